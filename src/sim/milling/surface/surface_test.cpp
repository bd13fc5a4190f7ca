#include "sim/milling/surface/surface.hpp"
#include "base/parallel.hpp"

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <set>

#include "mesh/distance.hpp"
#include "mesh/merge_flat.hpp"
#include "mesh/topology.hpp"
#include "sim/milling/cut/milling_testing.hpp"
#include "sim/milling/surface/solids_testing.hpp"

namespace obrys::sim::milling {
namespace {

using namespace testing;
using geom::Frame;

/// Largest distance of vertices and of triangle centres from a surface.
struct Deviation {
    double vertex = 0, centre = 0;
};

Deviation deviation(const mesh::Mesh& m, const std::function<double(Vec3)>& distance) {
    Deviation d;
    for (const Vec3& v : m.vertices) d.vertex = std::max(d.vertex, std::abs(distance(v)));
    for (std::size_t i = 0; i < m.triangles.size(); ++i)
        d.centre = std::max(d.centre, std::abs(distance(mesh::centre(m, i))));
    return d;
}

void expect_sound(const Surface& s) {
    ASSERT_FALSE(s.mesh.empty());
    const mesh::Topology t = mesh::topology(s.mesh);
    EXPECT_EQ(t.open.count, 0U);
    EXPECT_EQ(t.crowded.count, 0U);
    EXPECT_EQ(t.turned.count, 0U);
    EXPECT_EQ(s.unmatched, 0U);
    EXPECT_GT(mesh::volume(s.mesh), 0);
    EXPECT_EQ(s.mesh.tags.size(), s.mesh.triangles.size());
}

/// Signed distance to a box about the origin.
double box_distance(Vec3 p, Vec3 half) {
    const Vec3 q{std::abs(p.x) - half.x, std::abs(p.y) - half.y, std::abs(p.z) - half.z};
    const Vec3 out{std::max(q.x, 0.0), std::max(q.y, 0.0), std::max(q.z, 0.0)};
    return length(out) + std::min(std::max({q.x, q.y, q.z}), 0.0);
}

TEST(SurfaceOf, a_ball_lies_within_the_sagitta) {
    const double r = 3;
    for (const double step : {0.5, 0.25, 0.1}) {
        Faces faces;
        const Vec3 c{0.123, -0.456, 0.789};
        const Sampled s(around({-3, -4, -3}, {4, 3, 4}, step), faces.ball(c, r));
        const Surface surface = s.surface(faces);
        expect_sound(surface);
        const double sagitta = 3 * step * step / 8 / r;  // of a chord as long as a cell's diagonal
        const Deviation d = deviation(surface.mesh, [&](Vec3 p) { return distance(p, c) - r; });
        EXPECT_LE(d.vertex, sagitta) << step;
        EXPECT_LE(d.centre, sagitta) << step;
        EXPECT_NEAR(mesh::volume(surface.mesh), 4.0 / 3 * geom::pi * 27, 4 * geom::pi * 9 * sagitta / 2) << step;
        for (const std::uint32_t tag : surface.mesh.tags) ASSERT_EQ(tag, 1U);
    }
}

TEST(SurfaceOf, a_box_along_the_axes_is_exact) {
    for (const double shift : {0.0, 0.05, 0.1}) {  // 0.1: faces on nodes
        Faces faces;
        const Vec3 half{2, 1.5, 1}, c{shift, shift, shift};
        const Sampled s(around({-2.4, -2, -1.5}, {2.4, 2, 1.5}, 0.2), faces.box(c, half));
        const Surface surface = s.surface(faces);
        expect_sound(surface);
        const Deviation d = deviation(surface.mesh, [&](Vec3 p) { return box_distance(p - c, half); });
        EXPECT_LT(d.vertex, 1e-6) << shift;
        EXPECT_LT(d.centre, 1e-6) << shift;
        EXPECT_NEAR(mesh::volume(surface.mesh), 24, 1e-5) << shift;
        EXPECT_NEAR(mesh::area(surface.mesh), 2 * (12 + 8 + 6), 1e-5) << shift;
    }
}

TEST(SurfaceOf, a_turned_box_keeps_its_edges) {
    const Vec3 half{2, 1.5, 1};
    std::mt19937 random(5);
    std::uniform_real_distribution<double> angle(-3, 3);
    for (int n = 0; n < 20; ++n) {
        const Frame turn =
            Frame::rotation(0, angle(random)) * Frame::rotation(1, angle(random)) * Frame::rotation(2, angle(random));
        Faces faces;
        const Sampled s(around({-3, -3, -3}, {3, 3, 3}, 0.15), faces.box({0.01, 0.02, 0.03}, half, turn));
        const Surface surface = s.surface(faces);
        expect_sound(surface);
        const auto dist = [&](Vec3 p) { return box_distance(apply(inverse(turn), p - Vec3{0.01, 0.02, 0.03}), half); };
        const Deviation d = deviation(surface.mesh, dist);
        EXPECT_LT(d.vertex, 1e-4) << n;
        EXPECT_LT(d.centre, 1e-4) << n;
        EXPECT_NEAR(mesh::volume(surface.mesh), 24, 1e-3) << n;
        EXPECT_NEAR(mesh::area(surface.mesh), 52, 1e-2) << n;
    }
}

TEST(SurfaceOf, bodies_that_are_cut_out_of_each_other) {
    Faces faces;
    const Solid block = faces.box({0, 0, 0}, {3, 3, 1});
    const double slant = std::sqrt(0.5);
    const Solid drilled = subtract(block, faces.rod({0.5, 0.25, 0}, {0, 0, 1}, 1.2));
    const Solid trench = subtract(drilled, faces.rod({0, -2, 1.05}, {1, 0, 0}, 0.6));
    const Solid bored = subtract(trench, faces.rod({-2, 2, 0}, {slant, 0, slant}, 0.4));
    const Surface s = Sampled(around({-3, -3, -1}, {3, 3, 1}, 0.1), bored).surface(faces);
    expect_sound(s);
    std::set<std::uint32_t> tags(s.mesh.tags.begin(), s.mesh.tags.end());
    EXPECT_EQ(tags.size(), 9U) << "six faces of the block and three bores";
    // A vertex lies on one of the faces, and none in a bore.
    const auto from_rod = [](Vec3 p, Vec3 through, Vec3 along, double r) {
        const Vec3 v = p - through;
        return length(v - dot(v, along) * along) - r;
    };
    const Deviation d = deviation(s.mesh, [&](Vec3 p) {
        double out = box_distance(p, {3, 3, 1});
        out = std::max(out, -from_rod(p, {0.5, 0.25, 0}, {0, 0, 1}, 1.2));
        out = std::max(out, -from_rod(p, {0, -2, 1.05}, {1, 0, 0}, 0.6));
        return std::max(out, -from_rod(p, {-2, 2, 0}, {slant, 0, slant}, 0.4));
    });
    EXPECT_LT(d.vertex, 0.02);
    EXPECT_LT(d.centre, 0.03);
}

TEST(SurfaceOf, an_undercut_is_there) {
    // A slot of a T-cutter: narrow above, wide below.
    Faces faces;
    const Solid block = faces.box({0, 0, 0}, {3, 3, 2});
    const Solid slot =
        subtract(subtract(block, faces.box({0, 0, 1}, {4, 0.5, 1.2})), faces.box({0, 0, -0.6}, {4, 1.5, 0.4}));
    const Surface s = Sampled(around({-3, -3, -2}, {3, 3, 2}, 0.13), slot).surface(faces);
    expect_sound(s);
    EXPECT_NEAR(mesh::volume(s.mesh), 6 * 6 * 4 - 6 * 1 * 2.2 - 6 * 3 * 0.8, 1e-4);
    EXPECT_EQ(s.thin, 0U);
}

TEST(SurfaceOf, thin_walls_and_gaps_are_left_out_and_counted) {
    Faces faces;
    const Lattice lattice = around({-2, -2, -2}, {2, 2, 2}, 0.5);  // nodes at -2.25, -1.75 …
    const Solid wall = faces.box({0, 0, 0}, {0.2, 1, 1});          // -0.2 … 0.2 lies between two nodes
    const Surface none = Sampled(lattice, wall).surface(faces);
    EXPECT_TRUE(none.mesh.empty());
    EXPECT_EQ(none.thin, 16U) << "rays along x through a square of 4 by 4 nodes";
    const Solid slit = subtract(faces.box({0, 0, 0}, {1, 1, 1}), faces.box({0, 0, 0}, {0.2, 2, 2}));
    const Surface filled = Sampled(lattice, slit).surface(faces);
    expect_sound(filled);
    EXPECT_EQ(filled.thin, 16U);
    EXPECT_NEAR(mesh::volume(filled.mesh), 8, 1e-4);
}

TEST(SurfaceOf, nothing_and_of_a_lattice_too_small_is_empty) {
    Faces faces;
    const Solid nothing = [](Vec3, int) { return std::vector<Interval>{}; };
    EXPECT_TRUE(Sampled(around({-1, -1, -1}, {1, 1, 1}, 0.3), nothing).surface(faces).mesh.empty());
    Lattice flat = around({-1, -1, -1}, {1, 1, 1}, 0.3);
    flat.count[2] = 2;
    EXPECT_TRUE(Sampled(flat, faces.ball({}, 1)).surface(faces).mesh.empty());
}

TEST(SurfaceOf, material_beyond_the_lattice_is_closed_at_its_rim) {
    Faces faces;
    const Surface s = Sampled(around({-1, -1, -1}, {1, 1, 1}, 0.3), faces.box({}, {5, 5, 5})).surface(faces);
    const mesh::Topology t = mesh::topology(s.mesh);
    EXPECT_FALSE(s.mesh.empty());
    EXPECT_TRUE(t.closed());
    EXPECT_GT(s.unmatched, 0U);
}

/// Material or air at each node by chance: every way in which cells can meet.
TEST(SurfaceOf, chance_is_a_closed_manifold) {
    for (unsigned seed = 1; seed <= 60; ++seed) {
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> chance(0, 1);
        const double share = chance(random);
        const int n = 14;
        std::array<std::array<std::array<bool, n>, n>, n> material{};
        for (auto& plane : material)
            for (auto& line : plane)
                for (bool& node : line) node = chance(random) < share;
        Lattice lattice;
        lattice.count = {n, n, n};
        const Solid solid = [&](Vec3 p, int axis) {
            std::vector<Interval> all;
            for (int at = 1; at < n - 1; ++at) {
                Vec3 q = p;
                set_component(q, axis, at);
                const auto x = static_cast<std::size_t>(q.x), y = static_cast<std::size_t>(q.y),
                           z = static_cast<std::size_t>(q.z);
                if (x == 0 || y == 0 || z == 0 || x == n - 1 || y == n - 1 || z == n - 1 || !material[x][y][z])
                    continue;
                if (!all.empty() && all.back().end > at - 1 + 0.9) {
                    all.back().end = at + 0.45;
                } else if (!all.empty() && all.back().end >= at - 0.55) {
                    all.back().end = at + 0.45;
                } else {
                    all.push_back({at - 0.45, at + 0.45, 1, 1});
                }
            }
            return all;
        };
        Faces faces;
        (void)faces.add([](Vec3) { return Vec3{0.6, 0.48, 0.64}; });
        const Surface s = Sampled(lattice, solid).surface(faces);
        if (s.mesh.empty()) continue;
        const mesh::Topology t = mesh::topology(s.mesh);
        EXPECT_EQ(t.open.count, 0U) << "seed " << seed;
        EXPECT_EQ(t.crowded.count, 0U) << "seed " << seed;
        EXPECT_EQ(t.turned.count, 0U) << "seed " << seed;
        EXPECT_EQ(s.unmatched, 0U) << "seed " << seed;
    }
}

TEST(SurfaceOf, rays_that_disagree_by_rounding_are_drawn_to_the_node) {
    // A wall on the nodes' plane, which the rays along z see or do not see by chance.
    Faces faces;
    const Solid block = faces.box({0, 0, 0}, {1, 1, 1});
    std::mt19937 random(3);
    const Lattice lattice = around({-1.05, -1.05, -1.05}, {1.05, 1.05, 1.05}, 0.1);  // nodes at -1.1, -1.0 …
    const Solid noisy = [&](Vec3 p, int axis) {
        if (std::abs(std::abs(p.x) - 1) < 1e-9 || std::abs(std::abs(p.y) - 1) < 1e-9 ||
            std::abs(std::abs(p.z) - 1) < 1e-9) {
            const double in = std::uniform_int_distribution<int>(0, 1)(random) == 0 ? 0.5 : 2;
            for (double* c : {&p.x, &p.y, &p.z})
                if (std::abs(std::abs(*c) - 1) < 1e-9) *c *= in;
        }
        std::vector<Interval> m = block(p, axis);
        for (Interval& i : m) i.begin += 1e-13, i.end -= 1e-13;
        return m;
    };
    const Surface s = Sampled(lattice, noisy).surface(faces);
    const mesh::Topology t = mesh::topology(s.mesh);
    EXPECT_TRUE(t.closed());
    const Deviation d = deviation(s.mesh, [&](Vec3 p) { return box_distance(p, {1, 1, 1}); });
    EXPECT_LT(d.vertex, 1e-5);
    EXPECT_NEAR(mesh::volume(s.mesh), 8, 12 * 2 * 0.1 * 0.1 / 2) << "edges may lose half a cell";
}

TEST(SurfaceOf, a_trench_cut_by_a_ball_is_within_the_tolerance) {
    const double tolerance = 0.01, r = 3;
    const Box3 plate{{0, 0, -5}, {20, 12, 0}};
    const Lattice lattice = make_lattice(plate, step_for(tolerance, r)).value();
    Simulation simulation(plate, lattice, tolerance, 1);
    Cutter ball;
    ball.kind = CutterKind::ball;
    ball.diameter = 2 * r;
    ball.cutting_length = 25;
    const std::uint32_t tool = simulation.add_tool(shape_of(ball).shape);
    const Vec3 from{6, 5, -1}, to{15, 7, -1.5};
    ASSERT_EQ(simulation.add({geom::Straight{from, to}, {0, 0, 1}, tool}), Taken::taken);
    simulation.flush();
    const Surface s = extract_surface(
        simulation.dexels(), [&](std::uint32_t cut, Vec3 p, int, double) { return simulation.normal_at(cut, p); });
    expect_sound(s);
    const Vec3 up{0, 0, r}, along = to - from;
    const Deviation d = deviation(s.mesh, [&](Vec3 p) {
        const double t = std::clamp(dot(p - from - up, along) / dot(along, along), 0.0, 1.0);
        return std::max(box_distance(p - Vec3{10, 6, -2.5}, {10, 6, 2.5}), r - distance(p, from + up + t * along));
    });
    EXPECT_LE(d.vertex, tolerance);
    EXPECT_LE(d.centre, tolerance);
    EXPECT_NEAR(mesh::volume(s.mesh), volume(simulation), 0.2);
    for (std::size_t i = 0; i < s.mesh.triangles.size(); ++i) {
        const Vec3 c = mesh::centre(s.mesh, i);
        if (c.z > -0.2 || c.z < -4.5 || c.x < 1 || c.x > 19 || c.y < 1 || c.y > 11) continue;
        EXPECT_EQ(s.mesh.tags[i], 1U) << "the first sweep";
    }
}

TEST(SurfaceOf, one_thread_and_four_give_the_same) {
    Faces faces;
    const Solid body = subtract(faces.box({0, 0, 0}, {3, 2, 1}, Frame::rotation(2, 0.3)), faces.ball({0.5, 0, 1}, 0.9));
    const Sampled sampled(around({-4, -4, -1.5}, {4, 4, 1.5}, 0.08), body);
    Surface a, b;
    base::with_threads(1, [&] { a = sampled.surface(faces); });
    base::with_threads(4, [&] { b = sampled.surface(faces); });
    expect_sound(a);
    EXPECT_EQ(a.mesh.vertices, b.mesh.vertices);
    EXPECT_EQ(a.mesh.triangles, b.mesh.triangles);
    EXPECT_EQ(a.mesh.tags, b.mesh.tags);
}

std::map<std::uint32_t, double> areas_by_tag(const mesh::Mesh& m) {
    std::map<std::uint32_t, double> sum;
    for (std::size_t t = 0; t < m.triangles.size(); ++t) sum[m.tag(t)] += 0.5 * length(mesh::area_vector(m, t));
    return sum;
}

/// Slots with square ends that run out of the block: nothing but planes.
TEST(SurfaceOf, planes_merges_to_a_few_triangles) {
    for (const Vec3 axis : {Vec3{0, 0, 1}, Vec3{0, 0.28, 0.96}}) {
        Work w(Box3{{0, 0, -10}, {60, 40, 0}}, 0.25, tool_of(CutterKind::end_mill, 8));
        w.axis = axis;
        w.start({-10, 13.03, -4.1});
        w.to({70, 13.03, -4.1});
        w.start({-10, 28.07, -3.2});
        w.to({70, 28.07, -3.2});
        w.simulation.flush();
        const auto normal = [&](std::uint32_t cut, Vec3 p, int, double) { return w.simulation.normal_at(cut, p); };
        mesh::Mesh fine = extract_surface(w.simulation.dexels(), normal).mesh;
        const mesh::Mesh tagged = mesh::merge_flat(fine, 0.0005);
        const auto before = areas_by_tag(fine), after = areas_by_tag(tagged);
        ASSERT_EQ(before.size(), 3U);
        for (const auto& [tag, area] : before) EXPECT_NEAR(after.at(tag) / area, 1, 1e-9) << tag;
        fine.tags.clear();
        const mesh::Mesh plain = mesh::merge_flat(fine, 0.0005);
        for (const mesh::Mesh& m : {tagged, plain}) {
            EXPECT_GT(fine.triangles.size(), 150'000U);
            // Two lids of 10 corners, six planes of the slots, top in three strips, three sides.
            EXPECT_LT(m.triangles.size(), 80U);
            EXPECT_TRUE(mesh::topology(m).closed());
            EXPECT_NEAR(mesh::volume(m) / mesh::volume(fine), 1, 1e-9);
        }
    }
}

/// A pocket with round corners: its walls keep their corners along the outline, the planes nothing within.
TEST(SurfaceOf, a_pocket_merges_within_the_deviation) {
    Work w(Box3{{0, 0, -10}, {60, 40, 0}}, 0.25, tool_of(CutterKind::end_mill, 8));
    w.start({12.03, 12.07, 5});
    for (const Vec3 p : {Vec3{12.03, 12.07, -4.1},
                         {45.3, 12.07, -4.1},
                         {45.3, 28.3, -4.1},
                         {12.03, 28.3, -4.1},
                         {12.03, 18.3, -4.1},
                         {45.3, 18.3, -4.1},
                         {45.3, 22.3, -4.1},
                         {12.03, 22.3, -4.1}})
        w.to(p);
    w.simulation.flush();
    const auto normal = [&](std::uint32_t cut, Vec3 p, int, double) { return w.simulation.normal_at(cut, p); };
    mesh::Mesh fine = extract_surface(w.simulation.dexels(), normal).mesh;
    fine.tags.clear();
    const mesh::Mesh m = mesh::merge_flat(fine, 0.0005);
    EXPECT_TRUE(mesh::topology(m).closed());
    EXPECT_LT(m.triangles.size(), 2000U);
    EXPECT_NEAR(mesh::volume(m) / mesh::volume(fine), 1, 1e-6);
    const mesh::Distance to_new{mesh::Mesh(m)};
    double far = 0;
    for (const Vec3& p : fine.vertices) far = std::max(far, std::abs(to_new.signed_distance(p)));
    EXPECT_LE(far, 0.0005);
}

}  // namespace
}  // namespace obrys::sim::milling
