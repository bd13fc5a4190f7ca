#include "interp/flow/plain_block.hpp"

#include <algorithm>
#include <span>

#include "interp/stream/path_stage.hpp"
#include "program/modal_group.hpp"

namespace obrys::interp {

using program::Form;
using program::StatementKind;
using program::Word;

namespace {

constexpr std::uint8_t first_motion = 9;  ///< of G0 … G3 in PlainKinds::Kind::words
constexpr unsigned bits_of_word = 4, most_words = 64 / bits_of_word;

/// What a word is in PlainKinds::Kind::words; 0: its block is none of these.
constexpr std::array<std::uint8_t, 256> word_numbers = [] {
    std::array<std::uint8_t, 256> t{};
    std::uint8_t n = 0;
    for (const Code c : {Code::x, Code::y, Code::z, Code::i, Code::j, Code::k, Code::radius, Code::feed})
        t[static_cast<std::size_t>(c)] = ++n;
    return t;
}();
static_assert(first_motion + static_cast<unsigned>(Modal::arc_ccw) < 1U << bits_of_word);

/// As program::Unit::literal divides; a table in its function is made anew for every word.
constexpr std::array<double, 10> powers_of_ten{1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9};

/// A block's words; the values of those that are literals stand in BlockWords::value already.
struct Scanned {
    std::uint64_t words = 0;    ///< four bits each, in their order; 0: the block is none of these
    std::uint64_t present = 0;  ///< as BlockWords::present
    const Word* motion = nullptr;
    bool computes = false;  ///< has expressions
};

Scanned scan(Moving& run, std::uint32_t first, std::uint32_t end) {
    const Unit& unit = run.unit();
    Scanned s;
    const double increments = increments_of_unit(run);
    if (end - first > most_words) return s;
    for (const Word& w : std::span(unit.words).subspan(first, end - first)) {
        const Code code = program::code_of(w);
        std::uint64_t number = word_numbers[static_cast<std::size_t>(code)];
        if (code == Code::modal) {
            if (s.motion != nullptr || w.payload < 0 || w.payload > static_cast<std::int32_t>(Modal::arc_ccw))
                return {};
            s.motion = &w;
            number = first_motion + static_cast<std::uint64_t>(w.payload);
        } else if (number == 0) {
            return {};
        } else if (program::is_literal(w)) {
            const bool is_short = w.form < powers_of_ten.size();
            // A feed of 0 is no feed, and is told.
            if (code == Code::feed && (!is_short || w.payload <= 0)) return {};
            const double v = is_short ? static_cast<double>(w.payload) / powers_of_ten[w.form] : unit.literal(w);
            run.block.value[static_cast<std::size_t>(code)] = code == Code::feed ? v : in_increments(v, increments);
            run.block.reference[static_cast<std::size_t>(code)] = 0;
        } else {  // one that is empty is as though it were not there
            if (code == Code::feed || program::form_of(w) != Form::expression || run.traits->empty_parameters)
                return {};
            s.computes = true;
        }
        if (code != Code::modal) s.present |= bit(code);
        s.words = s.words << bits_of_word | number;
    }
    return s;
}

PlainKinds::Kind& place_of(PlainKinds& kinds, const Scanned& s) {
    constexpr std::uint64_t factor = 0x9E3779B97F4A7C15U;
    return kinds.kinds[static_cast<std::size_t>(s.words * factor >> 60)];
}

/// Nothing is under way that a move has to do with but the move itself.
bool nothing_else_is_due(const Cycling& run) {
    const BlockWords& b = run.block;
    const bool is_usual = b.special == Modal::linear && b.twice == 0 && (b.present & ~b.used) == 0;
    return is_usual && run.modal.motion <= Modal::arc_ccw && run.modal.feed_mode != cl::FeedMode::inverse_time &&
           !run.curve.open && !run.cycle.modal && !run.modal_call.is_on() && run.underway.empty() &&
           !run.spindle.mode_changed && run.surface.kind == SurfaceMode::Kind::none;
}

std::size_t said(const Saying& run) { return run.diagnostics->all().size() + run.diagnostics->dropped(); }

/// As motion_word, of what its like has not left as it is.
void take_motion(Moving& run, Modal motion) {
    run.modal.motion = motion;
    run.block.says_straight = motion <= Modal::linear;
    if (motion > Modal::linear) run.modal.last_sense = motion;
}

/// The block moves; all that stands before a move was found to be in order when its like was run.
void run_as_before(Cycling& run, const program::Statement& statement, const Scanned& s, std::uint32_t end) {
    BlockWords& b = run.block;  // but for these as the block before has left it, which was plain
    run.complained = false;
    b.used = b.present = 0;
    if (s.computes) {
        for (std::uint32_t i = statement.first; i < end && !run.stopped; ++i)
            if (const Word& w = run.unit().words[i]; program::form_of(w) == Form::expression)
                put_expression(run, statement, w);
        if (run.stopped) return;
    }
    b.present = s.present;
    b.groups = s.motion == nullptr ? 0 : std::uint32_t{1} << static_cast<unsigned>(program::ModalGroup::motion);
    b.says_straight = false;
    if (s.motion != nullptr) take_motion(run, program::modal_of(*s.motion));
    if (b.has(Code::feed)) technology(run);
    if (run.stopped) return;
    const bool judged = run.offsets.length_judged || !keeps_offsets(run);
    if (!run.told.current || !judged) begin_motion(run);  // all else that it looks at, its like has settled
    if (!run.stopped) static_cast<void>(path_motion(run));
    run.path->end_block(run);
    if ((b.present & ~b.used) != 0) report_unused(run);
}

/// Runs the block with all that there is to look at, and knows its kind from there on, where nothing else was met.
void run_first(Cycling& run, const program::Statement& statement, std::uint32_t index, const Scanned& s,
               const PlainKinds::Kind& kind) {
    const std::size_t before = said(run);
    const bool moved = run_block(run, statement, index);
    const bool in_order = moved && !run.stopped && !run.complained && said(run) == before;
    if (in_order && run.block.present == s.present && nothing_else_is_due(run)) {
        place_of(run.plain_kinds, s) = kind;
        run.plain_kinds.any = true;
    } else {
        run.plain_kinds.forget();
    }
}

}  // namespace

bool runs_plain_block(Cycling& run, const program::Statement& statement, std::uint32_t index) {
    const std::uint32_t end = run.unit().words_end(index);
    const Scanned s = scan(run, statement.first, end);
    if (s.words == 0) return false;
    const Modal motion = s.motion != nullptr ? program::modal_of(*s.motion) : run.modal.motion;
    const PlainKinds::Kind& kind = place_of(run.plain_kinds, s);
    if (kind.words == s.words && kind.motion == motion)
        run_as_before(run, statement, s, end);
    else
        run_first(run, statement, index, s, {s.words, motion});
    return true;
}

bool keeps_plain_kinds(const program::Statement& s) {
    switch (s.kind) {
        case StatementKind::if_:
        case StatementKind::else_:
        case StatementKind::endif:
        case StatementKind::while_:
        case StatementKind::endwhile:
        case StatementKind::repeat_:
        case StatementKind::until:
        case StatementKind::loop_:
        case StatementKind::endloop: return true;
        default: return false;
    }
}

namespace {

bool assigns_own(const Reckoning& run, const Word& w) {
    const Unit& unit = run.unit();
    if (program::code_of(w) != Code::assign) return false;
    const program::Expr& target = unit.exprs[unit.assigns[static_cast<std::size_t>(w.payload)].target];
    return target.kind == program::ExprKind::parameter && is_programs_own(run, target.a);
}

}  // namespace

bool runs_assignments(Calling& run, const program::Statement& s, std::uint32_t index) {
    if (s.kind != StatementKind::block || run.look != Look::no) return false;
    const std::uint32_t end = run.unit().words_end(index);
    const auto words = std::span(run.unit().words).subspan(s.first, end - s.first);
    const auto is_own = [&](const Word& w) { return assigns_own(run, w); };
    if (words.empty() || !std::all_of(words.begin(), words.end(), is_own)) return false;
    run.complained = false;
    for (const Word& w : words) {
        gather(run, s, w);
        if (run.stopped) return true;
    }
    if (!run.block.pending.empty()) take_effect(run);
    return true;
}

}  // namespace obrys::interp
