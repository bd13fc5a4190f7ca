#pragma once
/// Shared by the tests of this folder: running the stage, distances computed independently of it, random contours.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "path/compensation.hpp"

namespace obrys::path::test {

using geom::pi;
using geom::Vec2;

inline void expect_point(Vec2 actual, Vec2 expected, double tolerance = 1e-9) {
    EXPECT_NEAR(actual.x, expected.x, tolerance);
    EXPECT_NEAR(actual.y, expected.y, tolerance);
}
inline void expect_near(Vec2 actual, Vec2 expected, double tolerance = 1e-9) {
    EXPECT_NEAR(geom::distance(actual, expected), 0, tolerance) << actual.x << ' ' << actual.y;
}

struct Result {
    std::vector<Output> out;
    std::vector<Fault> faults;
};

struct Step {
    Element e;
    Setting s;
};

inline Result run(const std::vector<Step>& steps, std::size_t look_ahead = 3) {
    Result r;
    Compensation c(look_ahead);
    const auto sink = [&r](const Output& o) { r.out.push_back(o); };
    const auto keep = [&r](const std::vector<Fault>& f) { r.faults.insert(r.faults.end(), f.begin(), f.end()); };
    for (const Step& s : steps) keep(c.push(s.e, s.s, sink));
    keep(c.flush(sink));
    return r;
}

inline Setting left(double radius) { return {.side = Side::left, .radius = radius}; }
inline Setting right(double radius) { return {.side = Side::right, .radius = radius}; }

/// Approach from `from`, the contour under `s`, and no retract.
inline std::vector<Step> contour_steps(Vec2 from, const std::vector<Element>& contour, const Setting& s) {
    std::vector<Step> steps{{line(from, contour.front().from), s}};
    for (std::size_t i = 0; i < contour.size(); ++i) {
        steps.push_back({contour[i], s});
        steps.back().e.tag = i + 1;
    }
    return steps;
}

inline std::vector<Element> polyline(const std::vector<Vec2>& p) {
    std::vector<Element> e;
    for (std::size_t i = 1; i < p.size(); ++i) e.push_back(line(p[i - 1], p[i]));
    return e;
}

/// Nearest point of an element, by its definition.
inline Vec2 nearest(const Element& e, Vec2 p) {
    if (!is_arc(e)) {
        const Vec2 d = e.to - e.from;
        const double t = std::clamp(geom::dot(p - e.from, d) / geom::dot(d, d), 0.0, 1.0);
        return e.from + t * d;
    }
    const Vec2 radial = p - e.centre;
    const double radius = geom::distance(e.from, e.centre), along = geom::length(radial);
    double angle = std::atan2(radial.y, radial.x) - std::atan2(e.from.y - e.centre.y, e.from.x - e.centre.x);
    if (e.sweep < 0) angle = -angle;
    angle = std::fmod(angle + 4 * geom::pi, 2 * geom::pi);
    if (along > 0 && angle <= std::abs(e.sweep)) return e.centre + (radius / along) * radial;
    return geom::distance(p, e.from) < geom::distance(p, e.to) ? e.from : e.to;
}

inline double distance_to(const std::vector<Element>& contour, Vec2 p) {
    double best = std::numeric_limits<double>::infinity();
    for (const Element& e : contour) best = std::min(best, geom::distance(p, nearest(e, p)));
    return best;
}

/// Largest gap between the end of an output and the start of the next.
inline double largest_gap(const Result& r) {
    double gap = 0;
    for (std::size_t i = 1; i < r.out.size(); ++i)
        gap = std::max(gap, geom::distance(r.out[i - 1].element.to, r.out[i].element.from));
    return gap;
}

class Random {
public:
    explicit Random(std::uint32_t seed) : engine_(seed) {}
    double in(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine_); }
    int upto(int n) { return std::uniform_int_distribution<int>(0, n)(engine_); }

private:
    std::mt19937 engine_;
};

/// End points and kinds in order.
inline void expect_path(const Result& r, const std::vector<std::pair<Vec2, Kind>>& expected) {
    ASSERT_EQ(r.out.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
        SCOPED_TRACE(i);
        expect_point(r.out[i].element.to, expected[i].first);
        EXPECT_EQ(r.out[i].kind, expected[i].second);
    }
    EXPECT_LE(largest_gap(r), 1e-9);
}

}  // namespace obrys::path::test
