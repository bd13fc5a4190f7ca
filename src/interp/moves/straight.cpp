/// Straight moves: where the words of the block lead, and the way there.

#include <cmath>
#include <utility>

#include "base/codes.hpp"
#include "interp/capture.hpp"
#include "interp/moves/moves.hpp"
#include "interp/setup/tilted_axes.hpp"
#include "interp/stream/path_stage.hpp"

namespace obrys::interp {

namespace codes = base::codes;
using program::Reference;

void require_axis(Saying& run, const std::string& name) {
    if (run.env.machine.axes.empty() || run.env.machine.more_axes || machine_axis(run, name) != nullptr) return;
    unchecked(run, codes::unknown_word, run.here(), "the machine " + run.env.machine.name + " has no axis " + name,
              "name the right machine in the job, or add the axis to its file");
}

namespace {

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
    if (rotary && k != std::string_view::npos && !run.env.stand_alone && run.offsets.reference[k] != 0)
        unchecked_once(run, codes::unsupported, run.here(),
                       "the zero offset of the rotary axis " + name +
                           " is not followed: it is taken to stand where the "
                           "program says");
    run.extra_axes[name] = to;
    take_along(run, axis_end(name, to, rotary, rotary && tilted(run)));
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
        const std::uint8_t reference = b.ref(code);
        const bool incremental = is_incremental(run, reference);
        const double factor = reference == 0 ? length_factor(run, k, incremental) : word_factor(run, k, reference);
        const double v = b.get(code) * factor;
        coordinate(to, k) = incremental ? coordinate(to, k) + v : v;
        if (is_way_round(reference)) refuse_way_round(run, k);
    }
    if (run.look == Look::turned_subprogram) {
        if (b.has(Code::u)) to.x += b.get(Code::u) * length_factor(run, 0, true);
        if (b.has(Code::w)) to.z += b.get(Code::w) * length_factor(run, 2, true);
    }
    return to;
}

}  // namespace

namespace {

/// The block's coordinates are the place, as the program writes them: absolute, in millimetres, none of them a
/// diameter.
bool is_place_as_written(const Moving& run) {
    const BlockWords& b = run.block;
    const ModalState& m = run.modal;
    if (!m.absolute || m.inch_geometry || m.diameter != DiameterMode::off || run.look == Look::turned_subprogram ||
        (b.present & polar_words) != 0)
        return false;
    for (const Code c : {Code::x, Code::y, Code::z})
        if (b.has(c) && b.ref(c) != 0) return false;
    return true;
}

}  // namespace

geom::Vec3 programmed_target(Moving& run) {
    if (is_place_as_written(run)) {
        const BlockWords& b = run.block;
        geom::Vec3 to = run.programmed_position;
        if (b.has(Code::x)) to.x = b.get(Code::x);
        if (b.has(Code::y)) to.y = b.get(Code::y);
        if (b.has(Code::z)) to.z = b.get(Code::z);
        return to;
    }
    const geom::Vec3 to = cartesian_target(run);
    return (run.block.present & polar_words) != 0 ? polar_target(run, to) : to;
}

namespace {

/// A block that goes home, or to a machine position, names no place in the workpiece: it does not choose the zero in
/// which stock and part are.
bool names_no_place(const Moving& run) {
    if (run.moved || !keeps_offsets(run)) return false;
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
    judge_plane_taken_up(run);
    emit_frame(run);
    if (keeps_offsets(run) && !run.offsets.length_judged) judge_length(run);
    if (!run.datum_known && !run.datum_complained && !goes_by_machine(run)) say_unknown_way(run);
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
    return {{start(a.u), start(a.v)}, in_plane(to, a), start(a.w), coordinate(to, a.w), {}, 0, 0, {}};
}

}  // namespace

void capture(Moving& run, const path::Element& e, bool rapid) {
    const double unit = length_unit(run.modal);
    const bool sized = run.look == Look::turned_subprogram;
    const auto size = [&](Code c) { return sized && run.block.has(c) ? run.block.get(c) * unit : 0; };
    run.capture->push_back({e, rapid, run.modal.compensation, corner_of_block(run), run.frame, run.here(),
                            run.top().stack, size(Code::a), size(Code::c), angle_of_whole_line(run)});
}

namespace {

/// Both coordinates of the plane follow from polar words, or the other one from an angle.
bool names_with_others(const Moving& run, int axis) {
    constexpr std::uint64_t both =
        bit(Code::polar_radius) | bit(Code::polar_angle) | bit(Code::pole_angle) | bit(Code::line_angle);
    const PlaneAxes plane = plane_axes(run.modal.plane);
    return (run.block.present & both) != 0 && (axis == plane.u || axis == plane.v);
}

/// What the program has said, where the point on the workpiece does not tell that: in a turned frame a coordinate that
/// is not known hides others, and behind a change of tools one that has not been said anew looks as though it had been.
void tell_said(Moving& run) {
    std::array<bool, 3>& unsaid = run.unsaid_since_change;
    const bool shows = run.frame_is_identity || geom::is_finite(run.position);
    if (shows && unsaid == std::array<bool, 3>{}) return;
    for (int k = 0; k < 3; ++k)
        if (run.block.has(axis_code(k)) || names_with_others(run, k)) unsaid[static_cast<std::size_t>(k)] = false;
    if (shows && unsaid == std::array<bool, 3>{}) return;
    if (!geom::is_invertible(run.frame)) return;
    const geom::Vec3 seen = run.frame_is_identity ? run.position : geom::apply(geom::inverse(run.frame), run.position);
    cl::MachinePlace place{cl::PlaceKind::frame};
    bool tells = false;
    for (int k = 0; k < 3; ++k) {
        const auto n = static_cast<std::size_t>(k);
        const double said = coordinate(run.programmed_position, k);
        if (!std::isfinite(said)) continue;
        place.axes[n] = !unsaid[n];
        if (place.axes[n]) coordinate(place.to, k) = said;
        tells = tells || (unsaid[n] ? std::isfinite(coordinate(seen, k)) : !std::isfinite(coordinate(seen, k)));
    }
    if (tells && place.axes != std::array<bool, 3>{}) emit(run, place);
}

}  // namespace

void straight_motion(Moving& run, const geom::Vec3& to, bool rapid) {
    const PlaneAxes a = plane_axes(run.modal.plane);
    const geom::Vec3& at = run.programmed_position;
    const bool known = std::isfinite(coordinate(to, a.u)) && std::isfinite(coordinate(to, a.v));
    if (!rapid && run.modal.feed_mode == cl::FeedMode::inverse_time) hear_inverse_feed(run, geom::length(to - at));
    if (!known) flush_path(run);
    if (!known)  // there is no corner to put them on
        for (const Code c : {Code::chamfer_length, Code::chamfer_leg, Code::round, Code::corner_feed}) run.block.use(c);
    if (!known || !needs_path_stage(run)) {
        const geom::Vec2 step{coordinate(to, a.u) - coordinate(at, a.u), coordinate(to, a.v) - coordinate(at, a.v)};
        if (step.x != 0 || step.y != 0) run.last_direction = path::EndDirection(step);
        if (run.free_contour.at_hand) run.free_contour = {};
        if (run.capture != nullptr) capture(run, straight_element(at, to, a), rapid);
        arrive(run, to);
        tell_said(run);
        const std::array<bool, 3> unsaid = run.unsaid_since_change;
        emit_line(run, rapid);
        run.unsaid_since_change = unsaid;
        return;
    }
    plane_element(run, straight_element(at, to, a), to, rapid);
}

namespace {

/// F was programmed in another unit than the one in force.
void say_void_feed(Reckoning& run) {
    const cl::FeedMode mode = run.modal.feed_mode;
    const std::string unit = mode == cl::FeedMode::per_rev      ? "mm per revolution"
                             : mode == cl::FeedMode::per_minute ? "mm per minute"
                                                                : "inverse time";
    const std::string_view does = run.traits->feed_in_other_unit;
    unchecked(run, codes::feed_missing, run.here(),
              "no feed is programmed in " + unit + ", in which F counts from here on: " +
                  (does.empty() ? "what the control makes of the last one is not known" : std::string(does)),
              "write F beside or behind the word that changes its unit");
}

}  // namespace

void require_feed(Telling& run) {
    if (run.spindle.doubtful) judge_stop(run);
    if (run.feed_valid || !run.feed_dropped) return;
    run.feed_dropped = false;
    if (!(run.feed > 0)) return emit(run, cl::Feed{0, run.modal.feed_mode});
    say_void_feed(run);
    emit(run, cl::Feed{unknown_number, run.modal.feed_mode});
}

}  // namespace obrys::interp
