/// Hole cycles: CYCLE/word, couplets; every point until CYCLE/OFF is a hole.

#include <cmath>

#include "read/apt/state.hpp"

namespace obrys::read::apt {

using dialect::apt::Hole;
using program::Modal;

namespace {

/// The cycle before must not lend the next one its words.
void end_series(State& s) {
    if (!s.cycle) return;
    begin_block(s);
    s.build.modal(Modal::canned_off, s.line.begin, s.line.end);
    end_block(s);
    s.feed_told = s.feed_told && !s.cycle->feed;
    s.cycle.reset();
}

/// Where the feed begins, and where the cycle ends.
std::string take_heights(State& s, HoleCycle& c) {
    const HoleSizes& said = c.said;
    if (!said.depth) return "it says no depth (FEDTO, DEPTH)";
    if (!said.rapid_to && !said.clearance) return "it says no clearance (RAPTO, CLEAR)";
    c.depth = *said.depth;
    c.retract = said.retract;
    const bool both = said.clearance && said.rapid_to;
    if (both && s.system.rapid_to == dialect::apt::RapidTo::from_clearance) {
        c.clearance = *said.clearance - *said.rapid_to;
        if (!c.retract || *c.retract == 0) c.retract = said.clearance;
    } else {
        if (both && *said.clearance != *said.rapid_to)
            assume(s, c.begin, c.end, "of a cycle's RAPTO and CLEAR the first is taken to say where the feed begins",
                   "let the CAM system write one of them");
        c.clearance = said.rapid_to ? *said.rapid_to : *said.clearance;
    }
    if (c.retract && *c.retract == 0) c.retract = said.clearance ? *said.clearance : c.clearance;
    if (!said.retract_to_start) return {};
    assume(s, c.begin, c.end, "RTRCTO,AUTO is taken to go out to the height at which the tool stood before the cycle",
           "let the CAM system write a distance");
    c.retract.reset();
    if (s.at) c.start = s.at->z;
    return {};
}

/// The thread of a tap: PITCH or TPI, else a feed per turn of its own.
void take_thread(State& s, HoleCycle& c) {
    if (c.hole != Hole::tap_floating) return;
    const bool turn = c.feed && c.feed->mode == Modal::feed_per_rev;
    if (c.pitch && turn && std::abs(c.feed->value - *c.pitch) > 1e-6 * *c.pitch)
        assume(s, c.begin, c.end, "a tap's feed per turn is not its thread: the thread is what counts",
               "let the CAM system write one of them");
    if (!c.pitch && turn) c.pitch = c.feed->value;
    if (turn) c.feed.reset();
    if (c.pitch) c.hole = Hole::tap_rigid;
}

/// Steps of a rigid tap, behind which it goes back to break the chip.
std::string take_breaks(State& s, const HoleCycle& c) {
    if (c.first_step && c.first_step != c.step.value_or(*c.first_step)) return "a tap's steps are all of one size";
    if (!c.back) assume(s, c.begin, c.end, "nothing says how far a tap goes back to break chips: one turn is taken");
    return {};
}

std::string take_kind(State& s, HoleCycle& c) {
    c.pitch = c.said.pitch;
    c.feed = c.said.feed;
    c.dwell = c.said.dwell;
    c.first_step = c.said.first_step;
    c.step = c.said.step;
    c.back = c.said.back;
    take_thread(s, c);
    const bool taps = c.hole == Hole::tap_floating || c.hole == Hole::tap_rigid;
    if (c.pitch && !taps) return "PITCH and TPI say nothing of a cycle that is no tap";
    bool pecks = c.hole == Hole::peck || c.hole == Hole::chip_break;
    if (pecks && !c.step && !c.first_step) return "it says no step (STEP, 1STPECK)";
    if (!pecks && (c.step || c.first_step)) {
        if (c.hole == Hole::tap_rigid) return take_breaks(s, c);
        if (c.hole != Hole::drill) return "steps of this cycle are not run";
        c.hole = Hole::peck;
        pecks = true;
    }
    if (c.back && !pecks) return "BACK says nothing of a cycle without steps";
    if (pecks && !c.back)
        assume(s, c.begin, c.end,
               "nothing says how far pecks stop above the depth reached, or go back to break chips: 1 mm is taken, the "
               "control has its own");
    if (c.hole == Hole::feed_out)
        assume(s, c.begin, c.end, "the way out of REAM and BORE is taken at feed, to the clearance, the rest at rapid");
    return {};
}

/// DEEP and BRKCHP behind DRILL (NX): the word that says the cycle then.
std::optional<Hole> second_kind(const Arguments& a, Hole first) {
    if (first != Hole::drill || a.begin() + 2 >= a.end()) return std::nullopt;
    const dialect::apt::HoleWord* word = dialect::apt::find_hole(upper_of(a.begin()[2]));
    const bool steps = word != nullptr && (word->hole == Hole::peck || word->hole == Hole::chip_break);
    return steps ? std::optional(word->hole) : std::nullopt;
}

/// What the words of `c` come to; a complaint in its place where they do not.
void begin_series(State& s, HoleCycle c, std::string fault) {
    if (fault.empty()) fault = take_heights(s, c);
    if (fault.empty()) fault = take_kind(s, c);
    c.refused = !fault.empty();
    if (c.refused) refuse(s, fault);
    s.cycle = s.last_cycle = c;
}

/// CYCLE/ON: the cycle before it again, other numbers in the place of its own.
void call_again(State& s, const Arguments& a) {
    if (!s.last_cycle) return fail(s, a.begin(), "CYCLE/ON calls the cycle before it, and there is none");
    HoleCycle c;
    c.hole = s.last_cycle->kind;
    c.kind = c.hole;
    c.said = s.last_cycle->said;
    c.begin = s.line.begin;
    c.end = s.line.end;
    end_series(s);
    const bool known = s.last_cycle->named;
    c.named = known;
    std::string fault = known ? read_couplets(s, c.said, a, 1) : "the cycle before it is not known here";
    begin_series(s, c, std::move(fault));
}

}  // namespace

void read_cycle(State& s, const Arguments& a) {
    if (a.begin() == a.end() || a.begin()->kind != TokenKind::word) return fail(s, a.begin(), "CYCLE wants a word");
    drop_circle(s);
    const std::string word = upper_of(*a.begin());
    const bool starts_none = word == "INIT" || word == "CLEAR";  // SolidWorks CAM, before a cycle: none is in force
    if (word == "OFF" || word == "NOMORE" || starts_none) {
        refuse_rest(s, a, 1);
        end_series(s);
        if (starts_none) s.build.ignored("CYCLE/" + word, s.line.begin, s.line.end);
        return;
    }
    if (word == "ON") return call_again(s, a);
    end_series(s);
    HoleCycle c;
    c.begin = s.line.begin;
    c.end = s.line.end;
    const dialect::apt::HoleWord* known = dialect::apt::find_hole(word);
    if (known == nullptr) return begin_series(s, c, "what CYCLE/" + word + " does is not known here");
    c.named = true;
    const std::optional<Hole> second = second_kind(a, known->hole);
    c.hole = c.kind = second.value_or(known->hole);
    std::string fault = read_couplets(s, c.said, a, second ? 2 : 1);
    begin_series(s, c, std::move(fault));
}

}  // namespace obrys::read::apt
