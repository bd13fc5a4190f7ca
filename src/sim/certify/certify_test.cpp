#include "sim/certify/certify.hpp"

#include <gtest/gtest.h>

#include <string>

#include "sim/certify/blocks_testing.hpp"
#include "sim/certify/certify_testing.hpp"

namespace obrys::sim::certify {
namespace {

using namespace testing;

const mesh::Distance& plate() {
    static const mesh::Distance part(mesh::box({0, 0, -20}, {60, 40, 0}));
    return part;
}

TEST(Certified, scratches_of_pointed_tools_are_as_deep_as_they_are_however_narrow) {
    for (const double allowed : {0.002, 0.01, 0.05})
        for (const double angle : {30.0, 60.0, 90.0, 118.0})
            for (const double times : {0.5, 1.2, 3.0, 15.0}) {
                const Judge judge(plate(), allowed);
                const Shape tool = cone(5, angle);
                const auto d = found_in(judge, tool, {10.123, 11.07, -times * allowed}, {50.3, 29.9, -times * allowed});
                if (times < 1) {
                    EXPECT_FALSE(d && d->depth > allowed) << allowed << ' ' << angle;
                    continue;
                }
                ASSERT_TRUE(d) << allowed << ' ' << angle << ' ' << times;
                EXPECT_NEAR(d->depth, times * allowed, allowed / 10) << allowed << ' ' << angle << ' ' << times;
                EXPECT_NEAR(d->width, 2 * times * allowed * std::tan(geom::radians(angle) / 2), 1e-3 * allowed);
                EXPECT_NEAR(d->normal.z, 1, 1e-6);
            }
}

TEST(Certified, a_place_at_a_wall_is_no_wider_than_the_part_is_high) {
    const Judge judge(plate(), 0.01);
    const double r = 5;
    const auto d =
        found_in(judge, end_mill(r), {-20, -r + 0.05, -2}, {80, -r + 0.05, -2});  // reaches far above the plate
    ASSERT_TRUE(d);
    EXPECT_NEAR(d->depth, 0.05, 0.001);
    EXPECT_NEAR(d->width, 2, 0.05);
}

TEST(Certified, what_touches_all_along_is_clear) {
    const Judge judge(plate(), 0.01);
    for (const Shape& tool : {end_mill(5), ball(3), bull(6, 1), cone(5, 90)}) {
        EXPECT_EQ(depth_of(judge, tool, {-20, 20, 0}, {80, 20, 0}), 0);  // on the face
        const double r = tool.back().r1;
        EXPECT_EQ(depth_of(judge, tool, {-20, -r, -15}, {80, -r, -15}), 0);       // along the wall
        EXPECT_EQ(depth_of(judge, tool, {60 + r, 20, 5}, {60 + r, 20, -30}), 0);  // down beside it
    }
}

TEST(Certified, a_needle_that_cuts_into_a_wall_by_less_than_is_allowed_is_clear) {
    for (const double angle : {20.0, 45.0, 90.0, 135.0}) {
        const double half = geom::radians(angle) / 2;
        const double tip = 0.01 / std::tan(half);  // a body of its own
        const Shape tool{{0, 0, 0.01, tip, 0}, {0.01, tip, 5, 5 / std::tan(half), 0}};
        // Along an edge of the plate, the flank 0.7 of what is allowed into it.
        const double height = 2 / std::tan(half), off = 0.7 * 0.01 / std::cos(half);
        const Judge judge(plate(), 0.0105);
        const Vec3 at{-2 + off, 5, -height};
        const Move less{geom::Straight{at, at + Vec3{0, 30, 0}}, {0, 0, 1}, &tool};
        EXPECT_TRUE(judge.is_clear(less)) << angle;
        const Vec3 in{-2 + 2 * off, 5, -height};
        const Move more{geom::Straight{in, in + Vec3{0, 30, 0}}, {0, 0, 1}, &tool};
        EXPECT_FALSE(judge.is_clear(more)) << angle;
    }
}

TEST(Certified, a_place_level_with_the_ring_of_a_bull_nose_lies_outside_of_it) {
    const Swept ring{bull(6, 1).front(), {0, 0, 0}, {0, 0, 0}, {0, 0, 1}};
    EXPECT_NEAR(geom::distance(nearest_within(ring, {20, 0, 1}), {6, 0, 1}), 0, 1e-9);
    // A cut into the wall of a block: where the search comes by such a place it found the block's own thickness.
    const mesh::Distance block(mesh::box({-40, -20, -30}, {0, 20, 0}));
    const Judge judge(block, 0.01);
    const Vec3 start{5.9, -3, -20};
    EXPECT_NEAR(depth_of(judge, bull(6, 1), start, start + Vec3{0, 6, 5}), 0.1, 0.002);
}

TEST(Certified, a_wall_cut_into_is_as_deep_as_the_tool_went_past_it) {
    const Judge judge(plate(), 0.01);
    const auto d = found_in(judge, end_mill(5), {-20, -4.98, -15}, {80, -4.98, -15});
    ASSERT_TRUE(d);
    EXPECT_NEAR(d->depth, 0.02, 0.001);
    EXPECT_NEAR(d->normal.y, -1, 1e-6);
    EXPECT_FALSE(d->edge);
}

TEST(Certified, a_chamfer_that_nobody_wanted_is_said_of_the_edge) {
    const Judge judge(plate(), 0.01);
    // 0.1 x 45 degrees: the flank passes the edge at 0.1 / sqrt 2.
    const auto d = found_in(judge, cone(5, 90), {-20, -1.9, -2}, {80, -1.9, -2});
    ASSERT_TRUE(d);
    EXPECT_TRUE(d->edge);
    EXPECT_NEAR(d->depth, 0.1 / std::sqrt(2), 0.002);
}

TEST(Certified, an_edge_at_the_ring_where_a_cone_ends_lies_as_deep_as_elsewhere) {
    const Judge judge(plate(), 0.01);
    // Its point lies so low that the shaft begins level with the plate's top, or a little above or below.
    for (const double ring : {-0.03, -0.002, 0.0, 0.002, 0.03}) {
        const double leg = 0.1 - std::max(0.0, ring);
        const auto d = found_in(judge, cone(5, 90), {-20, -4.9, ring - 5}, {80, -4.9, ring - 5});
        ASSERT_TRUE(d);
        EXPECT_NEAR(d->depth, std::min(0.1, (leg + std::max(0.0, -ring)) / std::sqrt(2)), 0.002) << ring;
    }
}

TEST(Certified, an_edge_lies_as_deep_in_a_round_flank_of_many_chords) {
    // A quarter of a circle of 5 mm in chords of a degree, with a shaft above.
    Shape tool;
    const auto at = [](int i) { return geom::radians(static_cast<double>(i)); };
    for (int i = 0; i < 90; ++i)
        tool.push_back(
            {5 * std::sin(at(i)), 5 - 5 * std::cos(at(i)), 5 * std::sin(at(i + 1)), 5 - 5 * std::cos(at(i + 1)), 0});
    tool.push_back({5, 5, 5, 40, 0});
    const Judge judge(plate(), 0.01);
    // The middle of the ball stands so far from the plate's edge that this lies 0.3 within, askew.
    const double off = 4.7 * std::sin(geom::radians(40.0)), up = 4.7 * std::cos(geom::radians(40.0));
    const auto d = found_in(judge, tool, {-20, -off, up - 5}, {80, -off, up - 5});
    ASSERT_TRUE(d);
    EXPECT_NEAR(d->depth, 0.3, 0.01);
}

TEST(Certified, an_edge_is_as_deep_as_what_is_taken_off_it) {
    // A roof whose faces meet at the angle along x; an end mill's floor takes its ridge off. In the part it lies only
    // the sine of half that angle as deep, or less: the floor's middle is as far from both faces.
    for (const double degrees : {70.0, 90.0, 120.0})
        for (const double off : {0.0101, 0.03, 0.2}) {
            const double run = 20 * std::tan(geom::radians(degrees) / 2);
            mesh::Mesh roof{
                {{-30, -run, -20}, {30, -run, -20}, {30, run, -20}, {-30, run, -20}, {-30, 0, 0}, {30, 0, 0}},
                {{0, 2, 1}, {0, 3, 2}, {0, 1, 5}, {0, 5, 4}, {2, 3, 4}, {2, 4, 5}, {0, 4, 3}, {1, 2, 5}},
                {}};
            const mesh::Distance part(roof);
            const Judge judge(part, 0.01);
            const double d = depth_of(judge, end_mill(5), {-10, 1, -off}, {10, 2, -off});
            EXPECT_NEAR(d, off, 0.001) << degrees << ' ' << off;
            EXPECT_GT(d, 0.01);
        }
}

TEST(Certified, a_vertical_edge_that_is_clipped_is_found_from_its_corner_on) {
    for (const double allowed : {0.001, 0.01})
        for (const double clip : {0.0, 0.012, 0.02, 0.05, 0.3}) {
            const mesh::Distance jaw(mesh::box({0, 20, -20}, {20, 30, 20}));
            const Judge judge(jaw, allowed);
            const Vec3 out{std::sqrt(0.5), std::sqrt(0.5), 0}, way{out.y, -out.x, 0};
            const Vec3 middle = Vec3{20, 30, 5} + (5 - clip) * out;
            const double d = depth_of(judge, end_mill(5), middle - 20.0 * way, middle + 20.0 * way);
            EXPECT_NEAR(d, clip, 0.001 + 0.1 * clip) << allowed << ' ' << clip;
        }
}

TEST(Certified, what_goes_through_a_sheet_is_as_deep_as_it_is_thick) {
    const mesh::Distance sheet(mesh::box({0, 0, -1}, {60, 40, 0}));
    const Judge judge(sheet, 0.01);
    EXPECT_NEAR(depth_of(judge, end_mill(5), {-20, 20, -3}, {80, 20, -3}), 1, 0.01);
    EXPECT_NEAR(depth_of(judge, ball(3), {30, 20, 10}, {30, 20, -8}), 1, 0.01);
}

TEST(Certified, a_tool_wholly_inside_is_found) {
    const mesh::Distance block(mesh::box({-50, -50, -50}, {50, 50, 50}));
    const Judge judge(block, 0.01);
    EXPECT_GT(depth_of(judge, ball(2, 10), {0, 0, 0}, {1, 0, 0}), 39);
}

TEST(Certified, arcs_and_helices_are_judged_like_lines) {
    const Judge judge(plate(), 0.01);
    const Shape mill = end_mill(3);
    // A circle within the part's outline that stays above, and one that dips in by 0.03 at its end.
    for (const double dip : {0.0, 0.03}) {
        const geom::Circular c{{40, 20, 0}, {40, 20, -dip}, {30, 20, 0}, {0, 0, 1}, 2 * geom::pi};
        const Move move{c, {0, 0, 1}, &mill};
        if (dip == 0)
            EXPECT_TRUE(judge.is_clear(move));
        else
            EXPECT_NEAR(judge.deepest(move).value().depth, dip, 0.001);
    }
    // Around a round post of the same circle: nothing; 0.02 nearer: a gouge of that.
    const mesh::Distance post(mesh::cylinder({0, 0, -10}, 8, 10, 2000));
    const Judge beside(post, 0.01);
    for (const double near : {0.0, 0.02}) {
        const double r = 11 - near;
        const geom::Circular c{{r, 0, -5}, {-r, 0, -5}, {0, 0, -5}, {0, 0, 1}, geom::pi};
        const Move move{c, {0, 0, 1}, &mill};
        EXPECT_EQ(beside.is_clear(move), near == 0);
        if (near > 0) {
            EXPECT_NEAR(beside.deepest(move).value().depth, near, 0.001);
        }
    }
}

TEST(Certified, nothing_is_said_beside_the_stock) {
    const Judge judge(plate(), 0.01, {[](Vec3 p) { return -1 - p.z; }, {}, 0, true});  // the stock ends at -1
    EXPECT_FALSE(depth_of(judge, end_mill(5), {-20, 20, -0.5}, {80, 20, -0.5}) > 0.01);
    EXPECT_NEAR(depth_of(judge, end_mill(5), {-20, 20, -1.5}, {80, 20, -1.5}), 0.5, 0.01);
}

mesh::Mesh mesh_of(const testing::BlockCase& c) {
    mesh::Mesh m;
    const auto triangle = [&](Vec3 a, Vec3 b, Vec3 d) {
        const auto n = static_cast<std::uint32_t>(m.vertices.size());
        for (const Vec3& p : {a, b, d}) m.vertices.push_back(p);
        m.triangles.push_back({n, n + 1, n + 2});
    };
    for (const auto& t : c.triangles) triangle(t[0], t[1], t[2]);
    return m;
}

TEST(Certified, straight_blocks_agree_with_the_concave_maximum_of_the_oracle) {
    constexpr double allowed = 1e-5;
    for (const testing::BlockCase& c : testing::blocks) {
        const mesh::Distance part(mesh_of(c));
        const Judge judge(part, allowed);
        // Lifted by the gouge it touches.
        const Vec3 up{0, 0, c.gouge};
        for (const double more : {-0.01, 1e-4}) {
            const Vec3 lift = up + Vec3{0, 0, more};
            const Move move{geom::Straight{c.from + lift, c.to + lift}, {0, 0, 1}, &c.tool};
            EXPECT_EQ(judge.is_clear(move), more > 0) << c.name << ' ' << c.gouge << ' ' << more;
        }
    }
}

TEST(Certified, a_tip_that_is_less_deep_than_allowed_is_clear_however_it_comes) {
    const mesh::Distance part(mesh::box({-10, -10, -10}, {10, 10, 0}));
    constexpr double allowed = 0.01;
    const Judge judge(part, allowed);
    const Shape v{{0, 0, allowed, allowed, 0}, {allowed, allowed, 4, 4, 0}};
    const auto is_clear = [&](Vec3 from, Vec3 to) { return judge.is_clear({geom::Straight{from, to}, {0, 0, 1}, &v}); };
    const double low = -0.9 * allowed, deep = -1.1 * allowed;
    EXPECT_TRUE(is_clear({0, 0, 1}, {0, 0, low}));
    EXPECT_TRUE(is_clear({0, 0, low}, {8, 0, low}));
    EXPECT_TRUE(is_clear({0, 0, 1}, {8, 0, low}));
    EXPECT_FALSE(is_clear({0, 0, 1}, {0, 0, deep}));
    EXPECT_FALSE(is_clear({0, 0, deep}, {8, 0, deep}));
}

}  // namespace
}  // namespace obrys::sim::certify
