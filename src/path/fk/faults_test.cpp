#include <gtest/gtest.h>

#include "path/fk/fk_testing.hpp"

namespace obrys::path::test {

namespace {

constexpr double inf = std::numeric_limits<double>::infinity();

FkFault fault_of(FkRun& run) {
    run.finish();
    return run.fault.value_or(FkFault{});
}

bool names(const FkFault& f, FkDatum d) { return std::find(f.missing.begin(), f.missing.end(), d) != f.missing.end(); }

}  // namespace

TEST(FkFaults, LineWithoutLengthOrEnd) {
    FkRun run({0, 0});
    run.push(fl(12).angle(30));
    EXPECT_EQ(run.contour.pending(), 1U);
    const FkFault f = fault_of(run);
    EXPECT_EQ(f.reason, FkReason::under_determined);
    EXPECT_EQ(f.tag, 12U);
    EXPECT_EQ(f.missing, (std::vector<FkDatum>{FkDatum::x, FkDatum::y, FkDatum::len}));
}

TEST(FkFaults, ArcWithoutCentre) {
    FkRun run({0, 0});
    run.push(fl(1).to(10, 0)).push(fct(2).r(5).dr(+1)).push(fc(3).to(30, 30).dr(+1));
    const FkFault f = fault_of(run);
    EXPECT_EQ(f.reason, FkReason::under_determined);
    EXPECT_EQ(f.tag, 2U);
    EXPECT_TRUE(names(f, FkDatum::x));
    EXPECT_TRUE(names(f, FkDatum::cca));
    EXPECT_FALSE(names(f, FkDatum::r));
    EXPECT_FALSE(names(f, FkDatum::ccx));  // tangent to a known line at a known point, with R: the centre is known
    EXPECT_EQ(run.out.size(), 1U);         // what was determined has come out
}

TEST(FkFaults, ContradictionNamesDatumAndMiss) {
    FkRun run({0, 0});
    run.push(fl(7).to(30, 40).len(50.1));
    ASSERT_TRUE(run.fault);
    EXPECT_EQ(run.fault->reason, FkReason::contradictory);
    EXPECT_EQ(run.fault->tag, 7U);
    EXPECT_EQ(run.fault->datum, FkDatum::len);
    EXPECT_NEAR(run.fault->miss, 0.1, 0.03);
    // Nothing more comes out, and the fault stands.
    run.push(fl(8).to(0, 0));
    EXPECT_TRUE(run.out.empty());
    EXPECT_EQ(run.contour.finish().fault, run.fault);
}

TEST(FkFaults, RedundantDataWithinTheToleranceAreTaken) {
    for (const double by : {-0.9 * fk_tolerance, 0.9 * fk_tolerance}) {
        FkRun run({0, 0});
        run.push(fc(1).cc(10, 0).r(10 + by).dr(-1).to(20, 0)).finish();
        EXPECT_FALSE(run.fault);
    }
    FkRun run({0, 0});
    run.push(fc(1).cc(10, 0).r(10 + 3 * fk_tolerance).dr(-1).to(20, 0));
    ASSERT_TRUE(run.fault);
    EXPECT_EQ(run.fault->reason, FkReason::contradictory);
}

TEST(FkFaults, CircleThatALineMissesByLittleIsTouched) {
    // Y given to three decimals: the true height of the circle is 2 + 10 cos 45 degrees = 9.07106781.
    for (const double y : {9.071, 9.072}) {
        FkRun run({0, 9.072});
        run.push(fl(1).angle(0).to_y(9.072)).push(fc(2).cc(20, 9.072 - 10 + (y - 9.0715)).r(10).dr(+1).to(20, -0.928));
        run.finish();
        ASSERT_TRUE(run.fault || run.out.size() == 2U);
        if (!run.fault) {
            EXPECT_NEAR(run.out[0].to.x, 20, 0.2);
        }
    }
    FkRun run({0, 20});
    run.push(fl(1).angle(0)).push(fc(2).cc(20, 9.9).r(10).dr(+1).to(30, 9.9));
    ASSERT_TRUE(run.fault);
    EXPECT_EQ(run.fault->reason, FkReason::contradictory);
    EXPECT_GT(run.fault->miss, fk_tolerance);
}

TEST(FkFaults, AmbiguityNeedsFselect) {
    FkRun run({0, 0});
    run.push(fl(1).angle(0).to_x(20)).push(fc(2).to(40, 0).r(15).dr(+1));
    EXPECT_EQ(run.out.size(), 1U);
    EXPECT_EQ(run.contour.solutions(), 2U);
    const FkContour before = run.contour;
    const FkFault f = fault_of(run);
    EXPECT_EQ(f.reason, FkReason::ambiguous);
    EXPECT_EQ(f.tag, 2U);
    double lowest = 0, highest = 0;
    for (const std::size_t n : {1U, 2U}) {
        FkRun copy({0, 0});
        copy.contour = before;
        copy.select(n).finish();
        ASSERT_FALSE(copy.fault);
        lowest = std::min(lowest, copy.out[0].centre.y);
        highest = std::max(highest, copy.out[0].centre.y);
    }
    EXPECT_NEAR(highest, std::sqrt(15.0 * 15 - 100), 1e-9);
    EXPECT_NEAR(lowest, -highest, 1e-9);
}

// What follows may settle it as well as FSELECT.
TEST(FkFaults, AmbiguitySettledByTheNextElement) {
    FkRun run({0, 0});
    run.push(fc(2).to(20, 0).r(15).dr(+1));
    EXPECT_TRUE(run.out.empty());
    const double rise =
        std::atan2(10, std::sqrt(125));  // the short arc leaves upwards by the angle whose sine is 10/15
    run.push(flt(3).len(10).angle(geom::degrees(rise))).finish();
    ASSERT_FALSE(run.fault);
    EXPECT_GT(run.out[0].centre.y, 0);
}

TEST(FkFaults, FselectOutOfRange) {
    FkRun run({0, 0});
    run.push(fc(2).to(20, 0).r(15).dr(+1));
    ASSERT_EQ(run.contour.solutions(), 2U);
    for (const std::size_t n : {std::size_t{0}, std::size_t{3}}) {
        FkRun copy({0, 0});
        copy.contour = run.contour;
        copy.select(n);
        ASSERT_TRUE(copy.fault);
        EXPECT_EQ(copy.fault->reason, FkReason::no_such_solution);
        EXPECT_EQ(copy.fault->solutions, 2U);
    }
    const FkFault f = fault_of(run);
    EXPECT_EQ(f.reason, FkReason::ambiguous);
    EXPECT_EQ(f.solutions, 2U);
    EXPECT_EQ(f.tag, 2U);
}

TEST(FkFaults, ValuesThatAreNotKnown) {
    using Member = std::optional<FkValue> FkElement::*;
    const std::vector<std::pair<FkDatum, Member>> values{
        {FkDatum::x, &FkElement::x},     {FkDatum::y, &FkElement::y},       {FkDatum::pr, &FkElement::pr},
        {FkDatum::pa, &FkElement::pa},   {FkDatum::an, &FkElement::an},     {FkDatum::ccx, &FkElement::ccx},
        {FkDatum::ccy, &FkElement::ccy}, {FkDatum::ccpr, &FkElement::ccpr}, {FkDatum::ccpa, &FkElement::ccpa},
        {FkDatum::cca, &FkElement::cca}};
    const auto expect = [](const FkElement& e, FkDatum d) {
        FkRun run({0, 0}, Vec2{1, 0});
        run.push(e).finish();
        ASSERT_TRUE(run.fault);
        EXPECT_EQ(run.fault->reason, FkReason::not_known) << word(d);
        EXPECT_EQ(run.fault->datum, d);
        EXPECT_TRUE(run.out.empty());
    };
    for (const double bad : {not_given, inf, -inf}) {
        for (const auto& [datum, member] : values) {
            Block b = fc(1).dr(+1).to(20, 0).cc(10, 0).about(1, 1);
            b.*member = FkValue{bad};
            expect(b, datum);
        }
        expect(fl(1).to(5, 5).len(bad), FkDatum::len);
        expect(fc(1).to(5, 5).r(bad), FkDatum::r);
        expect(fl(1).to(5, 5).near(1, bad, 2), FkDatum::pd);
        expect(fl(1).to(5, 5).near(1, 2, bad), FkDatum::pd);
        expect(fl(1).to(5, 5).p1(bad, 2), FkDatum::p1);
    }
    FkRun lost({not_given, 0});
    lost.push(fl(1).to(5, 5));
    ASSERT_TRUE(lost.fault);
    EXPECT_EQ(lost.fault->reason, FkReason::not_known);
}

TEST(FkFaults, DataWithoutTheirCompanion) {
    const auto reason = [](const FkElement& e, std::optional<Vec2> direction = {}) {
        FkRun run({0, 0}, direction);
        run.push(fl(1).to(3, 4)).push(e);
        return run.fault ? run.fault->reason : FkReason::ambiguous;
    };
    Block b = fl(2);
    b.on[0].x = 3;
    EXPECT_EQ(reason(b), FkReason::incomplete);
    b = fl(2).to_x(9);
    b.distance = 3;
    EXPECT_EQ(reason(b), FkReason::incomplete);
    b = fl(2).to_x(9);
    b.parallel_distance = 3;
    EXPECT_EQ(reason(b), FkReason::incomplete);
    b = fl(2);
    b.pr = FkValue{3};
    EXPECT_EQ(reason(b), FkReason::incomplete);
    b = fl(2);
    b.parallel = 5;
    EXPECT_EQ(reason(b), FkReason::unknown_block);
    b = fl(2);
    b.x = FkValue{5, FkBase::block, 77};
    EXPECT_EQ(reason(b), FkReason::unknown_block);
    EXPECT_EQ(reason(fl(2).clsd(-1)), FkReason::unknown_block);
    EXPECT_EQ(reason(fl(2).r(5)), FkReason::bad_value);
    EXPECT_EQ(reason(fc(2).r(-5)), FkReason::bad_value);
    EXPECT_EQ(reason(fl(2).to_x(2e6)), FkReason::bad_value);
    FkRun first({0, 0});
    first.push(flt(1).len(10));
    ASSERT_TRUE(first.fault);
    EXPECT_EQ(first.fault->reason, FkReason::no_direction);
}

TEST(FkFaults, TooManyPending) {
    FkRun run({0, 0});
    for (std::uint64_t i = 0; i < 40 && !run.fault; ++i) run.push(fl(i));
    ASSERT_TRUE(run.fault);
    EXPECT_EQ(run.fault->reason, FkReason::too_many_pending);
    EXPECT_EQ(run.fault->tag, fk_most_pending);
}

TEST(FkFaults, ReferencesReachBackOnlySoFar) {
    for (const std::uint64_t back : {std::uint64_t{fk_history}, std::uint64_t{fk_history} + 1}) {
        FkRun run({0, 0});
        for (std::uint64_t i = 1; i <= 100; ++i) run.push(fl(i).to(static_cast<double>(i), static_cast<double>(i % 2)));
        Block b = fl(101).to_y(50);
        b.x = FkValue{3, FkBase::block, 101 - back};
        run.push(b).finish();
        EXPECT_EQ(run.fault.has_value(), back > fk_history);
    }
}

TEST(FkFaults, ConventionalElementsFitIn) {
    FkRun run({0, 0});
    Element l = line({0, 0}, {20, 10}), a = arc({30, 10}, {30, 20}, geom::pi);
    l.tag = 1;
    a.tag = 3;
    run.push(fk_conventional(l)).push(flt(2)).push(fk_conventional(a)).finish();
    ASSERT_TRUE(run.fault);  // the line goes on upwards and does not reach the arc's start, which is where it ends
    FkRun good({0, 0});
    good.push(fk_conventional(l)).push(fl(2).angle(0).to_x(30)).push(fk_conventional(a)).finish();
    ASSERT_FALSE(good.fault);
    ASSERT_EQ(good.out.size(), 3U);
    EXPECT_LT(apart(good.out[2], a), 1e-12);
}

}  // namespace obrys::path::test
