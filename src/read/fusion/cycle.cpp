/// Cycles: what they say, and their points.

#include <algorithm>
#include <cmath>

#include "dialect/fusion/words.hpp"
#include "read/fusion/state.hpp"

namespace obrys::read::fusion {

using dialect::fusion::Hole;
using geom::Vec3;
using program::Code;
using program::Modal;

namespace {

constexpr double above_depth = 1;  ///< mm that pecks stop above the depth reached

void refuse_cycle(State& s, std::string_view why) {
    s.cycle->refused = true;
    s.at.reset();
    refuse(s, s.cycle->where, why);
}

/// What the first point needs to know; empty: all of it is there.
std::string missing(const Cycle& c) {
    if (c.word->hole == Hole::thread_turning) {
        for (const std::string_view name : {"clearance", "pitch", "incrementalX", "incrementalZ"})
            if (!c.has(name)) return "it does not say " + std::string(name);
        return {};
    }
    for (const std::string_view name : {"clearance", "retract", "stock", "depth", "feedrate"})
        if (!c.has(name)) return "it does not say " + std::string(name);
    if (c.get("clearance") < c.get("retract")) return "its clearance lies below its retract plane";
    const bool pecks = c.word->hole == Hole::peck || c.word->hole == Hole::chip_break;
    if (pecks && !(c.get("incrementalDepth") > 0)) return "it says no depth of its pecks";
    if (!(c.get("feedrate") > 0) && c.word->hole != Hole::tap_rigid) return "it says no feed";
    return {};
}

/// The kind that it is run as.
Hole hole_of(const State& s, const Cycle& c) {
    if (c.word->hole == Hole::tap_rigid && !(s.tool && s.tool->pitch > 0)) return Hole::tap_floating;
    return c.word->hole;
}

double height_of(const State& s, double height) {
    return height + (s.direct ? s.context.into_setup.origin.z : s.shift.z);
}

/// A value of the cycle, in the block of its point.
void tell(State& s, Code code, double v) { s.build.literal(code, v, s.line.begin, s.line.end); }

void tell_pecks(State& s, const Cycle& c, Hole hole) {
    const double infeed = c.get("incrementalDepth"), less = c.get("incrementalDepthReduction"),
                 least = c.get("minimumIncrementalDepth");
    tell(s, Code::q, infeed);
    if (less > 0) {
        tell(s, Code::j, less);
        tell(s, Code::k, std::min(least > 0 ? least : infeed, infeed));
    }
    if (hole == Hole::chip_break) tell(s, Code::i, c.get("chipBreakDistance"));
    const bool out = hole == Hole::peck || c.get("accumulatedDepth") > 0;
    if (out) tell(s, Code::j1, above_depth);
    if (hole == Hole::chip_break && out) tell(s, Code::i1, c.get("accumulatedDepth"));
    assume(s, c.where,
           "nothing says where pecks count from, nor how far above the depth reached the tool comes back at rapid: the "
           "retract plane and 1 mm are taken, as controls do");
}

bool breaks_chips(const Cycle& c) {
    return c.get("incrementalDepth") > 0 && c.word->name.ends_with("-with-chip-breaking");
}

void tell_tap(State& s, const Cycle& c) {
    tell(s, Code::k1, s.tool->pitch);
    if (!breaks_chips(c)) return;
    tell(s, Code::q, c.get("incrementalDepth"));
    if (c.get("chipBreakDistance") > 0) tell(s, Code::i, c.get("chipBreakDistance") / s.tool->pitch);
}

void tell_shift(State& s, const Cycle& c) {
    const double angle = c.get("shiftOrientation") * std::acos(-1.0) / 180;
    tell(s, Code::i, c.get("shift") * std::cos(angle));
    tell(s, Code::j, c.get("shift") * std::sin(angle));
    assume(s, c.where, "the tool is taken to leave the wall of the hole in the direction of shiftOrientation");
}

void run_canned(State& s, const Cycle& c, Hole hole, const Vec3& bottom, double retract, double clearance) {
    const Place where = place_of(s.line);
    begin_block(s, where);
    if (c.get("feedrate") > 0) tell_feed(s, where, c.get("feedrate"));
    s.build.modal(Modal::canned, where.begin, where.end, static_cast<int>(hole));
    s.build.literal(Code::x, bottom.x, where.begin, where.end);
    s.build.literal(Code::y, bottom.y, where.begin, where.end);
    s.build.literal(Code::z, bottom.z, where.begin, where.end);
    tell(s, Code::radius, retract);
    tell(s, Code::e, clearance);
    if (c.get("dwell") > 0) tell(s, Code::p, c.get("dwell"));
    // Steps would count from the surface.
    const bool steps = hole == Hole::peck || hole == Hole::chip_break || breaks_chips(c);
    if (!steps) tell(s, Code::i1, std::clamp(height_of(s, c.get("stock")), bottom.z, retract));
    if (hole == Hole::peck || hole == Hole::chip_break) tell_pecks(s, c, hole);
    if (hole == Hole::tap_rigid) tell_tap(s, c);
    if (hole == Hole::bore_orient) tell_shift(s, c);
    end_block(s, where);
}

/// Over the hole at the height where the cycle begins, as the host of the posts goes there.
void go_over(State& s, const Vec3& bottom, double clearance) {
    const Place where = place_of(s.line);
    if (s.at && s.at->z < clearance) run_straight(s, where, {s.at->x, s.at->y, clearance}, true);
    if (!s.at) return run_straight(s, where, {bottom.x, bottom.y, clearance}, true);
    if (s.at->x != bottom.x || s.at->y != bottom.y) run_straight(s, where, {bottom.x, bottom.y, s.at->z}, true);
    if (s.at->z != clearance) run_straight(s, where, {bottom.x, bottom.y, clearance}, true);
}

bool same_feed_out(const Cycle& c) {
    return !c.has("retractFeedrate") || c.get("retractFeedrate") == c.get("feedrate");
}

void run_hole(State& s, Cycle& c, const Vec3& bottom) {
    const double clearance = height_of(s, c.get("clearance")), retract = height_of(s, c.get("retract"));
    const Hole hole = hole_of(s, c);
    const bool tilted =
        s.direct && !(s.context.into_setup.linear[8] == 1 && geom::distance(s.told_axis, {0, 0, 1}) < 1e-6);
    if (tilted) return refuse_cycle(s, "a cycle with a tool that does not stand along Z is not run here");
    if (!(retract >= bottom.z)) return refuse_cycle(s, "the bottom of a hole lies above its retract plane");
    const double deepest = c.get("accumulatedDepth");
    if (c.word->name.ends_with("-with-chip-breaking") && deepest > 0 && deepest < retract - bottom.z)
        return refuse_cycle(s, "how a tap goes out of the hole behind its accumulatedDepth is not known");
    go_over(s, bottom, clearance);
    if (hole == Hole::break_through) return run_break_through(s, c, bottom);
    if (hole == Hole::guided) return run_guided(s, c, bottom);
    if (hole == Hole::bore_feed && !same_feed_out(c)) return run_feed_out(s, c, bottom);
    run_canned(s, c, hole, bottom, retract, clearance);
    s.at = Vec3{bottom.x, bottom.y, clearance};
}

}  // namespace

void read_cycle(State& s) {
    if (s.cycle) return fail(s, "a cycle begins in a cycle");
    const auto& t = s.line.tokens;
    if (t.size() != 1 || t[0].kind != TokenKind::text) return fail(s, "a cycle has a name");
    std::string_view name = t[0].chars;
    if (const std::size_t slash = name.rfind('/'); slash != std::string_view::npos) name.remove_prefix(slash + 1);
    Cycle c;
    c.word = dialect::fusion::find_cycle(name);
    c.where = {t[0].begin, t[0].end};
    s.cycle = c;
    if (c.word == nullptr) return refuse_cycle(s, "nothing is known of this cycle");
    if (c.word->hole == Hole::not_run) return refuse_cycle(s, c.word->note);
    if (!s.tool || !s.in_section) refuse_cycle(s, "it stands outside of an operation with a tool");
}

void read_cycle_value(State& s, std::string_view name) {
    if (s.cycle->refused) return;
    const Token& value = s.line.tokens[1];
    if (dialect::fusion::is_known_value(name) && value.kind == TokenKind::number) {
        s.cycle->values.insert_or_assign(std::string(name), value.value);
        return;
    }
    if (!dialect::fusion::describes(name))
        refuse_cycle(s, "nothing is known of its " + std::string(name.substr(0, 80)) + ", or it is no number");
}

void run_point(State& s, const Vec3& at) {
    Cycle& c = *s.cycle;
    if (!c.begun) {
        if (const std::string why = missing(c); !why.empty()) return refuse_cycle(s, why);
        c.begun = true;
    }
    if (c.word->hole == Hole::thread_turning) return run_thread_pass(s, c, at);
    run_hole(s, c, at);
}

void end_cycle(State& s) {
    if (!s.cycle) return fail(s, "a cycle ends that has not begun");
    const bool canned = s.cycle->begun && static_cast<int>(hole_of(s, *s.cycle)) <= static_cast<int>(Hole::bore_orient);
    s.cycle.reset();
    if (!canned) return;
    const Place where = place_of(s.line);
    begin_block(s, where);
    s.build.modal(Modal::canned_off, where.begin, where.end);
    end_block(s, where);
}

}  // namespace obrys::read::fusion
