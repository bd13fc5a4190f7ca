#include "cycles/contour/contour.hpp"

#include <gtest/gtest.h>

#include <cstdio>

#include "cycles/mill/milling_testing.hpp"
#include "cycles/shapes.hpp"
#include "geom/boolean.hpp"
#include "geom/offset.hpp"
#include "geom/random_cases_testing.hpp"

namespace obrys::cycles {
namespace {

using geom::Contour;
using geom::Region;
using geom::Vec2;
using geom::Vec3;
using geom::testing::Random;
using testing::covered;
using testing::expect_sound;
using testing::milled_levels;
using testing::Move;
using testing::moves_of;
using testing::with;
using Kind = cl::CycleKind;
using Role = cl::CycleRole;

constexpr Vec3 contour_start{0, 0, 100};

Situation contour_mill(double radius) {
    Situation s;
    s.at = contour_start;
    s.tool_radius = radius;
    s.tool_plunge_angle = 4;
    return s;
}

/// Data of 20, then those of the machining cycles; a value added later counts.
Demand demand(Kind kind) {
    return {kind,
            {{Role::depth, -9},
             {Role::overlap, 1},
             {Role::allowance_side, 0.3},
             {Role::allowance_floor, 0.2},
             {Role::surface, 5},
             {Role::clearance, 2},
             {Role::clearance_height, 50},
             {Role::rounding_radius, 0},
             {Role::direction, 1},
             {Role::infeed, 4},
             {Role::feed_plunge, 120},
             {Role::feed_mill, 400},
             {Role::coarse_tool, 0},
             {Role::feed_reciprocate, 0},
             {Role::feed_retract, 0},
             {Role::allowance_left, 0}}};
}

Region plate() {
    // A pocket with a round and a square island.
    return geom::subtract(
        geom::subtract({{placed(rectangle(100, 70, 10), 0, {0, 0})}}, {{placed(disc(12), 0, {-20, 5})}}),
        {{placed(rectangle(15, 20, 0), 0.3, {25, -5})}});
}

void expect_covers(const std::vector<Move>& moves, const Region& region, double side, double radius, double height,
                   double step) {
    const geom::Box b = geom::box(region);
    const Region reach = geom::offset(geom::offset(region, -radius - side), radius);
    for (double u = b.lo.x + 0.03; u < b.hi.x; u += step)
        for (double v = b.lo.y + 0.07; v < b.hi.y; v += step)
            if (geom::contains(reach, {u, v})) {
                EXPECT_TRUE(covered(moves, {u, v}, radius, height)) << u << ' ' << v << " at " << height;
            }
}

TEST(Contours, ClassifiedByRunAndSide) {
    const Contour ccw = rectangle(10, 10, 0), cw = geom::reversed(ccw);
    EXPECT_EQ(classify(cw, -1), Subcontour::pocket);
    EXPECT_EQ(classify(ccw, 1), Subcontour::pocket);
    EXPECT_EQ(classify(cw, 1), Subcontour::island);
    EXPECT_EQ(classify(ccw, -1), Subcontour::island);
    EXPECT_EQ(classify(ccw, 0), std::nullopt);
    Contour open = ccw;
    open.closed = false;
    EXPECT_EQ(classify(open, 1), std::nullopt);
    EXPECT_EQ(classify({}, 1), std::nullopt);
    const Region r = area_of({{cw, Subcontour::pocket},
                              {geom::moved(ccw, {5, 0}), Subcontour::pocket},
                              {placed(disc(2), 0, {2, 0}), Subcontour::island}});
    EXPECT_NEAR(geom::area(r), 150 - geom::pi * 4, 1e-9);
}

TEST(RoughOut, PocketWithIslands) {
    const Region region = plate();
    const Expansion e = expand_contour(demand(Kind::rough_out), contour_mill(5), {.area = region, .train = {}});
    ASSERT_TRUE(e.ok());
    EXPECT_FALSE(e.assumption.empty());
    const auto moves = moves_of(e, contour_start);
    expect_sound(moves, region, {.surface = 5, .bottom = -3.8, .plunge = 120, .mill = 400, .away = 5.3});
    EXPECT_EQ(milled_levels(moves), (std::set<double>{1, -3, -3.8}));
    for (const double level : {1.0, -3.0, -3.8}) expect_covers(moves, region, 0.3, 5, level, 1.3);
    EXPECT_EQ(moves.back().to, 50);
}

TEST(RoughOut, PlungesByHelixWhereThereIsRoom) {
    const Demand d = with(demand(Kind::rough_out), Role::feed_reciprocate, 90);
    const Expansion e = expand_contour(d, contour_mill(5), {.area = plate(), .train = {}});
    ASSERT_TRUE(e.ok());
    const auto moves = moves_of(e, contour_start);
    expect_sound(moves, plate(), {.surface = 5, .bottom = -3.8, .plunge = 90, .mill = 400, .away = 5.3});
    bool oblique = false;
    for (const Move& m : moves) oblique |= !m.rapid && !m.vertical() && m.from > m.to;
    EXPECT_TRUE(oblique);
    Situation s = contour_mill(5);
    s.tool_plunge_angle = 0;
    EXPECT_FALSE(expand_contour(d, s, {.area = plate(), .train = {}}).ok());
}

TEST(RoughOut, FineRoughingMillsTheRestOnly) {
    const Region region = plate();
    const auto coarse = moves_of(
        expand_contour(demand(Kind::rough_out), contour_mill(8), {.area = region, .train = {}}), contour_start);
    const Expansion e = expand_contour(with(demand(Kind::rough_out), Role::coarse_tool, 3), contour_mill(3),
                                       {.area = region, .train = {}, .other_radius = 8});
    ASSERT_TRUE(e.ok());
    const auto fine = moves_of(e, contour_start);
    expect_sound(fine, region, {.surface = 5, .bottom = -3.8, .plunge = 120, .mill = 400, .away = 3.3});
    double way = 0, whole = 0;
    const auto all = moves_of(expand_contour(demand(Kind::rough_out), contour_mill(3), {.area = region, .train = {}}),
                              contour_start);
    for (const Move& m : fine) way += m.rapid ? 0 : static_cast<double>(m.samples.size());
    for (const Move& m : all) whole += m.rapid ? 0 : static_cast<double>(m.samples.size());
    EXPECT_LT(way, 0.6 * whole);
    const geom::Box b = geom::box(region);
    const Region reach = geom::offset(geom::offset(region, -3.3), 3);
    for (double u = b.lo.x; u < b.hi.x; u += 0.9)
        for (double v = b.lo.y; v < b.hi.y; v += 0.9)
            if (geom::contains(reach, {u, v})) {
                EXPECT_TRUE(covered(coarse, {u, v}, 8, -3.8) || covered(fine, {u, v}, 3, -3.8)) << u << ' ' << v;
            }
    EXPECT_FALSE(expand_contour(with(demand(Kind::rough_out), Role::coarse_tool, 3), contour_mill(3),
                                {.area = region, .train = {}})
                     .simulated);
}

TEST(RoughOut, ATooLargeToolNamesThePlace) {
    const auto complaint = [](const Demand& d, const Situation& s, const Region& r) {
        const Expansion e = expand_contour(d, s, {.area = r, .train = {}});
        EXPECT_FALSE(e.ok());
        EXPECT_TRUE(e.steps.empty());
        return e.complaints.empty() ? std::string() : e.complaints.front().text;
    };
    const Region small{{placed(disc(4), 0, {30, -20})}};
    EXPECT_NE(complaint(demand(Kind::rough_out), contour_mill(5), small).find("u 30.000 v -20.000"), std::string::npos);
    EXPECT_NE(complaint(demand(Kind::side_finish), contour_mill(5), small).find("u 30.000 v -20.000"),
              std::string::npos);
    for (const double infeed : {0.0, 1e-9})
        EXPECT_NE(complaint(with(demand(Kind::rough_out), Role::infeed, infeed), contour_mill(5), plate()), "");
    EXPECT_NE(complaint(with(demand(Kind::rough_out), Role::overlap, 1e-9), contour_mill(5), plate()), "");
    EXPECT_NE(complaint(with(demand(Kind::rough_out), Role::clearance_height, 1), contour_mill(5), plate()), "");
    EXPECT_NE(complaint(demand(Kind::rough_out), contour_mill(5), {}), "");
    EXPECT_FALSE(
        expand_contour(demand(Kind::rough_out), contour_mill(unknown), {.area = plate(), .train = {}}).simulated);
    // One part too narrow: the other is milled, the narrow one named.
    Region two = plate();
    two.contours.push_back(placed(disc(4), 0, {100, 0}));
    const Expansion e = expand_contour(demand(Kind::rough_out), contour_mill(5), {.area = two, .train = {}});
    ASSERT_TRUE(e.ok());
    ASSERT_EQ(e.complaints.size(), 1U);
    EXPECT_NE(e.complaints[0].text.find("u 100.000 v 0.000"), std::string::npos);
}

TEST(PilotDrill, DrillsWhereRoughingGoesDown) {
    const auto rough = moves_of(
        expand_contour(demand(Kind::rough_out), contour_mill(5), {.area = plate(), .train = {}}), contour_start);
    Situation drill = contour_mill(3);
    const Expansion e =
        expand_contour(demand(Kind::pilot_drill), drill, {.area = plate(), .train = {}, .other_radius = 5});
    ASSERT_TRUE(e.ok());
    std::vector<Vec2> holes;
    double deepest = 1e9;
    for (const Move& m : moves_of(e, contour_start)) {
        if (!m.rapid && m.vertical() && m.to < 5) holes.push_back(m.samples[0]);
        deepest = std::min(deepest, m.to);
    }
    EXPECT_NEAR(deepest, -3.8, 1e-12);
    for (const Move& m : rough)
        if (m.vertical() && !m.rapid && m.to < m.from) {
            double near = 1e9;
            for (const Vec2 h : holes) near = std::min(near, geom::distance(h, m.samples[0]));
            EXPECT_LT(near, 1e-9);
        }
    EXPECT_FALSE(expand_contour(demand(Kind::pilot_drill), drill, {.area = plate(), .train = {}}).simulated);
}

TEST(Finishing, FloorAndSides) {
    const Region region = plate();
    const auto floor = moves_of(
        expand_contour(demand(Kind::floor_finish), contour_mill(5), {.area = region, .train = {}}), contour_start);
    expect_sound(floor, region, {.surface = -3.8 + 1e-9, .bottom = -4, .plunge = 120, .mill = 400, .away = 5.3});
    EXPECT_EQ(milled_levels(floor), (std::set<double>{-4}));
    expect_covers(floor, region, 0.3, 5, -4, 1.3);
    for (const double sense : {1.0, -1.0}) {
        const Expansion e = expand_contour(with(demand(Kind::side_finish), Role::direction, sense), contour_mill(4),
                                           {.area = region, .train = {}});
        ASSERT_TRUE(e.ok());
        const auto moves = moves_of(e, contour_start);
        expect_sound(moves, region, {.surface = 5, .bottom = -4, .plunge = 120, .mill = 400, .away = 4});
        EXPECT_EQ(milled_levels(moves), (std::set<double>{1, -3, -4}));
        // Every wall is run along, at the tool's radius.
        for (const geom::Edge& edge : geom::edges(geom::offset(region, -4))) {
            double near = 1e9;
            for (const Move& m : moves)
                if (m.to == -4)
                    for (const Vec2 q : m.samples) near = std::min(near, geom::distance(q, geom::point_at(edge, 0.5)));
            EXPECT_LT(near, 0.25);
        }
    }
    const Expansion e = expand_contour(with(demand(Kind::side_finish), Role::allowance_left, 1.5), contour_mill(4),
                                       {.area = region, .train = {}, .other_radius = 5});
    EXPECT_FALSE(e.ok());
}

TEST(RoughOutRandom, NoGougeAllCovered) {
#ifdef NDEBUG
    constexpr unsigned many = 300;
#else
    constexpr unsigned many = 30;
#endif
    unsigned milled = 0;
    for (unsigned number = 0; number < many && !HasFailure(); ++number) {
        SCOPED_TRACE(number);
        Random random(number);
        Region r = geom::testing::lattice_region(random, 7);
        for (Contour& c : r.contours)
            for (geom::Vertex& v : c.vertices) v.p = 5.0 * v.p;
        Demand d = demand(Kind::rough_out);
        d = with(with(d, Role::overlap, random.between(0.4, 1.9)), Role::allowance_side, random.between(0, 0.6));
        d = with(d, Role::rounding_radius, random.below(3) ? 0 : random.between(0, 1));
        d = with(d, Role::direction, random.below(2) ? 1 : -1);
        d = with(d, Role::feed_reciprocate, random.below(2) ? 0 : 120);
        const double radius = random.between(0.8, 3), side = d.get(Role::allowance_side);
        const Expansion e = expand_contour(d, contour_mill(radius), {.area = r, .train = {}});
        if (geom::offset(r, -radius - side).empty()) {
            EXPECT_FALSE(e.ok());
            continue;
        }
        ASSERT_TRUE(e.ok());
        ++milled;
        const auto moves = moves_of(e, contour_start);
        expect_sound(moves, r, {.surface = 5, .bottom = -3.8, .plunge = 120, .mill = 400, .away = radius + side});
        if (d.get(Role::rounding_radius) == 0) expect_covers(moves, r, side, radius, -3.8, 1.7);
    }
    std::printf("seeds 0..%u: %u pockets\n", many - 1, milled);
    EXPECT_GT(milled, many / 3);
}

TEST(Contours, NonsenseIsBounded) {
    constexpr double inf = std::numeric_limits<double>::infinity();
    const double nasty[] = {0, -1, 1, 1e-12, -1e-12, 1e-3, 5, -20, 360, 1e6, -1e6, 1e300, inf, -inf, unknown, 0.1, 3};
    const Kind kinds[] = {Kind::rough_out, Kind::pilot_drill, Kind::floor_finish, Kind::side_finish,
                          Kind::contour_train};
    const Contour path{{{{0, 0}}, {{40, 0}, 0.3}, {{40, 30}}}, false};
    for (unsigned number = 0; number < 3000 && !HasFailure(); ++number) {
        SCOPED_TRACE(number);
        Random random(number);
        Demand d = demand(random.one_of(kinds));
        for (int k = random.below(4); k >= 0; --k) {
            const auto role = d.values[static_cast<std::size_t>(random.below(static_cast<int>(d.values.size())))].role;
            d = with(d, role, random.one_of(nasty));
        }
        Situation s = contour_mill(random.below(4) ? 5 : random.one_of(nasty));
        if (random.below(4) == 0) s.tool_plunge_angle = random.one_of(nasty);
        if (random.below(4) == 0) s.tool_cutting_length = random.one_of(nasty);
        ContourTask task{.area = plate(), .train = {path, random.below(3) - 1}, .other_radius = 6};
        if (random.below(4) == 0) task.other_radius = random.one_of(nasty);
        if (random.below(8) == 0) task.area.contours[0].vertices[0].p.x = random.one_of(nasty);
        if (random.below(8) == 0) task.train.contour.vertices[1].bulge = random.one_of(nasty);
        const Expansion e = expand_contour(d, s, task);
        EXPECT_LE(e.steps.size(), most_steps);
        EXPECT_TRUE(e.ok() || e.steps.empty());
        EXPECT_TRUE(e.ok() || !e.complaints.empty());
        for (const Move& m : moves_of(e, contour_start))
            for (const Vec2 p : m.samples) EXPECT_TRUE(std::isfinite(p.x + p.y + m.to));
    }
    EXPECT_FALSE(expand_contour(demand(Kind::drill), contour_mill(5), {}).simulated);
}

}  // namespace
}  // namespace obrys::cycles
