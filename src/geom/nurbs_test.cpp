#include "geom/nurbs.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <random>

namespace obrys::geom {
namespace {

/// N_i of order k by the recursion of Cox and de Boor, 0/0 = 0: nothing of it is shared with the code under test.
double basis(const std::vector<double>& t, std::size_t i, int k, double u) {
    if (k == 1) {
        const bool last = u == t.back() && t[i + 1] == t.back() && t[i] < t[i + 1];
        return (t[i] <= u && u < t[i + 1]) || last ? 1 : 0;
    }
    const auto order = static_cast<std::size_t>(k);
    double sum = 0;
    if (t[i + order - 1] > t[i]) sum += (u - t[i]) / (t[i + order - 1] - t[i]) * basis(t, i, k - 1, u);
    if (t[i + order] > t[i + 1]) sum += (t[i + order] - u) / (t[i + order] - t[i + 1]) * basis(t, i + 1, k - 1, u);
    return sum;
}

Vec3 by_definition(const Nurbs& c, double u) {
    Vec3 sum;
    double weight = 0;
    for (std::size_t i = 0; i < c.points.size(); ++i) {
        const double w = c.points[i].weight * basis(c.knots, i, c.order, u);
        sum = sum + w * c.points[i].p;
        weight += w;
    }
    return (1 / weight) * sum;
}

struct RandomCurves {
    std::mt19937 engine;
    double in(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine); }
    int whole(int low, int high) { return std::uniform_int_distribution<int>(low, high)(engine); }

    Nurbs curve(int least_order, int most_order, bool equal_weights) {
        Nurbs c;
        c.order = whole(least_order, most_order);
        const int n = c.order + whole(0, 6);
        for (int i = 0; i < n; ++i)
            c.points.push_back(
                {{in(-50, 50), in(-50, 50), in(-50, 50)}, equal_weights ? 2.5 : std::exp(in(-1.5, 1.5))});
        c.knots = clamped_knots(c.points.size(), c.order);
        // Own knots inside, some of them equal, up to order - 1 times.
        const auto k = static_cast<std::size_t>(c.order);
        if (whole(0, 1) == 1) {
            double at = 0;
            int same = 1;
            for (std::size_t i = k; i < c.points.size(); ++i) {
                const bool repeat = at > 0 && same < c.order - 1 && whole(0, 2) == 0;
                same = repeat ? same + 1 : 1;
                if (!repeat) at += in(0.1, 3);
                c.knots[i] = at;
            }
            for (std::size_t i = c.points.size(); i < c.knots.size(); ++i) c.knots[i] = at + 1;
        }
        return c;
    }
};

double largest_distance(const Nurbs& c, const NurbsPieces& p, int steps) {
    double out = 0;
    for (const NurbsPieces::Piece& piece : p.pieces)
        for (int i = 0; i <= steps; ++i) {
            const double t = static_cast<double>(i) / steps;
            out = std::max(
                out, distance(point_at(piece.curve, t), by_definition(c, piece.from + t * (piece.to - piece.from))));
        }
    return out;
}

TEST(Nurbs, BezierPointsGiveTheirCubic) {
    const Cubic c = bezier({0, 0, 0}, {1, 2, 0}, {3, 2, 1}, {4, 0, 1});
    EXPECT_EQ(point_at(c, 0), (Vec3{0, 0, 0}));
    EXPECT_EQ(point_at(c, 1), (Vec3{4, 0, 1}));
    EXPECT_EQ(point_at(c, 0.5), (Vec3{2, 1.5, 0.5}));  // (a + 3 b + 3 c + d) / 8
    EXPECT_EQ(derivative_at(c, 0), (Vec3{3, 6, 0}));
    EXPECT_EQ(derivative_at(c, 1), (Vec3{3, -6, 0}));
    const Cubic q = bezier({0, 0, 0}, {1, 2, 0}, {2, 0, 0});
    EXPECT_EQ(point_at(q, 0.5), (Vec3{1, 1, 0}));
    EXPECT_EQ(q.k3, (Vec3{0, 0, 0}));
    // The same parabola with its degree raised: b' = (a + 2 b) / 3, c' = (2 b + c) / 3.
    const Cubic raised = bezier({0, 0, 0}, {2.0 / 3, 4.0 / 3, 0}, {4.0 / 3, 4.0 / 3, 0}, {2, 0, 0});
    for (const double t : {0.0, 0.3, 0.7, 1.0}) EXPECT_LT(distance(point_at(q, t), point_at(raised, t)), 1e-15);
}

/// k zeros, 1 2 … n - k, k times n - k + 1 for n points, as LinuxCNC makes them for G5.2 L3 with five points.
TEST(Nurbs, ClampedKnots) {
    EXPECT_EQ(clamped_knots(5, 3), (std::vector<double>{0, 0, 0, 1, 2, 3, 3, 3}));
    EXPECT_EQ(clamped_knots(4, 4), (std::vector<double>{0, 0, 0, 0, 1, 1, 1, 1}));
    EXPECT_EQ(clamped_knots(2, 2), (std::vector<double>{0, 0, 1, 1}));
    EXPECT_TRUE(clamped_knots(2, 3).empty());
    EXPECT_TRUE(clamped_knots(3, 1).empty());
}

TEST(Nurbs, DeBoorIsTheDefinition) {
    for (unsigned seed = 1; seed <= 300; ++seed) {
        SCOPED_TRACE(seed);
        RandomCurves r{std::mt19937(seed)};
        const Nurbs c = r.curve(2, 6, seed % 2 == 0);
        ASSERT_TRUE(is_valid(c));
        const double end = c.knots.back();
        for (int i = 0; i <= 20; ++i) {
            const double u = std::min(end, end * i / 20);
            EXPECT_LT(distance(point_at(c, u), by_definition(c, u)), 1e-10) << u;
        }
        EXPECT_LT(distance(point_at(c, -1), c.points.front().p), 1e-12);
        EXPECT_LT(distance(point_at(c, end + 1), c.points.back().p), 1e-12);
    }
}

/// Equal weights and order 2 to 4: the pieces are the curve, whatever tolerance is asked for.
TEST(Nurbs, PolynomialPiecesAreTheCurve) {
    for (unsigned seed = 1; seed <= 300; ++seed) {
        SCOPED_TRACE(seed);
        RandomCurves r{std::mt19937(seed)};
        const Nurbs c = r.curve(2, 4, true);
        const auto p = cubic_pieces(c, 1000);
        ASSERT_TRUE(p);
        EXPECT_EQ(p->deviation, 0);
        EXPECT_LE(p->pieces.size(), c.points.size());
        EXPECT_LT(largest_distance(c, *p, 16), 1e-11);
        EXPECT_EQ(p->pieces.front().from, 0);
        EXPECT_EQ(p->pieces.back().to, c.knots.back());
        for (std::size_t i = 1; i < p->pieces.size(); ++i) {
            EXPECT_EQ(p->pieces[i].from, p->pieces[i - 1].to);
            EXPECT_LT(distance(point_at(p->pieces[i - 1].curve, 1), p->pieces[i].curve.k0), 1e-12);
        }
    }
}

/// Weights, or a higher order: within what is said, which is within the tolerance; and the tangent goes on.
TEST(Nurbs, OtherPiecesStayWithinTheTolerance) {
    for (unsigned seed = 1; seed <= 200; ++seed) {
        SCOPED_TRACE(seed);
        RandomCurves r{std::mt19937(seed)};
        const bool equal = seed % 4 == 0;
        const Nurbs c = r.curve(equal ? 5 : 2, 6, equal);
        const double tolerance = std::pow(10.0, -r.whole(0, 5));
        const auto p = cubic_pieces(c, tolerance);
        ASSERT_TRUE(p);
        EXPECT_LE(p->deviation, tolerance);
        EXPECT_GT(p->deviation, 0);
        EXPECT_LE(largest_distance(c, *p, 12), p->deviation + 1e-11);
        for (std::size_t i = 1; i < p->pieces.size(); ++i) {
            const NurbsPieces::Piece &a = p->pieces[i - 1], &b = p->pieces[i];
            EXPECT_LT(distance(point_at(a.curve, 1), b.curve.k0), 1e-12);
            const bool inside = std::find(c.knots.begin(), c.knots.end(), b.from) == c.knots.end();
            if (!inside) continue;
            EXPECT_LT(angle_between(derivative_at(a.curve, 1), b.curve.k1), 1e-9);
        }
    }
}

/// A quarter circle of radius 20 has the weights 1, cos 45°, 1.
TEST(Nurbs, CircleByWeights) {
    Nurbs c;
    c.order = 3;
    c.points = {{{20, 0, 1}, 1}, {{20, 20, 1}, std::sqrt(0.5)}, {{0, 20, 1}, 1}};
    c.knots = clamped_knots(3, 3);
    std::size_t before = 0;
    for (const double tolerance : {1.0, 1e-2, 1e-4, 1e-6}) {
        const auto p = cubic_pieces(c, tolerance);
        ASSERT_TRUE(p);
        for (const NurbsPieces::Piece& piece : p->pieces)
            for (int i = 0; i <= 50; ++i) {
                const Vec3 q = point_at(piece.curve, i / 50.0);
                EXPECT_LE(std::abs(std::hypot(q.x, q.y) - 20), tolerance);
                EXPECT_DOUBLE_EQ(q.z, 1);
            }
        EXPECT_GE(p->pieces.size(), before);
        // The error falls with the fourth power of the length: a hundredth of it needs the fourth at most.
        if (before > 0) {
            EXPECT_LE(p->pieces.size(), 4 * before);
        }
        before = p->pieces.size();
    }
    EXPECT_LE(before, 64U);
}

/// G5.2 P1 L4, X10 Y20 P1, X30 Y25 P2, X40 Y-5 P1.5, X60 Y10 P1, G5.3 from X0 Y0: points that the preview of LinuxCNC
/// 2.9 takes of it, at i of 75 equal steps of the parameter.
TEST(Nurbs, LinuxcncTakesTheSamePoints) {
    Nurbs c;
    c.order = 4;
    c.points = {{{0, 0, 0}, 1}, {{10, 20, 0}, 1}, {{30, 25, 0}, 2}, {{40, -5, 0}, 1.5}, {{60, 10, 0}, 1}};
    c.knots = clamped_knots(c.points.size(), c.order);
    const auto pieces = cubic_pieces(c, 1e-6);
    ASSERT_TRUE(pieces);
    for (const auto& [i, expected] :
         {std::pair(10, Vec3{9.7961402555, 13.4058167980, 0}), std::pair(25, Vec3{22.6315789474, 20.1315789474, 0}),
          std::pair(40, Vec3{30.2953890490, 16.0960014409, 0}), std::pair(70, Vec3{50.5494505495, 4.4717782218, 0})}) {
        const double u = c.knots.back() * i / 75;
        EXPECT_LT(distance(point_at(c, u), expected), 1e-9) << i;
        for (const NurbsPieces::Piece& p : pieces->pieces)
            if (p.from <= u && u <= p.to) {
                EXPECT_LT(distance(point_at(p.curve, (u - p.from) / (p.to - p.from)), expected), 1e-6) << i;
            }
    }
}

/// Weights are relative: all of them times two is the same curve.
RC_GTEST_PROP(Nurbs, WeightsAreRelative, (unsigned seed)) {
    RandomCurves r{std::mt19937(seed)};
    const Nurbs c = r.curve(2, 5, false);
    Nurbs d = c;
    for (NurbsPoint& p : d.points) p.weight *= 4;
    const auto a = cubic_pieces(c, 0.01), b = cubic_pieces(d, 0.01);
    RC_ASSERT(a && b && a->pieces.size() == b->pieces.size());
    for (std::size_t i = 0; i < a->pieces.size(); ++i) RC_ASSERT(a->pieces[i].curve == b->pieces[i].curve);
}

TEST(Nurbs, TheNumberOfPiecesIsLimited) {
    RandomCurves r{std::mt19937(7)};
    Nurbs c = r.curve(5, 5, false);
    const auto free = cubic_pieces(c, 1e-9), held = cubic_pieces(c, 1e-9, 12);
    ASSERT_TRUE(free && held);
    EXPECT_GT(free->pieces.size(), 12U);
    EXPECT_LE(held->pieces.size(), 12U);
    EXPECT_GT(held->deviation, 1e-9);
    EXPECT_LE(largest_distance(c, *held, 20), held->deviation);
    c.points[2].weight = 1e-12;  // nearly without weight, beside others: the bound stays one
    const auto thin = cubic_pieces(c, 1e-3);
    ASSERT_TRUE(thin);
    EXPECT_LE(largest_distance(c, *thin, 8), thin->deviation + 1e-9);
}

TEST(Nurbs, PointsThatCoincideAndHugeOnes) {
    Nurbs c;
    c.order = 3;
    c.points = {{{1, 2, 3}, 1}, {{1, 2, 3}, 5}, {{1, 2, 3}, 1}};
    c.knots = clamped_knots(3, 3);
    const auto p = cubic_pieces(c, 1e-6);
    ASSERT_TRUE(p);
    ASSERT_EQ(p->pieces.size(), 1U);
    EXPECT_LT(distance(point_at(p->pieces[0].curve, 0.5), {1, 2, 3}), 1e-14);
    for (NurbsPoint& q : c.points) q = {{1e308, -1e308, 0}, 1};
    c.points[1].p = {-1e308, 1e308, 0};
    EXPECT_TRUE(std::isnan(cubic_pieces(c, 1e-6)->deviation));
    c.points[1].weight = 2;
    EXPECT_TRUE(std::isnan(cubic_pieces(c, 1e-6)->deviation));
}

TEST(Nurbs, CurvesThatAreNone) {
    Nurbs good;
    good.order = 3;
    good.points = {{{0, 0, 0}, 1}, {{1, 0, 0}, 1}, {{1, 1, 0}, 1}, {{2, 1, 0}, 1}};
    good.knots = clamped_knots(4, 3);
    EXPECT_TRUE(cubic_pieces(good, 1));
    EXPECT_FALSE(cubic_pieces(good, 0));
    EXPECT_FALSE(cubic_pieces(good, NAN));
    const auto bad = [&](auto change) {
        Nurbs c = good;
        change(c);
        return !is_valid(c) && !cubic_pieces(c, 1);
    };
    EXPECT_TRUE(bad([](Nurbs& c) { c.order = 5; }));
    EXPECT_TRUE(bad([](Nurbs& c) { c.order = 1; }));
    EXPECT_TRUE(bad([](Nurbs& c) { c.order = -3; }));
    EXPECT_TRUE(bad([](Nurbs& c) { c.knots.pop_back(); }));
    EXPECT_TRUE(bad([](Nurbs& c) { c.knots[3] = 9; }));
    EXPECT_TRUE(bad([](Nurbs& c) { c.knots[3] = NAN; }));
    EXPECT_TRUE(bad([](Nurbs& c) { c.knots = {0, 0, 0, 0, 1, 1, 1}; }));
    EXPECT_TRUE(bad([](Nurbs& c) { c.knots = {0, 0, 0, 0, 0, 0, 0}; }));
    EXPECT_TRUE(bad([](Nurbs& c) { c.points[1].weight = 0; }));
    EXPECT_TRUE(bad([](Nurbs& c) { c.points[1].weight = -1; }));
    EXPECT_TRUE(bad([](Nurbs& c) { c.points[1].weight = NAN; }));
    EXPECT_TRUE(bad([](Nurbs& c) { c.points[1].p.z = INFINITY; }));
    EXPECT_TRUE(bad([](Nurbs& c) { c.points.clear(); }));
}

/// A range inside the knots: the curve need not reach its outer points.
TEST(Nurbs, KnotsNeedNotBeClamped) {
    Nurbs c;
    c.order = 4;
    for (int i = 0; i < 6; ++i) c.points.push_back({{10.0 * i, i % 2 == 0 ? 0.0 : 8.0, 0}, 1});
    for (int i = 0; i < 10; ++i) c.knots.push_back(i);
    ASSERT_TRUE(is_valid(c));
    const auto p = cubic_pieces(c, 1);
    ASSERT_TRUE(p);
    ASSERT_EQ(p->pieces.size(), 3U);
    EXPECT_EQ(p->pieces.front().from, 3);
    EXPECT_EQ(p->pieces.back().to, 6);
    EXPECT_LT(largest_distance(c, *p, 20), 1e-12);
}

}  // namespace
}  // namespace obrys::geom
