#include "check/engagement.hpp"

#include <algorithm>
#include <cmath>

#include "check/milling_tool.hpp"
#include "geom/vec.hpp"
#include "sim/milling/cut/simulation.hpp"

namespace obrys::check {

namespace milling = sim::milling;
using geom::pi;

namespace {

constexpr double plunges_along = 1 - 1e-9;  ///< part of the way along the axis from which a move counts as plunging
constexpr double least_reach = 1e-9;        ///< mm above the tip

double lean_of_round(const milling::Piece& p, double z) {
    return std::acos(std::clamp((p.centre - z) / p.arc, -1.0, 1.0));
}

/// The chip's thickness by the place of the edge: side sin(kappa) + down cos(kappa); where it is largest.
struct Thickest {
    double lean = NAN, value = -INFINITY;
    void look(double side, double down, double lean_there) {
        const double v = side * std::sin(lean_there) + down * std::cos(lean_there);
        if (v > value) *this = {lean_there, v};
    }
};

Thickest thickest(const std::vector<CuttingEdges::Lean>& leans, double side, double down) {
    Thickest best;
    const double best_lean = std::atan2(side, down);  // of all leans, were they there
    for (const CuttingEdges::Lean& l : leans) {
        best.look(side, down, l.lowest);
        best.look(side, down, l.highest);
        if (best_lean > l.lowest && best_lean < l.highest) best.look(side, down, best_lean);
    }
    return best;
}

/// Where the material's side lies that the outermost ray at `ray` belongs to; the tool's own is at `most`.
double outer(double ray, double most, double ray_distance) {
    return ray + ray_distance >= most ? most : ray + ray_distance / 2;
}

/// Largest and mean cosine over the angles.
struct Facing {
    double largest = 1, mean = 0;
};
Facing facing(double from, double to) {
    Facing f;
    if (from > 0 || to < 0) f.largest = std::max(std::cos(from), std::cos(to));
    f.mean = to - from > 1e-9 ? (std::sin(to) - std::sin(from)) / (to - from) : std::cos(from);
    return f;
}

}  // namespace

CuttingEdges::CuttingEdges(const shop::Tool& tool) : teeth_(tool.teeth) {
    milling::MadeShape made = milling::shape_of(cutter_of(tool));
    if (made.ok()) shape_ = std::move(made.shape.cutting);
}

double CuttingEdges::radius(double reach) const {
    const double widest = milling::widest_between(shape_, shape_.bottom, std::max(reach, shape_.bottom + least_reach));
    return shape_.pieces.empty() || !(widest > 0) ? NAN : widest;
}

std::vector<CuttingEdges::Lean> CuttingEdges::leans(double reach) const {
    std::vector<Lean> all;
    if (shape_.pieces.empty()) return all;
    if (const milling::Piece& first = shape_.pieces.front(); milling::radius_at(first, first.z0) > least_reach)
        all.push_back({0, 0});
    for (const milling::Piece& p : shape_.pieces) {
        if (p.z0 > shape_.bottom && p.z0 >= reach) break;
        if (p.kind == milling::PieceKind::round) {
            all.push_back({lean_of_round(p, p.z0), lean_of_round(p, std::clamp(reach, p.z0, p.z1))});
            continue;
        }
        const double lean = std::atan2(p.z1 - p.z0, p.r1 - p.r0);
        all.push_back({lean, lean});
    }
    return all;
}

EdgeEngagement engagement_of(const MilledMove& move, const CuttingEdges& edges, double ray_distance) {
    EdgeEngagement e;
    if (edges.teeth() > 0) e.feed_per_tooth = move.feed_per_rev_mm / edges.teeth();
    const double radius = edges.radius(move.reach_mm);
    if (!(move.volume_mm3 > 0) || !(move.rightmost_mm <= move.leftmost_mm) || !(radius > 0)) return e;
    const bool plunging = std::abs(move.sinking) >= plunges_along;
    const double right = -outer(-move.rightmost_mm, plunging ? 0 : radius, ray_distance);
    const double left = std::max(outer(move.leftmost_mm, radius, ray_distance), right);
    e.radial_depth = left - right;
    if (plunging) {
        e.from = -pi;
        e.to = pi;
    } else {
        milling::Engagement met;
        met.rightmost = right;
        met.leftmost = left;
        const milling::Angles angles = milling::engaged_angles(met, radius);
        e.from = angles.from;
        e.to = angles.to;
    }
    const double side = plunging ? 0 : std::sqrt(std::max(0.0, 1 - move.sinking * move.sinking));
    const Facing f = plunging ? Facing{} : facing(e.from, e.to);
    const Thickest chip = thickest(edges.leans(move.reach_mm), side * f.largest, move.sinking);
    const double mean = side * f.mean * std::sin(chip.lean) + move.sinking * std::cos(chip.lean);
    e.chip_largest = e.feed_per_tooth * std::max(chip.value, 0.0);
    e.chip_mean = e.feed_per_tooth * std::clamp(mean, 0.0, std::max(chip.value, 0.0));
    return e;
}

}  // namespace obrys::check
