/// What another program worked out in closed form, by search and by sampling (../shared/spec/oracle/surfaces): heights
/// at which tools touch meshes, blocks with their greatest gouge, finishing paths over a wave.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "base/oracle_testing.hpp"
#include "sim/certify/certify.hpp"

namespace obrys::sim::certify {
namespace {

using geom::Vec3;
using nlohmann::json;

constexpr double height = 100;  ///< mm of every tool, more than any mesh is high

std::optional<json> oracle(const std::string& name) { return base::testing::oracle("surfaces/" + name); }

mesh::Mesh mesh_of(const json& j) {
    mesh::Mesh m;
    for (const json& v : j.at("vertices")) m.vertices.push_back({v.at(0), v.at(1), v.at(2)});
    for (const json& t : j.at("triangles")) m.triangles.push_back({t.at(0), t.at(1), t.at(2)});
    return m;
}

Shape shape_of(const json& tool) {
    const std::string kind = tool.at("kind");
    const double r = tool.at("R");
    if (kind == "ball") return {{0, r, 0, r, r}, {r, r, r, height, 0}};
    if (kind == "flat") return {{r, 0, r, height, 0}};
    if (kind == "bull") {
        const double c = tool.at("rc");
        return {{r - c, c, r - c, c, c}, {r, c, r, height, 0}};
    }
    const double half = geom::radians(tool.at("half_angle"));
    if (kind == "cone") return {{0, 0, r, r / std::tan(half), 0}, {r, r / std::tan(half), r, height, 0}};
    const double b = tool.at("rb");  // taper: the ball up to where the cone touches it
    const double ring = b * std::cos(half), from = b * (1 - std::sin(half)), to = from + (r - ring) / std::tan(half);
    return {{0, b, 0, b, b}, {ring, from, r, to, 0}, {r, to, r, height, 0}};
}

TEST(CertifiedOracle, tools_touch_meshes_where_drop_cutting_says) {
    const std::optional<json> all = oracle("drop_cutter.json");
    if (!all) GTEST_SKIP() << "needs ../shared/spec/oracle/surfaces/drop_cutter.json";
    constexpr double allowed = 1e-6, beside = 1e-5, within = 1e-4;
    int touched = 0;
    for (const json& c : all->at("cases")) {
        const mesh::Distance part(mesh_of(all->at("meshes").at(c.at("mesh").get<std::string>())));
        const Judge judge(part, allowed);
        const Shape tool = shape_of(c.at("tool"));
        const auto clear = [&](Vec3 from, Vec3 to) {
            return judge.is_clear({geom::Straight{from, to}, {0, 0, 1}, &tool});
        };
        for (const json& p : c.at("points")) {
            const Vec3 at{p.at("x"), p.at("y"), 0};
            if (p.at("z").is_null()) {
                EXPECT_TRUE(clear(at + Vec3{0, 0, 40}, at - Vec3{0, 0, 40})) << c.at("mesh") << c.at("tool") << p;
                continue;
            }
            const Vec3 touch = at + Vec3{0, 0, p.at("z")}, above = touch + Vec3{0, 0, 40};
            EXPECT_TRUE(clear(above, touch + Vec3{0, 0, beside})) << c.at("mesh") << c.at("tool") << p;
            EXPECT_FALSE(clear(above, touch - Vec3{0, 0, within})) << c.at("mesh") << c.at("tool") << p;
            ++touched;
        }
    }
    EXPECT_GT(touched, 300);
}

TEST(CertifiedOracle, blocks_gouge_as_their_concave_maximum_says) {
    const std::optional<json> all = oracle("blocks.json"), meshes = oracle("drop_cutter.json");
    if (!all || !meshes) GTEST_SKIP() << "needs ../shared/spec/oracle/surfaces/blocks.json and drop_cutter.json";
    constexpr double allowed = 1e-6;
    for (const json& c : all->at("cases")) {
        const mesh::Distance part(mesh_of(meshes->at("meshes").at(c.at("mesh").get<std::string>())));
        const Judge judge(part, allowed);
        const Shape tool = shape_of(c.at("tool"));
        const auto point = [](const json& p) { return Vec3{p.at(0), p.at(1), p.at(2)}; };
        for (const double more : {-1e-4, 1e-5}) {
            const Vec3 lift{0, 0, c.at("gouge").get<double>() + more};
            const geom::Straight way{point(c.at("from")) + lift, point(c.at("to")) + lift};
            EXPECT_EQ(judge.is_clear({way, {0, 0, 1}, &tool}), more > 0) << c << more;
        }
    }
}

/// The wave as a body, in strips along y.
mesh::Mesh wave() {
    constexpr double strip = 0.02;  // chords leave a radius of 8.73 by 6e-6
    constexpr double far = 27, side = 8, floor = -20;
    mesh::Mesh m;
    const auto n = static_cast<std::uint32_t>(std::lround(2 * far / strip));
    for (std::uint32_t i = 0; i <= n; ++i) {
        const double x = -far + strip * i, z = 5 * std::cos(2 * geom::pi * x / 41.5);
        for (const auto& [y, h] : {std::pair{-side, floor}, {side, floor}, {side, z}, {-side, z}})
            m.vertices.push_back({x, y, h});
    }
    const auto quad = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
        m.triangles.push_back({a, b, c});
        m.triangles.push_back({a, c, d});
    };
    for (std::uint32_t i = 0; i < n; ++i)
        for (std::uint32_t k = 0; k < 4; ++k) {
            const std::uint32_t a = 4 * i + k, b = 4 * i + (k + 1) % 4;
            quad(a, a + 4, b + 4, b);
        }
    quad(0, 1, 2, 3);
    quad(4 * n + 3, 4 * n + 2, 4 * n + 1, 4 * n);
    if (mesh::volume(m) < 0) mesh::turn_over(m);
    return m;
}

TEST(CertifiedOracle, finishing_paths_over_a_wave_gouge_as_much_as_they_do) {
    const std::optional<json> all = oracle("certify.json");
    if (!all) GTEST_SKIP() << "needs ../shared/spec/oracle/surfaces/certify.json";
    const mesh::Distance part(wave());
    const double r = all->at("R");
    const Shape tool{{0, r, 0, r, r}, {r, r, r, height, 0}};
    for (const json& c : all->at("cases")) {
        const double gouge = c.at("gouge_max"), sampled = 2e-6, meshed = 6e-6;
        const Judge at_most(part, gouge + 2 * (sampled + meshed)), at_least(part, gouge - 2 * (sampled + meshed));
        const json& path = c.at("centre_path_xz");
        double deepest = 0;
        for (std::size_t i = 0; i + 1 < path.size(); ++i) {
            const auto tip = [&](const json& p) { return Vec3{p.at(0), 0, p.at(1).get<double>() - r}; };
            const Move move{geom::Straight{tip(path[i]), tip(path[i + 1])}, {0, 0, 1}, &tool};
            EXPECT_TRUE(at_most.is_clear(move)) << c.at("chord_tolerance") << " block " << i;
            if (at_least.is_clear(move)) continue;
            if (const auto d = at_least.deepest(move)) deepest = std::max(deepest, d->depth);
        }
        EXPECT_NEAR(deepest, gouge, gouge / 10) << c.at("chord_tolerance");
    }
}

}  // namespace
}  // namespace obrys::sim::certify
