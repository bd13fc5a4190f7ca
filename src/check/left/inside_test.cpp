/// How deep what is left stands in a body, against places of it looked at one by one, and fins of any thickness.

#include <gtest/gtest.h>

#include <random>

#include "base/seed_testing.hpp"
#include "check/left/cut_world_testing.hpp"
#include "check/left/inside.hpp"
#include "check/left/swept_depth.hpp"

namespace obrys::check {

namespace milling = sim::milling;

using geom::Vec3;
using testing::straight;

namespace {

constexpr double inside_allowed = 0.001, inside_thin = 0.00005;

struct InsideWorld : testing::CutWorld {
    StockPlanes planes;
    explicit InsideWorld(milling::Stock s = milling::Box3{{0, 0, -20}, {60, 40, 0}})
        : CutWorld(std::move(s)), planes(planes_of(stock)) {}
    [[nodiscard]] LeftDepth inside(const LeftBody& body, std::size_t cells = 800) {
        simulation.flush();
        const milling::Air air = simulation.air_in({{-100, -100, -100}, {200, 200, 200}});
        const LeftCuts cuts(air, simulation, 1'000'000);
        return deepest_inside(body, {stock, planes, air, cuts.all(), inside_allowed, 50, inside_thin, cells});
    }
    [[nodiscard]] bool is_left(Vec3 p) const {
        const milling::Air air = simulation.air_in({p - Vec3{2, 2, 2}, p + Vec3{2, 2, 2}});
        for (std::size_t body = 0; body < air.bodies(); ++body)
            if (!(air.outside(body, p) > 1e-3)) return false;
        return true;
    }
};

LeftBody milled(Vec3 from, Vec3 to, double radius, Vec3 axis = {0, 0, 1}) {
    return {from, {to - from, {}, {}}, axis, {{radius, 0}, {radius, 60}}, {}};
}

}  // namespace

TEST(LeftInside, AFinIsAsDeepAsItStandsHoweverThin) {
    for (const double width : {0.0004, 0.002, 0.03, 1.0}) {
        SCOPED_TRACE(width);
        InsideWorld w;
        const std::uint32_t tool = w.tool(6);
        const double x = 3 + width / 2;
        w.cut(tool, straight({20 - x, -10, -3}, {20 - x, 50, -3}));
        w.cut(tool, straight({20 + x, -10, -3}, {20 + x, 50, -3}));
        const LeftDepth d = w.inside(milled({20 - x, 18, -1.3}, {20 + x, 18, -1.3}, 3));
        EXPECT_TRUE(d.decided);
        EXPECT_NEAR(d.depth, 1.3, 0.03);
    }
}

TEST(LeftInside, SlotsThatTouchLeaveNothing) {
    InsideWorld w;
    const std::uint32_t tool = w.tool(6);
    w.cut(tool, straight({17, -10, -3}, {17, 50, -3}));
    w.cut(tool, straight({23, -10, -3}, {23, 50, -3}));
    const LeftDepth d = w.inside(milled({17, 18, -1.3}, {23, 18, -1.3}, 3));
    EXPECT_TRUE(d.decided);
    EXPECT_EQ(d.depth, 0);
}

TEST(LeftInside, TheOwnCutIsLeftWithoutContact) {
    InsideWorld w;
    const std::uint32_t tool = w.tool(10);
    w.cut(tool, straight({10, -4.5, -12}, {40, -4.5, -12}));
    for (const Vec3& to : {Vec3{40, -8, -12}, Vec3{40, -4.5, 5}, Vec3{10, -4.5, -12}, Vec3{50, -30, 4}}) {
        const LeftDepth d = w.inside(milled({40, -4.5, -12}, to, 5));
        EXPECT_TRUE(d.decided) << to.x << ' ' << to.y << ' ' << to.z;
        EXPECT_EQ(d.depth, 0) << to.x << ' ' << to.y << ' ' << to.z;
    }
    const LeftDepth d = w.inside(milled({40, -4.5, -12}, {41, -4.5, -12}, 5));
    EXPECT_TRUE(d.decided);
    EXPECT_NEAR(d.depth, 0.348, 0.01);  // where its end has not been, on the stock's face
}

TEST(LeftInside, AnEdgeIsAsDeepAsItLiesInTheBody) {
    InsideWorld w;
    // The upright edge at (0, 0), taken off by 0.2 along the diagonal.
    const double at = -(5 - 0.2) / std::sqrt(2.0);
    const LeftDepth d = w.inside(milled({at, at, -8}, {at, at, -8}, 5));
    EXPECT_TRUE(d.decided);
    EXPECT_NEAR(d.depth, 0.2, 0.005);
}

/// As it is, by points; and what is clear is clear.
TEST(LeftInside, APropertyOfRandomCuts) {
    const std::uint32_t seed = base::testing_seed();
    std::mt19937 random(seed);
    const auto in = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
    constexpr int cases = 12;
    int decided = 0;
    for (int n = 0; n < cases; ++n) {
        SCOPED_TRACE("seed " + std::to_string(seed) + ", case " + std::to_string(n));
        InsideWorld w(n % 3 == 0 ? milling::Stock(milling::CylinderStock{2, {30, 20, -20}, 20, 20})
                                 : milling::Stock(milling::Box3{{0, 0, -20}, {60, 40, 0}}));
        const std::array tools{w.tool(10), w.tool(8, milling::CutterKind::ball),
                               w.tool(12, milling::CutterKind::bull_nose), w.tool(9, milling::CutterKind::drill)};
        const auto place = [&](double low) { return Vec3{in(10, 50), in(8, 32), in(low, -2)}; };
        Vec3 first, last;
        for (int k = 0; k < 6; ++k) {
            const Vec3 a = place(-16), b = place(-16);
            const bool level = k % 2 == 0;
            w.cut(tools[static_cast<std::size_t>(k % 4)], straight(a, level ? Vec3{b.x, b.y, a.z} : b));
            if (k == 0) first = a, last = {b.x, b.y, a.z};
        }
        // Some follow the first cut, where it is only a little narrower, as wide or wider.
        const Vec3 a = n % 2 == 0 ? first : place(-12), b = n % 2 == 0 ? last : place(-12);
        const double r = n % 4 == 0 ? 5 : n % 4 == 2 ? 5.01 : in(1, 5);
        const LeftBody body = milled(a, b, r);
        const LeftDepth d = w.inside(body);
        if (!d.decided) continue;  // all along a curved wall: search.hpp knows that at once
        ++decided;
        if (n % 4 == 0) {
            EXPECT_EQ(d.depth, 0);
        }
        const SweptDepth swept(body.profile, body.axis, body.corner, body.edges[0], false, true);
        double most = 0;
        for (int k = 0; k < 4000; ++k) {
            const double turn = in(0, 2 * geom::pi), away = r * std::sqrt(in(0, 1));
            const Vec3 p =
                body.corner + in(0, 1) * body.edges[0] + Vec3{away * std::cos(turn), away * std::sin(turn), in(0, 20)};
            const double depth = swept.nearest(p).depth;
            if (depth > most && w.is_left(p)) most = depth;
        }
        EXPECT_LE(most, std::max(inside_allowed, 1.05 * d.depth) + 1e-6);
        if (d.depth > 0) {
            EXPECT_NEAR(swept.nearest(d.at).depth, d.depth, 1e-6);
        }
    }
    EXPECT_GE(decided, cases / 3);
}

TEST(LeftInside, AMeshThatIsConvexIsItsFaces) {
    milling::MeshStock m{{{0, 0, 0}, {40, 0, 0}, {0, 40, 0}, {0, 0, 30}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}};
    EXPECT_TRUE(planes_of(m).whole);
    EXPECT_EQ(planes_of(m).planes.size(), 4U);
    m.vertices.push_back({5, 5, 5});
    m.triangles[2] = {1, 2, 4};
    m.triangles.push_back({2, 3, 4});
    m.triangles.push_back({3, 1, 4});
    EXPECT_FALSE(planes_of(m).whole);
}

}  // namespace obrys::check
