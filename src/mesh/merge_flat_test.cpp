#include "mesh/merge_flat.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>
#include <set>

#include "mesh/distance.hpp"
#include "mesh/primitives.hpp"
#include "mesh/topology.hpp"
#include "mesh/weld.hpp"

namespace obrys::mesh {
namespace {

using geom::Frame;
using geom::Vec3;

constexpr double deviation = 0.0005;

/// Every triangle as n^2 small ones of the same tag.
Mesh divided(const Mesh& m, int n) {
    Mesh out;
    Welder welder(1e-9);
    for (std::size_t t = 0; t < m.triangles.size(); ++t) {
        const auto [a, b, c] = corners(m, t);
        const Vec3 one = (1.0 / n) * (b - a), other = (1.0 / n) * (c - a), from = a;
        const auto at = [&](int i, int j) { return welder.add(from + i * one + j * other); };
        for (int i = 0; i < n; ++i)
            for (int j = 0; i + j < n; ++j) {
                out.triangles.push_back({at(i, j), at(i + 1, j), at(i, j + 1)});
                if (i + j + 1 < n) out.triangles.push_back({at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
                out.tags.resize(out.triangles.size(), m.tag(t));
            }
    }
    out.vertices = welder.take();
    return out;
}

std::map<std::uint32_t, double> areas(const Mesh& m) {
    std::map<std::uint32_t, double> sum;
    for (std::size_t t = 0; t < m.triangles.size(); ++t) sum[m.tag(t)] += 0.5 * length(area_vector(m, t));
    return sum;
}

/// What must hold for every merged mesh that was closed.
void expect_same(const Mesh& before, const Mesh& after, double off, const std::string& what) {
    EXPECT_TRUE(topology(after).closed()) << what;
    EXPECT_LE(after.triangles.size(), before.triangles.size()) << what;
    EXPECT_EQ(after.tags.size(), before.tags.empty() ? 0 : after.triangles.size()) << what;
    const auto key = [](Vec3 p) { return std::array{p.x, p.y, p.z}; };
    std::set<std::array<double, 3>> old;
    for (const Vec3& p : before.vertices) old.insert(key(p));
    for (const Vec3& p : after.vertices) EXPECT_TRUE(old.contains(key(p))) << what;
    const Distance to_new{Mesh(after)}, to_old{Mesh(before)};
    double far = 0;
    for (const Vec3& p : before.vertices) far = std::max(far, std::abs(to_new.signed_distance(p)));
    std::mt19937 random(1);
    std::uniform_real_distribution<double> share(0, 1);
    for (std::size_t t = 0; t < after.triangles.size(); ++t)
        for (int i = 0; i < 20; ++i) {
            const auto [a, b, c] = corners(after, t);
            double u = share(random), v = share(random);
            if (u + v > 1) u = 1 - u, v = 1 - v;
            far = std::max(far, std::abs(to_old.signed_distance(a + u * (b - a) + v * (c - a))));
        }
    EXPECT_LE(far, off) << what;
}

TEST(MergeFlat, a_divided_box_becomes_twelve_triangles) {
    const Mesh plain = box({0, 0, 0}, {100, 60, 10});
    for (const int n : {1, 2, 7, 40})
        for (const double turn : {0.0, 0.3}) {
            Mesh fine = transformed(divided(plain, n), Frame::rotation(0, turn) * Frame::rotation(2, 2 * turn));
            fine.tags.clear();
            const Mesh m = merge_flat(fine, deviation);
            EXPECT_EQ(m.triangles.size(), 12U) << n << " " << turn;
            EXPECT_EQ(m.vertices.size(), 8U) << n << " " << turn;
            EXPECT_NEAR(volume(m) / 60000, 1, 1e-12);
            EXPECT_NEAR(area(m) / area(fine), 1, 1e-12);
            expect_same(fine, m, 1e-9, std::to_string(n));
        }
}

TEST(MergeFlat, tags_keep_their_areas_and_straight_borders) {
    Mesh tagged = divided(box({0, 0, 0}, {40, 40, 10}), 40);
    for (std::size_t t = 0; t < tagged.triangles.size(); ++t) {
        const Vec3 at = centre(tagged, t);
        // Strips on the upper side, a square within another strip.
        tagged.tags[t] = at.z < 10                                          ? 0
                         : at.x > 12 && at.x < 15 && at.y > 12 && at.y < 18 ? 9
                                                                            : 1 + static_cast<std::uint32_t>(at.x / 10);
    }
    const Mesh m = merge_flat(tagged, deviation);
    expect_same(tagged, m, 1e-9, "tags");
    EXPECT_LT(m.triangles.size(), 80U);
    const auto before = areas(tagged), after = areas(m);
    ASSERT_EQ(before.size(), after.size());
    for (const auto& [tag, sum] : before) EXPECT_NEAR(after.at(tag), sum, 1e-9) << tag;
}

TEST(MergeFlat, what_is_curved_stays_and_the_flat_beside_it_goes) {
    const Mesh bar = divided(cylinder({5, -3, 2}, 4, 7, 200), 12);
    const Mesh m = merge_flat(bar, 1e-5);
    expect_same(bar, m, 1e-5, "bar");
    // 200 sides of two triangles, and two lids of 200 corners, in which a vertex with many triangles may stay.
    EXPECT_LE(m.triangles.size(), 800U);
    EXPECT_NEAR(volume(m) / volume(bar), 1, 1e-10);
    const Mesh round = ball({1, 2, 3}, 3, 120);
    const Mesh as_it_was = merge_flat(round, 1e-6);
    EXPECT_EQ(as_it_was.triangles.size(), round.triangles.size());
    EXPECT_EQ(volume(as_it_was), volume(round));
}

/// Bodies with noise below and above what counts as flat, in any position.
TEST(MergeFlat, stays_within_its_deviation) {
    std::mt19937 random(20261121);
    std::uniform_real_distribution<double> between(-1, 1);
    for (int n = 0; n < 40; ++n) {
        Mesh m = n % 2 == 0 ? divided(box({0, 0, 0}, {3, 2, 1}), 12) : divided(cylinder({0, 0, 0}, 2, 1, 7 + n), 4);
        if (n % 3 == 0)
            for (std::size_t t = 0; t < m.triangles.size(); ++t) m.tags[t] = centre(m, t).x > 1.01 ? 1 : 0;
        else if (n % 3 == 1)
            m.tags.clear();
        const double off = std::pow(10, -3 + 2 * between(random)), noise = off * std::pow(10, -1 + between(random));
        for (Vec3& p : m.vertices) p = p + noise * Vec3{between(random), between(random), between(random)};
        m = transformed(m, Frame::rotation(0, 3 * between(random)) * Frame::rotation(2, 3 * between(random)) *
                               Frame::shift({50 * between(random), 0, 9}));
        const Mesh merged = merge_flat(m, off);
        const std::string what =
            "case " + std::to_string(n) + " deviation " + std::to_string(off) + " noise " + std::to_string(noise);
        expect_same(m, merged, off, what);
        EXPECT_GT(volume(merged), 0) << what;
        for (std::size_t t = 0; t < merged.triangles.size(); ++t) EXPECT_GT(length(area_vector(merged, t)), 0) << what;
        const Mesh again = merge_flat(m, off);
        EXPECT_EQ(again.triangles, merged.triangles) << what;
        EXPECT_EQ(again.vertices, merged.vertices) << what;
    }
}

/// Normals: no triangle looks another way than the faces it came from.
TEST(MergeFlat, turns_nothing_over) {
    Mesh fine = divided(box({0, 0, 0}, {10, 10, 10}), 30);
    // A dent with steep walls: the lid of the box has a hole that is not convex.
    for (Vec3& p : fine.vertices)
        if (p.z == 10 && std::abs(p.x - 5) + std::abs(p.y - 5) < 3 && !(p.x > 5 && p.y > 5)) p.z = 6;
    const Mesh m = merge_flat(fine, deviation);
    expect_same(fine, m, 1e-9, "dent");
    EXPECT_LT(m.triangles.size(), fine.triangles.size() / 10);
    EXPECT_NEAR(volume(m), volume(fine), 1e-9);
    double upward = 0;
    for (std::size_t t = 0; t < m.triangles.size(); ++t) {
        const Vec3 v = area_vector(m, t);
        if (v.z > 0) upward += v.z / 2;
    }
    EXPECT_NEAR(upward, 100, 1e-9) << "seen from above every place is covered once";
}

TEST(MergeFlat, meshes_that_bound_no_solid_are_left_where_they_do_not) {
    // Open: the border stays.
    Mesh open = divided(box({0, 0, 0}, {4, 4, 4}), 8);
    std::erase_if(open.triangles, [&](const Triangle& t) {
        return open.vertices[t[0]].z + open.vertices[t[1]].z + open.vertices[t[2]].z >= 12;
    });
    open.tags.clear();
    const std::size_t edges = topology(open).open.count;
    ASSERT_GT(edges, 0U);
    const Mesh m = merge_flat(open, deviation);
    EXPECT_EQ(topology(m).open.count, edges);
    EXPECT_LT(m.triangles.size(), open.triangles.size());
    EXPECT_NEAR(area(m), area(open), 1e-9);
    // Two bodies that share an edge, a third that touches in a corner.
    Mesh touching = divided(box({0, 0, 0}, {1, 1, 1}), 6);
    append(touching, divided(box({1, 1, 0}, {2, 2, 1}), 6));
    append(touching, divided(box({2, 2, 1}, {3, 3, 2}), 6));
    Welder welder(1e-9);
    for (Triangle& t : touching.triangles)
        for (std::uint32_t& v : t) v = welder.add(touching.vertices[v]);
    touching.vertices = welder.take();
    const Mesh joined = merge_flat(touching, deviation);
    EXPECT_NEAR(volume(joined), 3, 1e-12);
    EXPECT_NEAR(area(joined), 18, 1e-12);
    EXPECT_EQ(topology(joined).open.count, 0U);
    EXPECT_EQ(topology(joined).crowded.count, topology(touching).crowded.count);
    // Nothing, and no deviation.
    EXPECT_TRUE(merge_flat({}, deviation).empty());
    EXPECT_EQ(merge_flat(touching, 0).triangles, touching.triangles);
    EXPECT_EQ(merge_flat(touching, std::nan("")).triangles, touching.triangles);
    Mesh folded = box({0, 0, 0}, {1, 1, 1});
    folded.triangles.push_back({0, 0, 1});
    folded.triangles.push_back({2, 2, 2});
    EXPECT_EQ(merge_flat(folded, deviation).triangles.size(), folded.triangles.size());
}

}  // namespace
}  // namespace obrys::mesh
