/// Motion in machine coordinates: G74, G75, SUPA, G53, G153.

#include <cmath>

#include "base/codes.hpp"
#include "interp/moves/moves.hpp"
#include "interp/stream/path_stage.hpp"

namespace obrys::interp {

namespace codes = base::codes;

namespace {

double ahead(const Reckoning& run, int k) { return machine_ahead(run, static_cast<std::size_t>(k)); }

double from_machine(const Reckoning& run, int k, double machine) {
    const bool along_tool = k == plane_axes(run.modal.plane).w;
    const double tool = along_tool && run.traits->machine_words_are_gauge_point ? gauge_length(run) : 0;
    return machine - ahead(run, k) - tool;
}

/// All axes of the block go to their home, machine coordinate 0 where the machine's file gives none.
bool goes_home(const Moving& run) {
    for (int k = 0; k < 3; ++k) {
        const shop::MachineAxis* axis = machine_axis(run, std::string(1, "XYZ"[k]));
        const double home = axis != nullptr && axis->home ? *axis->home : 0;
        if (run.block.has(axis_code(k)) &&
            run.block.peek(axis_code(k)) * word_factor(run, k, run.block.ref(axis_code(k))) != home)
            return false;
    }
    return run.modal.motion == Modal::rapid;
}

/// mm below an axis' home that a retract along the tool may end: `L Z-10 FMAX M91`, SUPA Z-5.
constexpr double near_home = 50;

/// A mill goes away from the workpiece at rapid: along its tool alone, up to about home, or beside it. Whether such a
/// way along X and Y meets the stock the check says by the height that is known.
bool goes_away(const Moving& run) {
    if (run.env.machine.kind != shop::MachineKind::mill || run.modal.motion != Modal::rapid) return false;
    const int w = plane_axes(run.modal.plane).w;
    geom::Vec3 upright;
    coordinate(upright, w) = 1;
    if (!(run.tool_axis == upright)) return false;  // along Z is not along the tool
    bool along = false, beside = false;
    for (int k = 0; k < 3; ++k) {
        if (!run.block.has(axis_code(k))) continue;
        (k == w ? along : beside) = true;
        if (std::isnan(run.block.peek(axis_code(k)))) return false;
    }
    if (!along) return beside;
    const shop::MachineAxis* axis = machine_axis(run, axis_name(static_cast<std::size_t>(w)));
    const double home = axis != nullptr && axis->home ? *axis->home : 0;
    const Code code = axis_code(w);
    return !beside && !is_incremental(run, run.block.ref(code)) &&
           run.block.peek(code) * word_factor(run, w, run.block.ref(code)) >= home - near_home;
}

void assume_away(Reckoning& run) {
    assume(run, run.here(),
           "a position in machine coordinates is taken to lie away from the workpiece, as home does: where it is in "
           "the workpiece is not known",
           "give the offset in [datum] of the job, e.g. " + program::datum_key(*run.traits, run.reference_datum) +
               " = { x = 0.0, y = 0.0, z = -350.0 }");
}

/// Of the axes of the block.
std::string wanted_here(const Moving& run) {
    cl::MachinePlace place;
    geom::Vec3 at;
    for (int k = 0; k < 3; ++k) {
        const auto axis = static_cast<std::size_t>(k);
        place.axes[axis] = run.block.has(axis_code(k));
        coordinate(at, k) = ahead(run, k);
        const shop::MachineAxis* known = machine_axis(run, axis_name(axis));
        if (known != nullptr && known->home) coordinate(place.to, k) = *known->home;
    }
    return wanted_for_home(run, at, place);
}

void unknown_machine_position(Moving& run) {
    bool known = run.env.machine.datums.contains(run.reference_datum) || (keeps_offsets(run) && run.datum_known);
    for (int k = 0; k < 3 && known; ++k) known = !run.block.has(axis_code(k)) || !std::isnan(ahead(run, k));
    if (known) return;
    if (keeps_offsets(run) && goes_home(run))
        return assume(run, run.here(),
                      "machine coordinate 0 is taken as the home of its axis, away from the workpiece: where it is in "
                      "the workpiece is not known",
                      wanted_here(run));
    if (goes_away(run)) return assume_away(run);
    unchecked(run, codes::unknown_value, run.here(),
              "this block moves in machine coordinates and " + program::datum_phrase(*run.traits, run.reference_datum) +
                  " is not known: where it ends in the workpiece is not known",
              "give the offset in [datum] of the job, e.g. " + program::datum_key(*run.traits, run.reference_datum) +
                  " = { x = 0.0, y = 0.0, z = -350.0 }");
}

/// Radius compensation goes on from the contour's point in axes that a block in between did not move.
class ContourPoint {
public:
    explicit ContourPoint(Telling& run) : compensated_(run.path->active()), at_(run.programmed_position) {
        run.path->stop(run);
    }
    /// `moved`: bit per axis of the programmed frame.
    void keep(Telling& run, unsigned moved) const {
        for (int k = 0; k < 3 && compensated_; ++k)
            if ((moved >> static_cast<unsigned>(k) & 1U) == 0)
                coordinate(run.programmed_position, k) = coordinate(at_, k);
    }

private:
    bool compensated_;
    geom::Vec3 at_;
};

void go_to(Telling& run, geom::Vec3 target, bool rapid) {
    run.position = target;
    run.programmed_position = run.frame_is_identity ? target : geom::apply(geom::inverse(run.frame), target);
    emit(run, cl::Linear{target, run.tool_axis, rapid});
}

}  // namespace

/// G74 and G75: the axes of the block go to their reference point.
bool reference_point(Moving& run) {
    flush_path(run);
    geom::Vec3 target = run.position;
    const bool fixed = run.block.special == Modal::fixed_point;
    cl::MachinePlace place{fixed ? cl::PlaceKind::fixed : cl::PlaceKind::home};
    std::array<bool, 3> assumed{};
    for (int k = 0; k < 3; ++k) {
        if (!run.block.has(axis_code(k))) continue;
        run.block.use(axis_code(k));
        const auto axis = static_cast<std::size_t>(k);
        place.axes[axis] = true;
        const shop::Home home = fixed ? shop::Home{} : reference_point_of(run, axis);
        coordinate(target, k) = from_machine(run, k, home.at);
        coordinate(place.to, k) = home.at;
        assumed[axis] = home.is_assumed && std::isfinite(coordinate(target, k));
    }
    tell_assumed_homes(run, assumed);
    if (!geom::is_finite(target) && fixed)
        assume(run, run.here(),
               "the fixed point of G75 is not known: moves to and from it are simulated as far as they are known");
    else if (!geom::is_finite(target))
        assume(run, run.here(),
               "the reference point is not known in the workpiece frame: moves to and from it are simulated as far as "
               "they are known",
               wanted_for_home(run, target, place));
    if (place.axes != std::array<bool, 3>{}) emit(run, place);
    go_to(run, target, true);
    return true;
}

/// Whether the tool's length counts in them: with SUPA it does while D names an edge ($MN_G53_TOOLCORR = 0, as
/// delivered; SINUMERIK ISO Milling 04.07, page 3-42), along the tool of a mill, along both axes of a lathe.
bool leads_tip(const Reckoning& run, const cl::MachinePlace& place) {
    if (keeps_offsets(run) || run.traits->machine_words_are_gauge_point) return false;
    const bool has_tool = run.tool.edge != 0 && (run.tool.number != 0 || !run.tool.name.empty());
    const auto w = static_cast<std::size_t>(plane_axes(run.modal.plane).w);
    return has_tool && (run.env.machine.kind == shop::MachineKind::lathe || place.axes[w]);
}

/// SUPA, G53, G153: the words are machine coordinates (G53: without any frame, the same here).
bool machine_move(Moving& run) {
    const ContourPoint contour(run);
    if (run.modal.motion != Modal::rapid && run.modal.motion != Modal::linear)
        unchecked(run, codes::unsupported, run.here(),
                  "only straight moves are run in machine coordinates: this one is run straight to its end");
    unknown_machine_position(run);
    geom::Vec3 target = along_machine(run);
    unsigned moved = 0;
    cl::MachinePlace place;
    for (int k = 0; k < 3; ++k) {
        if (!run.block.has(axis_code(k))) continue;
        moved |= 1U << static_cast<unsigned>(k);
        place.axes[static_cast<std::size_t>(k)] = true;
        const bool incremental = is_incremental(run, run.block.ref(axis_code(k)));
        const double v = run.block.get(axis_code(k)) * word_factor(run, k, run.block.ref(axis_code(k)));
        coordinate(target, k) = incremental ? coordinate(target, k) + v : from_machine(run, k, v);
        if (!incremental) coordinate(place.to, k) = v;
    }
    place.tip = leads_tip(run, place);
    if (moved != 0) emit(run, place);
    go_to(run, from_along_machine(run, target), run.modal.motion == Modal::rapid);
    contour.keep(run, moved);
    return true;
}

namespace {

/// The tool axis' limit of travel along its own direction, mm from where the tool stands; NaN: not known here.
double way_to_limit(const Reckoning& run) {
    const int w = plane_axes(run.modal.plane).w;
    const shop::MachineAxis* axis = machine_axis(run, axis_name(static_cast<std::size_t>(w)));
    geom::Vec3 along;
    coordinate(along, w) = 1;
    if (axis == nullptr || !axis->max || !(run.tool_axis == along)) return unknown_number;
    return from_machine(run, w, *axis->max) - coordinate(run.position, w);
}

}  // namespace

/// M140 MB: away from the workpiece along the tool axis before the block's own motion. Source: iTNC 530 User's Manual,
/// "Retraction from the contour in the tool-axis direction: M140"; effective at the start of the block.
void retract_tool(Moving& run) {
    constexpr int to_limit = 2;
    const BlockWords& b = run.block;
    const ContourPoint contour(run);
    begin_motion(run);
    const bool limit = b.retract == to_limit;
    const double way = limit ? way_to_limit(run) : b.get(Code::q) * length_unit(run.modal);
    if (!limit && way < 0)
        return alarm(run, codes::value_range, run.here(), "MB of M140 is negative: it says how far the tool goes away");
    const bool feeds = b.has(Code::e);
    if (std::isnan(way) && limit && !feeds)
        assume_away(run);  // it leads away as "L Z+0 FMAX M91" does
    else if (std::isnan(way))
        unchecked(
            run, codes::unknown_value, run.here(),
            limit ? "M140 MB MAX goes to the limit of travel of the tool axis, which is not known in the workpiece: "
                    "where the tool then stands is not known"
                  : "how far M140 MB goes depends on a value that is not known",
            limit ? "name a machine with the limits of its axes, and the zero offset in [datum] of the job" : "");
    geom::Vec3 to = run.position;
    for (int k = 0; k < 3; ++k)  // where the way is not known, the other axes still are
        if (coordinate(run.tool_axis, k) != 0) coordinate(to, k) += way * coordinate(run.tool_axis, k);
    if (feeds) emit(run, cl::Feed{b.get(Code::e) * feed_factor(run), run.modal.feed_mode});
    go_to(run, to, !feeds);
    if (feeds && run.feed_valid) emit(run, cl::Feed{run.feed, run.modal.feed_mode});
    contour.keep(run, 1U << static_cast<unsigned>(plane_axes(run.modal.plane).w));
}

}  // namespace obrys::interp
