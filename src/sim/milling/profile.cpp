#include "sim/milling/profile.hpp"

#include <algorithm>
#include <cmath>

#include "base/whole.hpp"

namespace obrys::sim::milling {
namespace {

using geom::Vec2;

constexpr double flat_height = 1e-9;  ///< mm
constexpr int most_chords = 10'000;   ///< of one arc

struct ArcEdge {
    Vec2 centre;
    double radius = 0, start = 0, sweep = 0;
};

ArcEdge arc_of(const geom::Vertex& from, Vec2 to) {
    const Vec2 chord = to - from.p;
    const double half = geom::length(chord) / 2, b = from.bulge;
    ArcEdge arc;
    arc.sweep = 4 * std::atan(b);
    arc.radius = half * (1 + b * b) / (2 * std::abs(b));
    const Vec2 middle = 0.5 * (from.p + to);
    arc.centre = middle + ((1 - b * b) / (4 * b)) * geom::left_of(chord);
    const Vec2 out = from.p - arc.centre;
    arc.start = std::atan2(out.y, out.x);
    return arc;
}

Vec2 on(const ArcEdge& arc, double angle) { return arc.centre + arc.radius * Vec2{std::cos(angle), std::sin(angle)}; }

void add_straight(std::vector<Piece>& pieces, Vec2 from, Vec2 to) {
    if (to.y - from.y > flat_height) pieces.push_back(cone(from.y, to.y, std::max(0.0, from.x), std::max(0.0, to.x)));
}

void add_chords(std::vector<Piece>& pieces, const ArcEdge& arc, Vec2 to, double deviation) {
    const double step = 2 * std::acos(std::max(0.0, 1 - std::max(deviation, 1e-6) / arc.radius));
    const int n = base::clipped<int>(std::ceil(std::abs(arc.sweep) / step), 1, most_chords);
    Vec2 at = on(arc, arc.start);
    for (int i = 1; i <= n; ++i) {
        const Vec2 next = i == n ? to : on(arc, arc.start + arc.sweep * i / n);
        add_straight(pieces, at, next);
        at = next;
    }
}

/// Of an edge from one corner to the next: whether it rises all the way.
bool rises(const geom::Vertex& from, Vec2 to) {
    if (to.y < from.p.y - flat_height) return false;
    if (from.bulge == 0) return true;
    const ArcEdge arc = arc_of(from, to);
    // Counter-clockwise rising means an angle between -90 and 90 degrees, clockwise between 90 and 270.
    const double sign = arc.sweep > 0 ? 1 : -1;
    const auto upward = [&](double angle) { return sign * std::cos(angle) >= -1e-9; };
    return upward(arc.start) && upward(arc.start + arc.sweep) && upward(arc.start + arc.sweep / 2);
}

}  // namespace

std::vector<Piece> pieces_of_profile(const std::vector<geom::Vertex>& profile, double deviation, std::string& problem) {
    std::vector<Piece> pieces;
    for (const geom::Vertex& v : profile) {
        if (!std::isfinite(v.p.x) || !std::isfinite(v.p.y) || !std::isfinite(v.bulge) || v.p.x < 0 ||
            std::abs(v.bulge) > 1) {
            problem = "the profile has a corner that is not known, a negative radius or an arc of over 180 degrees";
            return {};
        }
    }
    for (std::size_t i = 0; i + 1 < profile.size(); ++i) {
        const geom::Vertex& from = profile[i];
        const Vec2 to = profile[i + 1].p;
        if (!rises(from, to)) {
            problem = "the profile does not rise from the tip upwards";
            return {};
        }
        if (std::abs(from.bulge) < 1e-9) {
            add_straight(pieces, from.p, to);
            continue;
        }
        const ArcEdge arc = arc_of(from, to);
        if (arc.sweep > 0 && arc.centre.x >= -flat_height && to.y - from.p.y > flat_height)
            pieces.push_back(round(from.p.y, to.y, std::max(0.0, arc.centre.x), arc.centre.y, arc.radius));
        else
            add_chords(pieces, arc, to, deviation);
    }
    if (pieces.empty()) problem = "the profile has no height";
    return pieces;
}

}  // namespace obrys::sim::milling
