// Moves that are added in pieces are one body.

#include <gtest/gtest.h>

#include <random>

#include "sim/milling/cut/milling_testing.hpp"

namespace obrys::sim::milling {
namespace {

using geom::Vec3;

const Box3 whole_block{{0, 0, 0}, {40, 40, 12}};

/// The same way in one and in pieces.
void add(Work& w, const geom::PathElement& path, int pieces) {
    for (int i = 0; i < pieces; ++i) {
        Pass pass{path, w.axis, w.tool};
        const Vec3 from = geom::point_at(path, double(i) / pieces), to = geom::point_at(path, double(i + 1) / pieces);
        if (const auto* c = std::get_if<geom::Circular>(&path))
            pass.path = geom::Circular{from, to, c->centre, c->normal, c->sweep / pieces};
        else
            pass.path = geom::Straight{from, to};
        pass.goes_on = i > 0;
        EXPECT_EQ(w.simulation.add(pass), Taken::taken);
    }
}

TEST(Whole, pieces_of_a_move_are_one_body) {
    const geom::PathElement level = geom::Straight{{3, 4, 5}, {31, 22, 5}},
                            ramp = geom::Straight{{31, 22, 5}, {8, 30, 2}},
                            arc = geom::Circular{{30, 20, 3}, {20, 30, 3}, {20, 20, 3}, {0, 0, 1}, geom::pi / 2};
    for (const CutterKind kind : {CutterKind::end_mill, CutterKind::ball, CutterKind::bull_nose})
        for (const geom::PathElement& path : {level, ramp, arc}) {
            Work one(whole_block, 0.5, tool_of(kind, 8, kind == CutterKind::bull_nose ? 1 : 0)),
                many(whole_block, 0.5, tool_of(kind, 8, kind == CutterKind::bull_nose ? 1 : 0));
            add(one, path, 1);
            add(many, path, 70);
            one.simulation.flush();
            many.simulation.flush();
            EXPECT_EQ(many.simulation.wholes().size(), 1U);
            const Air whole = many.simulation.whole_air_in(whole_block), same = one.simulation.air_in(whole_block);
            ASSERT_EQ(whole.bodies(), 2U);
            std::mt19937 random(1);
            std::uniform_real_distribution<double> in(0, 40);
            for (int i = 0; i < 300; ++i) {
                const Vec3 p{in(random), in(random), in(random)*0.3};
                EXPECT_NEAR(whole.outside(1, p), same.outside(1, p), 1e-6);
            }
        }
}

// Ends of arcs are rounded to decimals, so radii at both ends differ by a little.
TEST(Whole, pieces_of_an_arc_whose_end_is_rounded_are_one_body) {
    for (const double off : {4e-7, 5e-6}) {
        Work w(whole_block, 0.5, tool_of(CutterKind::end_mill, 8));
        add(w, geom::Circular{{30, 20, 3}, {20, 30 + off, 3}, {20, 20, 3}, {0, 0, 1}, geom::pi / 2}, 70);
        w.simulation.flush();
        EXPECT_LE(w.simulation.wholes().size(), 2U) << off;  // the last piece may pass the quarter by rounding
    }
    Work w(whole_block, 0.5, tool_of(CutterKind::end_mill, 8));
    add(w, geom::Circular{{30, 20, 3}, {20, 30.01, 3}, {20, 20, 3}, {0, 0, 1}, geom::pi / 2}, 70);
    w.simulation.flush();
    EXPECT_GT(w.simulation.wholes().size(), 2U);
}

TEST(Whole, what_turns_or_is_another_move_is_not) {
    Work w(whole_block, 0.5, tool_of(CutterKind::end_mill, 8));
    const auto take = [&](Vec3 from, Vec3 to, bool goes_on) {
        Pass pass{geom::Straight{from, to}, w.axis, w.tool};
        pass.goes_on = goes_on;
        EXPECT_EQ(w.simulation.add(pass), Taken::taken);
    };
    take({5, 5, 4}, {10, 5, 4}, false);
    take({10, 5, 4}, {15, 5, 4}, true);
    take({15, 5, 4}, {20, 5, 4}, false);   // another move
    take({20, 5, 4}, {25, 5.1, 4}, true);  // turns
    take({25, 5.1, 4}, {20, 5, 4}, true);  // back
    take({21, 5, 4}, {22, 5, 4}, true);    // a gap
    add(w, geom::Circular{{30, 20, 3}, {20, 10, 3}, {20, 20, 3}, {0, 0, 1}, 1.5 * geom::pi}, 30);
    w.simulation.flush();
    EXPECT_EQ(w.simulation.wholes().size(), 5U + 3U);
    EXPECT_EQ(w.simulation.whole_air_in(whole_block).bodies(), 1U + 5U + 3U);
}

}  // namespace
}  // namespace obrys::sim::milling
