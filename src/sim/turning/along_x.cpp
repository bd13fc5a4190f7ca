#include "sim/turning/along_x.hpp"

#include <algorithm>
#include <cmath>

#include "geom/region.hpp"
#include "geom/tolerance.hpp"

namespace obrys::sim::turning {

using geom::Edge;
using geom::Vec2;

namespace {

/// Values of x in which the column at z meets the edges, sorted. z is no corner's.
std::vector<double> column(const std::vector<Edge>& edges, double z) {
    std::vector<double> out;
    const double far = 1e6;
    for (const Edge& e : edges) {
        const geom::Box b = geom::box(e);
        if (z < b.lo.x || z > b.hi.x) continue;
        if (!geom::is_arc(e)) {
            if ((e.a.x <= z) != (e.b.x <= z)) out.push_back(e.a.y + (z - e.a.x) / (e.b.x - e.a.x) * (e.b.y - e.a.y));
            continue;
        }
        const geom::Crossings c = geom::crossings(e, {{z, -far}, {z, far}, 0}, geom::snap);
        for (int i = 0; i < c.count; ++i) out.push_back(c.points[static_cast<std::size_t>(i)].y);
    }
    std::sort(out.begin(), out.end());
    return out;
}

struct Columns {
    std::vector<Edge> piece, contour;
    std::vector<double> corners;

    void add_corners(const std::vector<Edge>& edges) {
        for (const Edge& e : edges) {
            const geom::Box b = geom::box(e);
            corners.push_back(b.lo.x);
            corners.push_back(b.hi.x);
        }
    }
    [[nodiscard]] double at(double z) const {
        const std::vector<double> own = column(piece, z);
        std::vector<double> walls = column(contour, z);
        std::erase_if(walls, [](double x) { return std::abs(x) <= geom::snap; });
        double best = 0;
        for (std::size_t i = 0; i + 1 < own.size(); i += 2) {
            // The span of the piece lies between the walls next to its middle.
            const double lo = own[i], hi = own[i + 1], mid = 0.5 * (lo + hi);
            const auto above = std::upper_bound(walls.begin(), walls.end(), mid);
            const bool up = above != walls.end(), down = above != walls.begin();
            if (up && down) {
                const double top = *above, bottom = *(above - 1), x = std::clamp(0.5 * (top + bottom), lo, hi);
                best = std::max(best, std::min(top - x, x - bottom));
            } else if (up) {
                best = std::max(best, *above - lo);
            } else if (down) {
                best = std::max(best, hi - *(above - 1));
            }
        }
        return best;
    }
};

double largest_between(const Columns& c, double z0, double z1) {
    // Straight walls: largest at an end, or where the two ways are alike; arcs: searched. The golden section after a
    // coarse look is exact to 1e-9 of the width for one hump a step.
    constexpr int steps = 8;
    const double in = 1e-9 * (z1 - z0);
    double best = 0, where = z0;
    for (int i = 0; i <= steps; ++i) {
        const double z = std::clamp(z0 + (z1 - z0) * i / steps, z0 + in, z1 - in);
        if (const double d = c.at(z); d > best) best = d, where = z;
    }
    double lo = std::max(z0 + in, where - (z1 - z0) / steps), hi = std::min(z1 - in, where + (z1 - z0) / steps);
    for (int i = 0; i < 45; ++i) {
        const double p = lo + 0.381966 * (hi - lo), q = hi - 0.381966 * (hi - lo);
        const double dp = c.at(p), dq = c.at(q);
        best = std::max({best, dp, dq});
        if (dp < dq) lo = p;
        else hi = q;
    }
    return best;
}

}  // namespace

double deepest_along_x(const geom::Region& piece, const geom::Region& region) {
    Columns c{geom::edges(piece), geom::edges(region), {}};
    c.add_corners(c.piece);
    const geom::Box b = geom::box(piece);
    c.add_corners(c.contour);
    std::erase_if(c.corners, [&](double z) { return z < b.lo.x || z > b.hi.x; });
    std::sort(c.corners.begin(), c.corners.end());
    double best = 0;
    for (std::size_t i = 0; i + 1 < c.corners.size(); ++i)
        if (c.corners[i + 1] - c.corners[i] > geom::snap)
            best = std::max(best, largest_between(c, c.corners[i], c.corners[i + 1]));
    return best;
}

}  // namespace obrys::sim::turning
