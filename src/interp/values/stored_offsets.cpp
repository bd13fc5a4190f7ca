/// Zeros and offsets as they are stored, and coordinates as they count them.

#include "interp/values/values.hpp"

namespace obrys::interp {

namespace {

constexpr std::size_t rotation_about_z = 9;  // behind the axes

}  // namespace

bool holds_all(const Saying& run) { return run.env.stored != nullptr || run.env.stand_alone; }

bool is_zero_held(const Reckoning& run, std::uint32_t datum, std::size_t axis) {
    if (holds_all(run) || run.env.machine.datums.contains(datum)) return true;
    const std::uint32_t behind =
        axis == rotation_about_z ? run.traits->offsets.rotation : static_cast<std::uint32_t>(axis);
    const auto first = first_of_datum(run, datum);
    return first && (axis != rotation_about_z || behind != 0) && run.parameters.is_set(*first + behind);
}

bool is_datum_given(const Reckoning& run, std::uint32_t datum, std::size_t axis) {
    return is_zero_held(run, datum, axis);
}

bool is_datum_given(const Reckoning& run, std::size_t axis) { return is_zero_held(run, run.reference_datum, axis); }

bool is_datum_given(const Reckoning& run) {
    bool given = false;
    for (std::size_t k = 0; k < 3; ++k) given = given || is_datum_given(run, k);
    return given;
}

bool holds_active_datum(const Reckoning& run, std::uint32_t n) {
    const std::uint32_t external_first = run.traits->offsets.external_first;
    if (external_first != 0 && n >= external_first && n < external_first + 9) return true;
    const auto first = first_of_datum(run, run.modal.datum);
    return first && n >= *first && n < *first + 9;
}

geom::Frame datum_frame(const Reckoning& run) {
    const Offsets& o = run.offsets;
    const Axes tip = tip_in_use(o);
    const geom::Frame f = geom::Frame::shift({o.datum[0] - o.reference[0] + o.tool[0] - tip[0],
                                              o.datum[1] - o.reference[1] + o.tool[1] - tip[1],
                                              o.datum[2] - o.reference[2] + o.tool[2] - tip[2]});
    return o.rotation == 0 ? f : f * geom::Frame::rotation(2, geom::radians(o.rotation));
}

double axis_coordinate(const Reckoning& run, std::size_t axis) {
    if (axis < 3) return coordinate(run.programmed_position, static_cast<int>(axis));
    const auto found = run.extra_axes.find(axis_name(axis));
    return found == run.extra_axes.end() ? unknown_number : found->second - run.offsets.total[axis];
}

namespace {

/// A length that nobody has given is compensated along the axis: how far the gauge point stands off is not known. The
/// offset of a lathe's tool (T0101) lies along X and Z.
bool is_length_unknown(const Reckoning& run, std::size_t axis) {
    const Offsets& o = run.offsets;
    const bool lathe = run.env.machine.kind == shop::MachineKind::lathe && run.traits->edge_is_offset_number;
    if (lathe) return run.tools.empty() && run.tool.number != 0 && run.tool.edge != 0 && axis != 1 && axis < 3;
    return o.is_not_given && o.length != Offsets::Length::none && axis == 2;
}

/// As machine_ahead, of a control whose offsets are kept in parameters.
double kept_ahead(const Reckoning& run, std::size_t axis) {
    const Offsets& o = run.offsets;
    if (is_length_unknown(run, axis)) return unknown_number;
    const bool known = run.datum_known && is_datum_given(run, axis) && o.given[axis];
    return known ? o.reference[axis] + tip_in_use(o)[axis] : unknown_number;
}

}  // namespace

double machine_ahead(const Reckoning& run, std::size_t axis) {
    if (keeps_offsets(run)) return kept_ahead(run, axis);
    const shop::Machine& m = run.env.machine;
    const auto known = m.datums.find(run.reference_datum);
    if (known == m.datums.end() || (axis < 2 && m.datum_rotations.contains(run.reference_datum))) return unknown_number;
    return coordinate(known->second, static_cast<int>(axis));
}

std::string wanted_for_home(const Reckoning& run, const geom::Vec3& at, const cl::MachinePlace& place) {
    bool no_home = false, no_zero = false, no_length = false;
    for (std::size_t k = 0; k < 3; ++k) {
        const int axis = static_cast<int>(k);
        if (!place.axes[k] || std::isfinite(coordinate(at, axis))) continue;
        no_home = no_home || std::isnan(coordinate(place.to, axis));
        const bool kept = keeps_offsets(run);
        no_length = no_length || (kept && is_length_unknown(run, k));
        no_zero = no_zero || (kept ? !(run.datum_known && is_datum_given(run, k)) : std::isnan(machine_ahead(run, k)));
    }
    const std::string zero = "the zero offset in [datum] of the job" +
                             std::string(keeps_offsets(run) ? ", or the parameter file of the control" : "");
    if (no_home) return "give home of the axes in the machine file" + (no_zero ? " and " + zero : std::string());
    if (no_zero) return "give " + zero;
    if (no_length) return "give the length of the tool: home and zero offset are known";
    return "home and zero offset are given: see what moves the axes or the zero before, by values that are not known";
}

double machine_coordinate(const Reckoning& run, std::size_t axis) {
    if (axis < 3) return coordinate(run.position, static_cast<int>(axis)) + machine_ahead(run, axis);
    const double at = axis_coordinate(run, axis);
    return at + run.offsets.total[axis] + run.offsets.reference[axis];
}

}  // namespace obrys::interp
