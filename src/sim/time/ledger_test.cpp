/// What is kept in little room: the slowest places, speed over time, chord errors by class.

#include "sim/time/ledger.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "geom/random_cases_testing.hpp"
#include "sim/time/speed_curve.hpp"
#include "sim/time/tolerance_use.hpp"

namespace obrys::sim::time {
namespace {

double all(const std::vector<Spent>& spent) {
    return std::accumulate(spent.begin(), spent.end(), 0.0, [](double s, const Spent& p) { return s + p.seconds; });
}

TEST(Ledger, keeps_all_or_the_slowest_whatever_their_order) {
    geom::testing::Random cases(3);
    const auto random = [&](double a, double b) { return cases.between(a, b); };
    Ledger whole(0), slowest(50);
    std::vector<double> of(400'000, 0.0);
    double sum = 0;
    for (std::uint32_t i = 0; i < of.size(); ++i) {
        const double seconds = random(0, 1) < 0.0001 ? random(5, 6) : random(0, 0.01);
        of[i] = seconds;
        sum += seconds;
        for (Ledger* l : {&whole, &slowest}) l->spend({0, i}, Cause::feed, seconds);
    }
    EXPECT_NEAR(all(whole.finish()), sum, 1e-6);
    std::vector<Spent> kept = slowest.finish();
    EXPECT_FALSE(slowest.is_short());
    EXPECT_LT(kept.size(), 200'000U);
    std::sort(kept.begin(), kept.end(), [](const Spent& a, const Spent& b) { return a.seconds > b.seconds; });
    std::sort(of.rbegin(), of.rend());
    for (std::size_t i = 0; i < 30; ++i) EXPECT_EQ(kept[i].seconds, of[i]);
}

TEST(Ledger, says_that_a_place_was_dropped_that_comes_again) {
    Ledger l(10);
    for (std::uint32_t i = 0; i < 300'000; ++i) l.spend({0, i}, Cause::feed, i == 7 ? 9 : 0.001);
    l.spend({0, 7}, Cause::feed, 1);
    l.spend({0, 400'000}, Cause::feed, 1);
    EXPECT_FALSE(l.is_short());  // that one was kept
    l.spend({0, 5000}, Cause::feed, 1);
    l.spend({0, 400'001}, Cause::feed, 1);
    EXPECT_TRUE(l.is_short());
}

TEST(SpeedCurve, keeps_time_way_and_the_highest_speed) {
    SpeedCurve curve(64);
    double way = 0, seconds = 0;
    for (int i = 0; i < 1000; ++i) {
        const double from = i % 2 == 0 ? 0 : 30, to = i % 2 == 0 ? 30 : 0, t = 0.1 + 0.01 * (i % 7);
        curve.take(t, from, to, {0, static_cast<std::uint32_t>(i)});
        way += 15 * t, seconds += t;
    }
    EXPECT_LE(curve.samples().size(), 64U);
    EXPECT_NEAR(curve.seconds(), seconds, 1e-9);
    EXPECT_NEAR(curve.samples().back().way, way, 1e-6);
    EXPECT_NEAR(curve.step() * static_cast<double>(curve.samples().size()), seconds, curve.step());
    for (const SpeedCurve::Sample& s : curve.samples()) EXPECT_LE(s.high, 30 + 1e-9);
    EXPECT_NEAR(curve.samples()[5].high, 30, 1e-9);
}

TEST(ToleranceUse, chord_errors_lie_below_what_is_said_of_them) {
    geom::testing::Random cases(4);
    const auto random = [&](double a, double b) { return cases.between(a, b); };
    ToleranceUse use{0.005};
    std::vector<double> errors;
    for (int i = 0; i < 5000; ++i) {
        errors.push_back(std::exp(random(std::log(1e-5), std::log(0.1))));
        use.take(errors.back());
    }
    std::sort(errors.begin(), errors.end());
    const double said = use.error_of(0.95), true_one = errors[static_cast<std::size_t>(0.95 * 5000)];
    EXPECT_GE(said, true_one * 0.99);
    EXPECT_LE(said, true_one * 1.45);
    EXPECT_EQ(use.coarse, static_cast<std::uint64_t>(
                              std::count_if(errors.begin(), errors.end(), [](double e) { return e > 0.005; })));
}

}  // namespace
}  // namespace obrys::sim::time
