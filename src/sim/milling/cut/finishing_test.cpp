// Finishing with a ball: every point of the surface lies at the ball's radius from the way of its centre, and none
// nearer.

#include <algorithm>
#include <cmath>
#include <random>

#include "sim/milling/cut/milling_testing.hpp"

namespace obrys::sim::milling {
namespace {

using geom::Vec3;

double square_from_way(const std::vector<Vec3>& way, Vec3 p) {
    double least = 1e9;
    for (std::size_t i = 1; i < way.size(); ++i) {
        const Vec3 a = way[i - 1], v = way[i] - a, q = p - a;
        const Vec3 off = q - std::clamp(dot(q, v) / dot(v, v), 0.0, 1.0) * v;
        least = std::min(least, dot(off, off));
    }
    return least;
}

/// Tips of a zig-zag over a wavy surface, all moves short, with steps of any length.
std::vector<Vec3> zigzag(std::uint64_t seed) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> between(0.1, 0.9);
    std::vector<Vec3> tips{{-1, -1, 4}};
    double sign = 1;
    for (double x = -1, y = -1; y < 13; x += sign * between(random)) {
        if (x < -1 || x > 13) {
            x = std::clamp(x, -1.0, 13.0);
            y += 0.5;
            sign = -sign;
        }
        tips.push_back({x, y, -2.5 + std::sin(0.9 * x) * std::cos(0.7 * y)});
    }
    return tips;
}

TEST(Finishing, EveryPointLiesOnTheBallsEnvelope) {
    const Box3 block{{0, 0, -6}, {12, 12, 0}};
    for (const Vec3 axis : {Vec3{0, 0, 1}, Vec3{0.3, 0.2, 1}}) {
        Work w(block, 0.24, tool_of(CutterKind::ball, 6));
        w.axis = axis;
        const std::vector<Vec3> tips = zigzag(5);
        w.start(tips[0]);
        for (std::size_t i = 1; i < tips.size(); ++i) w.to(tips[i]);
        const double removed = w.removed();
        EXPECT_NEAR(w.summed() / removed, 1, 0.01);
        std::vector<Vec3> way = tips;  // of the ball's centre
        for (Vec3& p : way) p = p + (3 / length(axis)) * axis;
        const Dexels& d = w.simulation.dexels();
        std::size_t on_ball = 0, off = 0, inside = 0;
        for (int ray_axis = 0; ray_axis < 3; ++ray_axis) {
            const int first = first_across(ray_axis), second = second_across(ray_axis);
            for (int b = 0; b < d.rays_b(ray_axis); b += 2) {
                for (int a = 0; a < d.rays_a(ray_axis); a += 2) {
                    for (const Interval& v : d.ray(ray_axis, a, b)) {
                        if (v.end_cut == 0) continue;
                        Vec3 p = d.lattice().origin;
                        set_component(p, first, component(p, first) + a * component(d.lattice().step, first));
                        set_component(p, second, component(p, second) + b * component(d.lattice().step, second));
                        set_component(p, ray_axis, v.end);
                        const double distance = std::sqrt(square_from_way(way, p));
                        inside += distance < 3 - 1e-6;
                        // What the straight part above the ball has cut lies farther out.
                        (std::abs(distance - 3) < 1e-6 ? on_ball : off) += 1;
                        if (std::abs(distance - 3) > 1e-6) continue;
                        const Vec3 n = w.simulation.normal_at(v.end_cut, p);
                        const double before = std::sqrt(square_from_way(way, p + 0.01 * n));
                        EXPECT_NEAR(before, distance - 0.01, 1e-4);
                    }
                }
            }
        }
        EXPECT_EQ(inside, 0U);
        EXPECT_GT(on_ball, 500U);
        EXPECT_LT(off, on_ball / 5);
    }
}

}  // namespace
}  // namespace obrys::sim::milling
