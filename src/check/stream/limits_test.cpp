#include <gtest/gtest.h>

#include "base/codes.hpp"
#include "check/stream/bench_part.hpp"

namespace obrys::check {
namespace {

using namespace bench_part;
using Codes = std::vector<std::string>;

shop::MachineAxis axis(const char* name, bool rotary, std::optional<double> min, std::optional<double> max) {
    shop::MachineAxis a;
    a.name = name;
    a.rotary = rotary;
    a.min = min;
    a.max = max;
    return a;
}

/// A lathe without stock: only the machine is checked.
Setup machine() {
    check::Setup s = setup();
    s.stock.reset();
    s.machine.axes = {axis("X", false, 0.0, 200.0), axis("Z", false, 0.0, 500.0)};
    s.machine.spindle.min = 50;
    s.machine.spindle.max = 3000;
    s.machine.max_feed = 4000;
    return s;
}

TEST(Limits, TravelInMachineCoordinates) {
    Script run(machine());
    run.step(cl::Datum{54, {0, 0, 100}});
    run.rapid(390, 150).rapid(401.5, 150).rapid(401, 150).rapid(402, 150).rapid(0, 150).rapid(0, 201);
    const Result r = run.finish();
    // Further out is said again, further in is not.
    EXPECT_EQ(codes(r), (Codes{"axis-limit@1", "axis-limit@3", "axis-limit@5"}));
    EXPECT_NEAR(amount(r.findings[0], "excess_mm"), 1.5, 1e-9);
    EXPECT_NE(r.findings[2].text.find("axis X goes 1.000 mm outside"), std::string::npos) << r.findings[2].text;
}

TEST(Limits, ArcsBulgePastTheirEnds) {
    Script run(machine());
    run.step(cl::Datum{54, {0, 0, 0}}).rapid(100, 195);
    // Half a turn from Z 100 to Z 120 about X 195: its top is at X 205.
    run.step(cl::Arc{{195, 0, 120}, {195, 0, 110}, {0, 1, 0}, -geom::pi});
    const Result r = run.finish();
    ASSERT_GE(r.findings.size(), 1u);
    EXPECT_EQ(r.findings[0].code, base::codes::tool_missing);
    const auto found = codes(r);
    ASSERT_EQ(std::count(found.begin(), found.end(), "axis-limit@1"), 1);
    for (const Finding& f : r.findings) {
        if (f.code == base::codes::axis_limit) {
            EXPECT_NEAR(amount(f, "excess_mm"), 5, 1e-9);
        }
    }
    Script below(machine());
    below.step(cl::Datum{54, {0, 0, 0}}).rapid(100, 195);
    below.step(cl::Arc{{195, 0, 120}, {195, 0, 110}, {0, 1, 0}, geom::pi});  // the other half
    const auto others = codes(below.finish());
    EXPECT_EQ(std::count(others.begin(), others.end(), "axis-limit@1"), 0);
}

/// From X 195 Z 100 to X 195 Z 120; x rises to 195 + rise in the middle.
cl::Spline hill(double rise) { return {{195, 0, 120}, {4 * rise, 0, -20}, {-4 * rise, 0, 0}, {}, {0, 0, 1}, {}}; }

TEST(Limits, SplinesBulgePastTheirEnds) {
    for (const double rise : {4.999, 5.5}) {
        Script run(machine());
        run.step(cl::Datum{54, {0, 0, 0}}).rapid(100, 195);
        const Result r = run.step(hill(rise)).finish();
        const auto found = codes(r);
        EXPECT_EQ(std::count(found.begin(), found.end(), "axis-limit@1"), rise > 5 ? 1 : 0);
        for (const Finding& f : r.findings) {
            if (f.code == base::codes::axis_limit) {
                EXPECT_NEAR(amount(f, "excess_mm"), 0.5, 1e-9);
            }
        }
    }
}

TEST(Limits, AdditionalAxesOfASplineToo) {
    check::Setup s = machine();
    s.machine.axes.push_back(axis("C", true, -10.0, 90.0));
    Script run(s);
    run.step(cl::Datum{54, {0, 0, 0}}).rapid(100, 195);
    cl::Spline curve = hill(0);
    curve.axes.push_back({{'C'}, 80, 44, -44, 0, true});  // from 80 over 91 in the middle back to 80
    const Result r = run.step(curve).finish();
    const auto is_limit = [](const Finding& f) { return f.code == base::codes::axis_limit; };
    ASSERT_EQ(std::count_if(r.findings.begin(), r.findings.end(), is_limit), 1);
    const Finding& f = *std::find_if(r.findings.begin(), r.findings.end(), is_limit);
    EXPECT_NEAR(amount(f, "excess_deg"), 1, 1e-9);
    EXPECT_NE(f.text.find("axis C goes to 91 degrees"), std::string::npos) << f.text;
}

TEST(Limits, WithoutAKnownZeroOnlyTheWayIsCompared) {
    Script run(machine());
    const Result r = run.rapid(1000, 50).rapid(1499, 50).rapid(1501, 50).finish();
    EXPECT_EQ(codes(r), Codes{"axis-limit@2"});
    EXPECT_NEAR(amount(r.findings[0], "excess_mm"), 1, 1e-9);
    bool said = false;
    for (const Note& n : r.assumptions) said = said || n.text.find("zero offset of axis Z is not known") == 0;
    EXPECT_TRUE(said);
}

TEST(Limits, AdditionalAxes) {
    check::Setup s = machine();
    s.machine.axes.push_back(axis("C", true, -90.0, 90.0));
    Script run(s);
    run.step(cl::Linear{{0, 0, 0}, {0, 0, 1}, true, cl::Seek::nothing, {{{'C'}, 95, true}}});
    const Result r = run.finish();
    ASSERT_EQ(codes(r), Codes{"axis-limit"});
    EXPECT_NEAR(amount(r.findings[0], "excess_deg"), 5, 1e-9);
}

TEST(Limits, SpindleSpeeds) {
    Script run(machine());
    run.step(cl::Spindle{3001, cl::SpindleMode::rpm, 1, 0});
    run.step(cl::Spindle{49, cl::SpindleMode::rpm, -1, 0});
    run.step(cl::Spindle{3000, cl::SpindleMode::rpm, 1, 0});
    run.step(cl::Spindle{300, cl::SpindleMode::surface, 1, 3500});
    run.step(cl::Spindle{300, cl::SpindleMode::surface, 1, 3000});
    run.step(cl::Spindle{0, cl::SpindleMode::rpm, 0, 0});
    const Result r = run.finish();
    ASSERT_EQ(codes(r), (Codes{"spindle-limit", "spindle-limit", "spindle-limit"}));
    EXPECT_EQ(line(r.findings[0].where), 1);
    EXPECT_EQ(line(r.findings[1].where), 2);
    EXPECT_EQ(line(r.findings[2].where), 4);
    EXPECT_EQ(amount(r.findings[1], "limit_rpm"), 50);
}

TEST(Limits, FeedsMissingTooHighAndWithoutSpindle) {
    Script run(machine());
    run.step(cl::ToolChange{5, 1, ""}).step(cl::Spindle{2000, cl::SpindleMode::rpm, 1, 0}).rapid(10, 50);
    run.feed(20, 50).feed(30, 50);  // said once
    run.step(cl::Feed{4001, cl::FeedMode::per_minute}).feed(20, 50).feed(30, 50);
    run.step(cl::Feed{2, cl::FeedMode::per_rev}).feed(20, 50);    // 4000 mm/min: at the limit
    run.step(cl::Feed{2.5, cl::FeedMode::per_rev}).feed(30, 50);  // 5000
    run.step(cl::Spindle{0, cl::SpindleMode::rpm, 0, 0}).feed(20, 50).feed(30, 50);
    const Result r = run.finish();
    EXPECT_EQ(codes(r), (Codes{"feed-missing@1", "feed-limit@3", "feed-limit@6", "spindle-stopped@7"}));
    EXPECT_NEAR(amount(r.findings[2], "feed_mm_per_min"), 5000, 1e-9);
}

TEST(Limits, ConstantCuttingSpeedAtTheSmallestRadius) {
    check::Setup s = machine();
    s.machine.max_feed = 500;
    Script run(s);
    run.step(cl::ToolChange{5, 1, ""}).step(cl::Spindle{100, cl::SpindleMode::surface, 1, 2500});
    run.step(cl::Feed{0.3, cl::FeedMode::per_rev}).rapid(10, 50).feed(10, 20).feed(10, 5);
    const Result r = run.finish();
    ASSERT_EQ(codes(r), Codes{"feed-limit@2"});  // at X 20 796 1/min and 239 mm/min, at X 5 held at 2500 1/min
    EXPECT_NEAR(amount(r.findings[0], "feed_mm_per_min"), 750, 1e-9);
}

TEST(Limits, RigidTappingTurnsTheSpindleItself) {
    Script run(machine());
    run.step(cl::ToolChange{5, 1, ""}).step(cl::Feed{0.2, cl::FeedMode::per_rev}).rapid(0, 50);
    run.step(cl::Thread{{0, 0, 30}, 1, true}).step(cl::Thread{{0, 0, 50}, 1, true});
    EXPECT_EQ(codes(run.finish()), Codes{});
}

TEST(Limits, ThreadWaitsForASpindleThatStands) {
    Script run(machine());
    run.step(cl::ToolChange{5, 1, ""}).step(cl::Feed{0.2, cl::FeedMode::per_rev}).rapid(10, 50);
    run.step(cl::Thread{{10, 0, 30}, 1, false});
    EXPECT_EQ(codes(run.finish()), Codes{"spindle-stopped@1"});
}

TEST(Limits, StandingSpindleMattersWhereMaterialIsCut) {
    check::Setup s = setup();
    Script run(s);
    run.step(cl::Feed{100, cl::FeedMode::per_minute}).step(cl::ToolChange{5, 1, ""}).rapid(33, 25);
    run.feed(33, 22).feed(33, 18);  // only the second one cuts
    const auto found = codes(run.finish());
    EXPECT_EQ(found.at(0), "spindle-stopped@2");
}

}  // namespace
}  // namespace obrys::check
