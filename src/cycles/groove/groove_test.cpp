#include <gtest/gtest.h>

#include "cycles/groove/oracle_testing.hpp"

namespace obrys::cycles::groove {
namespace {

using testing::bindings;
using testing::points;
using testing::refusals;

void expect_near(Vec2 a, Vec2 b, const char* what) {
    EXPECT_NEAR(a.x, b.x, 1.5e-9) << what;
    EXPECT_NEAR(a.y, b.y, 1.5e-9) << what;
}

Request request_of(const testing::Binding& b) {
    Request r;
    r.shape = testing::shape_of(b.measures);
    r.insert.width = b.width;
    r.manner.infeed = b.infeed;
    r.manner.stepover = b.stepover;
    return r;
}

TEST(GrooveContour, PointsByLineIntersection) {
    for (const testing::Points& p : points) {
        SCOPED_TRACE(p.name);
        const auto found = contours_of(testing::shape_of(p.measures), 1);
        ASSERT_TRUE(std::holds_alternative<Contours>(found));
        const Contours& c = std::get<Contours>(found);
        const Wall &l = c.rough.wall(Side::left), &r = c.rough.wall(Side::right);
        expect_near(l.edge, p.rough[0], "rough left edge");
        expect_near(l.corner, p.rough[1], "rough left corner");
        expect_near(r.corner, p.rough[2], "rough right corner");
        expect_near(r.edge, p.rough[3], "rough right edge");
        EXPECT_NEAR(l.foot().x, p.flat_begin, 1.5e-9);
        EXPECT_NEAR(r.foot().x, p.flat_end, 1.5e-9);
        const Wall &fl = c.finished.wall(Side::left), &fr = c.finished.wall(Side::right);
        expect_near(fl.edge, p.finished[0], "left edge");
        expect_near(fl.corner, p.finished[1], "left corner");
        expect_near(fr.corner, p.finished[2], "right corner");
        expect_near(fr.edge, p.finished[3], "right edge");
        expect_near(fl.top(), p.tangents[0], "left top");
        expect_near(fl.foot(), p.tangents[1], "left foot");
        expect_near(fr.foot(), p.tangents[2], "right foot");
        expect_near(fr.top(), p.tangents[3], "right top");
        EXPECT_NEAR(c.rough.area(), p.rough_area, 1e-3 + 1e-5 * p.rough_area);
        EXPECT_NEAR(c.finished.area(), p.finished_area, 1e-3 + 1e-5 * p.finished_area);
    }
}

TEST(GrooveContour, ChamfersByLegAndByBase) {
    EXPECT_DOUBLE_EQ(leg_of({2, Corner::Form::leg}, geom::radians(70)), 2);
    // the base of a triangle with two legs of this length and the angle 180 - 90 between them
    EXPECT_NEAR(leg_of({2, Corner::Form::base}, geom::radians(90)), std::sqrt(2), 1e-15);
    EXPECT_NEAR(leg_of({2, Corner::Form::radius}, geom::radians(90)), 2, 1e-15);
}

TEST(GrooveGuards, EachHasItsReason) {
    for (const testing::Refused& r : refusals) {
        const auto found = contours_of(testing::shape_of(r.measures), r.width);
        ASSERT_TRUE(std::holds_alternative<Refusal>(found)) << r.name;
        EXPECT_EQ(std::get<Refusal>(found).guard, r.guard) << r.name;
        EXPECT_FALSE(std::get<Refusal>(found).remedy.empty());
    }
}

/// The first of the oracle's grooves of this strategy, changed.
template <class Change>
std::optional<Guard> guard_of(Strategy strategy, Change change) {
    Request r;
    r.shape.p = {0, 50};
    r.shape.depth = 12;
    r.shape.width = 20;
    r.insert.width = 4;
    r.manner.infeed = 1.5;
    r.manner.stepover = 3.2;
    change(r);
    const auto contours = contours_of(r.shape, r.insert.width);
    if (const auto* refusal = std::get_if<Refusal>(&contours)) return refusal->guard;
    const auto path = path_of(r, std::get<Contours>(contours), strategy);
    if (const auto* refusal = std::get_if<Refusal>(&path)) return refusal->guard;
    return std::nullopt;
}

TEST(GrooveGuards, OfTheManner) {
    const auto guard = [](Strategy s, auto change) { return guard_of(s, change); };
    EXPECT_EQ(guard(Strategy::side_stepping, [](Request&) {}), std::nullopt);
    EXPECT_EQ(guard(Strategy::layers, [](Request& r) { r.manner.infeed = 0; }), Guard::infeed);
    EXPECT_EQ(guard(Strategy::layers, [](Request& r) { r.manner.infeed = 1e-6; }), Guard::infeed);
    EXPECT_EQ(guard(Strategy::ramping, [](Request& r) { r.manner.ramp_angle = 1e-9; }), Guard::ramp);
    EXPECT_EQ(guard(Strategy::layers, [](Request& r) { r.manner.stepover = 4.1; }), Guard::stepover);
    EXPECT_EQ(guard(Strategy::layers, [](Request& r) { r.insert.corner_radius = 2; }), Guard::insert_corner);
    EXPECT_EQ(guard(Strategy::layers, [](Request& r) { r.insert.reach = 12.9; }), Guard::overhang);
    EXPECT_EQ(guard(Strategy::layers, [](Request& r) { r.insert.reach = 13; }), std::nullopt);
    EXPECT_EQ(guard(Strategy::multiple, [](Request& r) { r.manner.rib = 1; }), Guard::rib);
    EXPECT_EQ(guard(Strategy::plunge_turning, [](Request& r) { r.manner.layer = 3.1; }), Guard::layer);
    EXPECT_EQ(guard(Strategy::ramping, [](Request& r) { r.shape.width = 5.9; }), Guard::ramp);
}

TEST(GrooveStrategies, ReachWhatIsBinding) {
    for (const testing::Binding& b : bindings) {
        SCOPED_TRACE(std::string(named(b.strategy).word) + " " + b.name);
        const Request r = request_of(b);
        const auto contours = contours_of(r.shape, r.insert.width);
        ASSERT_TRUE(std::holds_alternative<Contours>(contours));
        const auto found = path_of(r, std::get<Contours>(contours), b.strategy);
        ASSERT_EQ(std::holds_alternative<Refusal>(found), b.refused);
        if (b.refused) continue;
        const Doings& d = std::get<Path>(found).does;
        const double most = b.strategy == Strategy::finishing ? std::get<Contours>(contours).finished.area()
                                                              : std::get<Contours>(contours).rough.area();
        // Their arcs are 200 chords, which roughing and finishing do not share.
        EXPECT_GE(d.area, b.area - 1e-4 * b.area - 2e-3);
        EXPECT_LE(d.area, b.strategy == Strategy::plunge_turning ? most + 1e-6 : b.area + 1e-4 * b.area + 1e-6);
        EXPECT_GE(d.feed - d.air, b.least_cut - 1e-3);
        EXPECT_LE(d.widest_plunge, b.width);
        const auto same = [](std::size_t count, double expected) {
            return std::isnan(expected) || static_cast<double>(count) == expected;
        };
        EXPECT_FALSE(d.slot > b.slot + 1e-9) << d.slot;
        EXPECT_TRUE(same(d.columns, b.columns)) << d.columns;
        EXPECT_TRUE(same(d.full_columns, b.full_columns)) << d.full_columns;
        EXPECT_TRUE(same(d.ribs, b.ribs)) << d.ribs;
        EXPECT_FALSE(b.ribs > 0 && !(std::abs(d.rib_width - b.rib_width) < 1e-5)) << d.rib_width;
        EXPECT_TRUE(same(d.layers, b.layers)) << d.layers;
        EXPECT_FALSE(d.layer > b.thickest_layer + 1e-9) << d.layer;
        EXPECT_FALSE(static_cast<double>(d.passes) < b.least_passes) << d.passes;
    }
}

// The groove of the examples: from the low side each plunge removes more, and fewer are needed.
TEST(GrooveStrategies, SideSteppingFromBothSidesOfACone) {
    Request r = request_of(*std::find_if(bindings.begin(), bindings.end(),
                                         [](const auto& b) { return std::string_view(b.name) == "kod1"; }));
    const Contours c = std::get<Contours>(contours_of(r.shape, r.insert.width));
    const Doings low = std::get<Path>(path_of(r, c, Strategy::side_stepping)).does;
    const Doings high = std::get<Path>(path_of(r, c, Strategy::side_stepping_high)).does;
    EXPECT_EQ(low.plunges, 177U);
    EXPECT_EQ(high.plunges, 207U);
    EXPECT_NEAR(low.feed, 4617.413, 0.001);
    EXPECT_NEAR(low.slot, 1, 1e-9);
    EXPECT_NEAR(low.first_traverse, 1818, 1);
}

}  // namespace
}  // namespace obrys::cycles::groove
