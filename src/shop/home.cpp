#include "shop/home.hpp"

#include <algorithm>

namespace obrys::shop {

namespace {

bool may_be_zero(const MachineAxis& axis) {
    const bool is_limited = axis.min || axis.max;
    return !axis.rotary && (!is_limited || axis.min == 0.0 || axis.max == 0.0);
}

}  // namespace

Home home_of(const Machine& machine, std::string_view axis, bool at_zero) {
    const auto found =
        std::find_if(machine.axes.begin(), machine.axes.end(), [&](const MachineAxis& a) { return a.name == axis; });
    const bool is_listed = found != machine.axes.end();
    if (is_listed && found->home) return {*found->home, false};
    const bool is_there = is_listed || machine.axes.empty() || machine.more_axes;
    if (!at_zero || !is_there || (is_listed && !may_be_zero(*found))) return {};
    return {0, true};
}

}  // namespace obrys::shop
