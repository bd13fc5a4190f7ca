#include "mesh/solids.hpp"

#include <gtest/gtest.h>

#include "mesh/topology.hpp"

namespace obrys::mesh {
namespace {

/// A box of 10 x 10 x 10 from x on, every triangle with corners of its own.
Mesh soup(double x, std::size_t left_out = 0) {
    Mesh out;
    for (const Triangle& t : {Triangle{0, 2, 1},
                              {1, 2, 3},
                              {4, 5, 6},
                              {5, 7, 6},
                              {0, 1, 4},
                              {1, 5, 4},
                              {2, 6, 3},
                              {3, 6, 7},
                              {0, 4, 2},
                              {2, 4, 6},
                              {1, 3, 5},
                              {3, 7, 5}}) {
        if (left_out > 0 && left_out--) continue;
        const auto first = static_cast<std::uint32_t>(out.vertices.size());
        for (const std::uint32_t c : t)
            out.vertices.push_back({x + ((c & 1) != 0 ? 10 : 0), (c & 2) != 0 ? 10.0 : 0, (c & 4) != 0 ? 10.0 : 0});
        out.triangles.push_back({first, first + 1, first + 2});
    }
    return out;
}

TEST(Solids, EqualVerticesBecomeOne) {
    bool closed = true;
    base::Diagnostics out;
    Mesh with_none = soup(0);
    with_none.triangles.push_back({0, 1, 0});
    const Mesh m = settled(0, with_none, closed, out);
    EXPECT_EQ(m.vertices.size(), 8U);
    EXPECT_EQ(m.triangles.size(), 12U);
    EXPECT_TRUE(closed && topology(m).closed() && out.all().empty());
    EXPECT_DOUBLE_EQ(volume(m), 1000);
}

TEST(Solids, InsideOutIsTurnedOver) {
    bool closed = true;
    base::Diagnostics out;
    Mesh turned = soup(0);
    turn_over(turned);
    EXPECT_DOUBLE_EQ(volume(settled(0, turned, closed, out)), 1000);
    EXPECT_TRUE(closed);
}

TEST(Solids, AHoleIsSaid) {
    bool closed = true;
    base::Diagnostics out;
    const Mesh m = settled(3, soup(0, 1), closed, out);
    EXPECT_EQ(m.triangles.size(), 11U);
    EXPECT_FALSE(closed);
    ASSERT_EQ(out.all().size(), 1U);
    EXPECT_EQ(out.all()[0].code, "mesh-not-closed");
    EXPECT_EQ(out.all()[0].where.file, 3U);
    EXPECT_NE(out.all()[0].text.find("3 edges with one triangle only"), std::string::npos);
}

TEST(Solids, BodiesThatMayTouchAreSaid) {
    base::Diagnostics out;
    bool closed = true;
    EXPECT_DOUBLE_EQ(volume(united(0, {soup(0), soup(10.001), soup(-20)}, closed, out)), 3000);
    EXPECT_TRUE(closed && out.all().empty());
    EXPECT_DOUBLE_EQ(volume(united(0, {soup(30), soup(0), soup(10)}, closed, out)), 3000);
    EXPECT_FALSE(closed);
    ASSERT_EQ(out.all().size(), 1U);
    EXPECT_NE(out.all()[0].text.find("3 bodies, and number 2 and 3 may touch"), std::string::npos) << out.all()[0].text;
}

}  // namespace
}  // namespace obrys::mesh
