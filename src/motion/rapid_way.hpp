#pragma once
/// The way of a rapid whose axes go each at its own speed: it bends where one of them stops. mm, min.

#include <array>
#include <vector>

#include "geom/vec.hpp"
#include "shop/machine.hpp"

namespace obrys::motion {

/// As the machine file says, else as the control does it.
[[nodiscard]] inline shop::RapidPath rapid_path(const shop::Machine& machine, shop::RapidPath of_control) {
    return machine.rapid_path.value_or(of_control);
}
/// Of X, Y or Z (`k` 0, 1, 2), mm/min; an axis that the machine does not list is as fast as one whose speed its file
/// leaves out.
[[nodiscard]] double rapid_rate(const shop::Machine& machine, std::size_t k);

/// Unit vectors of the machine's X, Y and Z.
using LinearAxes = std::array<geom::Vec3, 3>;
inline constexpr LinearAxes upright_axes{geom::Vec3{1, 0, 0}, geom::Vec3{0, 1, 0}, geom::Vec3{0, 0, 1}};
/// They are at right angles, so that they say where a rapid bends.
[[nodiscard]] bool are_square(const LinearAxes& axes);
/// How far each of them goes, mm, with its sign.
[[nodiscard]] std::array<double, 3> ways_of_axes(const LinearAxes& axes, const geom::Vec3& from, const geom::Vec3& to);
/// The ends of the straight pieces of such a rapid, the last one `to`. One where it does not bend.
[[nodiscard]] std::vector<geom::Vec3> corners_of_rapid(const shop::Machine& machine, const LinearAxes& axes,
                                                       geom::Vec3 from, geom::Vec3 to);

}  // namespace obrys::motion
