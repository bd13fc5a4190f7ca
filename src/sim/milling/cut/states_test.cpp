// A simulation at an earlier pass, copies that go on by themselves, and what states may take.

#include <cmath>
#include <random>

#include "base/seed_testing.hpp"
#include "sim/milling/cut/milling_testing.hpp"

namespace obrys::sim::milling {
namespace {

using geom::Vec3;

const Stock slab = Box3{{0, 0, -8}, {60, 40, 0}};

Simulation started(std::size_t bytes) {
    Simulation s(slab, *make_lattice(box_of(slab), 1.0), 0.01, 2);
    s.keep_states(bytes);
    (void)s.add_tool(tool_of(CutterKind::ball, 4));
    (void)s.add_tool(tool_of(CutterKind::end_mill, 6));
    return s;
}

/// Short random moves of both tools, some of which take nothing away.
std::vector<Pass> random_passes(std::mt19937_64& random, std::size_t count) {
    const auto between = [&](double a, double b) { return std::uniform_real_distribution<double>(a, b)(random); };
    std::vector<Pass> passes;
    Vec3 at{0, 0, -1};
    while (passes.size() < count) {
        const Vec3 to{std::clamp(at.x + between(-3, 3.4), -2.0, 62.0), std::clamp(at.y + between(-3, 3.3), -2.0, 42.0),
                      std::clamp(at.z + between(-1, 1), -6.0, 1.0)};
        Pass p{geom::Straight{at, to}, {0, 0, 1}, static_cast<std::uint32_t>(random() % 2)};
        p.cut = random() % 8 != 0;
        passes.push_back(p);
        at = to;
    }
    return passes;
}

void add_all(Simulation& s, const std::vector<Pass>& passes, std::size_t first, std::size_t end) {
    for (std::size_t i = first; i < end; ++i) (void)s.add(passes[i]);
    s.flush();
}

void expect_same(const Simulation& a, const Simulation& b) {
    const Dexels &one = a.dexels(), &two = b.dexels();
    for (int axis = 0; axis < 3; ++axis)
        for (int v = 0; v < one.rays_b(axis); ++v)
            for (int u = 0; u < one.rays_a(axis); ++u) {
                const auto x = one.ray(axis, u, v), y = two.ray(axis, u, v);
                ASSERT_TRUE(std::equal(x.begin(), x.end(), y.begin(), y.end())) << axis << ' ' << u << ' ' << v;
            }
    ASSERT_EQ(a.engagements().size(), b.engagements().size());
    for (std::size_t i = 0; i < a.engagements().size(); ++i) {
        ASSERT_EQ(a.engagements()[i].touched, b.engagements()[i].touched) << i;
        ASSERT_EQ(a.engagements()[i].volume, b.engagements()[i].volume) << i;
    }
    ASSERT_EQ(a.sweeps(), b.sweeps());
    ASSERT_EQ(a.cuts_in(box_of(slab)), b.cuts_in(box_of(slab)));
}

}  // namespace

/// Whatever memory states may take: at a random pass the stock is the one that was simulated to there, and gone on with
/// from there it becomes the whole one.
TEST(States, AStockRestoredIsTheOneSimulatedToThere) {
    const auto seed = base::testing_seed();
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    const std::vector<Pass> passes = random_passes(random, 12'000);
    for (const std::size_t bytes : {std::size_t{0}, std::size_t{400'000}, std::size_t{1} << 30U}) {
        Simulation all = started(bytes);
        add_all(all, passes, 0, passes.size());
        Simulation untouched = started(0);
        add_all(untouched, passes, 0, passes.size());
        for (int n = 0; n < 4; ++n) {
            const std::size_t to = n == 0 ? 0 : random() % (passes.size() + 1);
            SCOPED_TRACE(to);
            Simulation direct = started(0);
            add_all(direct, passes, 0, to);
            Simulation then = all.at(to);
            expect_same(then, direct);
            EXPECT_EQ(volume(then), volume(direct));
            add_all(then, passes, to, passes.size());
            expect_same(then, untouched);
            expect_same(all, untouched);
        }
    }
}

TEST(States, StayWithinTheirMemoryAndShareWhatDidNotChange) {
    std::mt19937_64 random(4);
    const std::vector<Pass> passes = random_passes(random, 40'000);
    Simulation all = started(0);
    add_all(all, passes, 0, passes.size());
    const std::size_t own = all.dexels().bytes();
    for (const std::size_t bytes : {own / 2, 3 * own}) {
        States states(bytes);
        Simulation s = started(0);
        for (std::size_t i = 0; i < passes.size(); i += 2000) {
            add_all(s, passes, i, i + 2000);
            states.add(s.sweeps(), s.dexels());
            EXPECT_LE(states.bytes(s.dexels()), bytes);
        }
        EXPECT_TRUE(bytes < own || states.count() > 2);
    }
    const Dexels copy = all.dexels();
    EXPECT_EQ(copy.bytes_apart_from(all.dexels()), 0U);
}

}  // namespace obrys::sim::milling
