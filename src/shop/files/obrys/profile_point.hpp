#pragma once
/// One point of a profile in a job or tool file, and the edge that follows it. Private to this room.

#include <optional>

#include "geom/vec.hpp"
#include "shop/files/section.hpp"

namespace obrys::shop {

inline constexpr double same_point = 1e-9;   ///< mm
inline constexpr double chord_slack = 1e-6;  ///< mm; a semicircle with rounded coordinates is still a semicircle

struct ProfilePoint {
    geom::Vec2 p;                  ///< z, x; of a tool x, z
    std::optional<double> radius;  ///< of the arc to the next point, positive counter-clockwise
    bool large = false;
    base::Span where, radius_where;
};

/// `{z, x}` with `r`, `direction`, `large`; nothing where a coordinate is missing or was reported. `radii`: what
/// x may be.
[[nodiscard]] std::optional<ProfilePoint> read_profile_point(const Value& v, bool diameter,
                                                             base::Diagnostics& diagnostics,
                                                             Range radii = Range::not_negative);
/// The bulge of the edge from a to b; nothing, reported, where the radius does not reach.
[[nodiscard]] std::optional<double> bulge_of(const ProfilePoint& a, geom::Vec2 b, const Section& s);

}  // namespace obrys::shop
