#pragma once
/// What the tests of pockets, slots and studs share: a mill over the middle of the figure (mm, 1/min).

#include <gtest/gtest.h>

#include "cycles/mill/mill.hpp"
#include "cycles/mill/milling_testing.hpp"
#include "cycles/shapes.hpp"
#include "geom/offset.hpp"

namespace obrys::cycles::testing {

inline constexpr geom::Vec3 pocket_start{50, 40, 60};

inline Situation pocket_mill(double radius) {
    Situation s;
    s.at = pocket_start;
    s.tool_radius = radius;
    s.spindle_speed = 2000;
    s.spindle_direction = 1;
    s.tool_plunge_angle = 5;
    return s;
}

/// The tool reaches all of the region that it fits into.
inline void expect_covers(const std::vector<Move>& moves, const geom::Region& region, double side, double radius,
                          double height) {
    const geom::Box b = geom::box(region);
    const geom::Region reach = geom::offset(geom::offset(region, -radius - side), radius);
    for (double u = b.lo.x + 0.1; u < b.hi.x; u += 0.9)
        for (double v = b.lo.y + 0.1; v < b.hi.y; v += 0.9)
            if (geom::contains(reach, {u, v})) {
                EXPECT_TRUE(covered(moves, {u, v}, radius, height)) << u << ' ' << v;
            }
}

/// All but the stud.
inline geom::Region outside_of(const geom::Contour& stud) { return {{rectangle(4000, 4000, 0), geom::reversed(stud)}}; }

}  // namespace obrys::cycles::testing
