#include "geom/cubic.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

namespace obrys::geom {
namespace {

double any_number() { return *rc::gen::inRange(-20'000, 20'000) / 1000.0; }
Vec3 any_vec() {
    const double x = any_number(), y = any_number(), z = any_number();
    return {x, y, z};
}
Cubic any_cubic() {
    const Vec3 a = any_vec(), b = any_vec(), c = any_vec(), d = any_vec();
    return {a, b, c, d};
}

/// Length by many chords: from below, with an error of the square of the step.
double chords(const Cubic& c, int count) {
    double sum = 0;
    Vec3 last = point_at(c, 0);
    for (int i = 1; i <= count; ++i) {
        const Vec3 p = point_at(c, static_cast<double>(i) / count);
        sum += distance(last, p);
        last = p;
    }
    return sum;
}

TEST(Cubic, LengthsThatAreKnown) {
    EXPECT_NEAR(curve_length(Cubic{{9, 9, 9}, {3, 4, 12}, {}, {}}), 13, 1e-12);
    // y = x^2 over 0..1.
    EXPECT_NEAR(curve_length(Cubic{{}, {1, 0, 0}, {0, 1, 0}, {}}), std::sqrt(5) / 2 + std::asinh(2.0) / 4, 1e-12);
    // x = t^2, y = t^3, Neil's parabola: (13^1.5 - 8) / 27; the speed vanishes at 0.
    EXPECT_NEAR(curve_length(Cubic{{}, {}, {1, 0, 0}, {0, 1, 0}}), (std::pow(13, 1.5) - 8) / 27, 1e-11);
    // There and back along x, turning at 1/3 where the speed is 0.
    EXPECT_NEAR(curve_length(Cubic{{}, {-2, 0, 0}, {3, 0, 0}, {}}), 1.0 / 3 + 4.0 / 3, 1e-9);
    EXPECT_EQ(curve_length(Cubic{{1, 2, 3}, {}, {}, {}}), 0);
    EXPECT_NEAR(curve_length(Cubic{{}, {1e12, 0, 0}, {0, 1e12, 0}, {}}) / 1e12, std::sqrt(5) / 2 + std::asinh(2.0) / 4,
                1e-12);
    EXPECT_TRUE(std::isnan(curve_length(Cubic{{}, {NAN, 0, 0}, {}, {}})));
    EXPECT_TRUE(std::isnan(curve_length(Cubic{{}, {1e308, 0, 0}, {1e308, 0, 0}, {1e308, 0, 0}})));
}

RC_GTEST_PROP(Cubic, LengthAgreesWithChordsAndAddsUp, ()) {
    const Cubic c = any_cubic();
    const double whole = curve_length(c);
    const double two = chords(c, 2000), four = chords(c, 4000);
    RC_ASSERT(four <= whole + 1e-9);
    RC_ASSERT(std::abs(four + (four - two) / 3 - whole) <= 1e-4);
    const double at = *rc::gen::inRange(0, 1001) / 1000.0;
    RC_ASSERT(std::abs(curve_length(c, 0, at) + curve_length(c, at, 1) - whole) <= 2e-9);
    RC_ASSERT(std::abs(curve_length(reversed(c)) - whole) <= 2e-9);
}

RC_GTEST_PROP(Cubic, BoxIsTheSmallest, ()) {
    const Cubic c = any_cubic();
    const Box3 b = box(c);
    Vec3 lo = point_at(c, 0), hi = lo;
    for (int i = 1; i <= 3000; ++i) {
        const Vec3 p = point_at(c, i / 3000.0);
        lo = {std::min(lo.x, p.x), std::min(lo.y, p.y), std::min(lo.z, p.z)};
        hi = {std::max(hi.x, p.x), std::max(hi.y, p.y), std::max(hi.z, p.z)};
    }
    // Between two samples a coordinate rises by |f''| h^2 / 8 at most: 160 / 8 / 9e6.
    const double step = 2.5e-6;
    for (const auto& [outer, inner] : {std::pair{b.hi, hi}, std::pair{-1 * b.lo, -1 * lo}}) {
        RC_ASSERT(outer.x >= inner.x - 1e-12 && outer.x <= inner.x + step);
        RC_ASSERT(outer.y >= inner.y - 1e-12 && outer.y <= inner.y + step);
        RC_ASSERT(outer.z >= inner.z - 1e-12 && outer.z <= inner.z + step);
    }
}

TEST(Cubic, BoxesAtTheEdges) {
    // 4 t (1 - t): top 1 at 1/2; t^3 does not turn at 0; z is not known.
    const Box3 b = box(Cubic{{0, 0, NAN}, {4, 0, 0}, {-4, 0, 0}, {0, 1, 0}});
    EXPECT_EQ(b.lo.x, 0);
    EXPECT_EQ(b.hi.x, 1);
    EXPECT_EQ(b.lo.y, 0);
    EXPECT_EQ(b.hi.y, 1);
    EXPECT_TRUE(std::isnan(b.lo.z) && std::isnan(b.hi.z));
    // Where the squares of the coefficients overflow, and where they vanish.
    for (const double scale : {1e200, 1e-200})
        EXPECT_NEAR(range({0, 4 * scale, -4 * scale, 0}).second / scale, 1, 1e-12);
}

RC_GTEST_PROP(Cubic, ReversedRunsTheOtherWay, ()) {
    const Cubic c = any_cubic();
    for (const double t : {0.0, 0.1, 0.5, 0.9, 1.0}) {
        RC_ASSERT(distance(point_at(reversed(c), t), point_at(c, 1 - t)) <= 1e-12);
        RC_ASSERT(length(derivative_at(reversed(c), t) + derivative_at(c, 1 - t)) <= 1e-11);
    }
}

TEST(Cubic, LeavesAlsoWhereItsSpeedVanishes) {
    EXPECT_EQ(leaving(Cubic{{}, {0, 0, -2}, {1, 0, 0}, {}}), (Vec3{0, 0, -1}));
    EXPECT_EQ(leaving(Cubic{{}, {}, {3, 0, 0}, {0, 1, 0}}), (Vec3{1, 0, 0}));
    EXPECT_EQ(leaving(Cubic{{}, {}, {}, {0, 1e-300, 0}}), (Vec3{0, 1, 0}));
    EXPECT_EQ(leaving(Cubic{{5, 5, 5}, {}, {}, {}}), Vec3{});
}

TEST(Cubic, ParabolaThroughThreePoints) {
    const Vec3 a{1, 2, 3}, b{4, 1, 0}, c{6, 5, -2};
    const Cubic p = parabola(a, b, c);
    EXPECT_LE(distance(point_at(p, 0), a), 1e-15);
    EXPECT_LE(distance(point_at(p, 0.5), b), 1e-15);
    EXPECT_LE(distance(point_at(p, 1), c), 1e-15);
    EXPECT_NEAR(angle_between(derivative_at(p, 0.5), c - a), 0, 1e-12);
}

TEST(Cubic, AnglesBetweenDirections) {
    EXPECT_NEAR(angle_between({1, 0, 0}, {0, 5, 0}), pi / 2, 1e-15);
    EXPECT_NEAR(angle_between({1, 0, 0}, {-1, 1e-9, 0}), pi - 1e-9, 1e-15);
    EXPECT_TRUE(std::isnan(angle_between({1, 0, 0}, {})));
    EXPECT_TRUE(std::isnan(angle_between({1, 0, 0}, {NAN, 1, 0})));
}

}  // namespace
}  // namespace obrys::geom
