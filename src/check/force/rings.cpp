#include "check/force/rings.hpp"

#include <algorithm>
#include <cmath>

#include "check/milling_tool.hpp"

namespace obrys::check::force {

namespace milling = sim::milling;
using geom::pi;
using sim::force::Arc;
using sim::force::Ring;

namespace {

constexpr double nothing = 1e-9;  ///< mm
constexpr int round_rings = 8, straight_rings = 3, helix_rings = 10, end_rings = 4;

double lean_at(const milling::Piece& p, double z) { return std::acos(std::clamp((p.centre - z) / p.arc, -1.0, 1.0)); }

double lag_at(const Edges& e, double height) {
    return e.shape.radius > 0 ? height * std::tan(e.helix) / e.shape.radius : 0;
}

void add_end(std::vector<Ring>& rings, const milling::Shape& shape) {
    const double radius = milling::radius_at(shape.pieces.front(), shape.bottom);
    if (radius <= nothing) return;
    const double length = radius / end_rings;
    for (int i = 0; i < end_rings; ++i) rings.push_back({(i + 0.5) * length, 0, length, shape.bottom, 0, {}});
}

void add_round(std::vector<Ring>& rings, const Edges& e, const milling::Piece& p, double low, double high) {
    const double begin = lean_at(p, low), end = lean_at(p, high), step = (end - begin) / round_rings;
    for (int i = 0; i < round_rings; ++i) {
        const double lean = begin + (i + 0.5) * step, height = p.centre - p.arc * std::cos(lean);
        rings.push_back({p.ring + p.arc * std::sin(lean), lean, p.arc * step, height, lag_at(e, height), {}});
    }
}

void add_straight(std::vector<Ring>& rings, const Edges& e, const milling::Piece& p, double low, double high) {
    const double lean = std::atan2(p.z1 - p.z0, p.r1 - p.r0);
    const int count = e.helix > 0 ? helix_rings : p.r0 == p.r1 ? 1 : straight_rings;
    const double step = (high - low) / count;
    for (int i = 0; i < count; ++i) {
        const double height = low + (i + 0.5) * step;
        rings.push_back({milling::radius_at(p, height), lean, step / std::sin(lean), height, lag_at(e, height), {}});
    }
}

std::vector<Ring> rings_between(const Edges& e, double low, double high, bool with_end) {
    std::vector<Ring> rings;
    if (e.shape.pieces.empty()) return rings;
    if (with_end && low <= e.shape.bottom + nothing) add_end(rings, e.shape);
    for (const milling::Piece& p : e.shape.pieces) {
        const double from = std::max(low, p.z0), to = std::min(high, p.z1);
        if (to - from <= nothing) continue;
        if (p.kind == milling::PieceKind::round)
            add_round(rings, e, p, from, to);
        else
            add_straight(rings, e, p, from, to);
    }
    return rings;
}

/// Of what lies from `right` to `left` beside the way: at the flank that faces the feed.
void set_arc(Ring& r, double right, double left) {
    r.arcs.clear();
    if (right >= r.radius || left <= -r.radius) return;
    const double from = pi / 2 - std::asin(std::clamp(left / r.radius, -1.0, 1.0));
    const double to = pi / 2 - std::asin(std::clamp(right / r.radius, -1.0, 1.0));
    if (to > from) r.arcs.push_back({from, to});
}

/// A cut of this width at the tool's side.
void set_side(std::vector<Ring>& rings, bool left, double width) {
    for (Ring& r : rings)
        if (left)
            set_arc(r, r.radius - width, r.radius);
        else
            set_arc(r, -r.radius, width - r.radius);
}

/// The width at which a cut at the side has the section; the widest where none has.
double width_of(std::vector<Ring>& rings, const Met& met, bool left, double widest) {
    double low = 0, high = widest;
    constexpr int halvings = 24;
    for (int i = 0; i < halvings; ++i) {
        const double middle = (low + high) / 2;
        set_side(rings, left, middle);
        (sim::force::section(rings, met.way) < met.section ? low : high) = middle;
    }
    return high;
}

}  // namespace

Edges edges_of(const shop::Tool& tool, double helix) {
    Edges e;
    milling::MadeShape made = milling::shape_of(cutter_of(tool));
    if (made.ok()) e.shape = std::move(made.shape.cutting);
    e.helix = helix;
    return e;
}

Engaged engaged(const Edges& edges, const Met& met) {
    Engaged e;
    e.rings = rings_between(edges, met.low, met.high, met.way.down > 0);
    double widest = 0;
    for (const Ring& r : e.rings) widest = std::max(widest, r.radius);
    constexpr double near = 0.02;  // of the radius: what rays leave open of a side
    const bool left = met.left >= widest * (1 - near), right = met.right <= -widest * (1 - near);
    if (met.all_round)
        for (Ring& r : e.rings) r.arcs = {Arc{0, 2 * pi}};
    else if (left != right && std::isfinite(met.section))
        set_side(e.rings, left, width_of(e.rings, met, left, 2 * widest));
    else
        for (Ring& r : e.rings) set_arc(r, met.right, met.left);
    const double whole = sim::force::section(e.rings, met.way);
    if (std::isfinite(met.section) && whole > 0) e.share = std::min(1.0, met.section / whole);
    return e;
}

}  // namespace obrys::check::force
