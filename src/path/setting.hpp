#pragma once
/// What radius compensation is told with each element, and what it may find wrong.

#include <cstdint>

#include "geom/vec.hpp"

namespace obrys::path {

enum class Side : std::uint8_t { off, left, right };
enum class Approach : std::uint8_t { normal, around };        ///< NORM, KONT
enum class OuterCorner : std::uint8_t { arc, intersection };  ///< G450, G451

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
    bool operator==(const Setting&) const = default;
};

enum class Reason : std::uint8_t {
    tool_radius_too_large,    ///< an arc is tighter than the tool; it is left out
    arc_needs_line_at_start,  ///< compensation switched on, off or changed by an arc; it must be a line
    no_intersection,          ///< parallels of an inner corner do not meet; a straight link is put in
    element_vanishes,         ///< the inner corners at both ends leave nothing of it
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
