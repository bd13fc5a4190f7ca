#include "check/touching/rapid_way.hpp"

#include <algorithm>
#include <cmath>

#include "base/number.hpp"

namespace obrys::check {

namespace {

constexpr double same = 1e-9;  ///< mm

/// mm/min; an axis that the machine does not list is as fast as one whose speed its file leaves out.
double speed_of(const shop::Machine& machine, std::size_t k) {
    const auto axis = std::find_if(machine.axes.begin(), machine.axes.end(),
                                   [k](const shop::MachineAxis& a) { return a.name == std::string(1, "XYZ"[k]); });
    return axis != machine.axes.end() && axis->rapid > 0 ? axis->rapid : shop::MachineAxis{}.rapid;
}

}  // namespace

std::vector<geom::Vec3> corners_of_rapid(const shop::Machine& machine, const LinearAxes& axes, geom::Vec3 from,
                                         geom::Vec3 to) {
    const geom::Vec3 way = to - from;
    std::array<double, 3> parts{}, needs{};  // mm and minutes of each axis
    for (std::size_t k = 0; k < parts.size(); ++k) {
        parts[k] = geom::dot(axes[k], way);
        if (std::abs(parts[k]) > same) needs[k] = std::abs(parts[k]) / speed_of(machine, k);
    }
    std::array<double, 3> stops = needs;
    std::sort(stops.begin(), stops.end());
    std::vector<geom::Vec3> corners;
    for (const double at : stops) {
        geom::Vec3 p = from;
        for (std::size_t k = 0; k < parts.size(); ++k) p = p + (needs[k] > at ? at / needs[k] : 1) * parts[k] * axes[k];
        if (at > 0 && at < stops[2] && geom::distance(p, corners.empty() ? from : corners.back()) > same &&
            geom::distance(p, to) > same)
            corners.push_back(p);
    }
    corners.push_back(to);
    return corners;
}

bool are_square(const LinearAxes& axes) {
    for (std::size_t i = 0; i < axes.size(); ++i)
        for (std::size_t k = i; k < axes.size(); ++k)
            if (!(std::abs(geom::dot(axes[i], axes[k]) - (i == k ? 1 : 0)) < 1e-6)) return false;
    return true;
}

std::string bent_as_delivered(const Setup& setup) {
    const bool lathe = setup.machine.kind == shop::MachineKind::lathe;
    std::string speeds;
    for (const std::size_t k : {std::size_t{0}, std::size_t{1}, std::size_t{2}})
        if (!lathe || k != 1)
            speeds += (speeds.empty() ? "" : ", ") + std::string(1, "XYZ"[k]) + " " +
                      base::shortest(speed_of(setup.machine, k));
    return "rapids of several axes bend, as this control is delivered (" + setup.rapids.setting +
           "): each axis goes at its own rapid, " + speeds + " mm/min; rapid in the machine file says otherwise";
}

std::string met_if_bent(const Setup& setup, const std::string& what) {
    const std::string& setting = setup.rapids.setting;
    return "whether this rapid is clear depends on the machine: straight it is, but with each axis at its own rapid" +
           (setting.empty() ? "" : " (" + setting + ")") + " the " + what;
}

}  // namespace obrys::check
