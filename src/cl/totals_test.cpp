#include "cl/totals.hpp"

#include <gtest/gtest.h>

namespace obrys::cl {
namespace {

Record rapid(geom::Vec3 to) { return {Linear{to, {0, 0, 1}, true}, {}, 0}; }
Record feed(geom::Vec3 to) { return {Linear{to, {0, 0, 1}, false}, {}, 0}; }

TEST(Totals, CountsAndAddsLengths) {
    Totals t;
    t(rapid({0, 0, 0}));  // from nowhere: counted, without length
    t(rapid({3, 4, 0}));
    t(feed({3, 4, 12}));
    t({Thread{{3, 4, 2}, 1.5, false}, {}, 0});
    t({Dwell{1, 0}, {}, 0});
    EXPECT_EQ(t.records, 5u);
    EXPECT_EQ(t.moves, 4u);
    EXPECT_EQ(t.rapid_moves, 2u);
    EXPECT_EQ(t.feed_moves, 2u);
    EXPECT_DOUBLE_EQ(t.rapid_length_mm, 5);
    EXPECT_DOUBLE_EQ(t.feed_length_mm, 22);
}

TEST(Totals, ACoordinateThatWasNeverGivenDoesNotMove) {
    Totals t;
    t(rapid({10, NAN, NAN}));
    t(rapid({7, NAN, NAN}));
    t(rapid({7, NAN, 5}));  // z comes from nowhere
    t(feed({7, NAN, 1}));
    EXPECT_DOUBLE_EQ(t.rapid_length_mm, 3);
    EXPECT_DOUBLE_EQ(t.feed_length_mm, 4);
}

TEST(Totals, AnotherZeroMovesNothing) {
    Totals t;
    t({Datum{54, {100, 0, NAN}}, {}, 0});
    t(rapid({10, 0, 5}));
    t({Datum{55, {130, 0, -20}}, {}, 0});  // where they lie along z is not known: at the same place
    t(feed({-20, 4, 5}));
    EXPECT_DOUBLE_EQ(t.feed_length_mm, 4);
}

TEST(Totals, ArcsAndHelices) {
    Totals t;
    t(rapid({10, 0, 0}));
    t({Arc{{0, 10, 0}, {0, 0, 0}, {0, 0, 1}, geom::pi / 2}, {}, 0});
    EXPECT_DOUBLE_EQ(t.feed_length_mm, 5 * geom::pi);
    t({Arc{{0, 10, 9}, {0, 0, 0}, {0, 0, 1}, -4 * geom::pi}, {}, 0});  // two turns down a helix
    EXPECT_NEAR(t.feed_length_mm, 5 * geom::pi + std::hypot(40 * geom::pi, 9), 1e-12);
}

TEST(Totals, SplinesCountAsFeedMoves) {
    Totals t;
    t(rapid({5, 0, 0}));
    t({Spline{{2, 4, 0}, {3, -4, 0}, {}, {}, {0, 0, 1}, {}}, {}, 0});  // straight, from (5, 0) to (2, 4)
    EXPECT_EQ(t.feed_moves, 1u);
    EXPECT_NEAR(t.feed_length_mm, 5, 1e-12);
    EXPECT_EQ(t.position, (geom::Vec3{2, 4, 0}));
}

TEST(Totals, AnArcOnALatheDoesNotNeedY) {
    const double length = move_length({10, NAN, 0}, Arc{{0, NAN, 10}, {0, NAN, 0}, {0, 1, 0}, -geom::pi / 2});
    EXPECT_DOUBLE_EQ(length, 5 * geom::pi);
}

}  // namespace
}  // namespace obrys::cl
