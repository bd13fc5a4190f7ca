// A torus' outer half (with the disc it surrounds) on a straight way against a ray in any direction: two nested
// searches over convex functions. Outside: where along the ray is the distance from the swept piece 0 (Newton's method
// from outside never passes the root of a convex function). Inside: when on its way is the piece nearest to a point.

#include <algorithm>
#include <cmath>

#include "sim/milling/nearest.hpp"
#include "sim/milling/rows.hpp"

namespace obrys::sim::milling::detail {
namespace {

using geom::Vec3;

constexpr double exact = 1e-12;  ///< mm

/// From s outside, in the direction `sign`, to the surface.
bool approach(const Piece& piece, Vec3 v, Vec3 p, Vec3 d, double sign, double& s) {
    for (int i = 0; i < 200; ++i) {
        const Foot foot = foot_on(piece, v, p + s * d);
        if (foot.outside <= exact) return true;
        const double slope = dot(foot.gradient, d);
        if (sign * slope >= -1e-9) return foot.outside <= 1e-9;
        s -= foot.outside / slope;
    }
    return true;
}

}  // namespace

bool cut_round(const Piece& piece, Vec3 v, Vec3 p, Vec3 d, double& low, double& high) {
    const double bottom = piece.whole ? piece.centre - piece.arc : piece.z0;
    const double top = piece.whole ? piece.centre + piece.arc : piece.z1;
    const double widest = piece.ring + piece.arc,
                 reach = std::hypot(widest, (top - bottom) / 2) + length(v) / 2 + exact;
    const Vec3 middle = Vec3{0, 0, (bottom + top) / 2} + 0.5 * v;
    const double s = dot(middle - p, d);
    const Vec3 beside = p + s * d - middle;
    const double square = reach * reach - dot(beside, beside);
    if (!(square > 0)) return false;
    low = s - std::sqrt(square);
    high = s + std::sqrt(square);
    return approach(piece, v, p, d, 1, low) && approach(piece, v, p, d, -1, high) && low < high;
}

}  // namespace obrys::sim::milling::detail
