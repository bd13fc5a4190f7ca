#pragma once
/// Pockets, slots and studs of given figures: HEIDENHAIN's CYCL DEF 251 … 257. Lengths in mm, feeds in mm/min
/// (infinity: rapid traverse). What the members do beyond their comments: pocket.cpp, slot.cpp, stud.cpp.

#include "cycles/heights.hpp"

namespace obrys::cycles {

/// What 251 to 257 say. Angles in degrees.
struct MilledFigure : BelowSurface {
    Said operation;  ///< 0 roughing and finishing, 1 roughing, 2 finishing
    Said position;   ///< which point of the figure the called position is
    Said allowance_side;
    Said allowance_floor;
    double infeed = unknown;
    Said finish_infeed;  ///< 0 and not said: in one
    double feed_mill = unknown;
    double feed_plunge = unknown;
    Said feed_finish;     ///< 0 and not said: as milling
    Said feed_reference;  ///< says nothing here
    Said direction;       ///< +1 climb, -1 up-cut
    Said rotation;        ///< of the figure
    Said overlap;         ///< of the paths, in tool radii; above 0 and below 2; not said: 1
    Said plunge;          ///< 0 straight down, 1 helix, 2 to and fro
};

/// rectangular-pocket (251)
struct RectangularPocket : MilledFigure {
    static constexpr Kind kind = Kind::rectangular_pocket;
    double length = unknown;
    double width = unknown;
    Said corner_radius;
};

/// circular-pocket (252)
struct CircularPocket : MilledFigure {
    static constexpr Kind kind = Kind::circular_pocket;
    double diameter = unknown;
};

/// slot (253)
struct Slot : MilledFigure {
    static constexpr Kind kind = Kind::slot;
    double length = unknown;
    double width = unknown;
};

/// round-slot (254)
struct RoundSlot : MilledFigure {
    static constexpr Kind kind = Kind::round_slot;
    static constexpr bool anywhere = true;  ///< where it says its centre
    double pitch_circle = unknown;          ///< diameter
    double width = unknown;
    double angle_length = unknown;
    double start_angle = unknown;
    Said centre_u;  ///< where the position is 0
    Said centre_v;
    Said count;       ///< of slots, from 1 on
    Said angle_step;  ///< from slot to slot
};

/// rectangular-stud (256)
struct RectangularStud : MilledFigure {
    static constexpr Kind kind = Kind::rectangular_stud;
    double length = unknown;
    double width = unknown;
    double blank_length = unknown;
    double blank_width = unknown;
    Said corner_radius;
    Said approach_position;  ///< says nothing here
};

/// circular-stud (257)
struct CircularStud : MilledFigure {
    static constexpr Kind kind = Kind::circular_stud;
    double diameter = unknown;
    double blank_diameter = unknown;
    Said start_angle;  ///< says nothing here
};

// --- The tables.

template <>
inline constexpr auto members_of<MilledFigure> = joined<MilledFigure>(
    members_of<BelowSurface>, rows<MilledFigure>({
                                  {Role::operation, &MilledFigure::operation},
                                  {Role::position, &MilledFigure::position},
                                  {Role::allowance_side, &MilledFigure::allowance_side, Must::be_at_least_0},
                                  {Role::allowance_floor, &MilledFigure::allowance_floor, Must::be_at_least_0},
                                  {Role::infeed, &MilledFigure::infeed, Must::be_above_0},
                                  {Role::finish_infeed, &MilledFigure::finish_infeed, Must::be_at_least_0},
                                  {Role::feed_mill, &MilledFigure::feed_mill, Must::be_feed},
                                  {Role::feed_plunge, &MilledFigure::feed_plunge, Must::be_feed},
                                  {Role::feed_finish, &MilledFigure::feed_finish, Must::be_feed_or_0},
                                  {Role::feed_reference, &MilledFigure::feed_reference, Must::be_asked_for},
                                  {Role::direction, &MilledFigure::direction},
                                  {Role::rotation, &MilledFigure::rotation},
                                  {Role::overlap, &MilledFigure::overlap},
                                  {Role::plunge, &MilledFigure::plunge},
                              }));

template <>
inline constexpr auto members_of<RectangularPocket> = joined<RectangularPocket>(
    members_of<MilledFigure>, rows<RectangularPocket>({
                                  {Role::length, &RectangularPocket::length, Must::be_above_0},
                                  {Role::width, &RectangularPocket::width, Must::be_above_0},
                                  {Role::corner_radius, &RectangularPocket::corner_radius, Must::be_at_least_0},
                              }));

template <>
inline constexpr auto members_of<CircularPocket> =
    joined<CircularPocket>(members_of<MilledFigure>, rows<CircularPocket>({
                                                         {Role::diameter, &CircularPocket::diameter, Must::be_above_0},
                                                     }));

template <>
inline constexpr auto members_of<Slot> = joined<Slot>(members_of<MilledFigure>,
                                                      rows<Slot>({
                                                          {Role::length, &Slot::length, Must::be_above_0},
                                                          {Role::width, &Slot::width, Must::be_above_0},
                                                      }));

template <>
inline constexpr auto members_of<RoundSlot> =
    joined<RoundSlot>(members_of<MilledFigure>, rows<RoundSlot>({
                                                    {Role::pitch_circle, &RoundSlot::pitch_circle, Must::be_above_0},
                                                    {Role::width, &RoundSlot::width, Must::be_above_0},
                                                    {Role::angle_length, &RoundSlot::angle_length},
                                                    {Role::start_angle, &RoundSlot::start_angle},
                                                    {Role::centre_u, &RoundSlot::centre_u, Must::be_asked_for},
                                                    {Role::centre_v, &RoundSlot::centre_v, Must::be_asked_for},
                                                    {Role::count, &RoundSlot::count},
                                                    {Role::angle_step, &RoundSlot::angle_step},
                                                }));

template <>
inline constexpr auto members_of<RectangularStud> = joined<RectangularStud>(
    members_of<MilledFigure>, rows<RectangularStud>({
                                  {Role::length, &RectangularStud::length, Must::be_above_0},
                                  {Role::width, &RectangularStud::width, Must::be_above_0},
                                  {Role::blank_length, &RectangularStud::blank_length},
                                  {Role::blank_width, &RectangularStud::blank_width},
                                  {Role::corner_radius, &RectangularStud::corner_radius, Must::be_at_least_0},
                                  {Role::approach_position, &RectangularStud::approach_position, Must::be_asked_for},
                              }));

template <>
inline constexpr auto members_of<CircularStud> = joined<CircularStud>(
    members_of<MilledFigure>, rows<CircularStud>({
                                  {Role::diameter, &CircularStud::diameter, Must::be_above_0},
                                  {Role::blank_diameter, &CircularStud::blank_diameter},
                                  {Role::start_angle, &CircularStud::start_angle, Must::be_asked_for},
                              }));

}  // namespace obrys::cycles
