/// Every word of a block is acted on or said: what no handler took, and what the block has twice.
/// BlockWords::get marks a word as used; who only looks at one takes `peek`.

#include <bit>

#include "base/codes.hpp"
#include "base/text.hpp"
#include "interp/calls/calls.hpp"
#include "program/modal_group.hpp"

namespace obrys::interp {

namespace codes = base::codes;
using program::ModalGroup;
using program::Repeated;
using program::Word;

namespace {

/// Words that act by standing there: they have no value to take.
constexpr std::uint64_t bare_words = bit(Code::tool_change) | bit(Code::tool_definition) | bit(Code::feed_auto) |
                                     bit(Code::cycle_call) | bit(Code::cycle_call_modal);

std::string text_of(const Saying& run, const base::Span& where) {
    return std::string(base::trim(run.env.sources.text(where)));
}

/// The n-th word of the block with this code, from 0; the block where there is none.
base::Span place_of(const Reckoning& run, Code code, int n) {
    const Unit& unit = run.unit();
    const auto index = static_cast<std::uint32_t>(run.statement - unit.statements.data());
    for (std::uint32_t i = run.statement->first; i < unit.words_end(index); ++i)
        if (program::code_of(unit.words[i]) == code && n-- == 0) return unit.span(*run.statement, unit.words[i]);
    return run.here();
}

std::uint64_t codes_of(std::string_view letters) {
    std::uint64_t codes = 0;
    for (const char c : letters)
        codes |= bit(c == 'P' ? Code::p : c == 'Q' ? Code::q : c == 'E' ? Code::e : c == 'L' ? Code::l : Code::radius);
    return codes;
}

/// Words that belong to one of the control's own M functions.
std::uint64_t words_of_function(const Saying& run, int m) {
    for (const program::FunctionLetters& f : run.traits->function_letters)
        if (m >= f.first && m <= f.last) return codes_of(f.letters);
    return 0;
}

bool is_builders(const Saying& run, int m) { return m >= 10 && m != 17 && m != 30 && !is_standard_function(run, m); }

/// A word that the block's motion has left may be meant for an M function of the machine builder: it is listed.
void give_to_builder(Moving& run, int m, std::uint64_t words) {
    for (; words != 0; words &= words - 1) {
        const auto code = static_cast<Code>(std::countr_zero(words));
        run.block.use(code);
        const base::Span where = place_of(run, code, 0);
        assume(run, where,
               text_of(run, where) + " is taken as a word of M" + std::to_string(m) +
                   ", a function of the machine builder");
    }
}

void take_function_words(Moving& run) {
    const BlockWords& b = run.block;
    for (const int m : b.m) b.used |= b.present & words_of_function(run, m);
    const std::uint64_t letters = codes_of(run.traits->builders_letters);
    for (const int m : b.m)
        if (is_builders(run, m)) give_to_builder(run, m, b.present & ~b.used & letters);
}

/// I, J, K of 0 that an arc does not need say nothing that could be missed.
bool says_nothing(const BlockWords& b, Code c) {
    return (c == Code::i || c == Code::j || c == Code::k) && b.peek(c) == 0;
}

/// X2=, AX[…]= and their like, beside words that no axis goes with.
void say_unused_axes(Moving& run) {
    for (const BlockWords::NamedAxis& axis : run.block.axes)
        unchecked(run, codes::unknown_word, axis.where,
                  text_of(run, axis.where) + " has no meaning beside the other words of this block and is not run",
                  "take it out, or write the function that it belongs to");
}

}  // namespace

void report_unused(Moving& run) {
    BlockWords& b = run.block;
    if (b.feed_alone && !run.complained && !run.stopped && run.capture == nullptr)
        unchecked(run, codes::unknown_word, run.here(), "FB= has no meaning in this block and is not run",
                  "write it in the block of the path that it is for");
    if (b.thread_start && !run.complained && !run.stopped && run.capture == nullptr)
        unchecked(run, codes::unknown_word, run.here(), "SF= has no meaning in this block and is not run",
                  "write it in the block of a thread (G33, G34, G35)");
    if (!b.axes.empty() && !run.complained && !run.stopped) say_unused_axes(run);
    std::uint64_t left = b.present & ~b.used & ~bare_words;
    if (left == 0 || run.complained || run.stopped) return;
    if (!b.m.empty()) take_function_words(run);
    left &= ~b.used;
    for (; left != 0; left &= left - 1) {
        const auto code = static_cast<Code>(std::countr_zero(left));
        if (says_nothing(b, code)) continue;
        const base::Span where = place_of(run, code, 0);
        unchecked(run, codes::unknown_word, where,
                  text_of(run, where) + " has no meaning beside the other words of this block and is not run",
                  "take it out, or write the function that it belongs to");
    }
}

void repeated_words(Moving& run) {
    for (std::uint64_t left = run.block.twice; left != 0 && !run.stopped; left &= left - 1) {
        const auto code = static_cast<Code>(std::countr_zero(left));
        const base::Span where = place_of(run, code, 1);
        const std::string what = "the block programs an address twice: " + text_of(run, place_of(run, code, 0)) +
                                 " and " + text_of(run, where);
        if (run.traits->repeated_words == Repeated::stops)
            alarm(run, codes::repeated_word, where, what, "leave one of them in the block");
        else
            unchecked(run, codes::repeated_word, where,
                      what + (run.traits->repeated_words == Repeated::last_or_stop
                                  ? ": the control takes the last one, or stops, as one of its parameters says"
                                  : ": the control takes the last one"),
                      "leave one of them in the block");
    }
}

void repeated_group(Moving& run, const Word& w) {
    const ModalGroup group = program::group_of(program::modal_of(w));
    if (group == ModalGroup::none) return;
    const std::uint32_t mark = std::uint32_t{1} << static_cast<unsigned>(group);
    const bool again = (run.block.groups & mark) != 0;
    run.block.groups |= mark;
    if (!again) return;
    const base::Span where = run.unit().span(*run.statement, w);
    const std::string what = text_of(run, where) + " stands in one block with another word of its group";
    if (run.traits->repeated_groups == Repeated::stops)
        return alarm(run, codes::repeated_word, where, what, "write one of them, or two blocks");
    // Of words that act once the first would act, too, and take the same coordinates.
    if (group == ModalGroup::once || run.traits->repeated_groups == Repeated::last_or_stop)
        return unchecked(run, codes::repeated_word, where, what, "write one of them, or two blocks");
    assume(run, where, what + ": the control takes the last one");
}

}  // namespace obrys::interp
