#pragma once
/// Surfaces in passes: HEIDENHAIN's CYCL DEF 230, 231, 232. They say their place themselves. Lengths and places in mm,
/// feeds in mm/min. What the members do beyond their comments: multipass.cpp.

#include "cycles/typed.hpp"

namespace obrys::cycles {

/// multipass (230)
struct Multipass {
    static constexpr Kind kind = Kind::multipass;
    static constexpr bool anywhere = true;
    double start_u = unknown;
    double start_v = unknown;
    double start_w = unknown;
    double length = unknown;  ///< signed
    double width = unknown;   ///< signed
    double feed_plunge = unknown;
    double feed_mill = unknown;
    double feed_step = unknown;
    double clearance = unknown;
    double passes = unknown;
};

/// ruled-surface (231): between four corners, each pass from the first side to the second
struct RuledSurface {
    static constexpr Kind kind = Kind::ruled_surface;
    static constexpr bool anywhere = true;
    double start_u = unknown;
    double start_v = unknown;
    double start_w = unknown;
    double second_u = unknown;
    double second_v = unknown;
    double second_w = unknown;
    double third_u = unknown;
    double third_v = unknown;
    double third_w = unknown;
    double fourth_u = unknown;
    double fourth_v = unknown;
    double fourth_w = unknown;
    double feed_mill = unknown;
    double passes = unknown;
};

/// face-mill (232)
struct FaceMilling {
    static constexpr Kind kind = Kind::face_mill;
    static constexpr bool anywhere = true;
    double start_u = unknown;
    double start_v = unknown;
    double start_w = unknown;
    double length = unknown;       ///< signed
    double width = unknown;        ///< signed
    double end_surface = unknown;  ///< absolute w of the face
    Said allowance_floor;
    double infeed = unknown;
    double feed_mill = unknown;
    Said feed_finish;  ///< of the last level, where there is an allowance
    double feed_position = unknown;
    double clearance = unknown;
    Said second_clearance;
    Said side_clearance;
    double strategy = unknown;  ///< 0 to and fro, 1 the same within the surface, 2 one way
    double overlap = unknown;   ///< of the paths, in tool radii; below 2
};

// --- The tables.

template <>
inline constexpr auto members_of<Multipass> = rows<Multipass>({
    {Role::start_u, &Multipass::start_u},
    {Role::start_v, &Multipass::start_v},
    {Role::start_w, &Multipass::start_w},
    {Role::length, &Multipass::length},
    {Role::width, &Multipass::width},
    {Role::feed_plunge, &Multipass::feed_plunge, Must::be_feed},
    {Role::feed_mill, &Multipass::feed_mill, Must::be_feed},
    {Role::feed_step, &Multipass::feed_step, Must::be_feed},
    {Role::clearance, &Multipass::clearance, Must::be_at_least_0},
    {Role::passes, &Multipass::passes},
});

template <>
inline constexpr auto members_of<RuledSurface> = rows<RuledSurface>({
    {Role::start_u, &RuledSurface::start_u},
    {Role::start_v, &RuledSurface::start_v},
    {Role::start_w, &RuledSurface::start_w},
    {Role::second_u, &RuledSurface::second_u},
    {Role::second_v, &RuledSurface::second_v},
    {Role::second_w, &RuledSurface::second_w},
    {Role::third_u, &RuledSurface::third_u},
    {Role::third_v, &RuledSurface::third_v},
    {Role::third_w, &RuledSurface::third_w},
    {Role::fourth_u, &RuledSurface::fourth_u},
    {Role::fourth_v, &RuledSurface::fourth_v},
    {Role::fourth_w, &RuledSurface::fourth_w},
    {Role::feed_mill, &RuledSurface::feed_mill, Must::be_feed},
    {Role::passes, &RuledSurface::passes},
});

template <>
inline constexpr auto members_of<FaceMilling> = rows<FaceMilling>({
    {Role::start_u, &FaceMilling::start_u},
    {Role::start_v, &FaceMilling::start_v},
    {Role::start_w, &FaceMilling::start_w},
    {Role::length, &FaceMilling::length},
    {Role::width, &FaceMilling::width},
    {Role::end_surface, &FaceMilling::end_surface},
    {Role::allowance_floor, &FaceMilling::allowance_floor, Must::be_at_least_0},
    {Role::infeed, &FaceMilling::infeed, Must::be_above_0},
    {Role::feed_mill, &FaceMilling::feed_mill, Must::be_feed},
    {Role::feed_finish, &FaceMilling::feed_finish, Must::be_asked_for},
    {Role::feed_position, &FaceMilling::feed_position, Must::be_feed},
    {Role::clearance, &FaceMilling::clearance, Must::be_at_least_0},
    {Role::second_clearance, &FaceMilling::second_clearance, Must::be_at_least_0},
    {Role::side_clearance, &FaceMilling::side_clearance, Must::be_at_least_0},
    {Role::strategy, &FaceMilling::strategy},
    {Role::overlap, &FaceMilling::overlap, Must::be_above_0},
});

}  // namespace obrys::cycles
