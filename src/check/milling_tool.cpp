#include "check/milling_tool.hpp"

namespace obrys::check {

sim::milling::Cutter cutter_of(const shop::Tool& tool) {
    sim::milling::Cutter c;
    c.diameter = 2 * (tool.radius + tool.delta_radius);
    c.corner_radius = tool.corner_radius + tool.delta_corner_radius;
    c.kind = c.corner_radius <= 0                ? sim::milling::CutterKind::end_mill
             : c.corner_radius >= c.diameter / 2 ? sim::milling::CutterKind::ball
                                                 : sim::milling::CutterKind::bull_nose;
    c.cutting_length = tool.cutting_length.value_or(tool.length > 0 ? tool.length : 1000);
    return c;
}

bool has_shank(const shop::Tool&) { return false; }
bool has_holder(const shop::Tool&) { return false; }
bool may_plunge(const shop::Tool&) { return true; }

}  // namespace obrys::check
