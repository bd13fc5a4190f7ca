/// Motion blocks: where the axes go and by which path.

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/codes.hpp"
#include "interp/capture.hpp"
#include "interp/path_stage.hpp"
#include "interp/swivel.hpp"

namespace obrys::interp {

namespace codes = base::codes;
using program::Reference;

namespace {

constexpr std::uint64_t other_axes =
    bit(Code::a) | bit(Code::b) | bit(Code::c) | bit(Code::u) | bit(Code::v) | bit(Code::w);
constexpr std::uint64_t polar = bit(Code::polar_angle) | bit(Code::polar_radius);
constexpr std::uint64_t circle = bit(Code::i) | bit(Code::j) | bit(Code::k) | bit(Code::radius) |
                                 bit(Code::opening_angle) | bit(Code::i1) | bit(Code::j1) | bit(Code::k1) |
                                 bit(Code::turns) | bit(Code::pole_angle) | bit(Code::centre_at_pole);

/// R beside M19 is the spindle's angle.
std::uint64_t words_of_orientation(const BlockWords& b) {
    return std::find(b.m.begin(), b.m.end(), 19) != b.m.end() ? bit(Code::radius) : 0;
}

/// An axis the machine file does not list: moved all the same, but said.
void require_axis(Saying& run, const std::string& name) {
    if (run.env.machine.axes.empty() || run.env.machine.more_axes || machine_axis(run, name) != nullptr) return;
    unchecked(run, codes::unknown_word, run.here(), "the machine " + run.env.machine.name + " has no axis " + name,
              "name the right machine in the job, or add the axis to its file");
}

void extra_axis(Telling& run, const std::string& name, double value, std::uint8_t reference, bool rotary_by_letter) {
    require_axis(run, name);
    if (run.surface.kind != SurfaceMode::Kind::none && name == "C")
        return unchecked(run, codes::unsupported, run.here(),
                         "C in a program that is called within polar or cylindrical interpolation is not followed",
                         "write the contour in the program that switches it on");
    const shop::MachineAxis* known = machine_axis(run, name);
    const bool rotary = known != nullptr ? known->rotary : rotary_by_letter;
    double to = rotary ? value : value * length_unit(run.modal);
    const auto at = run.extra_axes.find(name);
    const auto k = name.size() == 1 ? std::string_view("XYZABCUVW").find(name[0]) : std::string_view::npos;
    if (is_incremental(run, reference))
        to += at == run.extra_axes.end() ? unknown_number : at->second;
    else if (k != std::string_view::npos)
        to += run.offsets.total[k];
    if (std::isnan(to))
        unchecked(run, codes::unknown_value, run.here(),
                  "where axis " + name + " goes depends on a value that is not known");
    if (rotary && k != std::string_view::npos && !run.env.tell_settings && run.offsets.reference[k] != 0)
        unchecked_once(run, codes::unsupported, run.here(),
                       "the zero offset of the rotary axis " + name +
                           " is not followed: it is taken to stand where the "
                           "program says");
    run.extra_axes[name] = to;
    emit(run, axis_record(name, to, rotary, rotary && tilted(run)));
}

}  // namespace

void extra_axes(Moving& run) {
    const BlockWords& b = run.block;
    const std::optional<Rotary> before = tilted(run) ? std::optional(rotary(run)) : std::nullopt;
    if ((b.present & other_axes) != 0) {
        for (int k = 3; k < 9; ++k)
            if (b.has(axis_code(k))) extra_axis(run, axis_name(k), b.get(axis_code(k)), b.ref(axis_code(k)), k < 6);
    }
    const std::vector<BlockWords::NamedAxis> named = std::move(run.block.axes);
    run.block.axes.clear();  // what is left there is said behind the block
    for (const auto& axis : named)
        extra_axis(run, axis.name, axis.value, axis.reference, axis.name[0] >= 'A' && axis.name[0] <= 'C');
    if (before) recount(run, *before);
}

namespace {

/// DC, ACP, ACN: which way round a rotary axis goes.
bool is_way_round(std::uint8_t reference) {
    return reference > static_cast<std::uint8_t>(Reference::shortest) &&
           reference <= 1 + static_cast<std::uint8_t>(Reference::negative);
}

void refuse_way_round(Saying& run, int axis) {
    const std::string name(1, "XYZ"[axis]);
    if (const shop::MachineAxis* known = machine_axis(run, name); known != nullptr && known->rotary) return;
    alarm(run, codes::value_range, run.here(),
          "DC, ACP and ACN say which way round a rotary axis goes, and " + name + " is a linear axis",
          "write " + name + "=AC(…)");
}

/// Target of the linear axes in the programmed frame.
geom::Vec3 cartesian_target(Moving& run) {
    const BlockWords& b = run.block;
    geom::Vec3 to = run.programmed_position;
    for (int k = 0; k < 3; ++k) {
        const Code code = axis_code(k);
        if (!b.has(code)) continue;
        const bool incremental = is_incremental(run, b.ref(code));
        const double v = b.get(code) * word_factor(run, k, b.ref(code));
        coordinate(to, k) = incremental ? coordinate(to, k) + v : v;
        if (is_way_round(b.ref(code))) refuse_way_round(run, k);
    }
    if (run.look == Look::turned_subprogram) {
        if (b.has(Code::u)) to.x += b.get(Code::u) * length_factor(run, 0, true);
        if (b.has(Code::w)) to.z += b.get(Code::w) * length_factor(run, 2, true);
    }
    return to;
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

}  // namespace

void arrive(Reckoning& run, const geom::Vec3& target) {
    run.programmed_position = target;
    run.position = run.frame_is_identity ? target : geom::apply(run.frame, target);
}

void require_feed(Telling& run) {
    if (run.spindle.doubtful) judge_stop(run);
    if (run.feed_valid || !run.feed_dropped) return;
    run.feed_dropped = false;
    emit(run, cl::Feed{0, run.modal.feed_mode});
}

geom::Vec3 programmed_target(Moving& run) {
    const geom::Vec3 to = cartesian_target(run);
    return (run.block.present & polar) != 0 ? polar_target(run, to) : to;
}

namespace {

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

bool path_motion(Moving& run) {
    const BlockWords& b = run.block;
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

}  // namespace

namespace {

/// A block that goes home, or to a machine position, names no place in the workpiece: it does not choose the zero in
/// which stock and part are.
bool names_no_place(const Moving& run) {
    if (run.moved || !keeps_offsets(run) || run.env.tell_settings) return false;
    if (run.block.suppress == Modal::suppress_all) return true;
    if (run.block.special != Modal::home) return false;
    for (int k = 0; k < 3; ++k)
        if (run.block.has(axis_code(k)) && !is_incremental(run, run.block.ref(axis_code(k)))) return false;
    return true;
}

/// The block's places are those of the machine, whatever zero offset is in force.
bool goes_by_machine(const Moving& run) {
    return run.block.suppress == Modal::suppress_all || run.block.special == Modal::reference_point ||
           run.block.special == Modal::fixed_point;
}

/// Once for each time that the program selects the zero offset.
void say_unknown_way(Telling& run) {
    run.datum_complained = run.capture == nullptr;
    const program::Traits& t = *run.traits;
    const std::string active = program::datum_name(t, run.modal.datum),
                      reference = program::datum_name(t, run.reference_datum);
    const bool mill = run.env.machine.kind == shop::MachineKind::mill;
    std::string example;
    const auto add = [&](std::uint32_t datum, const char* mill_place, const char* lathe_place) {
        if (datum == program::no_datum) return;  // nothing that a job could name
        example +=
            (example.empty() ? "" : " and ") + program::datum_key(t, datum) + " = " + (mill ? mill_place : lathe_place);
    };
    add(run.reference_datum, "{ x = 0.0, y = 0.0, z = -350.0 }", "{ x = 0.0, z = 120.0 }");
    if (run.modal.datum == run.reference_datum)
        return unchecked(run, codes::unknown_value, run.here(),
                         active +
                             ", or what is added to every zero offset, was written, and what it held before is not "
                             "known: how far the zero has moved is not known, the value before is taken as 0",
                         "give what it holds at the start of the program in [datum] of the job, e.g. " + example +
                             ", or write it before the first move");
    add(run.modal.datum, "{ x = 100.0, y = 0.0, z = -350.0 }", "{ x = 0.0, z = 240.0 }");
    unchecked(run, codes::unknown_value, run.here(),
              "where " + active + " lies against " + reference + " is not known: both are taken as the same zero",
              "give every offset that the program uses in [datum] of the job, e.g. " + example);
}

}  // namespace

void begin_motion(Moving& run) {
    if (names_no_place(run)) return;
    run.moved = true;
    emit_frame(run);
    if (keeps_offsets(run) && !run.offsets.length_judged) judge_length(run);
    if (!run.datum_known && !run.datum_complained && !goes_by_machine(run)) say_unknown_way(run);
}

bool is_incremental(const Reckoning& run, std::uint8_t reference) {
    if (reference == 0) return !run.modal.absolute;
    return reference == 1 + static_cast<std::uint8_t>(Reference::incremental) ||
           reference == 1 + static_cast<std::uint8_t>(Reference::diameter_incremental) ||
           reference == 1 + static_cast<std::uint8_t>(Reference::radius_incremental);
}

const shop::MachineAxis* machine_axis(const Saying& run, const std::string& name) {
    for (const shop::MachineAxis& a : run.env.machine.axes)
        if (a.name == name) return &a;
    return nullptr;
}

double length_factor(const Reckoning& run, int axis, bool incremental) {
    double factor = length_unit(run.modal);
    if (axis != 0 || run.modal.diameter == DiameterMode::off) return factor;
    if (run.modal.diameter == DiameterMode::absolute_only && incremental) return factor;
    return factor * 0.5;
}

double word_factor(const Reckoning& run, int axis, std::uint8_t reference) {
    if (reference <= 1 + static_cast<std::uint8_t>(Reference::negative))
        return length_factor(run, axis, is_incremental(run, reference));
    const bool diameter = reference == 1 + static_cast<std::uint8_t>(Reference::diameter_absolute) ||
                          reference == 1 + static_cast<std::uint8_t>(Reference::diameter_incremental);
    return length_unit(run.modal) * (diameter ? 0.5 : 1);
}

namespace {

/// G80 ends the cycle, and the controls' descriptions differ in which motion then holds: rapid, or the one before.
void say_rapid_by_cancel(Reckoning& run) {
    run.modal.rapid_by_cancel = false;
    assume(run, run.here(),
           "behind G80 the axes are taken to move in rapid traverse, though G1, G2 or G3 was in force before the cycle",
           "write G0 or G1 behind G80");
}

}  // namespace

namespace {

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
    const bool moves = (b.present & (linear_axes | polar | bit(Code::line_angle))) != 0;
    const bool turns = (b.present & circle & ~words_of_orientation(b)) != 0 && run.modal.motion != Modal::linear &&
                       run.modal.motion != Modal::rapid && run.modal.motion != Modal::canned_off;
    const bool others = (b.present & other_axes) != 0 || !b.axes.empty();
    if (b.special == Modal::pole_from_position || b.special == Modal::pole_from_zero ||
        b.special == Modal::pole_from_pole || b.special == Modal::pole_given) {
        set_pole(run);
        return false;
    }
    if (b.special == Modal::set_data || b.special == Modal::position_becomes || b.special == Modal::local_shift ||
        b.special == Modal::tool_length_by_axes || (b.special >= Modal::scaling_on && b.special <= Modal::rotation_off))
        return false;
    if (b.special == Modal::spline_cubic || b.special == Modal::spline_quadratic || b.special == Modal::nurbs_end) {
        begin_motion(run);
        return spline_motion(run);
    }
    const bool knots = run.modal.motion == Modal::nurbs && (b.has(Code::k) || b.has(Code::p));
    if (knots && !moves) return spline_motion(run);
    if (b.special == Modal::turning_cycle) {
        begin_motion(run);
        return turning_cycle(run);
    }
    if (b.special == Modal::circle_pocket) {
        begin_motion(run);
        return circle_pocket(run);
    }
    if (b.special == Modal::home) {
        go_home(run);
        return true;
    }
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

bool needs_path_stage(const Moving& run) {
    constexpr std::uint64_t corners = bit(Code::chamfer_length) | bit(Code::chamfer_leg) | bit(Code::round);
    return run.path->active() || run.modal.compensation != Modal::compensation_off ||
           (run.block.present & corners) != 0 || run.modal.round_modal > 0;
}

namespace {

/// A start that is not known yet only matters for the way onto the contour: any point off it will do.
path::Element straight_element(const geom::Vec3& at, const geom::Vec3& to, const PlaneAxes& a) {
    const auto start = [&](int k) {
        return std::isfinite(coordinate(at, k)) ? coordinate(at, k) : coordinate(to, k) + 1000;
    };
    path::Element e;
    e.from = {start(a.u), start(a.v)};
    e.to = {coordinate(to, a.u), coordinate(to, a.v)};
    e.w_from = start(a.w);
    e.w_to = coordinate(to, a.w);
    return e;
}

}  // namespace

void capture(Moving& run, const path::Element& e, bool rapid) {
    const double unit = length_unit(run.modal);
    const bool sized = run.look == Look::turned_subprogram;
    const auto size = [&](Code c) { return sized && run.block.has(c) ? run.block.get(c) * unit : 0; };
    run.capture->push_back({e, rapid, run.modal.compensation, corner_of_block(run), run.frame, run.here(),
                            run.top().stack, size(Code::a), size(Code::c), angle_of_whole_line(run)});
}

void straight_motion(Moving& run, const geom::Vec3& to, bool rapid) {
    const PlaneAxes a = plane_axes(run.modal.plane);
    const geom::Vec3& at = run.programmed_position;
    const bool known = std::isfinite(coordinate(to, a.u)) && std::isfinite(coordinate(to, a.v));
    if (!rapid && run.modal.feed_mode == cl::FeedMode::inverse_time) tell_inverse_feed(run, geom::length(to - at));
    if (!known) flush_path(run);
    if (!known)  // there is no corner to put them on
        for (const Code c : {Code::chamfer_length, Code::chamfer_leg, Code::round, Code::corner_feed}) run.block.use(c);
    if (!known || !needs_path_stage(run)) {
        const geom::Vec2 step{coordinate(to, a.u) - coordinate(at, a.u), coordinate(to, a.v) - coordinate(at, a.v)};
        if (step.x != 0 || step.y != 0) run.last_direction = step;
        run.free_contour = {};
        if (run.capture != nullptr) capture(run, straight_element(at, to, a), rapid);
        arrive(run, to);
        emit(run, cl::Linear{run.position, run.tool_axis, rapid});
        return;
    }
    plane_element(run, straight_element(at, to, a), to, rapid);
}

double programmed_coordinate(const Reckoning& run, const std::string& axis) {
    for (int k = 0; k < 3; ++k)
        if (axis.size() == 1 && axis[0] == "XYZ"[k])
            return coordinate(run.programmed_position, k) / length_factor(run, k, false);
    const auto found = run.extra_axes.find(axis);
    return found == run.extra_axes.end() ? unknown_number : found->second;
}

}  // namespace obrys::interp
