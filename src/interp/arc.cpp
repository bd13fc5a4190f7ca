/// Arcs: from the words of the block to centre and sweep. Out into the stream: plane_element.cpp.

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "base/codes.hpp"
#include "base/number.hpp"
#include "base/whole.hpp"
#include "cl/verify.hpp"
#include "interp/path_stage.hpp"
#include "path/arc_input.hpp"
#include "program/modal_group.hpp"

namespace obrys::interp {

namespace codes = base::codes;
using geom::Vec2;
using geom::Vec3;

path::ArcTolerance arc_tolerance(const Reckoning& run) {
    const program::Traits& t = *run.traits;
    const double own = run.modal.inch_geometry ? t.arc_tolerance_inch : t.arc_tolerance;
    return {own > 0 ? own : run.env.machine.defaults.circle_tolerance, 0.001, own > 0};
}

namespace {

constexpr Code centre_words[3] = {Code::i, Code::j, Code::k};
constexpr Code via_words[3] = {Code::i1, Code::j1, Code::k1};

/// Centre in the plane: incremental from the start (a radius in a lathe's X), or I=AC(…) in workpiece coordinates.
Vec2 centre_of(const Moving& run, const PlaneAxes& a) {
    const BlockWords& b = run.block;
    const double unit = length_unit(run.modal);
    const auto along = [&](int k) {
        const Code code = centre_words[k];
        const double start = coordinate(run.programmed_position, k);
        if (!b.has(code)) return start;
        const bool absolute =
            run.modal.centre_absolute || b.ref(code) == 1 + static_cast<std::uint8_t>(program::Reference::absolute);
        return absolute ? b.get(code) * length_factor(run, k, false) : start + b.get(code) * unit;
    };
    return {along(a.u), along(a.v)};
}

/// A centre along the axis across the plane in force: it was meant for another plane.
bool says_centre_across(Moving& run) {
    const int across = plane_axes(run.modal.plane).w;
    if (!run.block.has(centre_words[across]) || run.block.peek(centre_words[across]) == 0) return false;
    constexpr std::array letters{"I", "J", "K"};
    constexpr std::array planes{"G19 (YZ)", "G18 (ZX)", "G17 (XY)"};
    const auto k = static_cast<std::size_t>(across);
    alarm(run, codes::arc_radius, run.here(),
          std::string(letters[k]) + " is no centre in the plane in force, " + planes[k] +
              ": this arc lies in another plane",
          "program the arc's plane before it: G17, G18 or G19");
    return true;
}

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

constexpr int most_turns = 1000;  ///< of an angle about the pole; HEIDENHAIN takes up to 99999.9999 degrees

/// C and CP: about the pole, to a point or through an angle.
path::ArcResult about_pole(const Moving& run, Vec2 from, Vec2 to, path::Sense sense, const PlaneAxes& a) {
    const BlockWords& b = run.block;
    b.use(Code::centre_at_pole);
    const Vec2 centre = in_plane(run.modal.pole, a);
    if (!b.has(Code::pole_angle)) return path::arc_by_centre(from, to, centre, sense, 0, arc_tolerance(run));
    const double turns = std::abs(b.get(Code::pole_angle)) / 360;
    const double whole = std::max(0.0, std::ceil(turns) - 1);
    return path::arc_about_centre(from, centre, geom::radians((turns - whole) * 360), sense,
                                  base::clipped<int>(whole, 0, most_turns));
}

/// Full turns beyond the arc to its end: TURN=, or P - 1 where the control counts the arc itself
/// (Traits::arc_turns_in_p).
std::optional<int> turns_of(Moving& run) {
    const BlockWords& b = run.block;
    if (b.has(Code::turns)) {
        if (const auto n = base::whole<int>(b.get(Code::turns), 0, 999)) return n;
        alarm(run, codes::value_range, run.here(),
              "TURN, the number of full turns of a helix, must be a whole number from 0 to 999");
        return std::nullopt;
    }
    if (!run.traits->arc_turns_in_p || !b.has(Code::p)) return 0;
    const double p = b.get(Code::p);
    if (const auto n = base::whole<int>(p, 1, 1000)) return *n - 1;
    alarm(run, codes::value_range, run.here(),
          "P, the number of turns of an arc, must be a whole number from 1 to 1000");
    return std::nullopt;
}

/// "If I, J, K, and R addresses are specified simultaneously, the arc specified by address R takes precedence and the
/// other are ignored" (FANUC operator's manual, circular interpolation) [-].
void pass_over_centre(Moving& run) {
    for (const Code c : centre_words)
        if (run.block.has(c)) run.block.use(c);
    assume(run, run.here(), "an arc with R and a centre is run by its R: the control passes over I, J and K",
           "write one of them");
}

/// What is missing may be the word of another motion.
std::string remedy_of_circle(const Moving& run) {
    const bool written = (run.block.groups >> static_cast<unsigned>(program::ModalGroup::motion) & 1u) != 0;
    return written ? "" : "the circle is in force from a block before: write G0 or G1 for a straight line";
}

/// Full turns of a helix beyond the arc to its end, from how far it rises in one (Traits::helix_lead_across); nothing
/// where the arc does not come out at its end.
std::optional<int> turns_by_lead(Moving& run, const path::ArcResult& arc, double rise, const PlaneAxes& a) {
    const Code code = centre_words[a.w];
    if (!run.traits->helix_lead_across || !run.block.has(code) || !arc.ok()) return 0;
    constexpr double slack = 0.01;  // turns: leads are rounded to the word's resolution
    const double lead = std::abs(run.block.get(code) * length_unit(run.modal));
    const double turns = std::abs(rise) / lead - std::abs(arc.sweep) / geom::full_turn;
    if (std::isnan(turns)) return 0;
    const auto whole = base::whole<int>(std::round(turns), 0, most_turns);
    if (lead > 0 && whole && std::abs(turns - *whole) <= slack) return whole;
    alarm(run, codes::arc_radius, run.here(),
          "the lead of this helix, " + base::fixed(lead, 4) + " mm, does not lead to its end, " +
              base::fixed(std::abs(rise), 4) + " mm along the axis");
    return std::nullopt;
}

/// About the centre of I, J, K.
path::ArcResult arc_about_words(Moving& run, Vec2 from, Vec2 to, path::Sense sense, int turns, const PlaneAxes& a,
                                double rise) {
    const Vec2 centre = centre_of(run, a);
    const path::ArcResult arc = path::arc_by_centre(from, to, centre, sense, turns, arc_tolerance(run));
    const auto more = turns_by_lead(run, arc, rise, a);
    if (!more) return {};
    return *more == 0 ? arc : path::arc_by_centre(from, to, centre, sense, *more, arc_tolerance(run));
}

path::ArcResult planar_arc(Moving& run, Vec2 from, Vec2 to, bool end_given, const PlaneAxes& a, double rise) {
    const BlockWords& b = run.block;
    const path::Sense sense =
        run.modal.motion == Modal::arc_cw ? path::Sense::clockwise : path::Sense::counter_clockwise;
    if (run.modal.motion == Modal::arc_tangent && !b.has(Code::centre_at_pole))
        return path::arc_by_tangent(from, to, run.last_direction);
    const auto given = turns_of(run);
    if (!given) return {};
    const int turns = *given;
    const bool centre = b.has(centre_words[a.u]) || b.has(centre_words[a.v]);
    if (b.has(Code::pole_angle) && std::abs(b.get(Code::pole_angle)) > most_turns * 360.0) {
        alarm(run, codes::value_range, run.here(),
              "the angle of this arc is larger than " + std::to_string(most_turns) + " turns");
        return {};
    }
    if (b.has(Code::centre_at_pole) && b.has(Code::pole_angle) && b.get(Code::pole_angle) != 0 &&
        (b.get(Code::pole_angle) < 0) != (sense == path::Sense::clockwise))
        // iTNC 530 manual, circular path CP: DR and an incremental PA want one sign.
        unchecked(run, codes::unsupported, run.here(),
                  "the angle of this arc has another sign than its sense of rotation: it is run in that sense",
                  "write the same sign for both");
    if (b.has(Code::centre_at_pole)) return about_pole(run, from, to, sense, a);
    if (b.has(Code::radius) && centre && run.traits->radius_before_centre) pass_over_centre(run);
    if (b.has(Code::radius))
        return path::arc_by_radius(from, to, b.get(Code::radius) * length_unit(run.modal), sense, turns,
                                   arc_tolerance(run));
    if (b.has(Code::opening_angle)) {
        const double angle = geom::radians(b.get(Code::opening_angle));
        return end_given ? path::arc_by_angle(from, to, angle, sense, turns)
                         : path::arc_about_centre(from, centre_of(run, a), angle, sense, turns);
    }
    if (!centre && (b.has(Code::polar_angle) || b.has(Code::polar_radius)))
        return path::arc_by_centre(from, to, in_plane(run.modal.pole, a), sense, turns, arc_tolerance(run));
    if (centre) return arc_about_words(run, from, to, sense, turns, a, rise);
    path::ArcResult none;
    none.failure = path::ArcFailure::points_coincide;
    alarm(run, codes::arc_radius, run.here(),
          "a circle needs its centre (I, J, K), its radius (CR=) or its opening angle (AR=)", remedy_of_circle(run));
    return none;
}

bool has_unknown_circle_word(const Moving& run) {
    for (const Code c : {Code::i, Code::j, Code::k, Code::i1, Code::j1, Code::k1, Code::radius, Code::opening_angle,
                         Code::turns, Code::pole_angle})
        if (run.block.has(c) && std::isnan(run.block.peek(c))) return true;
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
    const double gap = std::abs(geom::distance(from, arc.centre) - geom::distance(arc.to, arc.centre));
    if (t.keep_centre || gap <= cl::circle_tolerance) return false;
    unchecked(run, codes::arc_radius, run.here(),
              "the end point lies " + base::fixed(gap, 3) +
                  " mm beside the circle through the start point, and no centre near the programmed one fits: how the "
                  "control runs this arc is not known, it is run as a straight move",
              "correct the end point or the centre");
    return true;
}

}  // namespace

bool arc_motion(Moving& run, const Vec3& target) {
    if (runs_straight(run)) return straight_motion(run, target, false), true;
    if (!geom::is_finite(run.programmed_position) || !geom::is_finite(target)) {
        const PlaneAxes a = plane_axes(run.modal.plane);
        const Vec2 from = in_plane(run.programmed_position, a), to = in_plane(target, a);
        if (!std::isfinite(from.x) || !std::isfinite(from.y) || !std::isfinite(to.x) || !std::isfinite(to.y)) {
            unchecked(run, codes::unknown_value, run.here(),
                      "the arc starts at a position that is not known: it is run as a straight move",
                      "position both axes of the plane before the arc");
            straight_motion(run, target, false);
            return true;
        }
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
    const PlaneAxes a = plane_axes(run.modal.plane);
    const bool end_given = run.block.has(axis_code(a.u)) || run.block.has(axis_code(a.v)) ||
                           run.block.has(Code::polar_angle) || run.block.has(Code::polar_radius);
    if (end_given && run.block.has(Code::pole_angle)) {
        alarm(run, codes::repeated_word, run.here(),
              "the arc gives its end twice: by an angle about the pole and by a point", "write one of them");
        return false;
    }
    const path::ArcResult arc = planar_arc(run, in_plane(run.programmed_position, a), in_plane(target, a), end_given, a,
                                           coordinate(target, a.w) - coordinate(run.programmed_position, a.w));
    if (run.stopped) return false;
    path::Element e;
    e.from = in_plane(run.programmed_position, a);
    e.w_from = coordinate(run.programmed_position, a.w);
    e.w_to = coordinate(target, a.w);
    Vec3 to = target;
    if (run.modal.motion == Modal::arc_tangent && arc.failure == path::ArcFailure::collinear) {
        e.to = in_plane(target, a);  // straight ahead: the tangential arc is a line
    } else if (!arc.ok()) {
        if (stays(run, arc)) return straight_motion(run, target, false), true;
        arc_alarm(run, arc);
        return false;
    } else if (no_centre_fits(run, arc, e.from, arc_tolerance(run))) {
        return straight_motion(run, target, false), true;
    } else {
        e.to = arc.to;
        e.centre = arc.centre;
        e.sweep = arc.sweep;
        coordinate(to, a.u) = arc.to.x;
        coordinate(to, a.v) = arc.to.y;
    }
    plane_element(run, std::move(e), to, false);
    return true;
}

}  // namespace obrys::interp
