/// Holes of the cycle in force.

#include <algorithm>
#include <cmath>

#include "read/apt/state.hpp"

namespace obrys::read::apt {

using dialect::apt::Hole;
using geom::Vec3;
using program::Code;
using program::Modal;

namespace {

constexpr double upright = 1e-6;
constexpr double above_depth = 1;  ///< mm that pecks stop above the depth reached, and chips are broken by
constexpr double round_feed = 1;   ///< per minute: CAM systems round the feed of a tap to whole numbers

/// The cycle's feed is its pitch by the speed of the spindle: it says the pitch, as controls take it.
bool feeds_by_pitch(State& s, const HoleCycle& c) {
    if (c.hole != Hole::tap_rigid || !c.feed) return false;
    const double due = *c.pitch * s.speed;
    if (s.speed > 0 && std::abs(c.feed->value - due) < 1e-9 * c.feed->value) return true;
    if (s.speed > 0 && std::abs(c.feed->value - due) > round_feed)
        assume(s, c.begin, c.end,
               "a tap's feed per minute is not its thread by the speed of the spindle: the thread is what counts",
               "let the CAM system write one of them");
    return false;
}

/// The height where the cycle ends, above `z` of the point.
double height_behind(const HoleCycle& c, double z) {
    return std::max(c.start.value_or(z + c.retract.value_or(c.clearance)), z + c.clearance);
}

void tell_sizes(State& s, const HoleCycle& c, const Vec3& at, bool by_feed) {
    const auto tell = [&](Code code, double v) { s.build.literal(code, v, c.begin, c.end); };
    tell(Code::radius, at.z + c.clearance);
    if (c.retract || c.start) tell(Code::e, height_behind(c, at.z));
    if (c.dwell && *c.dwell > 0) tell(Code::p, *c.dwell);
    if (s.system.holes_begin_at_surface) tell(Code::i1, at.z);
    if (c.hole == Hole::tap_rigid) {
        if (!by_feed) tell(Code::i, *c.pitch);
        if (!c.step && !c.first_step) return;
        tell(Code::q, c.step.value_or(c.first_step.value_or(0)));
        tell(Code::k1, c.back ? *c.back / *c.pitch : 1);
    }
    if (c.hole != Hole::peck && c.hole != Hole::chip_break) return;
    const double mm = s.inch > 0 ? s.inch : 1;
    const double first = c.first_step.value_or(c.step.value_or(0)), step = c.step.value_or(first);
    tell(Code::q, first);
    if (step < first) {
        tell(Code::j, first - step);
        tell(Code::k, step);
    }
    tell(Code::i, c.back.value_or(above_depth / mm));
}

/// Cutter locations say the way between two holes by nothing but the holes: a tool below the next one's clearance
/// rises to it before it moves.
void rise_to(State& s, double height) {
    if (!s.at || s.at->z >= height) return;
    begin_block(s);
    s.build.modal(Modal::rapid, s.line.begin, s.line.end);
    s.build.literal(Code::z, height, s.line.begin, s.line.end);
    end_block(s);
    s.at->z = height;
}

/// A tap whose cycle says no thread and no feed takes a feed per turn that is in force.
HoleCycle with_thread(State& s, HoleCycle c) {
    if (c.hole != Hole::tap_floating || c.feed || !s.feed || s.feed->mode != Modal::feed_per_rev) return c;
    if (!(s.feed->value > 0)) return c;
    assume(s, c.begin, c.end, "a tap of which only a feed per turn of FEDRAT is said takes that as its thread",
           "let the CAM system write PITCH");
    c.hole = Hole::tap_rigid;
    c.pitch = s.feed->value;
    return c;
}

/// The tool stands along Z in the end; it was tilted before.
void turn_upright(State& s, const Vec3& to) {
    if (geom::distance(s.axis, s.told_axis) < upright) return;
    assume(s, s.line.begin, s.line.end,
           "a tilted tool that a hole sets upright is taken to turn on its way there, at the height where it stands",
           "let the CAM system write a point with the new axis before the cycle");
    tell_upright(s, to);
}

}  // namespace

void run_hole(State& s, const Vec3& at) {
    if (s.cycle->refused) {
        s.at = at;
        return;
    }
    s.moved_with_tool = true;
    if (geom::distance(s.axis, {0, 0, 1}) > upright) {
        s.at = at;
        return refuse(s, "a hole cycle with a tool that does not stand along Z is not run");
    }
    const HoleCycle c = with_thread(s, *s.cycle);
    rise_to(s, at.z + c.clearance);
    turn_upright(s, at);
    begin_block(s);
    const bool by_feed = feeds_by_pitch(s, c);
    const bool own = c.feed && (c.hole != Hole::tap_rigid || by_feed);
    if (own || (s.feed && !s.feed_told)) {
        tell_feed(s, own ? *c.feed : *s.feed);
        s.feed_told = !own;
    }
    s.build.modal(Modal::canned, s.line.begin, s.line.end, static_cast<int>(c.hole));
    s.build.literal(Code::x, at.x, s.line.begin, s.line.end);
    s.build.literal(Code::y, at.y, s.line.begin, s.line.end);
    s.build.literal(Code::z, at.z - c.depth, s.line.begin, s.line.end);
    tell_sizes(s, c, at, by_feed);
    end_block(s);
    s.at = Vec3{at.x, at.y, height_behind(c, at.z)};
}

}  // namespace obrys::read::apt
