#pragma once
/// Shared by the tests of this folder: running the compensation, and what it must come to.

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "path/compensation/compensation.hpp"
#include "path/path_testing.hpp"

namespace obrys::path::test {

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
    for (const Step& s : steps) keep(c.push(Element(s.e), s.s, sink));
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

/// Largest gap between the end of an output and the start of the next.
inline double largest_gap(const Result& r) {
    double gap = 0;
    for (std::size_t i = 1; i < r.out.size(); ++i)
        gap = std::max(gap, geom::distance(r.out[i - 1].element.to, r.out[i].element.from));
    return gap;
}

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
