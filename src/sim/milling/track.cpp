#include "sim/milling/track.hpp"

#include <algorithm>
#include <cmath>

namespace obrys::sim::milling {
namespace {

constexpr double parallel = 1e-12;  ///< components below this belong to an axis of the stock that was turned there

geom::Vec3 unit(int axis, double sign) {
    return {axis == 0 ? sign : 0.0, axis == 1 ? sign : 0.0, axis == 2 ? sign : 0.0};
}

Box3 box_of(Heights x, Heights y, Heights z) { return {{x.low, y.low, z.low}, {x.high, y.high, z.high}}; }

}  // namespace

Heights heights_along(geom::Vec3 axis, const Box3& box) {
    const auto ends = [](double share, double from, double to) { return std::minmax({share * from, share * to}); };
    const auto [x0, x1] = ends(axis.x, box.min.x, box.max.x);
    const auto [y0, y1] = ends(axis.y, box.min.y, box.max.y);
    const auto [z0, z1] = ends(axis.z, box.min.z, box.max.z);
    return {x0 + y0 + z0, x1 + y1 + z1};
}

Box3 Orientation::box_in_tool(const Box3& box) const {
    return box_of(heights_along(x, box), heights_along(y, box), heights_along(z, box));
}

Box3 Orientation::box_in_stock(const Box3& box) const {
    return box_of(heights_along({x.x, y.x, z.x}, box), heights_along({x.y, y.y, z.y}, box),
                  heights_along({x.z, y.z, z.z}, box));
}

Orientation orientation_of(geom::Vec3 axis) {
    Orientation o;
    o.z = (1 / length(axis)) * axis;
    const double ax = std::abs(o.z.x), ay = std::abs(o.z.y), az = std::abs(o.z.z);
    o.along = ay < parallel && az < parallel   ? 0
              : ax < parallel && az < parallel ? 1
              : ax < parallel && ay < parallel ? 2
                                               : -1;
    if (o.along >= 0) {
        const double sign = (o.along == 0 ? o.z.x : o.along == 1 ? o.z.y : o.z.z) > 0 ? 1 : -1;
        o.z = unit(o.along, sign);
        o.x = unit((o.along + 1) % 3, 1);
    } else {
        const int least = ax <= ay && ax <= az ? 0 : ay <= az ? 1 : 2;
        o.x = cross(unit(least, 1), o.z);
        o.x = (1 / length(o.x)) * o.x;
    }
    o.y = cross(o.z, o.x);
    return o;
}

geom::Vec3 point_on(const Track& track, double share) {
    if (!track.circular) return share * track.v;
    const geom::Vec2 across = (1 - share) * track.first + share * track.last;
    const geom::Vec2 p = track.centre + (track.radius / geom::length(across)) * across;
    return {p.x, p.y, 0};
}

Offset offset_from(const Track& track, geom::Vec2 p) {
    using geom::Vec2;
    if (!track.circular) {
        const Vec2 v{track.v.x, track.v.y};
        const double way = std::sqrt(dot(v, v));
        if (way == 0) return {geom::length(p), geom::length(p)};
        const Vec2 e = (1 / way) * v;
        const double a = dot(p, e), n = cross(e, p), m = a - std::clamp(a, 0.0, way);
        return {m == 0 ? std::abs(n) : std::sqrt(m * m + n * n), n};
    }
    const Vec2 q = p - track.centre;
    const double far = std::sqrt(dot(q, q));
    const double left = track.turn * (track.radius - far);
    if (track.passes(q)) return {std::abs(left), left};
    return {std::min(geom::length(p), geom::distance(p, {track.v.x, track.v.y})), left};
}

}  // namespace obrys::sim::milling
