/// Blocks of words: what letters mean beside the G code of the block or that in force.

#include <algorithm>

#include "read/rs274/acramatic_state.hpp"

namespace obrys::read::rs274 {

namespace {

constexpr std::uint64_t every_axis =
    bit(Code::x) | bit(Code::y) | bit(Code::z) | bit(Code::a) | bit(Code::b) | bit(Code::c);
constexpr std::uint64_t feed_speed_tool = bit(Code::feed) | bit(Code::spindle) | bit(Code::tool);
constexpr std::uint16_t retract = 26;  // M
constexpr std::uint64_t centre_letters = bit(Code::i) | bit(Code::j) | bit(Code::k);

/// `(PGM, NAME="X")` names the program; other blocks in brackets are not known.
void read_bracket_block(State& s) {
    const std::uint32_t begin = s.line.here();
    const bool program = base::to_upper(s.line.rest().substr(0, 5)).starts_with("(PGM,");
    const std::size_t close = s.line.rest().find(')');
    if (close == std::string_view::npos) return fail(s, begin, s.line.end(), "this bracket is not closed", "add )");
    s.line.step(close + 1);
    if (!program)
        add_problem(s, Code::unsupported, begin, s.line.behind(), "a command in brackets, of which only PGM is known");
}

/// What would be read as a parameter, an expression or a text of other controls.
void refuse_foreign(State& s) {
    fail_here(s, here(s) + " begins a variable or an expression, which are not read of this control",
              "write the number that it stands for");
}

void read_acramatic_word(State& s) {
    const char c = s.line.peek(), next = s.line.peek(1);
    if (c == '(') return read_bracket_block(s);
    if (c == '#' || c == '[' || c == '$') return refuse_foreign(s);
    if (base::is_letter(c) && (next == '[' || next == '#' || next == '=' || next == '(')) {
        s.line.step();
        return refuse_foreign(s);
    }
    read_word(s);
}

void take_modes(AcramaticState& s) {
    for (const std::uint16_t g : s.facts.g) {
        if (g == 900 || g == 910) s.incremental = g == 910;
        if (g == 700 || g == 710) s.inch = g == 700;
        if (g >= 170 && g <= 190) s.other_plane = g != 170;
    }
}

/// H1 … H9: the fixture offset.
void take_offset(State& s) {
    const auto h = take_letter(s, Code::offset_h);
    if (!h) return;
    s.facts.letters &= ~bit(Code::offset_h);
    constexpr int before_first = 53, most = 9;
    const auto n = as_integer(h->value);
    if (n && *n >= 1 && *n <= most)
        return add_modal(s, Order::datum, Modal::datum, before_first + *n, h->begin, h->end);
    add_problem(s, Code::unsupported, h->begin, h->end, "a fixture offset other than H1 to H9");
}

/// M26: Z goes up to the end of its travel, which is its reference point.
void retract_block(AcramaticState& s) {
    const auto m = std::find_if(s.words.begin(), s.words.end(), [](const BlockWord& w) {
        return w.code == Code::modal && w.modal == Modal::reference_point;
    });
    const std::uint32_t begin = m->begin, end = m->end;
    if ((s.facts.letters & ~feed_speed_tool) != 0 || s.facts.motion != nullptr || s.facts.has_g(40)) {
        add_problem(s, Code::unsupported, begin, end, "M26 beside other motion: which of them is first is not known");
        s.facts.refused = true;
        return;
    }
    Value zero;
    zero.literal.integer = true;
    add_value(s, Order::value, Code::z, zero, begin, end);
    note_assumption(s, begin, end, "M26 is taken to lead Z to its reference point, the upper end of its travel",
                    "give home of Z in the machine file where that is known");
}

/// G4 F: seconds.
void dwell_block(State& s) {
    auto time = take_letter(s, Code::feed);
    if (!time) return fail(s, s.line.begin(), s.line.end(), "G4 does not say how long", "write G4 F1, in seconds");
    s.facts.letters &= ~bit(Code::feed);
    refuse_other_letters(s, feed_speed_tool, "G4");
    if (!s.failed) add_value(s, Order::value, Code::p, time->value, time->begin, time->end);
}

void arc_block(AcramaticState& s) {
    refuse_other_letters(s, every_axis | feed_speed_tool | centre_letters | bit(Code::p), "an arc");
    if (s.failed) return;
    if (auto radius = take_letter(s, Code::p)) {
        if ((s.facts.letters & centre_letters) != 0)
            return fail(s, radius->begin, radius->end, "an arc with P, its radius, and a centre", "write one of them");
        return add_value(s, Order::value, Code::radius, radius->value, radius->begin, radius->end);
    }
    if ((s.facts.letters & centre_letters) == 0) return;
    const std::uint32_t begin = s.words.front().begin;
    if (s.incremental) {
        add_problem(s, Code::unsupported, s.line.begin(), s.line.end(),
                    "the centre of an arc in G91: what I, J and K count from there is not known");
        s.facts.refused = true;
        return;
    }
    add_modal(s, Order::arc_centre, Modal::arc_centre_absolute, 0, begin, begin);
}

/// What the block's own G code moves from here on.
void take_motion(AcramaticState& s) {
    const auto* g = s.facts.motion;
    if (s.facts.refused && g == nullptr) s.moving = Moving::lost;
    if (g == nullptr) return;
    const Moving before = s.moving;
    s.moving = g->modal == Modal::canned_off                             ? Moving::unsaid
               : g->use == Use::canned                                   ? Moving::cycle
               : g->use == Use::unsupported                              ? Moving::lost
               : g->modal == Modal::arc_cw || g->modal == Modal::arc_ccw ? Moving::arc
                                                                         : Moving::straight;
    if (before != Moving::cycle || s.moving == Moving::cycle) return;
    s.tenths = 0;
    for (TableValue& v : s.table) v.fresh = false;
}

/// A block of coordinates by the motion in force.
void motion_block(AcramaticState& s) {
    switch (s.moving) {
        case Moving::unsaid:
            return fail(s, s.line.begin(), s.line.end(),
                        "no motion is in force here, neither said before nor left by G80",
                        "write G0, G1, G2, G3 or a cycle before them");
        case Moving::straight: return refuse_other_letters(s, every_axis | feed_speed_tool, "a straight move");
        case Moving::arc: return arc_block(s);
        case Moving::cycle: return cycle_block(s);
        case Moving::lost:
            add_problem(s, Code::unsupported, s.line.begin(), s.line.end(), "coordinates of a cycle that is not run");
            s.facts.refused = true;
    }
}

}  // namespace

void refuse_other_letters(State& s, std::uint64_t letters, std::string_view user) {
    for (const BlockWord& w : s.words) {
        const bool value = static_cast<unsigned>(w.code) < 64 && (s.facts.letters & bit(w.code)) != 0;
        if (!value || (letters & bit(w.code)) != 0) continue;
        const std::uint32_t begin = w.begin, end = w.end;
        return fail(s, begin, end,
                    std::string(1, base::upper(s.text[begin])) + " is none of the letters that are known of " +
                        std::string(user));
    }
}

void note_assumption(State& s, std::uint32_t begin, std::uint32_t end, std::string text, std::string remedy) {
    base::Diagnostic d;
    d.severity = base::Severity::note;
    d.code = base::codes::assumption;
    d.where = {s.file, begin, end};
    d.text = std::move(text);
    d.remedy = std::move(remedy);
    s.diagnostics.add(std::move(d));
}

void read_acramatic_block(AcramaticState& s) {
    while (!s.failed && !s.line.at_end()) read_acramatic_word(s);
    if (!s.failed) take_cancel(s);
    if (s.failed) return;
    take_modes(s);
    take_motion(s);
    take_offset(s);
    const bool cancels = s.facts.motion != nullptr && s.facts.motion->modal == Modal::canned_off;
    const bool moves =
        (s.facts.letters & ~feed_speed_tool) != 0 || (s.facts.motion != nullptr && s.facts.motion->use == Use::canned);
    if (s.facts.has_m(retract, retract))
        retract_block(s);
    else if (s.facts.has_g(40))
        dwell_block(s);
    else if (cancels && moves)
        fail(s, s.line.begin(), s.line.end(), "coordinates beside G80: what they do there is not known",
             "write them in a block of their own");
    else if (moves && !s.facts.refused)
        motion_block(s);
    emit_block(s);
    for (const std::uint16_t m : s.facts.m) note_end(s, m);
}

}  // namespace obrys::read::rs274
