#include <gtest/gtest.h>

#include <cstdio>

#include "cycles/contour/contour.hpp"
#include "cycles/mill/milling_testing.hpp"
#include "geom/offset.hpp"
#include "geom/random_cases_testing.hpp"

namespace obrys::cycles {
namespace {

using geom::Contour;
using geom::Vec2;
using geom::Vec3;
using geom::testing::Random;
using testing::milled_levels;
using testing::Move;
using testing::moves_of;
using testing::with;
using Role = cl::CycleRole;

constexpr Vec3 train_start{0, 0, 100};

Situation train_mill(double radius) {
    Situation s;
    s.at = train_start;
    s.tool_radius = radius;
    return s;
}
Demand train_25() {
    return {cl::CycleKind::contour_train,
            {{Role::depth, -7},
             {Role::allowance_side, 0.5},
             {Role::surface, 0},
             {Role::clearance_height, 20},
             {Role::infeed, 3},
             {Role::feed_plunge, 100},
             {Role::feed_mill, 350},
             {Role::direction, 1}}};
}
Expansion run(const Demand& d, double radius, const Contour& c, int side) {
    return expand_contour(d, train_mill(radius), {.area = {}, .train = {c, side}});
}
double distance_to(const std::vector<geom::Edge>& chain, Vec2 p) {
    double d = 1e300;
    for (const geom::Edge& e : chain) d = std::min(d, geom::distance(e, p));
    return d;
}
/// Samples of the milling moves of one level, in order.
std::vector<Vec2> samples_at(const std::vector<Move>& moves, double level) {
    std::vector<Vec2> out;
    for (const Move& m : moves)
        if (!m.rapid && m.from == level && m.to == level) out.insert(out.end(), m.samples.begin(), m.samples.end());
    return out;
}

// Along x, a corner to the left, an arc to the right.
const Contour open_contour{{{{0, 0}}, {{40, 0}}, {{40, 30}, -0.41421356237309503}, {{60, 50}}}, false};

TEST(ContourTrain, OpenOnBothSidesAndInEverySense) {
    for (const int side : {1, -1, 0})
        for (const double sense : {1.0, -1.0, 0.0}) {
            SCOPED_TRACE(::testing::Message() << "side " << side << " sense " << sense);
            const Expansion e = run(with(train_25(), Role::direction, sense), 4, open_contour, side);
            ASSERT_TRUE(e.ok());
            const auto moves = moves_of(e, train_start);
            EXPECT_EQ(milled_levels(moves), (std::set<double>{-3, -6, -7}));
            bool forward = side == 0 || (sense >= 0) == (side > 0);
            for (const double level : {-3.0, -6.0, -7.0}) {
                const auto way = samples_at(moves, level);
                ASSERT_GT(way.size(), 2U);
                for (const Vec2 p : way)
                    EXPECT_NEAR(distance_to(geom::edges(open_contour), p), side == 0 ? 0 : 4.5, 1e-9);
                const Vec2 first{0, side * 4.5};
                EXPECT_LT(geom::distance(forward ? way.front() : way.back(), first), 1e-9);
                if (sense == 0) forward = !forward;
            }
            for (const Move& m : moves) {
                if (m.rapid) {
                    EXPECT_GE(std::min(m.from, m.to), m.vertical() && m.to > m.from ? -7 : 20);
                } else if (m.vertical()) {
                    EXPECT_EQ(m.feed, 100);
                } else {
                    EXPECT_EQ(m.feed, 350);
                }
            }
            EXPECT_EQ(moves.back().to, 20);
        }
}

TEST(ContourTrain, ClosedStartsBesideItsStart) {
    const Contour c{{{{10, 0}}, {{10, 20}}, {{-10, 20}}, {{-10, -20}}, {{10, -20}}}, true};  // counter-clockwise
    for (const int side : {1, -1}) {
        const Expansion e = run(train_25(), 3, c, side);
        ASSERT_TRUE(e.ok());
        const auto way = samples_at(moves_of(e, train_start), -7);
        EXPECT_LT(geom::distance(way.front(), {10 - side * 3.5, 0}), 1e-9);
        EXPECT_LT(geom::distance(way.back(), way.front()), 1e-9);
        for (const Vec2 p : way) {
            EXPECT_NEAR(distance_to(geom::edges(c), p), 3.5, 1e-9);
            EXPECT_EQ(geom::contains({{c}}, p), side > 0);
        }
        EXPECT_GT((way[1].y - way[0].y) * side, 0) << "climb: the tool on the left of its way";
    }
    EXPECT_EQ(milled_levels(moves_of(run(train_25(), 3, c, 0), train_start)), (std::set<double>{-3, -6, -7}));
}

TEST(ContourTrain, ApproachesByItsData) {
    for (const double kind : {1.0, 2.0, 3.0}) {
        Demand d = with(with(train_25(), Role::approach, kind), Role::approach_radius, 6);
        d = with(with(d, Role::approach_angle, 90), Role::auxiliary_distance, 5);
        const Expansion e = run(d, 4, open_contour, 1);
        ASSERT_TRUE(e.ok()) << kind;
        const auto way = samples_at(moves_of(e, train_start), -7);
        for (const Vec2 p : way) EXPECT_GE(distance_to(geom::edges(open_contour), p), 4.5 - 1e-6);
        const Vec2 from = kind == 1 ? Vec2{-6, 10.5} : kind == 2 ? Vec2{-5, 4.5} : Vec2{0, 9.5};
        EXPECT_LT(geom::distance(way.front(), from), 1e-9) << kind;
    }
    // Compensation of the data counts: right instead of left.
    const auto way =
        samples_at(moves_of(run(with(train_25(), Role::compensation, 2), 4, open_contour, 1), train_start), -7);
    EXPECT_LT(way.back().y, 0);
}

TEST(ContourTrain, ATooLargeToolNamesThePlace) {
    const auto complaint = [](const Demand& d, double radius, const Contour& c, int side) {
        const Expansion e = run(d, radius, c, side);
        EXPECT_FALSE(e.ok());
        EXPECT_TRUE(e.steps.empty());
        return e.complaints.empty() ? std::string() : e.complaints.front().text;
    };
    // A notch 6 wide: the tool does not get in.
    const Contour notch{{{{0, 0}}, {{20, 0}}, {{20, -10}}, {{26, -10}}, {{26, 0}}, {{50, 0}}}, false};
    EXPECT_TRUE(run(train_25(), 2, notch, 1).ok());
    EXPECT_NE(complaint(train_25(), 3, notch, 1).find("tool radius too large"), std::string::npos);
    EXPECT_NE(complaint(train_25(), 3, notch, 1).find("u 20.000 v -5.000"), std::string::npos);
    // An inner arc smaller than the tool.
    const Contour arc{{{{0, 0}}, {{20, 0}, 0.41421356237309503}, {{23, 3}}, {{23, 20}}}, false};
    EXPECT_TRUE(run(train_25(), 2, arc, 1).ok());
    EXPECT_FALSE(run(train_25(), 4, arc, 1).ok());
    EXPECT_TRUE(run(train_25(), 4, arc, -1).ok());
    const Contour box{{{{0, 0}}, {{9, 0}}, {{9, 9}}, {{0, 9}}}, true};
    EXPECT_NE(complaint(train_25(), 5, box, 1), "");
    EXPECT_NE(complaint(with(train_25(), Role::infeed, 0), 3, open_contour, 1), "");
    EXPECT_NE(complaint(with(train_25(), Role::direction, 5), 3, open_contour, 1), "");
    EXPECT_NE(complaint(with(train_25(), Role::allowance_side, -9), 3, open_contour, 1), "");
    EXPECT_NE(complaint(train_25(), 3, {}, 1), "");
    EXPECT_FALSE(run(train_25(), unknown, open_contour, 1).simulated);
    EXPECT_FALSE(run(with(train_25(), Role::depth, unknown), 3, open_contour, 1).simulated);
}

TEST(ContourTrainRandom, KeepsItsDistanceOrSaysWhereItCannot) {
    constexpr unsigned many = 2000;
    unsigned ok = 0, too_large = 0;
    for (unsigned number = 0; number < many && !HasFailure(); ++number) {
        SCOPED_TRACE(number);
        Random random(number);
        Contour c = geom::testing::lattice_loop(random, 6);
        for (geom::Vertex& v : c.vertices) v.p = 5.0 * v.p;
        c.closed = random.below(2) != 0;
        if (!c.closed) c.vertices.back().bulge = 0;
        const double radius = random.between(0.1, 2);
        const int side = random.below(2) ? 1 : -1;
        const Expansion e = run(train_25(), radius, c, side);
        if (!e.ok()) {
            EXPECT_FALSE(e.complaints.empty());
            ++too_large;
            continue;
        }
        ++ok;
        for (const Move& m : moves_of(e, train_start))
            for (const Vec2 p : m.samples) {
                if (std::min(m.from, m.to) >= 0) break;
                EXPECT_GE(distance_to(geom::edges(c), p), radius + 0.5 - 1e-6);
            }
    }
    std::printf("seeds 0..%u: %u run, %u complained of\n", many - 1, ok, too_large);
    EXPECT_GT(ok, many / 10);
    EXPECT_GT(too_large, many / 10);
}

}  // namespace
}  // namespace obrys::cycles
