#pragma once
/// Triangles that are looked at part by part.

#include <algorithm>
#include <array>
#include <utility>

#include "geom/vec.hpp"

namespace obrys::sim::milling {

using Corners = std::array<geom::Vec3, 3>;

[[nodiscard]] inline geom::Vec3 centroid_of(const Corners& t) { return (1.0 / 3) * (t[0] + t[1] + t[2]); }

[[nodiscard]] inline double farthest_from(geom::Vec3 p, const Corners& t) {
    return std::max({geom::distance(t[0], p), geom::distance(t[1], p), geom::distance(t[2], p)});
}

/// On both sides of the middle of its longest side.
[[nodiscard]] inline std::pair<Corners, Corners> halves_of(const Corners& t) {
    std::size_t longest = 0;
    for (std::size_t i = 1; i < 3; ++i)
        if (geom::distance(t[i], t[(i + 1) % 3]) > geom::distance(t[longest], t[(longest + 1) % 3])) longest = i;
    const std::size_t next = (longest + 1) % 3;
    std::pair<Corners, Corners> halves{t, t};
    halves.first[next] = halves.second[longest] = 0.5 * (t[longest] + t[next]);
    return halves;
}

}  // namespace obrys::sim::milling
