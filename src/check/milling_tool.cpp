#include "check/milling_tool.hpp"

#include <algorithm>

namespace obrys::check {

namespace milling = sim::milling;

namespace {

milling::CutterKind cutter_kind(shop::ToolKind kind) {
    using shop::ToolKind;
    switch (kind) {
        case ToolKind::ball: return milling::CutterKind::ball;
        case ToolKind::bull_nose: return milling::CutterKind::bull_nose;
        case ToolKind::drill:
        case ToolKind::centre_drill: return milling::CutterKind::drill;
        case ToolKind::countersink: return milling::CutterKind::countersink;
        case ToolKind::chamfer: return milling::CutterKind::chamfer;
        case ToolKind::t_slot: return milling::CutterKind::t_slot;
        case ToolKind::form: return milling::CutterKind::form;
        default: return milling::CutterKind::end_mill;  // taps and reamers too: flat
    }
}

bool drills(shop::ToolKind kind) {
    using shop::ToolKind;
    return kind == ToolKind::drill || kind == ToolKind::centre_drill || kind == ToolKind::tap ||
           kind == ToolKind::reamer;
}

std::vector<milling::Body> bodies(const std::vector<shop::ToolBody>& of) {
    std::vector<milling::Body> all;
    for (const shop::ToolBody& b : of) all.push_back({b.lower_diameter, b.upper_diameter, b.length});
    return all;
}

}  // namespace

bool has_assumed_body(const shop::Tool& tool) {
    const shop::ToolKind kind = shop::assumed_kind(tool);
    return tool.cutting_length && *tool.cutting_length > 0 && tool.shank.empty() && kind != shop::ToolKind::t_slot &&
           kind != shop::ToolKind::form;
}

milling::Cutter cutter_of(const shop::Tool& tool, double rub) {
    milling::Cutter c;
    const shop::ToolKind kind = shop::assumed_kind(tool);
    if (kind == shop::ToolKind::other) return c;  // without a radius: no tool
    c.kind = cutter_kind(kind);
    c.diameter = 2 * (tool.radius + tool.delta_radius);
    c.corner_radius = kind == shop::ToolKind::ball ? c.diameter / 2 : tool.corner_radius + tool.delta_corner_radius;
    c.tip_diameter = tool.tip_diameter;
    c.point_angle = geom::radians(tool.point_angle.value_or(kind == shop::ToolKind::drill ? 118 : 90));
    c.width = tool.width;
    c.neck_diameter = tool.neck_diameter;
    c.profile = tool.profile;
    c.cutting_length = shop::cutting_height(tool).value_or(unknown_height);
    c.shank = bodies(tool.shank);
    c.holder = bodies(tool.holder);
    if (has_assumed_body(tool)) {
        // A mill's body may rub along a wall that was cut before; in a hole it leaves the chips no way.
        const double diameter = c.diameter + (drills(kind) ? 2 * rub : 0);
        double left = tool.length > 0 ? tool.length - c.cutting_length : unknown_height;
        for (const milling::Body& b : c.holder) left -= b.length;
        if (left > 0) c.shank.push_back({diameter, diameter, left});
    }
    return c;
}

}  // namespace obrys::check
