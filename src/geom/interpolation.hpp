#pragma once
/// What a controller whose axes move in steps of a basic length unit makes of a path element, and how far that is off.
///
/// Source: M. Hejsek, HEIDENHAIN iTNC 530 tools for NC programming of machines, thesis, Brno 2010, sections 2.1
/// and 2.2.4. The interpolator works out the way of each axis and sends pulses; a pulse moves one axis by one unit, one
/// axis at a time, so that anything not parallel to an axis becomes a staircase. The thesis gives no arithmetic, only
/// bounds: less than a unit for lines and splines, one to two units for (small) circles.
///
/// Here, exactly:
/// - The grid: whole multiples of the unit in x, y and z. A coordinate belongs to the grid value floor(c / unit + 1/2).
/// - The steps: the element's parameter u runs from 0 to 1. Whenever the exact coordinate of an axis passes the middle
///   between two grid values, that axis makes a step; where two axes pass at the same u (within 2e-6 units of way), x
///   goes before y before z.
///   The staircase begins at the start's grid point and ends at the end's.
/// - The deviation of a grid point that is visited: its distance from the nearest point of the element in the
///   neighbourhood of p(u), which is found by Newton's method from p(u) and is never farther than p(u). Largest and
///   mean are taken over all visited grid points, the first one too. Between two of them the way runs along an axis and
///   cannot lie farther from a straight element than its ends do.
/// - The bound: every coordinate is within half a unit of p(u), so no deviation exceeds sqrt(m)/2 units with m axes
/// that
///   move or stand beside the grid: 0.7072 units in a plane, 0.8661 in space (u is found to 1e-6 units). A circular
///   interpolator that adds up differences (DDA) can reach the thesis' one to two units; this one rounds positions, so
///   its error does not grow.

#include <array>
#include <cstdint>
#include <variant>

#include "base/function_ref.hpp"
#include "geom/cubic.hpp"

namespace obrys::geom {

struct Straight {
    Vec3 from, to;
};
/// Circle or helix: `from` turned about the line through `centre` along the unit vector `normal` by `sweep` radians,
/// counter-clockwise seen against `normal`. What is missing then to `to` (the rise of a helix, and the programmed
/// circle's error) is added in proportion to the parameter; without a sweep that is all.
struct Circular {
    Vec3 from, to, centre;
    Vec3 normal{0, 0, 1};
    double sweep = 0;
};
/// A Cubic runs from its point at 0 to that at 1.
using PathElement = std::variant<Straight, Circular, Cubic>;
[[nodiscard]] Vec3 point_at(const PathElement& e, double u);
[[nodiscard]] Vec3 derivative_at(const PathElement& e, double u);

/// A step of the staircase.
struct GridStep {
    int axis = 0;       ///< 0 x, 1 y, 2 z
    int direction = 0;  ///< +1 or -1 unit
    double u = 0;       ///< parameter at which it is made
    Vec3 at;            ///< grid point reached, mm
    Vec3 ideal;         ///< nearest point of the element
    double deviation = 0;
};

enum class StaircaseEnd : std::uint8_t {
    reached,
    not_known,  ///< the element is not finite, the unit not positive, a coordinate exceeds 2^50 units or a sweep 10^6
                ///< radians
    too_long,   ///< ended by `most_steps`; the figures are those of the part that was run
};
struct Staircase {
    StaircaseEnd end_reason = StaircaseEnd::not_known;
    Vec3 start, end;  ///< grid points, mm
    std::uint64_t steps = 0;
    std::array<std::uint64_t, 3> steps_of_axis{};
    double largest = 0, mean = 0;  ///< mm
    GridStep worst;  ///< where the largest deviation (but for 1e-6 units) first occurred; axis -1: at the start
};

/// Runs the element and hands on each step; keeps none.
Staircase staircase(const PathElement& e, double unit, base::FunctionRef<void(const GridStep&)> step,
                    std::uint64_t most_steps = 1'000'000'000);
[[nodiscard]] Staircase staircase(const PathElement& e, double unit);

}  // namespace obrys::geom
