// What follows from the dimensions of milling tools.
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "base/number.hpp"
#include "shop/size_range.hpp"
#include "shop/tool.hpp"

namespace obrys::shop {

namespace {

constexpr double size_slack = 1e-9;  ///< mm; dimensions that differ by less are the same

bool has_cone(ToolKind kind) {
    return kind == ToolKind::drill || kind == ToolKind::centre_drill || kind == ToolKind::countersink ||
           kind == ToolKind::chamfer;
}

std::string mm(double v) { return base::shortest(v) + " mm"; }

DimensionFault corner_fault(const Tool& t) {
    if (!(t.corner_radius >= 0)) return {"corner_radius", "the corner radius is negative"};
    if (t.corner_radius > t.radius + size_slack)
        return {"corner_radius", "the corner radius (" + mm(t.corner_radius) + ") is greater than the tool's radius (" +
                                     mm(t.radius) + ")"};
    if (t.kind == ToolKind::t_slot && 2 * t.corner_radius > t.width + size_slack)
        return {"corner_radius",
                "two corner radii of " + mm(t.corner_radius) + " do not fit on a width of " + mm(t.width)};
    return {};
}

DimensionFault cone_fault(const Tool& t) {
    if (!has_cone(t.kind)) return {};
    const double angle = t.point_angle.value_or(180);
    const bool flat = t.kind == ToolKind::drill || t.kind == ToolKind::centre_drill;
    if (!(angle > 0 && (flat ? angle <= 180 : angle < 180)))
        return {"point_angle", std::string("the point angle must be above 0 and ") + (flat ? "at most" : "below") +
                                   " 180 degrees, it is " + base::shortest(angle)};
    if (!(t.tip_diameter >= 0)) return {"tip_diameter", "the tip diameter is negative"};
    if (t.tip_diameter >= 2 * t.radius)
        return {"tip_diameter", "the tip diameter (" + mm(t.tip_diameter) + ") must be smaller than the diameter (" +
                                    mm(2 * t.radius) + ")"};
    return {};
}

DimensionFault disc_fault(const Tool& t) {
    if (t.kind != ToolKind::t_slot) return {};
    if (!(t.width > 0)) return {"width", "the width must be greater than 0"};
    if (!(t.neck_diameter > 0)) return {"neck_diameter", "the neck diameter must be greater than 0"};
    if (t.neck_diameter >= 2 * t.radius)
        return {"neck_diameter", "the neck diameter (" + mm(t.neck_diameter) + ") must be smaller than the diameter (" +
                                     mm(2 * t.radius) + ")"};
    return {};
}

DimensionFault length_fault(const Tool& t) {
    if (!t.cutting_length) return {};
    if (!(*t.cutting_length > 0)) return {"cutting_length", "the cutting length must be greater than 0"};
    const double point = point_height(t);
    if (point > *t.cutting_length + 1e-6)
        return {"cutting_length", "the cutting length (" + mm(*t.cutting_length) +
                                      ") is shorter than the point, which is " + base::fixed(point, 3) + " mm high"};
    const double round = t.kind == ToolKind::ball ? t.radius : t.kind == ToolKind::bull_nose ? t.corner_radius : 0;
    if (round > *t.cutting_length + size_slack)
        return {"cutting_length", "the cutting length (" + mm(*t.cutting_length) +
                                      ") is shorter than the corner radius (" + mm(round) + ")"};
    return {};
}

/// Where the length of the edges is not given, something of the tool's length must be left for them.
DimensionFault room_fault(const Tool& t) {
    const double bodies = height_of(t.shank) + height_of(t.holder);
    if (!(t.length > 0) || bodies == 0 || cutting_height(t)) return {};
    return {"length", "the length (" + mm(t.length) + ") leaves nothing for the edges: shank and holder are " +
                          mm(bodies) + " long together"};
}

}  // namespace

double height_of(const std::vector<ToolBody>& bodies) {
    return std::accumulate(bodies.begin(), bodies.end(), 0.0,
                           [](double sum, const ToolBody& b) { return sum + b.length; });
}

std::string_view kind_word(ToolKind kind) {
    static constexpr std::array<std::string_view, 14> words{
        "groove",       "turning",     "other", "end-mill", "ball",    "bull-nose", "drill",
        "centre-drill", "countersink", "tap",   "reamer",   "chamfer", "t-slot",    "form"};
    return words[static_cast<std::size_t>(kind)];
}

ToolKind assumed_kind(const Tool& tool) {
    if (tool.kind != ToolKind::other || !(tool.radius > 0)) return tool.kind;
    if (!(tool.corner_radius > 0)) return ToolKind::end_mill;
    return tool.corner_radius < tool.radius - size_slack ? ToolKind::bull_nose : ToolKind::ball;
}

DimensionFault dimension_fault(const Tool& tool) {
    if (!is_milling(tool.kind)) return {};
    if (tool.kind == ToolKind::form && tool.profile.size() < 2) return {"profile", "a form tool needs a profile"};
    if (!(tool.radius > 0)) return {"diameter", "the diameter must be greater than 0"};
    for (const double size : {tool.length, tool.cutting_length.value_or(0), tool.corner_radius, tool.width})
        if (const std::string problem = size_problem(size, false); !problem.empty())
            return {"length", "a size of " + mm(size) + " " + problem};
    if (tool.radius > largest_radius) return {"diameter", "no tool has a diameter of " + mm(2 * tool.radius)};
    for (const auto fault : {cone_fault, disc_fault, corner_fault, length_fault})
        if (DimensionFault found = fault(tool); !found.ok()) return found;
    for (const auto& [key, bodies] : {std::pair{"shank", &tool.shank}, std::pair{"holder", &tool.holder}})
        for (const ToolBody& b : *bodies)
            if (!(b.lower_diameter > 0 && b.upper_diameter > 0 && b.length > 0))
                return {key, std::string("the diameters and the length of each body of the ") + key +
                                 " must be greater than 0"};
    return room_fault(tool);
}

double point_height(const Tool& tool) {
    if (!has_cone(tool.kind) || !tool.point_angle || *tool.point_angle >= 180) return 0;
    const double flank = tool.radius - tool.tip_diameter / 2;
    return flank / std::tan(geom::radians(*tool.point_angle) / 2);
}

bool may_plunge(const Tool& tool) {
    if (tool.plunges) return *tool.plunges;
    if (tool.plunge_angle && *tool.plunge_angle > 0 && *tool.plunge_angle < 90) return false;
    switch (tool.kind) {
        case ToolKind::tap:
        case ToolKind::reamer:
        case ToolKind::t_slot: return false;
        case ToolKind::countersink:
        case ToolKind::chamfer: return tool.tip_diameter == 0;
        case ToolKind::form: return !tool.profile.empty() && tool.profile.front().p.x == 0;
        default: return true;
    }
}

std::optional<double> cutting_height(const Tool& tool) {
    if (tool.cutting_length && *tool.cutting_length > 0) return tool.cutting_length;
    if (tool.kind == ToolKind::t_slot && tool.width > 0) return tool.width;
    if (tool.kind == ToolKind::form && !tool.profile.empty()) return tool.profile.back().p.y;
    const double rest = tool.length - height_of(tool.shank) - height_of(tool.holder);
    return rest > 0 ? std::optional(rest) : std::nullopt;
}

}  // namespace obrys::shop
