#include "report/clamp_bodies.hpp"

#include <gtest/gtest.h>

namespace obrys::report {
namespace {

mesh::Box extent(const mesh::Mesh& m) {
    mesh::Box box;
    for (const geom::Vec3 v : m.vertices) box.add(v);
    return box;
}

TEST(ClampBodies, CylindersLieAlongTheirAxis) {
    for (int axis = 0; axis < 3; ++axis) {
        check::MillingSetup setup;
        setup.clamps.push_back({"bar", sim::milling::CylinderStock{axis, {10, 20, 30}, 5, 40}});
        const mesh::Box box = extent(clamp_bodies(setup).mesh);
        const geom::Vec3 size = box.size();
        EXPECT_NEAR(size.x, axis == 0 ? 40 : 10, 0.2);
        EXPECT_NEAR(size.y, axis == 1 ? 40 : 10, 0.2);
        EXPECT_NEAR(size.z, axis == 2 ? 40 : 10, 0.2);
        EXPECT_NEAR(box.centre().x, axis == 0 ? 30 : 10, 0.2);
        EXPECT_NEAR(box.centre().y, axis == 1 ? 40 : 20, 0.2);
    }
}

TEST(ClampBodies, OneNameOrSeveral) {
    check::MillingSetup setup;
    EXPECT_TRUE(clamp_bodies(setup).mesh.empty());
    setup.clamps.push_back({"clamp 1", sim::milling::Box3{{0, 0, 0}, {1, 1, 1}}});
    EXPECT_EQ(clamp_bodies(setup).name, "clamp 1");
    setup.clamps[0].name = "vice";
    EXPECT_EQ(clamp_bodies(setup).name, "clamp vice");
    setup.clamps.push_back({"jaw", sim::milling::Box3{{2, 0, 0}, {3, 1, 1}}});
    EXPECT_EQ(clamp_bodies(setup).name, "clamps");
    EXPECT_EQ(clamp_bodies(setup).mesh.triangles.size(), 24u);
}

}  // namespace
}  // namespace obrys::report
