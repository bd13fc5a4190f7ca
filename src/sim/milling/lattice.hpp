#pragma once
/// The lattice of rays a stock is cut in: where its nodes lie, how fine it must be, what it costs.
/// Frame of the stock, millimetres.

#include <array>
#include <cstddef>
#include <optional>

#include "geom/vec.hpp"

namespace obrys::sim::milling {

struct Box3 {
    geom::Vec3 min, max;
};

/// Nodes of a regular lattice; rays run along lattice lines. The outermost nodes lie about half a step outside the
/// stock's box, so that no face of the box meets a node and the surface can be closed.
struct Lattice {
    geom::Vec3 origin;           ///< node (0, 0, 0)
    geom::Vec3 step{1, 1, 1};    ///< per axis
    std::array<int, 3> count{};  ///< nodes per axis
    [[nodiscard]] geom::Vec3 node(int i, int j, int k) const {
        return {origin.x + i * step.x, origin.y + j * step.y, origin.z + k * step.z};
    }
};

/// The two other axes in their own order: along x (0) these are y and z, along y x and z, along z x and y.
[[nodiscard]] constexpr int first_across(int axis) { return axis == 0 ? 1 : 0; }
[[nodiscard]] constexpr int second_across(int axis) { return axis == 2 ? 1 : 2; }
[[nodiscard]] constexpr double component(geom::Vec3 v, int axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }
constexpr void set_component(geom::Vec3& v, int axis, double value) {
    (axis == 0 ? v.x : axis == 1 ? v.y : v.z) = value;
}

/// The lattice over a box with steps of at most `step`, about size / ceil(size / step) per axis, whose nodes lie 0.5 nm
/// beside every coordinate of six decimals in mm or five in inches: plane faces so given lie on no ray. Nothing where
/// the box is not finite or not positive, the step not positive, or an axis would have over 2^20 nodes.
[[nodiscard]] std::optional<Lattice> make_lattice(const Box3& box, double step);

/// How wide a lattice may be for vertices and triangle centres of a dual-contoured surface to lie within `tolerance` of
/// a surface whose smallest radius of curvature is `smallest_radius`, mm: a chord as long as a cell's diagonal, h sqrt
/// 3, has the sagitta 3 h^2 / 8 r; three quarters of the tolerance are given to it, which makes h = sqrt(2 r
/// tolerance). Radii so small that a sharp edge in their place stays within the tolerance, r (sqrt 2 - 1) <= tolerance,
/// do not count: the caller leaves them out (`matters`). 0 where an argument is not positive.
[[nodiscard]] double step_for(double tolerance, double smallest_radius);
[[nodiscard]] bool matters(double radius, double tolerance);

/// Memory of a stock in this lattice, bytes, before and after ordinary machining; an estimate: `pieces` material
/// intervals on each ray.
[[nodiscard]] double bytes_for(const Lattice& lattice, double pieces = 2);
/// The smallest tolerance whose lattice over the box fits into `bytes`, for a surface of that smallest radius.
[[nodiscard]] double tolerance_that_fits(const Box3& box, double smallest_radius, double bytes);

/// What a tolerance asks for, and whether it is to be had.
struct Resolution {
    double step = 0;                 ///< mm, at most, per axis
    double bytes = 0;                ///< what the rays will need; NaN where there is no lattice of this step at all
    std::optional<Lattice> lattice;  ///< nothing: refused
    double fits = 0;                 ///< where refused: the smallest tolerance that would not be, mm; NaN: none would
};
[[nodiscard]] Resolution resolve(const Box3& box, double tolerance, double smallest_radius, double most_bytes);

}  // namespace obrys::sim::milling
