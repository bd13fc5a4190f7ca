#include "cl/verify.hpp"

#include <gtest/gtest.h>

#include "base/codes.hpp"

namespace obrys::cl {
namespace {

/// Codes of what the verifier says about the steps, one after the other.
std::vector<std::string> complaints(const std::vector<Step>& steps) {
    base::Diagnostics diagnostics;
    Verifier verify(diagnostics);
    for (const Step& step : steps) verify({step, {}, 0});
    verify.finish();
    std::vector<std::string> out;
    for (const base::Diagnostic& d : diagnostics.all()) out.emplace_back(d.code);
    return out;
}
using Codes = std::vector<std::string>;

TEST(Verify, AGoodStreamPasses) {
    EXPECT_EQ(complaints({Linear{{10, 0, NAN}, {0, 0, 1}, true}, Linear{{10, 0, 0}, {0, 0, 1}, true},
                          Feed{0.2, FeedMode::per_rev}, Spindle{300, SpindleMode::surface, 1, 3000},
                          CycleBegin{Cycle{}, {10, 0, NAN}}, Arc{{0, 10, 0}, {0, 0, 0}, {0, 0, 1}, geom::pi / 2},
                          CycleEnd{}, Arc{{10, 0, 5}, {0, 0, 0}, {0, 0, 1}, -2.5 * geom::pi},
                          Thread{{10, 0, 0}, -1.5, false}, Dwell{0, 3}, Datum{54, {NAN, NAN, NAN}}}),
              Codes{});
}

TEST(Verify, OnlyASpindleThatStandsIsHeld) {
    EXPECT_EQ(complaints({Spindle{100, SpindleMode::rpm, 1, 0, 90}}), Codes{"value-range"});
    EXPECT_EQ(complaints({Spindle{100, SpindleMode::rpm, 0, 0, INFINITY}}), Codes{"value-range"});
    EXPECT_EQ(complaints({Spindle{100, SpindleMode::rpm, 0, 0, 90}, Spindle{100, SpindleMode::rpm, 0, 0, NAN}}),
              Codes{});
}

TEST(Verify, ACompensationActsInAPlane) {
    CompensationBegin begin;
    begin.normal = {0, 0, 2};
    EXPECT_EQ(complaints({begin, CompensationEnd{}}), Codes{"value-range"});
    begin.normal = {0, -1, 0};
    EXPECT_EQ(complaints({begin, CompensationEnd{}}), Codes{});
}

TEST(Verify, ArcsMustEndOnTheirCircle) {
    const Linear start{{10, 0, 0}, {0, 0, 1}, true};
    EXPECT_EQ(complaints({start, Arc{{0, 10.02, 0}, {0, 0, 0}, {0, 0, 1}, geom::pi / 2}}), Codes{"arc-radius"});
    EXPECT_EQ(complaints({start, Arc{{0, 10.005, 0}, {0, 0, 0}, {0, 0, 1}, geom::pi / 2}}), Codes{});
    // The other way round the circle does not end there.
    EXPECT_EQ(complaints({start, Arc{{0, 10, 0}, {0, 0, 0}, {0, 0, 1}, -geom::pi / 2}}), Codes{"arc-radius"});
    EXPECT_EQ(complaints({start, Arc{{10, 0, 0}, {0, 0, 0}, {0, 0, 1}, 0}}), Codes{"value-range"});
    EXPECT_EQ(complaints({start, Arc{{0, 10, 0}, {0, 0, 0}, {0, 0, 2}, 1}}), Codes{"value-range"});
}

TEST(Verify, ArcsStartWhereTheToolStandsInTheZeroInForce) {
    const Linear start{{15, 0, 0}, {0, 0, 1}, true};
    const Arc arc{{0, 10, 0}, {0, 0, 0}, {0, 0, 1}, geom::pi / 2};
    EXPECT_EQ(complaints({Datum{54, {0, 0, 0}}, start, Datum{55, {5, 0, 0}}, arc}), Codes{});
    EXPECT_EQ(complaints({Datum{54, {0, 0, 0}}, start, Datum{55, {4, 0, 0}}, arc}), Codes{"arc-radius"});
}

TEST(Verify, NoRecordHoldsTheseValues) {
    EXPECT_EQ(complaints({Linear{{INFINITY, 0, 0}, {0, 0, 1}, true}}), Codes{"value-range"});
    EXPECT_EQ(complaints({Linear{{0, 0, 0}, {0, 0, 1.1}, true}}), Codes{"value-range"});
    EXPECT_EQ(complaints({Spindle{-1, SpindleMode::rpm, 1, 0}}), Codes{"value-range"});
    EXPECT_EQ(complaints({Spindle{1, SpindleMode::rpm, 3, 0}}), Codes{"value-range"});
    EXPECT_EQ(complaints({Feed{INFINITY, FeedMode::per_minute}}), Codes{"value-range"});
    EXPECT_EQ(complaints({Dwell{-1, 0}}), Codes{"value-range"});
    EXPECT_EQ(complaints({Thread{{0, 0, 0}, 0, false}}), Codes{"value-range"});
    EXPECT_EQ(complaints({Linear{{0, 0, 0}, {0, 0, 1}, true, Seek::nothing, {{{}, 0, true}}}}), Codes{"value-range"});
    EXPECT_EQ(complaints({Frame{{{FrameKind::scaling, geom::Frame::scaling({1, 0, 1})}}}}), Codes{"value-range"});
    EXPECT_EQ(complaints({Frame{{{FrameKind::mirror, geom::Frame::scaling({-1, 1, 1})}}}}), Codes{});
}

TEST(Verify, SplinesStartAtThePosition) {
    const Linear start{{10, 0, NAN}, {0, 0, 1}, true};
    // From x 10 to 4 straight, from y 0 over a parabola back to 0; z was never given.
    Spline s{{4, 0, NAN}, {6, -1, 0}, {0, 1, 0}, {0, 0, 0}, {0, 0, 1}, {}};
    EXPECT_EQ(complaints({start, s}), Codes{});
    EXPECT_EQ(complaints({start, s, s}), Codes{"spline-start"});
    s.k3.y = 0.011;
    EXPECT_EQ(complaints({start, s}), Codes{"spline-start"});
    s.k3.y = 0.009;
    EXPECT_EQ(complaints({start, s}), Codes{});
}

TEST(Verify, SplinesAndTolerancesHoldNoOtherValues) {
    const SplineAxis a{{'A'}, 1, 2, 3, 4, true};
    EXPECT_EQ(complaints({Spline{{0, 0, 0}, {1, 0, 0}, {}, {}, {0, 0, 1}, {a, a}}}), Codes{});
    EXPECT_EQ(complaints({Spline{{0, 0, 0}, {1, 0, 0}, {}, {}, {0, 0, 1}, {a, a, a}}}), Codes{"value-range"});
    EXPECT_EQ(complaints({Spline{{0, 0, 0}, {1, 0, 0}, {}, {}, {0, 0, 1}, {SplineAxis{}}}}), Codes{"value-range"});
    EXPECT_EQ(complaints({Spline{{0, 0, 0}, {INFINITY, 0, 0}, {}, {}, {0, 0, 1}, {}}}), Codes{"value-range"});
    EXPECT_EQ(complaints({Spline{{0, 0, 0}, {1, 0, 0}, {}, {}, {0, 1, 1}, {}}}), Codes{"value-range"});
    EXPECT_EQ(complaints({Tolerance{0.05, 0.1, Filter::finishing}, Tolerance{}}), Codes{});
    EXPECT_EQ(complaints({Tolerance{-0.05, 0, Filter::none}}), Codes{"value-range"});
    EXPECT_EQ(complaints({Tolerance{0, NAN, Filter::none}}), Codes{"value-range"});
    EXPECT_EQ(complaints({PathMode{PathKind::within, 0.01}}), Codes{});
    EXPECT_EQ(complaints({PathMode{PathKind::within, -0.01}}), Codes{"value-range"});
}

TEST(Verify, CycleBracketsPairUp) {
    EXPECT_EQ(complaints({CycleBegin{}, CycleBegin{}, CycleEnd{}}), Codes{"unclosed"});
    EXPECT_EQ(complaints({CycleEnd{}}), Codes{"unclosed"});
}

TEST(Verify, CompensationIsOneAtATimeAndEnds) {
    const CompensationBegin left{CompensationSide::left, 5, 1, Approach::normal};
    EXPECT_EQ(complaints({left, Programmed{{0, 0, 0}, {10, 0, 0}, {}}, CompensationEnd{}}), Codes{});
    EXPECT_EQ(complaints({left}), Codes{"unclosed"});
    EXPECT_EQ(complaints({CompensationEnd{}}), Codes{"unclosed"});
    EXPECT_EQ(complaints({left, left, CompensationEnd{}}), Codes{"unclosed"});
    EXPECT_EQ(complaints({CompensationBegin{CompensationSide::left, INFINITY, 1, Approach::normal}, CompensationEnd{}}),
              Codes{"value-range"});
    EXPECT_EQ(complaints({Programmed{{0, 0, 0}, {INFINITY, 0, 0}, {}}}), Codes{"value-range"});
    EXPECT_EQ(complaints({Programmed{{0, 0, 0}, {10, 0, 0}, {5, 0, 0}, {0, 1, 1}, 3}}), Codes{"value-range"});
    EXPECT_EQ(complaints({Programmed{{0, 0, 0}, {10, 0, 0}, {}, {0, 0, 1}, 0, false, Corner::rounding, NAN}}),
              Codes{"value-range"});
}

TEST(Verify, WaysOntoAContourPairUp) {
    const LeadBegin onto{LeadKind::tangent_arc, true, {0, 0, 0}, 0, 5, 1.5};
    EXPECT_EQ(complaints({onto, Linear{{0, 0, 0}}, LeadEnd{}}), Codes{});
    EXPECT_EQ(complaints({onto}), Codes{"unclosed"});
    EXPECT_EQ(complaints({LeadEnd{}}), Codes{"unclosed"});
    EXPECT_EQ(complaints({onto, onto, LeadEnd{}}), Codes{"unclosed"});
    EXPECT_EQ(complaints({LeadBegin{LeadKind::tangent_line, true, {}, NAN}, LeadEnd{}}), Codes{"value-range"});
}

TEST(Verify, PlacesOfTheMachineAndToolsAreWithinReason) {
    EXPECT_EQ(complaints({MachinePlace{PlaceKind::home, 1, {false, false, true}, {NAN, NAN, NAN}}}), Codes{});
    EXPECT_EQ(complaints({MachinePlace{}}), Codes{"value-range"});
    EXPECT_EQ(complaints({MachinePlace{PlaceKind::coordinates, 1, {true, false, false}, {INFINITY, 0, 0}}}),
              Codes{"value-range"});
    EXPECT_EQ(complaints({ToolLength{1, 5, {}}, ToolLength{}}), Codes{});
    EXPECT_EQ(complaints({ToolLength{2, 5, {}}}), Codes{"value-range"});
    EXPECT_EQ(complaints({ToolLength{1, 0, geom::Vec3{0, 0, INFINITY}}}), Codes{"value-range"});
    EXPECT_EQ(complaints({ToolData{1, 1, INFINITY, {}}}), Codes{"value-range"});
    EXPECT_EQ(complaints({DatumData{54, {1, NAN, 3}, 0.5}}), Codes{});
    EXPECT_EQ(complaints({DatumData{54, {INFINITY, NAN, 3}, {}}}), Codes{"value-range"});
}

TEST(Verify, CyclesBeginWhereTheToolStands) {
    const Linear over{{10, 20, 5}, {0, 0, 1}, true};
    const auto at = [](geom::Vec3 place) { return CycleBegin{Cycle{}, place}; };
    EXPECT_EQ(complaints({over, at({10, 20, 5}), CycleEnd{}}), Codes{});
    EXPECT_EQ(complaints({over, at({10, 20, NAN}), CycleEnd{}}), Codes{});
    EXPECT_EQ(complaints({over, at({10, 20.01, 5}), CycleEnd{}}), Codes{"value-range"});
}

TEST(Verify, CyclesSayEachValueOnceAndWithinReason) {
    const auto with = [](std::vector<CycleValue> values) {
        return CycleBegin{Cycle{CycleKind::drill, {}, std::move(values), {}, {}}, {}};
    };
    EXPECT_EQ(complaints({with({{CycleRole::depth, -5}, {CycleRole::clearance, NAN}}), CycleEnd{}}), Codes{});
    EXPECT_EQ(complaints({with({{CycleRole::feed_retract, INFINITY}}), CycleEnd{}}), Codes{});
    EXPECT_EQ(complaints({with({{CycleRole::depth, -5}, {CycleRole::depth, -6}}), CycleEnd{}}), Codes{"value-range"});
    EXPECT_EQ(complaints({with({{CycleRole::depth, INFINITY}}), CycleEnd{}}), Codes{"value-range"});
    Cycle flat;
    flat.plane.linear = {};
    EXPECT_EQ(complaints({CycleBegin{flat, {}}, CycleEnd{}}), Codes{"value-range"});
    EXPECT_EQ(complaints({CycleBegin{Cycle{}, {}, CycleCall::pattern, 3, 2}, CycleEnd{}}), Codes{"value-range"});
}

}  // namespace
}  // namespace obrys::cl
