#include "sim/turning/along_x.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "geom/region.hpp"
#include "geom/tolerance.hpp"

namespace obrys::sim::turning {

using geom::Edge;

namespace {

double straight_at(const Edge& e, double z) { return e.a.y + (z - e.a.x) / (e.b.x - e.a.x) * (e.b.y - e.a.y); }

/// Edges in the order in which a column that goes along z meets them.
class Swept {
public:
    /// Edges upright or beside [z0, z1] bound no column.
    Swept(const std::vector<Wall>& edges, double z0, double z1) {
        for (const Wall& w : edges)
            if (w.box.lo.x < w.box.hi.x && w.box.lo.x <= z1 && w.box.hi.x >= z0) walls_.push_back(w);
        std::sort(walls_.begin(), walls_.end(), [](const Wall& a, const Wall& b) { return a.box.lo.x < b.box.lo.x; });
    }
    /// Between z0 and z1 no edge begins or ends; z0 does not go back.
    void go_to(double z0, double z1) {
        std::erase_if(active_, [&](const Wall* w) { return w->box.hi.x < z1; });
        for (; next_ < walls_.size() && walls_[next_].box.lo.x <= z0; ++next_)
            if (walls_[next_].box.hi.x >= z1) active_.push_back(&walls_[next_]);
        has_arc_ = std::any_of(active_.begin(), active_.end(), [](const Wall* w) { return w->arc; });
    }
    void add_corners(std::vector<double>& out) const {
        for (const Wall& w : walls_) {
            out.push_back(w.box.lo.x);
            out.push_back(w.box.hi.x);
        }
    }
    [[nodiscard]] bool has_arc() const { return has_arc_; }
    [[nodiscard]] const std::vector<const Wall*>& active() const { return active_; }
    /// Values of x in which the column at z meets the edges, sorted. z is no corner's.
    void column(double z, std::vector<double>& out) const {
        constexpr double far = 1e6;
        out.clear();
        for (const Wall* w : active_) {
            if (!w->arc) {
                out.push_back(straight_at(w->edge, z));
                continue;
            }
            const geom::Crossings c = geom::crossings(w->edge, {{z, -far}, {z, far}, 0}, geom::snap);
            for (int i = 0; i < c.count; ++i) out.push_back(c.points[static_cast<std::size_t>(i)].y);
        }
        std::sort(out.begin(), out.end());
    }

private:
    std::vector<Wall> walls_;
    std::vector<const Wall*> active_;
    std::size_t next_ = 0;
    bool has_arc_ = false;
};

/// The way out of the span [lo, hi] of the piece, between the walls next to its middle.
double way_out(double lo, double hi, const std::vector<double>& walls) {
    const auto above = std::upper_bound(walls.begin(), walls.end(), 0.5 * (lo + hi));
    const bool up = above != walls.end(), down = above != walls.begin();
    if (up && down) {
        const double top = *above, bottom = *(above - 1), x = std::clamp(0.5 * (top + bottom), lo, hi);
        return std::min(top - x, x - bottom);
    }
    return up ? *above - lo : down ? hi - *(above - 1) : 0;
}

class Columns {
public:
    Columns(const geom::Region& piece, const std::vector<Wall>& contour, const geom::Box& b)
        : piece_(walls_of(piece), b.lo.x, b.hi.x), contour_(contour, b.lo.x, b.hi.x) {
        piece_.add_corners(corners_);
        contour_.add_corners(corners_);
        std::erase_if(corners_, [&](double z) { return z < b.lo.x || z > b.hi.x; });
        std::sort(corners_.begin(), corners_.end());
    }
    [[nodiscard]] double largest() {
        double best = 0;
        for (std::size_t i = 0; i + 1 < corners_.size(); ++i) {
            const double z0 = corners_[i], z1 = corners_[i + 1];
            if (!(z1 - z0 > geom::snap)) continue;
            piece_.go_to(z0, z1);
            contour_.go_to(z0, z1);
            if (piece_.active().empty() || contour_.active().empty()) continue;
            const bool arcs = piece_.has_arc() || contour_.has_arc();
            best = std::max(best, arcs ? searched(z0, z1) : of_straight_walls(z0, z1));
        }
        return best;
    }

private:
    using Ends = std::array<double, 2>;  ///< values at both ends of the interval

    [[nodiscard]] double at(double z) {
        piece_.column(z, own_);
        contour_.column(z, walls_);
        double best = 0;
        for (std::size_t i = 0; i + 1 < own_.size(); i += 2)
            best = std::max(best, way_out(own_[i], own_[i + 1], walls_));
        return best;
    }
    /// The golden section after a coarse look is exact to 1e-9 of the width for one hump a step.
    [[nodiscard]] double searched(double z0, double z1) {
        constexpr int steps = 8;
        const double in = 1e-9 * (z1 - z0);
        double best = 0, where = z0;
        for (int i = 0; i <= steps; ++i) {
            const double z = std::clamp(z0 + (z1 - z0) * i / steps, z0 + in, z1 - in);
            if (const double d = at(z); d > best) best = d, where = z;
        }
        double lo = std::max(z0 + in, where - (z1 - z0) / steps), hi = std::min(z1 - in, where + (z1 - z0) / steps);
        for (int i = 0; i < 45; ++i) {
            const double p = lo + 0.381966 * (hi - lo), q = hi - 0.381966 * (hi - lo);
            const double dp = at(p), dq = at(q);
            best = std::max({best, dp, dq});
            if (dp < dq)
                lo = p;
            else
                hi = q;
        }
        return best;
    }
    /// Straight edges that do not cross: the way out of each span is the least of linear functions, so it is largest at
    /// an end or where two of these are alike. The order in the middle holds all along.
    [[nodiscard]] double of_straight_walls(double z0, double z1) {
        const auto ends = [&](const Swept& s, std::vector<Ends>& out) {
            order_.clear();
            for (const Wall* w : s.active()) order_.emplace_back(straight_at(w->edge, 0.5 * (z0 + z1)), w);
            std::sort(order_.begin(), order_.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
            out.clear();
            for (const auto& [x, w] : order_) out.push_back({straight_at(w->edge, z0), straight_at(w->edge, z1)});
        };
        ends(piece_, own_ends_);
        ends(contour_, wall_ends_);
        double best = 0;
        for (std::size_t i = 0; i + 1 < own_ends_.size(); i += 2)
            best = std::max(best, of_span(own_ends_[i], own_ends_[i + 1]));
        return best;
    }
    [[nodiscard]] double of_span(const Ends& lo, const Ends& hi) const {
        const double middle = lo[0] + lo[1] + hi[0] + hi[1];
        const auto above = std::upper_bound(wall_ends_.begin(), wall_ends_.end(), middle,
                                            [](double m, const Ends& w) { return m < 2 * (w[0] + w[1]); });
        const bool up = above != wall_ends_.end(), down = above != wall_ends_.begin();
        if (!up && !down) return 0;
        std::array<Ends, 3> ways{};
        for (const std::size_t i : {0U, 1U}) {
            if (up) ways[0][i] = (*above)[i] - lo[i];
            if (down) ways[up ? 1 : 0][i] = hi[i] - (*(above - 1))[i];
            if (up && down) ways[2][i] = 0.5 * ((*above)[i] - (*(above - 1))[i]);
        }
        const std::size_t count = up && down ? 3 : 1;
        const auto least = [&](double t) {
            double v = ways[0][0] + t * (ways[0][1] - ways[0][0]);
            for (std::size_t k = 1; k < count; ++k) v = std::min(v, ways[k][0] + t * (ways[k][1] - ways[k][0]));
            return v;
        };
        double best = std::max(least(0), least(1));
        for (std::size_t j = 0; j < count; ++j)
            for (std::size_t k = j + 1; k < count; ++k) {
                const double d0 = ways[j][0] - ways[k][0], d1 = ways[j][1] - ways[k][1];
                if ((d0 > 0) != (d1 > 0) && d0 != d1) best = std::max(best, least(d0 / (d0 - d1)));
            }
        return best;
    }

    Swept piece_, contour_;
    std::vector<double> corners_;
    std::vector<double> own_, walls_;
    std::vector<std::pair<double, const Wall*>> order_;
    std::vector<Ends> own_ends_, wall_ends_;
};

}  // namespace

std::vector<Wall> walls_of(const geom::Region& region) {
    std::vector<Wall> out;
    for (const Edge& e : geom::edges(region)) out.push_back({e, geom::box(e), geom::is_arc(e)});
    return out;
}

double deepest_along_x(const geom::Region& piece, const std::vector<Wall>& contour) {
    const geom::Box b = geom::box(piece);
    return b.empty() ? 0 : Columns(piece, contour, b).largest();
}

}  // namespace obrys::sim::turning
