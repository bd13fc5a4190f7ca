// Triangles in air: proved to have material beside every place of them. A convex body lies behind its tangent plane.
// Where from each corner some way leads out of the planes of all bodies near, a way between these does from each place
// between the corners, and is no longer than theirs.

#include <algorithm>
#include <cmath>

#include "sim/milling/exact.hpp"
#include "sim/milling/nearest.hpp"

namespace obrys::sim::milling {

namespace {

using geom::Vec3;

constexpr double level_face = 1 - 1e-12;       ///< a tool's lower face on a circle: its plane has no bend
constexpr double one_plane = 1e-3;             ///< between directions
constexpr double small = 0.7, smallest = 0.1;  ///< of what is allowed: sizes of triangles

}  // namespace

class Exact::BesideSearch {
public:
    BesideSearch(const Exact& exact, const Near& near, double allowed, std::size_t parts)
        : exact_(exact), near_(near), allowed_(allowed), left_(parts) {}

    [[nodiscard]] bool run(const Corners& t) {
        std::vector<Body> all;
        for (const Air::Sweep& s : near_.sweeps)
            for (const Shape* part : exact_.parts_of(s.shape)) all.push_back({&s, part});
        return is_beside(t, all);
    }

private:
    struct Body {
        const Air::Sweep* sweep = nullptr;
        const Shape* part = nullptr;
    };

    [[nodiscard]] bool is_beside(const Corners& t, const std::vector<Body>& bodies) {
        if (left_ == 0) return false;
        --left_;
        const Vec3 middle = centroid_of(t);
        const double reach = farthest_from(middle, t);
        std::vector<Body> about;
        std::vector<Plane> planes;
        for (const Body& b : bodies) {
            const Plane plane = plane_at(b, middle, t);
            if (plane.side.outside >= reach + allowed_) continue;
            about.push_back(b);
            planes.push_back(plane.least < 0 ? best_plane(b, t, plane) : plane);
        }
        if (std::all_of(t.begin(), t.end(), [&](Vec3 p) { return is_left_from(p, planes); })) return true;
        // Small ones the middle tells for: where planes do not, inside a circle's bend.
        if (reach <= small * allowed_ &&
            exact_.is_on_surface(near_, middle, allowed_ - reach, std::numeric_limits<double>::max()))
            return true;
        if (reach <= smallest * allowed_) return false;
        const auto [one, two] = halves_of(t);
        return is_beside(one, about) && is_beside(two, about);
    }

    /// A body lies behind it, about a triangle.
    struct Plane {
        Vec3 at;
        Side side;         ///< of `at`
        double least = 0;  ///< how far the triangle's corners are before it, at least
    };
    [[nodiscard]] Plane plane_at(const Body& b, Vec3 at, const Corners& t) const {
        const Air::Sweep& s = *b.sweep;
        const Foot foot = foot_on(*b.part, s.track, s.frame.to_tool(at - s.from));
        Plane plane{at, {foot.outside, s.frame.to_stock(foot.gradient)}, HUGE_VAL};
        if (s.track.circular && !(std::abs(foot.gradient.z) > level_face))
            plane.side.outside -= bend_of(s, foot.gradient, at, farthest_from(at, t) + 2 * allowed_);
        for (const Vec3& p : t) plane.least = std::min(plane.least, before(plane, p));
        return plane;
    }
    /// Where a body ends beside a triangle's middle, its face along the triangle is told at a corner.
    [[nodiscard]] Plane best_plane(const Body& b, const Corners& t, Plane best) const {
        for (const Vec3& p : t) {
            const Plane other = plane_at(b, p, t);
            if (other.least > best.least) best = other;
        }
        return best;
    }
    [[nodiscard]] static double before(const Plane& plane, Vec3 p) {
        return plane.side.outside + dot(plane.side.in, p - plane.at);
    }

    /// How far a body that was swept on a circle may stand out of its tangent plane within so much about a point. All
    /// of it by what the circle goes beyond the place where the tool touches that plane: nothing on the outer side. On
    /// the inner one the circle's bend tells.
    [[nodiscard]] static double bend_of(const Air::Sweep& s, Vec3 gradient, Vec3 p, double about) {
        const Track& t = s.track;
        const Vec3 own = s.frame.to_tool(p - s.from);
        const geom::Vec2 q = geom::Vec2{own.x, own.y} - t.centre, g{gradient.x, gradient.y};
        const auto within = [&](geom::Vec2 to) {
            return t.turn * cross(t.first, to) >= 0 && t.turn * cross(to, t.last) >= 0;
        };
        const bool beside = !within(q);
        const double far = geom::length(q), ends = std::max(dot(g, t.first), dot(g, t.last));
        const double most = within(g) ? geom::length(g) : ends;
        const geom::Vec2 touches = !beside && far > 0 ? (1 / far) * q
                                   : geom::distance(q, t.radius * t.first) < geom::distance(q, t.radius * t.last)
                                       ? t.first
                                       : t.last;
        const double beyond = t.radius * std::max(0.0, most - dot(g, touches));
        // Beyond the centre a tool wider than its circle has stood at both ends: a kink lies between these.
        if (beside && s.shape->radius > t.radius) return beyond;
        const double inner = far - about;
        return inner > about ? std::min(beyond, about * about / (2 * inner)) : beyond;
    }

    /// There is a way from a corner out of all planes, and not out of the stock.
    [[nodiscard]] bool is_left_from(Vec3 p, const std::vector<Plane>& planes) {
        sides_.clear();
        bool in_air = false;
        const auto add = [&](const Side& side) {
            if (side.outside >= allowed_) return;
            in_air = in_air || side.outside < 0;
            // Of a fine helix many bodies share a floor.
            for (Side& other : sides_)
                if (geom::distance(other.in, side.in) < one_plane) {
                    other.outside = std::min(other.outside, side.outside);
                    return;
                }
            sides_.push_back(side);
        };
        for (const Plane& plane : planes) add({before(plane, p), plane.side.in});
        if (near_.stock) {
            const std::vector<StockBody::Face> faces = exact_.stock_.faces_at(p, allowed_);
            for (const StockBody::Face& f : faces) add({f.within, f.in});
            if (faces.empty()) add(exact_.side(near_, 0, p));
        }
        return !in_air || is_left(sides_, allowed_);
    }

    const Exact& exact_;
    const Near& near_;
    double allowed_ = 0;
    std::size_t left_ = 0;     ///< parts that may still be looked at
    std::vector<Side> sides_;  ///< kept for its memory
};

bool Exact::is_beside_material(const Near& near, const Corners& triangle, double allowed, std::size_t parts) const {
    if (!near.stock && !near.blank) return false;
    return BesideSearch(*this, near, allowed, parts).run(triangle);
}

}  // namespace obrys::sim::milling
