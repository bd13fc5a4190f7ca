#pragma once
/// Shared by the tests of this folder and its rooms: distances by their definition, random numbers.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "path/element.hpp"

namespace obrys::path::test {

using geom::pi;
using geom::Vec2;

inline void expect_point(Vec2 actual, Vec2 expected, double tolerance = 1e-9) {
    EXPECT_NEAR(actual.x, expected.x, tolerance);
    EXPECT_NEAR(actual.y, expected.y, tolerance);
}
inline void expect_near(Vec2 actual, Vec2 expected, double tolerance = 1e-9) {
    EXPECT_NEAR(geom::distance(actual, expected), 0, tolerance) << actual.x << ' ' << actual.y;
}

inline std::vector<Element> polyline(const std::vector<Vec2>& p) {
    std::vector<Element> e;
    for (std::size_t i = 1; i < p.size(); ++i) e.push_back(line(p[i - 1], p[i]));
    return e;
}

/// Nearest point of an element, by its definition.
inline Vec2 nearest(const Element& e, Vec2 p) {
    if (!is_arc(e)) {
        const Vec2 d = e.to - e.from;
        const double t = std::clamp(geom::dot(p - e.from, d) / geom::dot(d, d), 0.0, 1.0);
        return e.from + t * d;
    }
    const Vec2 radial = p - e.centre;
    const double radius = geom::distance(e.from, e.centre), along = geom::length(radial);
    double angle = std::atan2(radial.y, radial.x) - std::atan2(e.from.y - e.centre.y, e.from.x - e.centre.x);
    if (e.sweep < 0) angle = -angle;
    angle = std::fmod(angle + 4 * geom::pi, 2 * geom::pi);
    if (along > 0 && angle <= std::abs(e.sweep)) return e.centre + (radius / along) * radial;
    return geom::distance(p, e.from) < geom::distance(p, e.to) ? e.from : e.to;
}

inline double distance_to(const std::vector<Element>& contour, Vec2 p) {
    double best = std::numeric_limits<double>::infinity();
    for (const Element& e : contour) best = std::min(best, geom::distance(p, nearest(e, p)));
    return best;
}

class Random {
public:
    explicit Random(std::uint32_t seed) : engine_(seed) {}
    double in(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine_); }
    int upto(int n) { return std::uniform_int_distribution<int>(0, n)(engine_); }

private:
    std::mt19937 engine_;
};

}  // namespace obrys::path::test
