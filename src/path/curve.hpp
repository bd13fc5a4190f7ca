#pragma once
/// Parallels of contour elements and where they cross: what corner rounding and radius compensation share.
/// A place on a curve is its distance from the curve's start: millimetres on a line, radians on an arc.

#include <optional>

#include "path/element.hpp"

namespace obrys::path {

/// Parallel of an element. On an arc `radius_from`, `radius_to` are signed: negative where the parallel would lie
/// beyond the centre, i.e. the arc is too tight for the distance.
struct Curve {
    geom::Vec2 from, to;
    geom::Vec2 centre;
    double sweep = 0;
    double radius_from = 0, radius_to = 0;
};

/// The parallel at `d0` at the start and `d1` at the end, positive to the left of the motion.
/// The distances may differ on a line only (it becomes inclined); on an arc d1 counts.
[[nodiscard]] Curve parallel(const Element& e, double d0, double d1);
/// Millimetres or radians from start to end.
[[nodiscard]] double extent(const Curve& c);
/// Millimetres per unit of place.
[[nodiscard]] double scale(const Curve& c);
/// False for an arc whose parallel is turned inside out.
[[nodiscard]] bool exists(const Curve& c);

/// A common point of two consecutive curves and its place on each.
struct Crossing {
    geom::Vec2 point;
    double on_a = 0, on_b = 0;
};
/// The crossing nearest to the corner between a and b, within a from place `a_begin` on and within b.
[[nodiscard]] std::optional<Crossing> crossing_within(const Curve& a, double a_begin, const Curve& b);
/// The nearest crossing of a prolonged past its end with b prolonged before its start; arcs are prolonged as circles,
/// by a quarter turn at most.
[[nodiscard]] std::optional<Crossing> crossing_beyond(const Curve& a, const Curve& b);

/// Where a, from place `a_begin` on, first goes across b to the side away from the tool (`side` +1: the tool is left of
/// the motion), that is comes nearer to b's element than b is. Touching within same_point does not count. Of an arc of
/// more than a turn only the last turn (b: the first) is looked at.
[[nodiscard]] std::optional<Crossing> first_entry(const Curve& a, double a_begin, const Curve& b, double side);
[[nodiscard]] geom::Vec2 point_on(const Curve& c, double place);

/// True where the lines or circles that carry the two curves have a point in common.
[[nodiscard]] bool carriers_meet(const Curve& a, const Curve& b);

}  // namespace obrys::path
