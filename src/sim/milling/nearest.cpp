#include "sim/milling/nearest.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace obrys::sim::milling {
namespace {

using geom::Vec2;
using geom::Vec3;

constexpr double meeting_slack = 1e-12;  ///< mm
constexpr double steep = 0.9;            ///< of a gradient along the axis: that of a piece's disc, not of its side

struct Moment {
    double t = 0, slope = 0;
    Foot foot;
};

template <class Convex>
Moment moment(const Convex& body, Vec3 v, Vec3 p, double t) {
    Moment m;
    m.t = t;
    m.foot.outside = outside(body, p - t * v, m.foot.normal);
    m.foot.gradient = m.foot.normal;
    m.foot.place = t * v;
    m.slope = -dot(m.foot.normal, v);
    return m;
}

/// The place of a tool that keeps its height at the moment when its axis is nearest to p: that is when every piece is.
Vec3 place_near(const Track& track, Vec2 p) {
    if (!track.circular) {
        const double square = track.v.x * track.v.x + track.v.y * track.v.y;
        const double t = square > 0 ? std::clamp((p.x * track.v.x + p.y * track.v.y) / square, 0.0, 1.0) : 0;
        return t * track.v;
    }
    const Vec2 q = p - track.centre;
    const double far = geom::length(q);
    if (far > 0 && track.passes(q)) {
        const Vec2 at = track.centre + (track.radius / far) * q;
        return {at.x, at.y, 0};
    }
    return geom::length(p) <= geom::distance(p, {track.v.x, track.v.y}) ? Vec3{} : track.v;
}

/// How far a point lies outside of a moving piece at least: beside all places of its axis, below or above all of it.
double least_outside(const Piece& piece, const Track& track, Vec3 p) {
    const Vec3 place = place_near(track, {p.x, p.y});
    const double beside =
        geom::length(Vec2{p.x - place.x, p.y - place.y}) - std::max({piece.r0, piece.r1, piece.ring + piece.arc});
    return std::max({beside, piece.z0 + std::min(0.0, track.v.z) - p.z, p.z - piece.z1 - std::max(0.0, track.v.z)});
}

/// The least value of a convex function of time, which is piecewise smooth: between two moments the tangents' meeting
/// is a lower bound; it tells when to stop, and takes turns with the secant of the slopes as the next moment to look
/// at.
template <class Convex>
Foot foot_of(const Convex& body, Vec3 v, Vec3 p) {
    Moment a = moment(body, v, p, 0), b = moment(body, v, p, 1);
    if (a.slope >= 0) return a.foot;
    if (b.slope <= 0) return b.foot;
    double weight_a = 1, weight_b = 1;
    for (int i = 0; i < 80; ++i) {
        const double fa = a.foot.outside, fb = b.foot.outside;
        const double meet = (fb - fa + a.slope * a.t - b.slope * b.t) / (a.slope - b.slope);
        if (std::min(fa, fb) - (fa + a.slope * (meet - a.t)) < meeting_slack) break;
        const double sa = weight_a * a.slope, sb = weight_b * b.slope;
        double t = i % 3 == 2 ? meet : a.t + (b.t - a.t) * (sa / (sa - sb));
        if (!(t > a.t && t < b.t)) t = (a.t + b.t) / 2;
        const Moment m = moment(body, v, p, t);
        if (m.slope == 0) return m.foot;
        if (m.slope < 0) {
            a = m;
            weight_a = 1;
            weight_b /= 2;
        } else {
            b = m;
            weight_b = 1;
            weight_a /= 2;
        }
    }
    Foot best = a.foot.outside < b.foot.outside ? a.foot : b.foot;
    const double share = b.slope / (b.slope - a.slope);  // of a, for a slope of 0
    best.gradient = share * a.foot.normal + (1 - share) * b.foot.normal;
    return best;
}

/// A tool that keeps its height stands at `place` when it is nearest.
template <class Convex>
Foot foot_of(const Convex& body, const Track& track, Vec3 place, Vec3 p) {
    if (!track.circular && !track.level()) return foot_of(body, track.v, p);
    Foot foot;
    foot.place = place;
    foot.outside = outside(body, p - place, foot.normal);
    foot.gradient = foot.normal;
    return foot;
}

}  // namespace

Foot foot_on(const Piece& piece, Vec3 v, Vec3 p) { return foot_of(piece, v, p); }

Foot foot_on(const Shape& shape, const Track& track, Vec3 p) {
    Foot best;
    best.outside = std::numeric_limits<double>::infinity();
    const bool level = track.circular || track.level();
    const Vec3 place = level ? place_near(track, {p.x, p.y}) : Vec3{};
    std::size_t deepest = 0;
    for (std::size_t i = 0; i < shape.pieces.size(); ++i) {
        const Piece& piece = shape.pieces[i];
        Foot foot;
        if (!level && piece.kind == PieceKind::round && piece.whole && piece.ring == 0) {
            const Vec3 q = p - Vec3{0, 0, piece.centre};
            const double t = std::clamp(dot(q, track.v) / dot(track.v, track.v), 0.0, 1.0);
            foot.place = t * track.v;
            foot.outside = outside(piece, p - foot.place, foot.normal);
            foot.gradient = foot.normal;
        } else if (!level && least_outside(piece, track, p) >= best.outside) {
            continue;
        } else {
            foot = foot_of(piece, track, place, p);
        }
        if (foot.outside < best.outside) best = foot, deepest = i;
    }
    // At the disc between two pieces both end, but there is no surface. Where another end of the piece is nearer than
    // that disc, what goes on beyond it is no deeper.
    if (best.outside > 0 || !(std::abs(best.gradient.z) > steep)) return best;
    const std::size_t disc = best.gradient.z > 0 ? deepest : deepest - 1;  // below the lowest piece there is none
    if (disc >= shape.bridges.size()) return best;
    const Foot foot = foot_of(shape.bridges[disc], track, place, p);
    if (foot.outside < best.outside) best = foot;
    return best;
}

}  // namespace obrys::sim::milling
