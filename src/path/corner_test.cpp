#include "path/corner.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "path/corner_stage.hpp"
#include "path/nose.hpp"
#include "path/path_testing.hpp"

namespace obrys::path::test {
namespace {

const Element along = line({0, 0}, {10, 0});
const Element up = line({10, 0}, {10, 10});

TEST(corner, ChamferByLengthAndByLeg) {
    const CornerResult leg = chamfer_by_leg(along, up, 2);
    ASSERT_TRUE(leg.ok());
    expect_near(leg.first.to, {8, 0});
    expect_near(leg.inserted.to, {10, 2});
    expect_near(leg.second.from, {10, 2});
    const CornerResult length = chamfer(along, up, 2 * std::sqrt(2.0));
    ASSERT_TRUE(length.ok());
    expect_near(length.first.to, {8, 0});
    const Element slanted = line({10, 0}, {20, 10});  // turns by 45 degrees
    const CornerResult c = chamfer(along, slanted, 3);
    EXPECT_NEAR(planar_length(c.inserted), 3, 1e-12);
    EXPECT_NEAR(geom::distance(c.first.to, {10, 0}), geom::distance(c.second.from, {10, 0}), 1e-12);
}

TEST(corner, ChamferWithAnArc) {
    const Element quarter = arc({10, 0}, {0, 0}, geom::pi / 2);
    const CornerResult c = chamfer(along, quarter, 2);
    ASSERT_TRUE(c.ok());
    EXPECT_NEAR(planar_length(c.inserted), 2, 1e-9);
    EXPECT_NEAR(geom::distance(c.second.from, {0, 0}), 10, 1e-12);
    EXPECT_NEAR(geom::distance(c.first.to, {10, 0}), geom::distance(c.second.from, {10, 0}), 1e-9);
    EXPECT_EQ(chamfer(along, quarter, 20).failure, CornerFailure::too_short);
}

TEST(corner, RoundingOfLines) {
    const CornerResult r = rounding(along, up, 3);
    ASSERT_TRUE(r.ok());
    expect_near(r.first.to, {7, 0});
    expect_near(r.inserted.centre, {7, 3});
    EXPECT_NEAR(r.inserted.sweep, geom::pi / 2, 1e-12);
    expect_near(r.second.from, {10, 3});
    EXPECT_TRUE(rounding(along, up, 10).ok());
    EXPECT_EQ(rounding(along, up, 10.1).failure, CornerFailure::too_short);
    const CornerResult right_turn = rounding(along, line({10, 0}, {10, -10}), 3);
    EXPECT_NEAR(right_turn.inserted.sweep, -geom::pi / 2, 1e-12);
}

TEST(corner, RoundingWithArcs) {
    // Outside of a circle of radius 5 about (10, 5), entered at (5, 5) along y = 5: an arc of radius 2 touches both.
    const CornerResult r = rounding(line({-20, 5}, {5, 5}), arc({5, 5}, {10, 5}, -geom::pi / 2), 2);
    ASSERT_TRUE(r.ok());
    EXPECT_NEAR(r.inserted.centre.y, 7, 1e-9);
    EXPECT_NEAR(geom::distance(r.inserted.centre, {10, 5}), 7, 1e-9);
    // Two arcs of radius 10 that meet at (6, 8).
    const CornerResult two =
        rounding(arc({10, 0}, {0, 0}, std::atan2(8, 6)), arc({6, 8}, {12, 0}, std::atan2(8, 6)), 1);
    ASSERT_TRUE(two.ok());
    expect_near(two.inserted.centre, {6, std::sqrt(45.0)});
}

TEST(corner, Failures) {
    EXPECT_EQ(rounding(along, line({10, 0}, {20, 0}), 1).failure, CornerFailure::tangential);
    EXPECT_EQ(rounding(along, line({10, 0}, {0, 0}), 1).failure, CornerFailure::reversal);
    EXPECT_EQ(rounding(along, up, 0).failure, CornerFailure::bad_size);
    EXPECT_EQ(chamfer(along, up, std::nan("")).failure, CornerFailure::bad_size);
    EXPECT_EQ(chamfer_by_leg(along, line({11, 0}, {11, 9}), 1).failure, CornerFailure::not_joined);
    EXPECT_EQ(rounding(arc({0, 0}, {0, 1}, 1), line(arc({0, 0}, {0, 1}, 1).to, {-9, 1}), 1.5).failure,
              CornerFailure::too_short);
    EXPECT_NEAR(largest_corner(along, up, CornerKind::rounding, 50), 10, 1e-8);
    EXPECT_NEAR(largest_corner(along, up, CornerKind::chamfer_leg, 3), 3, 0);
}

/// The inserted arc touches both neighbours: no change of direction at either end.
RC_GTEST_PROP(corner, RoundingIsTangent, (std::uint32_t seed)) {
    Random random(seed);
    for (int i = 0; i < 100; ++i) {
        const auto element = [&](Vec2 p) {
            if (random.upto(1) == 0) return line(p, p + random.in(5, 20) * rotated({1, 0}, random.in(-4, 4)));
            return arc(p, p + random.in(3, 20) * rotated({1, 0}, random.in(-4, 4)),
                       random.in(0.5, 6) * (random.upto(1) == 0 ? 1 : -1));
        };
        const Element a = element({1, 2}), b = element(a.to);
        const double radius = random.in(0.01, 4);
        const CornerResult r = rounding(a, b, radius);
        if (!r.ok()) continue;
        RC_ASSERT(std::abs(turn_between(end_direction(r.first), start_direction(r.inserted))) < 1e-6);
        RC_ASSERT(std::abs(turn_between(end_direction(r.inserted), start_direction(r.second))) < 1e-6);
        RC_ASSERT(std::abs(geom::distance(r.inserted.to, r.inserted.centre) - radius) < 1e-9);
        RC_ASSERT(geom::distance(nearest(a, r.first.to), r.first.to) < 1e-9);
        RC_ASSERT(geom::distance(nearest(b, r.second.from), r.second.from) < 1e-9);
    }
}

struct StageRun {
    std::vector<CornerOutput> out;
    std::vector<CornerFault> faults;
};

StageRun stage(const std::vector<std::pair<Element, CornerRequest>>& input) {
    StageRun r;
    CornerStage s;
    const auto sink = [&r](const CornerOutput& o) { r.out.push_back(o); };
    for (const auto& [e, request] : input)
        if (auto f = s.push(e, request, sink)) r.faults.push_back(*f);
    s.flush(sink);
    return r;
}

TEST(corner_stage, ModalRoundingAndEvents) {
    const CornerRequest modal{.kind = CornerKind::rounding, .size = 2, .modal = true, .before = {90}, .after = {91}};
    Element second = up;
    second.before = {5};
    const Element third = line({10, 10}, {10, 20}), fourth = line({10, 20}, {0, 20});
    const StageRun r = stage({{along, modal}, {second, modal}, {third, modal}, {fourth, modal}});
    EXPECT_TRUE(r.faults.empty());
    ASSERT_EQ(r.out.size(), 6u);
    EXPECT_TRUE(r.out[1].inserted);
    EXPECT_EQ(r.out[1].element.before, (Events{5, 90}));
    EXPECT_EQ(r.out[2].element.before, (Events{91}));
    EXPECT_TRUE(r.out[4].inserted);
    for (std::size_t i = 1; i < r.out.size(); ++i) expect_near(r.out[i].element.from, r.out[i - 1].element.to);
}

TEST(corner_stage, TooShortFailsOrReduces) {
    CornerRequest request{.kind = CornerKind::rounding, .size = 15};
    StageRun r = stage({{along, request}, {up, {}}});
    ASSERT_EQ(r.faults.size(), 1u);
    EXPECT_EQ(r.faults[0].failure, CornerFailure::too_short);
    EXPECT_EQ(r.out.size(), 2u);
    request.reduce = true;
    r = stage({{along, request}, {up, {}}});
    ASSERT_EQ(r.faults.size(), 1u);
    EXPECT_NEAR(r.faults[0].made, 10, 1e-8);
    EXPECT_GE(r.out.size(), 2u);
}

TEST(corner_stage, MovesAlongTheNormalBetween) {
    const CornerRequest request{.kind = CornerKind::chamfer_leg, .size = 1};
    Element down = line({10, 0}, {10, 0});
    down.w_to = -4;
    StageRun r = stage({{along, request}, {down, {}}, {up, {}}});
    ASSERT_EQ(r.out.size(), 4u);
    expect_near(r.out[1].element.to, {9, 0});
    EXPECT_EQ(r.out[2].element.w_from, -4);
    r = stage({{along, request}, {down, {}}, {down, {}}, {down, {}}, {down, {}}, {up, {}}});
    EXPECT_EQ(r.out.size(), 6u) << "more than three blocks between: no chamfer";
}

TEST(nose, TipOfEachPosition) {
    // Outside turning towards the chuck: the tip is nearer to the axis and to the chuck than the nose centre.
    const auto p3 = nose_offset(3, 0.8);
    ASSERT_TRUE(p3);
    EXPECT_EQ(*p3, (Vec2{-0.8, -0.8}));
    EXPECT_EQ(nose_offset(2, 0.4), (Vec2{-0.4, 0.4}));
    EXPECT_EQ(nose_offset(7, 1), (Vec2{-1, 0}));
    EXPECT_EQ(nose_offset(8, 1), (Vec2{0, -1}));
    EXPECT_EQ(nose_offset(9, 1), (Vec2{0, 0}));
    EXPECT_FALSE(nose_offset(0, 1));
    EXPECT_FALSE(nose_offset(10, 1));
    for (int i = 1; i <= 4; ++i) EXPECT_EQ(*nose_offset(i, 1), -*nose_offset((i + 1) % 4 + 1, 1));
}

}  // namespace
}  // namespace obrys::path::test
