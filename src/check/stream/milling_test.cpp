/// Milling through the whole check: records in, findings and figures out.

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "base/codes.hpp"
#include "check/result_testing.hpp"
#include "check/stream/check.hpp"
#include "check/stream/milling_testing.hpp"
#include "mesh/primitives.hpp"

namespace obrys::check {

namespace {

using testing::amount;
using testing::face_setup;
using testing::of;

/// Mills the strips at Y 5, 20 and 35 at a height; the last one not where `half`.
Result mill(Setup setup, double z, bool half) {
    const cl::CallStacks stacks;
    Check check(std::move(setup), stacks);
    std::uint32_t at = 0;
    const auto take = [&](cl::Step step) {
        check.take({std::move(step), {0, at, at + 1}, 0});
        ++at;
    };
    take(cl::ToolChange{1, 1, ""});
    take(cl::Spindle{3000, cl::SpindleMode::rpm, 1, 0});
    take(cl::Linear{{-20, 5, 20}, {0, 0, 1}, true});
    take(cl::Feed{500, cl::FeedMode::per_minute});
    for (const double y : {5.0, 20.0, 35.0}) {
        if (half && y > 20) break;
        take(cl::Linear{{-20, y, z}, {0, 0, 1}, true});
        take(cl::Linear{{80, y, z}, {0, 0, 1}, false});
        take(cl::Linear{{80, y, 20}, {0, 0, 1}, true});
        take(cl::Linear{{-20, y, 20}, {0, 0, 1}, true});
    }
    return check.finish();
}

Setup with_part(Setup s, double top) {
    s.milling->part = std::make_shared<const mesh::Distance>(mesh::box({0, 0, -40}, {60, 40, top}));
    return s;
}

}  // namespace

TEST(Milling, AFinishedFaceIsClean) {
    const Result r = mill(with_part(face_setup(), -5), -5, false);
    EXPECT_EQ(r.verdict, Verdict::clean);
    EXPECT_TRUE(r.findings.empty());
    ASSERT_NE(r.milled, nullptr);
    EXPECT_NEAR(r.milled->figures.before_mm3 - r.milled->figures.after_mm3, 60 * 40 * 5, 1e-6 * 96'000);
    // The rim meets X 0 when the centre is at X -10; the last of a strip goes where the tool is widest, at X 60, of the
    // third strip, of which 5 mm on both sides of the way are there, at X 60 - sqrt(75). The rays do not quite reach
    // the widest place.
    EXPECT_NEAR(r.milled->figures.contact_length_mm, 70 + 70 + 70 - std::sqrt(75), 2);
}

TEST(Milling, WhatIsLeftIsNamedWithItsHeightAndTheMoveBesideIt) {
    const Result r = mill(with_part(face_setup(), -5), -5, true);
    const auto rest = of(r, base::codes::rest_material);
    ASSERT_EQ(rest.size(), 1U);
    EXPECT_NEAR(amount(*rest[0], "height_mm"), 5, 0.02);
    EXPECT_EQ(rest[0]->severity, base::Severity::warning);
    ASSERT_TRUE(rest[0]->place);
    EXPECT_GT(rest[0]->place->y, 29.9);
    EXPECT_EQ(r.verdict, Verdict::findings);
}

/// A strip as the part is, then two 1 mm too high; as moves of their own and as a contour cycle's.
TEST(Milling, WhatLiesAlongSeveralBlocksNamesThemAndTheContourElements) {
    for (const bool cycle : {false, true}) {
        const cl::CallStacks stacks;
        Check check(with_part(face_setup(), -5), stacks);
        const auto take = [&](cl::Step step, std::uint32_t at) { check.take({std::move(step), {0, at, at + 1}, 0}); };
        take(cl::ToolChange{1, 1, ""}, 0);
        take(cl::Spindle{3000, cl::SpindleMode::rpm, 1, 0}, 0);
        take(cl::Linear{{-20, 5, 20}, {0, 0, 1}, true}, 0);
        take(cl::Feed{500, cl::FeedMode::per_minute}, 0);
        if (cycle) take(cl::CycleBegin{}, 0);
        std::uint32_t at = 10;
        for (const auto& [y, z] : {std::pair{35.0, -5.0}, std::pair{20.0, -4.0}, std::pair{5.0, -4.0}}) {
            take(cl::Linear{{-20, y, z}, {0, 0, 1}, true}, 0);
            take(cl::Linear{{80, y, z}, {0, 0, 1}, false}, at++);
            take(cl::Linear{{80, y, 20}, {0, 0, 1}, true}, 0);
            take(cl::Linear{{-20, y, 20}, {0, 0, 1}, true}, 0);
        }
        if (cycle) take(cl::CycleEnd{}, 0);
        const Result r = check.finish();
        const auto rest = of(r, base::codes::rest_material);
        ASSERT_EQ(rest.size(), 1U);
        EXPECT_NEAR(amount(*rest[0], "height_mm"), 1, 0.02);
        std::vector<std::uint32_t> blocks{rest[0]->where.begin};
        for (const base::Related& other : rest[0]->related) blocks.push_back(other.where.begin);
        std::sort(blocks.begin(), blocks.end());
        EXPECT_EQ(blocks, (std::vector<std::uint32_t>{10, 11, 12}));
        EXPECT_EQ(rest[0]->related.back().where.begin, 10U) << "it made the wall between the heights only";
        const std::string where =
            cycle ? ", along this contour element and 2 more blocks" : ", in the cuts of this block and 2 more blocks";
        EXPECT_NE(rest[0]->text.find(where), std::string::npos) << rest[0]->text;
    }
}

/// A wall that the first tool leaves 0.1 mm too thick, and that the second one, 0.05 mm farther off, does not touch.
TEST(Milling, WhatALaterToolWasToTakeIsFoundAtItsBlock) {
    check::Setup s = face_setup();
    s.tools[0].cutting_length = 60;
    shop::Tool finisher = s.tools[0];
    finisher.number = 2;
    finisher.radius = 5;
    s.tools.push_back(finisher);
    s.milling->part = std::make_shared<const mesh::Distance>(mesh::box({0, 0, -40}, {30, 40, 0}));
    const cl::CallStacks stacks;
    Check check(std::move(s), stacks);
    std::uint32_t at = 0;
    const auto take = [&](cl::Step step) {
        check.take({std::move(step), {0, at, at + 1}, 0});
        ++at;
    };
    std::uint32_t finishing = 0;
    for (const std::uint32_t tool : {1U, 2U}) {
        take(cl::ToolChange{tool, 1, ""});
        take(cl::Spindle{3000, cl::SpindleMode::rpm, 1, 0});
        take(cl::Linear{{100, -20, 50}, {0, 0, 1}, true});
        take(cl::Feed{500, cl::FeedMode::per_minute});
        for (const double x : tool == 1 ? std::vector{55.0, 40.1} : std::vector{35.15}) {
            take(cl::Linear{{x, -20, 50}, {0, 0, 1}, true});
            take(cl::Linear{{x, -20, -41}, {0, 0, 1}, true});
            finishing = at;
            take(cl::Linear{{x, 60, -41}, {0, 0, 1}, false});
            take(cl::Linear{{x, 60, 50}, {0, 0, 1}, true});
        }
    }
    const Result r = check.finish();
    const auto rest = of(r, base::codes::rest_material);
    ASSERT_EQ(rest.size(), 1U);
    EXPECT_NEAR(amount(*rest[0], "height_mm"), 0.1, 0.002);
    EXPECT_EQ(rest[0]->where.begin, finishing);
}

/// Which moves met the stock is said as it is.
TEST(Milling, ARapidThatAloneMetTheStockIsNotDenied) {
    for (const double z : {-2.0, 1.0}) {
        const cl::CallStacks stacks;
        Check check(with_part(face_setup(), -2), stacks);
        const auto take = [&](cl::Step step) { check.take({std::move(step), {0, 0, 1}, 0}); };
        take(cl::ToolChange{1, 1, ""});
        take(cl::Spindle{3000, cl::SpindleMode::rpm, 1, 0});
        take(cl::Linear{{30, 20, 50}, {0, 0, 1}, true});
        take(cl::Linear{{30, 20, z}, {0, 0, 1}, true});
        take(cl::Linear{{30, 20, 50}, {0, 0, 1}, true});
        take(cl::Feed{500, cl::FeedMode::per_minute});
        take(cl::Linear{{80, 20, 50}, {0, 0, 1}, false});
        const Result r = check.finish();
        EXPECT_EQ(of(r, base::codes::rapid_in_stock).size(), z < 0 ? 1U : 0U);
        EXPECT_EQ(r.verdict, z < 0 ? Verdict::findings : Verdict::not_fully_checked);
    }
}

TEST(Milling, EveryPlaceAndEveryClampOfOneMoveIsFound) {
    check::Setup s = with_part(face_setup(), -5);
    s.milling->clamps = {{"left", sim::milling::Box3{{-30, 0, -20}, {-20, 40, 0}}},
                         {"right", sim::milling::Box3{{80, 0, -20}, {90, 40, 0}}}};
    const cl::CallStacks stacks;
    Check check(std::move(s), stacks);
    std::uint32_t at = 0;
    const auto take = [&](cl::Step step) {
        check.take({std::move(step), {0, at, at + 1}, 0});
        ++at;
    };
    take(cl::ToolChange{1, 1, ""});
    take(cl::Spindle{3000, cl::SpindleMode::rpm, 1, 0});
    take(cl::Linear{{-40, 5, 20}, {0, 0, 1}, true});
    take(cl::Feed{500, cl::FeedMode::per_minute});
    for (const auto& [y, z] : {std::pair{5.0, -5.0}, std::pair{35.0, -5.0}, std::pair{20.0, -4.0}}) {
        take(cl::Linear{{-8, y, z}, {0, 0, 1}, false});
        take(cl::Linear{{y == 20 ? 90.0 : 68.0, y, z}, {0, 0, 1}, false});
        if (y == 20) take(cl::Linear{{-30, y, z}, {0, 0, 1}, false});  // through both clamps
    }
    take(cl::Linear{{-30, 20, 20}, {0, 0, 1}, true});
    take(cl::Linear{{30, -20, 20}, {0, 0, 1}, true});
    take(cl::Linear{{30, -20, -5}, {0, 0, 1}, true});
    take(cl::Linear{{30, 60, -5}, {0, 0, 1}, false});  // cuts what the third strip left in two
    const Result r = check.finish();
    std::map<std::uint64_t, std::size_t> met;
    for (const Finding* f : of(r, base::codes::clamp_collision)) ++met[f->move.value_or(0)];
    EXPECT_TRUE(std::any_of(met.begin(), met.end(), [](const auto& m) { return m.second == 2; }));
    EXPECT_EQ(of(r, base::codes::rest_material).size(), 2U);
}

TEST(Milling, ACutIntoThePartIsAGougeOfItsMove) {
    const Result r = mill(with_part(face_setup(), -5), -6, false);
    const auto gouges = of(r, base::codes::gouge);
    ASSERT_FALSE(gouges.empty());
    EXPECT_NEAR(amount(*gouges[0], "depth_mm"), 1, 0.02);
    EXPECT_TRUE(gouges[0]->move);
    EXPECT_TRUE(of(r, base::codes::rest_material).empty());
}

TEST(Milling, WithoutAPartNothingIsCalledClean) {
    const Result r = mill(face_setup(), -5, false);
    EXPECT_EQ(r.verdict, Verdict::not_fully_checked);
}

TEST(Milling, AToleranceThatDoesNotFitTheMemorySaysWhatWould) {
    check::Setup s = face_setup();
    s.milling->tolerance = 1e-6;
    s.milling->memory_bytes = 50e6;
    const Result r = mill(std::move(s), -5, false);
    EXPECT_EQ(r.verdict, Verdict::not_fully_checked);
    EXPECT_EQ(r.milled, nullptr);
    ASSERT_FALSE(r.unchecked.empty());
    EXPECT_NE(r.unchecked[0].text.find("of which 50 MB may be used"), std::string::npos) << r.unchecked[0].text;
    EXPECT_NE(r.unchecked[0].remedy.find("mm would fit"), std::string::npos) << r.unchecked[0].remedy;
}

TEST(Milling, ATooCoarseToleranceIsNotCalledClean) {
    for (const double tolerance : {4.0, 20.0, 1000.0}) {
        check::Setup s = with_part(face_setup(), -5);
        s.milling->tolerance = tolerance;
        const Result r = mill(std::move(s), -5, false);
        const bool said = std::any_of(r.unchecked.begin(), r.unchecked.end(), [](const Note& n) {
            return n.text.find("may pass between them") != std::string::npos;
        });
        EXPECT_EQ(said, tolerance > 5) << tolerance;
        EXPECT_EQ(r.verdict, said ? Verdict::not_fully_checked : r.verdict);
        for (const Note& n : r.unchecked) EXPECT_EQ(n.text.find("not one move met"), std::string::npos);
    }
}

TEST(Milling, AToolWithoutRadiusIsNotSimulatedAndSaidSo) {
    check::Setup s = with_part(face_setup(), -5);
    s.tools[0].radius = 0;
    const Result r = mill(std::move(s), -5, false);
    EXPECT_EQ(r.verdict, Verdict::not_fully_checked);
    EXPECT_TRUE(of(r, base::codes::rest_material).empty());
}

TEST(Milling, AProgramBesideTheStockIsNotClean) {
    const Result r = mill(with_part(face_setup(), 0), 5, false);
    EXPECT_EQ(r.verdict, Verdict::not_fully_checked);
}

TEST(Milling, AMoveThatIsTooLongForTheToleranceIsNotCalledClean) {
    check::Setup s = with_part(face_setup(), 0);
    const cl::CallStacks stacks;
    Check check(std::move(s), stacks);
    const auto take = [&](cl::Step step) { check.take({std::move(step), {0, 0, 1}, 0}); };
    take(cl::ToolChange{1, 1, ""});
    take(cl::Spindle{3000, cl::SpindleMode::rpm, 1, 0});
    take(cl::Linear{{-20, 20, -5}, {0, 0, 1}, true});
    take(cl::Feed{500, cl::FeedMode::per_minute});
    take(cl::Arc{{-20, 20, 5}, {1e9, 20, -5}, {0, 0, 1}, 1e5 * geom::pi});
    const Result r = check.finish();
    EXPECT_EQ(r.verdict, Verdict::not_fully_checked);
    EXPECT_TRUE(std::any_of(r.unchecked.begin(), r.unchecked.end(),
                            [](const Note& n) { return n.text.find("not simulated") != std::string::npos; }));
}

TEST(Milling, ATurningAxisIsNotCalledClean) {
    for (const bool rapid : {false, true}) {
        const cl::CallStacks stacks;
        Check check(with_part(face_setup(), 0), stacks);
        const auto take = [&](cl::Step step) { check.take({std::move(step), {0, 0, 1}, 0}); };
        take(cl::ToolChange{1, 1, ""});
        take(cl::Spindle{3000, cl::SpindleMode::rpm, 1, 0});
        take(cl::Linear{{-50, 20, 50}, {0, 0, 1}, true});
        take(cl::Linear{{-40, 20, 50}, {0, 0, 1}, true});
        take(cl::Feed{500, cl::FeedMode::per_minute});
        take(cl::Linear{{-40, 20, 50}, {1, 0, 0}, rapid});  // on the spot
        take(cl::Linear{{-40, 20, 60}, {1, 0, 0}, rapid});
        const Result r = check.finish();
        EXPECT_EQ(r.verdict, Verdict::not_fully_checked);
        EXPECT_TRUE(std::any_of(r.unchecked.begin(), r.unchecked.end(),
                                [](const Note& n) { return n.text.find("rotary axes") != std::string::npos; }));
    }
}

TEST(Milling, TheResultDoesNotDependOnTheNumberOfThreads) {
    check::Setup one = with_part(face_setup(), -5), four = one;
    one.milling->threads = 1;
    four.milling->threads = 4;
    one.milling->surface = four.milling->surface = true;
    const Result a = mill(std::move(one), -6, true), b = mill(std::move(four), -6, true);
    EXPECT_EQ(a.milled->surface.vertices, b.milled->surface.vertices);
    EXPECT_EQ(a.milled->surface.tags, b.milled->surface.tags);
    EXPECT_EQ(a.findings.size(), b.findings.size());
}

}  // namespace obrys::check
