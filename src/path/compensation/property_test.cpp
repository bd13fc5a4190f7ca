#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "path/arc_input.hpp"
#include "path/corner.hpp"
#include "path/compensation/compensation_testing.hpp"

namespace obrys::path::test {
namespace {

/// rapidcheck runs each property on 100 seeds; 100 contours a seed make 10 000.
constexpr int contours_per_seed = 100;

/// Any 32-bit seed, large ones from the first case on.
Random random_of_seed() {
    return Random(*rc::gen::noShrink(rc::gen::resize(100, rc::gen::arbitrary<std::uint32_t>())));
}

struct Sample {
    std::vector<Element> contour;
    double radius = 0;  ///< signed: positive left
};

/// Lines and arcs whose direction stays within 60 degrees of +x, no shorter than 12 mm, arcs of radius 15 mm and more;
/// a tool of 2 mm at most fits everywhere: elements that are not neighbours are 6 mm apart.
Sample chain(Random& random) {
    const double limit = geom::radians(60);
    Sample s;
    Vec2 p{random.in(-50, 50), random.in(-50, 50)};
    double heading = random.in(-limit, limit);
    for (int i = 2 + random.upto(6); i >= 0; --i) {
        const double length = random.in(12, 40);
        const double end = random.in(-limit, limit);
        const double curvature = (end - heading) / length;
        if (random.upto(1) == 0 || std::abs(curvature) > 1.0 / 15 || std::abs(end - heading) < 0.05) {
            s.contour.push_back(line(p, p + length * rotated({1, 0}, heading)));
        } else {
            const Vec2 centre = p + (1 / curvature) * geom::left_of(rotated({1, 0}, heading));
            s.contour.push_back(arc(p, centre, end - heading));
            heading = end;
        }
        p = s.contour.back().to;
        if (random.upto(3) > 0) heading = random.in(-limit, limit);  // else a tangential transition
    }
    s.radius = random.in(0.1, 2) * (random.upto(1) == 0 ? 1 : -1);
    return s;
}

/// A convex polygon, counter-clockwise, starting amid an edge; with or without equal fillets.
Sample polygon(Random& random) {
    const int n = 3 + random.upto(5);
    std::vector<Vec2> corner;
    for (int i = 0; i < n; ++i)
        corner.push_back(random.in(30, 31) * rotated({1, 0}, 2 * geom::pi * (i + random.in(0, 0.5)) / n));
    double half_edge = 1e9, steepest = 0;
    const auto at = [&](int i) { return corner[static_cast<std::size_t>((i + n) % n)]; };
    for (int i = 0; i < n; ++i) {
        half_edge = std::min(half_edge, 0.5 * geom::distance(at(i), at(i + 1)));
        steepest = std::max(steepest, std::tan(0.5 * turn_between(at(i) - at(i - 1), at(i + 1) - at(i))));
    }
    const double widest = half_edge / steepest;  // the largest fillet or inner tool every edge has room for
    const double fillet = random.upto(1) == 0 ? 0 : random.in(0.1, 0.95) * widest;
    const double room = fillet > 0 ? fillet : 0.9 * widest;
    Sample s;
    s.contour = {line(0.5 * (at(0) + at(1)), at(1))};
    for (int i = 1; i <= n; ++i) {
        Element next = line(at(i), i < n ? at(i + 1) : 0.5 * (at(0) + at(1)));
        const auto rounded = rounding(s.contour.back(), next, fillet);
        if (fillet > 0 && rounded.ok()) {
            s.contour.back() = rounded.first;
            s.contour.push_back(rounded.inserted);
            next = rounded.second;
        }
        s.contour.push_back(next);
    }
    s.radius = random.upto(1) == 0 ? random.in(0.05, 0.99) * room : -random.in(0.1, 40);
    return s;
}

Sample any(Random& random) { return random.upto(1) == 0 ? chain(random) : polygon(random); }

Result compensated(const Sample& s, OuterCorner corner = OuterCorner::arc,
                   Clearance clearance = Clearance::neighbours) {
    Setting setting = left(s.radius);
    setting.clearance = clearance;
    setting.window = 99;
    setting.corner = corner;
    const Element& first = s.contour.front();
    const Vec2 n = geom::left_of(start_direction(first));
    return run(contour_steps(first.from + 3 * s.radius * n, s.contour, setting));
}

/// Distance and side of points along an output.
void check_output(const Sample& s, const Output& o, bool exact) {
    const double r = std::abs(s.radius);
    for (int k = 0; k <= 8; ++k) {
        const Vec2 p = point_at(o.element, k / 8.0);
        const double d = distance_to(s.contour, p);
        RC_ASSERT(d >= r - 1e-9);
        if (exact) RC_ASSERT(d <= r + 1e-9);
        for (const Element& e : s.contour) {
            const Vec2 foot = nearest(e, p);
            const bool inner = geom::distance(foot, e.from) > 1e-6 && geom::distance(foot, e.to) > 1e-6;
            if (!inner || geom::distance(foot, p) > r + 1e-6) continue;
            const Vec2 along = is_arc(e) ? std::copysign(1.0, e.sweep) * geom::left_of(foot - e.centre) : e.to - e.from;
            RC_ASSERT(geom::cross(along, p - foot) * s.radius > 0);
        }
    }
}

RC_GTEST_PROP(compensation_property, KeepsTheRadiusOnItsSideAndHoldsTogether, ()) {
    Random random = random_of_seed();
    for (int i = 0; i < contours_per_seed; ++i) {
        const Sample s = any(random);
        for (const auto corner : {OuterCorner::arc, OuterCorner::intersection}) {
            const Result r = compensated(s, corner);
            RC_ASSERT(r.faults.empty());
            RC_ASSERT(largest_gap(r) <= 1e-9);
            for (std::size_t k = 1; k < r.out.size(); ++k) check_output(s, r.out[k], corner == OuterCorner::arc);
        }
    }
}

RC_GTEST_PROP(compensation_property, MovesAndMirrorsWithTheContour, ()) {
    Random random = random_of_seed();
    for (int i = 0; i < contours_per_seed; ++i) {
        const Sample s = any(random);
        const double angle = random.in(-4, 4), flip = random.upto(1) == 0 ? 1 : -1;
        const Vec2 shift{random.in(-100, 100), random.in(-100, 100)};
        const auto moved = [&](Vec2 p) { return rotated({p.x, flip * p.y}, angle) + shift; };
        const auto moved_element = [&](Element e) {
            e.from = moved(e.from);
            e.to = moved(e.to);
            e.centre = moved(e.centre);
            e.sweep *= flip;
            return e;
        };
        Sample other;
        other.radius = flip * s.radius;
        for (const Element& e : s.contour) other.contour.push_back(moved_element(e));
        const Result a = compensated(s, OuterCorner::intersection), b = compensated(other, OuterCorner::intersection);
        RC_ASSERT(a.out.size() == b.out.size());
        for (std::size_t k = 0; k < a.out.size(); ++k) {
            const Element want = moved_element(a.out[k].element), &have = b.out[k].element;
            RC_ASSERT(a.out[k].kind == b.out[k].kind);
            RC_ASSERT(geom::distance(want.from, have.from) < 1e-8);
            RC_ASSERT(geom::distance(want.to, have.to) < 1e-8);
            RC_ASSERT(std::abs(want.sweep - have.sweep) < 1e-8);
        }
    }
}

RC_GTEST_PROP(compensation_property, LookingFartherChangesNothingWhereTheToolFits, ()) {
    Random random = random_of_seed();
    for (int i = 0; i < contours_per_seed; ++i) {
        const Sample s = any(random);
        for (const auto corner : {OuterCorner::arc, OuterCorner::intersection}) {
            const Result plain = compensated(s, corner);
            for (const auto clearance : {Clearance::reported, Clearance::avoided}) {
                const Result r = compensated(s, corner, clearance);
                RC_ASSERT(r.faults.empty());
                RC_ASSERT(r.out.size() == plain.out.size());
                for (std::size_t k = 0; k < r.out.size(); ++k) {
                    RC_ASSERT(r.out[k].kind == plain.out[k].kind);
                    RC_ASSERT(r.out[k].element.tag == plain.out[k].element.tag);
                    RC_ASSERT(geom::distance(r.out[k].element.to, plain.out[k].element.to) < 1e-9);
                    RC_ASSERT(std::abs(r.out[k].element.sweep - plain.out[k].element.sweep) < 1e-9);
                }
            }
        }
    }
}

RC_GTEST_PROP(compensation_property, RadiusZeroGivesTheContour, ()) {
    Random random = random_of_seed();
    for (int i = 0; i < contours_per_seed; ++i) {
        Sample s = any(random);
        const Result r = run(contour_steps(s.contour.front().from - Vec2{5, 5}, s.contour, left(0)));
        RC_ASSERT(r.faults.empty());
        RC_ASSERT(r.out.size() == s.contour.size() + 1);
        for (std::size_t k = 0; k < s.contour.size(); ++k) {
            const Element& e = r.out[k + 1].element;
            RC_ASSERT(geom::distance(e.from, s.contour[k].from) < 1e-9);
            RC_ASSERT(geom::distance(e.to, s.contour[k].to) < 1e-9);
            RC_ASSERT(std::abs(e.sweep - s.contour[k].sweep) < 1e-12);
            RC_ASSERT(e.tag == k + 1);
        }
    }
}

/// Programs are written to three decimals, so that tangents are never exact: that must not trouble the compensation.
RC_GTEST_PROP(compensation_property, RoundedCoordinatesMakeNoFaults, ()) {
    Random random = random_of_seed();
    const auto rounded = [](Vec2 p) { return Vec2{std::round(p.x * 1000) / 1000, std::round(p.y * 1000) / 1000}; };
    for (int i = 0; i < contours_per_seed; ++i) {
        Sample s = any(random);
        if (std::abs(s.radius) < 0.1) continue;
        for (Element& e : s.contour) {
            e.from = rounded(e.from);
            e.to = rounded(e.to);
            if (!is_arc(e)) continue;
            const auto a = arc_by_centre(e.from, e.to, rounded(e.centre),
                                         e.sweep > 0 ? Sense::counter_clockwise : Sense::clockwise);
            RC_ASSERT(a.ok());
            e.centre = a.centre;
            e.sweep = a.sweep;
        }
        const Result r = compensated(s);
        for (const Fault& f : r.faults) RC_ASSERT(f.reason == Reason::tool_radius_too_large);
        RC_ASSERT(largest_gap(r) <= 1e-9);
        if (!r.faults.empty()) continue;
        for (std::size_t k = 1; k < r.out.size(); ++k)
            RC_ASSERT(distance_to(s.contour, point_at(r.out[k].element, 0.5)) >= std::abs(s.radius) - 2e-3);
    }
}

/// Any input, sensible or not: output is connected, finite, and nothing of the look-ahead is lost.
RC_GTEST_PROP(compensation_property, AnyInputGivesAConnectedPath, ()) {
    Random random = random_of_seed();
    for (int i = 0; i < contours_per_seed; ++i) {
        std::vector<Step> steps;
        Vec2 p{0, 0};
        int event = 0;
        for (int k = 3 + random.upto(12); k >= 0; --k) {
            const int what = random.upto(7);
            Element e = line(p, what == 0 ? p : p + Vec2{random.in(-9, 9), random.in(-9, 9)});
            if (what > 4) e = arc(p, p + Vec2{random.in(-9, 9), random.in(-9, 9)}, random.in(-7, 7));
            e.before = {++event};
            Setting s = left(random.in(-3, 3));
            if (random.upto(9) == 0) s.side = Side::off;
            s.approach = static_cast<Approach>(random.upto(2));
            s.at_end = static_cast<CornerEnd>(random.upto(2));
            s.clearance = static_cast<Clearance>(random.upto(2));
            s.window = static_cast<std::size_t>(random.upto(9));
            s.corner = random.upto(1) == 0 ? OuterCorner::arc : OuterCorner::intersection;
            steps.push_back({e, s});
            p = e.to;
        }
        const Result r = run(steps, static_cast<std::size_t>(1 + random.upto(4)));
        RC_ASSERT(largest_gap(r) <= 1e-6);
        int seen = 0;
        for (const Output& o : r.out)
            for (const int id : o.element.before) RC_ASSERT(id == ++seen);
        RC_ASSERT(seen == event);
        for (const Output& o : r.out) RC_ASSERT(std::isfinite(o.element.to.x) && std::isfinite(o.element.to.y));
    }
}

}  // namespace
}  // namespace obrys::path::test
