/// Cycles that the control itself has and calls like programs; one of the user with that name counts before them
/// (SINUMERIK search path: the program's folder, subprograms, then the cycles of user, builder and control).

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include "base/codes.hpp"
#include "base/whole.hpp"
#include "interp/calls/calls.hpp"
#include "interp/setup/setup.hpp"
#include "interp/setup/tilted_axes.hpp"
#include "shop/kinematics.hpp"

namespace obrys::interp {

namespace codes = base::codes;
using program::Call;
using program::ControlCycle;

std::optional<double> plain(Reckoning& run, const Call& call, std::size_t i) {
    if (i >= call.arguments.size() || call.arguments[i] == program::no_expr) return 0;
    const Value v = evaluate(run, call.arguments[i]);
    if (run.stopped || !v.is_number() || std::isnan(v.number)) return std::nullopt;
    return v.number;
}

namespace {

/// CYCLE832(tolerance, mode, tolerance of rotary axes): nothing moves. Without arguments and with tolerance 0 it is
/// switched off. The last digit of the mode is 1 finishing, 2 semi-finishing, 3 roughing, 4 precision; the one before
/// it 1 where the third argument counts. Source: SINUMERIK Operate, cycles, "High Speed Settings (CYCLE832)".
void path_tolerance(Telling& run, const Call& call) {
    const auto tolerance = plain(run, call, 0), mode = plain(run, call, 1), rotary = plain(run, call, 2);
    if (run.stopped) return;
    if (!tolerance) return unchecked(run, codes::unknown_value, call.where, "the tolerance of this cycle is not known");
    run.modal.tolerance_by = "CYCLE832";
    run.modal.tolerance_cycle = std::abs(*tolerance) * length_unit(run.modal);
    cl::Tolerance t;
    t.contour = run.modal.tolerance_cycle;
    const int digits = base::whole<int>(mode.value_or(0), 0, 999'999).value_or(0);
    constexpr int precision = 4;
    if (t.contour > 0 && digits % 10 <= precision) t.filter = static_cast<cl::Filter>(digits % 10);
    if (t.contour > 0 && digits / 10 % 10 == 1) t.rotary = std::abs(rotary.value_or(0));
    flush_path(run);
    emit(run, t);
}

/// CYCLE800(_FR,_TC,_ST,_MODE,_X0,_Y0,_Z0,_A,_B,_C,_X1,_Y1,_Z1,_DIR,_FR_I).
using SwivelNumbers = std::array<double, 15>;
enum SwivelArgument : std::size_t {
    swivel_retracts = 0,
    swivel_status = 2,
    swivel_mode = 3,
    swivel_before = 4,
    swivel_angles = 7,
    swivel_behind = 10,
    swivel_direction = 13,
    swivel_distance = 14
};

/// Its numbers; nothing where one is not known.
std::optional<SwivelNumbers> swivel_numbers(Reckoning& run, const Call& call) {
    constexpr std::size_t name = 1;
    SwivelNumbers out{};
    for (std::size_t i = 0; i < out.size(); ++i) {
        const auto v = i == name ? std::optional(0.0) : plain(run, call, i);
        if (run.stopped || !v) return std::nullopt;
        out[i] = *v;
    }
    return out;
}

/// Three turns, each about an axis of the system that the ones before have turned; pairs of bits of the mode name it: 1
/// X, 2 Y, 3 Z. Nothing where an angle has none.
std::optional<geom::Frame> turned_axis_by_axis(int mode, std::span<const double> angles) {
    geom::Frame f;
    for (const double angle : angles) {
        const int axis = mode & 3;
        mode /= 4;
        if (axis == 0 && angle != 0) return std::nullopt;
        if (axis != 0) f = f * geom::Frame::rotation(axis - 1, geom::radians(angle));
    }
    return f;
}

/// What the digits of _ST say besides new or additive, and the tip's place: from hundreds on.
constexpr std::array status_digits{"it aligns the tool (_ST, hundreds)", "it swivels by hand (_ST, thousands)",
                                   "it does not swivel (_ST, ten thousands)",
                                   "how it chooses the direction in which the axes turn (_ST, hundred thousands)"};

/// Why a form of CYCLE800 is not run; empty: it is.
std::string_view why_no_swivel(const SwivelNumbers& n, bool turns) {
    constexpr double other_angles = 64;
    const auto retracts = base::whole<int>(n[swivel_retracts], 0, 5);
    if (!retracts || *retracts == 3) return "what its _FR says of retracting the tool is not known";
    if (n[swivel_distance] < 0)
        return "the way by which the tool retracts is negative (_FR_I), which stops the control";
    const auto status = base::whole<int>(n[swivel_status], 0, 999'999);
    if (!status) return "its _ST is none that is known";
    int digits = *status / 100;
    for (const char* says : status_digits) {
        if (digits % 10 != 0) return says;
        digits /= 10;
    }
    if (*status % 10 > 1 || *status / 10 % 10 > 1)
        return "what it says with _ST besides new, additive and tracking of the tip is not followed";
    if (turns && !(n[swivel_mode] >= 0 && n[swivel_mode] < other_angles))
        return "its angles are not said axis by axis (_MODE)";
    return {};
}

/// _FR: the tool goes away before the axes turn. 5: along itself by _FR_I. 1: Z of the machine goes to a place that the
/// swivel data record holds, 2: then X and Y, 4: as far along the tool as the travels let it; where that is, is not
/// known here. Source: SINUMERIK Operate, Operating Manual Turning 06/2019, p. 611 (the ways), programs of CAM systems
/// (their numbers): docs/dialects/sinumerik.md.
void retract_before_swivel(Calling& run, const SwivelNumbers& n, const base::Span& where) {
    if (n[swivel_retracts] == 0) return;
    constexpr double by_distance = 5, along_z = 1, unknown = std::numeric_limits<double>::quiet_NaN();
    begin_motion(run);
    const Rotary axes = rotary(run);
    const bool stand_at_zero =
        std::all_of(axes.values.begin(), axes.values.end(), [](double v) { return std::abs(v) < 1e-12; });
    geom::Vec3 to{unknown, unknown, unknown};
    if (n[swivel_retracts] == by_distance && (tilted(run) || stand_at_zero)) {
        const bool known = shop::has_rotary(shop::chain_of(run.env.machine));
        to = run.position + n[swivel_distance] * length_unit(run.modal) * (known ? axis_of_tool(run) : run.tool_axis);
    } else {
        assume(run, where,
               "where the tool retracts to before the axes turn (_FR) is a setting of the machine: that place is not "
               "known");
        if (n[swivel_retracts] == along_z && stand_at_zero && !tilted(run))
            to = {run.position.x, run.position.y, unknown};
    }
    stand_at(run, to);
    emit(run, cl::Linear{run.position, run.tool_axis, true});
}

geom::Vec3 vector_at(const SwivelNumbers& n, std::size_t first, double unit) {
    return unit * geom::Vec3{n[first], n[first + 1], n[first + 2]};
}

/// CYCLE800: shift to X0 Y0 Z0, turn, shift to X1 Y1 Z1 in the turned system. The programmed frame ends, and without
/// angles the tilted plane. _DIR: the rotary axes go there, to the smaller or the greater of their two positions; 0:
/// they stand. Source: SINUMERIK Operate, "Swivel plane/swivel tool (CYCLE800)".
void swivel_plane(Calling& run, const Call& call) {
    const auto numbers = swivel_numbers(run, call);
    if (run.stopped) return;
    if (!numbers) return say_not_run(run, call, "it tilts the working plane by a value that is not known");
    const SwivelNumbers& n = *numbers;
    const bool turns = n[swivel_angles] != 0 || n[swivel_angles + 1] != 0 || n[swivel_angles + 2] != 0;
    if (const std::string_view why = why_no_swivel(n, turns); !why.empty())
        return say_not_run(run, call, std::string(why));
    const auto turned = turned_axis_by_axis(base::whole<int>(n[swivel_mode], 0, 63).value_or(0),
                                            std::span(n).subspan(swivel_angles, 3));
    if (!turned) return say_not_run(run, call, "its _MODE names no axis for an angle");
    const double unit = length_unit(run.modal);
    geom::Frame plane = geom::Frame::shift(vector_at(n, swivel_before, unit)) * *turned *
                        geom::Frame::shift(vector_at(n, swivel_behind, unit));
    if (std::fmod(n[swivel_status], 10) == 1) plane = active_plane(run) * plane;
    flush_path(run);
    if (!(run.modal.programmed == active_plane(run)))
        assume(run, call.where, "this cycle ends the programmed frame too (TRANS, ROT, SCALE, MIRROR)",
               "write the frame behind it");
    retract_before_swivel(run, n, call.where);
    if (run.stopped) return;
    const bool was_tilted = tilted(run), has_axes = shop::has_rotary(shop::chain_of(run.env.machine));
    const BeforeSwivel stood{on_workpiece(run), axis_of_tool(run), 0};
    const geom::Vec3 axis_before = run.tool_axis;
    run.modal.programmed = {};
    if (turns || was_tilted || plane == geom::Frame{})
        tilt(run, plane, {n[swivel_direction], false}, call.where);
    else
        run.modal.programmed = plane, update_frame(run);
    if (run.stopped) return;
    constexpr double tracks = 10;
    if (n[swivel_direction] != 0 && (turns || was_tilted || has_axes))
        swivel(run, n[swivel_status] >= tracks, true, stood, call.where);
    else
        tell_rotary(run, axis_before);
}

}  // namespace

void say_not_run(Saying& run, const Call& call, const std::string& why) {
    const program::Problem& p = run.unit().problems[call.problem];
    unchecked(run, codes::unsupported, p.where, p.text + " is not run: " + why);
}

namespace {

void hole(Calling& run, const Call& call) {
    auto read = read_hole_call(run, call);
    if (!read || run.stopped) return;
    if (call.kind == program::CallKind::modal)
        run.modal_call.hole = std::move(*read);
    else
        call_hole(run, *read, {});
}

}  // namespace

void control_cycle(Calling& run, const Call& call) {
    if (call.kind == program::CallKind::modal) run.modal_call = {};
    switch (call.control_cycle) {
        case ControlCycle::hole: return hole(run, call);
        case ControlCycle::hole_row:
        case ControlCycle::hole_circle: return call_hole_pattern(run, call);
        case ControlCycle::path_tolerance: return path_tolerance(run, call);
        case ControlCycle::swivel: return swivel_plane(run, call);
        default: return say_not_run(run, call, run.unit().problems[call.problem].reason);
    }
}

}  // namespace obrys::interp
