/// Values found again from what they make, and what the measurements cannot tell.

#include "sim/time/fit.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace obrys::sim::time {
namespace {

/// Ramps of known length at two speeds, dwells: T = L/v + v/a + a/j, and a part that only the third decides.
std::vector<std::vector<double>> model(const std::vector<std::vector<double>>& sets) {
    std::vector<std::vector<double>> out;
    for (const std::vector<double>& s : sets) {
        const double v = s[0], a = s[1], dwell = s[2];
        out.push_back({100 / v + v / a, 500 / v + v / a, 2000 / v + v / a + 10 * dwell, 1000 / v + v / a + dwell});
    }
    return out;
}

TEST(Fit, finds_the_values_again) {
    const std::vector<double> truth{250, 1800, 3.5};
    const std::vector<double> seen = model({truth}).front();
    std::vector<Measured> measured;
    for (const double s : seen) measured.push_back({s, 0.002 * s});
    const Fitted f = fit({{150, 1.4}, {1000, 1.4}, {1, 1.4}, {5, 1.4}}, measured, model);
    ASSERT_EQ(f.values.size(), 4U);
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_NEAR(f.values[i].value / truth[i], 1, 0.02) << i;
        EXPECT_EQ(f.values[i].sight, Sight::seen) << i;
    }
    EXPECT_EQ(f.values[3].sight, Sight::not_seen);  // nothing depends on it
    EXPECT_NEAR(f.values[3].value, 5, 1e-9);
    EXPECT_LT(f.singular.back(), 1e-6);
    for (std::size_t i = 0; i < seen.size(); ++i) EXPECT_NEAR(f.predicted[i] / seen[i], 1, 0.004);
}

TEST(Fit, a_single_total_tells_values_apart_no_more_than_it_can) {
    const auto total = [](const std::vector<std::vector<double>>& sets) {
        std::vector<std::vector<double>> out;
        for (const std::vector<double>& s : sets) out.push_back({10 + s[0] + s[1]});
        return out;
    };
    const Fitted f = fit({{5, 1.4}, {5, 1.4}}, {{30, 0.3}}, total);
    EXPECT_NEAR(f.predicted.front(), 30, 0.5);
    EXPECT_EQ(f.values[0].sight, Sight::with_others);
    EXPECT_EQ(f.values[1].sight, Sight::with_others);
    EXPECT_NEAR(f.values[0].value, f.values[1].value, 1e-6);
}

TEST(Fit, eigenvalues_are_those_of_a_matrix_that_is_known) {
    const std::vector<double> e = eigenvalues({{2, 1, 0}, {1, 2, 1}, {0, 1, 2}});
    EXPECT_NEAR(e[0], 2 + std::sqrt(2), 1e-12);
    EXPECT_NEAR(e[1], 2, 1e-12);
    EXPECT_NEAR(e[2], 2 - std::sqrt(2), 1e-12);
}

}  // namespace
}  // namespace obrys::sim::time
