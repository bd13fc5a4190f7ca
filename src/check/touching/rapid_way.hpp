#pragma once
/// Where a rapid comes by whose axes go each at its own speed: its way bends where one of them stops.

#include <array>
#include <string>
#include <vector>

#include "check/setup.hpp"
#include "geom/vec.hpp"

namespace obrys::check {

/// As the machine file says, else as the control does it.
[[nodiscard]] inline shop::RapidPath rapid_path(const Setup& setup) {
    return setup.machine.rapid_path.value_or(setup.rapids.path);
}

/// Unit vectors of the machine's X, Y and Z.
using LinearAxes = std::array<geom::Vec3, 3>;
inline constexpr LinearAxes upright_axes{geom::Vec3{1, 0, 0}, geom::Vec3{0, 1, 0}, geom::Vec3{0, 0, 1}};

/// The ends of its straight pieces, the last one `to`; lengths in mm. One where it does not bend.
[[nodiscard]] std::vector<geom::Vec3> corners_of_rapid(const shop::Machine& machine, const LinearAxes& axes,
                                                       geom::Vec3 from, geom::Vec3 to);
/// The axes are at right angles, so that they say where a rapid bends.
[[nodiscard]] bool are_square(const LinearAxes& axes);

/// That rapids are run bent, as the control is delivered.
[[nodiscard]] std::string bent_as_delivered(const Setup& setup);
/// That only the bent way of a rapid meets something: "the tool runs into the stock: …".
[[nodiscard]] std::string met_if_bent(const Setup& setup, const std::string& what);
inline constexpr const char* say_rapid_way =
    "say which in the machine file (rapid = \"straight\" or \"dog-leg\"), or move one axis after the other";

}  // namespace obrys::check
