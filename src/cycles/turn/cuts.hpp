#pragma once
/// Turning cycles of single cuts, pecks and threads, as structs. Lengths in mm, those in X as radii; what counts beyond
/// the comments: turning.hpp.

#include "cycles/typed.hpp"

namespace obrys::cycles {

/// lathe-peck-along (G74)
struct PecksAlong {
    static constexpr Kind kind = Kind::lathe_peck_along;
    double target_u = unknown;
    Said target_v;
    Said infeed;       ///< from peck to peck; not said: in one go
    Said stepover;     ///< across
    Said escape;       ///< after each infeed; 0
    Said relief;       ///< sideways at the bottom, where there are steps; 0
    Said length_unit;  ///< mm per unit of the program, which matters to tolerances; not said: 1
};

/// lathe-peck-across (G75)
struct PecksAcross {
    static constexpr Kind kind = Kind::lathe_peck_across;
    Said target_u;
    double target_v = unknown;
    Said infeed;       ///< from peck to peck; not said: in one go
    Said stepover;     ///< across
    Said escape;       ///< after each infeed; 0
    Said relief;       ///< sideways at the bottom, where there are steps; 0
    Said length_unit;  ///< mm per unit of the program, which matters to tolerances; not said: 1
};

/// lathe-box-along (G90)
struct BoxAlong {
    static constexpr Kind kind = Kind::lathe_box_along;
    double target_u = unknown;
    double target_v = unknown;
    Said taper_v;      ///< start of the cut less its end; 0
    Said length_unit;  ///< mm per unit of the program, which matters to tolerances; not said: 1
};

/// lathe-box-across (G94)
struct BoxAcross {
    static constexpr Kind kind = Kind::lathe_box_across;
    double target_u = unknown;
    double target_v = unknown;
    Said taper_u;      ///< start of the cut less its end; 0
    Said length_unit;  ///< mm per unit of the program, which matters to tolerances; not said: 1
};

/// What G76 and G92 say of each pass.
struct ThreadLine {
    double target_u = unknown;
    double target_v = unknown;  ///< of the root
    Said taper_v;               ///< start of the cut less its end; 0
    Said runout;                ///< along the axis; 0
    double pitch = unknown;
    Said spindle_angle;  ///< of the spindle where the thread begins, degrees; 0
    Said length_unit;    ///< mm per unit of the program, which matters to tolerances; not said: 1
};

/// lathe-box-thread (G92)
struct BoxThread : ThreadLine {
    static constexpr Kind kind = Kind::lathe_box_thread;
};

/// lathe-thread-passes (G76)
struct ThreadPasses : ThreadLine {
    static constexpr Kind kind = Kind::lathe_thread_passes;
    double thread_depth = unknown;
    double first_depth = unknown;
    Said min_infeed;
    Said finish_allowance;
    Said finish_passes;  ///< not said: 1
    Said infeed_angle;   ///< degrees, half of a/2; 0
    Said infeed_method;  ///< 1 equal areas on one flank, 2 on both; 3 equal depths on one flank, 4 on both; not said: 1
    Said runout_leads;   ///< the runout in leads of the thread, where it is not said as a length
};

/// lathe-thread-degressive (LinuxCNC G76)
struct DegressiveThread {
    static constexpr Kind kind = Kind::lathe_thread_degressive;
    Said length_unit;               ///< mm per unit of the program, which matters to tolerances; not said: 1
    double target_u = unknown;      ///< end of the drive line
    Said target_v;                  ///< not said: where the tool stands
    double pitch = unknown;         ///< P, signed
    double crest_offset = unknown;  ///< I; negative: outside
    double first_depth = unknown;   ///< J
    double thread_depth = unknown;  ///< K
    Said degression;                ///< R; 1
    Said infeed_angle;              ///< Q, degrees; 0
    Said spring_passes;             ///< H; 0
    Said taper_length;              ///< E; 0
    Said taper_ends;                ///< L: 0 none, 1 entry, 2 exit, 3 both
};

// --- The tables.

template <>
inline constexpr auto members_of<PecksAlong> = rows<PecksAlong>({
    {Role::target_u, &PecksAlong::target_u},
    {Role::target_v, &PecksAlong::target_v},
    {Role::infeed, &PecksAlong::infeed, Must::be_at_least_0},
    {Role::stepover, &PecksAlong::stepover, Must::be_at_least_0},
    {Role::escape, &PecksAlong::escape, Must::be_at_least_0},
    {Role::relief, &PecksAlong::relief, Must::be_asked_for},
    {Role::length_unit, &PecksAlong::length_unit, Must::be_above_0},
});

template <>
inline constexpr auto members_of<PecksAcross> = rows<PecksAcross>({
    {Role::target_u, &PecksAcross::target_u},
    {Role::target_v, &PecksAcross::target_v},
    {Role::infeed, &PecksAcross::infeed, Must::be_at_least_0},
    {Role::stepover, &PecksAcross::stepover, Must::be_at_least_0},
    {Role::escape, &PecksAcross::escape, Must::be_at_least_0},
    {Role::relief, &PecksAcross::relief, Must::be_asked_for},
    {Role::length_unit, &PecksAcross::length_unit, Must::be_above_0},
});

template <>
inline constexpr auto members_of<BoxAlong> = rows<BoxAlong>({
    {Role::target_u, &BoxAlong::target_u},
    {Role::target_v, &BoxAlong::target_v},
    {Role::taper_v, &BoxAlong::taper_v},
    {Role::length_unit, &BoxAlong::length_unit, Must::be_above_0},
});

template <>
inline constexpr auto members_of<BoxAcross> = rows<BoxAcross>({
    {Role::target_u, &BoxAcross::target_u},
    {Role::target_v, &BoxAcross::target_v},
    {Role::taper_u, &BoxAcross::taper_u},
    {Role::length_unit, &BoxAcross::length_unit, Must::be_above_0},
});

template <>
inline constexpr auto members_of<ThreadLine> = rows<ThreadLine>({
    {Role::target_u, &ThreadLine::target_u},
    {Role::target_v, &ThreadLine::target_v},
    {Role::taper_v, &ThreadLine::taper_v},
    {Role::runout, &ThreadLine::runout, Must::be_at_least_0},
    {Role::pitch, &ThreadLine::pitch, Must::be_above_0},
    {Role::spindle_angle, &ThreadLine::spindle_angle},
    {Role::length_unit, &ThreadLine::length_unit, Must::be_above_0},
});

template <>
inline constexpr auto members_of<BoxThread> = joined<BoxThread>(members_of<ThreadLine>);

template <>
inline constexpr auto members_of<ThreadPasses> = joined<ThreadPasses>(
    members_of<ThreadLine>, rows<ThreadPasses>({
                                {Role::thread_depth, &ThreadPasses::thread_depth, Must::be_above_0},
                                {Role::first_depth, &ThreadPasses::first_depth, Must::be_above_0},
                                {Role::min_infeed, &ThreadPasses::min_infeed, Must::be_at_least_0},
                                {Role::finish_allowance, &ThreadPasses::finish_allowance, Must::be_at_least_0},
                                {Role::finish_passes, &ThreadPasses::finish_passes},
                                {Role::infeed_angle, &ThreadPasses::infeed_angle},
                                {Role::infeed_method, &ThreadPasses::infeed_method},
                                {Role::runout_leads, &ThreadPasses::runout_leads, Must::be_at_least_0},
                            }));

template <>
inline constexpr auto members_of<DegressiveThread> = rows<DegressiveThread>({
    {Role::length_unit, &DegressiveThread::length_unit, Must::be_above_0},
    {Role::target_u, &DegressiveThread::target_u},
    {Role::target_v, &DegressiveThread::target_v},
    {Role::pitch, &DegressiveThread::pitch},
    {Role::crest_offset, &DegressiveThread::crest_offset},
    {Role::first_depth, &DegressiveThread::first_depth},
    {Role::thread_depth, &DegressiveThread::thread_depth},
    {Role::degression, &DegressiveThread::degression},
    {Role::infeed_angle, &DegressiveThread::infeed_angle},
    {Role::spring_passes, &DegressiveThread::spring_passes},
    {Role::taper_length, &DegressiveThread::taper_length},
    {Role::taper_ends, &DegressiveThread::taper_ends},
});

}  // namespace obrys::cycles
