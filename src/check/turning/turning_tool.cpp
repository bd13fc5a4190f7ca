#include "check/turning/turning_tool.hpp"

#include <algorithm>
#include <cmath>

#include "check/milling_tool.hpp"
#include "geom/region.hpp"

namespace obrys::check {

using geom::Contour;
using shop::ToolKind;

namespace {

constexpr double endless = 1000;  ///< mm, as long as nobody says how long
constexpr double wider = 0.1;     ///< mm that a blade's holder is wider than the blade, at least, on either side

/// Half a section: from the flat tip's rim over a cone of this height, or a round corner, up to the radius.
Contour section(double radius, double tip, double height, double corner) {
    const double quarter = std::tan(geom::pi / 8), rim = corner > 0 ? radius - corner : tip;
    const double at = corner > 0 ? corner : height, bulge = corner > 0 ? quarter : 0;
    Contour c;
    const auto add = [&](double z, double x, double b) {
        if (!c.vertices.empty() && geom::distance(c.vertices.back().p, {z, x}) < 1e-9) c.vertices.pop_back();
        c.vertices.push_back({{z, x}, b});
    };
    add(0, -rim, bulge);
    add(at, -radius, 0);
    add(endless, -radius, 0);
    add(endless, radius, 0);
    add(at, radius, bulge);
    if (rim > 1e-9) add(0, rim, 0);
    return c;
}

Contour on_axis(const shop::Tool& t, double radius) {
    if (!(radius > 0)) return {};
    switch (t.kind) {
        case ToolKind::end_mill:
        case ToolKind::tap:
        case ToolKind::reamer: return section(radius, radius, 0, 0);
        case ToolKind::ball:
        case ToolKind::bull_nose: return section(radius, radius, 0, std::min(t.corner_radius, radius));
        case ToolKind::drill:
        case ToolKind::centre_drill:
        case ToolKind::countersink:
        case ToolKind::chamfer: return section(radius, t.tip_diameter / 2, shop::point_height(t), 0);
        default: return {};
    }
}

}  // namespace

Contour turning_outline(const shop::Tool& tool) {
    if (!shop::is_milling(tool.kind)) return shop::outline(tool);
    return on_axis(tool, tool.kind == ToolKind::tap ? core_radius(tool) : tool.radius + tool.delta_radius);
}

Contour whole_tap(const shop::Tool& tap) { return on_axis(tap, tap.radius + tap.delta_radius); }

Contour behind_blade(const shop::Tool& tool) {
    if (tool.kind != ToolKind::groove || !(tool.cutting_depth > 0) || !tool.bodies.empty()) return {};
    if (tool.direction == shop::BladeDirection::in) return {};
    shop::Tool wide = tool;
    wide.width += 2 * wider;
    wide.corner_radius = wide.corner_radius_left = wide.corner_radius_right = 0;
    wide.cutting_depth = endless;
    const double aside = tool.reference == shop::ReferenceCorner::left ? -wider : wider;
    const bool face = tool.direction == shop::BladeDirection::face;
    return geom::moved(shop::outline(wide),
                       face ? geom::Vec2{tool.cutting_depth, aside} : geom::Vec2{aside, tool.cutting_depth});
}

}  // namespace obrys::check
