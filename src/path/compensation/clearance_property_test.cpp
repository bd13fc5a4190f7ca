/// Random contours with features smaller than the tool. Seeds are printed.

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

#include "path/compensation/compensation_testing.hpp"

namespace obrys::path::test {
namespace {

struct JaggedSample {
    std::vector<Element> contour;
    double radius = 0;  ///< positive: tool left
};

/// From p through a neck into a wider chamber and back; on both sides level ground above the chamber.
std::vector<Vec2> bottle(Random& random, Vec2 p) {
    const double wider = random.in(0.1, 6), neck = random.in(0.1, 12), high = random.in(0.1, 9),
                 deep = random.in(0.1, 9);
    const double a = p.x + wider + 0.1, b = a + neck, top = p.y - high, bottom = top - deep;
    return {{a, p.y},         {a, top}, {a - wider, top}, {a - wider, bottom},   {b + wider, bottom},
            {b + wider, top}, {b, top}, {b, p.y},         {b + wider + 0.1, p.y}};
}

/// A contour that does not meet itself, between straight leads longer than the tool is wide: the graph of a function
/// with teeth, steps, half-round grooves and beads, and bottles hanging from it.
JaggedSample jagged(Random& random) {
    JaggedSample s;
    s.radius = random.in(0.2, 4);
    Vec2 p{-40, 0};
    const auto to = [&](Vec2 q) {
        s.contour.push_back(line(p, q));
        p = q;
    };
    to({0, random.in(-1, 1)});
    for (int i = 1 + random.upto(14); i > 0; --i) {
        const double step = random.in(0.05, 5);
        const int what = random.upto(5);
        if (what == 0) {
            const Vec2 centre = p + Vec2{step, 0};
            s.contour.push_back(arc(p, centre, random.upto(1) == 0 ? pi : -pi));
            p = s.contour.back().to = p + Vec2{2 * step, 0};
        } else if (what == 1) {
            const double bend = random.in(0.1, 1.5) * (random.upto(1) == 0 ? 1 : -1);
            const Vec2 middle = p + Vec2{step, 0};
            const Vec2 centre = middle + (step / std::tan(bend)) * Vec2{0, 1};
            s.contour.push_back(arc(p, centre, 2 * bend));
            p = s.contour.back().to = p + Vec2{2 * step, 0};
        } else if (what == 3 && random.upto(2) == 0) {
            for (const Vec2 q : bottle(random, p)) to(q);
        } else {
            to({p.x + (what == 2 ? 0.01 : step), random.in(-5, 5)});
        }
    }
    to(p + Vec2{40, random.in(-1, 1)});
    return s;
}

Setting setting(const JaggedSample& s, Clearance c, std::size_t window = 99) {
    Setting r = left(s.radius);
    r.clearance = c;
    r.window = window;
    return r;
}

Result compensated(const JaggedSample& s, const Setting& with) {
    return run(contour_steps(s.contour.front().from + Vec2{-1, 3 * s.radius}, s.contour, with));
}

/// Smallest and largest distance of the path, without its approach, to the contour.
std::pair<double, double> distances(const JaggedSample& s, const Result& r) {
    double least = 1e9, most = 0;
    for (std::size_t k = 1; k < r.out.size(); ++k)
        for (int i = 0; i <= 8; ++i) {
            const double d = distance_to(s.contour, point_at(r.out[k].element, i / 8.0));
            least = std::min(least, d);
            most = std::max(most, d);
        }
    return {least, most};
}

TEST(clearance_property, LookAheadKeepsTheRadiusToTheWholeWindow) {
    const std::uint32_t seed = 20251121;
    std::cout << "seed " << seed << '\n';
    Random random(seed);
    int left_out = 0;
    for (int i = 0; i < 10000; ++i) {
        const JaggedSample s = jagged(random);
        const Result avoided = compensated(s, setting(s, Clearance::avoided));
        const Result reported = compensated(s, setting(s, Clearance::reported));
        SCOPED_TRACE(i);
        for (const Fault& f : avoided.faults) ASSERT_TRUE(f.bridged);
        ASSERT_LE(largest_gap(avoided), 1e-9);
        const auto [least, most] = distances(s, avoided);
        ASSERT_GE(least, s.radius - 1e-9);
        ASSERT_LE(most, s.radius + 1e-9);
        left_out += avoided.faults.empty() ? 0 : 1;
        // Without it the same contour is faulty, and only then; cuts of less than 1 um are let pass.
        ASSERT_LE(largest_gap(reported), 1e-9);
        const double deepest = s.radius - distances(s, reported).first;
        if (avoided.faults.empty()) {
            ASSERT_TRUE(reported.faults.empty());
        }
        if (reported.faults.empty()) {
            ASSERT_LE(deepest, 1.001e-3);
        }
        if (!reported.faults.empty() && reported.faults[0].reason == Reason::interference) {
            ASSERT_GT(deepest, 0.0);
        }
        if (!avoided.faults.empty() && deepest > 1.1e-3) {
            ASSERT_FALSE(reported.faults.empty());
        }
    }
    EXPECT_GT(left_out, 5000);
    std::cout << left_out << " of 10000 contours have elements that the tool does not fit into\n";
}

TEST(clearance_property, MovesAndMirrorsWithTheContour) {
    const std::uint32_t seed = 20251122;
    std::cout << "seed " << seed << '\n';
    Random random(seed);
    for (int i = 0; i < 10000; ++i) {
        const JaggedSample s = jagged(random);
        const double angle = random.in(-4, 4), flip = random.upto(1) == 0 ? 1 : -1;
        const Vec2 shift{random.in(-100, 100), random.in(-100, 100)};
        const auto moved = [&](Vec2 p) { return rotated({p.x, flip * p.y}, angle) + shift; };
        const Setting with = setting(s, i % 2 == 0 ? Clearance::avoided : Clearance::reported);
        auto steps = contour_steps({-50, 20}, s.contour, with);
        const Result a = run(steps);
        for (Step& step : steps) {
            step.e.from = moved(step.e.from);
            step.e.to = moved(step.e.to);
            step.e.centre = moved(step.e.centre);
            step.e.sweep *= flip;
            if (flip < 0) step.s.side = Side::right;
        }
        const Result b = run(steps);
        SCOPED_TRACE(i);
        ASSERT_EQ(a.out.size(), b.out.size());
        ASSERT_EQ(a.faults.size(), b.faults.size());
        for (std::size_t k = 0; k < a.out.size(); ++k) {
            ASSERT_EQ(a.out[k].kind, b.out[k].kind);
            ASSERT_LE(geom::distance(moved(a.out[k].element.to), b.out[k].element.to), 1e-6);
        }
        for (std::size_t k = 0; k < a.faults.size(); ++k) {
            ASSERT_EQ(a.faults[k].reason, b.faults[k].reason);
            ASSERT_EQ(a.faults[k].tag, b.faults[k].tag);
        }
    }
}

/// A star-shaped closed contour, counter-clockwise, from the middle of an edge on; pocket (left) or island (right).
JaggedSample star(Random& random) {
    const int n = 4 + random.upto(20);
    std::vector<Vec2> corner;
    for (int i = 0; i < n; ++i)
        corner.push_back(random.in(8, 40) * rotated({1, 0}, 2 * pi * (i + random.in(0.05, 0.95)) / n));
    const Vec2 middle = 0.5 * (corner.front() + corner.back());
    corner.insert(corner.begin(), middle);
    corner.push_back(middle);
    return {polyline(corner), random.in(0.2, 8) * (random.upto(1) == 0 ? 1 : -1)};
}

TEST(clearance_property, LookAheadGoesRoundClosedContours) {
    const std::uint32_t seed = 20251124;
    std::cout << "seed " << seed << '\n';
    Random random(seed);
    int tried = 0, left_out = 0;
    for (int i = 0; i < 10000; ++i) {
        const JaggedSample s = star(random);
        const double radius = std::abs(s.radius);
        const Vec2 start = s.contour.front().from + s.radius * geom::left_of(start_direction(s.contour.front()));
        if (distance_to(s.contour, start) < radius - 1e-9) continue;  // the tool has no room there
        ++tried;
        SCOPED_TRACE(i);
        auto steps = contour_steps(start, s.contour, setting(s, Clearance::avoided));
        steps.push_back({line(s.contour.front().from, start), {}});
        const Result r = run(steps);
        for (const Fault& f : r.faults) ASSERT_TRUE(f.bridged);
        left_out += r.faults.empty() ? 0 : 1;
        ASSERT_LE(largest_gap(r), 1e-9);
        ASSERT_LE(geom::distance(r.out.back().element.to, start), 1e-9);
        for (const Output& o : r.out)
            for (int k = 0; k <= 8; ++k) {
                const double d = distance_to(s.contour, point_at(o.element, k / 8.0));
                ASSERT_GE(d, radius - 1e-9);
                ASSERT_LE(d, radius + 1e-9);
            }
    }
    std::cout << left_out << " of " << tried << " contours have elements that the tool does not fit into\n";
    EXPECT_GT(tried, 5000);
    EXPECT_GT(left_out, 1000);
}

/// A window that sees one element only never crosses over; one that sees all gives the same path as any that sees
/// enough.
TEST(clearance_property, ALargerWindowLeavesNoMoreFaults) {
    const std::uint32_t seed = 20251123;
    std::cout << "seed " << seed << '\n';
    Random random(seed);
    for (int i = 0; i < 2000; ++i) {
        const JaggedSample s = jagged(random);
        const std::size_t all = s.contour.size();
        const Result whole = compensated(s, setting(s, Clearance::avoided, all)),
                     more = compensated(s, setting(s, Clearance::avoided, all + 50));
        ASSERT_EQ(whole.out.size(), more.out.size());
        ASSERT_EQ(whole.faults, more.faults);
        for (const std::size_t n : {0U, 1U, 2U, 5U}) {
            const Result r = compensated(s, setting(s, Clearance::avoided, n));
            ASSERT_LE(largest_gap(r), 1e-9);
            for (const Output& o : r.out) ASSERT_TRUE(std::isfinite(o.element.to.x) && std::isfinite(o.element.sweep));
        }
    }
}

}  // namespace
}  // namespace obrys::path::test
