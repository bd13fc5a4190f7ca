#pragma once
/// Frames: shift, rotation, scale and mirror of one coordinate system in another.

#include <array>

#include "geom/vec.hpp"

namespace obrys::geom {

/// Affine map from the inner to the outer system: `outer = linear * inner + origin`.
/// `linear` holds the rotation, the scale factors and the mirroring, row by row.
struct Frame {
    std::array<double, 9> linear{1, 0, 0, 0, 1, 0, 0, 0, 1};
    Vec3 origin;

    bool operator==(const Frame&) const = default;
    [[nodiscard]] static Frame shift(Vec3 by);
    /// Rotation by `angle` radians, counter-clockwise seen against `axis` (0 = x, 1 = y, 2 = z).
    [[nodiscard]] static Frame rotation(int axis, double angle);
    [[nodiscard]] static Frame scaling(Vec3 factors);
};

[[nodiscard]] Vec3 apply(const Frame& f, Vec3 point);        ///< a point of the inner system, in the outer
[[nodiscard]] Vec3 apply_direction(const Frame& f, Vec3 v);  ///< a direction: without the shift
[[nodiscard]] Frame operator*(const Frame& outer, const Frame& inner);
[[nodiscard]] double determinant(const Frame& f);  ///< negative where the frame mirrors
[[nodiscard]] bool is_invertible(const Frame& f);
[[nodiscard]] Frame inverse(const Frame& f);  ///< requires is_invertible
[[nodiscard]] bool is_shift_only(const Frame& f);

}  // namespace obrys::geom
