#include "sim/certify/certify.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "sim/certify/closest.hpp"

namespace obrys::sim::certify {

using geom::Vec3;

namespace {

constexpr double coarse = 0.5, fine = 0.05;  ///< what a chord may leave out of a curve, of the depth
constexpr double shortest = 1e-9;            ///< part of a way that is not cut into two any more

bool overlap(const mesh::Box& a, const mesh::Box& b) {
    return a.lo.x <= b.hi.x && a.hi.x >= b.lo.x && a.lo.y <= b.hi.y && a.hi.y >= b.lo.y && a.lo.z <= b.hi.z &&
           a.hi.z >= b.lo.z;
}

bool holds(const mesh::Box& a, const mesh::Box& b) {
    return a.lo.x <= b.lo.x && a.hi.x >= b.hi.x && a.lo.y <= b.lo.y && a.hi.y >= b.hi.y && a.lo.z <= b.lo.z &&
           a.hi.z >= b.hi.z;
}

/// Largest second derivative of a path.
double bend_of(const geom::PathElement& path) {
    if (const auto* c = std::get_if<geom::Circular>(&path)) {
        const Vec3 out = c->from - c->centre;
        const double size = length(c->normal);
        const double along = size > 0 ? dot(out, c->normal) / size : 0;
        return c->sweep * c->sweep * std::sqrt(std::max(0.0, dot(out, out) - along * along));
    }
    if (const auto* k = std::get_if<geom::Cubic>(&path))
        return std::max(length(2.0 * k->k2), length(2.0 * k->k2 + 6.0 * k->k3));
    return 0;
}

/// Whether a box and the swept body lie apart for certain.
bool apart(const Swept& swept, const mesh::Box& own, const mesh::Box& box) {
    if (!overlap(own, box)) return true;
    const Vec3 c = box.centre(), half = 0.5 * box.size();
    const Vec3 u = towards(swept, c);
    const double reach = std::abs(u.x) * half.x + std::abs(u.y) * half.y + std::abs(u.z) * half.z;
    return dot(u, c) - reach > extent(swept, u);
}

bool apart(const Swept& swept, const std::array<Vec3, 3>& c, Vec3 normal) {
    // A tool that touches a surface lies on its outer side as a rule.
    if (dot(normal, c[0]) < -extent(swept, -1.0 * normal)) return true;
    const Vec3 u = towards(swept, (1.0 / 3) * (c[0] + c[1] + c[2]));
    if (std::min({dot(u, c[0]), dot(u, c[1]), dot(u, c[2])}) > extent(swept, u)) return true;
    if (dot(normal, c[0]) > extent(swept, normal)) return true;
    return closest(swept, c, swept.body.rounding).lower > swept.body.rounding;
}

}  // namespace

Judge::Judge(const mesh::Distance& part, double allowed, std::function<double(Vec3)> within)
    : part_(part), box_(mesh::bounds(part.mesh())), allowed_(allowed), within_(std::move(within)) {}

bool Judge::meets(const Swept& inner) const {
    const mesh::Box own = box_of(inner);
    bool met = false;
    part_.visit([&](const mesh::Box& box) { return !apart(inner, own, box); },
                [&](std::uint32_t t) { return !(met = !apart(inner, corners(part_.mesh(), t), part_.normal(t))); });
    return met;
}

std::vector<std::uint32_t> Judge::met_by(const Swept& inner) const {
    constexpr std::size_t most = 4096;
    const mesh::Box own = box_of(inner);
    std::vector<std::uint32_t> met;
    part_.visit([&](const mesh::Box& box) { return !apart(inner, own, box); },
                [&](std::uint32_t t) {
                    if (!apart(inner, corners(part_.mesh(), t), part_.normal(t))) met.push_back(t);
                    return met.size() < most;
                });
    return met;
}

/// Certainly nothing of it is deeper than `depth`: with one way or another of making it smaller it meets nothing and is
/// not inside.
bool Judge::clear_piece(const Swept& whole, double depth) const {
    if (!overlap(box_of(whole), box_)) return true;
    Swept inner = whole;
    for (const Inwards how : {Inwards::middle, Inwards::along, Inwards::across}) {
        inner.body = shrunk(whole.body, depth, how);
        if (meets(inner)) {
            if (whole.body.rounding >= depth) return false;  // all ways are one
            continue;
        }
        // All of it lies on one side of the surface.
        const Vec3 p = inner.from + inner.body.z0 * inner.axis;
        return !holds(box_, box_of(inner)) || !(part_.signed_distance(p) < 0);
    }
    return false;
}

bool Judge::clear_between(const Move& move, double u0, double u1, double depth, std::vector<Piece>* failing) const {
    const double du = u1 - u0, off = bend_of(move.path) * du * du / 8;
    const Vec3 a = geom::point_at(move.path, u0), b = geom::point_at(move.path, u1);
    const double size = length(move.axis);
    if (!geom::is_finite(a) || !geom::is_finite(b) || !(size > 0)) return false;
    const Vec3 axis = (1 / size) * move.axis;
    bool all = true, near = false;
    for (const Body& body : *move.shape) {
        const Swept whole{body, a, b - a, axis};
        mesh::Box box = box_of(whole);
        const Vec3 more{off, off, off};
        box.lo = box.lo - more, box.hi = box.hi + more;
        if (!overlap(box, box_)) continue;
        near = true;
        if (off > coarse * depth) break;
        if (clear_piece(whole, depth - off)) continue;
        all = false;
        if (off > fine * depth || failing == nullptr) break;
        failing->push_back({whole, u0, u1, off});
    }
    if (!near || (all && off <= coarse * depth)) return true;
    if (off <= fine * depth || du < shortest) return false;
    const double middle = (u0 + u1) / 2;
    const bool first = clear_between(move, u0, middle, depth, failing);
    if (!first && failing == nullptr) return false;
    return clear_between(move, middle, u1, depth, failing) && first;
}

bool Judge::is_clear(const Move& move) const { return clear_between(move, 0, 1, allowed_, nullptr); }

double Judge::upper_bound(const Move& move, double from) const {
    for (const double more : {0.1, 0.3, 1.0, 3.0, 10.0})
        if (const double depth = from + more * allowed_; clear_between(move, 0, 1, depth, nullptr)) return depth;
    for (const double times : {1.5, 2.0, 4.0})
        if (clear_between(move, 0, 1, from * times, nullptr)) return from * times;
    return std::numeric_limits<double>::infinity();
}

}  // namespace obrys::sim::certify
