/// Words with a value and a name of their own, and what machine axes are called.

#include <algorithm>
#include <cmath>
#include <string_view>

#include "base/codes.hpp"
#include "base/number.hpp"
#include "interp/run.hpp"

namespace obrys::interp {

namespace codes = base::codes;
using program::NamedKind;

std::optional<std::string> machine_axis_name(const Run& run, const std::string& name) {
    constexpr std::string_view letters = "XYZABCUVW";
    const auto digits_from = [&](std::size_t at) {
        return name.size() > at && name.find_first_not_of("0123456789", at) == std::string::npos;
    };
    if (name.size() == 2 && name[1] == '1' && letters.find(name[0]) != std::string_view::npos) return name.substr(0, 1);
    if (name.size() <= 4 && name.starts_with("AX") && digits_from(2)) {
        const auto n = static_cast<std::size_t>(base::parse_integer(std::string_view(name).substr(2)).value_or(0));
        const auto& axes = run.env.machine.axes;
        if (n >= 1 && n <= axes.size()) return axes[n - 1].name;
        return axes.empty() && n >= 1 && n <= 3 ? std::optional(axis_name(n - 1)) : std::nullopt;
    }
    if (name.size() >= 3 && name.size() <= 4 && name[0] == 'M' && letters.find(name[1]) != std::string_view::npos &&
        digits_from(2))
        return name.substr(1, 1);
    return std::nullopt;
}

namespace {

/// POS[X]=, POSA[C]=: linear axes move on their own, others are additional axes as if they stood in the block.
void position(Run& run, const program::Named& n) {
    const std::string written = axis_of(run, n.index);
    const std::string axis = machine_axis_name(run, written).value_or(written);
    if (run.stopped) return;
    if (axis.empty() || axis == "?")
        return unchecked(run, codes::unknown_value, run.here(),
                         "which axis is positioned here depends on a value that is not known");
    const double v = number(run, n.value);
    const std::uint8_t reference = reference_of(run.unit().exprs[n.value]);
    const auto k = axis.size() == 1 ? std::string_view("XYZABCUVW").find(axis[0]) : std::string_view::npos;
    if (k != std::string_view::npos && k < 3) {
        run.block.positioned.push_back({axis, v, reference, run.here()});
        run.block.goes_on = run.block.goes_on || n.kind == NamedKind::position_meanwhile;
    } else if (k != std::string_view::npos) {
        run.block.put(axis_code(static_cast<int>(k)), v, reference);
    } else {
        run.block.axes.push_back({axis, v, reference, run.here()});
    }
}

void axis_feed(Run& run, const program::Named& n) {
    const std::string written = axis_of(run, n.index);
    const double feed = number(run, n.value);
    if (run.stopped) return;
    const std::string axis = machine_axis_name(run, written).value_or(written);
    run.axis_feeds[axis] = feed * (run.modal.inch_feed ? 25.4 : 1);
    if (axis != "X" && axis != "Y" && axis != "Z")
        assume(run, run.here(), "FA[" + axis + "]= is the feed of a single axis and is not followed");
}

/// The sum offset is among the tool's data: what it holds is known where the program wrote it alone.
void sum_offset(Run& run, double number) {
    if (number == 0) return;
    unchecked_once(run, codes::unknown_value, run.here(),
                   "DL=" + printed(Value::real(number)) + ": the sum offset of T" + std::to_string(run.tool.number) +
                       " D" + std::to_string(run.tool.edge) +
                       " that it adds is not known: the tip is taken to stand where the program says",
                   "write DL=0, or put the offset into the tool's length and radius");
}

}  // namespace

void special_value(Run& run, const program::Named& n) {
    if (n.kind == NamedKind::position || n.kind == NamedKind::position_meanwhile) return position(run, n);
    if (n.kind == NamedKind::axis_feed) return axis_feed(run, n);
    const double v = number(run, n.value);
    if (run.stopped) return;
    ModalState& m = run.modal;
    const double unit = length_unit(m);
    switch (n.kind) {
        case NamedKind::rounding_distance: m.rounding_distance = std::max(v, 0.0) * unit; return;
        case NamedKind::rounding_distance_rapid: m.rounding_distance_rapid = std::max(v, 0.0) * unit; return;
        case NamedKind::block_feed: run.block.feed_alone = v; return;
        case NamedKind::contour_tolerance: m.contour_tolerance = v < 0 ? std::nan("") : v * unit; return;
        case NamedKind::corner_overshoot:
            if (v < 0 || v > 100)
                return alarm(run, codes::value_range, run.here(),
                             "DISC=" + base::fixed(v, 0) + " is not within 0 and 100");
            m.corner_overshoot = v;
            return;
        default: return sum_offset(run, v);
    }
}

}  // namespace obrys::interp
