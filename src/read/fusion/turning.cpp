/// Threads: feed coupled to the spindle, and the cycle that turns them pass by pass.

#include <cmath>

#include "read/fusion/state.hpp"

namespace obrys::read::fusion {

using geom::Vec3;
using program::Code;
using program::Modal;

namespace {

void tell_thread(State& s, const Place& where, const Vec3& to, double pitch) {
    const Vec3 from = s.at.value_or(to);
    const bool along = std::abs(to.z - from.z) >= std::abs(to.x - from.x);
    begin_block(s, where);
    s.build.modal(Modal::thread, where.begin, where.end);
    s.build.literal(Code::x, to.x, where.begin, where.end);
    s.build.literal(Code::z, to.z, where.begin, where.end);
    s.build.literal(along ? Code::k : Code::i, pitch, where.begin, where.end);
    end_block(s, where);
    s.at = to;
}

}  // namespace

void run_thread(State& s, const Place& where, const Vec3& to) {
    if (!s.at) return refuse(s, where, "where this pass of a thread begins is not known");
    tell_thread(s, where, to, *s.thread_pitch);
}

void couple_feed(State& s, bool coupled) {
    s.thread_pitch.reset();
    if (!coupled) return;
    const auto pitch = number_of(s, "operation:threadPitch");
    if (pitch && *pitch > 0)
        s.thread_pitch = *pitch;
    else
        refuse(s, place_of(s.line), "the feed is coupled to the spindle, and nothing says the pitch");
}

/// In across the axis, along the thread, out across the axis, back: as the cycle of one pass that Autodesk's posts for
/// lathes write (G92).
void run_thread_pass(State& s, const Cycle& c, const Vec3& to) {
    const Place where = place_of(s.line);
    const double clear = c.get("clearance");
    if (!s.at || !s.context.turning) return refuse(s, where, "where this pass of a thread begins is not known");
    if (!(c.get("pitch") > 0)) return refuse(s, where, "a thread has a pitch above 0");
    const double start_x = to.x - c.get("incrementalX"), start_z = to.z - c.get("incrementalZ");
    if (s.at->x != clear) run_straight(s, where, {clear, 0, s.at->z}, true);
    if (s.at->z != start_z) run_straight(s, where, {clear, 0, start_z}, true);
    run_straight(s, where, {start_x, 0, start_z}, true);
    tell_thread(s, where, to, c.get("pitch"));
    run_straight(s, where, {clear, 0, to.z}, true);
    run_straight(s, where, {clear, 0, start_z}, true);
}

}  // namespace obrys::read::fusion
