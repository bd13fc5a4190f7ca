#pragma once
/// What radius compensation is told with each element, and what it may find wrong.

#include <cstddef>
#include <cstdint>

#include "geom/vec.hpp"

namespace obrys::path {

enum class Side : std::uint8_t { off, left, right };
/// NORM, KONT; ready: the element is already the centre's path, line or arc, and ends (begins) normal to the contour's
/// first (last) point, as those of smooth_approach.hpp.
enum class Approach : std::uint8_t { normal, around, ready };
enum class OuterCorner : std::uint8_t { arc, intersection };  ///< G450, G451

/// How the corner at the end of this one element is made, whatever is in force (HEIDENHAIN, "Machining small contour
/// steps: M97", "Machining open contour corners: M98"; M90 changes the feed alone and is none of it).
enum class CornerEnd : std::uint8_t {
    usual,
    crossing,  ///< M97: an outer corner is closed by the crossing of the parallels, however far away; so the next
               ///< element may be shorter than the tool. Inner corners as usual.
    open,  ///< M98: an inner corner is run out to both normals and linked straight: both elements are cut to their end
};

/// What becomes of contour elements farther on than the next one. Zone of an element: all points nearer to it than the
/// tool's radius.
enum class Clearance : std::uint8_t {
    neighbours,  ///< not looked at, but for Compensation's look-ahead at inner corners (SINUMERIK without CDON)
    reported,    ///< the path is made from neighbours alone; where it enters another zone that is an `interference`
    avoided,  ///< HEIDENHAIN M120 LA: where the centre comes into a later zone it goes on along that element; what lies
              ///< between is left out and reported as `bridged`
};

/// How the path is made.
enum class Method : std::uint8_t {
    crossing,   ///< corners from the parallels of the elements beside them, with a look-ahead
    held_move,  ///< the last move alone is held back: an inner corner moves its end, and what the tool cannot reach
                ///< ends the program (held_move.hpp)
};

/// Tolerances of Method::held_move.
struct HeldMoveLimits {
    double straight_on = 0.05;     ///< rad: a smaller change of direction is no corner
    double sweep_growth = 0.0254;  ///< rad: by so much moving its end may prolong an arc
    double radius_change = 0.01;   ///< mm: by so much moving its end may change an arc's radius
    double flat_entry = 1e-4;      ///< cosine below which the chord of an entry arc stands across its end's radius
    bool operator==(const HeldMoveLimits&) const = default;
};

/// What is in force in an element's block.
struct Setting {
    Side side = Side::off;
    double radius = 0;  ///< mm; negative: the other side
    Approach approach = Approach::normal;
    OuterCorner corner = OuterCorner::arc;
    double corner_limit = geom::radians(100);  ///< largest change of direction closed by an intersection
    /// From the compensated centre to the point that the stream moves (turning: nose_offset); taken at the approach and
    /// kept until the retract. Programmed points are contour points; output is the moved point.
    geom::Vec2 tip{};
    CornerEnd at_end = CornerEnd::usual;
    Clearance clearance = Clearance::neighbours;
    std::size_t window = 0;  ///< contour elements looked at ahead (M120: LA, 99 at most) and behind; 1000 at most
    Method method = Method::crossing;
    HeldMoveLimits limits{};  ///< of Method::held_move
    bool rapid = false;       ///< the element is run in rapid: Method::held_move makes no arc before it
    bool operator==(const Setting&) const = default;
};

enum class Reason : std::uint8_t {
    tool_radius_too_large,    ///< an arc is tighter than the tool; it is left out
    arc_needs_line_at_start,  ///< compensation switched on, off or changed by an arc; it must be a line
    no_intersection,          ///< parallels of an inner corner do not meet; a straight link is put in
    element_vanishes,         ///< the inner corners at both ends leave nothing of it
    interference,             ///< the path cuts into `other`, not a neighbour, within `window`; `at`: on the path
    refused,                  ///< Method::held_move: the program ends here; Fault::refusal says why
};

/// Why Method::held_move ends the program; message() in refusal.hpp has the control's words.
enum class Refusal : std::uint8_t {
    none,
    entry_line_short,  ///< the first compensated line is not longer than the tool radius
    entry_arc_short,   ///< nor is the chord of the first compensated arc
    arc_too_tight,     ///< the tool is not smaller than the arc that it runs in
    feed_reversed,     ///< nothing is left of a line between its corners
    rapid_reversed,    ///< the same, run in rapid
    arc_unreachable,   ///< line and arc do not meet, or nothing is left of an arc
    arc_line_unreachable,
    arc_arc_unreachable,
    same_centre,    ///< an inner corner between arcs about one centre
    radii_differ,   ///< the moved end is not on its arc
    arc_after_off,  ///< the move that follows the compensation's end must be straight
    already_on,     ///< another side or radius without switching off
};

struct Fault {
    Reason reason = Reason::no_intersection;
    std::uint64_t tag = 0;    ///< the element at fault
    std::uint64_t other = 0;  ///< its partner at the corner
    geom::Vec2 at;            ///< programmed corner, mm
    bool bridged = false;     ///< the element was left out and the path is sound: what remains is uncut material
    Refusal refusal = Refusal::none;
    double radius_was = 0, radius_is = 0;  ///< of Refusal::radii_differ, mm
    bool operator==(const Fault&) const = default;
};

}  // namespace obrys::path
