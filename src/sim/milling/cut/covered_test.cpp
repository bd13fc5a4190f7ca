/// Bodies that are called covered lie in another one all over, and levels of ordinary work are found.

#include "sim/milling/cut/covered.hpp"

#include <algorithm>
#include <random>

#include "base/seed_testing.hpp"
#include "sim/milling/cut/milling_testing.hpp"
#include "sim/milling/nearest.hpp"

namespace obrys::sim::milling {
namespace {

using geom::Vec3;

const Box3 levels_blank{{0, 0, -10}, {30, 20, 0}};

bool has_taken(const Air::Sweep& s, Vec3 p, double more) {
    return foot_on(*s.shape, s.track, s.frame.to_tool(p - s.from)).outside <= more;
}

/// Every place in the stock that a covered body has taken has another one taken, too.
void expect_nothing_lost(const Simulation& s, std::span<const std::uint8_t> covered) {
    const std::uint32_t seed = base::testing_seed();
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> x(-1, 31), y(-1, 21), z(-10, 0);
    const std::vector<Simulation::Whole> wholes = s.wholes();
    for (int i = 0; i < 20'000; ++i) {
        const Vec3 p{x(random), y(random), z(random)};
        bool by_covered = false, by_other = false;
        for (std::size_t n = 0; n < wholes.size(); ++n) {
            const Air::Sweep body = s.body_of(wholes[n]);
            by_covered = by_covered || (covered[n] != 0 && has_taken(body, p, -1e-6));
            by_other = by_other || (covered[n] == 0 && has_taken(body, p, 1e-6));
        }
        ASSERT_TRUE(!by_covered || by_other) << p.x << ' ' << p.y << ' ' << p.z;
    }
}

std::ptrdiff_t count(std::span<const std::uint8_t> covered) { return std::ranges::count(covered, std::uint8_t{1}); }

TEST(Covered, TurnsOfAHelixButTheLast) {
    Work w(levels_blank, 0.4, tool_of(CutterKind::end_mill, 6));
    w.start({17, 10, 1});
    w.arc({17, 10, -7}, {15, 10, 1}, 5 * 2 * geom::pi);
    w.simulation.flush();
    const auto covered = milling::covered(w.simulation, w.simulation.wholes());
    EXPECT_NEAR(static_cast<double>(count(covered)), 0.8 * static_cast<double>(covered.size()), 3);
    expect_nothing_lost(w.simulation, covered);
}

TEST(Covered, LevelsOfAPocket) {
    Work w(levels_blank, 0.4, tool_of(CutterKind::bull_nose, 6, 1));
    for (const double z : {-2.0, -4.0, -6.0}) {
        w.start({8, 6, 1});
        w.to({8, 6, z});
        w.to({22, 6, z});
        w.arc({24, 8, z}, {22, 8, z}, geom::pi / 2);
        w.to({24, 14, z});
        w.to({8, 14, z});
        w.to({8, 6, z});
    }
    w.simulation.flush();
    const auto covered = milling::covered(w.simulation, w.simulation.wholes());
    EXPECT_GE(count(covered), 2 * 5);
    expect_nothing_lost(w.simulation, covered);
}

TEST(Covered, NotWhereTheEdgesEndInTheStock) {
    Work w(levels_blank, 0.4, tool_of(CutterKind::end_mill, 6, 0, 3));  // edges of 3 mm: the wall above stays
    for (const double z : {-2.0, -6.0}) w.start({-5, 10, z}), w.to({35, 10, z});
    w.simulation.flush();
    EXPECT_EQ(count(milling::covered(w.simulation, w.simulation.wholes())), 0);
}

TEST(Covered, NotByAnotherWayOrTool) {
    Work w(levels_blank, 0.4, tool_of(CutterKind::ball, 6));
    const std::uint32_t larger = w.simulation.add_tool(tool_of(CutterKind::ball, 8));
    w.start({-5, 10, -2}), w.to({35, 10, -2});
    w.start({-5, 10.001, -4}), w.to({35, 10.001, -4});
    w.start({-5, 10, -4}), w.to({34, 10, -4});
    w.tool = larger;
    w.start({-5, 10, -4}), w.to({35, 10, -4});
    w.simulation.flush();
    EXPECT_EQ(count(milling::covered(w.simulation, w.simulation.wholes())), 0);
}

}  // namespace
}  // namespace obrys::sim::milling
