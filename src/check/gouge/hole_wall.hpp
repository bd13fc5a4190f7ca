#pragma once
/// How wide a hole is, by points of its wall that several moves have cut. Millimetres.

#include <cstdint>
#include <optional>
#include <vector>

#include "geom/vec.hpp"

namespace obrys::check {

struct WallPoint {
    geom::Vec3 at;
    std::uint32_t tag = 0;  ///< of the move that cut there
};

/// A line that the hole should lie about; unit vector.
struct HoleAxis {
    geom::Vec3 foot, along;
};

struct HoleRadii {
    double fitted = 0;  ///< of the circle of least squares through all points; `least` where they lie on none
    /// Of the narrowest circle that one of the moves has cut: where others took more, the hole was meant like this.
    double least = 0;
};

[[nodiscard]] double middle(std::vector<double> v);

/// Nothing where neither the wall nor what a move has cut of it is a cylinder along the axis: half of the points lie
/// farther off than allowed.
[[nodiscard]] std::optional<HoleRadii> radii_of(const std::vector<WallPoint>& wall, const HoleAxis& axis,
                                                double allowed);

}  // namespace obrys::check
