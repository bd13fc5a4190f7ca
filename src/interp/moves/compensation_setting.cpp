// What radius compensation works with: side, radius, where the tool's nose lies, how far it looks ahead.

#include <cmath>
#include <string>

#include "base/codes.hpp"
#include "base/number.hpp"
#include "cl/unknown_tool.hpp"
#include "interp/stream/path_stage.hpp"
#include "interp/values/nose_of_tool.hpp"
#include "path/compensation/preset.hpp"
#include "path/nose.hpp"
#include "shop/orientation.hpp"

#include "interp/moves/moves.hpp"

namespace obrys::interp {

namespace codes = base::codes;

namespace {

/// The contour is compensated in programmed coordinates: the tool, which no frame turns or scales, is brought there.
void into_frame(const Telling& run, path::Setting& s) {
    if (run.frame_is_identity || geom::is_shift_only(run.frame) || compensates_in_fixed_plane(run)) return;
    const PlaneAxes a = plane_axes(run.modal.plane);
    const geom::Frame back = geom::inverse(run.frame);
    geom::Vec3 tip, unit;
    coordinate(tip, a.u) = s.tip.x;
    coordinate(tip, a.v) = s.tip.y;
    coordinate(unit, a.u) = 1;
    const geom::Vec3 turned = geom::apply_direction(back, tip);
    s.tip = {coordinate(turned, a.u), coordinate(turned, a.v)};
    s.radius *= geom::length(geom::apply_direction(back, unit));
}

}  // namespace

double radius_in_stream(const Telling& run, double radius) {
    if (run.frame_is_identity || geom::is_shift_only(run.frame) || compensates_in_fixed_plane(run)) return radius;
    geom::Vec3 unit;
    coordinate(unit, plane_axes(run.modal.plane).u) = 1;
    return radius * geom::length(geom::apply_direction(run.frame, unit));
}

namespace {

/// The nose of a tool of no kind: outside turning towards the chuck, as of an insert whose orientation is not given.
constexpr int usual_nose = 3;

/// A lathe's path depends on where the nose lies; on other machines a tool without that is a mill.
void say_missing_nose(Reckoning& run) {
    if (run.env.machine.kind != shop::MachineKind::lathe) return;
    unchecked_once(run, codes::unknown_value, run.here(),
                   "radius compensation with T" + std::to_string(run.tool.number) +
                       ": where the programmed point lies on its nose is not known, orientation 3 is taken",
                   "give the tool as a turning insert (kind = \"turning\") with its orientation in the job");
}

int nose_of(Reckoning& run, const shop::Tool& tool) {
    const std::optional<int> nose = nose_orientation(tool);
    if (!nose) say_missing_nose(run);
    return nose.value_or(usual_nose);
}

/// As the tool table counts: of G41.1 L, of the tool that D names, or of the tool in use.
int table_nose_of(Reckoning& run, double radius) {
    if (run.modal.compensation_orientation >= 0) return run.modal.compensation_orientation;
    if (run.tool.data == nullptr) return 0;
    const std::optional<int> nose = table_orientation(*run.tool.data);
    if (nose || radius == 0 || run.env.machine.kind != shop::MachineKind::lathe) return nose.value_or(0);
    return shop::mirrored_orientation(nose_of(run, *run.tool.data));
}

std::string active_edge(const Reckoning& run) {
    if (run.tool.number == cl::unknown_tool) return "this tool";
    return "tool T" + std::to_string(run.tool.number) + " D" + std::to_string(run.tool.edge);
}

/// Compensation that changes nothing is said: no radius, none that is known, or none at all.
void say_missing_radius(Reckoning& run, const std::optional<double>& radius) {
    if (radius && *radius != 0) return;
    const shop::Tool* tool = run.tool.data;
    const bool turning =
        tool != nullptr && (tool->kind == shop::ToolKind::turning || tool->kind == shop::ToolKind::groove);
    const bool foreign = turning && run.env.machine.kind == shop::MachineKind::mill;
    if (radius && !turning) return;
    const std::string what = "radius compensation with " + active_edge(run);
    if (!radius || foreign)
        return unchecked_once(run, codes::unknown_value, run.here(),
                              what +
                                  (foreign                                      ? ", a lathe tool without radius"
                                   : run.tool.edge == 0 && run.tool.number != 0 ? ", which selects no radius"
                                                                                : ", whose radius is not known") +
                                  ": the contour is run without compensation",
                              "give the tool with its radius in the job");
    assume(run, run.here(), what + ", whose radius is 0: the contour is run without compensation",
           "give the tool with its radius in the job if it has one");
}

/// Radius that compensation works with, mm; nothing where it is not known or the edge has none.
std::optional<double> radius_in_force(const Reckoning& run) {
    if (!std::isnan(run.modal.compensation_radius)) return run.modal.compensation_radius;
    if (run.tool.data == nullptr || run.tool.edge == 0) return std::nullopt;
    return compensation_radius(*run.tool.data);
}

/// Compensation that holds one move back: the radius may be negative, nothing is looked ahead.
path::Setting held_move_setting(Reckoning& run) {
    path::Setting s = path::held_move_preset(length_unit(run.modal));
    if (run.modal.compensation == Modal::compensation_off) return s;
    const std::optional<double> known = radius_in_force(run);
    say_missing_radius(run, known);
    const double radius = known.value_or(0);
    s.side = run.modal.compensation == Modal::compensation_left ? path::Side::left : path::Side::right;
    s.radius = radius;
    s.rapid = run.modal.motion == Modal::rapid;
    // Also in a turned system the control counts the tip's place along the programmed axes.
    if (run.modal.plane == 18)
        s.tip = path::table_nose_offset(table_nose_of(run, radius), std::abs(radius)).value_or(geom::Vec2{});
    return s;
}

/// OFFN: the contour stands that much off. Beyond the middle of the tool the side would turn round.
void add_allowance(Reckoning& run, path::Setting& s) {
    const double more = run.modal.contour_allowance;
    if (more == 0) return;
    if (s.radius + more >= 0) {
        s.radius += more;
        return;
    }
    unchecked_once(
        run, codes::unsupported, run.here(),
        "OFFN=" + base::fixed(more, 3) +
            " takes more off than the tool's radius: which side of the contour the tool runs on is not known",
        "compensate on the other side, with OFFN of the other sign");
    s.radius = 0;
}

}  // namespace

path::Setting compensation_setting(Moving& run) {
    if (run.traits->compensation_holds_move) return held_move_setting(run);
    path::Setting s;
    // The way off goes round the contour's end as the way on goes round its start.
    s.approach = run.modal.approach == Modal::approach_contour ? path::Approach::around : path::Approach::normal;
    s.corner =
        run.modal.corner == Modal::corner_intersection ? path::OuterCorner::intersection : path::OuterCorner::arc;
    if (run.modal.compensation == Modal::compensation_off) return s;
    s.side = run.modal.compensation == Modal::compensation_left ? path::Side::left : path::Side::right;
    if (run.modal.corner_overshoot > 0 && s.corner == path::OuterCorner::arc)
        assume(run, run.here(),
               "DISC=" + base::fixed(run.modal.corner_overshoot, 0) +
                   ": outer corners are run as the conic whose middle lies that many per cent of the way from the " +
                   "arc to the crossing of the parallels");
    if (run.block.corner_end == Modal::corner_crossing) s.at_end = path::CornerEnd::crossing;
    if (run.block.corner_end == Modal::corner_open) s.at_end = path::CornerEnd::open;
    const std::uint32_t reported = run.unit().traits->compensation_window;
    if (run.modal.look_ahead > 0) {
        s.clearance = path::Clearance::avoided;
        s.window = static_cast<std::size_t>(run.modal.look_ahead);
    } else if (reported > 0) {
        s.clearance = path::Clearance::reported;
        s.window = reported;
    }
    const shop::Tool* tool = run.tool.data;
    const std::optional<double> radius = radius_in_force(run);
    say_missing_radius(run, radius);
    s.radius = radius.value_or(0) + run.tool.delta_radius;
    add_allowance(run, s);
    if (tool != nullptr && s.radius != 0 && run.modal.plane == 18 && run.env.machine.kind == shop::MachineKind::lathe)
        s.tip = path::nose_offset(nose_of(run, *tool), s.radius).value_or(geom::Vec2{});
    into_frame(run, s);
    return s;
}

}  // namespace obrys::interp
