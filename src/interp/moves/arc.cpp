/// Arcs: from the words of the block to centre and sweep. Out into the stream: plane_element.cpp.

#include <cmath>

#include "base/codes.hpp"
#include "base/number.hpp"
#include "cl/verify.hpp"
#include "interp/moves/moves.hpp"
#include "interp/stream/path_stage.hpp"
#include "path/arc_input.hpp"

namespace obrys::interp {

namespace codes = base::codes;
using geom::Vec2;
using geom::Vec3;

namespace {

constexpr Code via_words[3] = {Code::i1, Code::j1, Code::k1};

}  // namespace

void arc_alarm(Moving& run, const path::ArcResult& r) {
    const bool by_centre = r.failure == path::ArcFailure::radius_mismatch || r.failure == path::ArcFailure::no_radius;
    if (by_centre && says_centre_across(run)) return;
    std::string text;
    switch (r.failure) {
        case path::ArcFailure::radius_mismatch:
            text = "the end point lies " + base::fixed(std::abs(r.radius_difference), 3) + " mm " +
                   (r.radius_difference > 0 ? "outside" : "inside") +
                   " the circle through the start point about this centre";
            break;
        case path::ArcFailure::no_radius: text = "the centre lies on the start point"; break;
        case path::ArcFailure::radius_too_small:
            text = "the radius is smaller than half the distance from start to end";
            break;
        case path::ArcFailure::points_coincide:
            text = "start and end are the same point: the arc is not determined";
            break;
        case path::ArcFailure::collinear: text = "the three points lie on a straight line"; break;
        case path::ArcFailure::bad_angle: text = "the opening angle must lie between 0 and 360 degrees"; break;
        case path::ArcFailure::no_direction: text = "a tangential arc needs a move before it"; break;
        case path::ArcFailure::none: return;
    }
    alarm(run, codes::arc_radius, run.here(), std::move(text));
}

namespace {

bool has_unknown_circle_word(const Moving& run) {
    constexpr std::uint64_t words = bit(Code::i) | bit(Code::j) | bit(Code::k) | bit(Code::i1) | bit(Code::j1) |
                                    bit(Code::k1) | bit(Code::radius) | bit(Code::opening_angle) | bit(Code::turns) |
                                    bit(Code::pole_angle);
    for (std::uint64_t left = run.block.present & words; left != 0; left &= left - 1)
        if (std::isnan(run.block.peek(static_cast<Code>(std::countr_zero(left))))) return true;
    return run.traits->arc_turns_in_p && run.block.has(Code::p) && std::isnan(run.block.peek(Code::p));
}

bool tilted_arc(Moving& run, const Vec3& to) {
    Vec3 via = run.programmed_position;
    for (int k = 0; k < 3; ++k) {
        if (!run.block.has(via_words[k])) continue;
        const std::uint8_t ref = run.block.ref(via_words[k]);
        const bool incremental =
            ref == 0 ? !run.modal.absolute : ref == 1 + static_cast<std::uint8_t>(program::Reference::incremental);
        const double v = run.block.get(via_words[k]) * length_factor(run, k, incremental);
        coordinate(via, k) = incremental ? coordinate(via, k) + v : v;
    }
    if (!geom::is_finite(run.programmed_position) || !geom::is_finite(via) || !geom::is_finite(to)) {
        unchecked(run, codes::unknown_value, run.here(),
                  "a point of this circle in space is not known: it is run as a straight move",
                  "move to a known place in all three axes before");
        straight_motion(run, to, false);
        return true;
    }
    const PlaneAxes a = plane_axes(run.modal.plane);
    Vec3 normal;
    coordinate(normal, a.w) = 1;
    const path::ArcInSpace arc = path::arc_through(run.programmed_position, via, to, normal);
    if (!arc.ok()) {
        path::ArcResult r;
        r.failure = arc.failure;
        arc_alarm(run, r);
        return false;
    }
    run_arc_in_space(run, {to, arc.centre, arc.normal, arc.sweep});
    return true;
}

/// Traits::line_without_centre.
bool runs_straight(Moving& run) {
    const std::string_view setting = run.traits->line_without_centre;
    if (setting.empty() || (run.modal.motion != Modal::arc_cw && run.modal.motion != Modal::arc_ccw)) return false;
    for (const Code c : {Code::i, Code::j, Code::k, Code::radius, Code::opening_angle, Code::polar_angle,
                         Code::polar_radius, Code::centre_at_pole})
        if (run.block.has(c)) return false;
    if (run.path->active() != (run.modal.compensation != Modal::compensation_off)) {
        // B-63684EN, cutter compensation C: start-up and cancel want G0 or G1.
        alarm(run, codes::compensation, run.here(),
              "radius compensation begins or ends while a circle is in force" +
                  of_alarm(run.traits->alarms.circle_compensates),
              "write a straight move in this block");
        return true;
    }
    assume(run, run.here(),
           "coordinates without I, J, K and R while G2 or G3 is in force are run straight, as with " +
               std::string(setting),
           "write G1, or the arc's radius or centre");
    return true;
}

/// Traits::radius_to_start_stays: only a coordinate along the tool's axis is left of it.
bool stays(Moving& run, const path::ArcResult& arc) {
    if (!run.traits->radius_to_start_stays || arc.failure != path::ArcFailure::points_coincide ||
        !run.block.has(Code::radius))
        return false;
    assume(run, run.here(), "an arc with R to the point where it starts is no move on this control",
           "write the centre (I, J, K) of a full circle");
    return true;
}

/// A control that moves the centre takes an end beside the circle within a part of its radius. Where the end lies
/// nearly in line with centre and start no centre fits, and what path it runs is not known.
bool no_centre_fits(Saying& run, const path::ArcResult& arc, Vec2 from, const path::ArcTolerance& t) {
    if (t.keep_centre) return false;
    const double gap = std::abs(geom::distance(from, arc.centre) - geom::distance(arc.to, arc.centre));
    if (gap <= cl::circle_tolerance) return false;
    unchecked(run, codes::arc_radius, run.here(),
              "the end point lies " + base::fixed(gap, 3) +
                  " mm beside the circle through the start point, and no centre near the programmed one fits: how the "
                  "control runs this arc is not known, it is run as a straight move",
              "correct the end point or the centre");
    return true;
}

/// Runs an arc whose words have been resolved.
void run_planar(Moving& run, const Vec3& target, const PlaneAxes& a, const path::ArcResult& arc) {
    const Vec2 from = in_plane(run.programmed_position, a);
    if (no_centre_fits(run, arc, from, arc_tolerance(run))) return straight_motion(run, target, false);
    Vec3 to = target;
    coordinate(to, a.u) = arc.to.x;
    coordinate(to, a.v) = arc.to.y;
    const double w_from = coordinate(run.programmed_position, a.w), w_to = coordinate(target, a.w);
    plane_element(run, {from, arc.to, w_from, w_to, arc.centre, arc.sweep, 0, {}}, to, false);
}

}  // namespace

bool arc_motion(Moving& run, const Vec3& target) {
    const PlaneAxes a = plane_axes(run.modal.plane);
    const Vec2 start = in_plane(run.programmed_position, a), end = in_plane(target, a);
    if (const path::ArcResult arc = usual_arc(run, start, end, a); arc.ok())
        return run_planar(run, target, a, arc), true;
    if (runs_straight(run)) return straight_motion(run, target, false), true;
    const bool known = std::isfinite(start.x) && std::isfinite(start.y) && std::isfinite(end.x) && std::isfinite(end.y);
    if (!known) {
        unchecked(run, codes::unknown_value, run.here(),
                  "the arc starts at a position that is not known: it is run as a straight move",
                  "position both axes of the plane before the arc");
        straight_motion(run, target, false);
        return true;
    }
    if (has_unknown_circle_word(run)) {
        unchecked(run, codes::unknown_value, run.here(),
                  "the arc depends on a value that is not known: it is run as a straight move");
        straight_motion(run, target, false);
        return true;
    }
    if (run.block.has(Code::centre_at_pole) && !has_pole(run)) return false;
    if (run.modal.motion == Modal::linear) {
        alarm(run, codes::arc_radius, run.here(),
              "the sense of rotation DR is missing: no arc before this one has any");
        return false;
    }
    if (run.modal.motion == Modal::arc_via) return tilted_arc(run, target);
    if (run.modal.motion == Modal::arc_about) return arc_about_axis(run, target);
    const bool end_given = run.block.has(axis_code(a.u)) || run.block.has(axis_code(a.v)) ||
                           run.block.has(Code::polar_angle) || run.block.has(Code::polar_radius);
    if (end_given && run.block.has(Code::pole_angle)) {
        alarm(run, codes::repeated_word, run.here(),
              "the arc gives its end twice: by an angle about the pole and by a point", "write one of them");
        return false;
    }
    const path::ArcResult arc =
        planar_arc(run, start, end, end_given, a, coordinate(target, a.w) - coordinate(run.programmed_position, a.w));
    if (run.stopped) return false;
    if (run.modal.motion == Modal::arc_tangent && arc.failure == path::ArcFailure::collinear) {
        // Straight ahead: the tangential arc is a line.
        const double w_from = coordinate(run.programmed_position, a.w), w_to = coordinate(target, a.w);
        plane_element(run, {start, end, w_from, w_to, {}, 0, 0, {}}, target, false);
        return true;
    }
    if (arc.ok()) return run_planar(run, target, a, arc), true;
    if (stays(run, arc)) return straight_motion(run, target, false), true;
    arc_alarm(run, arc);
    return false;
}

}  // namespace obrys::interp
