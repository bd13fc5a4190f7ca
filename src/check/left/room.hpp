#pragma once
/// A box about a place, made as large as it may be.

#include <algorithm>
#include <array>
#include <cstddef>

#include "check/left/body.hpp"

namespace obrys::check {

/// A box about a place.
struct Room {
    geom::Vec3 at;
    std::array<geom::Vec3, 3> axes;
    std::array<std::array<double, 2>, 3> size{};  ///< against and along each
    [[nodiscard]] std::array<geom::Vec3, 8> corners() const {
        std::array<geom::Vec3, 8> all;
        for (std::size_t i = 0; i < all.size(); ++i) {
            all[i] = at;
            for (std::size_t k = 0; k < 3; ++k) {
                const bool up = (i >> k & 1) != 0;
                all[i] = all[i] + (up ? size[k][1] : -size[k][0]) * axes[k];
            }
        }
        return all;
    }
};

/// Axes of a room: `first` and one as near to `second` as can be.
inline std::array<geom::Vec3, 3> axes_of(geom::Vec3 first, geom::Vec3 second) {
    geom::Vec3 next = second - geom::dot(second, first) * first;
    if (!(geom::length(next) > 0.1)) {
        const sim::milling::Orientation any = sim::milling::orientation_of(first);
        return {first, any.x, any.y};
    }
    next = (1 / geom::length(next)) * next;
    return {first, next, geom::cross(first, next)};
}

/// A side as far out as it may be, but for `fine`.
template <class Holds>
void grow(Room& room, std::size_t axis, std::size_t side, double most, double fine, const Holds& holds) {
    double& size = room.size[axis][side];
    double in = size, out = most;
    size = most;
    if (holds(room)) return;
    constexpr int halvings = 40;
    for (int i = 0; i < halvings && out - in > fine; ++i) {
        size = 0.5 * (in + out);
        (holds(room) ? in : out) = size;
    }
    size = in;
}

/// All sides but the first one's, in turn and by and by, so that none takes the room of the others.
template <class Holds>
void widen(Room& room, double first, double most, double fine, const Holds& holds) {
    constexpr std::array<std::array<std::size_t, 2>, 5> sides{{{0, 0}, {1, 0}, {1, 1}, {2, 0}, {2, 1}}};
    const auto next = [&](double size) { return std::min(most, std::max(first, 2 * size)); };
    bool any = true;
    for (int round = 0; round < 30 && any; ++round) {
        any = false;
        for (const auto& [k, side] : sides) {
            double& size = room.size[k][side];
            const double was = size;
            if (was >= most) continue;
            size = next(was);
            if (holds(room))
                any = true;
            else
                size = was;
        }
    }
    for (const auto& [k, side] : sides)
        if (const double size = room.size[k][side]; size < most) grow(room, k, side, next(size), fine, holds);
}

}  // namespace obrys::check
