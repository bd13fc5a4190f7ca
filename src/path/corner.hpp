#pragma once
/// Chamfers and roundings between two consecutive contour elements: exact, in the plane.
/// SINUMERIK (Programming Manual Fundamentals, "Chamfer, rounding"): CHF= length of the chamfer, CHR= its leg in the
/// original direction of motion, RND= radius of the tangent arc. The chamfer is symmetrical to the bisector; where an
/// arc is involved its ends are equally far (straight) from the corner.

#include <cstdint>

#include "path/element.hpp"

namespace obrys::path {

enum class CornerFailure : std::uint8_t {
    none,
    bad_size,    ///< not a positive number
    not_joined,  ///< the elements have no common point
    tangential,  ///< there is no corner: nothing to insert, keep the elements
    reversal,    ///< the second element runs back along the first
    wrong_way,   ///< the second element runs the other way than the sign of the size says
    too_short,   ///< an element is too short for it
};

/// The shortened elements with the new one between; the inputs unchanged where `failure` is set.
/// The new element has the first one's tag, no events, and lies at the w of the corner.
struct CornerResult {
    CornerFailure failure = CornerFailure::none;
    Element first, inserted, second;
    [[nodiscard]] bool ok() const { return failure == CornerFailure::none; }
};

/// Chamfer of the given length (CHF).
[[nodiscard]] CornerResult chamfer(const Element& a, const Element& b, double length);
/// Chamfer whose ends are `leg` from the corner (CHR).
[[nodiscard]] CornerResult chamfer_by_leg(const Element& a, const Element& b, double leg);
/// Tangent arc of the given radius (RND).
[[nodiscard]] CornerResult rounding(const Element& a, const Element& b, double radius);

enum class CornerKind : std::uint8_t { none, chamfer, chamfer_leg, rounding };
[[nodiscard]] CornerResult insert_corner(const Element& a, const Element& b, CornerKind kind, double size);
/// The largest size up to `size` that fits, found to 1e-9 mm; 0 where none does. Newer controls reduce to it instead of
/// raising an alarm.
[[nodiscard]] double largest_corner(const Element& a, const Element& b, CornerKind kind, double size);

}  // namespace obrys::path
