/// ANG=: a straight line given by its angle to the first axis of the plane, alone or as the first of two whose corner
/// the control computes (SINUMERIK Fundamentals 10.2004, contour definition programming: one and two straight lines).

#include <cmath>

#include "base/codes.hpp"
#include "interp/capture.hpp"
#include "interp/moves/moves.hpp"

namespace obrys::interp {

namespace codes = base::codes;
using geom::Vec2;
using geom::Vec3;

namespace {

Vec2 along(double degrees) { return {std::cos(geom::radians(degrees)), std::sin(geom::radians(degrees))}; }

bool not_determined(Saying& run, bool both) {
    unchecked(run, codes::unsupported, run.here(),
              "ANG= with " + std::string(both ? "both" : "none") + " of the plane's axes is not run here",
              both ? "leave out one of the coordinates, or write the line before it with ANG= alone"
                   : "the next block needs ANG= and the end point of its line in both axes, absolute");
    return false;
}

/// The second of two lines: it must lie at its angle, which the corner of the first one has seen to.
bool lies_at_angle(Reckoning& run, const Vec3& to, const PlaneAxes& axes, double angle) {
    if (run.look == Look::next_element) return true;
    const Vec2 step = in_plane(to, axes) - in_plane(run.programmed_position, axes), d = along(angle);
    const double off = std::abs(geom::cross(d, step));
    if (geom::dot(d, step) > 0 && off < 1e-6 + 1e-6 * geom::length(step)) return true;
    return not_determined(run, true);
}

/// The first of two lines: its end is where it meets the second one.
bool to_corner(Moving& run, Vec3& to, const PlaneAxes& axes, double angle) {
    const Vec2 from = in_plane(run.programmed_position, axes), d1 = along(angle);
    if (run.look == Look::next_element) {  // looked at as the next line of another one: it has a direction and no end
        coordinate(to, axes.u) = from.x + d1.x;
        coordinate(to, axes.v) = from.y + d1.y;
        return true;
    }
    const auto next = run.onward->next_element(run.programmed_position);
    if (!next || !next->line_angle || path::is_arc(next->element)) return not_determined(run, false);
    const Vec2 d2 = along(*next->line_angle), way = next->element.to - from;
    const double turn = geom::cross(d1, d2);
    const double first = geom::cross(way, d2) / turn, second = geom::cross(d1, way) / turn;
    if (std::isnan(turn + geom::length(way))) return not_determined(run, false);
    if (std::abs(turn) < 1e-9 || !(first > 0) || !(second > 0)) {
        alarm(run, codes::value_range, run.here(),
              "the line at this angle ANG does not meet the line of the next block between here and its end point");
        return false;
    }
    coordinate(to, axes.u) = from.x + first * d1.x;
    coordinate(to, axes.v) = from.y + first * d1.y;
    return true;
}

}  // namespace

bool line_by_angle(Moving& run, Vec3& to) {
    const BlockWords& b = run.block;
    const PlaneAxes axes = plane_axes(run.modal.plane);
    const bool has_u = b.has(axis_code(axes.u)), has_v = b.has(axis_code(axes.v));
    const double degrees = b.get(Code::line_angle);
    if (has_u && has_v) return lies_at_angle(run, to, axes, degrees);
    if (!has_u && !has_v) return to_corner(run, to, axes, degrees);
    const int given = has_u ? axes.u : axes.v, other = has_u ? axes.v : axes.u;
    const Vec2 d = along(degrees);
    const double forward = has_u ? d.x : d.y, across = has_u ? d.y : d.x;
    const double step = coordinate(to, given) - coordinate(run.programmed_position, given);
    if (std::abs(forward) < 1e-12) {
        alarm(run, codes::value_range, run.here(), "a line at this angle ANG never reaches the given coordinate");
        return false;
    }
    coordinate(to, other) = coordinate(run.programmed_position, other) + step * across / forward;
    return true;
}

std::optional<double> angle_of_whole_line(const Moving& run) {
    const BlockWords& b = run.block;
    const PlaneAxes axes = plane_axes(run.modal.plane);
    const Code u = axis_code(axes.u), v = axis_code(axes.v);
    if (!b.has(Code::line_angle) || !b.has(u) || !b.has(v)) return std::nullopt;
    if (is_incremental(run, b.ref(u)) || is_incremental(run, b.ref(v))) return std::nullopt;
    return b.get(Code::line_angle);
}

}  // namespace obrys::interp
