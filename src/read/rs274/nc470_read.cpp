#include "read/rs274/nc470_read.hpp"

#include <bit>

#include "dialect/rs274/nc470.hpp"
#include "read/rs274/one_part.hpp"
#include "read/rs274/state.hpp"

namespace obrys::read::rs274 {

namespace {

struct Nc470State : State {
    using State::State;
    bool motion_said = false;  ///< G0 or G1 has been
};

constexpr std::uint64_t letters_of(std::initializer_list<Code> codes) {
    std::uint64_t all = 0;
    for (const Code c : codes) all |= program::bit(c);
    return all;
}
constexpr std::uint64_t axis_letters =
    letters_of({Code::x, Code::y, Code::z, Code::a, Code::b, Code::c, Code::u, Code::v, Code::w});
constexpr std::uint64_t known_letters = axis_letters | letters_of({Code::feed, Code::spindle, Code::tool});

/// What would be read as a parameter, an expression or a text of other controls.
bool is_foreign(const State& s) {
    const char c = s.line.peek(), next = s.line.peek(1);
    return c == '#' || c == '[' || c == '$' || c == ';' ||
           (base::is_letter(c) && (next == '[' || next == '#' || next == '=' || next == '('));
}

void read_nc470_word(State& s) {
    if (!is_foreign(s)) return read_word(s);
    fail_here(s, here(s) + " begins something that this control does not have", "its words are a letter and a number");
}

/// The words of letters that are not known, and more than one axis.
void check_letters(State& s) {
    for (const BlockWord& w : s.words) {
        const bool is_letter = static_cast<unsigned>(w.code) < 64 && s.facts.has(w.code);
        if (!is_letter) continue;
        const auto letter = program::bit(w.code);
        if ((letter & known_letters) == 0)
            return fail(
                s, w.begin, w.end,
                std::string(1, base::upper(s.text[w.begin])) + " is none of the letters that are known of NC 470");
        if ((letter & axis_letters) != 0 && std::popcount(s.facts.letters & axis_letters) > 1)
            return fail(s, w.begin, w.end, "this control moves one axis at a time", "write a block for each axis");
    }
}

/// G4 F: seconds.
void take_dwell(State& s) {
    auto time = take_letter(s, Code::feed);
    if (!time) return fail(s, s.line.begin(), s.line.end(), "G4 does not say how long", "write G4 F1, in seconds");
    s.facts.letters &= ~letters_of({Code::feed});
    if ((s.facts.letters & axis_letters) != 0)
        return fail(s, s.line.begin(), s.line.end(), "an axis beside G4", "write a block for each");
    add_value(s, Order::value, Code::p, time->value, time->begin, time->end);
}

/// D: which of the tool's offsets corrects its tip. The words of a program are those of the tip all the same.
void take_offset_number(State& s) {
    const auto d = take_letter(s, Code::offset_d);
    if (!d) return;
    s.facts.letters &= ~letters_of({Code::offset_d});
    const auto n = as_integer(d->value);
    if (!n || *n < 0) fail(s, d->begin, d->end, "D is the number of an offset");
}

void read_nc470_block(Nc470State& s) {
    while (!s.failed && !s.line.at_end()) read_nc470_word(s);
    if (!s.failed) take_offset_number(s);
    if (!s.failed && s.facts.has_g(40))
        take_dwell(s);
    else if (!s.failed)
        check_letters(s);
    if (s.failed) return;
    s.motion_said = s.motion_said || s.facts.motion != nullptr;
    if (!s.motion_said && (s.facts.letters & axis_letters) != 0)
        return fail(s, s.line.begin(), s.line.end(), "no motion has been said before", "write G0 or G1");
    emit_block(s);
    for (const std::uint16_t m : s.facts.m) note_end(s, m);
}

void read_nc470_line(Nc470State& s) {
    s.failed = false;
    begin_words(s);
    if (s.line.at_end() || s.line.rest() == "%") return;
    if (s.part->ended) return say_unreached(s);
    if (s.line.fault() != CommentFault::none)
        return fail(s, s.line.fault_begin(), s.line.fault_begin() + 1, "this bracket is not closed", "add )");
    if (s.line.peek() == '/')
        return fail_here(s, "/ for blocks that may be skipped is not known of this control", "take it out");
    read_block_head(s);
    if (s.failed || s.line.at_end()) return;
    read_nc470_block(s);
}

}  // namespace

std::vector<program::Unit> read_nc470(std::uint32_t file, const base::Sources& sources, program::Names& names,
                                      base::Diagnostics& diagnostics) {
    Nc470State s(file, dialect::rs274::nc470, names, diagnostics, sources);
    return read_one_part(s, diagnostics, read_nc470_line);
}

int nc470_likelihood(std::string_view, std::string_view, std::vector<std::string>*) { return 0; }

}  // namespace obrys::read::rs274
