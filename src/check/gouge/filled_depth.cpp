#include "check/gouge/filled_depth.hpp"

#include <array>
#include <cmath>

namespace obrys::check {

namespace milling = sim::milling;

using geom::Vec3;

FilledDepth depth_at(const milling::Air& air, Vec3 p, double least, double enough, std::size_t first) {
    FilledDepth d{enough, 0};
    const auto ask = [&](std::size_t body) {
        if (const double outside = air.outside(body, p, d.depth); outside < d.depth) d = {outside, body};
        return d.depth > least;
    };
    if (!ask(first) || !ask(0)) return d;
    for (std::size_t body = 1; body < air.bodies(); ++body)
        if (body != first && !ask(body)) break;
    return d;
}

Vec3 way_out(const milling::Air& air, std::size_t body, Vec3 p) {
    constexpr double h = 1e-4;  // mm
    Vec3 way, nearest;
    double least = HUGE_VAL;
    for (int k = 0; k < 3; ++k) {
        std::array<double, 2> at{};
        for (std::size_t i = 0; i < 2; ++i) {
            Vec3 q = p;
            milling::set_component(q, k, milling::component(p, k) + (i == 0 ? -h : h));
            at[i] = air.outside(body, q);
            if (at[i] < least) least = at[i], nearest = (1 / h) * (q - p);
        }
        milling::set_component(way, k, at[0] - at[1]);
    }
    const double size = length(way);
    // Halfway between two sides of the stock it leads either way.
    return size > 1e-3 * h ? (1 / size) * way : nearest;
}

}  // namespace obrys::check
