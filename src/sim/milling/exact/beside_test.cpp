/// What is proved to lie beside material does: random cuts along circles and lines, random small triangles near them.

#include <random>

#include "base/seed_testing.hpp"
#include "base/whole.hpp"
#include "sim/milling/cut/milling_testing.hpp"
#include "sim/milling/exact/exact.hpp"

namespace obrys::sim::milling {
namespace {

using geom::Vec3;

/// Whether random places of a ball find material.
bool has_material(const Exact& exact, const Exact::Near& near, Vec3 p, double radius, std::mt19937& random) {
    std::uniform_real_distribution<double> any(-1, 1);
    for (int i = 0; i < 3000; ++i) {
        const Vec3 way{any(random), any(random), any(random)};
        if (geom::length(way) <= 1 && exact.is_material(near, p + radius * way)) return true;
    }
    return false;
}

/// How high the bottom of a tool lies at a distance from its axis.
double bottom_at(double radius, double corner, double across) {
    const double round = across - (radius - corner);
    return round <= 0 ? 0 : corner - std::sqrt(std::max(0.0, corner * corner - round * round));
}

TEST(BesideMaterial, IsTrueOfWhatIsProved) {
    constexpr double allowed = 0.01;
    const std::uint32_t seed = base::testing_seed();
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    const auto between = [&](double a, double b) { return std::uniform_real_distribution<double>(a, b)(random); };
    const Box3 block{{0, 0, -10}, {30, 30, 0}};
    int proved = 0, in_air = 0;
    for (int world = 0; world < 12; ++world) {
        const auto kind = std::array{CutterKind::end_mill, CutterKind::bull_nose, CutterKind::ball}[world % 3];
        const double radius = between(1, 5), track = between(0.3, 6);
        const double corner = std::array{0.0, 0.4, 1.0}[world % 3] * radius;
        Work w(block, 0.4, tool_of(kind, 2 * radius, 0.4 * radius));
        const double z = between(-4, -1), turn = between(0.5, 6.2) * (world % 2 == 0 ? 1 : -1);
        w.start({15 + track, 15, z});
        w.arc({15 + track * std::cos(turn), 15 + track * std::sin(turn), z}, {15, 15, z}, turn);
        w.to({between(3, 27), between(3, 27), z});
        w.simulation.flush();
        const Lattice lattice = w.simulation.dexels().lattice();
        Exact exact(w.simulation, lattice);
        for (int i = 0; i < 20'000; ++i) {
            // Beside the way's inner and outer wall, and at the tool's bottom.
            const bool below = i % 2 == 1;
            const double across = below ? between(-1, 1) : i % 4 == 0 ? -1 : 1;
            const double angle = between(0, 2 * geom::pi), off = track + radius * across;
            const double high = below ? bottom_at(radius, corner, radius * std::abs(across)) : between(0, 0.9) * -z;
            const Vec3 at{15 + off * std::cos(angle) + between(-0.02, 0.02),
                          15 + off * std::sin(angle) + between(-0.02, 0.02), z + high + between(-0.02, 0.02)};
            const double size = between(0.01, 0.2);
            const auto near_at = [&] { return at + size * Vec3{between(-1, 1), between(-1, 1), between(-1, 1)}; };
            const Corners t{at, near_at(), near_at()};
            const Vec3 step = lattice.step, first = at - lattice.origin;
            const auto index = [](double v) { return base::clipped<std::int32_t>(v, 0, 1000); };
            const Place cell{index(first.x / step.x), index(first.y / step.y), index(first.z / step.z)};
            exact.prepare({cell});
            const auto near = exact.about(cell, at, 2 * size + 4 * allowed);
            if (!near || exact.is_material(*near, (1.0 / 3) * (t[0] + t[1] + t[2])) ||
                !exact.is_beside_material(*near, t, allowed, most_beside_parts))
                continue;
            ++proved;
            for (int k = 0; k < 10; ++k) {
                double u = between(0, 1), v = between(0, 1);
                if (u + v > 1) u = 1 - u, v = 1 - v;
                const Vec3 p = t[0] + u * (t[1] - t[0]) + v * (t[2] - t[0]);
                if (exact.is_material(*near, p)) continue;
                ++in_air;
                ASSERT_TRUE(has_material(exact, *near, p, 1.3 * allowed, random))
                    << p.x << ' ' << p.y << ' ' << p.z << " world " << world;
            }
        }
    }
    EXPECT_GT(proved, 300);
    EXPECT_GT(in_air, 300);
}

}  // namespace
}  // namespace obrys::sim::milling
