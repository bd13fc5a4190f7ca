/// Where the same tool has been before (cuts.hpp).

#include <algorithm>
#include <cmath>

#include "check/left/cuts.hpp"

namespace obrys::check {

namespace milling = sim::milling;

using geom::Vec2;
using geom::Vec3;

namespace {

constexpr double same_spot = 1e-9;   ///< mm
constexpr double same_axis = 1e-14;  ///< rounding of a direction

/// How high a tip stands over a straight way of the same tool, both in its frame: NaN beside the way.
double height_over(const milling::Track& t, Vec3 tip) {
    const Vec2 way{t.v.x, t.v.y}, at{tip.x, tip.y};
    const double square = geom::dot(way, way);
    const double u = square > 0 ? std::clamp(geom::dot(at, way) / square, 0.0, 1.0) : 0;
    if (geom::length(at - u * way) > same_spot) return NAN;
    return square > 0 ? tip.z - u * t.v.z : tip.z - std::clamp(tip.z, std::min(0.0, t.v.z), std::max(0.0, t.v.z));
}

}  // namespace

bool LeftCuts::hold_way(const milling::Shape& own, const geom::Straight& way, Vec3 axis, double stock_top) const {
    return std::any_of(sweeps_.begin(), sweeps_.end(), [&](const milling::Air::Sweep& s) {
        if (s.shape != &own || s.track.circular || geom::distance(s.frame.z, axis) > 0) return false;
        const auto holds = [&](Vec3 tip) {
            const double over = height_over(s.track, s.frame.to_tool(tip - s.from));
            if (std::abs(over) <= same_spot) return true;
            return own.rising && over > 0 && geom::dot(axis, tip) - over + own.top >= stock_top;
        };
        return holds(way.from) && holds(way.to);
    });
}

bool LeftCuts::was_at(const milling::Shape& own, Vec3 tip, Vec3 axis) const {
    return std::any_of(sweeps_.begin(), sweeps_.end(), [&](const milling::Air::Sweep& s) {
        if (s.shape != &own || geom::distance(s.frame.z, axis) > same_axis) return false;
        const Vec3 at = s.frame.to_tool(tip - s.from);
        if (s.track.circular) return geom::length(at) <= same_spot || geom::distance(at, s.track.v) <= same_spot;
        return std::abs(height_over(s.track, at)) <= same_spot;
    });
}

}  // namespace obrys::check
