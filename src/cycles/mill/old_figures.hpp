#pragma once
/// The older forms of pockets, slots and studs: HEIDENHAIN's CYCL DEF 4, 5, 210 … 215. Lengths in mm, feeds in mm/min.
/// What the members do beyond their comments: pocket.cpp, slot.cpp, stud.cpp.

#include "cycles/heights.hpp"

namespace obrys::cycles {

/// What 4 and 5 say: the tool stands above the centre at the clearance, to which it returns.
struct OldPocket {
    static constexpr bool anywhere = false;
    double clearance = unknown;  ///< older programs write it with the depth's sign
    double depth = unknown;      ///< from the surface, negative
    double infeed = unknown;     ///< older programs write it with the depth's sign
    double feed_plunge = unknown;
    double feed_mill = unknown;
    Said direction;  ///< +1 DR+, -1 DR-
};

/// rectangular-pocket-simple (4)
struct OldRectangularPocket : OldPocket {
    static constexpr Kind kind = Kind::rectangular_pocket_simple;
    Said axis_x;  ///< sides, named by the axes of the working plane
    Said axis_y;
    Said axis_z;
    Said corner_radius;
};

/// circular-pocket-simple (5)
struct OldCircularPocket : OldPocket {
    static constexpr Kind kind = Kind::circular_pocket_simple;
    double radius = unknown;
};

/// What 210 and 211 say.
struct ReciprocatingMilling : BelowSurface {
    static constexpr bool anywhere = true;  ///< where it says its centre
    double centre_u = unknown;
    double centre_v = unknown;
    double width = unknown;
    double feed_mill = unknown;
    Said feed_plunge;  ///< 0 and not said: as milling
    double infeed = unknown;
    Said finish_infeed;  ///< 0 and not said: in one
    Said operation;      ///< 0 roughing and finishing, 1 roughing, 2 finishing
};

/// slot-reciprocating (210)
struct ReciprocatingSlot : ReciprocatingMilling {
    static constexpr Kind kind = Kind::slot_reciprocating;
    double length = unknown;
    Said rotation;  ///< degrees
};

/// round-slot-reciprocating (211)
struct ReciprocatingRoundSlot : ReciprocatingMilling {
    static constexpr Kind kind = Kind::round_slot_reciprocating;
    double pitch_circle = unknown;  ///< diameter
    double angle_length = unknown;  ///< degrees
    double start_angle = unknown;   ///< degrees
};

/// What 212 to 215 say: one run along the wall on every level.
struct WallFinishing : BelowSurface {
    static constexpr bool anywhere = true;  ///< where it says its centre
    double infeed = unknown;
    double feed_mill = unknown;
    Said feed_plunge;  ///< 0 and not said: as milling
    double centre_u = unknown;
    double centre_v = unknown;
};

/// Of a rectangle.
struct RectangularFinishing : WallFinishing {
    double length = unknown;
    double width = unknown;
    Said corner_radius;
    Said allowance_u;  ///< says nothing here
};

/// rectangular-pocket-finish (212)
struct RectangularPocketFinishing : RectangularFinishing {
    static constexpr Kind kind = Kind::rectangular_pocket_finish;
};

/// rectangular-stud-finish (213)
struct RectangularStudFinishing : RectangularFinishing {
    static constexpr Kind kind = Kind::rectangular_stud_finish;
};

/// Of a circle.
struct CircularFinishing : WallFinishing {
    double diameter = unknown;
    Said blank_diameter;  ///< says nothing here
};

/// circular-pocket-finish (214)
struct CircularPocketFinishing : CircularFinishing {
    static constexpr Kind kind = Kind::circular_pocket_finish;
};

/// circular-stud-finish (215)
struct CircularStudFinishing : CircularFinishing {
    static constexpr Kind kind = Kind::circular_stud_finish;
};

// --- The tables.

template <>
inline constexpr auto members_of<OldPocket> = rows<OldPocket>({
    {Role::clearance, &OldPocket::clearance},
    {Role::depth, &OldPocket::depth, Must::go_deep},
    {Role::infeed, &OldPocket::infeed, Must::be_other_than_0},
    {Role::feed_plunge, &OldPocket::feed_plunge, Must::be_feed},
    {Role::feed_mill, &OldPocket::feed_mill, Must::be_feed},
    {Role::direction, &OldPocket::direction},
});

template <>
inline constexpr auto members_of<OldRectangularPocket> = joined<OldRectangularPocket>(
    members_of<OldPocket>, rows<OldRectangularPocket>({
                               {Role::axis_x, &OldRectangularPocket::axis_x, Must::be_asked_for},
                               {Role::axis_y, &OldRectangularPocket::axis_y, Must::be_asked_for},
                               {Role::axis_z, &OldRectangularPocket::axis_z, Must::be_asked_for},
                               {Role::corner_radius, &OldRectangularPocket::corner_radius, Must::be_at_least_0},
                           }));

template <>
inline constexpr auto members_of<OldCircularPocket> =
    joined<OldCircularPocket>(members_of<OldPocket>, rows<OldCircularPocket>({
                                                         {Role::radius, &OldCircularPocket::radius, Must::be_above_0},
                                                     }));

template <>
inline constexpr auto members_of<ReciprocatingMilling> = joined<ReciprocatingMilling>(
    members_of<BelowSurface>, rows<ReciprocatingMilling>({
                                  {Role::centre_u, &ReciprocatingMilling::centre_u},
                                  {Role::centre_v, &ReciprocatingMilling::centre_v},
                                  {Role::width, &ReciprocatingMilling::width, Must::be_above_0},
                                  {Role::feed_mill, &ReciprocatingMilling::feed_mill, Must::be_feed},
                                  {Role::feed_plunge, &ReciprocatingMilling::feed_plunge, Must::be_feed_or_0},
                                  {Role::infeed, &ReciprocatingMilling::infeed, Must::be_above_0},
                                  {Role::finish_infeed, &ReciprocatingMilling::finish_infeed, Must::be_at_least_0},
                                  {Role::operation, &ReciprocatingMilling::operation},
                              }));

template <>
inline constexpr auto members_of<ReciprocatingSlot> = joined<ReciprocatingSlot>(
    members_of<ReciprocatingMilling>, rows<ReciprocatingSlot>({
                                          {Role::length, &ReciprocatingSlot::length, Must::be_above_0},
                                          {Role::rotation, &ReciprocatingSlot::rotation},
                                      }));

template <>
inline constexpr auto members_of<ReciprocatingRoundSlot> = joined<ReciprocatingRoundSlot>(
    members_of<ReciprocatingMilling>, rows<ReciprocatingRoundSlot>({
                                          {Role::pitch_circle, &ReciprocatingRoundSlot::pitch_circle, Must::be_above_0},
                                          {Role::angle_length, &ReciprocatingRoundSlot::angle_length},
                                          {Role::start_angle, &ReciprocatingRoundSlot::start_angle},
                                      }));

template <>
inline constexpr auto members_of<WallFinishing> = joined<WallFinishing>(
    members_of<BelowSurface>, rows<WallFinishing>({
                                  {Role::infeed, &WallFinishing::infeed, Must::be_above_0},
                                  {Role::feed_mill, &WallFinishing::feed_mill, Must::be_feed},
                                  {Role::feed_plunge, &WallFinishing::feed_plunge, Must::be_feed_or_0},
                                  {Role::centre_u, &WallFinishing::centre_u},
                                  {Role::centre_v, &WallFinishing::centre_v},
                              }));

template <>
inline constexpr auto members_of<RectangularFinishing> = joined<RectangularFinishing>(
    members_of<WallFinishing>, rows<RectangularFinishing>({
                                   {Role::length, &RectangularFinishing::length, Must::be_above_0},
                                   {Role::width, &RectangularFinishing::width, Must::be_above_0},
                                   {Role::corner_radius, &RectangularFinishing::corner_radius, Must::be_at_least_0},
                                   {Role::allowance_u, &RectangularFinishing::allowance_u, Must::be_asked_for},
                               }));

template <>
inline constexpr auto members_of<RectangularPocketFinishing> =
    joined<RectangularPocketFinishing>(members_of<RectangularFinishing>);

template <>
inline constexpr auto members_of<RectangularStudFinishing> =
    joined<RectangularStudFinishing>(members_of<RectangularFinishing>);

template <>
inline constexpr auto members_of<CircularFinishing> = joined<CircularFinishing>(
    members_of<WallFinishing>, rows<CircularFinishing>({
                                   {Role::diameter, &CircularFinishing::diameter, Must::be_above_0},
                                   {Role::blank_diameter, &CircularFinishing::blank_diameter, Must::be_asked_for},
                               }));

template <>
inline constexpr auto members_of<CircularPocketFinishing> =
    joined<CircularPocketFinishing>(members_of<CircularFinishing>);

template <>
inline constexpr auto members_of<CircularStudFinishing> = joined<CircularStudFinishing>(members_of<CircularFinishing>);

}  // namespace obrys::cycles
