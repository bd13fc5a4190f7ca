#include "check/turning/parting.hpp"

#include <gtest/gtest.h>

#include "geom/boolean.hpp"

namespace obrys::check {
namespace {

geom::Region block(double z0, double z1, double x0, double x1) {
    return {{{{{{z0, x0}, 0}, {{z1, x0}, 0}, {{z1, x1}, 0}, {{z0, x1}, 0}}, true}}};
}

const geom::Region turned_part = block(-40, 0, 6, 18), turned_bar = block(-60, 0, 6, 18);

TEST(Parting, ABladeThatStoppedLeavesANeck) {
    const auto neck = neck_behind(turned_part, geom::subtract(turned_bar, block(-43, -40, 9, 30)));
    ASSERT_TRUE(neck);
    EXPECT_NEAR(neck->z, -41.5, 1e-9);
    EXPECT_NEAR(neck->thickness, 3, 1e-6);
    EXPECT_NEAR(neck->inner, 6, 1e-6);
    EXPECT_NEAR(neck->outer, 9, 1e-6);
}

TEST(Parting, NothingIsSaidOtherwise) {
    EXPECT_FALSE(neck_behind(turned_part, turned_bar)) << "held in the chuck";
    EXPECT_FALSE(neck_behind(turned_part, turned_part)) << "nothing behind it";
    EXPECT_FALSE(neck_behind(turned_part, geom::subtract(turned_bar, block(-43, -40, 5, 30)))) << "cut off";
    EXPECT_FALSE(neck_behind(turned_part, geom::subtract(turned_bar, block(-43, -40, 16, 30)))) << "a groove";
    EXPECT_FALSE(neck_behind({}, turned_bar));
    EXPECT_FALSE(neck_behind(turned_part, {}));
}

}  // namespace
}  // namespace obrys::check
