#include "sim/certify/certify.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "sim/certify/closest.hpp"

namespace obrys::sim::certify {

using geom::Vec3;

namespace {

constexpr double coarse = 0.5, fine = 0.05;  ///< what a chord may leave out of a curve, of the depth
constexpr double shortest = 1e-9;            ///< part of a way that is not cut into two any more
constexpr double excuse = 1e-9;              ///< mm: less is none
constexpr double smallest_piece = 0.125;     ///< of a triangle, of what is allowed
constexpr std::size_t most_pieces = 1024;    ///< of a triangle

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

using Triangle = Judge::Triangle;

double side_of(const Triangle& t, std::size_t k) { return geom::distance(t[k], t[(k + 1) % 3]); }

double longest_side(const Triangle& t) { return std::max({side_of(t, 0), side_of(t, 1), side_of(t, 2)}); }

/// Across its longest side.
std::array<Triangle, 2> halves_of(const Triangle& t) {
    const double most = longest_side(t);
    const std::size_t k = side_of(t, 0) >= most ? 0 : side_of(t, 1) >= most ? 1 : 2;
    const Vec3 a = t[k], b = t[(k + 1) % 3], c = t[(k + 2) % 3], middle = 0.5 * (a + b);
    return {Triangle{a, middle, c}, Triangle{middle, b, c}};
}

bool apart(const Swept& swept, const Triangle& c, Vec3 normal) {
    // A tool that touches a surface lies on its outer side as a rule.
    if (dot(normal, c[0]) < -extent(swept, -1.0 * normal)) return true;
    const Vec3 u = towards(swept, (1.0 / 3) * (c[0] + c[1] + c[2]));
    if (std::min({dot(u, c[0]), dot(u, c[1]), dot(u, c[2])}) > extent(swept, u)) return true;
    if (dot(normal, c[0]) > extent(swept, normal)) return true;
    return closest(swept, c, swept.body.rounding).lower > swept.body.rounding;
}

/// Whether the body meets the surface at a triangle that counts.
template <class Counts>
bool meets_any(const mesh::Distance& surface, const Swept& inner, Counts&& counts) {
    const mesh::Box own = box_of(inner);
    bool met = false;
    surface.visit([&](const mesh::Box& box) { return !apart(inner, own, box); },
                  [&](std::uint32_t t) {
                      met = !apart(inner, corners(surface.mesh(), t), surface.normal(t)) && counts(t);
                      return !met;
                  });
    return met;
}

/// Of a body that meets nothing of the surface: it lies outside.
bool lies_outside(const mesh::Distance& surface, const mesh::Box& box, const Swept& inner) {
    const Vec3 p = inner.from + inner.body.z0 * inner.axis;
    return !holds(box, box_of(inner)) || !(surface.signed_distance(p) < 0);
}

/// Certainly nothing of it is deeper than `depth`: with one way or another of making it smaller it meets nothing and is
/// not inside.
template <class Meets>
bool is_clear_of(const mesh::Distance& surface, const mesh::Box& box, const Swept& whole, double depth, Meets&& meets) {
    if (!overlap(box_of(whole), box)) return true;
    Swept inner = whole;
    for (const Inwards how : all_ways) {
        inner.body = shrunk(whole.body, depth, how);
        if (!meets(inner) && lies_outside(surface, box, inner))
            return true;                                 // one may lie inside where another does not
        if (whole.body.rounding >= depth) return false;  // all ways are one
    }
    return false;
}

}  // namespace

Judge::Judge(const mesh::Distance& part, double allowed, Before before)
    : part_(part), box_(mesh::bounds(part.mesh())), allowed_(allowed), before_(std::move(before)) {
    if (before_.surface) stock_box_ = mesh::bounds(before_.surface->mesh());
}

/// Where the part is known to be another one, a triangle may lie deeper in the tool by as much: it is cut up until each
/// piece is held by that or lies outside. `inner`: smaller already.
bool Judge::is_excused(const Swept& inner, std::uint32_t triangle) const {
    if (!known_.more) return false;
    const Vec3 normal = part_.normal(triangle);
    const auto clear_with = [&](const Triangle& piece, double more) {
        return std::any_of(all_ways.begin(), all_ways.end(), [&](Inwards how) {
            Swept smaller = inner;
            smaller.body = shrunk(inner.body, more, how);
            return apart(smaller, piece, normal);
        });
    };
    std::vector<Triangle> open{corners(part_.mesh(), triangle)};
    const Vec3 met = closest(inner, open.front(), to_the_end).on_other;
    if (!(known_.more({met, met, met}) > excuse)) return false;
    for (std::size_t left = most_pieces; !open.empty() && left > 0; --left) {
        const Triangle piece = open.back();
        open.pop_back();
        if (apart(inner, piece, normal)) continue;
        const double more = known_.more(piece);
        if (more > excuse && clear_with(piece, more)) continue;
        if (longest_side(piece) < smallest_piece * allowed_) return false;
        for (const Triangle& half : halves_of(piece)) open.push_back(half);
    }
    return open.empty();
}

bool Judge::meets(const Swept& inner) const {
    return meets_any(part_, inner, [&](std::uint32_t t) { return !is_excused(inner, t); });
}

std::vector<std::uint32_t> Judge::met_by(const Swept& inner) const {
    constexpr std::size_t most = 4096;
    std::vector<std::uint32_t> met;
    static_cast<void>(meets_any(part_, inner, [&](std::uint32_t t) {
        if (!is_excused(inner, t)) met.push_back(t);
        return met.size() >= most;
    }));
    return met;
}

/// Of the ways of making it smaller by a depth that which meets least.
Judge::Met Judge::fewest_met(const Swept& whole, double depth) const {
    Met fewest;
    if (!overlap(box_of(whole), box_)) {
        fewest.clear = true;
        return fewest;
    }
    for (const Inwards how : all_ways) {
        Met met;
        met.inner = whole;
        met.inner.body = shrunk(whole.body, depth, how);
        met.triangles = met_by(met.inner);
        met.clear = met.triangles.empty() && lies_outside(part_, box_, met.inner);
        const bool fewer = how == Inwards::middle || met.triangles.size() < fewest.triangles.size();
        if (fewer) fewest = std::move(met);
        if (fewest.triangles.empty() || whole.body.rounding >= depth) break;
    }
    return fewest;
}

bool Judge::clear_piece(const Swept& whole, Asked asked) const {
    const auto in_part = [&](const Swept& inner) { return meets(inner); };
    if (is_clear_of(part_, box_, whole, asked.depth, in_part)) return true;
    if (asked.of == Of::part || !before_.surface || !(asked.depth > before_.off)) return false;
    const mesh::Distance& stock = *before_.surface;
    const auto in_stock = [&](const Swept& inner) {
        return meets_any(stock, inner, [](std::uint32_t) { return true; });
    };
    return is_clear_of(stock, stock_box_, whole, asked.depth - before_.off, in_stock);
}

bool Judge::clear_between(const Move& move, double u0, double u1, Asked asked, std::vector<Piece>* failing) const {
    const double du = u1 - u0, off = bend_of(move.path) * du * du / 8, depth = asked.depth;
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
        if (clear_piece(whole, {depth - off, asked.of})) continue;
        all = false;
        if (off > fine * depth || failing == nullptr) break;
        failing->push_back(whole);
    }
    if (!near || (all && off <= coarse * depth)) return true;
    if (off <= fine * depth || du < shortest) return false;
    const double middle = (u0 + u1) / 2;
    const bool first = clear_between(move, u0, middle, asked, failing);
    if (!first && failing == nullptr) return false;
    return clear_between(move, middle, u1, asked, failing) && first;
}

bool Judge::is_clear(const Move& move, double depth, Of of) const {
    return clear_between(move, 0, 1, {depth, of}, nullptr);
}

}  // namespace obrys::sim::certify
