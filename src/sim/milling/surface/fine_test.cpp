#include <gtest/gtest.h>

#include <atomic>
#include <random>

#include "base/parallel.hpp"
#include "mesh/distance.hpp"
#include "mesh/primitives.hpp"
#include "mesh/topology.hpp"
#include "sim/milling/exact/exact.hpp"
#include "sim/milling/fine_testing.hpp"
#include "sim/milling/surface/surface.hpp"

namespace obrys::sim::milling {
namespace {

using geom::Vec3;
using testing::Move;
using testing::Reference;
using testing::RoundTool;

struct BothWays {
    double mesh = 0;   ///< of points of triangles from the exact surface, at least
    double exact = 0;  ///< of exact points from the mesh
    Vec3 mesh_at, exact_at;
};

Simulation simulate(const Reference& r, double tolerance, double smallest, int threads = 0) {
    Simulation s(r.block, *make_lattice(r.block, step_for(tolerance, smallest)), tolerance, threads);
    for (const Move& m : r.moves) {
        Pass pass;
        pass.path = geom::Straight{m.from, m.to};
        pass.tool = s.add_tool(testing::shape_of(m.tool));
        EXPECT_EQ(s.add(pass), Taken::taken);
    }
    s.flush();
    return s;
}

void expect_closed(const mesh::Mesh& m) {
    const mesh::Topology t = mesh::topology(m);
    EXPECT_EQ(t.open.count, 0U);
    EXPECT_EQ(t.crowded.count, 0U);
    EXPECT_EQ(t.turned.count, 0U);
}

BothWays both_ways(const Reference& r, const mesh::Mesh& m, std::mt19937& random, int lines) {
    BothWays d;
    std::uniform_real_distribution<double> share(0, 1);
    const auto judge = [&](Vec3 p) {
        const double off = std::abs(r.depth(p));
        if (off > d.mesh) d.mesh = off, d.mesh_at = p;
    };
    for (const Vec3& v : m.vertices) judge(v);
    for (std::size_t t = 0; t < m.triangles.size(); ++t) {
        const auto corner = [&](std::size_t c) { return m.vertices[m.triangles[t][c]]; };
        double u = share(random), v = share(random);
        if (u + v > 1) u = 1 - u, v = 1 - v;
        judge(corner(0) + u * (corner(1) - corner(0)) + v * (corner(2) - corner(0)));
        judge(mesh::centre(m, t));
    }
    const mesh::Distance distance(m);
    for (int i = 0; i < lines; ++i) {
        Vec3 p;
        for (int a = 0; a < 3; ++a)
            set_component(
                p, a,
                component(r.block.min, a) + share(random) * (component(r.block.max, a) - component(r.block.min, a)));
        const int axis = i % 3;
        for (const double at : r.ends(p, axis)) {
            set_component(p, axis, at);
            const double off = distance.nearest(p).distance;
            if (off > d.exact) d.exact = off, d.exact_at = p;
        }
    }
    return d;
}

TEST(Fine, a_stock_whose_mesh_crosses_itself_ends_within_the_lattice) {
    // A block of which one upper corner lies below its lower face: beyond it all seems to be within.
    const MeshStock stock{{{39.515, -20.628, -33.905},
                           {-16.943, 26.275, -33.905},
                           {25.145, 36.805, -33.905},
                           {-2.573, -31.158, -33.905},
                           {29.585, -23.112, -3.22},
                           {25.624, 36.925, -35.384},
                           {-29.664, 23.092, 3.275},
                           {-26.487, -37.141, 35.988}},
                          {{0, 1, 2},
                           {0, 3, 1},
                           {4, 5, 6},
                           {4, 6, 7},
                           {0, 2, 5},
                           {0, 5, 4},
                           {2, 1, 6},
                           {2, 6, 5},
                           {1, 3, 7},
                           {1, 7, 6},
                           {3, 0, 4},
                           {3, 4, 7}}};
    constexpr double tolerance = 0.05;
    Simulation s(stock, *make_lattice(box_of(stock), step_for(tolerance, 1)), tolerance);
    Pass pass;
    pass.path = geom::Straight{{7.4, 33.7, -23}, {2.1, 32.4, -19.3}};
    pass.tool = s.add_tool(testing::shape_of({RoundTool::Kind::ball, 1}));
    EXPECT_EQ(s.add(pass), Taken::taken);
    s.flush();
    std::atomic<int> asked = 0;  // what follows takes long, as nothing of it can be right
    const Surface found = extract_surface(s, [&] { return ++asked > 4; });
    EXPECT_GT(mesh::bounds(found.mesh).lo.z, -35.384 - 4 * s.dexels().lattice().step.z);
}

// Nodes stand in a wall of the stock that is thinner than the margin by which lines are looked at beyond these.
TEST(Fine, a_wall_of_the_stock_thinner_than_the_tolerance_takes_no_time) {
    constexpr double tolerance = 0.002, half = 0.0003;
    mesh::Mesh wall = mesh::box({-half, -2, 0}, {half, 2, 3});
    const MeshStock stock{wall.vertices, {wall.triangles.begin(), wall.triangles.end()}};
    Lattice lattice = *make_lattice({{-1, -2.1, -0.1}, {1, 2.1, 3.1}}, 0.125);
    lattice.origin.x = -9 * lattice.step.x;
    Simulation s(stock, lattice, tolerance);
    Pass pass;
    pass.path = geom::Straight{{-4, -0.7, 0.5553}, {4, 0.6, 0.5553}};
    RoundTool t;
    t.kind = RoundTool::Kind::cone;
    t.half_angle = geom::radians(10);
    pass.tool = s.add_tool(testing::shape_of(t));
    EXPECT_EQ(s.add(pass), Taken::taken);
    s.flush();
    const Surface surface = extract_surface(s);
    expect_closed(surface.mesh);
    EXPECT_EQ(surface.refined.open.size(), 0U);
    EXPECT_LT(surface.refined.cells, 100U);
    EXPECT_GT(mesh::volume(surface.mesh), 0.8 * 4 * 3 * 2 * half);
}

TEST(Fine, a_fin_thinner_than_the_lattice_stays) {
    for (const double thick : {0.1, 0.03}) {
        for (const auto& [tolerance, y] :
             {std::pair{0.01, 7.0}, {0.01, 7.17}, {0.05, 7.0}, {0.05, 7.21}, {0.05, 7.43}}) {
            if (thick < tolerance) continue;
            RoundTool t;
            t.radius = 3;
            Reference r{{{0, 0, 0}, {10, 14, 6}}, {}};
            r.moves.push_back({t, {-5, y - 3 - thick / 2, 3}, {15, y - 3 - thick / 2, 3}});
            r.moves.push_back({t, {-5, y + 3 + thick / 2, 3}, {15, y + 3 + thick / 2, 3}});
            const Simulation s = simulate(r, tolerance, 3);
            const Surface surface = extract_surface(s);
            expect_closed(surface.mesh);
            EXPECT_EQ(surface.refined.open.size(), 0U);
            std::mt19937 random(1);
            const BothWays d = both_ways(r, surface.mesh, random, 300);
            EXPECT_LE(d.mesh, tolerance);
            EXPECT_LE(d.exact, tolerance);
            EXPECT_NEAR(mesh::volume(surface.mesh), 10 * 14 * 6 - 2 * 10 * 6 * 3, 10 * 3 * tolerance);
        }
    }
}

TEST(Fine, a_web_below_a_drill_stays) {
    RoundTool t;
    t.kind = RoundTool::Kind::flat;
    Reference r{{{0, 0, 0}, {12, 12, 8}}, {}};
    r.moves.push_back({t, {6, 6, 10}, {6, 6, 4.05}});
    r.moves.push_back({t, {6, 6, -41}, {6, 6, -36.05}});  // from below: its upper end is 3.95
    const double tolerance = 0.04;
    const Simulation s = simulate(r, tolerance, 3);
    const Surface surface = extract_surface(s);
    expect_closed(surface.mesh);
    EXPECT_EQ(surface.refined.open.size(), 0U);
    EXPECT_NEAR(mesh::volume(surface.mesh), 12 * 12 * 8 - geom::pi * 9 * 7.9, geom::pi * 9 * tolerance);
    std::mt19937 random(2);
    const BothWays d = both_ways(r, surface.mesh, random, 300);
    EXPECT_LE(d.mesh, tolerance);
    EXPECT_LE(d.exact, tolerance);
}

TEST(Fine, a_scratch_of_a_point_between_rays_is_in_the_surface) {
    for (const double half : {15.0, 45.0}) {
        RoundTool t;
        t.kind = RoundTool::Kind::cone;
        t.half_angle = geom::radians(half);
        Reference r{{{0, 0, 0}, {10, 10, 5}}, {}};
        r.moves.push_back({t, {2, 2.3, 4.9}, {8, 7.1, 4.9}});
        r.moves.push_back({t, {8, 2, 6}, {8, 2, 4.92}});
        const Simulation s = simulate(r, 0.01, 3);
        const Surface surface = extract_surface(s);
        expect_closed(surface.mesh);
        EXPECT_EQ(surface.refined.open.size(), 0U);
        const mesh::Distance distance(surface.mesh);
        for (const Vec3 p : {Vec3{2, 2.3, 4.9}, Vec3{5, 4.7, 4.9}, Vec3{6.5, 5.9, 4.9}, Vec3{8, 2, 4.92}})
            // Above its very point a cone is narrower than the tolerance.
            EXPECT_LE(distance.nearest(p).distance, std::max(0.01, 0.005 / std::tan(t.half_angle))) << half << p.x;
        std::mt19937 random(3);
        const BothWays d = both_ways(r, surface.mesh, random, 300);
        EXPECT_LE(d.mesh, 0.01);
        EXPECT_LE(d.exact, std::max(0.01, 0.005 / std::tan(t.half_angle)));
    }
}

TEST(Fine, what_lies_by_a_quad_is_known_as_far_as_the_quad_reaches) {
    RoundTool t;
    t.radius = 1;
    Reference r{{{0, 0, 0}, {10, 10, 5}}, {{t, {7, 7, 4}, {7, 7.5, 4}}}};
    const Simulation s = simulate(r, 0.01, 1);
    const Lattice& lattice = s.dexels().lattice();
    Exact exact(s, lattice);
    const double step = lattice.step.x;
    const Place cell = *cell_at(lattice, {6 - 1.5 * step, 7.2, 4.5});
    exact.prepare({cell});
    const Vec3 middle = lattice.node(cell[0], cell[1], cell[2]) + 0.5 * lattice.step;
    const Vec3 corner{6, 7.2, 4.5};
    const auto about = exact.about(cell, 0.5 * (corner + middle), geom::distance(corner, middle));
    ASSERT_TRUE(about.has_value());
    EXPECT_EQ(about->sweeps.size(), 1U);
    EXPECT_FALSE(exact.about(cell, middle + Vec3{20 * step, 0, 0}, step).has_value());
    EXPECT_FALSE(exact.about(cell, middle, 20 * step).has_value());
}

TEST(Fine, does_not_depend_on_threads) {
    RoundTool t;
    t.kind = RoundTool::Kind::bull;
    t.radius = 2;
    Reference r{{{0, 0, 0}, {6, 8, 4}}, {}};
    r.moves.push_back({t, {1, 2, 3}, {5, 3.3, 2.2}});
    t.kind = RoundTool::Kind::flat;
    r.moves.push_back({t, {1, 6.2, 3}, {5, 7.3, 3}});
    mesh::Mesh one, other;
    for (const int threads : {1, 4}) {
        base::with_threads(
            threads, [&] { (threads == 1 ? one : other) = extract_surface(simulate(r, 0.01, 0.5, threads)).mesh; });
    }
    EXPECT_EQ(one.vertices, other.vertices);
    EXPECT_EQ(one.triangles, other.triangles);
    EXPECT_EQ(one.tags, other.tags);
}

TEST(Fine, random_programs_are_within_the_tolerance) {
    constexpr unsigned first = 1, count = 12;
    for (unsigned seed = first; seed < first + count; ++seed) {
        std::mt19937 random(seed);
        const auto in = [&](double low, double high) {
            return std::uniform_real_distribution<double>(low, high)(random);
        };
        Reference r{{{0, 0, 0}, {10, 10, 5}}, {}};
        const double tolerance = in(0, 1) < 0.5 ? 0.01 : 0.02;
        double smallest = 10;
        const int moves = 1 + static_cast<int>(in(0, 5));
        Vec3 at{in(-1, 11), in(-1, 11), in(1, 4.5)};
        RoundTool t;
        for (int i = 0; i < moves; ++i) {
            if (i == 0 || in(0, 1) < 0.4) {
                const int kind = static_cast<int>(in(0, 4));
                t.kind = static_cast<RoundTool::Kind>(kind);
                t.radius = in(1, 4);
                t.corner = in(0.1, 0.9) * t.radius;
                t.half_angle = geom::radians(in(15, 60));
            }
            smallest = std::min(smallest, t.kind == RoundTool::Kind::bull ? t.corner : t.radius);
            Vec3 to{in(-1, 11), in(-1, 11), in(0, 1) < 0.5 ? at.z : in(0.5, 4.9)};
            if (in(0, 1) < 0.15) to.x = at.x, to.y = at.y, to.z = in(0.5, 4.9);
            r.moves.push_back({t, at, to});
            at = to;
        }
        const Simulation s = simulate(r, tolerance, std::max(smallest, 0.5));
        const Surface surface = extract_surface(s);
        expect_closed(surface.mesh);
        const BothWays d = both_ways(r, surface.mesh, random, 600);
        EXPECT_EQ(surface.refined.open.size(), 0U) << "seed " << seed;
        EXPECT_LE(d.mesh, tolerance) << "seed " << seed << " at " << d.mesh_at.x << " " << d.mesh_at.y << " "
                                     << d.mesh_at.z;
        EXPECT_LE(d.exact, tolerance) << "seed " << seed << " at " << d.exact_at.x << " " << d.exact_at.y << " "
                                      << d.exact_at.z;
    }
}

}  // namespace
}  // namespace obrys::sim::milling
