#pragma once
/// Forces on a mill: its edges are cut into rings, each engaged over some angles; every revolution all teeth pass them.
/// mm, N, radians. Frame: x is the direction of the feed (its part square to the axis), z the axis up to the holder,
/// and an angle is that between y and a point of the edge, growing as the tool turns (clockwise seen from the holder):
/// Altintas, Manufacturing Automation, ch. 2. Forces are those on the tool.

#include <cmath>
#include <span>
#include <vector>

#include "geom/vec.hpp"
#include "sim/cutting/law.hpp"

namespace obrys::sim::force {

/// Angles over which a ring is in material, from 0 to 2 pi; `from` is not above `to`.
struct Arc {
    double from = 0, to = 0;
};

/// A piece of the edge of every tooth.
struct Ring {
    double radius = 0;
    double lean = geom::pi / 2;  ///< of the edge out of the plane normal to the axis: 0 an end, 90 degrees a flank
    double length = 0;           ///< of edge
    double height = 0;           ///< above the tip
    double lag = 0;              ///< by which it comes later than the tip of its tooth: 2 height tan(helix) / diameter
    std::vector<Arc> arcs;
};

struct Feed {
    double side = 0;  ///< mm a tooth square to the axis
    double down = 0;  ///< along the axis, into the material; below 0: up
};

struct Forces {
    geom::Vec3 mean;            ///< over a revolution
    double mean_resultant = 0;  ///< mean of the size, which is more than the size of the mean
    double peak = 0;            ///< largest size
    double rms = 0;
    double peak_side = 0;    ///< largest part square to the axis, which bends the tool
    double mean_torque = 0;  ///< N mm
    double peak_torque = 0;
    double edge_part = 0;                    ///< of the mean torque, what the edge takes whatever the chip's thickness
    double engaged = 0;                      ///< part of a revolution in which a tooth is in material
    double largest_chip = 0, mean_chip = 0;  ///< mm
};

/// The chip at an angle of a ring; not above 0: none.
[[nodiscard]] double chip(const Ring& ring, const Feed& feed, double angle);

/// `steps`: about so many places of a revolution.
[[nodiscard]] Forces forces(std::span<const Ring> rings, int teeth, const Feed& feed, const cutting::Law& law,
                            int steps = 360);

/// Of what a tooth's feed of 1 mm removes, mm2 across the feed: of the way (side, down), a unit vector.
[[nodiscard]] double section(std::span<const Ring> rings, const Feed& way);

/// Rings of a cylinder from one height to another; `helix` radians.
[[nodiscard]] std::vector<Ring> flank(double diameter, double low, double high, double helix, int rings, Arc arc);
/// Of a round (a ball, a corner) about a ring of radius `ring` between two leans.
[[nodiscard]] std::vector<Ring> round_edge(double ring, double radius, double low_lean, double high_lean, double helix,
                                           int rings);

/// The same means in closed form, of an end mill by the linear law: for holding the sums to.
struct ClosedMeans {
    double x = 0, y = 0, axial = 0;  ///< axial: along the edge, of a right-hand helix out of the holder
    double torque = 0;
};
[[nodiscard]] ClosedMeans closed_means(const cutting::Law& law, int teeth, double diameter, double depth, double feed,
                                       Arc arc);

}  // namespace obrys::sim::force
