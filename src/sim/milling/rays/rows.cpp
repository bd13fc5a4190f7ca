#include "sim/milling/rays/rows.hpp"

#include <algorithm>
#include <cmath>

namespace obrys::sim::milling {
namespace {

using geom::Vec2;
using geom::Vec3;

constexpr double barely = 1e-9;  ///< mm

[[nodiscard]] bool is_ball(const Piece& p) { return p.kind == PieceKind::round && p.whole && p.ring == 0; }
[[nodiscard]] bool is_round(const Piece& p) { return p.kind == PieceKind::round && (p.ring > 0 || p.whole); }
[[nodiscard]] bool is_cylinder(const Piece& p) { return p.kind == PieceKind::cone && p.r0 == p.r1; }

void set(Spans& spans, int i, double low, double high) {
    spans.low[static_cast<std::size_t>(i)] = low;
    spans.high[static_cast<std::size_t>(i)] = high;
}

/// Rays along the axis, tool that keeps its height, its place or both coordinates' ratio to nothing: a ray is inside
/// between the heights that belong to its distance from the track.
void along_by_distance(const Piece& piece, const Track& track, const Row& row, Spans& spans) {
    const double down = std::min(0.0, track.v.z), up = std::max(0.0, track.v.z);
    for (int i = 0; i < row.count; ++i) {
        const Vec3 p = row.p + i * row.step;
        const auto h = heights_at(piece, offset_from(track, {p.x, p.y}).distance);
        if (!h)
            set(spans, i, 1, 0);
        else if (row.d.z > 0)
            set(spans, i, h->low + down, h->high + up);
        else
            set(spans, i, -h->high - up, -h->low - down);
    }
}

/// Rays across the axis, a cylinder on a ramp: a disc, while the ray is between its ends.
bool across_cylinder(const Piece& piece, const Track& track, const Row& row, const Aims& aims, Spans& spans) {
    const double t0 = (row.p.z - piece.z0) / track.v.z, t1 = (row.p.z - piece.z1) / track.v.z;
    const double from = std::max(0.0, std::min(t0, t1)), to = std::min(1.0, std::max(t0, t1));
    if (!(from <= to)) return false;
    detail::Capsule c = detail::capsule_of(aims.level, row, from, to, piece.r0);
    c.n = c.n_step = 0;
    detail::capsule_row(c, row.count, spans);
    return true;
}

/// A ball with its centre on the axis: seen from it the rays lie lower.
void ball_row(double centre, double radius, const Row& row, const Aims& aims, Spans& spans) {
    detail::Capsule c = detail::capsule_of(aims.whole, row, 0, 1, radius);
    c.a -= centre * aims.whole.e.z;
    c.n -= centre * aims.whole.beside.z;
    detail::capsule_row(c, row.count, spans);
    const double along = centre * row.d.z;
    if (along == 0) return;
    for (std::size_t i = 0; i < static_cast<std::size_t>(row.count); ++i) {
        spans.low[i] += along;
        spans.high[i] += along;
    }
}

/// Where rays meet the piece's way at most: an upright cylinder around it, between the heights it reaches.
void bound(const Piece& piece, const Track& track, const Row& row, const Aims& aims, Spans& spans) {
    const double bottom = (piece.whole ? piece.centre - piece.arc : piece.z0) + std::min(0.0, track.v.z) - barely;
    const double top = (piece.whole ? piece.centre + piece.arc : piece.z1) + std::max(0.0, track.v.z) + barely;
    double widest = widest_between(piece, piece.z0, piece.z1);
    if (aims.lie == Lie::across)
        widest = widest_between(piece, row.p.z - std::max(0.0, track.v.z), row.p.z - std::min(0.0, track.v.z));
    if (aims.flat_length > 0) {
        detail::Capsule c = detail::capsule_of(aims.flat, row, 0, 1, widest + barely);
        c.n = c.n_step = 0;
        detail::capsule_row(c, row.count, spans);
        detail::stretch_row({dot(row.p, aims.flat_d), dot(row.step, aims.flat_d)}, 1 / aims.flat_length, row.count,
                            spans);
    } else {
        spans.low.fill(-never);
        spans.high.fill(never);
    }
    if (std::abs(row.d.z) <= 1e-9) return;
    const double per_height = 1 / row.d.z, step = -row.step.z * per_height;
    const double one = (bottom - row.p.z) * per_height, other = (top - row.p.z) * per_height;
    detail::clip_row({std::min(one, other), step}, {std::max(one, other), step}, row.count, spans);
}

/// A cylinder met by skew rays: seen along the axis a disc on its way; where it meets a ray beyond an end of the
/// cylinder, that end's disc counts instead. False: no formula, for rays or ways next to level or upright.
class SkewCylinder {
public:
    SkewCylinder(const Piece& piece, const Track& track, const Row& row, const Aims& aims)
        : piece_(piece), v_(track.v), d_(row.d), aim_(aims.flat), flat_(aims.flat_length), flat_d_(aims.flat_d) {
        known_ = flat_ > 0.01 && std::abs(d_.z) > 0.01 && aim_.way > 1e-6 * length(v_);
        if (!known_) return;
        per_rise_ = 1 / d_.z;
        back_ = Vec2{v_.z * per_rise_ * d_.x - v_.x, v_.z * per_rise_ * d_.y - v_.y};
        back_square_ = dot(back_, back_);
        known_ = back_square_ > 1e-6 * dot(v_, v_);
    }
    [[nodiscard]] bool known() const { return known_; }

    [[nodiscard]] bool cut(Vec3 p, double& low, double& high) const {
        const double a = dot(p, aim_.e), lean = aim_.sine * piece_.r0;
        return end(p, a, std::clamp(a - lean, 0.0, aim_.way), -1, low) &&
               end(p, a, std::clamp(a + lean, 0.0, aim_.way), 1, high) && low < high;
    }

private:
    /// The least s (sign -1) or the largest; `way`: how far the disc has come.
    bool end(Vec3 p, double a, double way, double sign, double& s) const {
        const double half = piece_.r0 * piece_.r0 - (a - way) * (a - way);
        if (!(half > 0)) return false;
        s = (way * aim_.slope + sign * std::sqrt(half) - dot(p, flat_d_)) / flat_;
        const double z = p.z + s * d_.z - way / aim_.way * v_.z;
        if (z >= piece_.z0 && z <= piece_.z1) return true;
        // While the ray meets this end's plane it passes there at s0 + t v.z / d.z.
        const double s0 = ((z < piece_.z0 ? piece_.z0 : piece_.z1) - p.z) * per_rise_, s1 = v_.z * per_rise_;
        const Vec2 at{p.x + s0 * d_.x, p.y + s0 * d_.y};
        const double middle = -dot(at, back_) / back_square_;
        const Vec2 nearest = at + middle * back_;
        const double room = piece_.r0 * piece_.r0 - dot(nearest, nearest);
        if (!(room > 0)) return false;
        const double stay = std::sqrt(room / back_square_);
        const double from = std::max(0.0, middle - stay), to = std::min(1.0, middle + stay);
        if (!(from <= to)) return false;
        s = s0 + (sign * s1 > 0 ? to : from) * s1;
        return true;
    }

    const Piece& piece_;
    Vec3 v_, d_;
    const Aim& aim_;
    double flat_ = 0;
    Vec3 flat_d_;
    bool known_ = false;
    double per_rise_ = 0, back_square_ = 0;
    Vec2 back_;  ///< how the place where the ray meets a plane normal to the axis moves in time, seen by the tool
};

/// Ray by ray, for what has no formula for rows: only rays that come near the piece and are worth it.
void each_ray(const Piece& piece, const Track& track, const Row& row, const Aims& aims, Worth worth, Spans& spans) {
    Spans around;
    bound(piece, track, row, aims, around);
    detail::Ends ends;
    const SkewCylinder skew(piece, track, row, aims);
    const bool by_formula = is_cylinder(piece) && skew.known();
    for (int i = 0; i < row.count; ++i) {
        const auto at = static_cast<std::size_t>(i);
        double low = around.low[at], high = around.high[at];
        set(spans, i, 1, 0);
        if (!(low < high) || !worth(i, low, high)) continue;
        const Vec3 p = row.p + i * row.step;
        if (by_formula        ? skew.cut(p, low, high)
            : is_round(piece) ? detail::cut_round(piece, track.v, p, row.d, ends, low, high)
                              : detail::cut_quadric(piece, track.v, p, row.d, low, high))
            set(spans, i, low, high);
    }
}

/// False: nothing of the row is met.
bool cut_row_by(const Piece& piece, const Track& track, const Row& row, const Aims& aims, Worth worth, Spans& spans) {
    const Lie lie = aims.lie;
    if (lie == Lie::along && (track.circular || track.level() || track.upright())) {
        along_by_distance(piece, track, row, spans);
        return true;
    }
    if (lie == Lie::across) {
        const double low = row.p.z - std::max(0.0, track.v.z), high = row.p.z - std::min(0.0, track.v.z);
        // The half of a whole ball or disc that lies in the pieces beside it need not be looked at.
        if (high < piece.z0 || low > piece.z1) return false;
    }
    if (is_ball(piece)) {
        ball_row(piece.centre, piece.arc, row, aims, spans);
        return true;
    }
    if (is_cylinder(piece) && lie == Lie::across) return across_cylinder(piece, track, row, aims, spans);
    if (is_cylinder(piece) && lie == Lie::along)
        detail::ramp_cylinder_row(piece, track, row, spans);
    else
        each_ray(piece, track, row, aims, worth, spans);
    return true;
}

}  // namespace

bool cut_ray(const Piece& piece, Vec3 v, Vec3 p, Vec3 d, double& low, double& high) {
    // From the point of the ray that is nearest to the tool, so that no large numbers cancel.
    const double s = dot(p, d);
    const bool hit = is_round(piece) ? detail::cut_round(piece, v, p - s * d, d, low, high)
                                     : detail::cut_quadric(piece, v, p - s * d, d, low, high);
    low -= s;
    high -= s;
    return hit;
}

void cut_row(const Shape& shape, const Track& track, const Row& row, const Aims& aims, Worth worth,
             base::FunctionRef<void(const Spans&)> take) {
    Spans spans;
    if (aims.lie == Lie::across && (track.circular || track.level() || track.upright())) {
        const double rise = track.v.z;
        const double radius = widest_between(shape, row.p.z - std::max(0.0, rise), row.p.z - std::min(0.0, rise));
        if (!(radius > 0)) return;
        if (track.circular) {
            detail::cut_circle_across(track, row, radius, take);
            return;
        }
        detail::Capsule c = detail::capsule_of(aims.level, row, 0, 1, radius);
        c.n = c.n_step = 0;
        detail::capsule_row(c, row.count, spans);
        take(spans);
        return;
    }
    for (const Piece& piece : shape.pieces)
        if (cut_row_by(piece, track, row, aims, worth, spans)) take(spans);
}

void cut_row_from_above(const Shape& shape, const Track& track, const Row& row, const Aims& aims, Spans& spans) {
    const double high = shape.top + std::min(0.0, track.v.z);
    const bool ramp = !(track.circular || track.level() || track.upright());
    if (!track.circular && is_ball(shape.pieces.front()) && shape.pieces.size() <= 2) {
        detail::Capsule c = detail::capsule_of(aims.whole, row, 0, 1, shape.pieces.front().arc);
        c.low_shift += shape.pieces.front().centre;
        detail::capsule_low_row(c, row.count, high, spans);
        return;
    }
    const double down = std::min(0.0, track.v.z);
    if (ramp) {
        detail::ramp_low_row(shape, track, row, high, spans);
        return;
    }
    for (int i = 0; i < row.count; ++i) {
        const Vec3 q = row.p + i * row.step;
        const double low = lower_side(shape, offset_from(track, {q.x, q.y}).distance) + down;
        set(spans, i, std::min(low, high), high);
    }
}

}  // namespace obrys::sim::milling
