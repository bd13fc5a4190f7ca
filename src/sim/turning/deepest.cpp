#include "sim/turning/deepest.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <queue>

#include "base/whole.hpp"
#include "geom/region.hpp"
#include "geom/tolerance.hpp"

namespace obrys::sim::turning {

using geom::Edge;
using geom::Region;
using geom::Vec2;

namespace {

constexpr double depth_error = 2e-5;  // mm, of a normal depth found inside or along a piece
constexpr double chord_error = 1e-5;  // mm, of the arcs of a piece as chords
constexpr double flat_enough = 1e-7;  // mm, sagitta of an arc that counts as its chord
constexpr int most_cells = 100'000, most_chords = 100'000;

/// Distance of two boxes.
double apart(const geom::Box& a, const geom::Box& b) {
    const double x = std::max({0.0, a.lo.x - b.hi.x, b.lo.x - a.hi.x});
    return std::hypot(x, std::max({0.0, a.lo.y - b.hi.y, b.lo.y - a.hi.y}));
}

using Polygon = std::vector<Vec2>;

void add_chords(const Edge& e, std::vector<Edge>& out) {
    int n = 1;
    if (geom::is_arc(e)) {
        const double step = 2 * std::acos(std::max(0.0, 1 - chord_error / geom::circle(e).radius));
        const double count = std::ceil(std::abs(geom::sweep_angle(e)) / std::max(step, 1e-9));
        n = base::clipped<int>(count, 2, most_chords);
    }
    for (int i = 0; i < n; ++i) {
        const Edge p = geom::part(e, static_cast<double>(i) / n, static_cast<double>(i + 1) / n);
        out.push_back({p.a, p.b, 0});
    }
}

/// The part of a closed polygon on the side x <= at (axis 0) or y <= at (axis 1), or the other side.
Polygon clipped(const Polygon& in, int axis, double at, double sign) {
    Polygon out;
    const auto off = [&](Vec2 p) { return sign * ((axis == 0 ? p.x : p.y) - at); };
    for (std::size_t i = 0; i < in.size(); ++i) {
        const Vec2 p = in[i], q = in[(i + 1) % in.size()];
        const double dp = off(p), dq = off(q);
        if (dp >= 0) out.push_back(p);
        if ((dp > 0 && dq < 0) || (dp < 0 && dq > 0)) out.push_back(p + dp / (dp - dq) * (q - p));
    }
    return out;
}

double doubled_area(const Polygon& p) {
    double sum = 0;
    for (std::size_t i = 0; i < p.size(); ++i) sum += geom::cross(p[i] - p[0], p[(i + 1) % p.size()] - p[0]);
    return sum;
}

/// A wall with what bounds its distance from above; arcs are at most a quarter turn.
struct Feature {
    Edge edge;
    bool arc = false;
    geom::Circle circle;

    explicit Feature(const Edge& e) : edge(e), arc(std::abs(geom::sagitta(e)) > flat_enough) {
        if (arc) circle = geom::circle(e);
    }
    /// Nearest to the arc itself, not to an end of it.
    [[nodiscard]] bool beside(Vec2 p) const {
        const Vec2 from = edge.a - circle.centre, to = edge.b - circle.centre, way = p - circle.centre;
        const double turn = edge.bulge > 0 ? 1 : -1;
        return turn * geom::cross(from, way) >= 0 && turn * geom::cross(way, to) >= 0;
    }
};

/// For points between others no distance is larger than what these convex functions say at the others.
class ConvexBound {
public:
    ConvexBound(const Feature& f, const std::vector<Vec2>& corners, Vec2 middle) : f_(f) {
        if (!f.arc) return;
        double by_a = 0, by_b = 0, by_arc = 0;
        const Vec2 out = middle - f.circle.centre;
        const double l = geom::length(out);
        towards_ = l > 0 ? (1 / l) * out : Vec2{1, 0};
        bool all_beside = true;
        for (const Vec2 p : corners) {
            by_a = std::max(by_a, geom::distance(p, f.edge.a));
            by_b = std::max(by_b, geom::distance(p, f.edge.b));
            all_beside = all_beside && f.beside(p);
            by_arc = std::max(by_arc, from_arc(p));
        }
        if (!all_beside) by_arc = std::numeric_limits<double>::infinity();
        kind_ = by_arc <= std::min(by_a, by_b) ? Kind::arc : by_a <= by_b ? Kind::a : Kind::b;
    }
    [[nodiscard]] double operator()(Vec2 p) const {
        switch (kind_) {
            case Kind::line: break;
            case Kind::arc: return from_arc(p);
            case Kind::a: return geom::distance(p, f_.edge.a);
            case Kind::b: return geom::distance(p, f_.edge.b);
        }
        return geom::distance(Edge{f_.edge.a, f_.edge.b, 0}, p) + (f_.edge.bulge == 0 ? 0 : flat_enough);
    }

private:
    enum class Kind : std::uint8_t { line, arc, a, b };
    /// The distance from a centre is convex, and never less than its part along a fixed direction.
    [[nodiscard]] double from_arc(Vec2 p) const {
        const Vec2 way = p - f_.circle.centre;
        return std::max(geom::length(way) - f_.circle.radius, f_.circle.radius - geom::dot(way, towards_));
    }

    const Feature& f_;
    Kind kind_ = Kind::line;
    Vec2 towards_;
};

/// A part of a piece: the outer contour and the holes, clipped. What is not convex hangs together by seams along the
/// cut, which are not of the piece.
struct Cell {
    std::vector<Polygon> loops;
    std::vector<std::uint32_t> walls;  ///< those that may be nearest to a point of the part
    double bound = 0;
    bool operator<(const Cell& other) const { return bound < other.bound; }

    [[nodiscard]] std::vector<Vec2> corners() const {
        std::vector<Vec2> out;
        for (const Polygon& p : loops) out.insert(out.end(), p.begin(), p.end());
        return out;
    }
};

geom::Box box_of(const std::vector<Vec2>& points) {
    geom::Box b;
    for (const Vec2 p : points) b.add(p);
    return b;
}

/// One side of a cell; nothing where that is seams alone.
std::optional<Cell> half(const Cell& c, int axis, double at, double sign) {
    Cell out{{}, c.walls, 0};
    double area = 0;
    for (const Polygon& loop : c.loops) {
        Polygon side = clipped(loop, axis, at, sign);
        if (side.size() < 2) continue;
        area += doubled_area(side);
        out.loops.push_back(std::move(side));
    }
    return std::abs(area) > 1e-12 ? std::optional(std::move(out)) : std::nullopt;
}

/// Largest distance from the points of a connected piece to walls, by branch and bound. What is convex is over a part
/// largest in a corner of the part.
class Deepest {
public:
    explicit Deepest(const std::vector<Wall>& walls) : all_(walls) {}

    /// Ends early once a point deeper than `enough` is found.
    void search(const Region& piece, double enough = std::numeric_limits<double>::infinity()) {
        piece_ = piece;
        Cell all;
        for (const geom::Contour& c : piece.contours) {
            std::vector<Edge> chords;
            for (const Edge& e : geom::edges(c)) add_chords(e, chords);
            Polygon loop;
            for (const Edge& e : chords) loop.push_back(e.a);
            if (loop.size() > 1) all.loops.push_back(std::move(loop));
        }
        walls_ = nearest_walls(all.corners());
        for (std::uint32_t i = 0; i < walls_.size(); ++i) all.walls.push_back(i);
        std::priority_queue<Cell> open;
        offer(std::move(all), open);
        for (int n = 0; n < most_cells && !open.empty() && open.top().bound > depth + depth_error; ++n) {
            if (depth > enough) return;
            const Cell c = open.top();
            open.pop();
            const geom::Box b = box_of(c.corners());
            const int axis = b.hi.x - b.lo.x > b.hi.y - b.lo.y ? 0 : 1;
            const double at = axis == 0 ? 0.5 * (b.lo.x + b.hi.x) : 0.5 * (b.lo.y + b.hi.y);
            for (const double sign : {-1.0, 1.0})
                if (auto side = half(c, axis, at, sign)) offer(std::move(*side), open);
        }
    }

    double depth = 0;
    Vec2 point;

private:
    void offer(Cell c, std::priority_queue<Cell>& open) {
        const std::vector<Vec2> corners = c.corners();
        if (corners.size() < 2) return;
        double bound = std::numeric_limits<double>::infinity();
        std::vector<double> nearest(corners.size(), bound);
        std::vector<std::pair<double, std::uint32_t>> reach;  // nearest corner of the part to each wall
        const geom::Box b = box_of(corners);
        const double size = geom::distance(b.lo, b.hi);
        std::vector<ConvexBound> bounds;
        for (const std::uint32_t w : c.walls) {
            bounds.emplace_back(walls_[w], corners, 0.5 * (b.lo + b.hi));
            double far = 0, near = std::numeric_limits<double>::infinity();
            for (std::size_t i = 0; i < corners.size(); ++i) {
                const double d = geom::distance(walls_[w].edge, corners[i]);
                nearest[i] = std::min(nearest[i], d);
                far = std::max(far, bounds.back()(corners[i]));
                near = std::min(near, d);
            }
            bound = std::min(bound, far);
            reach.emplace_back(near, w);
        }
        for (std::size_t i = 0; i < corners.size(); ++i)
            if (nearest[i] > depth && in_piece(corners[i])) {
                depth = nearest[i];
                point = corners[i];
            }
        if (bound <= depth + depth_error) return;
        c.walls.clear();
        std::vector<ConvexBound> kept;
        for (std::size_t i = 0; i < reach.size(); ++i) {
            if (reach[i].first > bound + size) continue;
            c.walls.push_back(reach[i].second);
            kept.push_back(bounds[i]);
        }
        c.bound = std::min(bound, between_two(kept, corners));
        if (c.bound > depth + depth_error) open.push(std::move(c));
    }
    [[nodiscard]] bool in_piece(Vec2 p) const {
        return geom::contains(piece_, p) || geom::distance(piece_, p) <= 2 * chord_error;
    }
    /// Between two walls no point is farther from the nearer one than half the sum of the distances.
    [[nodiscard]] static double between_two(const std::vector<ConvexBound>& walls, const std::vector<Vec2>& corners) {
        double bound = std::numeric_limits<double>::infinity();
        if (walls.size() > 12) return bound;
        for (std::size_t i = 0; i < walls.size(); ++i)
            for (std::size_t j = i + 1; j < walls.size(); ++j) {
                double far = 0;
                for (const Vec2 p : corners) far = std::max(far, 0.5 * (walls[i](p) + walls[j](p)));
                bound = std::min(bound, far);
            }
        return bound;
    }

    /// The walls that may be nearest to some point of the part.
    [[nodiscard]] std::vector<Feature> nearest_walls(const std::vector<Vec2>& corners_of_part) const {
        const geom::Box b = box_of(corners_of_part);
        const std::array<Vec2, 4> corners{b.lo, {b.hi.x, b.lo.y}, b.hi, {b.lo.x, b.hi.y}};
        double far = std::numeric_limits<double>::infinity();
        const auto farthest = [&](auto&& to) {
            double d = 0;
            for (const Vec2 c : corners) d = std::max(d, to(c));
            return d;
        };
        for (const Wall& w : all_) far = std::min(far, farthest([&](Vec2 c) { return geom::distance(w.edge.a, c); }));
        for (const Wall& w : all_)
            if (apart(w.box, b) <= far)
                far = std::min(far, farthest([&](Vec2 c) { return geom::distance(w.edge, c); }));
        std::vector<Feature> out;
        for (const Wall& w : all_) {
            if (apart(w.box, b) > far + geom::snap) continue;
            const int quarters =
                w.arc ? 1 + base::clipped<int>(std::abs(geom::sweep_angle(w.edge)) / (geom::pi / 2), 0, 4) : 1;
            for (int i = 0; i < quarters; ++i)
                out.emplace_back(quarters == 1 ? w.edge
                                               : geom::part(w.edge, static_cast<double>(i) / quarters,
                                                            static_cast<double>(i + 1) / quarters));
        }
        return out;
    }

    const std::vector<Wall>& all_;
    std::vector<Feature> walls_;
    Region piece_;
};

bool on_axis(const Edge& e) { return std::abs(e.a.y) <= geom::snap && std::abs(e.b.y) <= geom::snap && e.bulge == 0; }

}  // namespace

Around::Around(const Region& contour) : edges_(walls_of(contour)) {
    std::erase_if(edges_, [](const Wall& w) { return on_axis(w.edge); });
}

std::optional<Depth> Around::measure(const Region& piece, double tolerance) const {
    Depth d;
    if (edges_.empty()) return std::nullopt;
    Deepest deepest(edges_);
    deepest.search(piece);
    d.normal = deepest.depth;
    if (!(d.normal > tolerance)) return std::nullopt;
    d.deepest = deepest.point;
    d.area = geom::area(piece);
    d.volume = geom::volume(piece);
    d.along_x = deepest_along_x(piece, edges_);
    d.region = piece;
    return d;
}

bool Around::reaches(const Region& piece, double depth) const {
    if (edges_.empty()) return true;
    Deepest deepest(edges_);
    deepest.search(piece, depth);
    return deepest.depth > depth;
}

}  // namespace obrys::sim::turning
