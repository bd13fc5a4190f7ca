/// The functions of C against those of the standard library, which they stand in for.

#include "base/float_chars.hpp"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <random>
#include <string>

#include "base/seed_testing.hpp"

namespace obrys::base {
namespace {

std::string text_of(ToChars (*make)(char*, char*, double, CharsFormat), double v, CharsFormat format) {
    std::array<char, 500> buffer;
    const ToChars made = make(buffer.data(), buffer.data() + buffer.size(), v, format);
    return made.ec == std::errc{} ? std::string(buffer.data(), made.ptr) : "does not fit";
}

void expect_alike(double v) {
    const bool plain = std::abs(v) < 1e15 && std::abs(v) > 1e-7;  // beyond, plain digits are many and not asked for
    for (const CharsFormat format : {CharsFormat::general, CharsFormat::scientific, CharsFormat::fixed}) {
        if (!plain && format == CharsFormat::fixed) continue;
        EXPECT_EQ(text_of(by_c::to_chars, v, format), text_of(to_chars, v, format));
    }
    std::array<char, 500> a, b;
    for (const CharsFormat format : {CharsFormat::fixed, CharsFormat::scientific}) {
        const ToChars x = by_c::to_chars(a.data(), a.data() + a.size(), v, format, 6);
        const ToChars y = to_chars(b.data(), b.data() + b.size(), v, format, 6);
        EXPECT_EQ(std::string(a.data(), x.ptr), std::string(b.data(), y.ptr));
    }
    const std::string text = text_of(to_chars, v, CharsFormat::scientific);
    double read = 0;
    EXPECT_EQ(by_c::from_chars(text.data(), text.data() + text.size(), read, CharsFormat::general).ec, std::errc{});
    EXPECT_EQ(read, v) << text;
}

TEST(FloatChars, WriteAndReadAsTheStandardLibraryDoes) {
    for (const double v :
         {0.0, -0.0, 1.0, 0.1, 1e15, 123456.789, 1e-7, 5e-324, 1.7976931348623157e308, 1e23, 9.5e-5, 100.0})
        expect_alike(v);
    std::mt19937_64 random(testing_seed());
    std::uniform_real_distribution<double> length(-1000, 1000);
    for (int i = 0; i < 20'000; ++i) {
        expect_alike(std::round(length(random) * 1e4) / 1e4);
        const double any = std::bit_cast<double>(random());
        if (std::isfinite(any) && std::abs(any) < 1e15) expect_alike(any);
    }
}

TEST(FloatChars, ReadsWhatBeginsLikeANumber) {
    for (const std::string text : {"1",   "-1.5",  ".5",     "5.",     "-",   ".",        "",
                                   "+1",  " 1",    "1e5",    "1e",     "1e+", "1E-3x",    "1.2.3",
                                   "--1", "1e400", "1e-400", "0e-400", "-0",  "0.0000e5", "12345678901234567890123",
                                   "1x",  "0x10",  "inf",    "-inf",   "nan", "infinity"})
        for (const CharsFormat format : {CharsFormat::general, CharsFormat::fixed}) {
            double a = 7, b = 7;
            const char *first = text.data(), *last = first + text.size();
            const FromChars x = by_c::from_chars(first, last, a, format), y = from_chars(first, last, b, format);
            EXPECT_EQ(x.ptr - first, y.ptr - first) << text;
            EXPECT_EQ(x.ec, y.ec) << text;
            EXPECT_EQ(a, b) << text;
        }
}

TEST(FloatChars, WhatDoesNotFitIsSaid) {
    std::array<char, 3> small;
    EXPECT_EQ(by_c::to_chars(small.data(), small.data() + 3, 1.25, CharsFormat::fixed).ec, std::errc::value_too_large);
    EXPECT_EQ(text_of(by_c::to_chars, std::numeric_limits<double>::infinity(), CharsFormat::general), "inf");
}

TEST(FloatChars, BitsStay) { EXPECT_EQ(bit_cast<std::uint64_t>(1.5), std::bit_cast<std::uint64_t>(1.5)); }

}  // namespace
}  // namespace obrys::base
