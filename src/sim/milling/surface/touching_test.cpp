// Cuts that touch without a gap, as rings and rows of a pocket do: between them there is no material, however coarse
// the lattice is.

#include <gtest/gtest.h>

#include "sim/milling/cut/milling_testing.hpp"
#include "sim/milling/surface/surface.hpp"

namespace obrys::sim::milling {
namespace {

using geom::Vec3;

std::size_t open_places(Work& w) {
    w.simulation.flush();
    return extract_surface(w.simulation).refined.open.size();
}

TEST(Touching, rows_side_by_side_leave_no_fin) {
    const Box3 block{{0, 0, 0}, {40, 40, 12}};
    for (const double tolerance : {0.05, 0.1, 0.2, 0.3, 0.4, 0.5})
        for (const double turn : {0.0, 0.3}) {
            Work w(block, step_for(tolerance, 3.4), tool_of(CutterKind::end_mill, 10), tolerance);
            const Vec3 along{std::cos(turn), std::sin(turn), 0}, aside{-along.y, along.x, 0}, c{20, 20, 7};
            for (const double beside : {-5.0, 5.0}) {
                w.start(c + beside * aside - 50.0 * along);
                w.to(c + beside * aside + 50.0 * along);
            }
            EXPECT_EQ(open_places(w), 0U) << tolerance << ' ' << turn;
        }
}

TEST(Touching, a_ring_within_a_ring_leaves_no_crest) {
    const Box3 block{{0, 0, 0}, {46, 46, 12}};
    const Vec3 c{23, 23, 0};
    for (const double tolerance : {0.1, 0.2, 0.3, 0.4, 0.5, 1.0}) {
        Work w(block, step_for(tolerance, 3.4), tool_of(CutterKind::end_mill, 12), tolerance);
        w.start(c + Vec3{14, 0, 12});
        for (const double z : {7.0, 2.0, 2.0}) w.arc(c + Vec3{14, 0, z}, c + Vec3{0, 0, w.at.z}, 2 * geom::pi);
        w.to(c + Vec3{0, 0, 2});
        w.to(c + Vec3{2, 0, 2});
        w.arc(w.at, c + Vec3{0, 0, 2}, 2 * geom::pi);
        EXPECT_EQ(open_places(w), 0U) << tolerance;
    }
}

// A ball on a slanting circle, in chords, comes a little out of a side of the stock: the edge there is as sharp as a
// feather, and chords that reach over it a little have taken it back by much.
TEST(Touching, a_feather_edge_is_looked_for_where_it_is) {
    const Box3 block{{-12, -12, -12}, {12, 12, 12}};
    const Vec3 n{0, -0.5, std::sqrt(0.75)}, up{0, std::sqrt(0.75), 0.5};
    for (const double out : {0.02, 0.05, 0.1}) {
        Work w(block, step_for(0.01, 3), tool_of(CutterKind::ball, 6));
        w.axis = n;
        const Vec3 centre{9 - 7 + out, -8, 2},
            first = centre + 7.0 * Vec3{std::cos(-0.4), 0, 0} + (7 * std::sin(-0.4)) * up;
        w.start(first + Vec3{});
        w.arc(centre + (7 * std::cos(0.4)) * Vec3{1, 0, 0} + (7 * std::sin(0.4)) * up, centre, 0.8, n);
        EXPECT_EQ(open_places(w), 0U) << out;
    }
}

}  // namespace
}  // namespace obrys::sim::milling
