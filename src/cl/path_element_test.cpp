#include "cl/path_element.hpp"

#include <gtest/gtest.h>

namespace obrys::cl {
namespace {

TEST(PathElement, EveryKindOfMoveEndsWhereItSays) {
    const geom::Vec3 from{10, 0, 2}, to{0, 10, 5};
    const Spline spline{to, {10, -10, -3}, {}, {}, {0, 0, 1}, {}};
    for (const Step& s : {Step{Linear{to, {0, 0, 1}, false}}, Step{Thread{to, 1, false}}, Step{spline},
                          Step{Arc{to, {0, 0, 0}, {0, 0, 1}, geom::pi / 2}}}) {
        const auto e = element_of(from, s);
        ASSERT_TRUE(e);
        EXPECT_LE(geom::distance(geom::point_at(*e, 0), from), 1e-14);
        EXPECT_LE(geom::distance(geom::point_at(*e, 1), to), 1e-14);
    }
    const auto helix = element_of(from, Arc{to, {0, 0, 0}, {0, 0, 1}, geom::pi / 2});
    EXPECT_LE(geom::distance(geom::point_at(*helix, 0.5), {10 * std::sqrt(0.5), 10 * std::sqrt(0.5), 3.5}), 1e-14);
    EXPECT_FALSE(element_of(from, Dwell{}));
}

TEST(PathElement, ACoordinateNeverGivenStaysOut) {
    const auto line = element_of({1, NAN, 2}, Linear{{3, NAN, 4}, {0, 0, 1}, false});
    ASSERT_TRUE(line);
    EXPECT_EQ(geom::point_at(*line, 1), (geom::Vec3{3, 0, 4}));
    EXPECT_FALSE(element_of({1, NAN, 2}, Linear{{3, 0, 4}, {0, 0, 1}, false}));
    const auto arc = element_of({10, NAN, 0}, Arc{{0, NAN, 10}, {0, NAN, 0}, {0, 1, 0}, -geom::pi / 2});
    ASSERT_TRUE(arc);
    EXPECT_EQ(geom::point_at(*arc, 0.25).y, 0);
    EXPECT_FALSE(element_of({10, 0, 0}, Arc{{0, 10, 0}, {NAN, 0, 0}, {0, 0, 1}, geom::pi / 2}));
    const auto spline = element_of({NAN, NAN, NAN}, Spline{{1, 2, NAN}, {1, 1, 0}, {}, {}, {0, 0, 1}, {}});
    ASSERT_TRUE(spline);
    EXPECT_EQ(geom::point_at(*spline, 0), (geom::Vec3{2, 3, 0}));
    EXPECT_FALSE(element_of({0, 0, 0}, Spline{{1, 2, NAN}, {1, 1, 1}, {}, {}, {0, 0, 1}, {}}));
    EXPECT_FALSE(element_of({0, 0, 0}, Spline{{1, 2, 3}, {1, 1, NAN}, {}, {}, {0, 0, 1}, {}}));
}

}  // namespace
}  // namespace obrys::cl
