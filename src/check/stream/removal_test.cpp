#include <gtest/gtest.h>

#include "base/codes.hpp"
#include "check/stream/bench_part.hpp"

namespace obrys::check {
namespace {

using namespace bench_part;
using Codes = std::vector<std::string>;

TEST(Removal, ACleanProgramIsClean) {
    Script run(setup());
    const Result r = run.ready().whole_groove().finish();
    EXPECT_EQ(codes(r), Codes{});
    EXPECT_TRUE(r.unchecked.empty());
    EXPECT_EQ(r.verdict, Verdict::clean);
    EXPECT_EQ(exit_code(r.verdict), 0);
    EXPECT_EQ(r.stats.moves, 10u);
    EXPECT_EQ(r.stats.feed_moves, 3u);
    ASSERT_TRUE(r.before && r.after);
    EXPECT_NEAR(r.before->area_mm2, 2000, 1e-9);
    EXPECT_NEAR(r.after->area_mm2, 2000 - 9 * 4.5, 1e-6);
    EXPECT_NEAR(r.before->volume_mm3 - r.after->volume_mm3, geom::pi * 9 * (20 * 20 - 15.5 * 15.5), 1e-3);
}

TEST(Removal, GougeWithDepthAndArea) {
    Script run(setup());
    const Result r = run.ready().whole_groove().rapid(33.5, 25).feed(33.5, 14).rapid(33.5, 25).finish();
    ASSERT_EQ(codes(r), (Codes{"gouge@11", "allowance-cut@11"}));
    const Finding& gouge = r.findings[0];
    EXPECT_NEAR(amount(gouge, "depth_x_mm"), 1, 1e-6);
    EXPECT_NEAR(amount(gouge, "area_mm2"), 3, 1e-6);
    EXPECT_EQ(line(gouge.where), 15);
    EXPECT_EQ(gouge.severity, base::Severity::error);
    EXPECT_EQ(gouge.from->x, 25);
    EXPECT_EQ(gouge.to->x, 14);
    EXPECT_FALSE(gouge.region.empty());
    EXPECT_NEAR(amount(r.findings[1], "depth_x_mm"), 1.5, 1e-6);
    EXPECT_NEAR(amount(r.findings[1], "area_mm2"), 4.5, 1e-6);
    EXPECT_EQ(r.verdict, Verdict::findings);
    EXPECT_EQ(exit_code(r.verdict), 1);
}

TEST(Removal, OnlyTheAllowance) {
    Script run(setup());
    const Result r = run.ready().whole_groove().rapid(33.5, 25).feed(33.5, 15.2).rapid(33.5, 25).finish();
    ASSERT_EQ(codes(r), Codes{"allowance-cut@11"});
    EXPECT_NEAR(amount(r.findings[0], "depth_x_mm"), 0.3, 1e-6);
    EXPECT_EQ(r.findings[0].severity, base::Severity::warning);
}

TEST(Removal, RapidsMayNotCut) {
    Script run(setup());
    const Result r = run.ready().rapid(33.5, 25).rapid(33.5, 18).rapid(33.5, 25).whole_groove().finish();
    ASSERT_EQ(codes(r), Codes{"rapid-in-stock@2"});
    EXPECT_NEAR(amount(r.findings[0], "depth_x_mm"), 2, 1e-6);
    EXPECT_NEAR(amount(r.findings[0], "area_mm2"), 6, 1e-6);
}

TEST(Removal, RestMaterialIsPlacedAtTheCutBesideIt) {
    Script run(setup());
    run.ready().rapid(30.5, 25).feed(30.5, 15.5).rapid(30.5, 25).rapid(36.5, 25).feed(36.5, 15.5).rapid(36.5, 25);
    const Result r = run.finish();
    ASSERT_EQ(codes(r), Codes{"rest-material@5"});
    EXPECT_NEAR(amount(r.findings[0], "area_mm2"), 3 * 4.5, 1e-6);
    EXPECT_NEAR(amount(r.findings[0], "z_from_mm"), 33.5, 1e-6);
    EXPECT_NEAR(amount(r.findings[0], "z_to_mm"), 36.5, 1e-6);
    EXPECT_EQ(line(r.findings[0].where), 9);
}

TEST(Removal, RestMaterialThatNothingCutIsPlacedAtTheEnd) {
    Script run(setup());
    const Result r = run.ready().step(cl::Stop{cl::StopKind::end}).finish();
    ASSERT_EQ(codes(r), Codes{"rest-material"});
    EXPECT_NEAR(amount(r.findings[0], "area_mm2"), 9 * 4.5, 1e-6);
    EXPECT_EQ(line(r.findings[0].where), 5);
}

TEST(Removal, RestMaterialIsJudgedOnlyWhereTheContourIs) {
    check::Setup s = setup();
    s.part = polygon({{20, 0}, {50, 0}, {50, 18}, {20, 18}});
    s.allowance.reset();
    Script run(s);
    const Result r = run.ready().rapid(20, 25).feed(20, 18).feed(47, 18).rapid(47, 25).finish();
    EXPECT_EQ(codes(r), Codes{});
    ASSERT_FALSE(r.assumptions.empty());
    EXPECT_NE(r.assumptions.back().text.find("from Z 20.000 to Z 50.000 mm"), std::string::npos);
}

TEST(Removal, TheStartPositionIsAnAssumption) {
    check::Setup s = setup();
    Script run(s);
    run.step(cl::Linear{{25, 0, NAN}, {0, 0, 1}, true});
    const Result r = run.ready().whole_groove().finish();
    EXPECT_EQ(r.verdict, Verdict::clean);
    ASSERT_EQ(r.assumptions.size(), 1u);
    EXPECT_NE(r.assumptions[0].text.find("first 1 rapid move was not simulated"), std::string::npos)
        << r.assumptions[0].text;
}

TEST(Removal, APositionLostOnTheWayIsNotSimulated) {
    Script run(setup());
    run.ready().whole_groove();
    run.step(cl::Linear{{25, 0, NAN}, {0, 0, 1}, true});  // x stays above the stock: proved to touch nothing
    EXPECT_TRUE(run.finish().unchecked.empty());
    Script home(setup());  // from outside of the stock to where nobody said: away from it
    home.ready().whole_groove();
    home.step(cl::Linear{{NAN, 0, NAN}, {0, 0, 1}, true}).step(cl::Linear{{25, 0, NAN}, {0, 0, 1}, true});
    const Result away = home.finish();
    EXPECT_EQ(away.verdict, Verdict::clean);
    EXPECT_FALSE(away.assumptions.empty());
    Script lost(setup());  // the same from within the groove: by which way is not known
    lost.ready().whole_groove();
    lost.step(cl::Linear{{16, 0, 15}, {0, 0, 1}, true});
    lost.step(cl::Linear{{NAN, 0, NAN}, {0, 0, 1}, true}).step(cl::Linear{{15, 0, NAN}, {0, 0, 1}, true});
    const Result r = lost.finish();
    EXPECT_EQ(r.verdict, Verdict::not_fully_checked);
    EXPECT_EQ(exit_code(r.verdict), 3);
    ASSERT_EQ(r.unchecked.size(), 2u);
    EXPECT_EQ(r.unchecked[0].code, base::codes::not_simulated);
    EXPECT_EQ(r.unchecked[0].times, 2u);
    EXPECT_NE(r.unchecked[1].text.find("rest material not judged"), std::string::npos);
}

TEST(Removal, WithoutStockTheRestIsStillChecked) {
    check::Setup s = setup();
    s.stock.reset();
    Script run(s);
    const Result r = run.step(cl::ToolChange{5, 1, ""}).feed(33, 25).finish();
    EXPECT_EQ(codes(r), (Codes{"feed-missing@0", "spindle-stopped@0"}));
    ASSERT_EQ(r.unchecked.size(), 1u);
    EXPECT_EQ(r.unchecked[0].text, "no stock: removal not simulated");
    EXPECT_EQ(r.verdict, Verdict::not_fully_checked);
}

TEST(Removal, MissingToolsAreFindings) {
    Script run(setup());
    run.step(cl::Spindle{1000, cl::SpindleMode::rpm, 1, 0}).step(cl::Feed{0.2, cl::FeedMode::per_rev});
    const Result r = run.step(cl::ToolChange{7, 1, ""}).rapid(33, 25).feed(33, 18).finish();
    ASSERT_EQ(codes(r), Codes{"tool-missing@0"});
    EXPECT_EQ(line(r.findings[0].where), 3);
    EXPECT_EQ(r.findings[0].text, "tool T7 D1 is not in the tool list");
    EXPECT_EQ(r.verdict, Verdict::not_fully_checked);
    Script none(setup());
    none.step(cl::Spindle{1000, cl::SpindleMode::rpm, 1, 0}).step(cl::Feed{0.2, cl::FeedMode::per_rev});
    EXPECT_EQ(codes(none.rapid(33, 25).feed(33, 22).feed(33, 18).finish()), Codes{"tool-missing@1"});
}

TEST(Removal, AToolWithoutOutlineIsNamed) {
    check::Setup s = setup();
    s.tools[0].kind = shop::ToolKind::other;
    s.tools[0].name = "DRILL";
    Script run(s);
    const Result r = run.ready().feed(33, 18).finish();
    ASSERT_FALSE(r.unchecked.empty());
    EXPECT_EQ(r.unchecked[0].text, "tool T5 D1 has no outline: its removal is not simulated");
}

TEST(Removal, OneFindingForEachCodeAndMoveAndTheirCallStack) {
    Script run(setup());
    run.ready();
    const cl::StackId stack = run.stacks.push(0, {0, 700, 709});
    run.step(cl::Linear{{12, 0, 33}, {0, 0, 1}, true}, stack);
    const Result r = run.finish();
    const auto found = codes(r);
    EXPECT_EQ(std::count(found.begin(), found.end(), "gouge@1"), 1);
    EXPECT_EQ(std::count(found.begin(), found.end(), "rapid-in-stock@1"), 1);
    EXPECT_EQ(r.findings[0].stack, (std::vector<base::Span>{{0, 700, 709}}));
}

TEST(Removal, AnotherZeroOffsetMovesTheTool) {
    check::Setup s = setup();
    Script run(s);
    run.step(cl::Datum{54, {0, 0, 100}}).ready().whole_groove();
    run.step(cl::Datum{55, {0, 0, 110}});
    // In G55 the groove lies 10 mm further down: the same cut as before, nothing is left to remove.
    EXPECT_EQ(codes(run.rapid(23.5, 25).feed(23.5, 15.5).rapid(23.5, 25).finish()), Codes{});
    Script other(s);
    other.step(cl::Datum{54, {0, 0, 100}}).ready().whole_groove().step(cl::Datum{55, {0, 0, 110}});
    EXPECT_EQ(codes(other.rapid(33.5, 25).feed(33.5, 15.5).rapid(33.5, 25).finish()), Codes{"gouge@11"});
}

/// Depth of what an arc from Z 40 to Z 60 about Z 50 X 25 removes from the bar.
double arc_depth(geom::Vec3 normal, double sweep) {
    check::Setup s = setup();
    s.part = polygon({{0, 0}, {100, 0}, {100, 1}, {0, 1}});
    s.allowance.reset();
    s.keep_moves = 10;
    Script run(s);
    run.ready().rapid(40, 25).step(cl::Arc{{25, 0, 60}, {25, 0, 50}, normal, sweep});
    const Result r = run.finish();
    for (const Note& n : r.unchecked) EXPECT_EQ(n.text, "not one move met the stock: nothing was checked against it");
    EXPECT_NEAR(r.moves.back().sweep, normal.y * sweep, 1e-15);
    return r.moves.back().depth_x;
}

TEST(Removal, ArcsTurnTheRightWay) {
    // Counter-clockwise in the (z, x) plane, about +y, the way from left to right leads below the centre.
    EXPECT_NEAR(arc_depth({0, 1, 0}, geom::pi), 5, 1e-9);
    EXPECT_NEAR(arc_depth({0, -1, 0}, -geom::pi), 5, 1e-9);
    EXPECT_EQ(arc_depth({0, 1, 0}, -geom::pi), 0);
}

TEST(Removal, AStockThatIsNeverMetIsNotClean) {
    Script run(setup());
    const Result r = run.ready().rapid(40, 25).feed(50, 25).finish();
    ASSERT_FALSE(r.unchecked.empty());
    EXPECT_EQ(r.unchecked[0].text, "not one move met the stock: nothing was checked against it");
    check::Setup apart = setup();
    for (geom::Vertex& v : apart.stock->contours[0].vertices) v.p.x -= 300;
    Script other(apart);
    const Result o = other.ready().whole_groove().finish();
    ASSERT_EQ(o.unchecked.size(), 2U);
    EXPECT_EQ(o.unchecked[1].text, "the part lies outside the stock");
    EXPECT_EQ(o.verdict, Verdict::not_fully_checked);
}

TEST(Removal, ArcsOutsideTheTurningPlaneAreNotSimulatedAndThreadsAreBands) {
    Script run(setup());
    run.ready().rapid(40, 25).step(cl::Arc{{19, 0, 40}, {22, 0, 40}, {0, 0, 1}, geom::pi});
    const Result r = run.finish();
    ASSERT_FALSE(r.unchecked.empty());
    EXPECT_EQ(r.unchecked[0].text, "arc outside the turning plane: removal not simulated");
    Script thread(setup());
    const Result t = thread.ready().rapid(40, 19.5).step(cl::Thread{{19.5, 0, 20}, 1.5, false}).finish();
    EXPECT_TRUE(t.unchecked.empty());
    Script without(setup());  // what the rapid to the start took
    EXPECT_EQ(t.after->area_mm2, without.ready().rapid(40, 19.5).finish().after->area_mm2);
    EXPECT_NE(t.assumptions.at(0).text.find("threads are not cut"), std::string::npos) << t.assumptions.at(0).text;
}

/// From Z 40 to Z 20 at X 25, down to X 19 in the middle: its ends pass beside the stock.
cl::Spline dip() { return {{25, 0, 20}, {-24, 0, 20}, {24, 0, 0}, {}, {0, 0, 1}, {}}; }

TEST(Removal, SplinesAreNotSimulated) {
    Script run(setup());
    const Result r = run.ready().rapid(40, 25).step(dip()).finish();
    ASSERT_FALSE(r.unchecked.empty());
    EXPECT_EQ(r.unchecked[0].text, "spline: removal not simulated");
    EXPECT_EQ(r.verdict, Verdict::not_fully_checked);
    EXPECT_EQ(r.after->area_mm2, r.before->area_mm2);
}

TEST(Trace, KeepsCurvesThatAreNoArcsInThePlaneAsChains) {
    check::Setup s = setup();
    s.keep_moves = 9;
    Script run(s);
    run.step(cl::Datum{54, {0, 0, 0}}).ready().rapid(40, 25).step(dip()).rapid(40, 25);
    run.step(cl::Datum{55, {1, 0, 0}}).rapid(40, 25).step(dip());
    run.rapid(40, 22).step(cl::Arc{{19, 0, 40}, {20.5, 0, 40}, {0, 0, 1}, geom::pi});
    const Result r = run.finish();
    ASSERT_EQ(r.moves.size(), 8u);
    for (const std::size_t i : {std::size_t{2}, std::size_t{5}}) {
        const auto& via = r.moves[i].via;
        const double shift = i == 5 ? 1 : 0;
        ASSERT_GE(via.size(), 20u);
        for (const geom::Vec2& p : via) EXPECT_NEAR(p.y, 19 + shift + 6 * ((p.x - 30) / 10) * ((p.x - 30) / 10), 1e-9);
        EXPECT_GT(via.front().x, via.back().x);
    }
    // An arc across the plane is seen as a line there and back of the same length along x.
    EXPECT_EQ(r.moves[7].sweep, 0);
    EXPECT_GE(r.moves[7].via.size(), 5u);
}

TEST(Trace, KeepsMovesAndSnapshotsWithinTheBound) {
    check::Setup s = setup();
    s.keep_moves = 9;
    Script run(s);
    const Result r = run.ready().whole_groove().finish();
    ASSERT_EQ(r.moves.size(), 9u);
    EXPECT_EQ(r.moves[0].tool, 1u);
    EXPECT_TRUE(std::isnan(r.moves[0].from.x));
    EXPECT_EQ(r.moves[2].to, (geom::Vec2{33.5, 15.5}));
    EXPECT_NEAR(r.moves[2].area, 13.5, 1e-6);
    EXPECT_FALSE(r.moves[2].removed.empty());
    check::Setup many = setup();
    many.keep_moves = 100'000;
    Script long_run(many);
    long_run.ready();
    for (int i = 0; i < 5000; ++i) long_run.rapid(33 + i % 2, 25);
    const Result l = long_run.finish();
    EXPECT_EQ(l.moves.size(), 5001u);
    EXPECT_LT(l.snapshots.size(), 64u);
    EXPECT_GT(l.snapshots.size(), 20u);
}

}  // namespace
}  // namespace obrys::check
