#include "check/group.hpp"

#include <gtest/gtest.h>

#include "base/codes.hpp"
#include "check/collect.hpp"

namespace obrys::check {
namespace {

Finding gouge(std::uint32_t at, std::uint64_t move, double depth, std::string cause = {}) {
    Finding f;
    f.code = base::codes::gouge;
    f.where = {0, at, at + 1};
    f.move = move;
    f.amounts = {{"depth_mm", depth}};
    f.cause = std::move(cause);
    return f;
}

TEST(Groups, AreOfOneCodeLineAndCall) {
    Result r;
    r.findings = {gouge(1, 2, 0.1), gouge(9, 3, 1), gouge(1, 4, 0.3), gouge(1, 5, 0.2), gouge(1, 6, 9)};
    r.findings[3].code = base::codes::allowance_cut;
    r.findings[4].stack = {{0, 20, 21}};
    const auto groups = groups_of(r);
    ASSERT_EQ(groups.size(), 4u);
    EXPECT_EQ(groups[0].members, (std::vector<std::size_t>{0, 2}));
    EXPECT_EQ(groups[0].worst, 2u);
    EXPECT_EQ(groups[0].times, 2u);
    EXPECT_EQ(groups[0].first_move, 2u);
}

TEST(Groups, AnOwnCauseCountsMoreThanTheLine) {
    Result r;
    r.findings = {gouge(1, 2, 0.1, "tool 1 holder"), gouge(9, 3, 1, "tool 1 holder"), gouge(9, 4, 1, "tool 2 holder")};
    EXPECT_EQ(groups_of(r).size(), 2u);
}

/// However many moves there are, number, worst and first one of a cause are exact, and memory is bounded.
TEST(Groups, PastTheLimitMovesAreCountedAndTheWorstIsKept) {
    const cl::CallStacks stacks;
    Collector out(stacks, 10);
    const cl::Record record{cl::Linear{}, {0, 5, 6}, 0};
    for (std::uint64_t i = 0; i < 1000; ++i) out.finding(record, gouge(5, 100 + i, i == 700 ? 7 : 1));
    out.finding(record, gouge(6, 5000, 3));
    const Result& r = out.result();
    EXPECT_LE(r.findings.size(), 13u);
    const auto groups = groups_of(r);
    ASSERT_EQ(groups.size(), 2u);
    EXPECT_EQ(groups[0].times, 1000u);
    EXPECT_EQ(groups[0].first_move, 100u);
    EXPECT_EQ(r.findings[groups[0].worst].move, 800u);
    EXPECT_EQ(groups[1].times, 1u);
    EXPECT_EQ(r.findings_dropped, 0u);
}

TEST(Groups, CausesPastTheLimitAreCountedOnly) {
    const cl::CallStacks stacks;
    Collector out(stacks, 10);
    for (std::uint32_t i = 0; i < 25; ++i) out.finding(cl::Record{cl::Linear{}, {0, i, i + 1}, 0}, gouge(i, i, 1));
    EXPECT_EQ(groups_of(out.result()).size(), 10u);
    EXPECT_EQ(out.result().findings_dropped, 15u);
}

}  // namespace
}  // namespace obrys::check
