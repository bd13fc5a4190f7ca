/// Hole cycles: CYCLE/word, couplets; every point until CYCLE/OFF is a hole.

#include <cmath>

#include "read/apt/state.hpp"

namespace obrys::read::apt {

using dialect::apt::Couplet;
using dialect::apt::Hole;
using dialect::apt::HoleValue;
using geom::Vec3;
using program::Code;
using program::Modal;

namespace {

constexpr double upright = 1e-6;
constexpr double above_depth = 1;  ///< mm that pecks stop above the depth reached, and chips are broken by

/// The cycle before must not lend the next one its words.
void end_series(State& s) {
    if (!s.cycle) return;
    begin_block(s);
    s.build.modal(Modal::canned_off, s.line.begin, s.line.end);
    end_block(s);
    s.feed_told = s.feed_told && !s.cycle->feed;
    s.cycle.reset();
}

struct Sizes {
    std::optional<double> rapid_to, clearance, depth;
};

double unit_of(const State& s, bool inches) { return (inches ? 25.4 : 1) / (s.inch > 0 ? s.inch : 1); }

void take_feed(HoleCycle& c, const Token& t, bool per_turn, double factor) {
    Feed f;
    f.value = t.number.value * factor;
    f.mode = per_turn ? Modal::feed_per_rev : Modal::feed_per_minute;
    f.begin = t.begin;
    f.end = t.end;
    c.feed = f;
}

void take(State& s, HoleCycle& c, Sizes& sizes, HoleValue what, const Token& t) {
    const double v = t.number.value;
    switch (what) {
        case HoleValue::depth: sizes.depth = std::abs(v); return;
        case HoleValue::rapid_to: sizes.rapid_to = v; return;
        case HoleValue::clearance: sizes.clearance = v; return;
        case HoleValue::retract: c.retract = v; return;
        case HoleValue::dwell: c.dwell = v; return;
        case HoleValue::first_step: c.first_step = v; return;
        case HoleValue::step: c.step = v; return;
        case HoleValue::back: c.back = v; return;
        case HoleValue::feed_minute: return take_feed(c, t, false, unit_of(s, false));
        case HoleValue::feed_turn: return take_feed(c, t, true, unit_of(s, false));
        case HoleValue::inch_minute: return take_feed(c, t, false, unit_of(s, true));
        case HoleValue::inch_turn: return take_feed(c, t, true, unit_of(s, true));
        case HoleValue::plain_minute: return take_feed(c, t, false, 1);
        case HoleValue::plain_turn: return take_feed(c, t, true, 1);
        case HoleValue::threads_inch: c.pitch = v > 0 ? unit_of(s, true) / v : NAN; return;
        case HoleValue::pitch: c.pitch = v; return;
        case HoleValue::none: return;
    }
}

/// Units that feeds of the cycle name, before a length of it is looked at.
void take_unit_of_feed(State& s, const Arguments& a) {
    for (const Token& t : a) {
        const Couplet* known = t.kind == TokenKind::word ? dialect::apt::find_couplet(upper_of(t)) : nullptr;
        if (known == nullptr || s.unit_told) continue;
        if (known->value == HoleValue::feed_minute || known->value == HoleValue::feed_turn) set_unit(s, 1);
        if (known->value == HoleValue::inch_minute || known->value == HoleValue::inch_turn) set_unit(s, 25.4);
    }
    need_unit(s);
}

/// The couplets; a complaint where something else stands there.
std::string read_couplets(State& s, HoleCycle& c, Sizes& sizes, const Arguments& a) {
    for (const Token* t = a.begin() + 1; t < a.end(); ++t) {
        if (t->kind == TokenKind::comma) continue;
        if (t->kind == TokenKind::number)
            return "the order of numbers without words is each shop's own: nothing says whether " +
                   std::string(t->chars) + " is a depth, a feed or a clearance";
        const Couplet* known = t->kind == TokenKind::word ? dialect::apt::find_couplet(upper_of(*t)) : nullptr;
        if (known == nullptr) return "what " + std::string(t->chars) + " says of it is not known";
        if (known->alone) continue;
        if (t + 2 >= a.end() || t[1].kind != TokenKind::comma || t[2].kind != TokenKind::number)
            return std::string(t->chars) + " wants a number";
        take(s, c, sizes, known->value, t[2]);
        t += 2;
    }
    return {};
}

/// Where the feed begins, and where the cycle ends.
std::string take_heights(const State& s, HoleCycle& c, const Sizes& sizes) {
    if (!sizes.depth) return "it says no depth (FEDTO, DEPTH)";
    if (!sizes.rapid_to && !sizes.clearance) return "it says no clearance (RAPTO, CLEAR)";
    c.depth = *sizes.depth;
    const bool below = s.system.rapid_to == dialect::apt::RapidTo::from_clearance && sizes.clearance && sizes.rapid_to;
    if (below) {
        c.clearance = *sizes.clearance - *sizes.rapid_to;
        if (!c.retract || *c.retract == 0) c.retract = sizes.clearance;
    } else {
        c.clearance = sizes.rapid_to.value_or(sizes.clearance.value_or(0));
    }
    if (c.retract && *c.retract == 0) c.retract = sizes.clearance ? *sizes.clearance : c.clearance;
    return {};
}

/// Steps of a rigid tap, behind which it goes back to break the chip.
std::string take_breaks(State& s, const HoleCycle& c) {
    if (c.first_step && c.first_step != c.step.value_or(*c.first_step)) return "a tap's steps are all of one size";
    if (!c.back) assume(s, c.begin, c.end, "nothing says how far a tap goes back to break chips: one turn is taken");
    return {};
}

std::string take_kind(State& s, HoleCycle& c) {
    if (c.hole == Hole::tap_floating && !c.pitch && c.feed && c.feed->mode == Modal::feed_per_rev) {
        c.pitch = c.feed->value;
        c.feed.reset();
    }
    if (c.hole == Hole::tap_floating && c.pitch) c.hole = Hole::tap_rigid;
    if (c.hole == Hole::tap_rigid && !(*c.pitch > 0)) return "its pitch is not greater than 0";
    const bool pecks = c.hole == Hole::peck || c.hole == Hole::chip_break;
    if (pecks && !c.step && !c.first_step) return "it says no step (STEP, 1STPECK)";
    if (!pecks && (c.step || c.first_step)) {
        if (c.hole == Hole::tap_rigid) return take_breaks(s, c);
        if (c.hole != Hole::drill) return "steps of this cycle are not run";
        c.hole = Hole::peck;
    }
    if (pecks && !c.back)
        assume(s, c.begin, c.end,
               "nothing says how far pecks stop above the depth reached, or go back to break chips: 1 mm is taken, the "
               "control has its own");
    if (c.hole == Hole::feed_out)
        assume(s, c.begin, c.end, "the way out of REAM and BORE is taken at feed, to the clearance, the rest at rapid");
    return {};
}

}  // namespace

void read_cycle(State& s, const Arguments& a) {
    if (a.begin() == a.end() || a.begin()->kind != TokenKind::word) return fail(s, a.begin(), "CYCLE wants a word");
    const std::string word = upper_of(*a.begin());
    if (word == "OFF" || word == "NOMORE") return end_series(s);
    if (word == "INIT" || word == "CLEAR") {  // SolidWorks CAM, before a cycle: none is in force
        end_series(s);
        return s.build.ignored("CYCLE/" + word, s.line.begin, s.line.end);
    }
    if (word == "ON") {
        s.cycle = s.last_cycle;
        if (!s.cycle) fail(s, a.begin(), "CYCLE/ON calls the cycle before it, and there is none");
        return;
    }
    end_series(s);
    take_unit_of_feed(s, a);
    HoleCycle c;
    c.begin = s.line.begin;
    c.end = s.line.end;
    Sizes sizes;
    const dialect::apt::HoleWord* known = dialect::apt::find_hole(word);
    std::string fault = known == nullptr ? "what CYCLE/" + word + " does is not known here" : "";
    if (known != nullptr) c.hole = known->hole;
    if (fault.empty()) fault = read_couplets(s, c, sizes, a);
    if (fault.empty()) fault = take_heights(s, c, sizes);
    if (fault.empty()) fault = take_kind(s, c);
    c.refused = !fault.empty();
    if (c.refused) refuse(s, fault);
    s.cycle = s.last_cycle = c;
}

namespace {

/// The cycle's feed is its pitch by the speed of the spindle: it says the pitch, as controls take it.
bool feeds_by_pitch(const State& s, const HoleCycle& c) {
    return c.pitch && c.feed && c.feed->mode == Modal::feed_per_minute && s.speed > 0 &&
           std::abs(c.feed->value - *c.pitch * s.speed) < 1e-9 * c.feed->value;
}

void tell_sizes(State& s, const HoleCycle& c, const Vec3& at) {
    const auto tell = [&](Code code, double v) { s.build.literal(code, v, c.begin, c.end); };
    tell(Code::radius, at.z + c.clearance);
    if (c.retract) tell(Code::e, at.z + std::max(*c.retract, c.clearance));
    if (c.dwell && *c.dwell > 0) tell(Code::p, *c.dwell);
    if (s.system.holes_begin_at_surface) tell(Code::i1, at.z);
    if (c.hole == Hole::tap_rigid) {
        if (!feeds_by_pitch(s, c)) tell(Code::i, *c.pitch);
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

}  // namespace

namespace {

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

}  // namespace

void run_hole(State& s, const Vec3& at) {
    const HoleCycle& c = *s.cycle;
    if (c.refused) {
        s.at = at;
        return;
    }
    s.moved_with_tool = true;
    if (geom::distance(s.axis, {0, 0, 1}) > upright)
        return refuse(s, "a hole cycle with a tool that does not stand along Z is not run");
    rise_to(s, at.z + c.clearance);
    begin_block(s);
    const bool own = c.feed && (c.hole != Hole::tap_rigid || feeds_by_pitch(s, c));
    if (own || (s.feed && !s.feed_told)) {
        tell_feed(s, own ? *c.feed : *s.feed);
        s.feed_told = !own;
    }
    s.build.modal(Modal::canned, s.line.begin, s.line.end, static_cast<int>(c.hole));
    s.build.literal(Code::x, at.x, s.line.begin, s.line.end);
    s.build.literal(Code::y, at.y, s.line.begin, s.line.end);
    s.build.literal(Code::z, at.z - c.depth, s.line.begin, s.line.end);
    tell_sizes(s, c, at);
    end_block(s);
    s.at = Vec3{at.x, at.y, at.z + std::max(c.retract.value_or(c.clearance), c.clearance)};
}

}  // namespace obrys::read::apt
