#include <gtest/gtest.h>

#include <random>

#include "mesh/distance.hpp"
#include "mesh/topology.hpp"
#include "sim/milling/fine_testing.hpp"
#include "sim/milling/nearest.hpp"
#include "sim/milling/surface/surface.hpp"
#include "sim/milling/surface/unseen.hpp"

namespace obrys::sim::milling {
namespace {

using geom::Vec3;

constexpr double unseen_tolerance = 0.01;
const Box3 unseen_block{{0, 0, 0}, {12, 12, 6}};

Simulation blank() {
    return Simulation(unseen_block, *make_lattice(unseen_block, step_for(unseen_tolerance, 3)), unseen_tolerance);
}

void cut(Simulation& s, std::uint32_t tool, Vec3 from, Vec3 to) {
    Pass pass;
    pass.path = geom::Straight{from, to};
    pass.tool = tool;
    EXPECT_EQ(s.add(pass), Taken::taken);
}

Surface surface_of(Simulation& s) {
    s.flush();
    Surface surface = extract_surface(s);
    const mesh::Topology t = mesh::topology(surface.mesh);
    EXPECT_EQ(t.open.count, 0U);
    EXPECT_EQ(t.crowded.count, 0U);
    EXPECT_EQ(t.turned.count, 0U);
    EXPECT_EQ(surface.refined.open.size(), 0U);
    return surface;
}

// Three slots leave a column of three sides between all rays.
TEST(Unseen, a_needle_between_all_rays_is_in_the_surface) {
    std::mt19937 random(1);
    const auto in = [&](double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); };
    for (int i = 0; i < 6; ++i) {
        const double thick = in(0.02, 0.04), turn = in(0, 2);
        const Vec3 c{in(5.5, 6.5), in(5.5, 6.5), 0};
        Simulation s = blank();
        testing::RoundTool t;
        const std::uint32_t tool = s.add_tool(testing::shape_of(t));
        std::vector<Vec3> corners;
        for (int k = 0; k < 3; ++k) {
            const double a = turn + 2 * geom::pi / 3 * k;
            const Vec3 n{std::cos(a), std::sin(a), 0}, along{-n.y, n.x, 0};
            const Vec3 beside = c + (3 + thick) * n + Vec3{0, 0, 3};
            cut(s, tool, beside - 20.0 * along, beside + 20.0 * along);
            corners.push_back(c - (2 * thick) * n);
        }
        const Surface surface = surface_of(s);
        const mesh::Distance distance(surface.mesh);
        for (Vec3 p : corners)
            for (const double z : {3.5, 4.7, 6.0}) {
                p.z = z;
                EXPECT_LE(distance.nearest(p).distance, unseen_tolerance) << i << " thick " << thick << " at " << z;
            }
    }
}

// A disc with a sharp rim comes a little into a wall from the side.
TEST(Unseen, the_groove_of_a_sharp_rim_is_in_the_surface) {
    std::mt19937 random(2);
    const auto in = [&](double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); };
    for (int i = 0; i < 6; ++i) {
        const double deep = in(0.03, 0.1), z = in(2, 4), y = in(5, 7);
        Simulation s = blank();
        ToolShape disc;
        disc.cutting = make_shape({cone(0, 0.5, 2.5, 3), cone(0.5, 1, 3, 2.5), cylinder(1, 20, 1)});
        const Vec3 at{deep - 3, y, z - 0.5};
        cut(s, s.add_tool(disc), at + Vec3{0, 0, 20}, at);
        cut(s, s.add_tool(disc), at, at + Vec3{-2, 0, 0});
        const Surface surface = surface_of(s);
        EXPECT_LE(mesh::Distance(surface.mesh).nearest({deep, y, z}).distance, unseen_tolerance)
            << i << " deep " << deep;
    }
}

// Faces of a wedge of 20 degrees meet far beyond the last cell that both pass through.
TEST(Unseen, the_tip_of_a_sharp_edge_is_in_the_surface) {
    std::mt19937 random(3);
    const auto in = [&](double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); };
    for (int i = 0; i < 6; ++i) {
        const double half = geom::radians(10), turn = in(0, 2), tip = 4.5 + in(0, 1);
        Simulation s = blank();
        testing::RoundTool t;
        t.kind = testing::RoundTool::Kind::cone;
        t.half_angle = half;
        t.radius = 1.2;
        const std::uint32_t tool = s.add_tool(testing::shape_of(t));
        const Vec3 n{std::cos(turn), std::sin(turn), 0}, along{-n.y, n.x, 0}, c{6, 6, 1};
        // Two grooves whose flanks meet above between them.
        const double beside = (tip - 1) * std::tan(half);
        for (const double side : {-beside, beside})
            cut(s, tool, c + side * n - 20.0 * along, c + side * n + 20.0 * along);
        const Surface surface = surface_of(s);
        const mesh::Distance distance(surface.mesh);
        for (const double way : {-2.0, -0.7, 0.0, 0.61, 2.3}) {
            Vec3 p = c + way * along;
            p.z = tip;
            EXPECT_LE(distance.nearest(p).distance, unseen_tolerance) << i << " tip " << tip << " at " << way;
        }
    }
}

// Where one piece of a tool lies upon another, both end: taken for a face of the tool, that disc makes edges in the
// air.
TEST(Unseen, pieces_of_a_tool_have_no_face_between_them) {
    const std::vector<Piece> point{cone(0, 2, 0, 2), cylinder(2, 9, 2)}, dovetail{cone(0, 2, 3, 2), cylinder(2, 9, 2)},
        double_angle{cone(0, 2, 1, 3), cone(2, 4, 3, 1)}, step{cylinder(0, 2, 1.5), cylinder(2, 9, 3)};
    for (const std::vector<Piece>& pieces : {point, dovetail, double_angle, step}) {
        const Shape shape = make_shape(pieces);
        Track level, ramp;
        level.v = {5, 1, 0}, ramp.v = {5, 1, -1e-3};
        for (const Track& track : {level, ramp})
            for (const double along : {0.0, 0.4, 1.0})
                for (const double aside : {-1.0, 0.0, 0.9}) {
                    const Vec3 p = along * track.v + Vec3{-0.2 * aside, aside, 2};
                    const Foot foot = foot_on(shape, track, p);
                    EXPECT_LT(foot.outside, -0.3) << aside;
                    EXPECT_GE(foot.outside, -3);
                }
    }
    Simulation s = blank();
    testing::RoundTool t;
    t.kind = testing::RoundTool::Kind::cone;
    t.radius = 1.4;
    const std::uint32_t tool = s.add_tool(testing::shape_of(t));
    for (const double x : {5.0, 6.1})
        for (const double y : {3.0, 7.0}) cut(s, tool, {x, y, 2}, {y, x, 2});  // cylinders from 3.4 on
    surface_of(s);
}

/// Edges that are found in the group of cells about a place.
Edges edges_about(Simulation& s, Vec3 p) {
    s.flush();
    Exact exact(s, s.dexels().lattice());
    return edges_in({*cell_at(s.dexels().lattice(), p)}, exact, unseen_tolerance, 4, false);
}

// Where more faces meet than can be looked at pair by pair, that is said.
TEST(Unseen, too_many_faces_about_a_place_are_told) {
    for (const int sides : {8, 96}) {
        Simulation s = blank();
        testing::RoundTool t;
        const std::uint32_t tool = s.add_tool(testing::shape_of(t));
        const Vec3 c{6.03, 6.02, 0};
        for (int k = 0; k < sides; ++k) {
            const double a = 2 * geom::pi * k / sides;
            const Vec3 n{std::cos(a), std::sin(a), 0}, along{-n.y, n.x, 0};
            const Vec3 beside = c + (t.radius + 0.004) * n + Vec3{0, 0, 1};
            cut(s, tool, beside - 20.0 * along, beside + 20.0 * along);
        }
        const Edges found = edges_about(s, c + Vec3{0, 0, 3});
        EXPECT_FALSE(found.places.empty());
        EXPECT_EQ(found.unjudged.empty(), sides == 8) << found.unjudged.size();
    }
}

// A scratch of a sharp point is narrower than cells as small as the tolerance: its bottom is held to all along.
TEST(Unseen, the_bottom_of_a_shallow_scratch_is_in_the_surface_all_along) {
    for (const double deep : {0.0111, 0.0206, 0.05}) {
        Simulation s = blank();
        testing::RoundTool t;
        t.kind = testing::RoundTool::Kind::cone;
        t.half_angle = geom::radians(10);
        const std::uint32_t tool = s.add_tool(testing::shape_of(t));
        const Vec3 from{2.03, 3.17, 6 - deep}, to{9.41, 8.77, 6 - deep};
        cut(s, tool, from + Vec3{0, 0, 5}, from);
        cut(s, tool, from, to);
        const Surface surface = surface_of(s);
        EXPECT_EQ(surface.refined.filled.size(), 0U);
        const mesh::Distance distance(surface.mesh);
        double worst = 0;
        constexpr int places = 20'000;
        for (int i = 0; i <= places; ++i)
            worst = std::max(worst, distance.nearest(from + (double(i) / places) * (to - from)).distance);
        EXPECT_LE(worst, unseen_tolerance) << deep;
    }
}

// What is asked for but not done is not done by half: the mesh is closed, only coarser.
TEST(Unseen, a_surface_that_is_told_to_stop_is_closed) {
    Simulation s = blank();
    testing::RoundTool t;
    t.kind = testing::RoundTool::Kind::cone;
    const std::uint32_t tool = s.add_tool(testing::shape_of(t));
    cut(s, tool, {-3, 5.3, 5.1}, {15, 6.1, 5.1});
    s.flush();
    EXPECT_GT(extract_surface(s).refined.cells, 0U);
    for (int after = 0; after < 12; ++after) {
        int asked = 0;
        const Surface surface = extract_surface(s, [&] { return ++asked > after; });
        const mesh::Topology topology = mesh::topology(surface.mesh);
        EXPECT_EQ(topology.open.count, 0U) << after;
        EXPECT_GT(surface.mesh.triangles.size(), 1000U);
    }
}

}  // namespace
}  // namespace obrys::sim::milling
