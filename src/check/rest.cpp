#include "check/rest.hpp"

#include <algorithm>
#include <cmath>

#include "base/codes.hpp"
#include "base/number.hpp"
#include "base/whole.hpp"
#include "sim/turning/turning.hpp"

namespace obrys::check {

namespace {

constexpr double beside_margin = 0.005;  ///< mm between a piece and the cut that bounds it

/// Cuts away what lies outside [min_z, max_z]: there the wanted contour says nothing.
geom::Region within(const geom::Region& left, const Box& band) {
    const Box all = box_of(left);
    sim::turning::Workpiece work(left);
    const auto remove = [&](double z0, double z1) {
        if (z1 - z0 <= 0) return;
        const double x0 = all.min_x - 1, x1 = all.max_x + 1;
        const geom::Contour block{{{{z0, x0}}, {{z1, x0}}, {{z1, x1}}, {{z0, x1}}}, true};
        work.cut(block, {});
    };
    if (all.min_z < band.min_z) remove(all.min_z - 1, band.min_z);
    if (all.max_z > band.max_z) remove(band.max_z, all.max_z + 1);
    return work.region();
}

Finding rest_finding(const sim::turning::Depth& piece, bool allowance) {
    const Box box = box_of(piece.region);
    Finding f;
    f.code = base::codes::rest_material;
    f.severity = base::Severity::warning;
    f.text = mm(piece.normal) + " of material is left outside the " + (allowance ? "allowance contour" : "part") +
             " at " + point(piece.deepest) + ": from Z " + base::fixed(box.min_z, 3) + " to Z " +
             base::fixed(box.max_z, 3) + ", " + mm2(piece.area);
    f.amounts = {{"depth_mm", piece.normal},   {"depth_x_mm", piece.along_x}, {"area_mm2", piece.area},
                 {"volume_mm3", piece.volume}, {"z_mm", piece.deepest.x},     {"x_mm", piece.deepest.y},
                 {"z_from_mm", box.min_z},     {"z_to_mm", box.max_z}};
    f.region = piece.region;
    f.at = piece.deepest;
    return f;
}

}  // namespace

Box box_of(const geom::Contour& contour) {
    Box box;
    const auto& v = contour.vertices;
    for (std::size_t i = 0; i < v.size(); ++i) {
        box.add(v[i].p);
        const bool edge = contour.closed || i + 1 < v.size();
        if (!edge || v[i].bulge == 0) continue;
        // An arc may bulge past its ends: add the extremes of its circle that it passes.
        const geom::Vec2 a = v[i].p, b = v[(i + 1) % v.size()].p, chord = b - a;
        const double k = (1 - v[i].bulge * v[i].bulge) / (4 * v[i].bulge);
        const geom::Vec2 centre = 0.5 * (a + b) + k * geom::left_of(chord);
        const double radius = geom::distance(a, centre);
        for (const geom::Vec2 d : {geom::Vec2{1, 0}, {0, 1}, {-1, 0}, {0, -1}}) {
            const geom::Vec2 p = centre + radius * d;
            const double side = geom::cross(chord, p - a);  // a left-turning arc lies right of its chord
            if ((v[i].bulge > 0) == (side < 0)) box.add(p);
        }
    }
    return box;
}

Box box_of(const geom::Region& region) {
    Box all;
    for (const geom::Contour& c : region.contours) {
        const Box b = box_of(c);
        if (b.empty()) continue;
        all.add({b.min_z, b.min_x});
        all.add({b.max_z, b.max_x});
    }
    return all;
}

std::size_t LastCuts::cell(double z) const {
    const double t = (z - min_z_) / std::max(max_z_ - min_z_, 1e-9) * static_cast<double>(cells);
    return base::clipped<std::size_t>(t, 0, cells - 1);
}

void LastCuts::add(const Move& move, const Box& removed) {
    if (removed.empty()) return;
    const auto entry = std::make_shared<const Entry>(
        Entry{move.record.from, move.record.stack, move.index, move.from, move.to, removed});
    for (std::size_t i = cell(removed.min_z); i <= cell(removed.max_z); ++i) last_[i] = entry;
}

const LastCuts::Entry* LastCuts::beside(const Box& piece) const {
    const Entry* best = nullptr;
    for (std::size_t i = cell(piece.min_z - beside_margin); i <= cell(piece.max_z + beside_margin); ++i) {
        const Entry* e = last_[i].get();
        if (e != nullptr && e->box.meets(piece, beside_margin) && (best == nullptr || e->index > best->index)) best = e;
    }
    return best;
}

void find_rest(const Setup& setup, const geom::Region& left, const LastCuts& cuts, const cl::Record& end,
               Collector& out) {
    const geom::Region& wanted = setup.allowance ? *setup.allowance : *setup.part;
    const Box band = box_of(wanted), all = box_of(left);
    if (band.empty() || all.empty()) return;
    if (all.min_z < band.min_z - beside_margin || all.max_z > band.max_z + beside_margin)
        out.assumption("rest material is judged from Z " + base::fixed(band.min_z, 3) + " to Z " +
                       base::fixed(band.max_z, 3) + " mm, where the contour is given");
    const auto pieces = sim::turning::pieces_outside(within(left, band), wanted, setup.tolerances.rest_material);
    for (const sim::turning::Depth& piece : pieces) {
        Finding f = rest_finding(piece, setup.allowance.has_value());
        const LastCuts::Entry* last = cuts.beside(box_of(piece.region));
        if (last == nullptr) {
            out.finding(end, std::move(f));
            continue;
        }
        f.text += "; the last move that cut beside it ends here";
        f.move = last->index;
        f.from = last->from;
        f.to = last->to;
        out.finding(cl::Record{cl::CycleEnd{}, last->where, last->stack}, std::move(f));
    }
}

}  // namespace obrys::check
