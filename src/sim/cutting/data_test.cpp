/// Cutting data follow from each other whichever is left out, and the machine's limits hold.

#include "sim/cutting/data.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <cmath>

#include "sim/cutting/form.hpp"
#include "sim/cutting/law.hpp"

namespace obrys::sim::cutting {
namespace {

double between(double low, double high) { return low + (high - low) * (*rc::gen::inRange(0, 100001)) / 1e5; }

/// All that is known of a cut, from its least data.
Data whole_cut(Asked& a) {
    a[Value::diameter] = between(2, 80);
    a.ball = *rc::gen::arbitrary<bool>();
    a[Value::teeth] = *rc::gen::inRange(1, 9);
    a[Value::speed] = between(100, 20000);
    a[Value::feed_per_tooth] = between(0.005, 0.3);
    a[Value::depth] = a[Value::diameter] * between(0.02, 0.45);
    a.tilt = 0;
    Asked without_width = a;
    a[Value::width] = solve(without_width, {})[Value::effective_diameter] * between(0.02, 1);
    return solve(a, {});
}

RC_GTEST_PROP(CuttingData, any_one_follows_from_the_others, ()) {
    Asked a;
    const Data whole = whole_cut(a);
    for (std::size_t i = 0; i < values; ++i) {
        RC_ASSERT(std::isfinite(whole.values[i]));
        Asked others = a;
        others.given = whole.values;
        others.given[i] = NAN;
        const Data again = solve(others, {});
        RC_ASSERT(again.differences.empty());
        RC_ASSERT(std::abs(again.values[i] - whole.values[i]) <= 1e-6 * whole.values[i]);
    }
}

RC_GTEST_PROP(CuttingData, one_that_contradicts_is_said, ()) {
    Asked a;
    const Data whole = whole_cut(a);
    a.given = whole.values;
    const auto changed = static_cast<std::size_t>(*rc::gen::inRange(0, static_cast<int>(values)));
    a.given[changed] *= 1.05;
    if (a[Value::width] > a[Value::effective_diameter]) return;  // no width of a cut any more
    RC_ASSERT(!solve(a, {}).differences.empty());
}

RC_GTEST_PROP(CuttingData, the_machine_holds, ()) {
    shop::WorkMaterial steel;
    steel.kienzle = shop::KienzleLaw{1500, 0.22, 0, 0, INFINITY, "test"};
    Asked a;
    a.material = &steel;
    const Data free = whole_cut(a);
    MachineLimits limits;
    limits.most_speed = between(100, 20000);
    limits.most_feed = between(10, 5000);
    limits.most_power = between(10, 10000);
    a.material = &steel;
    const Data held = solve(a, limits);
    constexpr double rounding = 1 + 1e-9;
    RC_ASSERT(held[Value::speed] <= limits.most_speed * rounding);
    RC_ASSERT(held[Value::feed] <= limits.most_feed * rounding);
    RC_ASSERT(held.power <= limits.most_power * rounding);
    const bool within = free[Value::speed] <= limits.most_speed && free[Value::feed] <= limits.most_feed &&
                        free.power <= limits.most_power;
    RC_ASSERT(held.clamped_by.empty() == within);
    RC_ASSERT(held[Value::diameter] == free[Value::diameter]);
    RC_ASSERT(held[Value::feed_per_tooth] <= free[Value::feed_per_tooth] * rounding);
}

TEST(CuttingData, what_is_not_given_is_not_known) {
    Asked a;
    a[Value::cutting_speed] = 160;
    a[Value::diameter] = 10;
    const Data d = solve(a, {});
    EXPECT_NEAR(d[Value::speed], 5092.958178940651, 1e-9);
    EXPECT_TRUE(std::isnan(d[Value::feed]));
    EXPECT_TRUE(std::isnan(d.power));
    a.ball = true;  // its effective diameter hangs on the depth
    EXPECT_TRUE(std::isnan(solve(a, {})[Value::speed]));
}

TEST(CuttingData, turning_by_the_text_book) {
    shop::WorkMaterial m;
    m.kienzle = shop::KienzleLaw{1500, 0.22, 0, 0, INFINITY, "test"};
    Asked a;
    a.process = Process::turning;
    a.material = &m;
    a[Value::cutting_speed] = 180;
    a[Value::diameter] = 60;
    a[Value::feed_per_tooth] = 0.3;
    a[Value::depth] = 2;
    a.nose_radius = 0.8;
    const Data d = solve(a, {});
    EXPECT_NEAR(d.power, 3518.8202949683838, 1e-6);  // force.json, turning
    EXPECT_NEAR(d.rz, 14.1, 0.1);                    // f2 / (8 r)
    EXPECT_NEAR(d[Value::feed], 0.3 * d[Value::speed], 1e-9);
}

TEST(CuttingData, a_bull_nose_lies_between_an_end_mill_and_a_ball) {
    EXPECT_DOUBLE_EQ(effective_diameter({10, 0, 0}, 0.5), 10);
    EXPECT_DOUBLE_EQ(effective_diameter({10, 2, 0}, 2), 10);
    EXPECT_NEAR(effective_diameter({10, 2, 0}, 0.5), 6 + 2 * std::sqrt(0.5 * 3.5), 1e-12);
    EXPECT_GT(effective_diameter({10, 2, 0.3}, 0.5), effective_diameter({10, 2, 0}, 0.5));
}

TEST(CuttingLaw, no_chip_no_force) {
    const Law law = linear_law({750, 300, 150, 20, 15, 3, "", ""});
    EXPECT_EQ(force(law, 0).tangential, 0);
    EXPECT_NEAR(force(law, 1e-6).tangential, 20 * 1e-3, 1e-3);  // the edge's part falls with the chip
    EXPECT_NEAR(force(law, 0.1).tangential, 95, 1e-12);
}

}  // namespace
}  // namespace obrys::sim::cutting
