#include "report/sheet/sheet.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace obrys::report::sheet {
namespace {

Program of(const std::vector<cl::Step>& steps, const std::vector<shop::Tool>& tools = {}) {
    shop::Machine machine;
    machine.name = "mill";
    machine.axes.resize(3);
    for (shop::MachineAxis& axis : machine.axes) axis.rapid = 6000;
    Collector collector(tools, machine);
    for (std::uint32_t i = 0; i < steps.size(); ++i) collector.take({steps[i], {0, i, i + 1}, 0});
    Program p = collector.finish();
    p.name = "P<1>";
    return p;
}

cl::Linear rapid(double x, double y, double z) { return {{x, y, z}, {0, 0, 1}, true}; }
cl::ToolChange tool(std::uint32_t number) {
    cl::ToolChange change;
    change.number = number;
    change.edge = 1;
    return change;
}

TEST(Sheet, TimesFollowFromPathFeedAndRapidByTool) {
    const Program p = of({tool(1), rapid(0, 0, 0), rapid(100, 0, 0), cl::Feed{600}, cl::Linear{{100, 50, 0}}, tool(2),
                          cl::Spindle{1000, cl::SpindleMode::rpm, 1}, cl::Feed{0.1, cl::FeedMode::per_rev},
                          cl::Linear{{100, 50, -10}}, cl::Dwell{2, 0}, cl::Dwell{0, 50}});
    ASSERT_EQ(p.tools.size(), 2U);
    EXPECT_DOUBLE_EQ(p.tools[0].times.rapid_s, 1);
    EXPECT_DOUBLE_EQ(p.tools[0].times.feed_s, 5);
    EXPECT_DOUBLE_EQ(p.tools[1].times.feed_s, 6);
    EXPECT_DOUBLE_EQ(p.tools[1].times.dwell_s, 5);
    EXPECT_DOUBLE_EQ(p.tools[1].least_feed, 100);
    EXPECT_EQ(p.times.unmeasured, 1U) << "the first move begins nobody knows where";
    EXPECT_DOUBLE_EQ(p.times.seconds(), 17);
    EXPECT_EQ(p.tool_changes, 2U);
}

TEST(Sheet, WhatIsNotKnownIsCountedApartAndNotAsNothing) {
    const Program p = of({rapid(0, 0, 0), cl::Feed{NAN}, cl::Linear{{10, 0, 0}}, cl::Dwell{0, 5}, cl::Dwell{NAN},
                          cl::Linear{{10, 0, 0}, {0, 0, 1}, true, cl::Seek::nothing, {{{'C'}, 90, true}}}});
    EXPECT_DOUBLE_EQ(p.times.untimed_mm, 10);
    EXPECT_EQ(p.times.untimed_dwells, 2U);
    EXPECT_EQ(p.times.rotary, 1U);
    EXPECT_FALSE(p.times.is_whole());
    const std::string text = as_text(pages({p}, {}, {}));
    EXPECT_NE(text.find("at least "), std::string::npos);
    EXPECT_NE(text.find("10 mm whose feed"), std::string::npos) << text;
}

TEST(Sheet, AnArcReachesFartherThanItsEnds) {
    const Program p = of({rapid(10, 0, 0), cl::Arc{{0, -10, -5}, {0, 0, 0}, {0, 0, 1}, 0.75 * geom::full_turn}});
    EXPECT_NEAR(p.travel.low.x, -10, 1e-12);
    EXPECT_NEAR(p.travel.high.y, 10, 1e-12);
    EXPECT_NEAR(p.travel.low.y, -10, 1e-12);
    EXPECT_NEAR(p.travel.low.z, -5, 1e-12);
    const Program clockwise =
        of({rapid(10, 0, 0), cl::Arc{{0, -10, 0}, {0, 0, 0}, {0, 0, 1}, -0.25 * geom::full_turn}});
    EXPECT_NEAR(clockwise.travel.low.x, 0, 1e-12);
    EXPECT_NEAR(clockwise.travel.high.y, 0, 1e-12);
}

TEST(Sheet, ASplineReachesFartherThanItsEnds) {
    // z goes down by 1 in the middle and comes back.
    const Program p = of({rapid(0, 0, 0), cl::Spline{{10, 0, 0}, {-10, 0, -4}, {0, 0, 4}, {}, {0, 0, 1}, {}}});
    EXPECT_NEAR(p.travel.low.z, -1, 1e-12);
    EXPECT_NEAR(p.travel.high.x, 10, 1e-12);
}

TEST(Sheet, ToolsOfTheListHaveTheirSizes) {
    shop::Tool drill;
    drill.number = 3;
    drill.kind = shop::ToolKind::drill;
    drill.radius = 4;
    const Program p = of({tool(3), rapid(0, 0, 0)}, {drill});
    ASSERT_EQ(p.tools.size(), 1U);
    EXPECT_DOUBLE_EQ(p.tools[0].diameter, 8);
    EXPECT_NE(as_text(pages({p}, {}, {})).find("T3 D1, drill, diameter 8 mm"), std::string::npos);
}

TEST(Sheet, AJobIsOneListOfTools) {
    const Program p = of({tool(1), rapid(0, 0, 0), rapid(60, 0, 0)});
    const std::vector<Page> both = pages({p, p}, {true}, {});
    ASSERT_EQ(both.size(), 3U);
    EXPECT_EQ(both[0].tables[1].rows.size(), 1U);
    EXPECT_EQ(both[0].facts[2].second, "at least 0 h 0 min 1 s");
}

TEST(Sheet, WhatDiffersFromAnOlderOneIsSaid) {
    const Program old = of({tool(1), rapid(0, 0, 0), cl::Feed{600}, cl::Linear{{60, 0, 0}}});
    const Program now = of({tool(1), rapid(0, 0, 0), cl::Feed{600}, cl::Linear{{120, 0, 0}}, tool(2), rapid(0, 0, 0)});
    const auto same = since("old.json", as_json({old}), {old});
    ASSERT_TRUE(same);
    EXPECT_TRUE(same->lines.empty());
    const auto differs = since("old.json", as_json({old}), {now});
    ASSERT_TRUE(differs);
    const auto says = [&](const std::string& line) {
        return std::find(differs->lines.begin(), differs->lines.end(), line) != differs->lines.end();
    };
    EXPECT_TRUE(says("T1 D1: feed_s: 6.000 -> 12.000"));
    EXPECT_TRUE(says("T2 D1: new in tools"));
    EXPECT_FALSE(since("x", "{}", {now}));
    EXPECT_FALSE(since("x", "[1, 2", {now}));
    EXPECT_FALSE(since("x", R"({"format": "obrys-sheet", "version": 1})", {now}));
}

TEST(Sheet, DocumentsAreWhole) {
    const Program p = of({tool(1), rapid(0, 0, 0), cl::Feed{600}, cl::Linear{{60, 0, 0}}});
    const std::vector<Page> all = pages({p}, {}, {});
    EXPECT_NE(as_html(all).find("P&lt;1&gt;"), std::string::npos);
    EXPECT_EQ(as_html(all).find("P<1>"), std::string::npos);
    const std::string pdf = as_pdf(all);
    EXPECT_TRUE(pdf.starts_with("%PDF-"));
    EXPECT_NE(pdf.find("%%EOF"), std::string::npos);
    const auto json = nlohmann::json::parse(as_json({p}));
    EXPECT_EQ(json["programs"][0]["tools"][0]["number"], 1);
    EXPECT_TRUE(json["programs"][0]["tools"][0]["diameter_mm"].is_null());
}

}  // namespace
}  // namespace obrys::report::sheet
