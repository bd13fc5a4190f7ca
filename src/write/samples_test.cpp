#include "write/samples.hpp"

#include <gtest/gtest.h>

#include <set>

#include "write/post_testing.hpp"
#include "write/preview.hpp"

namespace obrys::write {
namespace {

TEST(Samples, ReachEveryKindOfRecordAndCycle) {
    for (const char* name : {"fanuc", "sinumerik-840d-lathe"}) {
        const Post post = post_of(std::string(shipped_post(name)->text));
        std::set<std::size_t> steps;
        std::set<cl::CycleKind> kinds;
        for (const cl::Step& s : sample_begin(post, 5)) steps.insert(s.index());
        for (const Sample& sample : record_samples(post))
            for (const cl::Step& s : sample.steps) steps.insert(s.index());
        for (const Sample& sample : cycle_samples(post))
            kinds.insert(*sample.cycle), steps.insert(sample.steps.back().index());
        constexpr std::size_t brackets_end = 1;  // CycleEnd comes with the moves
        EXPECT_GE(steps.size() + brackets_end + (turns(post) ? 1 : 0), std::variant_size_v<cl::Step>) << name;
        EXPECT_EQ(kinds.size(), static_cast<std::size_t>(cl::CycleKind::probe) + 1) << name;
    }
}

TEST(Preview, PrintsACommandWithChosenValues) {
    const Post post = post_of("extends = \"heidenhain-itnc530\"\n");
    const auto drill = preview(post, "cycle.drill", {{"depth", -12.5}});
    ASSERT_EQ(drill.size(), 1U);
    ASSERT_EQ(drill[0].blocks.size(), 2U);
    EXPECT_NE(drill[0].blocks[0].find("Q201=-12.5 Q206=200"), std::string::npos) << drill[0].blocks[0];
    EXPECT_EQ(drill[0].blocks[1], "CYCL CALL");
    EXPECT_TRUE(preview(post, "spindle.surface-cw", {}).empty());
    const auto fits = preview(post, "motion.linear", {{"x", 1e7}});
    ASSERT_EQ(fits.size(), 1U);
    EXPECT_EQ(fits[0].fault, "a word cannot hold its number");
}

TEST(Preview, EveryCommandOfEveryShippedPostPrintsOrSaysWhyNot) {
    for (const std::string& name : shipped_post_names()) {
        const Post post = post_of(std::string(shipped_post(name)->text));
        for (const Previewed& p : preview(post, "", {})) EXPECT_EQ(p.fault, "") << name << " " << p.command;
    }
}

TEST(Preview, ACycleIsShownOnceForEachForm) {
    const Post post = post_of(std::string(shipped_post("fanuc")->text));
    const auto forms = preview(post, "cycle.canned-drill", {});
    ASSERT_EQ(forms.size(), 2U);
    EXPECT_EQ(forms[0].form, "with dwell-bottom");
    EXPECT_EQ(forms[1].form, "without dwell-bottom");
    EXPECT_NE(forms[0].blocks.at(0).find("G82"), std::string::npos);
    EXPECT_NE(forms[1].blocks.at(0).find("G81"), std::string::npos);
}

}  // namespace
}  // namespace obrys::write
