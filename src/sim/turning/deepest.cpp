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

constexpr double depth_error = 2e-4;  // mm, of a normal depth found inside or along a piece
constexpr double chord_error = 1e-4;  // mm, of arcs as chords, for bounds only
constexpr int most_cells = 20'000;

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
        n = base::clipped<int>(std::ceil(std::abs(geom::sweep_angle(e)) / std::max(step, 1e-3)), 2, 10'000);
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

/// A piece that is not convex, clipped: its parts hang together by seams along the cut, which are not of the piece.
struct Cell {
    Polygon part;
    std::vector<std::uint32_t> walls;  ///< those that may be nearest to a point of the part
    double bound = 0;
    bool operator<(const Cell& other) const { return bound < other.bound; }
};

/// Largest distance from the points of one outer contour to walls, by branch and bound. The distance to a straight wall
/// is convex, so over a part it is largest in a corner of the part.
class Deepest {
public:
    explicit Deepest(const std::vector<Wall>& walls) : all_(walls) {}

    void search(const geom::Contour& piece) {
        piece_ = {{piece}};
        std::vector<Edge> chords;
        for (const Edge& e : geom::edges(piece)) add_chords(e, chords);
        Cell all;
        for (const Edge& e : chords) all.part.push_back(e.a);
        walls_ = nearest_walls(all.part);
        for (std::uint32_t i = 0; i < walls_.size(); ++i) all.walls.push_back(i);
        std::priority_queue<Cell> open;
        offer(std::move(all), open);
        for (int n = 0; n < most_cells && !open.empty() && open.top().bound > depth + depth_error; ++n) {
            const Cell c = open.top();
            open.pop();
            geom::Box b;
            for (const Vec2 p : c.part) b.add(p);
            const int axis = b.hi.x - b.lo.x > b.hi.y - b.lo.y ? 0 : 1;
            const double at = axis == 0 ? 0.5 * (b.lo.x + b.hi.x) : 0.5 * (b.lo.y + b.hi.y);
            for (const double sign : {-1.0, 1.0}) {
                Cell half{clipped(c.part, axis, at, sign), c.walls, 0};
                if (std::abs(doubled_area(half.part)) > 1e-12) offer(std::move(half), open);  // else seams alone
            }
        }
    }

    double depth = 0;
    Vec2 point;

private:
    void offer(Cell c, std::priority_queue<Cell>& open) {
        if (c.part.size() < 2) return;
        double bound = std::numeric_limits<double>::infinity(), least_far = bound;
        std::vector<double> nearest(c.part.size(), bound), to_wall(c.part.size());
        std::vector<std::pair<double, std::uint32_t>> reach;  // nearest corner of the part to each wall
        geom::Box b;
        for (const Vec2 p : c.part) b.add(p);
        const double size = geom::distance(b.lo, b.hi);
        for (const std::uint32_t w : c.walls) {
            double far = 0, near = std::numeric_limits<double>::infinity();
            for (std::size_t i = 0; i < c.part.size(); ++i) {
                const double d = geom::distance(walls_[w], c.part[i]);
                nearest[i] = std::min(nearest[i], d);
                far = std::max(far, d);
                near = std::min(near, d);
            }
            bound = std::min(bound, far);
            least_far = std::min(least_far, far);
            reach.emplace_back(near, w);
        }
        for (std::size_t i = 0; i < c.part.size(); ++i)
            if (nearest[i] > depth && in_piece(c.part[i])) {
                depth = nearest[i];
                point = c.part[i];
            }
        if (bound <= depth + depth_error) return;
        c.walls.clear();
        for (const auto& [near, w] : reach)
            if (near <= least_far + size) c.walls.push_back(w);
        c.bound = std::min(bound, between_two(c));
        if (c.bound > depth + depth_error) open.push(std::move(c));
    }
    [[nodiscard]] bool in_piece(Vec2 p) const {
        return geom::contains(piece_, p) || geom::distance(piece_, p) <= 2 * chord_error;
    }
    /// Between two walls no point is farther from the nearer one than half the sum of the distances.
    [[nodiscard]] double between_two(const Cell& c) const {
        double bound = std::numeric_limits<double>::infinity();
        if (c.walls.size() > 12) return bound;
        for (std::size_t i = 0; i < c.walls.size(); ++i)
            for (std::size_t j = i + 1; j < c.walls.size(); ++j) {
                double far = 0;
                for (const Vec2 p : c.part)
                    far = std::max(
                        far, 0.5 * (geom::distance(walls_[c.walls[i]], p) + geom::distance(walls_[c.walls[j]], p)));
                bound = std::min(bound, far);
            }
        return bound;
    }

    /// The walls that may be nearest to some point of the part.
    [[nodiscard]] std::vector<Edge> nearest_walls(const Polygon& part) const {
        geom::Box b;
        for (const Vec2 p : part) b.add(p);
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
        std::vector<Edge> out;
        for (const Wall& w : all_)
            if (apart(w.box, b) <= far + geom::snap) out.push_back(w.edge);
        return out;
    }

    const std::vector<Wall>& all_;
    std::vector<Edge> walls_;
    Region piece_;
};

bool on_axis(const Edge& e) { return std::abs(e.a.y) <= geom::snap && std::abs(e.b.y) <= geom::snap && e.bulge == 0; }

}  // namespace

Around::Around(const Region& contour) : edges_(walls_of(contour)) {
    std::erase_if(edges_, [](const Wall& w) { return on_axis(w.edge); });
    std::vector<Edge> chords;
    for (const Wall& w : edges_) add_chords(w.edge, chords);
    for (const Edge& e : chords) chords_.push_back({e, geom::box(e), false});
}

std::optional<Depth> Around::measure(const Region& piece, double tolerance) const {
    Depth d;
    if (chords_.empty()) return std::nullopt;
    Deepest deepest(chords_);
    for (const geom::Contour& c : piece.contours)
        if (geom::area(c) > 0) deepest.search(c);
    // The corner found is exact in the piece; its distance from the true contour, arcs as arcs.
    d.normal = std::numeric_limits<double>::infinity();
    const geom::Box here{deepest.point, deepest.point};
    for (const Wall& w : edges_)
        if (apart(w.box, here) <= d.normal) d.normal = std::min(d.normal, geom::distance(w.edge, deepest.point));
    if (!(d.normal > tolerance) || deepest.depth == 0) return std::nullopt;
    d.deepest = deepest.point;
    d.area = geom::area(piece);
    d.volume = geom::volume(piece);
    d.along_x = deepest_along_x(piece, edges_);
    d.region = piece;
    return d;
}

}  // namespace obrys::sim::turning
