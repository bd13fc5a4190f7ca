#include "sim/certify/body.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace obrys::sim::certify {

using geom::Vec2;
using geom::Vec3;

namespace {

constexpr double slant = 0.1;  ///< radians off the axis, or off its normal
constexpr double soft = 0.05;  ///< of the depth: rounding left on corners, which keeps distances from nought

/// Unit vector from a corner of the half section inwards; `side`: towards the other corner.
Vec2 inwards(double radius, Vec2 side, double up, Inwards how) {
    if (!(radius > 0)) return {0, up};
    const auto off_axis = [&](double angle) { return Vec2{-std::sin(angle), up * std::cos(angle)}; };
    if (how == Inwards::along) return off_axis(slant);
    if (how == Inwards::across) return off_axis(geom::pi / 2 - slant);
    if (how == Inwards::rather_along) return off_axis(geom::pi / 6);
    if (how == Inwards::rather_across) return off_axis(geom::pi / 3);
    const double size = geom::length(side);
    if (!(size > 0)) return {-1, 0};
    if (how == Inwards::flank) return (up / size) * Vec2{-side.y, side.x};
    const Vec2 sum = Vec2{-1, 0} + (1 / size) * side;
    const double both = geom::length(sum);
    return both > 1e-9 ? (1 / both) * sum : Vec2{0, up};
}

/// The corner moved by `way` at most; what would pass the axis stays on it.
Vec2 moved(Vec2 corner, Vec2 direction, double way) {
    const Vec2 p = corner + way * direction;
    if (p.x >= 0) return p;
    const double rest = std::sqrt(std::max(0.0, way * way - corner.x * corner.x));
    return {0, corner.y + std::copysign(rest, direction.y)};
}

/// Where ends meet that would pass each other: neither farther off than it was moved. Half a body goes that far up or
/// down, as a point does: what lies below or above it is all that counts then.
double meeting(const Body& whole, const Body& moved, Inwards how) {
    const double highest = std::min(moved.z0, 2 * whole.z1 - moved.z1),
                 lowest = std::max(moved.z1, 2 * whole.z0 - moved.z0);
    if (how == Inwards::along || how == Inwards::rather_along) return highest;
    if (how == Inwards::rather_across) return lowest;
    return std::clamp((whole.z0 + whole.z1) / 2, moved.z1, moved.z0);
}

/// Nearest point of the half section's outline, as seen from outside; the point itself where it lies within.
Vec2 nearest_on(const Body& b, Vec2 p) {
    if (b.r0 == 0 && b.r1 == 0) return {0, std::clamp(p.y, b.z0, b.z1)};
    const std::array<Vec2, 4> corners{{{0, b.z0}, {b.r0, b.z0}, {b.r1, b.z1}, {0, b.z1}}};
    const Vec2 side = corners[2] - corners[1];
    // A disc without height has no flank to be on the inner side of.
    const bool inner = side == Vec2{} ? p.x <= b.r0 : geom::cross(side, p - corners[1]) >= 0;
    if (p.y >= b.z0 && p.y <= b.z1 && inner) return p;
    Vec2 best = corners[0];
    double least = INFINITY;
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec2 a = corners[i], along = corners[i + 1] - a;
        const double size = geom::dot(along, along);
        const double t = size > 0 ? std::clamp(geom::dot(p - a, along) / size, 0.0, 1.0) : 0;
        const Vec2 at = a + t * along, off = p - at;
        if (const double d = geom::dot(off, off); d < least) least = d, best = at;
    }
    return best;
}

}  // namespace

Body shrunk(const Body& body, double depth, Inwards how) {
    Body b = body;
    if (b.rounding >= depth) {
        b.rounding -= depth;
        return b;
    }
    const double left = depth - b.rounding, way = (1 + soft) * left;
    const Vec2 low{b.r0, b.z0}, high{b.r1, b.z1};
    const Vec2 l = moved(low, inwards(b.r0, high - low, 1, how), way);
    const Vec2 h = moved(high, inwards(b.r1, low - high, -1, how), way);
    b = {l.x, l.y, h.x, h.y, soft * left};
    if (b.z0 > b.z1) b.z0 = b.z1 = meeting(body, b, how);
    return b;
}

std::optional<Body> core_of(const Body& body, double depth) {
    Body b = body;
    if (b.rounding >= depth) {
        b.rounding -= depth;
        return b;
    }
    const double d = depth - b.rounding, rise = b.z1 - b.z0, growth = b.r1 - b.r0, slope = std::hypot(rise, growth);
    if (!(rise > 2 * d)) return std::nullopt;
    const Vec2 out{rise / slope, -growth / slope};
    const double line = geom::dot(out, {b.r0, b.z0}) - d;
    const auto radius = [&](double z) { return (line - out.y * z) / out.x; };
    double low = b.z0 + d, high = b.z1 - d;
    if (radius(low) < 0 && radius(high) < 0) return std::nullopt;
    if (radius(low) < 0) low = line / out.y;
    if (radius(high) < 0) high = line / out.y;
    return Body{std::max(0.0, radius(low)), low, std::max(0.0, radius(high)), high, 0};
}

Vec3 support(const Swept& s, Vec3 u) {
    const double up = dot(u, s.axis);
    const Vec3 across = u - up * s.axis;
    const double size = length(across);
    const bool high = s.body.r1 * size + s.body.z1 * up > s.body.r0 * size + s.body.z0 * up;
    const double r = high ? s.body.r1 : s.body.r0, z = high ? s.body.z1 : s.body.z0;
    Vec3 p = s.from + z * s.axis;
    // Along the axis what is across is rounding alone; the middle of the disc is as far.
    if (r > 0 && size > 1e-9 * std::abs(up)) p = p + (r / size) * across;
    return dot(u, s.way) > 0 ? p + s.way : p;
}

double extent(const Swept& s, Vec3 u) {
    const double up = dot(u, s.axis);
    const bool ball = s.body.r0 == 0 && s.body.r1 == 0;
    const double size = ball ? 0 : std::sqrt(std::max(0.0, 1 - up * up));
    const double body = std::max(s.body.r1 * size + s.body.z1 * up, s.body.r0 * size + s.body.z0 * up);
    return dot(u, s.from) + std::max(0.0, dot(u, s.way)) + body + s.body.rounding;
}

mesh::Box box_of(const Swept& s) {
    const Vec3 a = s.axis;
    const auto reach = [](double along) { return std::sqrt(std::max(0.0, 1 - along * along)); };
    const Vec3 ring{reach(a.x), reach(a.y), reach(a.z)}, ball{s.body.rounding, s.body.rounding, s.body.rounding};
    mesh::Box box;
    for (const Vec3& tip : {s.from, s.from + s.way})
        for (const auto& [r, z] : {std::pair{s.body.r0, s.body.z0}, std::pair{s.body.r1, s.body.z1}}) {
            const Vec3 middle = tip + z * a;
            box.add(middle - r * ring - ball);
            box.add(middle + r * ring + ball);
        }
    return box;
}

Vec3 towards(const Swept& s, Vec3 p) {
    const double size = dot(s.way, s.way);
    const auto nearest_way = [&](Vec3 q) { return size > 0 ? std::clamp(dot(q, s.way) / size, 0.0, 1.0) : 0.0; };
    Vec3 off;
    double t = nearest_way(p - s.from - (0.5 * (s.body.z0 + s.body.z1)) * s.axis);
    for (int i = 0; i < 2; ++i) {
        const Vec3 d = p - s.from - t * s.way;
        const double z = dot(d, s.axis);
        const Vec3 across = d - z * s.axis;
        const double r = length(across);
        const Vec2 near = nearest_on(s.body, {r, z});
        if (near.x == r && near.y == z) return {};
        const Vec3 at = near.y * s.axis + (r > 0 ? near.x / r : 0) * across;
        off = d - at;
        if (i > 0 || size == 0) break;
        t = nearest_way(p - s.from - at);
    }
    const double far = length(off);
    return far > 0 ? (1 / far) * off : Vec3{};
}

Vec3 nearest_within(const Swept& s, Vec3 p) {
    Vec3 core;
    const auto far = [&](double t) {
        const Vec3 d = p - s.from - t * s.way;
        const double z = dot(d, s.axis);
        const Vec3 across = d - z * s.axis;
        const double r = length(across);
        const Vec2 near = nearest_on(s.body, {r, z});
        core = p - d + near.y * s.axis + (r > 0 ? near.x / r : 0) * across;
        return geom::length(Vec2{r, z} - near);
    };
    // The distance is convex along the way: golden section.
    constexpr double share = 0.6180339887498949;
    double a = 0, b = 1, best = 0, least = far(0);
    const auto look = [&](double t) {
        const double d = far(t);
        if (d < least) least = d, best = t;
        return d;
    };
    if (dot(s.way, s.way) > 0 && least > 0 && look(1) > 0) {
        double t = b - share * (b - a), u = a + share * (b - a), at_t = look(t), at_u = look(u);
        while (b - a > 1e-10 && least > 0)
            if (at_t <= at_u) {
                b = u, u = t, at_u = at_t;
                at_t = look(t = b - share * (b - a));
            } else {
                a = t, t = u, at_t = at_u;
                at_u = look(u = a + share * (b - a));
            }
    }
    far(best);
    if (least <= s.body.rounding) return p;
    return core + (s.body.rounding / least) * (p - core);
}

}  // namespace obrys::sim::certify
