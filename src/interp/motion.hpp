#pragma once
/// Motion inside interp: what straight moves and arcs share. Private.

#include "interp/run.hpp"
#include "path/element.hpp"

namespace obrys::interp {

/// The working plane: indices (0 = x …) of its first and second axis and of its normal.
struct PlaneAxes {
    int u = 0, v = 1, w = 2;
};
[[nodiscard]] PlaneAxes plane_axes(int plane);

/// Millimetres per programmed unit of a linear axis: inches, and diameters of a lathe's X.
[[nodiscard]] double length_factor(const Run&, int axis, bool incremental);

/// Runs the block's arc to `to` (programmed frame); false where it could not be resolved.
[[nodiscard]] bool arc_motion(Run&, const geom::Vec3& to);
/// Runs an element of the working plane that ends at `to` (programmed frame), through the path stage where it is at
/// work.
void plane_element(Run&, path::Element element, const geom::Vec3& to, bool rapid);
[[nodiscard]] bool needs_path_stage(const Run&);
/// Straight move to `to` (programmed frame).
void straight_motion(Run&, const geom::Vec3& to, bool rapid);

}  // namespace obrys::interp
