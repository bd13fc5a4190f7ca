// Kinds of milling tools that tool data say.
#include <array>
#include <cmath>
#include <utility>

#include "shop/files/siemens/toa.hpp"
#include "shop/reading_testing.hpp"

namespace obrys::shop {
namespace {

using enum ToolKind;

/// A tool of one type with radius 5, corner radius 1 and length 100.
Tool toa(int type, const std::string& more = "") {
    Reading r;
    const auto t = read_toa(
        r.add("$TC_DP1[1,1]=" + std::to_string(type) + "\n$TC_DP3[1,1]=100\n$TC_DP6[1,1]=5\n$TC_DP7[1,1]=1\n" + more,
              "A.TOA"),
        r.sources, r.diagnostics);
    EXPECT_EQ(r.complaints(), "");
    return t.at(0);
}

TEST(Toa, TypesBecomeKinds) {
    const std::pair<int, ToolKind> all[]{
        {100, bull_nose}, {110, ball},      {111, ball},         {120, end_mill},    {121, bull_nose}, {130, end_mill},
        {131, bull_nose}, {140, bull_nose}, {145, other},        {150, t_slot},      {151, t_slot},    {200, drill},
        {205, drill},     {210, reamer},    {220, centre_drill}, {230, countersink}, {231, end_mill},  {240, tap},
        {241, tap},       {250, reamer},    {700, other},        {500, turning}};
    for (const auto& [type, kind] : all) {
        const Tool t = toa(type);
        EXPECT_EQ(t.kind, kind) << type;
        EXPECT_TRUE(dimension_fault(t).ok()) << type << dimension_fault(t).text;
    }
    EXPECT_EQ(toa(120).corner_radius, 0);  // it is not evaluated for 120
    EXPECT_EQ(toa(121).corner_radius, 1);
    EXPECT_EQ(toa(110).corner_radius, 5);
    EXPECT_EQ(toa(151).width, 1);
    EXPECT_EQ(toa(151).assumed, "neck diameter 5 mm");
    EXPECT_EQ(toa(200).assumed, "point angle 118 degrees");
    EXPECT_EQ(toa(121, "$TC_DP16[1,1]=0.5\n").corner_radius, 1.5);
    EXPECT_EQ(toa(121, "$TC_DP7[1,1]=9\n").kind, ball);  // larger than the radius: no more than a ball
}

TEST(Toa, ConesAndCaps) {
    const Tool cone = toa(155, "$TC_DP11[1,1]=10\n");
    EXPECT_EQ(cone.kind, form);
    ASSERT_EQ(cone.profile.size(), 3U);
    EXPECT_EQ(cone.profile[1].p, (geom::Vec2{5, 0}));
    EXPECT_NEAR(cone.profile[2].p.x, 5 + 100 * std::tan(geom::radians(10)), 1e-12);
    EXPECT_EQ(cone.assumed, "radius 5 mm at the tip, cutting edge up to the height of 100 mm");
    EXPECT_EQ(toa(156, "$TC_DP11[1,1]=10\n").profile.size(), 4U);
    EXPECT_EQ(toa(155, "$TC_DP11[1,1]=90\n").kind, other);
    const Tool cap = toa(111, "$TC_DP7[1,1]=13\n");  // 13 - sqrt(169 - 25) = 1
    EXPECT_EQ(cap.kind, form);
    ASSERT_EQ(cap.profile.size(), 3U);
    EXPECT_NEAR(cap.profile[1].p.y, 1, 1e-12);
    EXPECT_NEAR(4 * std::atan(cap.profile[0].bulge), std::asin(5.0 / 13), 1e-12);
}

}  // namespace
}  // namespace obrys::shop
