/// Coordinates of the programmed frame, and what a word of one counts.

#include <string_view>

#include "base/number.hpp"
#include "interp/capture.hpp"
#include "interp/values/values.hpp"

namespace obrys::interp {

using program::Reference;

void arrive(Reckoning& run, const geom::Vec3& target) {
    run.programmed_position = target;
    run.position = run.frame_is_identity ? target : geom::apply(run.frame, target);
}

const shop::MachineAxis* machine_axis(const Saying& run, const std::string& name) {
    for (const shop::MachineAxis& a : run.env.machine.axes)
        if (a.name == name) return &a;
    return nullptr;
}

double word_factor(const Reckoning& run, int axis, std::uint8_t reference) {
    if (reference <= 1 + static_cast<std::uint8_t>(Reference::negative))
        return length_factor(run, axis, is_incremental(run, reference));
    const bool diameter = reference == 1 + static_cast<std::uint8_t>(Reference::diameter_absolute) ||
                          reference == 1 + static_cast<std::uint8_t>(Reference::diameter_incremental);
    return length_unit(run.modal) * (diameter ? 0.5 : 1);
}

double programmed_coordinate(const Reckoning& run, const std::string& axis) {
    for (int k = 0; k < 3; ++k)
        if (axis.size() == 1 && axis[0] == "XYZ"[k])
            return coordinate(run.programmed_position, k) / length_factor(run, k, false);
    const auto found = run.extra_axes.find(axis);
    return found == run.extra_axes.end() ? unknown_number : found->second;
}

std::optional<std::string> machine_axis_name(const Saying& run, const std::string& name) {
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

}  // namespace obrys::interp
