#pragma once
/// B-spline curves with weights (NURBS), and how they become the cubics that the stream can hold.
///
/// A curve of order k (degree k - 1) with n points p_i, weights w_i > 0 and n + k knots that do not descend is
/// C(u) = sum w_i N_i(u) p_i / sum w_i N_i(u) for u from knot k - 1 to knot n (L. Piegl, W. Tiller, "The NURBS Book",
/// chapters 2 to 5). Units: mm; the parameter has none.
///
/// RS-274 as LinuxCNC 2.9 runs it (behaviour of its interpreter and of the path it makes of `NURBS_FEED`):
/// G5 X Y I J P Q is the cubic with the points start, start + (I,J), end + (P,Q), end; G5.1 X Y I J the parabola with
/// the points start, start + (I,J), end; G5.2 … G5.3 a curve of order L (3 where L is less or missing) with the
/// control points X Y of the weights P, the first one being the start. Its knots are `clamped_knots`: k times 0, then
/// 1, 2, …, k times n - k + 1. LinuxCNC runs all three as two arcs between each two of 4 n + 1 points at equal steps of
/// u, which lies near the curve (its preview takes 15 n points of the curve itself); here the curve is kept.

#include <optional>
#include <vector>

#include "geom/cubic.hpp"

namespace obrys::geom {

/// The cubic with these Bezier points, from t = 0 to 1.
[[nodiscard]] Cubic bezier(Vec3 a, Vec3 b, Vec3 c, Vec3 d);
/// The parabola with these Bezier points, as a cubic: the same curve with the same parameter.
[[nodiscard]] Cubic bezier(Vec3 a, Vec3 b, Vec3 c);

struct NurbsPoint {
    Vec3 p;
    double weight = 1;
    bool operator==(const NurbsPoint&) const = default;
};
struct Nurbs {
    int order = 4;
    std::vector<NurbsPoint> points;
    std::vector<double> knots;
};

/// Knots 0 … 0 1 2 … m … m with `order` equal ones at each end: the curve begins at its first point and ends at its
/// last. Empty for fewer points than the order or an order below 2.
[[nodiscard]] std::vector<double> clamped_knots(std::size_t points, int order);

constexpr int largest_order = 24;

/// What a curve needs: order 2 … `largest_order`, as many points at least, points + order knots, none descending, no
/// more than `order` equal ones (`order` - 1 inside), a range that is not empty; weights above 0; everything finite.
[[nodiscard]] bool is_valid(const Nurbs& curve);

/// Point at a parameter by de Boor's algorithm; a parameter outside the range counts as its end. The curve is valid.
[[nodiscard]] Vec3 point_at(const Nurbs& curve, double u);

/// A curve as cubics, each from t = 0 to 1, in order; one ends where the next begins.
struct NurbsPieces {
    struct Piece {
        Cubic curve;
        double from = 0, to = 0;  ///< range of the curve's parameter that it stands for, run evenly
    };
    std::vector<Piece> pieces;
    /// No point of a piece lies farther than this from the point of the curve at the same parameter, mm (an upper
    /// bound, rounding aside). 0: the pieces are the curve. NaN: not known, the numbers are too large to compute with.
    double deviation = 0;
};

/// The curve cut at its knots, by knot insertion (W. Boehm, 1980). Pieces of order 2 to 4 with equal weights are the
/// curve itself. Others are cut in halves until the cubic with the same ends and the same derivatives there stays
/// within `tolerance` mm, so the tangent is continuous where the curve's is; but into no more than `most` pieces, and
/// none shorter than 2^-20 of a knot interval: `deviation` then says what was reached. Nothing for a curve that is not
/// valid or a tolerance that is not above 0.
[[nodiscard]] std::optional<NurbsPieces> cubic_pieces(const Nurbs& curve, double tolerance, std::size_t most = 100'000);

}  // namespace obrys::geom
