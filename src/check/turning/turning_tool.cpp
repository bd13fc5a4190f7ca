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
constexpr double wider = 0.1;     ///< mm that what holds a blade or a drill is wider than it, at least, on either side
constexpr double rub = 0.022;     ///< mm by which a body that is assumed stands out of the hole that its edges made
constexpr double shortest_edge = 1e-3;  ///< mm

/// From the flat tip's rim over a cone of this height, or a round corner, up to the radius, and on to `length`.
Contour section(double radius, double tip, double height, double corner, double length) {
    const double quarter = std::tan(geom::pi / 8), rim = corner > 0 ? radius - corner : tip;
    const double at = corner > 0 ? corner : height, bulge = corner > 0 ? quarter : 0;
    Contour c;
    const auto add = [&](double z, double x, double b) {
        if (!c.vertices.empty() && geom::distance(c.vertices.back().p, {z, x}) < 1e-9) c.vertices.pop_back();
        c.vertices.push_back({{z, x}, b});
    };
    add(0, -rim, bulge);
    add(at, -radius, 0);
    const double end = std::max(length, at + shortest_edge);
    add(end, -radius, 0);
    add(end, radius, 0);
    add(at, radius, bulge);
    if (rim > 1e-9) add(0, rim, 0);
    return c;
}

/// On a lathe length 1 of tool data lies along X, and lengths of a table are offsets from any other tool: neither says
/// where the tool ends.
shop::Tool measured(shop::Tool tool) {
    if (tool.table || !tool.parameters.empty()) tool.length = 0;
    return tool;
}

Contour on_axis(const shop::Tool& t, double radius) {
    if (!(radius > 0)) return {};
    const double length =
        is_carried_anywhere(t) || carried_by(t).empty() ? endless : shop::cutting_height(measured(t)).value_or(endless);
    switch (t.kind) {
        case ToolKind::end_mill:
        case ToolKind::tap:
        case ToolKind::reamer: return section(radius, radius, 0, 0, length);
        case ToolKind::ball:
        case ToolKind::bull_nose: return section(radius, radius, 0, std::min(t.corner_radius, radius), length);
        case ToolKind::drill:
        case ToolKind::centre_drill:
        case ToolKind::countersink:
        case ToolKind::chamfer: return section(radius, t.tip_diameter / 2, shop::point_height(t), 0, length);
        default: return {};
    }
}

/// A cylinder or cone about the tool's axis.
Contour frustum(double z, const sim::milling::Body& body, double more) {
    const double low = body.lower_diameter / 2 + more, high = body.upper_diameter / 2 + more, end = z + body.length;
    Contour c{{{{z, -low}, 0}, {{end, -high}, 0}}, true};
    if (high > 1e-9) c.vertices.push_back({{end, high}, 0});
    if (low > 1e-9) c.vertices.push_back({{z, low}, 0});
    return c;
}

}  // namespace

Contour turning_outline(const shop::Tool& tool) {
    if (!shop::is_milling(tool.kind)) return shop::outline(tool);
    return on_axis(tool, tool.kind == ToolKind::tap ? core_radius(tool) : tool.radius + tool.delta_radius);
}

bool is_carried_anywhere(const shop::Tool& tool) {
    return shop::is_milling(tool.kind) && !(tool.shank.empty() && tool.holder.empty()) &&
           !shop::cutting_height(measured(tool));
}

bool is_held_by_nothing(const shop::Tool& tool) {
    return shop::is_milling(tool.kind) && tool.holder.empty() && !stands_in_spindle(measured(tool));
}

std::vector<Carried> carried_by(const shop::Tool& tool) {
    std::vector<Carried> all;
    for (const Contour& body : tool.bodies) all.push_back({Carried::Kind::holder, body});
    if (!shop::is_milling(tool.kind) || is_carried_anywhere(tool)) return all;
    const shop::Tool own = measured(tool);
    const sim::milling::Cutter cutter = cutter_of(own, rub);
    const bool assumed = has_assumed_body(own), machine = stands_in_spindle(own);
    double z = cutter.cutting_length;
    const auto add = [&](Carried::Kind kind, const sim::milling::Body& body) {
        all.push_back({kind, frustum(z, body, kind == Carried::Kind::machine ? wider : 0)});
        z += body.length;
    };
    for (const auto& body : cutter.shank)
        add(assumed && &body == &cutter.shank.front() ? Carried::Kind::edges : Carried::Kind::shank, body);
    for (const auto& body : cutter.holder)
        add(machine && &body == &cutter.holder.back() ? Carried::Kind::machine : Carried::Kind::holder, body);
    return all;
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
