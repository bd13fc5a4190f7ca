#include "motion/rapid_way.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace obrys::motion {

namespace {

constexpr double same = 1e-9;  ///< mm

}  // namespace

double rapid_rate(const shop::Machine& machine, std::size_t k) {
    const auto axis = std::find_if(machine.axes.begin(), machine.axes.end(),
                                   [k](const shop::MachineAxis& a) { return a.name == std::string(1, "XYZ"[k]); });
    return axis != machine.axes.end() && axis->rapid > 0 ? axis->rapid : shop::MachineAxis{}.rapid;
}

std::array<double, 3> ways_of_axes(const LinearAxes& axes, const geom::Vec3& from, const geom::Vec3& to) {
    const geom::Vec3 way = to - from;
    return {geom::dot(axes[0], way), geom::dot(axes[1], way), geom::dot(axes[2], way)};
}

std::vector<geom::Vec3> corners_of_rapid(const shop::Machine& machine, const LinearAxes& axes, geom::Vec3 from,
                                         geom::Vec3 to) {
    const std::array<double, 3> parts = ways_of_axes(axes, from, to);
    std::array<double, 3> needs{};  // minutes of each axis
    for (std::size_t k = 0; k < parts.size(); ++k)
        if (std::abs(parts[k]) > same) needs[k] = std::abs(parts[k]) / rapid_rate(machine, k);
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

}  // namespace obrys::motion
