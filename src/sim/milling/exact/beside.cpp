// Triangles in air: proved to have material beside every place of them. A convex body lies behind its tangent plane.
// Where from each corner some way leads out of the planes of all bodies near, a way between these does from each place
// between the corners, and is no longer than theirs.

#include <algorithm>
#include <cmath>

#include "sim/milling/exact/exact.hpp"
#include "sim/milling/nearest.hpp"

namespace obrys::sim::milling {

namespace {

using geom::Vec3;

constexpr double along_axis = 0.9;             ///< of a direction: that of an end of a piece, not of its side
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
        const Vec3 own = s.frame.to_tool(at - s.from);
        const Foot foot = foot_on(*b.part, s.track, own);
        const double size = length(foot.gradient);
        Vec3 n = size > 0 ? (1 / size) * foot.gradient : foot.normal;
        const double about = farthest_from(at, t) + 2 * allowed_;
        double outside = outside_of(b, own, foot.place, n, about);
        // Where a piece of the tool is nearest with its end, there is another one and no face.
        if (std::abs(n.z) > along_axis) {
            const Vec3 side = side_of(*b.part, own - foot.place);
            const double by_side = outside_of(b, own, foot.place, side, about);
            if (by_side > outside) n = side, outside = by_side;
        }
        Plane plane{at, {outside, s.frame.to_stock(n)}, HUGE_VAL};
        for (const Vec3& p : t) plane.least = std::min(plane.least, before(plane, p));
        return plane;
    }
    /// How far a point lies before the plane with this normal behind which a body lies: all of it, or, swept on a
    /// circle, what of it is no farther from the point than `about`. `own`, `place`, `n`: in the tool's frame.
    [[nodiscard]] static double outside_of(const Body& b, Vec3 own, Vec3 place, Vec3 n, double about) {
        const Track& track = b.sweep->track;
        const double of_all = dot(n, own) - reach_of(*b.part, track, n);
        if (!track.circular) return of_all;
        return std::max(of_all, dot(n, own - place) - reach_of(*b.part, n) - bend_of(*b.sweep, own, about));
    }
    /// How far a moving body reaches in a direction, all of it: its tangent plane.
    [[nodiscard]] static double reach_of(const Shape& part, const Track& t, Vec3 n) {
        double most = 0;  // of the way, from where it begins
        const geom::Vec2 g{n.x, n.y};
        if (t.circular) {
            most = dot(t.centre, g) +
                   t.radius * (t.passes(g) ? geom::length(g) : std::max(dot(g, t.first), dot(g, t.last)));
        } else {
            most = std::max(0.0, dot(n, t.v));
        }
        return most + reach_of(part, n);
    }
    [[nodiscard]] static double reach_of(const Shape& part, Vec3 n) {
        const double across = std::sqrt(n.x * n.x + n.y * n.y);
        double most = -HUGE_VAL;
        for (const Piece& p : part.pieces) {
            most = std::max({most, across * p.r0 + n.z * p.z0, across * p.r1 + n.z * p.z1});
            const double touches = p.centre + p.arc * n.z;  // `n` is of unit length
            if (p.kind == PieceKind::round && touches > p.z0 && touches < p.z1)
                most = std::max(most, across * p.ring + n.z * p.centre + p.arc);
        }
        return most;
    }
    /// Out of the tool's side at a height.
    [[nodiscard]] static Vec3 side_of(const Shape& part, Vec3 p) {
        const auto at =
            std::find_if(part.pieces.begin(), part.pieces.end() - 1, [&](const Piece& q) { return p.z <= q.z1; });
        const double far = std::sqrt(p.x * p.x + p.y * p.y);
        const Vec3 out = far > 0 ? Vec3{p.x / far, p.y / far, 0} : Vec3{1, 0, 0};
        Vec3 n = (at->z1 - at->z0) * out - Vec3{0, 0, at->r1 - at->r0};
        if (at->kind == PieceKind::round) n = std::max(0.0, far - at->ring) * out + Vec3{0, 0, p.z - at->centre};
        const double size = length(n);
        return size > 0 ? (1 / size) * n : out;
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

    /// How far a body that was swept on a circle may stand out of its tangent planes within so much about a point, on
    /// the side of the circle's axis.
    [[nodiscard]] static double bend_of(const Air::Sweep& s, Vec3 own, double about) {
        const geom::Vec2 q = geom::Vec2{own.x, own.y} - s.track.centre;
        // Beyond the centre a tool wider than its circle has stood at both ends: a kink lies between these.
        if (!s.track.passes(q) && s.shape->radius > s.track.radius) return HUGE_VAL;
        const double inner = geom::length(q) - about;
        return inner > about ? about * about / (2 * inner) : HUGE_VAL;
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
