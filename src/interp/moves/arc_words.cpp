/// An arc of the working plane from the words of its block.

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "base/codes.hpp"
#include "base/number.hpp"
#include "base/whole.hpp"
#include "interp/moves/moves.hpp"
#include "path/arc_input.hpp"
#include "program/modal_group.hpp"

namespace obrys::interp {

namespace codes = base::codes;
using geom::Vec2;

namespace {

constexpr Code centre_words[3] = {Code::i, Code::j, Code::k};

bool is_finite(Vec2 p) { return std::isfinite(p.x) && std::isfinite(p.y); }

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

}  // namespace

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

}  // namespace

path::ArcResult usual_arc(const Moving& run, Vec2 from, Vec2 to, const PlaneAxes& a) {
    constexpr std::uint64_t others = bit(Code::i1) | bit(Code::j1) | bit(Code::k1) | bit(Code::radius) |
                                     bit(Code::opening_angle) | bit(Code::turns) | bit(Code::p) |
                                     bit(Code::pole_angle) | bit(Code::centre_at_pole) | polar_words;
    path::ArcResult none;
    none.failure = path::ArcFailure::no_radius;
    const BlockWords& b = run.block;
    const Modal m = run.modal.motion;
    const std::uint64_t centre = bit(centre_words[a.u]) | bit(centre_words[a.v]), across = bit(centre_words[a.w]);
    if ((m != Modal::arc_cw && m != Modal::arc_ccw) || (b.present & (others | across)) != 0) return none;
    if ((b.present & centre) == 0 || !is_finite(from) || !is_finite(to)) return none;
    for (const int k : {a.u, a.v})
        if (b.has(centre_words[k]) && std::isnan(b.peek(centre_words[k]))) return none;
    const path::Sense sense = m == Modal::arc_cw ? path::Sense::clockwise : path::Sense::counter_clockwise;
    return path::arc_by_centre(from, to, centre_of(run, a), sense, 0, arc_tolerance(run));
}

path::ArcResult planar_arc(Moving& run, Vec2 from, Vec2 to, bool end_given, const PlaneAxes& a, double rise) {
    const BlockWords& b = run.block;
    const path::Sense sense =
        run.modal.motion == Modal::arc_cw ? path::Sense::clockwise : path::Sense::counter_clockwise;
    if (run.modal.motion == Modal::arc_tangent && !b.has(Code::centre_at_pole))
        return path::arc_by_tangent(from, to, run.last_direction.get());
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

}  // namespace obrys::interp
