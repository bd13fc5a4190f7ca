#include <gtest/gtest.h>

#include "base/codes.hpp"
#include "check/result.hpp"

namespace obrys::check {
namespace {

base::Diagnostic diagnostic(std::string_view code, std::uint32_t at, std::string text = "text") {
    return {base::Severity::error, code, {0, at, at + 1}, std::move(text), "remedy", {}, {}};
}

TEST(Merge, EveryKindOfCodeGoesToItsList) {
    base::Diagnostics d;
    d.add(diagnostic(base::codes::arithmetic, 1));
    d.add(diagnostic(base::codes::unknown_word, 2));
    d.add(diagnostic(base::codes::assumption, 3));
    d.add(diagnostic(base::codes::no_effect, 4));
    d.add(diagnostic(base::codes::file_missing, 5));
    Result r;
    r.findings.push_back({});
    merge(r, d);
    ASSERT_EQ(r.findings.size(), 2u);
    EXPECT_EQ(r.findings[0].code, base::codes::arithmetic);  // what the program did wrong comes first
    EXPECT_EQ(r.findings[0].remedy, "remedy");
    EXPECT_EQ(r.unchecked.size(), 2u);
    EXPECT_EQ(r.assumptions.size(), 1u);
    EXPECT_EQ(r.listed.size(), 1u);
    EXPECT_EQ(r.verdict, Verdict::not_fully_checked);
}

TEST(Merge, TheVerdictFollows) {
    Result r;
    base::Diagnostics nothing;
    merge(r, nothing);
    EXPECT_EQ(r.verdict, Verdict::clean);
    base::Diagnostics d;
    d.add(diagnostic(base::codes::no_effect, 4));
    merge(r, d);
    EXPECT_EQ(r.verdict, Verdict::clean);
    base::Diagnostics alarm;
    alarm.add(diagnostic(base::codes::program_alarm, 4));
    merge(r, alarm);
    EXPECT_EQ(r.verdict, Verdict::findings);
}

TEST(Merge, RepetitionsAreCounted) {
    base::Diagnostics d;
    for (std::uint32_t i = 0; i < 3; ++i) d.add(diagnostic(base::codes::no_effect, i, "G64 is accepted"));
    for (std::uint32_t i = 0; i < 3; ++i) d.add(diagnostic(base::codes::unknown_word, i / 2, "FOO"));
    Result r;
    merge(r, d);
    ASSERT_EQ(r.listed.size(), 1u);
    EXPECT_EQ(r.listed[0].times, 3u);
    ASSERT_EQ(r.unchecked.size(), 2u);  // two places
    EXPECT_EQ(r.unchecked[0].times, 2u);
}

TEST(Merge, DroppedComplaintsAreNotForgotten) {
    base::Diagnostics d;
    d.set_limit_per_code(1);
    d.add(diagnostic(base::codes::arithmetic, 1));
    d.add(diagnostic(base::codes::arithmetic, 2));
    Result r;
    merge(r, d);
    EXPECT_EQ(r.verdict, Verdict::not_fully_checked);
}

}  // namespace
}  // namespace obrys::check
