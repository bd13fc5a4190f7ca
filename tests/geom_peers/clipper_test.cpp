/// Offsets of random contours held against Clipper's, which knows polygons only: arcs are given to it as chords.

#include <gtest/gtest.h>

#ifdef OBRYS_HAVE_CLIPPER

#include <cstdio>
#include <polyclipping/clipper.hpp>

#include "geom/offset.hpp"
#include "judge.hpp"

namespace obrys::geom {
namespace {

using testing::distance_to;
using testing::judge;
using testing::lattice_loop;
using testing::lattice_region;
using testing::Random;
using testing::turned;
using testing::Verdict;

constexpr unsigned many = 10'000;
constexpr double scale = 1e7;          // Clipper's units a millimetre
constexpr double sagitta_most = 1e-3;  // mm, of chords for arcs: the contour's and Clipper's own
/// Clipper's contour lies within this of the true one: chords of the source, chords of its roundings, rounding of
/// points to its units. (ClipperLib also drops points nearer than 1.415 units.)
constexpr double error = 2 * sagitta_most + 20 / scale;

ClipperLib::Path polygon(const Contour& c) {
    ClipperLib::Path out;
    const auto add = [&](Vec2 p) { out.emplace_back(std::llround(p.x * scale), std::llround(p.y * scale)); };
    const std::vector<Edge> around = edges(c);
    for (const Edge& e : around) {
        int n = 1;
        if (is_arc(e)) {
            const double step = 2 * std::acos(1 - std::min(1.0, sagitta_most / circle(e).radius));
            n = static_cast<int>(std::ceil(std::abs(sweep_angle(e)) / step));
        }
        for (int i = 0; i < n; ++i) add(point_at(e, static_cast<double>(i) / n));
    }
    if (!c.closed && !around.empty()) add(around.back().b);
    return out;
}

ClipperLib::Paths clipper_offset(const std::vector<Contour>& contours, double by, ClipperLib::EndType end) {
    ClipperLib::ClipperOffset offsetter(2, sagitta_most * scale);
    for (const Contour& c : contours) offsetter.AddPath(polygon(c), ClipperLib::jtRound, end);
    ClipperLib::Paths out;
    offsetter.Execute(out, by * scale);
    return out;
}

double area_of(const ClipperLib::Paths& paths) {
    double sum = 0;
    for (const auto& p : paths) sum += ClipperLib::Area(p);
    return sum / (scale * scale);
}

/// Inside an odd number of the paths.
bool inside(const ClipperLib::Paths& paths, Vec2 p) {
    const ClipperLib::IntPoint q(std::llround(p.x * scale), std::llround(p.y * scale));
    bool in = false;
    for (const auto& path : paths) in ^= ClipperLib::PointInPolygon(q, path) != 0;
    return in;
}

struct Totals {
    unsigned cases = 0, points = 0, clipper_wrong = 0;
    double widest = 0;
};

/// Areas must agree within the error, points further than it from the contour must lie alike. Where they do not,
/// Clipper must be wrong at a point whose distance from the source tells, and we at none.
struct Comparison {
    const Region& ours;
    ClipperLib::Paths theirs;
    double least = 0, most = 0;  ///< area, of the true contour moved by the error
    Box around;
    double d = 0;
};

template <class Truth>
void compare(const Comparison& c, Random& random, Truth truth, Totals& totals) {
    ++totals.cases;
    const auto ours = [&](Vec2 p) { return contains(c.ours, p); };
    const auto theirs = [&](Vec2 p) { return inside(c.theirs, p); };
    Box around = c.around;
    around.add(around.lo - Vec2{c.d, c.d});
    around.add(around.hi + Vec2{c.d, c.d});
    const Verdict few = judge(around, 12, random, truth, ours, theirs);
    totals.points += few.points;
    EXPECT_EQ(few.ours_wrong, 0U);
    const double a = area_of(c.theirs);
    if (a >= c.least - 1e-9 && a <= c.most + 1e-9 && few.theirs_wrong == 0) {
        totals.widest = std::max(totals.widest, std::abs(a - area(c.ours)));
        return;
    }
    const Verdict many_points = judge(around, 100'000, random, truth, ours, theirs);
    EXPECT_EQ(many_points.ours_wrong, 0U);
    EXPECT_GT(many_points.theirs_wrong + few.theirs_wrong, 0U)
        << a << " is not between " << c.least << " and " << c.most;
    ++totals.clipper_wrong;
}

void print(const Totals& t) {
    std::printf(
        "seeds 0..%u: %u offsets, %u points; Clipper provably wrong in %u, areas apart by %.2g mm2 at most in the "
        "others\n",
        many - 1, t.cases, t.points, t.clipper_wrong, t.widest);
    EXPECT_LT(t.clipper_wrong, t.cases / 50);
}

constexpr double distances[] = {0.05, 0.4, 0.5, 1, 1.25, 2};

TEST(Clipper, RegionsGrownAndShrunk) {
    Totals totals;
    for (unsigned number = 0; number < many && !HasFailure(); ++number) {
        SCOPED_TRACE(number);
        Random random(number);
        const Region r = turned(lattice_region(random, 6), random.between(0, 6), {});
        const double d = random.below(3) ? random.one_of(distances) : random.between(0.001, 2);
        const double by = number % 2 == 0 ? d : -d;
        const Region ours = offset(r, by);
        const auto theirs = clipper_offset(r.contours, by, ClipperLib::etClosedPolygon);
        // Whatever lies within the error of the true contour lies between two other offsets of ours.
        const std::vector<Edge> source = edges(r);
        const auto truth = [&](Vec2 p) {
            const double from = distance_to(source, p);
            const bool in = contains(r, p);
            if (std::abs(from - d) < 2 * error || from < 2 * error) return -1;
            return (by > 0 ? in || from < d : in && from > d) ? 1 : 0;
        };
        compare({ours, theirs, area(offset(r, by - error)), area(offset(r, by + error)), box(r), d}, random, truth,
                totals);
    }
    print(totals);
}

TEST(Clipper, BandsAboutOpenContours) {
    Totals totals;
    for (unsigned number = 0; number < many && !HasFailure(); ++number) {
        SCOPED_TRACE(number);
        Random random(number);
        Contour c = turned({{lattice_loop(random, 6)}}, random.between(0, 6), {}).contours[0];
        c.closed = false;
        if (edges(c).empty()) continue;
        const double d = random.below(3) ? random.one_of(distances) : random.between(0.01, 2);
        const Region ours = band(c, d);
        const auto theirs = clipper_offset({c}, d, ClipperLib::etOpenRound);
        const std::vector<Edge> source = edges(c);
        const auto truth = [&](Vec2 p) {
            const double from = distance_to(source, p);
            return std::abs(from - d) < 2 * error ? -1 : from < d ? 1 : 0;
        };
        compare({ours, theirs, area(band(c, d - error)), area(band(c, d + error)), box(c), d}, random, truth, totals);
    }
    print(totals);
}

}  // namespace
}  // namespace obrys::geom

#else
TEST(Clipper, RegionsGrownAndShrunk) { GTEST_SKIP() << "needs Clipper (libpolyclipping-dev)"; }
TEST(Clipper, BandsAboutOpenContours) { GTEST_SKIP() << "needs Clipper (libpolyclipping-dev)"; }
#endif
