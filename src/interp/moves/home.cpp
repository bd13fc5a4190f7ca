/// G28 and G30: by way of a point to a stored position; G28.1 and G30.1 store it.
/// Source: LinuxCNC, G-Codes, "G28", "G30"; Fanuc, "Reference position".

#include <algorithm>
#include <cmath>

#include "base/codes.hpp"
#include "interp/moves/moves.hpp"

namespace obrys::interp {

namespace codes = base::codes;

namespace {

std::uint32_t first_of(const Moving& run) {
    const program::OffsetParameters& p = run.traits->offsets;
    return run.block.special_number >= 2 ? p.home_second : p.home_first;
}

/// Machine coordinate to which the axis goes.
shop::Home home_of(const Moving& run, std::size_t axis) {
    if (const std::uint32_t first = first_of(run); first != 0) {
        const std::uint32_t n = first + static_cast<std::uint32_t>(axis);
        if (run.parameters.is_set(n) || holds_all(run)) return {run.parameters.get(n) * stored_unit(run, axis), false};
    }
    if (run.block.special_number < 2) return reference_point_of(run, axis);
    const shop::MachineAxis* known = machine_axis(run, axis_name(axis));
    const bool is_second = run.block.special_number == 2 && known != nullptr && known->second_home;
    return {is_second ? *known->second_home : unknown_number, false};
}

void emit_other_axis(Telling& run, std::size_t k, double to) {
    const std::string name = axis_name(k);
    run.extra_axes[name] = to;
    take_along(run, axis_end(name, to, is_rotary(k), false));
}

/// Bare G28 moves the axes that the machine has.
bool is_absent(const Saying& run, std::size_t axis) {
    const shop::Machine& m = run.env.machine;
    return !m.axes.empty() && !m.more_axes && machine_axis(run, axis_name(axis)) == nullptr;
}

std::string names_of(const std::array<bool, 3>& axes) {
    std::string names;
    for (std::size_t k = 0; k < axes.size(); ++k)
        if (axes[k]) names += (names.empty() ? "" : ", ") + axis_name(k);
    return names;
}

std::string unknown_axes(const geom::Vec3& to) {
    std::array<bool, 3> unknown{};
    for (int k = 0; k < 3; ++k) unknown[static_cast<std::size_t>(k)] = !std::isfinite(coordinate(to, k));
    return names_of(unknown);
}

}  // namespace

shop::Home reference_point_of(const Reckoning& run, std::size_t axis) {
    constexpr std::size_t rotary_from = 3;
    return shop::home_of(run.env.machine, axis_name(axis), run.env.homes_at_zero && axis < rotary_from);
}

/// That depends on where the zero lies, which somebody has given.
void tell_assumed_homes(Saying& run, const std::array<bool, 3>& axes) {
    if (axes == std::array<bool, 3>{}) return;
    assume(run, run.here(),
           "no home of " + names_of(axes) + " is given: machine coordinate 0 is taken for it, as on most machines",
           "give home of the axes in the machine file");
}

namespace {

/// To the stored position with those axes that are named, or with all.
void to_home(Moving& run, bool all) {
    const Offsets& o = run.offsets;
    geom::Vec3 to = run.position;
    cl::MachinePlace place;
    place.kind = cl::PlaceKind::home;
    std::array<bool, 3> assumed{};
    for (std::size_t k = 0; k < 9; ++k) {
        if (all ? is_absent(run, k) : !run.block.has(axis_code(static_cast<int>(k)))) continue;
        const auto [home, is_assumed] = home_of(run, k);
        if (k < 3) {
            double& at = coordinate(to, static_cast<int>(k));
            at = home - machine_ahead(run, k), place.axes[k] = true;
            coordinate(place.to, static_cast<int>(k)) = home;
            assumed[k] = is_assumed && std::isfinite(at);
        } else if (run.extra_axes.contains(axis_name(k))) {
            emit_other_axis(run, k, home - o.reference[k]);
        }
    }
    tell_assumed_homes(run, assumed);
    place.number = static_cast<std::uint8_t>(std::clamp(run.block.special_number, 1, 9));
    if (!geom::is_finite(to))
        assume(run, run.here(),
               "the home position of " + unknown_axes(to) +
                   " is not known in the workpiece frame: moves to and from it are simulated as far as "
                   "they are known",
               wanted_for_home(run, to, place));
    run.offsets.lost = run.offsets.lost || !geom::is_finite(to);
    if (geom::is_finite(to)) emit_frame(run);  // it is a place in that frame
    run.position = to;
    run.programmed_position = geom::apply(geom::inverse(run.frame), to);
    if (place.axes != std::array<bool, 3>{}) emit(run, place);
    emit(run, cl::Linear{to, run.tool_axis, true});
}

}  // namespace

namespace {

/// G91 G28 Z0: by way of where the tool stands. Where that is not known, there is no move to a place that is not known.
bool stands_by_way(const Moving& run, const geom::Vec3& by_way) {
    const auto moves = [&](int k) { return run.block.has(axis_code(k)) && run.block.peek(axis_code(k)) != 0; };
    if (run.modal.absolute || geom::is_finite(by_way)) return false;
    for (int k = 0; k < 9; ++k)
        if (moves(k)) return false;
    return true;
}

}  // namespace

void go_home(Moving& run) {
    flush_path(run);
    bool any = false;
    for (int k = 0; k < 9; ++k) any = any || run.block.has(axis_code(k));
    begin_motion(run);
    const geom::Vec3 by_way = programmed_target(run);
    bool others = false;
    for (int k = 3; k < 9; ++k) {
        const bool counts = run.modal.absolute || run.extra_axes.contains(axis_name(static_cast<std::size_t>(k)));
        others = others || (run.block.has(axis_code(k)) && counts);
    }
    if (others) extra_axes(run);
    const bool stands = stands_by_way(run, by_way);
    arrive(run, by_way);
    if (!stands || others) emit(run, cl::Linear{run.position, run.tool_axis, true});
    to_home(run, !any);
    if (!run.traits->home_cancels_length || run.offsets.length == Offsets::Length::none) return;
    if (run.block.has(Code::offset_h))
        assume(run, run.here(), "H has no effect here: going home ends the compensation of the tool's length",
               "compensate the length anew behind it, where the tool goes on");
    tool_length_words(run, Modal::tool_length_off);
}

void store_home(Moving& run) {
    const std::uint32_t first = first_of(run);
    for (std::size_t k = 0; k < 9 && first != 0; ++k) {
        const double at = machine_coordinate(run, k);
        run.parameters.set(first + static_cast<std::uint32_t>(k),
                           std::isnan(at) ? (k < 3 ? at : 0) : at / stored_unit(run, k));
    }
}

}  // namespace obrys::interp
