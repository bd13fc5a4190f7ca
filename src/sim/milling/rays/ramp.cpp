// Rays along the axis of a tool on a ramp.

#include <algorithm>
#include <cmath>

#include "sim/milling/rays/lanes.hpp"
#include "sim/milling/rays/rows.hpp"

namespace obrys::sim::milling::detail {
namespace {

using geom::Vec2;
using geom::Vec3;

struct Slope {
    Vec2 e;           ///< direction of the way, seen along the axis
    double way = 0;   ///< its length
    double rise = 0;  ///< per way
};
Slope slope_of(const Track& track) {
    Slope s;
    s.way = std::hypot(track.v.x, track.v.y);
    s.e = {track.v.x / s.way, track.v.y / s.way};
    s.rise = track.v.z / s.way;
    return s;
}

/// While the axis is within `radius` of a ray: from which part of the way to which; not from < to: never.
struct Stay {
    double from = 1, to = 0;
    double a = 0, n = 0;  ///< along the way and beside it
};
Stay stay_of(const Slope& slope, Vec2 p, double radius) {
    Stay s;
    s.a = dot(p, slope.e);
    s.n = cross(slope.e, p);
    const double square = radius * radius - s.n * s.n;
    if (!(square > 0)) return s;
    const double half = std::sqrt(square);
    s.from = std::max(0.0, s.a - half);
    s.to = std::min(slope.way, s.a + half);
    return s;
}

/// Lower side of a piece at a distance from its axis, and its first two derivatives.
struct Flank {
    double height = 0, rise = 0, bend = 0;
};
Flank flank_of(const Piece& p, double distance) {
    if (p.kind == PieceKind::cone) {
        if (distance <= p.r0 || p.r1 <= p.r0) return {p.z0, 0, 0};
        const double rise = (p.z1 - p.z0) / (p.r1 - p.r0);
        return {p.z0 + (distance - p.r0) * rise, rise, 0};
    }
    const double beyond = std::max(0.0, distance - p.ring), arc2 = p.arc * p.arc;
    const double depth = std::sqrt(std::max(0.0, arc2 - beyond * beyond));
    const double height = p.centre - depth;
    if (height < p.z0) return {p.z0, 0, 0};
    return {height, depth > 0 ? beyond / depth : never, arc2 / (depth * depth * depth)};
}

/// Lowest point of a piece that gets wider upwards, over a ray, on its way along a ramp: the height is a convex
/// function of the way, so its derivative has one change of sign. Newton's method finds it between two bounds.
double ramp_low(const Piece& piece, const Slope& slope, Vec2 p) {
    const Stay s = stay_of(slope, p, std::max(piece.r0, piece.r1));
    if (!(s.from < s.to)) return never;
    double low = never, change = 0, bend = 0;
    const auto look = [&](double x) {
        const double m = s.a - x, square = s.n * s.n + m * m, distance = std::sqrt(square);
        const Flank f = flank_of(piece, distance);
        const double share = m == 0 ? 0 : m / distance;
        change = slope.rise - (f.rise == 0 || m == 0 ? 0 : f.rise * share);
        bend = f.bend * share * share + (f.rise == 0 ? 0 : f.rise * (s.n * s.n / (square * distance)));
        low = std::min(low, f.height + x * slope.rise);
    };
    double a = s.from, b = s.to;
    look(a);
    if (change >= 0) return low;
    look(b);
    if (change <= 0) return low;
    double x = (a + b) / 2, before = never;
    for (int i = 0; i < 100 && b - a > 1e-13; ++i) {
        look(x);
        if (change * change < 1e-20 || change * change < 1e-13 * bend) break;
        (change < 0 ? a : b) = x;
        const double next = x - change / bend;
        const bool nearer = std::abs(change) < before / 2;
        before = std::abs(change);
        x = nearer && next > a && next < b ? next : (a + b) / 2;
    }
    return low;
}

/// A round piece's way, as the rays of a row see it.
struct RoundRamp {
    double ring = 0, arc = 0, centre = 0, bottom = 0, radius = 0;
    double way = 0, rise = 0;
    Steps a, n;  ///< of the rays along the way and beside it
};

/// Lowest points where those lie at the beginning or at the end of a ray's stay under the piece, as most do on short
/// moves; NaN where they lie between, `never` beside the piece.
OBRYS_LANES void low_at_ends(const RoundRamp& r, int count, std::array<double, Row::most>& low) {
    const int lanes = in_full(count);
    for (int i = 0; i < lanes; ++i) {
        const double a = r.a.at + i * r.a.step, n = r.n.at + i * r.n.step;
        const double square = r.radius * r.radius - n * n, half = std::sqrt(square > 0 ? square : 0.0);
        const double from = a - half > 0 ? a - half : 0.0, to = a + half < r.way ? a + half : r.way;
        double height[2], growth[2];
        for (int end = 0; end < 2; ++end) {
            const double x = end == 0 ? from : to, m = a - x, distance = std::sqrt(n * n + m * m);
            const double out = distance - r.ring, beyond = out > 0 ? out : 0.0, left = r.arc * r.arc - beyond * beyond;
            const double depth = std::sqrt(left > 0 ? left : 0.0), flank = r.centre - depth;
            const bool flat = !(beyond > 0) || flank < r.bottom;
            height[end] = (flank < r.bottom ? r.bottom : flank) + x * r.rise;
            growth[end] = flat ? r.rise : r.rise * depth * distance - beyond * m;
        }
        double lowest = growth[1] <= 0 ? height[1] : std::numeric_limits<double>::quiet_NaN();
        lowest = growth[0] >= 0 ? height[0] : lowest;
        lowest = square > 0 ? lowest : never;
        low[static_cast<std::size_t>(i)] = from < to ? lowest : never;
    }
}

RoundRamp round_ramp(const Piece& piece, const Slope& slope, const Row& row) {
    RoundRamp r;
    r.ring = piece.ring;
    r.arc = piece.arc;
    r.centre = piece.centre;
    r.bottom = piece.z0;
    r.radius = std::max(piece.r0, piece.r1);
    r.way = slope.way;
    r.rise = slope.rise;
    const Vec2 p{row.p.x, row.p.y}, step{row.step.x, row.step.y};
    r.a = {dot(p, slope.e), dot(step, slope.e)};
    r.n = {cross(slope.e, p), cross(slope.e, step)};
    return r;
}

}  // namespace

void ramp_cylinder_row(const Piece& piece, const Track& track, const Row& row, Spans& spans) {
    const Slope slope = slope_of(track);
    for (int i = 0; i < row.count; ++i) {
        const auto at = static_cast<std::size_t>(i);
        const Vec3 p = row.p + i * row.step;
        const Stay s = stay_of(slope, {p.x, p.y}, piece.r0);
        if (!(s.from < s.to)) {
            spans.low[at] = 1, spans.high[at] = 0;
            continue;
        }
        const double z0 = s.from * slope.rise, z1 = s.to * slope.rise;
        const double low = piece.z0 + std::min(z0, z1), high = piece.z1 + std::max(z0, z1);
        spans.low[at] = row.d.z > 0 ? low : -high;
        spans.high[at] = row.d.z > 0 ? high : -low;
    }
}

void ramp_low_row(const Shape& shape, const Track& track, const Row& row, double high, Spans& spans) {
    const Slope slope = slope_of(track);
    spans.low.fill(high);
    spans.high.fill(high);
    std::array<double, Row::most> low;
    for (const Piece& piece : shape.pieces) {
        if (piece.covered && !(piece.r1 > piece.r0)) continue;
        const bool is_round = piece.kind == PieceKind::round;
        if (is_round) low_at_ends(round_ramp(piece, slope, row), row.count, low);
        for (int i = 0; i < row.count; ++i) {
            const auto at = static_cast<std::size_t>(i);
            const Vec3 p = row.p + i * row.step;
            if (!is_round || std::isnan(low[at])) low[at] = ramp_low(piece, slope, {p.x, p.y});
            spans.low[at] = std::min(spans.low[at], low[at]);
        }
    }
}

}  // namespace obrys::sim::milling::detail
