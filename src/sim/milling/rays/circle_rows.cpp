#include <algorithm>
#include <cmath>

#include "sim/milling/rays/rows.hpp"

namespace obrys::sim::milling::detail {
namespace {

using geom::Vec2;

struct Ray {
    Vec2 p, d;
};

struct Stretch {
    double low = 1, high = 0;
};

Stretch through_disc(const Ray& line, Vec2 centre, double radius) {
    const Vec2 to = centre - line.p;
    const double beside = cross(line.d, to), square = radius * radius - beside * beside;
    if (!(square > 0)) return {};
    const double half = std::sqrt(square), middle = dot(line.d, to);
    return {middle - half, middle + half};
}

/// Keeps of [low, high] where a + s b >= 0.
void clip(Stretch& part, double a, double b) {
    if (b > 0)
        part.low = std::max(part.low, -a / b);
    else if (b < 0)
        part.high = std::min(part.high, -a / b);
    else if (a < 0)
        part = {};
}

}  // namespace

/// The swept disc: the discs at both ends and, between their directions from the centre, a ring. The ring may be met
/// twice.
void cut_circle_across(const Track& track, const Row& row, double radius, base::FunctionRef<void(const Spans&)> take) {
    std::array<Spans, 4> spans;
    for (int i = 0; i < row.count; ++i) {
        const geom::Vec3 p = row.p + i * row.step;
        const Ray line{{p.x, p.y}, {row.d.x, row.d.y}};
        std::array<Stretch, 4> parts{through_disc(line, {}, radius),
                                     through_disc(line, {track.v.x, track.v.y}, radius)};
        Stretch ring = through_disc(line, track.centre, track.radius + radius);
        const Vec2 q = line.p - track.centre;
        clip(ring, track.turn * cross(track.first, q), track.turn * cross(track.first, line.d));
        clip(ring, track.turn * cross(q, track.last), track.turn * cross(line.d, track.last));
        const Stretch hole =
            radius < track.radius ? through_disc(line, track.centre, track.radius - radius) : Stretch{};
        if (hole.low < hole.high) {
            parts[2] = {ring.low, std::min(ring.high, hole.low)};
            parts[3] = {std::max(ring.low, hole.high), ring.high};
        } else {
            parts[2] = ring;
        }
        for (std::size_t k = 0; k < parts.size(); ++k) {
            spans[k].low[static_cast<std::size_t>(i)] = parts[k].low;
            spans[k].high[static_cast<std::size_t>(i)] = parts[k].high;
        }
    }
    for (const Spans& s : spans) take(s);
}

}  // namespace obrys::sim::milling::detail
