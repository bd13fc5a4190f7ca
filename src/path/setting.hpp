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
    bool operator==(const Setting&) const = default;
};

enum class Reason : std::uint8_t {
    tool_radius_too_large,    ///< an arc is tighter than the tool; it is left out
    arc_needs_line_at_start,  ///< compensation switched on, off or changed by an arc; it must be a line
    no_intersection,          ///< parallels of an inner corner do not meet; a straight link is put in
    element_vanishes,         ///< the inner corners at both ends leave nothing of it
    interference,             ///< the path cuts into `other`, not a neighbour, within `window`; `at`: on the path
};
struct Fault {
    Reason reason = Reason::no_intersection;
    std::uint64_t tag = 0;    ///< the element at fault
    std::uint64_t other = 0;  ///< its partner at the corner
    geom::Vec2 at;            ///< programmed corner, mm
    bool bridged = false;     ///< the element was left out and the path is sound: what remains is uncut material
    bool operator==(const Fault&) const = default;
};

}  // namespace obrys::path
