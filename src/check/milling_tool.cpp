#include "check/milling_tool.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>

#include "base/text.hpp"

namespace obrys::check {

namespace milling = sim::milling;

namespace {

constexpr double least_nose = 20;          ///< mm: the flange of an HSK-E 20 (DIN 69893-5)

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
        default: return milling::CutterKind::end_mill;  // a tap's core and reamers too: flat
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

bool stands_in_spindle(const shop::Tool& tool) { return tool.length >= shop::least_gauge_length; }

bool may_bore(const shop::Tool& tool) {
    const shop::ToolKind kind = shop::assumed_kind(tool);
    return kind == shop::ToolKind::reamer || (kind == shop::ToolKind::end_mill && !shop::may_plunge(tool));
}

double coarse_pitch(const shop::Tool& tap) {
    // ISO 261, coarse pitches: from this diameter on.
    constexpr std::array<std::array<double, 2>, 21> coarse{
        {{1, 0.25}, {1.4, 0.3}, {1.6, 0.35}, {2, 0.4},  {2.5, 0.45}, {3, 0.5},   {3.5, 0.6},
         {4, 0.7},  {5, 0.8},   {6, 1},      {8, 1.25}, {10, 1.5},   {12, 1.75}, {14, 2},
         {18, 2.5}, {24, 3},    {30, 3.5},   {36, 4},   {42, 4.5},   {48, 5},    {56, 5.5}}};
    const double diameter = 2 * (tap.radius + tap.delta_radius);
    double pitch = std::min(0.25, 0.2 * diameter);
    for (const auto& [from, own] : coarse)
        if (diameter >= from - 1e-9) pitch = own;
    return pitch;
}

double core_radius(const shop::Tool& tap) {
    constexpr double depth = 1.082532;  // 5/4 of the height of the fundamental triangle, in pitches: d - D1
    const double diameter = 2 * (tap.radius + tap.delta_radius);
    const double core = diameter - depth * tap.pitch.value_or(coarse_pitch(tap));
    return 0.5 * std::max(core, 0.5 * diameter);
}

namespace {

/// By its type or its name: no table of a control has a mark for it.
bool is_forming(const shop::Tool& tap) {
    const std::string said = base::to_upper(tap.type + " " + tap.name);
    constexpr std::array signs{"FORMING", "FORM TAP", "ROLL TAP", "THREAD FORMER", "GEWINDEFORM"};
    return std::any_of(signs.begin(), signs.end(),
                       [&](std::string_view sign) { return said.find(sign) != std::string::npos; });
}

/// ISO 965-1: tolerance TD1 of the minor diameter of internal threads, mm; grade 7 is 1.25 times grade 6.
double minor_tolerance(double pitch) {
    const double grade_6 = pitch < 0.9 ? 0.433 * pitch - 0.19 * std::pow(pitch, 1.22) : 0.23 * std::pow(pitch, 0.7);
    return 1.25 * grade_6;
}

}  // namespace

double widest_hole_radius(const shop::Tool& tap) {
    constexpr double formed = 0.4;  // pitches; makers of forming taps ask for 0.45 (M10: 9.3)
    const double pitch = tap.pitch.value_or(coarse_pitch(tap));
    if (is_forming(tap)) return tap.radius + tap.delta_radius - 0.5 * formed * pitch;
    return core_radius(tap) + 0.5 * minor_tolerance(pitch);
}

namespace {

/// What is known of the end that does not cut.
std::optional<double> known_core(const shop::Tool& tool) {
    using shop::ToolKind;
    switch (shop::assumed_kind(tool)) {
        case ToolKind::tap: return core_radius(tool);
        case ToolKind::reamer: return 0.8 * (tool.radius + tool.delta_radius);
        case ToolKind::countersink:
        case ToolKind::chamfer:
            if (tool.tip_diameter > 0) return tool.tip_diameter / 2;
            return std::nullopt;
        case ToolKind::form:
            if (!tool.profile.empty() && tool.profile.front().p.x > 0) return tool.profile.front().p.x;
            return std::nullopt;
        default: return std::nullopt;
    }
}

}  // namespace

double blind_radius(const shop::Tool& tool) {
    if (shop::may_plunge(tool)) return 0;
    const double radius = tool.radius + tool.delta_radius;
    if (shop::assumed_kind(tool) == shop::ToolKind::t_slot) return radius;
    return known_core(tool).value_or(radius / 2);
}

double core_on_slant(const shop::Tool& tool) {
    if (shop::may_plunge(tool)) return 0;
    if (shop::assumed_kind(tool) == shop::ToolKind::t_slot && tool.neck_diameter > 0) return tool.neck_diameter / 2;
    return known_core(tool).value_or((tool.radius + tool.delta_radius) / 5);
}

namespace {

/// How wide the uppermost part is that the job tells; 0: not known.
double width_at_top(const shop::Tool& tool, const milling::Cutter& c) {
    if (!c.holder.empty()) return c.holder.back().upper_diameter;
    if (!c.shank.empty()) return c.shank.back().upper_diameter;
    if (c.kind == milling::CutterKind::t_slot) return c.neck_diameter;
    if (c.kind == milling::CutterKind::form) return tool.profile.empty() ? 0 : 2 * tool.profile.back().p.x;
    return c.diameter;
}

/// No tool ends in the air: up to its gauge plane it goes on as wide as what the job tells of it, and above stands the
/// nose of the spindle, at least as wide as all below and as the smallest taper.
void put_into_spindle(const shop::Tool& tool, milling::Cutter& c) {
    if (!stands_in_spindle(tool)) return;
    double height = std::min(c.cutting_length, tool.length), widest = std::max(c.diameter, least_nose);
    for (const auto* bodies : {&c.shank, &c.holder})
        for (const milling::Body& b : *bodies) {
            height += b.length;
            widest = std::max({widest, b.lower_diameter, b.upper_diameter});
        }
    constexpr double same = 1e-6;  // mm
    const double gap = tool.length - height, width = width_at_top(tool, c);
    if (gap > same && width > 0) (c.holder.empty() ? c.shank : c.holder).push_back({width, width, gap});
    c.holder.push_back({widest, widest, unknown_height});
}

}  // namespace

milling::Cutter cutter_of(const shop::Tool& tool, double rub) {
    milling::Cutter c;
    const shop::ToolKind kind = shop::assumed_kind(tool);
    if (kind == shop::ToolKind::other) return c;  // without a radius: no tool
    c.kind = cutter_kind(kind);
    c.diameter = 2 * (kind == shop::ToolKind::tap ? core_radius(tool) : tool.radius + tool.delta_radius);
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
    put_into_spindle(tool, c);
    return c;
}

}  // namespace obrys::check
