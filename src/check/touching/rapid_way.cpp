#include "check/touching/rapid_way.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>

#include "sim/milling/stock.hpp"

namespace obrys::check {

namespace milling = sim::milling;

namespace {

/// Minutes that each of X, Y and Z needs for its part of the way; nothing where the machine does not say its speed.
std::optional<std::array<double, 3>> needs_of(const shop::Machine& machine, geom::Vec3 way) {
    std::array<double, 3> needs{};
    for (std::size_t k = 0; k < needs.size(); ++k) {
        const double part = std::abs(milling::component(way, static_cast<int>(k)));
        if (part == 0) continue;
        const auto axis = std::find_if(machine.axes.begin(), machine.axes.end(),
                                       [k](const shop::MachineAxis& a) { return a.name == std::string(1, "XYZ"[k]); });
        if (axis == machine.axes.end() || !(axis->rapid > 0)) return std::nullopt;
        needs[k] = part / axis->rapid;
    }
    return needs;
}

}  // namespace

std::vector<geom::Vec3> corners_of_rapid(const shop::Machine& machine, geom::Vec3 from, geom::Vec3 to) {
    const geom::Vec3 way = to - from;
    const auto needs = machine.rapid_path == shop::RapidPath::dog_leg ? needs_of(machine, way) : std::nullopt;
    if (!needs) return {to};
    std::vector<geom::Vec3> corners;
    std::array<double, 3> stops = *needs;
    std::sort(stops.begin(), stops.end());
    for (const double at : stops) {
        geom::Vec3 p = to;
        for (int k = 0; k < 3; ++k)
            if (const double need = (*needs)[static_cast<std::size_t>(k)]; need > at)
                milling::set_component(p, k, milling::component(from, k) + at / need * milling::component(way, k));
        if (at > 0 || at == stops[2]) corners.push_back(p);
    }
    return corners;
}

}  // namespace obrys::check
