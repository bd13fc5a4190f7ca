/// Arcs in any plane, and the axis of a tool that stands in any direction.

#include <array>
#include <cmath>
#include <utility>

#include "base/codes.hpp"
#include "base/whole.hpp"
#include "interp/moves/moves.hpp"

namespace obrys::interp {

namespace codes = base::codes;
using geom::Vec2;
using geom::Vec3;

namespace {

constexpr double near_upright = 1e-9;  ///< of a cosine: the arc lies in the working plane

/// The words of a vector; NaN where one is missing.
Vec3 vector_of(Moving& run, const std::array<Code, 3>& words) {
    Vec3 v{NAN, NAN, NAN};
    for (int k = 0; k < 3; ++k)
        if (run.block.has(words[static_cast<std::size_t>(k)]))
            coordinate(v, k) = run.block.get(words[static_cast<std::size_t>(k)]);
    return v;
}
constexpr std::array direction_words{Code::i1, Code::j1, Code::k1};
constexpr std::array centre_words_of_axis{Code::i, Code::j, Code::k};

/// Two directions square to `normal` and to each other, in this order right-handed.
std::pair<Vec3, Vec3> plane_of(const Vec3& normal) {
    const Vec3 helper = std::abs(normal.x) < 0.5 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
    const Vec3 across = geom::cross(normal, helper);
    const Vec3 u = (1 / geom::length(across)) * across;
    return {u, geom::cross(normal, u)};
}

/// The normal as G17, G18 and G19 have theirs: the largest of its parts is positive.
void face_upwards(cl::Arc& arc) {
    const Vec3& n = arc.normal;
    const double largest = std::abs(n.z) >= std::abs(n.x) && std::abs(n.z) >= std::abs(n.y) ? n.z
                           : std::abs(n.y) >= std::abs(n.x)                                 ? n.y
                                                                                            : n.x;
    if (largest >= 0) return;
    arc.normal = -1 * arc.normal;
    arc.sweep = -arc.sweep;
}

bool straight_instead(Moving& run, const Vec3& to, const char* why) {
    unchecked(run, codes::unknown_value, run.here(), std::string(why) + ": it is run as a straight move",
              "move to a known place in all three axes before");
    straight_motion(run, to, false);
    return true;
}

}  // namespace

void run_arc_in_space(Moving& run, const cl::Arc& arc) {
    const PlaneAxes a = plane_axes(run.modal.plane);
    Vec3 normal;
    coordinate(normal, a.w) = 1;
    const double tilt = geom::dot(arc.normal, normal);
    if (std::abs(std::abs(tilt) - 1) < near_upright) {
        path::Element e;
        e.from = in_plane(run.programmed_position, a);
        e.to = in_plane(arc.to, a);
        e.centre = in_plane(arc.centre, a);
        e.w_from = coordinate(run.programmed_position, a.w);
        e.w_to = coordinate(arc.to, a.w);
        e.sweep = tilt > 0 ? arc.sweep : -arc.sweep;
        return plane_element(run, std::move(e), arc.to, false);
    }
    flush_path(run);
    if (run.modal.compensation != Modal::compensation_off)
        unchecked(run, codes::unsupported, run.here(),
                  "radius compensation of an arc that is not in the working plane is not run");
    lead_to_place(run);
    run.programmed_position = arc.to;
    run.position = geom::apply(run.frame, arc.to);
    const Vec3 n = geom::apply_direction(run.frame, arc.normal);
    const double size = geom::length(n);
    emit(run, cl::Arc{run.position, geom::apply(run.frame, arc.centre),
                      (geom::determinant(run.frame) < 0 ? -1 / size : 1 / size) * n, arc.sweep, false, run.tool_axis});
}

bool arc_about_axis(Moving& run, const Vec3& to) {
    const Vec3 from = run.programmed_position;
    const Vec3 centre = length_unit(run.modal) * vector_of(run, centre_words_of_axis);
    const Vec3 axis = vector_of(run, direction_words);
    if (!geom::is_finite(from) || !geom::is_finite(to))
        return straight_instead(run, to, "the arc starts or ends at a position that is not known");
    if (!geom::is_finite(centre) || !(geom::length(axis) > 0))
        return straight_instead(run, to, "centre or axis of this arc is not known");
    const Vec3 n = (1 / geom::length(axis)) * axis;
    const auto plane = plane_of(n);
    const Vec3 u = plane.first, v = plane.second;
    const auto flat = [&](const Vec3& p) { return Vec2{geom::dot(p - centre, u), geom::dot(p - centre, v)}; };
    const int turns = run.block.has(Code::turns) ? base::clipped<int>(run.block.get(Code::turns), 0, 999) : 0;
    const path::ArcResult arc =
        path::arc_by_centre(flat(from), flat(to), {}, path::Sense::counter_clockwise, turns, arc_tolerance(run));
    if (!arc.ok()) {
        arc_alarm(run, arc);
        return false;
    }
    const Vec3 level = geom::dot(from - centre, n) * n;
    cl::Arc out{to, centre + level + arc.centre.x * u + arc.centre.y * v, n, arc.sweep, false};
    face_upwards(out);
    run_arc_in_space(run, out);
    return true;
}

void aim_tool(Moving& run) {
    const Vec3 axis = vector_of(run, direction_words);
    if (!(geom::length(axis) > 0))
        return alarm(run, codes::value_range, run.here(), "the axis of the tool has no direction");
    flush_path(run);
    const Vec3 n = geom::apply_direction(run.frame, axis);
    run.tool_axis = (1 / geom::length(n)) * n;
}

}  // namespace obrys::interp
