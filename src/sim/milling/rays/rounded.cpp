// A torus' outer half (with the disc it surrounds) on a straight way against a ray in any direction. F(s, t), how far
// the ray's point s lies outside the piece at the moment t, is convex; the ray enters the swept piece at the least s
// with F = 0. There the moment is the nearest one: F_t = 0, or t is 0 or 1 and F grows from there on. For a convex F
// this is not only necessary: a place that fulfils it is the end. So Newton's method may look for it from any guess, as
// that of the ray before, and what it finds needs no further proof. Where it finds nothing (rays that graze, pieces cut
// off by planes) two nested searches that cannot fail take its place.

#include <algorithm>
#include <cmath>

#include "sim/milling/nearest.hpp"
#include "sim/milling/rays/rows.hpp"

namespace obrys::sim::milling::detail {
namespace {

using geom::Vec3;

constexpr double newton_slack = 1e-12;  ///< mm
constexpr double grazing = 1e-3;        ///< a ray's slope to the surface below which Newton's method is left
constexpr int newton_steps = 24;        ///< of Newton's method; four are usual

/// The distance from a whole piece and its derivatives along the ray and in time.
struct Slopes {
    double f = 0, s = 0, t = 0, st = 0, tt = 0;
};

/// q: the point, from the piece's centre.
Slopes slopes_at(const Piece& piece, Vec3 q, Vec3 d, Vec3 v) {
    Slopes r;
    const double square = q.x * q.x + q.y * q.y;
    if (square <= piece.ring * piece.ring) {  // above or below the disc
        const double side = q.z < 0 ? -1 : 1;
        r.f = side * q.z - piece.arc;
        r.s = side * d.z;
        r.t = -side * v.z;
        return r;
    }
    const double distance = std::sqrt(square), beyond = distance - piece.ring;
    const double far = std::sqrt(beyond * beyond + q.z * q.z), per_distance = 1 / distance, per_far = 1 / far;
    const double ox = q.x * per_distance, oy = q.y * per_distance, no = beyond * per_far, nz = q.z * per_far;
    const double d_out = d.x * ox + d.y * oy, d_round = d.y * ox - d.x * oy;
    const double v_out = v.x * ox + v.y * oy, v_round = v.y * ox - v.x * oy;
    // Curved by 1 / far in the half plane through the axis, and by no / distance around it.
    const double d_up = no * d.z - nz * d_out, v_up = no * v.z - nz * v_out, around = no * per_distance;
    r.f = far - piece.arc;
    r.s = no * d_out + nz * d.z;
    r.t = -(no * v_out + nz * v.z);
    r.st = -(v_up * d_up * per_far + v_round * d_round * around);
    r.tt = v_up * v_up * per_far + v_round * v_round * around;
    return r;
}

enum class Met : std::uint8_t { yes, no, unsure };

/// A line below what is left of F when the nearest moment is taken, through a point outside.
struct Below {
    double s = 0, value = 0, slope = 0;
};
Below below(const Slopes& f, double s, double t) { return {s, f.f + std::min(-t * f.t, (1 - t) * f.t), f.s}; }
/// F is nowhere 0: lines that fall and rise meet above 0, or one rises from above 0 where the search begins.
bool above_zero(const Below& falls, const Below& rises, double start) {
    if (!(rises.value > 0)) return false;
    if (rises.value + rises.slope * (start - rises.s) > newton_slack) return true;
    if (!(falls.value > 0)) return false;
    const double meet =
        (rises.value - falls.value + falls.slope * falls.s - rises.slope * rises.s) / (falls.slope - rises.slope);
    return falls.value + falls.slope * (meet - falls.s) > newton_slack;
}

/// Where a ray across the axis enters the piece where that stands at the move's beginning or end; else `s` as it is.
double at_rest(const Piece& piece, Vec3 v, Vec3 p, Vec3 d, Spot spot) {
    if (d.z != 0 || (spot.t != 0 && spot.t != 1)) return spot.s;
    const Vec3 q = p - spot.t * v;
    const double beside = d.x * q.y - d.y * q.x, widest = piece.ring + std::sqrt(piece.arc * piece.arc - q.z * q.z);
    const double s = -(q.x * d.x + q.y * d.y) - std::sqrt(widest * widest - beside * beside);
    return std::isfinite(s) ? s : spot.s;
}

/// Newton's method for the least s, from a guess; the ray is outside up to `start`. p from the piece's centre.
Met enter(const Piece& piece, Vec3 v, Vec3 p, Vec3 d, double start, Spot& spot) {
    auto& [s, t] = spot;
    const double way = std::sqrt(dot(v, v));
    Below falls, rises;
    for (int i = 0; i < newton_steps; ++i) {
        s = at_rest(piece, v, p, d, spot);
        const Slopes f = slopes_at(piece, p + s * d - t * v, d, v);
        if (f.f > 0) {
            (f.s < 0 ? falls : rises) = below(f, s, t);
            if (above_zero(falls, rises, start)) return Met::no;
        }
        double next = f.t > 0 ? 0 : f.t < 0 ? 1 : t;
        if (const double det = f.s * f.tt - f.t * f.st; f.tt > 0 && det < 0)
            next = std::clamp(t + (f.f * f.st - f.s * f.t) / det, 0.0, 1.0);
        const double step = f.s < -grazing ? -(f.f + f.t * (next - t)) / f.s : 0.5 * (start - s);
        // No direction is curved more than 1 / arc: so far off, in F, is the place the step leads to.
        const double moved = std::abs(step) + std::abs(next - t) * way;
        s = std::max(start, s + step);
        t = next;
        if (f.s < -grazing && moved * moved <= newton_slack * piece.arc * -f.s) return Met::yes;
    }
    return Met::unsure;
}

/// A straight line through the ends of the last two rays, or what is known without them.
Spot guess(const std::array<Spot, 2>& spots, int known, Spot unknown) {
    if (known == 0) return unknown;
    if (known == 1) return spots[0];
    return {2 * spots[0].s - spots[1].s, std::clamp(2 * spots[0].t - spots[1].t, 0.0, 1.0)};
}
void keep(std::array<Spot, 2>& spots, Spot spot) {
    spots[1] = spots[0];
    spots[0] = spot;
}

/// From s outside, in the direction `sign`, to the surface: Newton's method from outside never passes the root of a
/// convex function of s, and a search finds the nearest moment for each.
bool approach(const Piece& piece, Vec3 v, Vec3 p, Vec3 d, double sign, double& s) {
    for (int i = 0; i < 200; ++i) {
        const Foot foot = foot_on(piece, v, p + s * d);
        if (foot.outside <= newton_slack) return true;
        const double slope = dot(foot.gradient, d);
        if (sign * slope >= -1e-9) return foot.outside <= 1e-9;
        s -= foot.outside / slope;
    }
    return true;
}

}  // namespace

bool cut_round(const Piece& piece, Vec3 v, Vec3 p, Vec3 d, Ends& ends, double& low, double& high) {
    const double first = low, last = high;
    if (piece.whole) {
        const Vec3 q = p - Vec3{0, 0, piece.centre}, back = -1.0 * d;
        const double vd = dot(v, d);
        // Moves are short as a rule: a ray ends where the move does, on the side it comes from.
        Spot one = guess(ends.before, ends.known, {first, vd > 0 ? 0.0 : 1.0});
        Spot other = guess(ends.behind, ends.known, {-last, vd > 0 ? 1.0 : 0.0});
        const Met in = enter(piece, v, q, d, first, one);
        const Met out = in == Met::yes ? enter(piece, v, q, back, -last, other) : in;
        if (out == Met::yes) {
            keep(ends.before, one);
            keep(ends.behind, other);
            ++ends.known;
            low = one.s;
            high = -other.s;
            return low < high;
        }
        ends.known = 0;
        if (out == Met::no) return false;
    }
    return approach(piece, v, p, d, 1, low) && approach(piece, v, p, d, -1, high) && low < high;
}

bool cut_round(const Piece& piece, Vec3 v, Vec3 p, Vec3 d, double& low, double& high) {
    const double bottom = piece.whole ? piece.centre - piece.arc : piece.z0;
    const double top = piece.whole ? piece.centre + piece.arc : piece.z1;
    const double reach = std::hypot(piece.ring + piece.arc, (top - bottom) / 2) + length(v) / 2 + newton_slack;
    const Vec3 middle = Vec3{0, 0, (bottom + top) / 2} + 0.5 * v;
    const double s = dot(middle - p, d);
    const Vec3 beside = p + s * d - middle;
    const double square = reach * reach - dot(beside, beside);
    if (!(square > 0)) return false;
    low = s - std::sqrt(square);
    high = s + std::sqrt(square);
    Ends ends;
    return cut_round(piece, v, p, d, ends, low, high);
}

}  // namespace obrys::sim::milling::detail
