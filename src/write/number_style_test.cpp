#include "write/number_style.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace obrys::write {
namespace {

std::string written(double v, const NumberStyle& style) {
    std::string out;
    return append_number(out, v, style) ? out : "no";
}

TEST(NumberStyle, ZerosAtTheEndAndThePoint) {
    NumberStyle plain;
    EXPECT_EQ(written(10, plain), "10");
    EXPECT_EQ(written(-0.5, plain), "-0.5");
    EXPECT_EQ(written(1.23456, plain), "1.235");
    EXPECT_EQ(written(-0.0001, plain), "0");
    NumberStyle point{.decimals = 4, .point = true};
    EXPECT_EQ(written(10, point), "10.");
    EXPECT_EQ(written(0.25, point), "0.25");
    NumberStyle tenth{.decimals = 4, .least = 1, .point = true};
    EXPECT_EQ(written(10, tenth), "10.0");
    EXPECT_EQ(written(0.25, tenth), "0.25");
    NumberStyle whole{.decimals = 0, .point = true};
    EXPECT_EQ(written(7, whole), "7.");
}

TEST(NumberStyle, SignsDigitsAndFactors) {
    NumberStyle plus{.decimals = 4, .plus = true};
    EXPECT_EQ(written(0, plus), "+0");
    EXPECT_EQ(written(-0.00001, plus), "+0");
    EXPECT_EQ(written(-3.5, plus), "-3.5");
    NumberStyle two{.decimals = 0, .digits = 2};
    EXPECT_EQ(written(5, two), "05");
    EXPECT_EQ(written(12, two), "12");
    NumberStyle diameter{.decimals = 4, .factor = 2};
    EXPECT_EQ(written(30.25, diameter), "60.5");
}

TEST(NumberStyle, WhatAWordCannotHoldIsRefused) {
    NumberStyle plain;
    EXPECT_EQ(written(1e6, plain), "no");
    EXPECT_EQ(written(NAN, plain), "no");
    EXPECT_EQ(written(INFINITY, plain), "no");
    NumberStyle feed{.at_rapid = "FMAX"};
    EXPECT_EQ(written(INFINITY, feed), "FMAX");
    EXPECT_EQ(written(-INFINITY, feed), "no");
}

TEST(NumberStyle, TheValueThatIsWritten) {
    EXPECT_DOUBLE_EQ(as_written(1.23456, {.decimals = 3}), 1.235);
    EXPECT_DOUBLE_EQ(as_written(1.00026, {.decimals = 3, .factor = 2}), 1.0005);
    EXPECT_TRUE(std::isnan(as_written(NAN, {})));
}

}  // namespace
}  // namespace obrys::write
