#include "check/touching/clearing_cut.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace obrys::check {

namespace milling = sim::milling;

using geom::Vec2;
using geom::Vec3;

namespace {

constexpr double joined = 1e-6;  ///< mm between zones that are one

Vec2 in_plane(Vec3 p) { return {p.x, p.y}; }

/// Where on a way, 0 … 1, a place is nearest.
double nearest_at(Vec2 from, Vec2 way, Vec2 p) {
    const double square = geom::dot(way, way);
    return square > 0 ? std::clamp(geom::dot(p - from, way) / square, 0.0, 1.0) : 0;
}

std::array<Vec2, 4> corners_of(const Patch& p) {
    return {Vec2{p.lo.x, p.lo.y}, Vec2{p.hi.x, p.lo.y}, Vec2{p.hi.x, p.hi.y}, Vec2{p.lo.x, p.hi.y}};
}

double from_patch(const Patch& patch, Vec2 p) {
    const Vec2 off{std::max({patch.lo.x - p.x, p.x - patch.hi.x, 0.0}),
                   std::max({patch.lo.y - p.y, p.y - patch.hi.y, 0.0})};
    return geom::length(off);
}

}  // namespace

double distance_between(Vec2 from, Vec2 to, const Patch& patch) {
    // The distance from a convex set is convex along a straight way: the least by corners and ends, or they cross.
    const Vec2 way = to - from;
    double least = std::min(from_patch(patch, from), from_patch(patch, to));
    bool left = false, right = false;
    for (const Vec2& c : corners_of(patch)) {
        least = std::min(least, geom::length(c - (from + nearest_at(from, way, c) * way)));
        (geom::cross(way, c - from) > 0 ? left : right) = true;
    }
    const bool beside = std::max(from.x, to.x) < patch.lo.x || std::min(from.x, to.x) > patch.hi.x ||
                        std::max(from.y, to.y) < patch.lo.y || std::min(from.y, to.y) > patch.hi.y;
    return left && right && !beside ? 0 : least;
}

void Zones::add(Zone z) {
    if (!(z.high > z.low)) return;
    auto first = all_.begin();
    while (first != all_.end() && first->high < z.low - joined) ++first;
    auto last = first;
    for (; last != all_.end() && last->low <= z.high + joined; ++last) {
        z.low = std::min(z.low, last->low);
        z.high = std::max(z.high, last->high);
    }
    all_.insert(all_.erase(first, last), z);
}

bool Zones::cover(Zone z) const {
    return std::any_of(all_.begin(), all_.end(),
                       [&](const Zone& own) { return own.low <= z.low + joined && own.high >= z.high - joined; });
}

ClearingCut::ClearingCut(const milling::Air::Sweep& sweep)
    : shape_(sweep.shape),
      from_(sweep.frame.to_tool(sweep.from)),
      way_(sweep.track.v),
      circular_(sweep.track.circular),
      centre_(in_plane(from_) + sweep.track.centre),
      first_(sweep.track.first),
      last_(sweep.track.last),
      radius_(sweep.track.radius),
      turn_(sweep.track.turn) {
    flat_ = shape_->pieces.size() == 1 && shape_->pieces[0].kind == milling::PieceKind::cone &&
            shape_->pieces[0].r0 == shape_->pieces[0].r1;
    const Vec3 to = from_ + way_;
    // At most a quarter of a circle stands off its chord by less than half of that.
    const double more = shape_->radius + (circular_ ? 0.5 * geom::length(in_plane(way_)) : 0);
    around_ = {{std::min(from_.x, to.x) - more, std::min(from_.y, to.y) - more},
               {std::max(from_.x, to.x) + more, std::max(from_.y, to.y) + more}};
    heights_ = {std::min(from_.z, to.z) + shape_->bottom, std::max(from_.z, to.z) + shape_->top};
}

bool ClearingCut::in_wedge(Vec2 q) const {
    const double least = -1e-9 * geom::length(q);
    return turn_ * geom::cross(first_, q) >= least && turn_ * geom::cross(q, last_) >= least;
}

/// The way's part that is nearest to the corners is as near to all between them.
ClearingCut::Beside ClearingCut::beside(const Patch& patch) const {
    const std::array<Vec2, 4> corners = corners_of(patch);
    Beside b;
    if (circular_) {
        double most = 0, least = INFINITY, to_from = 0, to_end = 0;
        bool all = true;
        for (const Vec2& c : corners) {
            all = all && in_wedge(c - centre_);
            most = std::max(most, geom::length(c - centre_));
            to_from = std::max(to_from, geom::length(c - in_plane(from_)));
            to_end = std::max(to_end, geom::length(c - in_plane(from_ + way_)));
        }
        least = from_patch(patch, centre_);
        b.distance = all ? std::max(most - radius_, radius_ - least) : std::min(to_from, to_end);
        b.low = b.high = from_.z;
        return b;
    }
    const Vec2 from = in_plane(from_), way = in_plane(way_);
    double first = 1, last = 0;
    for (const Vec2& c : corners) {
        const double u = nearest_at(from, way, c);
        b.distance = std::max(b.distance, geom::length(c - (from + u * way)));
        first = std::min(first, u), last = std::max(last, u);
    }
    if (way == Vec2{}) first = 0, last = 1;
    const double at_first = from_.z + first * way_.z, at_last = from_.z + last * way_.z;
    b.low = std::min(at_first, at_last), b.high = std::max(at_first, at_last);
    return b;
}

/// Of a straight piece of another way.
ClearingCut::Beside ClearingCut::beside(Vec3 a, Vec3 b) const {
    Beside r;
    if (circular_) {
        const Vec2 p = in_plane(a) - centre_, q = in_plane(b) - centre_;
        r.low = r.high = from_.z;
        if (in_wedge(p) && in_wedge(q)) {
            const Vec2 way = q - p;
            const double least = geom::length(p + nearest_at(p, way, {}) * way);
            r.distance = std::max({geom::length(p) - radius_, geom::length(q) - radius_, radius_ - least});
            return r;
        }
        const auto from_end = [&](Vec2 end) {
            return std::max(geom::length(in_plane(a) - end), geom::length(in_plane(b) - end));
        };
        r.distance = std::min(from_end(in_plane(from_)), from_end(in_plane(from_ + way_)));
        return r;
    }
    const Vec2 from = in_plane(from_), way = in_plane(way_);
    double first = nearest_at(from, way, in_plane(a)), last = nearest_at(from, way, in_plane(b));
    r.distance =
        std::max(geom::length(in_plane(a) - (from + first * way)), geom::length(in_plane(b) - (from + last * way)));
    if (way == Vec2{}) first = 0, last = 1;
    const double at_first = from_.z + first * way_.z, at_last = from_.z + last * way_.z;
    r.low = std::min(at_first, at_last), r.high = std::max(at_first, at_last);
    return r;
}

void ClearingCut::add(const Beside& at, double slack, Zones& zones) const {
    const double d = std::max(0.0, at.distance - slack);
    if (d > shape_->radius) return;
    // Straight up or down all of its way counts, else what is taken wherever the tip is on that part.
    const bool upright = !circular_ && way_.x == 0 && way_.y == 0;
    const double low = upright ? at.low : at.high, high = upright ? at.high : at.low;
    if (shape_->rising) return zones.add({low + milling::lower_side(*shape_, d), high + shape_->top});
    for (const milling::Piece& p : shape_->pieces)
        if (const auto h = milling::heights_at(p, d)) zones.add({low + h->low, high + h->high});
}

void ClearingCut::add_over(const Patch& patch, double slack, Zones& zones) const { add(beside(patch), slack, zones); }

void ClearingCut::add_along(const Upright& body, double slack, Zones& zones) const {
    Beside at = beside(body.from, body.to);
    if (body.shape == shape_ && shape_->rising && at.distance <= slack) {
        // The same tool on this way or above it is within what it took.
        const auto above = [&](Vec3 tip) {
            const bool upright = way_.x == 0 && way_.y == 0;
            const double u = nearest_at(in_plane(from_), in_plane(way_), in_plane(tip));
            return tip.z >= (circular_ ? from_.z
                             : upright ? std::min(from_.z, from_.z + way_.z)
                                       : tip_at(u).z) -
                                joined;
        };
        if (above(body.from) && above(body.to)) {
            const bool upright = !circular_ && way_.x == 0 && way_.y == 0;
            zones.add({std::min(body.from.z, body.to.z) + body.bottom, (upright ? at.high : at.low) + shape_->top});
        }
    }
    at.distance += body.radius;
    add(at, slack, zones);
}

}  // namespace obrys::check
