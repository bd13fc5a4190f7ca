#pragma once
/// Shapes of tools, how deep they cut, and random bodies with tools that nearly touch them.

#include <cmath>
#include <optional>

#include "geom/random_cases_testing.hpp"
#include "mesh/primitives.hpp"
#include "sim/certify/certify.hpp"

namespace obrys::sim::certify::testing {

using geom::Vec3;
using geom::testing::Random;

inline Shape end_mill(double r, double height = 30) { return {{r, 0, r, height, 0}}; }
inline Shape ball(double r, double height = 30) { return {{0, r, 0, r, r}, {r, r, r, height, 0}}; }
inline Shape bull(double r, double corner, double height = 30) {
    return {{r - corner, corner, r - corner, corner, corner}, {r, corner, r, height, 0}};
}
inline Shape cone(double r, double degrees, double height = 30) {
    const double h = r / std::tan(geom::radians(degrees) / 2);
    return {{0, 0, r, h, 0}, {r, h, r, h + height, 0}};
}

inline std::optional<Depth> found_in(const Judge& judge, const Shape& shape, Vec3 from, Vec3 to,
                                     Vec3 axis = {0, 0, 1}) {
    const Move move{geom::Straight{from, to}, axis, &shape};
    return judge.is_clear(move) ? std::nullopt : judge.deepest(move);
}

inline double depth_of(const Judge& judge, const Shape& shape, Vec3 from, Vec3 to, Vec3 axis = {0, 0, 1}) {
    const std::optional<Depth> found = found_in(judge, shape, from, to, axis);
    return found ? found->depth : 0;
}

/// A random body and a tool that nearly touches it.
struct Case {
    mesh::Mesh part;
    Shape tool;
    Vec3 from, to, axis;
};

inline Vec3 direction(Random& random) {
    for (;;) {
        const Vec3 v{random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
        if (length(v) > 0.1 && length(v) < 1) return (1 / length(v)) * v;
    }
}

inline Case random_case(Random& random) {
    Case c;
    switch (random.below(3)) {
        case 0: c.part = mesh::box({-10, -8, -6}, {10, 8, 6}); break;
        case 1: c.part = mesh::ball({0, 0, 0}, 8, 40); break;
        default: c.part = mesh::cylinder({0, 0, -6}, 8, 12, 60); break;
    }
    const double r = random.between(1, 5);
    switch (random.below(4)) {
        case 0: c.tool = end_mill(r, 20); break;
        case 1: c.tool = ball(r, 20); break;
        case 2: c.tool = bull(r, r * random.between(0.1, 0.9), 20); break;
        default: c.tool = cone(r, random.between(30, 150), 20); break;
    }
    c.axis = random.below(2) == 0 ? Vec3{0, 0, 1} : direction(random);
    const Vec3 out = direction(random);
    c.from = random.between(6, 14) * out + random.between(0, 5) * direction(random);
    c.to = c.from + random.between(0.1, 8) * direction(random);
    return c;
}

}  // namespace obrys::sim::certify::testing
