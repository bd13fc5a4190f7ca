#include "check/turning/rest.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "base/codes.hpp"
#include "base/number.hpp"
#include "base/whole.hpp"
#include "check/turning/parting.hpp"
#include "geom/boolean.hpp"
#include "geom/region.hpp"
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
    for (const geom::Contour& c : region.contours) all.cover(box_of(c));
    return all;
}

LastCuts::Range LastCuts::range(const Box& box, double margin) const {
    const auto index = [](double v, double lo, double hi) {
        const double t = (v - lo) / std::max(hi - lo, 1e-9) * static_cast<double>(cells);
        return base::clipped<std::size_t>(t, 0, cells - 1);
    };
    return {
        index(box.min_z - margin, stock_.min_z, stock_.max_z), index(box.max_z + margin, stock_.min_z, stock_.max_z),
        index(box.min_x - margin, stock_.min_x, stock_.max_x), index(box.max_x + margin, stock_.min_x, stock_.max_x)};
}

void LastCuts::add(const Move& move, const geom::Region& removed) {
    const Box box = box_of(removed);
    if (box.empty() || last_.empty()) return;
    const auto entry = std::make_shared<const Entry>(
        Entry{move.record.from, move.record.stack, move.index, move.from, move.to, removed, box});
    const Range r = range(box, 0);
    for (std::size_t z = r.z0; z <= r.z1; ++z)
        for (std::size_t x = r.x0; x <= r.x1; ++x) last_[z * cells + x] = entry;
}

const LastCuts::Entry* LastCuts::beside(const geom::Region& piece, const geom::Region& wanted) const {
    if (last_.empty()) return nullptr;
    constexpr int samples = 16;
    constexpr double much = 0.5;  // of the largest share: of such cuts the last one
    const Box box = box_of(piece);
    std::set<std::pair<std::uint64_t, const Entry*>> near;  // in the order of the moves
    const Range r = range(box, beside_margin);
    for (std::size_t z = r.z0; z <= r.z1; ++z)
        for (std::size_t x = r.x0; x <= r.x1; ++x)
            if (const Entry* e = last_[z * cells + x].get(); e != nullptr && e->box.meets(box, beside_margin))
                near.emplace(e->index, e);
    const std::vector<geom::Edge> edges = geom::edges(piece);
    std::vector<std::pair<double, const Entry*>> shares;
    double most = 0;
    for (const auto& [index, e] : near) {
        double along = 0;
        for (const geom::Edge& edge : edges)
            for (int i = 0; i < samples; ++i) {
                const geom::Vec2 p = geom::point_at(edge, (i + 0.5) / samples);
                if (geom::distance(e->removed, p) <= beside_margin)
                    along += geom::length(edge) / samples * geom::distance(wanted, p);
            }
        shares.emplace_back(along, e);
        most = std::max(most, along);
    }
    const Entry* last = nullptr;
    for (const auto& [along, e] : shares)
        if (along >= much * most) last = e;
    return last;
}

void find_rest(const Setup& setup, const Left& left, const LastCuts& cuts, const cl::Record& end, Collector& out) {
    const geom::Region& wanted = setup.allowance ? *setup.allowance : *setup.part;
    Box band = box_of(wanted);
    const Box all = box_of(left.stock);
    if (band.empty() || all.empty()) return;
    // What stands in front of a face that the contour draws is to go; behind the part it is held.
    if (setup.right_face && left.in_front) band.max_z = std::max(band.max_z, all.max_z);
    if (all.min_z < band.min_z - beside_margin || all.max_z > band.max_z + beside_margin)
        out.assumption("rest material is judged from Z " + base::fixed(band.min_z, 3) + " to Z " +
                       base::fixed(band.max_z, 3) + " mm, where the contour is given");
    if (const auto neck = setup.part ? neck_behind(*setup.part, left.stock) : std::nullopt)
        out.assumption("the part is not cut off: behind it, at Z " + base::fixed(neck->z, 3) + ", " +
                       base::fixed(neck->thickness, 3) + " mm hold it, from X " + base::fixed(neck->inner, 3) +
                       " to X " + base::fixed(neck->outer, 3) + " (radius)");
    geom::Region judged = within(left.stock, band);
    if (!left.ridges.empty()) judged = geom::subtract(judged, left.ridges);
    const auto pieces = sim::turning::pieces_outside(judged, wanted, setup.tolerances.rest_material);
    for (const sim::turning::Depth& piece : pieces) {
        Finding f = rest_finding(piece, setup.allowance.has_value());
        const LastCuts::Entry* last = cuts.beside(piece.region, wanted);
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
