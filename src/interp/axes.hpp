#pragma once
/// Axes and working planes by number. Private to interp.

#include <cstddef>
#include <cstdint>

#include "geom/vec.hpp"
#include "interp/block_words.hpp"

namespace obrys::interp {

/// G34, G35: F says by how much the pitch changes.
[[nodiscard]] inline bool changes_pitch(Modal m) { return m == Modal::thread_rising || m == Modal::thread_falling; }
/// A, B and C among the nine axes.
[[nodiscard]] inline bool is_rotary(std::size_t axis) { return axis >= 3 && axis < 6; }
/// G54 (54) is 1, G59.3 (593) is 9; G54.1 P1 (5401) is 1001.
[[nodiscard]] inline std::uint32_t place_of_datum(std::uint32_t number) {
    return number >= 5401 ? number - 5401 + 1001 : number >= 591 ? number - 584 : number - 53;
}
/// As programs select it: 54 … 59, 591 … 593.
[[nodiscard]] inline std::uint32_t number_of_place(std::uint32_t place) {
    return place <= 6 ? 53 + place : 584 + place;
}
constexpr std::uint64_t other_axes =
    bit(Code::a) | bit(Code::b) | bit(Code::c) | bit(Code::u) | bit(Code::v) | bit(Code::w);
constexpr std::uint64_t polar_words = bit(Code::polar_angle) | bit(Code::polar_radius);
[[nodiscard]] inline Code axis_code(int k) { return static_cast<Code>(static_cast<int>(Code::x) + k); }
[[nodiscard]] inline double& coordinate(geom::Vec3& v, int k) { return k == 0 ? v.x : k == 1 ? v.y : v.z; }
[[nodiscard]] inline double coordinate(const geom::Vec3& v, int k) { return k == 0 ? v.x : k == 1 ? v.y : v.z; }
/// The working plane: indices (0 = x …) of its first and second axis and of its normal.
struct PlaneAxes {
    int u = 0, v = 1, w = 2;
};
[[nodiscard]] inline PlaneAxes plane_axes(int plane) {
    if (plane == 18) return {2, 0, 1};
    if (plane == 19) return {1, 2, 0};
    return {0, 1, 2};
}
[[nodiscard]] inline geom::Vec2 in_plane(const geom::Vec3& v, const PlaneAxes& a) {
    return a.w == 2 ? geom::Vec2{v.x, v.y} : a.w == 1 ? geom::Vec2{v.z, v.x} : geom::Vec2{v.y, v.z};
}

}  // namespace obrys::interp
