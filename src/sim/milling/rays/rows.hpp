#pragma once
/// What a sweep takes from a row of rays.

#include <array>
#include <limits>

#include "base/function_ref.hpp"
#include "geom/vec.hpp"
#include "sim/milling/shape.hpp"
#include "sim/milling/track.hpp"

namespace obrys::sim::milling {

/// Rays at equal distances, in the tool's frame at its start. Ray i: p + i * step + s * d; d has unit length, p and
/// step are normal to it; the step is never zero, not even for a single ray.
struct Row {
    static constexpr int most = 16;
    geom::Vec3 p, step, d;
    int count = 0;
};
/// Of each ray the part [low, high] of s; nothing where not low < high.
struct Spans {
    std::array<double, Row::most> low{}, high{};
};

/// How rays lie to the tool's axis.
enum class Lie : std::uint8_t {
    along,   ///< parallel to it, either way
    across,  ///< normal to it; a row must then be of one height
    skew,
};

/// A translation as rays of one direction see it: `e` lies along its part normal to the rays, which is `way` long.
struct Aim {
    geom::Vec3 e, beside;        ///< unit vectors, normal to each other and to the rays
    double way = 0;              ///< 0 where the translation runs along the rays but for rounding
    double along = 0;            ///< its part along the rays
    double slope = 0, sine = 0;  ///< way along the rays per `way`, and per length of the translation
};
[[nodiscard]] Aim aim_of(geom::Vec3 v, geom::Vec3 d);

/// A straight or circular track as rays of direction d see it.
struct Aims {
    Lie lie = Lie::along;
    Aim whole, level;        ///< of the translation, and of its part normal to the tool's axis
    Aim flat;                ///< of the latter, by rays projected along the axis
    geom::Vec3 flat_d;       ///< their direction, unit length
    double flat_length = 0;  ///< of a unit of the rays when projected; flat and flat_d stand only where this is not 0
};
[[nodiscard]] Aims aims_of(const Track& track, geom::Vec3 d, Lie lie);

/// Whether there is anything to cut on ray i of the row in [low, high].
using Worth = base::FunctionRef<bool(int i, double low, double high)>;

/// Calls `take` for one part of the swept solid after another; together they are what is removed from the row's rays,
/// but for rays that `worth` says are empty, which may be left out. Parts may touch or overlap. `aims` are those of the
/// track and of the row's direction. `Lie::skew` and circular tracks do not go together.
void cut_row(const Shape& shape, const Track& track, const Row& row, const Aims& aims, Worth worth,
             base::FunctionRef<void(const Spans&)> take);

/// For rays upwards along the axis and a shape that rises: the lower side alone; `high` is the top of the shape where
/// it is lowest on its way. Right for stock that ends below that.
void cut_row_from_above(const Shape& shape, const Track& track, const Row& row, const Aims& aims, Spans& spans);

/// One ray p + s * d (p need not be normal to d) against one convex piece that moves by v. Any directions.
[[nodiscard]] bool cut_ray(const Piece& piece, geom::Vec3 v, geom::Vec3 p, geom::Vec3 d, double& low, double& high);

namespace detail {

/// A circle of radius^2 `square` - n^2 that moves in the plane of a ray: a is the distance of the ray from the circle's
/// start along the part of the translation that is normal to the ray, n the distance beside it.
struct Capsule {
    double a = 0, a_step = 0, n = 0, n_step = 0;
    double square = 0;
    double from = 0, to = 0;     ///< the part of the way that counts, along a
    double slope = 0, sine = 0;  ///< way along the ray per way along a, and per way
    double low_shift = 0, high_shift = 0;
};
void capsule_row(const Capsule& c, int count, Spans& spans);
/// A number that grows from ray to ray.
struct Steps {
    double at = 0, step = 0;
};
/// Spans counted from `foot` and multiplied by `scale`, which is positive.
void stretch_row(const Steps& foot, double scale, int count, Spans& spans);
/// What of spans lies between `one` and `other`.
void clip_row(const Steps& one, const Steps& other, int count, Spans& spans);
void capsule_low_row(const Capsule& c, int count, double high, Spans& spans);
/// Rays along the axis, on a ramp: a cylinder; the lower side of a shape that rises, or `high` where that is lower.
void ramp_cylinder_row(const Piece& piece, const Track& track, const Row& row, Spans& spans);
void ramp_low_row(const Shape& shape, const Track& track, const Row& row, double high, Spans& spans);
/// The rays whose span, moved by `base`, is neither empty nor inside their gap; returns how many. Gaps may be read up
/// to the next multiple of four.
int candidates(const Spans& spans, double base, const double* gap_low, const double* gap_high, int count,
               std::array<int, Row::most>& rays);
/// The circle's way from t0 to t1 of the track.
[[nodiscard]] Capsule capsule_of(const Aim& aim, const Row& row, double t0, double t1, double radius);

[[nodiscard]] bool cut_quadric(const Piece& piece, geom::Vec3 v, geom::Vec3 p, geom::Vec3 d, double& low, double& high);
/// Where on a ray and when it meets a moving piece.
struct Spot {
    double s = 0, t = 0;
};
/// Of the last two rays of a row, the last one first: a guess for the next one. Behind, s is counted backwards.
struct Ends {
    std::array<Spot, 2> before, behind;
    int known = 0;
};
/// Between `low` and `high`, which it narrows down.
[[nodiscard]] bool cut_round(const Piece& piece, geom::Vec3 v, geom::Vec3 p, geom::Vec3 d, Ends& ends, double& low,
                             double& high);
[[nodiscard]] bool cut_round(const Piece& piece, geom::Vec3 v, geom::Vec3 p, geom::Vec3 d, double& low, double& high);
/// Circular track, rays across, a disc of this radius.
void cut_circle_across(const Track& track, const Row& row, double radius, base::FunctionRef<void(const Spans&)> take);

}  // namespace detail

}  // namespace obrys::sim::milling
