#include "sim/turning/contact.hpp"

#include <algorithm>
#include <cmath>

#include "geom/region.hpp"

namespace obrys::sim::turning {

using geom::Edge;
using geom::Vec2;

namespace {

constexpr std::size_t most_poses = 24;
constexpr double touching = 1e-7;  // mm

double length_in(const Edge& e, Vec2 ahead, const std::vector<Edge>& material) {
    std::vector<double> stops{0, 1};
    const geom::Box b = geom::box(e);
    for (const Edge& m : material) {
        if (!geom::overlap(geom::box(m), b, touching)) continue;
        const geom::Crossings c = geom::crossings(e, m, touching);
        for (int i = 0; i < c.count; ++i) stops.push_back(geom::parameter(e, c.points[static_cast<std::size_t>(i)]));
        for (const Vec2 p : {m.a, m.b})
            if (geom::distance(e, p) <= touching) stops.push_back(geom::parameter(e, p));
    }
    for (double& t : stops) t = std::clamp(t, 0.0, 1.0);
    std::sort(stops.begin(), stops.end());
    double sum = 0;
    const double whole = geom::length(e);
    for (std::size_t i = 0; i + 1 < stops.size(); ++i) {
        if ((stops[i + 1] - stops[i]) * whole <= touching) continue;
        const double t = 0.5 * (stops[i] + stops[i + 1]);
        if (geom::cross(ahead, geom::tangent_at(e, t)) <= 1e-9) continue;  // looks aside or back
        // A little behind the edge: at the end of the move the edge lies on the border of what it removed.
        const Vec2 p = geom::point_at(e, t) - (10 * touching) * ahead;
        if (geom::winding(material, p) > 0) sum += (stops[i + 1] - stops[i]) * whole;
    }
    return sum;
}

}  // namespace

double contact_length(const geom::Contour& outline, const Move& move, const geom::Region& removed) {
    Vec2 ahead = move.to - move.from;
    if (move.sweep != 0) ahead = (move.sweep > 0 ? 1.0 : -1.0) * geom::left_of(move.to - move.centre);
    const double way = geom::length(ahead);
    if (way < touching) return 0;
    const Vec2 u = (1 / way) * ahead;
    const std::vector<Edge> material = geom::edges(removed), own = geom::edges(outline);
    std::vector<double> poses{0};  // back from the end, mm
    if (move.sweep == 0)
        for (const Edge& m : material)
            for (const Edge& e : own)
                for (const Vec2 corner : {e.a, e.b})
                    if (const double back = geom::dot(move.to + corner - m.a, u); back > touching && back < way)
                        poses.push_back(back);
    std::sort(poses.begin(), poses.end());
    poses.erase(std::unique(poses.begin(), poses.end(), [](double a, double b) { return b - a < 1e-3; }), poses.end());
    const std::size_t stride = 1 + poses.size() / most_poses;
    double best = 0;
    for (std::size_t i = 0; i < poses.size(); i += stride) {
        double sum = 0;
        for (const Edge& e : own) sum += length_in(geom::moved(e, move.to - poses[i] * u), u, material);
        best = std::max(best, sum);
    }
    return best;
}

}  // namespace obrys::sim::turning
