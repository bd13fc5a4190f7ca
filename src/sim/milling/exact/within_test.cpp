#include "sim/milling/exact/within.hpp"

#include <gtest/gtest.h>

#include <random>

#include "base/seed_testing.hpp"
#include "sim/milling/fine_testing.hpp"

namespace obrys::sim::milling {
namespace {

using geom::Vec3;

const Box3 within_block{{0, 0, 0}, {12, 12, 6}};
constexpr double within_allowed = 0.01;

Simulation within_blank() { return Simulation(within_block, *make_lattice(within_block, 0.25), 0.01); }

/// Cuts of round tools, a slanting one and a quarter of a circle among them.
void cut_some(Simulation& s, std::mt19937& random, int count) {
    const auto in = [&](double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); };
    using Kind = testing::RoundTool::Kind;
    for (int i = 0; i < count; ++i) {
        testing::RoundTool t;
        t.kind = std::array{Kind::flat, Kind::ball, Kind::bull, Kind::cone}[static_cast<std::size_t>(i) % 4];
        t.radius = in(1, 3);
        const std::uint32_t tool = s.add_tool(testing::shape_of(t));
        const Vec3 from{in(0, 12), in(0, 12), in(2, 5)};
        Pass pass;
        pass.tool = tool;
        if (i % 3 == 2)
            pass.path = geom::Circular{from, from + Vec3{-3, 3, 0}, from + Vec3{-3, 0, 0}, {0, 0, 1}, geom::pi / 2};
        else
            pass.path = geom::Straight{from, {in(0, 12), in(0, 12), i % 2 == 0 ? from.z : in(2, 5)}};
        static_cast<void>(s.add(pass));
    }
    s.flush();
}

mesh::Mesh triangle_of(Vec3 a, Vec3 b, Vec3 c) {
    mesh::Mesh mesh;
    mesh.vertices = {a, b, c};
    mesh.triangles = {{0, 1, 2}};
    mesh.tags = {0};
    return mesh;
}

/// How deep a point lies in the material.
double depth_at(const Air& air, Vec3 p) {
    double least = INFINITY;
    for (std::size_t body = 0; body < air.bodies(); ++body) least = std::min(least, air.outside(body, p));
    return least;
}

}  // namespace

TEST(WithinMaterial, WhatIsSaidToBeRightIsNowhereDeeper) {
    const std::uint32_t seed = base::testing_seed();
    std::mt19937 random(seed);
    const auto in = [&](double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); };
    int right = 0, wrong = 0;
    for (int scene = 0; scene < 8; ++scene) {
        Simulation s = within_blank();
        cut_some(s, random, 6);
        const Air air = s.air_in({{-1, -1, -1}, {13, 13, 7}});
        Exact exact(s, s.dexels().lattice());
        for (int n = 0; n < 4000 && right + wrong < 400 * (scene + 1); ++n) {
            // Corners that lie about on the surface.
            std::array<Vec3, 3> t;
            t[0] = {in(0, 12), in(0, 12), in(1, 6)};
            if (std::abs(depth_at(air, t[0])) > 0.012) continue;
            for (std::size_t k = 1; k < 3; ++k)
                for (int tries = 0; tries < 300; ++tries) {
                    t[k] = t[0] + Vec3{in(-0.2, 0.2), in(-0.2, 0.2), in(-0.2, 0.2)};
                    if (std::abs(depth_at(air, t[k])) < 0.012) break;
                }
            const mesh::Mesh mesh = triangle_of(t[0], t[1], t[2]);
            const std::vector<WithinMaterial::Deep> found = WithinMaterial(exact).places(mesh, within_allowed, 150);
            (found.empty() ? right : wrong) += 1;
            double deepest = -INFINITY;
            for (int i = 0; i <= 20; ++i)
                for (int k = 0; i + k <= 20; ++k)
                    deepest = std::max(deepest,
                                       depth_at(air, t[0] + (0.05 * i) * (t[1] - t[0]) + (0.05 * k) * (t[2] - t[0])));
            if (found.empty())
                EXPECT_LE(deepest, 1.04 * within_allowed) << "seed " << seed;
            else
                EXPECT_GT(deepest, 0.8 * within_allowed) << "seed " << seed;
        }
    }
    EXPECT_GT(right, 100);
    EXPECT_GT(wrong, 60);
}

// Two strips of a floor meet at a small angle; between them a ridge begins, lower than a cell.
TEST(WithinMaterial, AFlatTriangleOverARidgeIsFound) {
    Simulation s = within_blank();
    testing::RoundTool t;
    t.kind = testing::RoundTool::Kind::cone;
    const std::uint32_t tool = s.add_tool(testing::shape_of(t));
    for (const double y : {5.95, 6.05}) {
        Pass pass;
        pass.path = geom::Straight{{-3, y, 4}, {15, y, 4}};
        pass.tool = tool;
        static_cast<void>(s.add(pass));
    }
    s.flush();
    Exact exact(s, s.dexels().lattice());
    // The ridge at y 6 is 0.05 high, its sides slope by 45 degrees.
    const Air air = s.air_in({{-1, -1, -1}, {13, 13, 7}});
    EXPECT_NEAR(depth_at(air, {5, 6, 4}), 0.05 / std::sqrt(2), 1e-6);
    const auto across = [&](double z) { return triangle_of({5, 5.95, z}, {5, 6.05, z}, {5.2, 6.0, z}); };
    EXPECT_EQ(WithinMaterial(exact).places(across(4.0), within_allowed, 150).size(), 1U);
    EXPECT_EQ(WithinMaterial(exact).places(across(4.046), within_allowed, 150).size(), 0U);
}

}  // namespace obrys::sim::milling
