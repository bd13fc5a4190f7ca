#include "base/whole.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace obrys::base {
namespace {

constexpr double huge = 1e300, infinity = std::numeric_limits<double>::infinity();
const double nan = std::nan("");

TEST(Whole, CutsTowardZeroWithinItsType) {
    EXPECT_EQ(cut<int>(2.9), 2);
    EXPECT_EQ(cut<int>(-2.9), -2);
    EXPECT_EQ(cut<int>(2147483647.9), 2147483647);
    EXPECT_EQ(cut<int>(-2147483648.9), -2147483647 - 1);
    EXPECT_EQ(cut<std::uint32_t>(4294967295.0), 4294967295U);
    EXPECT_EQ(cut<std::uint32_t>(-0.5), 0U);
    EXPECT_EQ(cut<std::int64_t>(9223372036854774784.0), 9223372036854774784);
    EXPECT_EQ(cut<std::size_t>(4611686018427387904.0), 4611686018427387904U);
    EXPECT_EQ(cut<char>(65.0), 'A');
}

TEST(Whole, NothingWhereItDoesNotFit) {
    for (const double v : {2147483648.0, -2147483649.0, huge, -huge, infinity, -infinity, nan})
        EXPECT_EQ(cut<int>(v), std::nullopt) << v;
    for (const double v : {-1.0, 4294967296.0, huge, nan}) EXPECT_EQ(cut<std::uint32_t>(v), std::nullopt) << v;
    for (const double v : {9223372036854775808.0, -9223372036854777856.0, huge, nan})
        EXPECT_EQ(cut<std::int64_t>(v), std::nullopt) << v;
    for (const double v : {-1.0, huge, nan}) EXPECT_EQ(cut<std::size_t>(v), std::nullopt) << v;
    EXPECT_EQ(cut<int>(10.0, 0, 9), std::nullopt);
    EXPECT_EQ(cut<int>(-1.0, 0, 9), std::nullopt);
}

TEST(Whole, AWholeNumberHasNoFraction) {
    EXPECT_EQ(whole<int>(9.0, 1, 9), 9);
    EXPECT_EQ(whole<int>(8.5, 1, 9), std::nullopt);
    EXPECT_EQ(whole<int>(-0.5, 0, 9), std::nullopt);
    EXPECT_EQ(whole<int>(nan, 0, 9), std::nullopt);
    EXPECT_EQ(whole<int>(std::stod(std::string(100, '1'))), std::nullopt);
}

TEST(Whole, ClippedStaysBetweenItsEnds) {
    EXPECT_EQ(clipped<int>(2.9, 0, 9), 2);
    EXPECT_EQ(clipped<int>(huge, 0, 9), 9);
    EXPECT_EQ(clipped<int>(-huge, 0, 9), 0);
    EXPECT_EQ(clipped<int>(infinity, 1, 9), 9);
    EXPECT_EQ(clipped<int>(nan, 1, 9), 1);
    EXPECT_EQ(clipped<std::size_t>(1e30, 0, 7), 7U);
}

}  // namespace
}  // namespace obrys::base
