#include "check/left/swept_depth.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace obrys::check {

using geom::Vec2;
using geom::Vec3;

namespace {

constexpr double no_length = 1e-12;

Vec2 unit(Vec2 v) { return (1 / geom::length(v)) * v; }

}  // namespace

SweptDepth::SweptDepth(const std::vector<Vec2>& profile, Vec3 axis, Vec3 from, Vec3 way, bool open_below,
                       bool open_above)
    : profile_(profile), frame_(sim::milling::orientation_of(axis)), from_(from), way_(frame_.to_tool(way)) {
    slants_ = std::abs(way_.z) > no_length;
    if (!open_below) slopes_.push_back({0, -1});
    for (std::size_t i = 0; i + 1 < profile.size(); ++i) {
        const Vec2 along = profile[i + 1] - profile[i];
        if (geom::length(along) > no_length && along.y > no_length) slopes_.push_back(unit({along.y, -along.x}));
    }
    if (!open_above) slopes_.push_back({0, 1});
}

/// Round about the axis the plane that is nearest: the larger of what both ends of the way say, least of all
/// directions.
SweptDepth::Nearest SweptDepth::at_slope(Vec2 slope, Vec3 p) const {
    double reach = -std::numeric_limits<double>::infinity();
    for (const Vec2& at : profile_) reach = std::max(reach, geom::dot(slope, at));
    const double c = slope.x;
    const Vec2 first{p.x, p.y}, last{p.x - way_.x, p.y - way_.y}, way{way_.x, way_.y};
    const double at_first = reach - slope.y * p.z, at_last = reach - slope.y * (p.z - way_.z);
    std::array<Vec2, 4> turns{Vec2{1, 0}, Vec2{1, 0}, Vec2{1, 0}, Vec2{1, 0}};
    std::size_t n = 1;
    if (geom::length(first) > no_length) turns[0] = unit(first);
    if (geom::length(last) > no_length) turns[n++] = unit(last);
    if (const double size = geom::length(way); c > no_length && size > no_length) {
        const double along = -slope.y * way_.z / (c * size);
        if (std::abs(along) <= 1) {
            const Vec2 u = (1 / size) * way;
            const double across = std::sqrt(1 - along * along);
            turns[n++] = along * u + across * Vec2{-u.y, u.x};
            turns[n++] = along * u - across * Vec2{-u.y, u.x};
        }
    }
    Nearest best{{}, std::numeric_limits<double>::infinity()};
    for (std::size_t i = 0; i < n; ++i) {
        const Vec2 u = turns[i];
        const double depth = std::max(at_first - c * geom::dot(u, first), at_last - c * geom::dot(u, last));
        if (depth < best.depth) best = {frame_.to_stock({c * u.x, c * u.y, slope.y}), depth};
    }
    return best;
}

void SweptDepth::attempt(Vec2 slope, Vec3 p, Nearest& best) const {
    const Nearest n = at_slope(slope, p);
    if (n.depth < best.depth) best = n;
}

SweptDepth::Nearest SweptDepth::nearest(Vec3 at) const {
    const Vec3 p = frame_.to_tool(at - from_);
    Nearest best{{}, std::numeric_limits<double>::infinity()};
    for (const Vec2& slope : slopes_) attempt(slope, p, best);
    if (!slants_) return best;
    // Between the sides' slopes a rim sweeps; the least of several that are looked at lies beside the least of all.
    constexpr double share = 0.6180339887498949;
    constexpr int steps = 24, looks = 8;
    for (std::size_t i = 0; i + 1 < slopes_.size(); ++i) {
        const double low = std::atan2(slopes_[i].y, slopes_[i].x),
                     high = std::atan2(slopes_[i + 1].y, slopes_[i + 1].x);
        if (!(high - low > 1e-9)) continue;
        const auto at_angle = [&](double angle) { return at_slope({std::cos(angle), std::sin(angle)}, p); };
        const double part = (high - low) / looks;
        int least = 0;
        double depth = std::numeric_limits<double>::infinity();
        for (int k = 0; k <= looks; ++k)
            if (const double d = at_angle(low + k * part).depth; d < depth) depth = d, least = k;
        double a = low + std::max(0, least - 1) * part, b = low + std::min(looks, least + 1) * part;
        double s = b - share * (b - a), t = a + share * (b - a);
        Nearest at_s = at_angle(s), at_t = at_angle(t);
        for (int k = 0; k < steps; ++k) {
            if (at_s.depth <= at_t.depth)
                b = t, t = s, at_t = at_s, at_s = at_angle(s = b - share * (b - a));
            else
                a = s, s = t, at_s = at_t, at_t = at_angle(t = a + share * (b - a));
        }
        for (const Nearest& n : {at_s, at_t})
            if (n.depth < best.depth) best = n;
    }
    return best;
}

}  // namespace obrys::check
