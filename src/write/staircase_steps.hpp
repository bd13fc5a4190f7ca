#pragma once
/// What staircases of slopes and of arcs share. Private to write.

#include <algorithm>
#include <array>
#include <cmath>

#include "geom/vec.hpp"

namespace obrys::write {

inline constexpr double still = 1e-7;         ///< mm: an axis that would move less stands
inline constexpr double most_steps = 1e6;     ///< of one move
inline constexpr double wall_noise = 0.0015;  ///< mm, of walls, which are chords of arcs
inline constexpr double level_noise = 1e-9;   ///< of a normal beside an axis

inline std::array<double, 3> coordinates(const geom::Vec3& v) { return {v.x, v.y, v.z}; }
inline geom::Vec3 vector_of(const std::array<double, 3>& c) { return {c[0], c[1], c[2]}; }
inline geom::Vec2 level(const geom::Vec3& v) { return {v.x, v.y}; }

/// Whole steps of a way so long that none is longer than `step`, as the thesis counts them: one more where it divides.
inline double steps_for(double length, double step) { return step > 0 ? std::floor(length / step) + 1 : NAN; }

/// The fewest parts of which none is more than `most`.
inline double parts_of_at_most(double length, double most) {
    return std::max(1.0, std::ceil(length / most * (1 - 1e-12)));
}

}  // namespace obrys::write
