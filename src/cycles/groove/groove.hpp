#pragma once
/// A groove of any place of a lathe, in the plane (u, v) of docs/make.md: x of a Vec2 is u, along the surface; y is v,
/// out of the material; mm, angles in radians. What is asked for, what makes it impossible, and the contours it leads
/// to.

#include <array>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

#include "geom/vec.hpp"

namespace obrys::cycles::groove {

using geom::Vec2;

inline constexpr double nothing = 1e-9;  ///< mm; less is none

enum class Side : std::uint8_t { left, right };
[[nodiscard]] constexpr Side other(Side s) { return s == Side::left ? Side::right : Side::left; }
[[nodiscard]] constexpr std::size_t index(Side s) { return s == Side::left ? 0 : 1; }
/// u of the material's side: -1 where the flank lies at smaller u.
[[nodiscard]] constexpr double outward(Side s) { return s == Side::left ? -1 : 1; }

/// What stands in the place of a corner.
struct Corner {
    enum class Form : std::uint8_t {
        radius,
        leg,   ///< chamfer by the length on each side (CHR)
        base,  ///< chamfer by its own length (CHF)
    };
    double size = 0;  ///< 0: the corner stays sharp
    Form form = Form::radius;
};

/// The finished groove. `p` is the right edge before its corner element, on a surface that rises with `slope`.
struct Shape {
    Vec2 p;
    double slope = 0;
    double depth = 0;                          ///< below p, along v
    double width = 0;                          ///< of the bottom
    std::array<double, 2> flank{};             ///< angles from v, by Side; 0 is a straight wall
    std::array<Corner, 2> outer{}, inner{};    ///< by Side
    double leave_bottom = 0, leave_flank = 0;  ///< allowances, normal to each
};

struct Insert {
    double width = 0;
    double corner_radius = 0;
    double reach = std::numeric_limits<double>::infinity();  ///< usable overhang
};

/// How it is cut.
struct Manner {
    double infeed = 0;
    double stepover = 0;
    double clearance = 1;  ///< between rapid and feed
    double peck = 0;       ///< of long plunges; 0: in one cut
    double retract = 1;    ///< for breaking the chip, between pecks
    double rib = 0.7;      ///< widest rib, as a part of the insert's width
    double layer = 0;      ///< of plunge turning; 0: the infeed, at most `widest_layer`
    double lift = 0.1;     ///< back between plunging and turning
    double ramp_angle = geom::radians(5);
    double dwell = 0;  ///< at the bottom, s
};

/// As parts of the insert's width. Sources: ZCC-CT catalogue 2019 p. 460 (layer), Sandvik grooving guide p. 32.
inline constexpr double thickest_layer = 0.75, thickest_ramp = 0.5;

struct Request {
    Shape shape;
    Insert insert;
    Manner manner;
};

enum class Guard : std::uint8_t {
    insert_wider,    ///< than the flat bottom that roughing leaves
    no_groove_left,  ///< allowances or corner elements need all of a side, or the surface lies below the bottom
    infeed,          ///< none
    insert_corner,   ///< as wide as the insert
    overhang,        ///< too short
    holder,          ///< leaning flanks or the curved blade of a face groove
    stepover,        ///< none, or wider than the insert
    rib,             ///< not narrower than the insert
    layer,           ///< thicker than the insert's side can cut
    ramp,            ///< no room for one
};
[[nodiscard]] std::string_view name_of(Guard guard);

/// Equal steps of at most `step` that make up `length`.
[[nodiscard]] int steps_of(double length, double step);
/// More cuts than this are refused: nobody means them.
inline constexpr double most_cuts = 100'000;

/// Why there is no path: nothing is ever made in spite of it.
struct Refusal {
    Guard guard = Guard::infeed;
    std::string text, remedy;
};

}  // namespace obrys::cycles::groove
