#include <gtest/gtest.h>

#include "shop/files/obrys/machine_file.hpp"
#include "shop/kinematics.hpp"

namespace obrys::shop {
namespace {

using geom::radians;

TEST(Kinematics, ShippedMachinesReachWhatTheyShould) {
    const Chain c = chain_of(shipped_machine("hermle-u1130").value());
    ASSERT_EQ(c.joints.size(), 5U);
    EXPECT_EQ(c.joints[0].name, "C");
    EXPECT_EQ(c.joints[4].name, "Z");
    EXPECT_NEAR(c.joints[1].min, radians(-115), 1e-12);
    const ToolPose side{{-565, -300, -400}, {0, 1, 0}};  // horizontal tool: A -90, within -115 … 30
    const AxisPositions found = positions_for(c, side, 150);
    ASSERT_EQ(found.reach, Reach::reached);
    EXPECT_TRUE(found.positions[0].in_limits()) << found.positions[0].outside;
    EXPECT_NEAR(found.positions[0].values[1], radians(-90), 1e-9);
    EXPECT_EQ(chain_of(shipped_machine("fv25cnc-a").value()).joints.size(), 3U);
    EXPECT_EQ(chain_of(shipped_machine("lathe-generic").value()).joints.size(), 0U);
}

}  // namespace
}  // namespace obrys::shop
