/// Motion blocks: where the axes go and by which path.

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "base/codes.hpp"
#include "interp/capture.hpp"
#include "interp/flow/flow.hpp"

namespace obrys::interp {

namespace codes = base::codes;

namespace {

constexpr std::uint64_t circle = bit(Code::i) | bit(Code::j) | bit(Code::k) | bit(Code::radius) |
                                 bit(Code::opening_angle) | bit(Code::i1) | bit(Code::j1) | bit(Code::k1) |
                                 bit(Code::turns) | bit(Code::pole_angle) | bit(Code::centre_at_pole);

/// R beside M19 is the spindle's angle.
std::uint64_t words_of_orientation(const BlockWords& b) {
    return std::find(b.m.begin(), b.m.end(), 19) != b.m.end() ? bit(Code::radius) : 0;
}

void dwell(Moving& run) {
    const BlockWords& b = run.block;
    cl::Dwell d;
    if (b.has(Code::p))
        d.seconds = b.get(Code::p);
    else if (b.has(Code::feed) && run.traits->dwell_in_feed_words)
        d.seconds = b.get(Code::feed);
    else if (b.has(Code::spindle) && run.traits->dwell_in_feed_words)
        d.revolutions = b.get(Code::spindle);
    else if (run.traits->dwell_in_feed_words)
        unchecked(run, codes::value_range, run.here(), "G4 says neither how long nor how many revolutions it waits",
                  "write F with seconds or S with revolutions of the spindle");
    if (d.seconds < 0 || d.revolutions < 0) {
        alarm(run, codes::value_range, run.here(), "the dwell of G4 is negative");
        return;
    }
    emit(run, d);
}

/// R+ and R-: the path along the axis is longer or shorter by the tool's radius (compensation of paraxial blocks).
geom::Vec3 lengthened(Moving& run, geom::Vec3 to) {
    const double radius = active_radius(run);
    if (std::isnan(radius))
        unchecked(run, codes::unknown_value, run.here(),
                  "R+ and R- need the radius of tool T" + std::to_string(run.tool.number) + ", which is not known",
                  "give the tool with its radius in the job");
    const double by = run.block.paraxial == Modal::paraxial_longer ? radius : -radius;
    for (int k = 0; k < 3; ++k) {
        if (!run.block.has(axis_code(k))) continue;
        const double step = coordinate(to, k) - coordinate(run.programmed_position, k);
        if (step != 0) coordinate(to, k) += step > 0 ? by : -by;
    }
    return to;
}

/// G38.2 … G38.5 by their last digit; G31 goes on whether it has touched or not.
cl::Seek sought(int number) {
    switch (number) {
        case 2: return cl::Seek::contact;
        case 4: return cl::Seek::release;
        case 5: return cl::Seek::release_or_end;
        default: return cl::Seek::contact_or_end;
    }
}

/// G38.2 …: the move is run to its end; what it touches is not known here.
bool probe(Moving& run) {
    flush_path(run);
    unchecked(run, codes::unsupported, run.here(),
              "probing is not simulated: the move is run to its end, and what it finds is not known");
    const geom::Vec3 to = programmed_target(run);
    require_feed(run);
    arrive(run, to);
    emit(run, cl::Linear{run.position, run.tool_axis, false, sought(run.modal.motion_number)});
    run.probed = true;
    forget_live(run, program::SystemVariable::probed_coordinate);
    forget_live(run, program::SystemVariable::probe_success);
    return true;
}

/// About a pole whose coordinates span another plane than the working plane: the same, there.
bool motion_across(Moving& run) {
    if (run.modal.compensation == Modal::compensation_off) flush_path(run);
    if (run.capture != nullptr || needs_path_stage(run)) {
        unchecked(run, codes::unsupported, run.here(),
                  "this circle or polar block does not lie in the working plane, in which radius compensation, "
                  "roundings, chamfers and contours of cycles do: it is run as a straight move",
                  "end radius compensation (R0) before it");
        straight_motion(run, programmed_target(run), run.modal.motion == Modal::rapid);
        return true;
    }
    const int pole = std::exchange(run.modal.pole_plane, 0), working = std::exchange(run.modal.plane, pole);
    const bool moved = path_motion(run);
    run.modal.plane = working;
    run.modal.pole_plane = pole;
    run.last_direction = {};
    return moved;
}

}  // namespace

bool path_motion(Moving& run) {
    const BlockWords& b = run.block;
    const bool about_pole = b.has(Code::centre_at_pole) || (b.present & polar_words) != 0;
    if (about_pole && run.modal.pole_plane != 0) return motion_across(run);
    const Modal m = run.modal.motion;
    geom::Vec3 to = programmed_target(run);
    if (b.has(Code::line_angle) && !line_by_angle(run, to)) return false;
    if (b.paraxial == Modal::paraxial_longer || b.paraxial == Modal::paraxial_shorter) to = lengthened(run, to);
    if (m != Modal::rapid && !b.rapid) require_feed(run);
    if (run.modal.smoothing != 0 || run.modal.compressor || run.modal.tolerance_cycle > 0 || run.modal.blend > 0 ||
        run.modal.blend_free)
        note_rounding(run);
    const bool arc = m == Modal::arc_cw || m == Modal::arc_ccw || m == Modal::arc_via || m == Modal::arc_tangent ||
                     m == Modal::arc_about;
    const bool by_radius = b.has(Code::radius) && run.traits->radius_makes_arc;
    if (arc || b.has(Code::centre_at_pole) || by_radius) return arc_motion(run, to);
    if (m == Modal::rapid || m == Modal::linear) {
        straight_motion(run, to, m == Modal::rapid);
        return true;
    }
    return thread_motion(run, to);
}

namespace {

/// G80 ends the cycle, and the controls' descriptions differ in which motion then holds: rapid, or the one before.
void say_rapid_by_cancel(Reckoning& run) {
    run.modal.rapid_by_cancel = false;
    assume(run, run.here(),
           "behind G80 the axes are taken to move in rapid traverse, though G1, G2 or G3 was in force before the cycle",
           "write G0 or G1 behind G80");
}

/// Under G93 a feed says how long its own block takes. Controls whose missing feed is an alarm have raised it.
void judge_inverse_feed(Moving& run) {
    const BlockWords& b = run.block;
    const Modal m = run.modal.motion;
    const bool feeds = (m == Modal::linear || m == Modal::arc_cw || m == Modal::arc_ccw) && !b.rapid;
    if (!feeds || b.has(Code::feed) || run.traits->needs_feed) return;
    unchecked(run, codes::feed_missing, run.here(),
              "in inverse time mode every block has its own F: the control stops here, and the last F is taken",
              "write F in the block, or a feed per minute before it");
}

/// Words that make of the block something else than a way to its coordinates; nothing where it goes there all the same.
std::optional<bool> special_motion(Cycling& run) {
    switch (const Modal special = run.block.special) {
        case Modal::pole_from_position:
        case Modal::pole_from_zero:
        case Modal::pole_from_pole:
        case Modal::pole_given: set_pole(run); return false;
        case Modal::set_data:
        case Modal::position_becomes:
        case Modal::local_shift:
        case Modal::position_reset:
        case Modal::tool_length_by_axes: return false;
        case Modal::spline_cubic:
        case Modal::spline_quadratic:
        case Modal::nurbs_end: begin_motion(run); return spline_motion(run);
        case Modal::turning_cycle: begin_motion(run); return turning_cycle(run);
        case Modal::circle_pocket: begin_motion(run); return circle_pocket(run);
        case Modal::home: go_home(run); return true;
        default:
            if (special >= Modal::scaling_on && special <= Modal::rotation_off) return false;
            return std::nullopt;
    }
}

}  // namespace

bool motion(Cycling& run) {
    const BlockWords& b = run.block;
    if (b.special == Modal::dwell) {
        dwell(run);
        return false;
    }
    if (b.retract != 0) retract_tool(run);
    if (run.stopped) return false;
    complete_arc(run);
    const bool moves = (b.present & (linear_axes | polar_words | bit(Code::line_angle))) != 0;
    const bool turns = (b.present & circle & ~words_of_orientation(b)) != 0 && run.modal.motion != Modal::linear &&
                       run.modal.motion != Modal::rapid && run.modal.motion != Modal::canned_off;
    const bool others = (b.present & other_axes) != 0 || !b.axes.empty();
    if (b.special != Modal::linear)
        if (const std::optional<bool> moved = special_motion(run)) return *moved;
    const bool knots = run.modal.motion == Modal::nurbs && (b.has(Code::k) || b.has(Code::p));
    if (knots && !moves) return spline_motion(run);
    if (!moves && !turns && !others) return false;
    if (run.modal.feed_mode == cl::FeedMode::inverse_time) judge_inverse_feed(run);
    if (run.modal.rapid_by_cancel) say_rapid_by_cancel(run);
    if ((b.present & linear_axes & ~run.known_axes) != 0 && run.surface.kind == SurfaceMode::Kind::none)
        for (int k = 0; k < 3; ++k)
            if (b.has(axis_code(k))) require_axis(run, std::string(1, "XYZ"[k]));
    begin_motion(run);
    if (others && run.look != Look::turned_subprogram) extra_axes(run);
    if (run.stopped) return false;
    if (run.modal.motion == Modal::canned) return canned_motion(run);
    if (run.modal.motion == Modal::nurbs) return spline_motion(run);
    if (run.modal.motion == Modal::probe) return probe(run);
    if (b.special == Modal::rigid_tap) return rigid_tap(run);
    if (run.modal.motion == Modal::canned_off) {
        alarm(run, codes::value_range, run.here(), "axis words without a motion: G80 is in force",
              "write G0 or G1 before them");
        return false;
    }
    if (b.special == Modal::reference_point || b.special == Modal::fixed_point) return reference_point(run);
    if (b.machine_axis && b.suppress == Modal::linear)
        unchecked(run, codes::unsupported, run.here(),
                  "an axis is moved here by the name it has in the machine: it is taken as the axis of the program");
    if (b.suppress != Modal::linear && moves) return machine_move(run);
    return path_motion(run);
}

}  // namespace obrys::interp
