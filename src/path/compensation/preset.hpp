#pragma once
/// Settings of controls that need more than one field of path::Setting, by name.

#include <optional>

#include "path/setting.hpp"

namespace obrys::path {

/// RS-274 as LinuxCNC 2.9's interpreter runs it. Its limits are numbers of the program's unit, whatever that is: `unit`
/// is its length in mm (25.4 under G20), and the arc's growth has a value for each.
[[nodiscard]] Setting held_move_preset(double unit);

/// Setting::tip for the same: from the nose's centre to the point that the program moves, by the orientation 0 … 9 of
/// the tool table; Vec2.x is z, Vec2.y is x. Its numbers count from a tool in front of the turning centre, so they are
/// those of nose_offset seen in a mirror; 0 is a mill.
[[nodiscard]] std::optional<geom::Vec2> table_nose_offset(int orientation, double radius);

}  // namespace obrys::path
