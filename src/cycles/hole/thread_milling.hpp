#pragma once
/// Threads milled in a hole or on a stud: HEIDENHAIN's CYCL DEF 262 … 265, 267. Lengths in mm, feeds in mm/min
/// (infinity: rapid traverse). What the members do beyond their comments: thread_mill.cpp.

#include "cycles/typed.hpp"

namespace obrys::cycles {

/// What all of them say.
struct MilledThread {
    static constexpr bool anywhere = false;
    double surface = unknown;    ///< absolute w
    double clearance = unknown;  ///< above the surface
    Said second_clearance;       ///< above the surface, where the tool stands behind the cycle
    double depth = unknown;      ///< of the thread, from the surface, negative
    double pitch = unknown;      ///< negative: left hand
    double diameter = unknown;   ///< nominal
    Said direction;              ///< +1 climb, -1 up-cut
    Said threads_per_step;       ///< 0: one turn, 1: one helix over the whole length
    double feed_mill = unknown, feed_position = unknown;
    Said feed_approach;  ///< 0 and not said: as milling
};

/// thread-mill (262)
struct ThreadMilling : MilledThread {
    static constexpr Kind kind = Kind::thread_mill;
};

/// A chamfer milled with the tool's front.
struct ThreadFront : MilledThread {
    Said front_depth;       ///< from the surface, negative; 0: none
    Said front_offset;      ///< radius of the way
    Said feed_countersink;  ///< of it
};

/// thread-mill-countersink (263)
struct CountersunkThreadMilling : ThreadFront {
    static constexpr Kind kind = Kind::thread_mill_countersink;
    Said countersink_depth;  ///< from the surface, negative
    Said side_clearance;     ///< says nothing here: countersinking along the core diameter is not simulated
};

/// thread-mill-drill (264)
struct DrilledThreadMilling : MilledThread {
    static constexpr Kind kind = Kind::thread_mill_drill;
    Said front_depth, front_offset;  ///< as of ThreadFront
    Said hole_depth;                 ///< from the surface, negative; 0: none
    Said infeed;
    Said stop_distance_first;
    Said chip_break_depth, chip_break_distance;
    Said feed_plunge;
};

/// thread-mill-helix (265)
struct HelicalThreadMilling : ThreadFront {
    static constexpr Kind kind = Kind::thread_mill_helix;
    Said countersink_order;  ///< not 0: behind the thread
};

/// thread-mill-outside (267)
struct OutsideThreadMilling : ThreadFront {
    static constexpr Kind kind = Kind::thread_mill_outside;
};

// --- The tables.

template <>
inline constexpr auto members_of<MilledThread> = rows<MilledThread>({
    {Role::surface, &MilledThread::surface},
    {Role::clearance, &MilledThread::clearance, Must::be_at_least_0},
    {Role::second_clearance, &MilledThread::second_clearance, Must::be_at_least_0},
    {Role::depth, &MilledThread::depth, Must::go_down},
    {Role::pitch, &MilledThread::pitch, Must::be_other_than_0},
    {Role::diameter, &MilledThread::diameter, Must::be_above_0},
    {Role::direction, &MilledThread::direction},
    {Role::threads_per_step, &MilledThread::threads_per_step, Must::be_at_least_0},
    {Role::feed_mill, &MilledThread::feed_mill, Must::be_feed},
    {Role::feed_position, &MilledThread::feed_position, Must::be_feed},
    {Role::feed_approach, &MilledThread::feed_approach, Must::be_feed_or_0},
});

template <>
inline constexpr auto members_of<ThreadMilling> = joined<ThreadMilling>(members_of<MilledThread>);

template <>
inline constexpr auto members_of<ThreadFront> = joined<ThreadFront>(
    members_of<MilledThread>, rows<ThreadFront>({
                                  {Role::front_depth, &ThreadFront::front_depth, Must::go_down},
                                  {Role::front_offset, &ThreadFront::front_offset, Must::be_asked_for},
                                  {Role::feed_countersink, &ThreadFront::feed_countersink, Must::be_asked_for},
                              }));

template <>
inline constexpr auto members_of<CountersunkThreadMilling> = joined<CountersunkThreadMilling>(
    members_of<ThreadFront>, rows<CountersunkThreadMilling>({
                                 {Role::countersink_depth, &CountersunkThreadMilling::countersink_depth, Must::go_down},
                                 {Role::side_clearance, &CountersunkThreadMilling::side_clearance, Must::be_asked_for},
                             }));

template <>
inline constexpr auto members_of<DrilledThreadMilling> = joined<DrilledThreadMilling>(
    members_of<MilledThread>,
    rows<DrilledThreadMilling>({
        {Role::front_depth, &DrilledThreadMilling::front_depth, Must::go_down},
        {Role::front_offset, &DrilledThreadMilling::front_offset, Must::be_asked_for},
        {Role::hole_depth, &DrilledThreadMilling::hole_depth, Must::go_down},
        {Role::infeed, &DrilledThreadMilling::infeed, Must::be_asked_for},
        {Role::stop_distance_first, &DrilledThreadMilling::stop_distance_first, Must::be_asked_for},
        {Role::chip_break_depth, &DrilledThreadMilling::chip_break_depth, Must::be_asked_for},
        {Role::chip_break_distance, &DrilledThreadMilling::chip_break_distance, Must::be_asked_for},
        {Role::feed_plunge, &DrilledThreadMilling::feed_plunge, Must::be_asked_for},
    }));

template <>
inline constexpr auto members_of<HelicalThreadMilling> = joined<HelicalThreadMilling>(
    members_of<ThreadFront>, rows<HelicalThreadMilling>({
                                 {Role::countersink_order, &HelicalThreadMilling::countersink_order},
                             }));

template <>
inline constexpr auto members_of<OutsideThreadMilling> = joined<OutsideThreadMilling>(members_of<ThreadFront>);

}  // namespace obrys::cycles
