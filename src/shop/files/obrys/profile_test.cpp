#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/number.hpp"
#include "shop/contour_check.hpp"
#include "shop/files/obrys/job_testing.hpp"

namespace obrys::shop {
namespace {

using geom::pi;

std::optional<Profile> stock(const std::string& keys) {
    Reading r;
    Job j = read_job(r.add("program = \"A\"\n[stock]\n" + keys), r.sources, r.diagnostics);
    EXPECT_EQ(r.complaints(), "");
    return j.stock;
}

double area(const std::string& keys) {
    const auto p = stock(keys);
    if (!p || p->region.contours.size() != 1) return -1;
    return signed_area(p->region.contours.front());
}

std::string wrong(const std::string& keys) { return job_places("program = \"A\"\n[stock]\n" + keys); }

TEST(Profile, AreasByHand) {
    EXPECT_NEAR(area("bar = {diameter = 80, length = 100}"), 4000, 1e-9);
    EXPECT_NEAR(area("tube = {outer_diameter = 80, inner_diameter = 60, length = 100}"), 1000, 1e-9);
    EXPECT_NEAR(area("cone = {left_diameter = 80, right_diameter = 40, length = 10}"), 300, 1e-9);
    EXPECT_NEAR(area("cone = {left_diameter = 0, right_diameter = 40, length = 10}"), 100, 1e-9);
    EXPECT_NEAR(area("profile = [{z = 0.0, x = 106.0}, {z = 300.0, x = 226.0}]"), 300 * 166, 1e-9);
    EXPECT_NEAR(area("diameter = true\nprofile = [{z = 0, x = 106}, {z = 300, x = 226}]"), 300 * 83, 1e-9);
    EXPECT_NEAR(area("closed = true\nprofile = [{z=0,x=5}, {z=4,x=5}, {z=4,x=8}, {z=0,x=8}, {z=0,x=5}]"), 12, 1e-9);
    // a half disc on the axis, drawn from left to right over the top: clockwise
    EXPECT_NEAR(area("profile = [{z=-5, x=0, r=5, direction=\"cw\"}, {z=5, x=0}]"), pi * 25 / 2, 1e-9);
    EXPECT_NEAR(area("profile = [{z=-5, x=0, r=-5}, {z=5, x=0}]"), pi * 25 / 2, 1e-9);
    // a bar 10 x 10 with a quarter circle of radius 2 hollowed out of its upper right corner, and with one rounded on
    EXPECT_NEAR(area("profile = [{z=0,x=10}, {z=8,x=10,r=2,direction=\"ccw\"}, {z=10,x=8}]"), 100 - pi, 1e-9);
    EXPECT_NEAR(area("profile = [{z=0,x=10}, {z=8,x=10,r=2,direction=\"cw\"}, {z=10,x=8}]"), 100 - 4 + pi, 1e-9);
}

TEST(Profile, AFullDiscOfTwoArcs) {
    EXPECT_NEAR(area("closed = true\nprofile = [{z=-5,x=20,r=5}, {z=5,x=20,r=5}]"), 25 * pi, 1e-9);
    EXPECT_NEAR(area("closed = true\nprofile = [{z=0,x=15,r=5,large=true}, {z=5,x=20,r=5}]"), 25 * pi, 1e-9);
}

TEST(Profile, RegionIsClosedToTheAxisCounterClockwise) {
    const auto p = stock("profile = [{z = 0, x = 10}, {z = 50, x = 20}]");
    ASSERT_TRUE(p);
    EXPECT_EQ(p->drawn.vertices, (std::vector<geom::Vertex>{{{0, 10}, 0}, {{50, 20}, 0}}));
    EXPECT_FALSE(p->drawn.closed);
    EXPECT_EQ(p->region.contours.front().vertices,
              (std::vector<geom::Vertex>{{{0, 0}, 0}, {{50, 0}, 0}, {{50, 20}, 0}, {{0, 10}, 0}}));
    EXPECT_TRUE(p->region.contours.front().closed);
}

TEST(Profile, PositionsOfBlanks) {
    const auto range = [](const std::string& keys) {
        const auto p = stock("bar = {diameter = 10, " + keys + "}");
        double low = 1e9, high = -1e9;
        for (const geom::Vertex& v : p->region.contours.front().vertices)
            low = std::min(low, v.p.x), high = std::max(high, v.p.x);
        return std::pair(low, high);
    };
    EXPECT_EQ(range("length = 30"), std::pair(-30.0, 0.0));
    EXPECT_EQ(range("length = 30, z_min = 5"), std::pair(5.0, 35.0));
    EXPECT_EQ(range("length = 30, z_max = 2"), std::pair(-28.0, 2.0));
    EXPECT_EQ(range("z_min = -1, z_max = 2"), std::pair(-1.0, 2.0));
}

TEST(Profile, Mistakes) {
    EXPECT_EQ(wrong("profile = [{z=0,x=1}]"), "3:1: the profile has only one point\n");
    EXPECT_EQ(wrong("profile = 3"), "3:11: 'profile' must be an array of points, not a whole number\n");
    EXPECT_EQ(wrong("profile = [{z=0,x=-1}, {z=5,x=1}]"), "3:19: 'x' must not be negative, it is -1\n");
    EXPECT_EQ(wrong("profile = [{z=0}, {z=5,x=1,rad=2}]"),
              "3:12: a profile point has no 'x'\n3:28: unknown key 'rad' in a profile point\n");
    EXPECT_EQ(wrong("profile = [{z=0,x=1,r=2}, {z=10,x=1}]"),
              "3:23: radius 2 mm is too small: the next point is 10.000 mm away\n");
    EXPECT_EQ(wrong("profile = [{z=0,x=1}, {z=10,x=1,r=3}]"), "3:35: 'r' on the last point: no edge follows it\n");
    EXPECT_EQ(wrong("profile = [{z=0,x=1,r=0}, {z=10,x=1}]"), "3:23: 'r' must not be 0\n");
    EXPECT_EQ(wrong("profile = [{z=0,x=1,large=true}, {z=10,x=1}]"), "3:12: 'direction' and 'large' need an 'r'\n");
    EXPECT_EQ(wrong("profile = [{z=0,x=1,r=-20,direction=\"cw\"}, {z=10,x=1}]"),
              "3:23: 'r' is negative and 'direction' is given\n");
    EXPECT_EQ(wrong("profile = [{z=0,x=1}, {z=0,x=1}, {z=9,x=1}]"),
              "3:23: this point is the same as the one before it\n");
    EXPECT_EQ(wrong("profile = [{z=0,x=0}, {z=9,x=0}]"), "3:1: the profile encloses no area\n");
    EXPECT_EQ(wrong("profile = [{z=0,x=1,r=6}, {z=10,x=1}]"),
              "3:12: the arc from this point crosses the turning axis\n");
    EXPECT_EQ(wrong("profile = [{z=0,x=9},{z=5,x=0},{z=9,x=9}]"),
              "3:12: the edge from this point crosses or touches the one that closes the profile to the axis\n");
    EXPECT_EQ(wrong("bar = {diameter = 3, lenght = 4}"),
              "3:7: 'bar' has no 'length'\n3:22: unknown key 'lenght' in 'bar'\n");
    EXPECT_EQ(wrong("bar = {diameter = 3, length = 4, z_min = 0, z_max = 4}"),
              "3:22: 'length', 'z_min' and 'z_max' together\n");
    EXPECT_EQ(wrong("bar = {diameter = 3, z_min = 4, z_max = 4}"), "3:41: 'z_max' must be greater than 'z_min'\n");
    EXPECT_EQ(wrong("tube = {outer_diameter = 3, inner_diameter = 4, length = 4}"),
              "3:46: 'inner_diameter' must be smaller than 'outer_diameter'\n");
    EXPECT_EQ(wrong("cone = {left_diameter = 0, right_diameter = 0, length = 4}"),
              "3:8: both diameters of the cone are 0\n");
    EXPECT_EQ(wrong("closed = true\nbar = {diameter = 3, length = 4}"),
              "3:1: 'closed' means nothing without a 'profile'\n");
    EXPECT_EQ(wrong("bar = {diameter = 3, length = 4}\ncone = {left_diameter = 1, right_diameter = 1, length = 4}"),
              "4:1: [stock] has both 'bar' and 'cone'\n");
}

TEST(Profile, ACrossingNamesBothEdges) {
    EXPECT_EQ(job_complaints("program = \"A\"\n[stock]\nprofile = [\n  {z = 0, x = 10},\n  {z = 10, x = 20},\n  {z = "
                             "10, x = 10},\n  {z = 0, x = 19},\n]\n"),
              "job.toml:6:3: error: the profile crosses or touches itself: the edge from this point [job-value]\n"
              "    {z = 10, x = 10},\n"
              "    ^~~~~~~~~~~~~~~~\n"
              "job.toml:4:3: note: meets the edge from this point\n"
              "    {z = 0, x = 10},\n"
              "    ^~~~~~~~~~~~~~~\n");
    // an arc that bulges through the line opposite
    EXPECT_NE(wrong("closed = true\nprofile = [{z=0,x=10},{z=20,x=10},{z=20,x=14,r=-10.1},{z=0,x=14}]").find("crosses"),
              std::string::npos);
    // an overlap of two edges on one line
    EXPECT_NE(wrong("closed = true\nprofile = [{z=0,x=5},{z=20,x=5},{z=10,x=5},{z=10,x=9}]").find("crosses"),
              std::string::npos);
}

/// The same region whatever vertex it begins with.
geom::Contour from_lowest(geom::Contour c) {
    auto& v = c.vertices;
    std::rotate(v.begin(),
                std::min_element(v.begin(), v.end(),
                                 [](const geom::Vertex& a, const geom::Vertex& b) {
                                     return std::pair(a.p.x, a.p.y) < std::pair(b.p.x, b.p.y);
                                 }),
                v.end());
    return c;
}

RC_GTEST_PROP(ProfileProperty, EitherDirectionGivesTheSameRegion, ()) {
    const int n = *rc::gen::inRange(2, 12);
    std::string there = "profile = [", back = "]";
    for (int i = 0; i < n; ++i) {
        // Steps of 10 along z; an arc's rise over its chord stays below the corners' distance from the axis.
        const std::string point =
            "{z = " + std::to_string(10 * i) + ", x = " + std::to_string(*rc::gen::inRange(20, 24));
        const int r = i + 1 < n ? *rc::gen::inRange(-1, 2) * 40 : 0;
        there += point + (r != 0 ? ", r = " + std::to_string(r) : "") + "}, ";
        // Backwards the radius belongs to the point where the edge now begins: the next one, which was written before.
        static int pending = 0;
        if (i == 0) pending = 0;
        back = point + (pending != 0 ? ", r = " + std::to_string(-pending) : "") + "}, " + back;
        pending = r;
    }
    const auto a = stock(there + "]"), b = stock("profile = [" + back);
    RC_ASSERT(a.has_value() && b.has_value());
    const geom::Contour ca = from_lowest(a->region.contours.front()), cb = from_lowest(b->region.contours.front());
    RC_ASSERT(ca.vertices.size() == cb.vertices.size());
    for (std::size_t i = 0; i < ca.vertices.size(); ++i) {
        RC_ASSERT(ca.vertices[i].p == cb.vertices[i].p);
        RC_ASSERT(std::abs(ca.vertices[i].bulge - cb.vertices[i].bulge) < 1e-15);
    }
    RC_ASSERT(signed_area(ca) > 0);
}

}  // namespace
}  // namespace obrys::shop
