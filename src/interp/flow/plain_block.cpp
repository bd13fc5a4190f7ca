#include "interp/flow/plain_block.hpp"

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
    for (std::uint32_t i = first; i < end; ++i) {
        const Word& w = unit.words[i];
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
            // A feed of 0 is no feed, and is told.
            if (code == Code::feed && (program::form_of(w) == Form::pooled || w.payload <= 0)) return {};
            const double v = unit.literal(w);
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
           !run.curve.open && !run.cycle.modal && run.modal_call.unit == nullptr && run.underway.empty() &&
           !run.spindle.mode_changed && run.surface.kind == SurfaceMode::Kind::none;
}

std::size_t said(const Saying& run) { return run.diagnostics->all().size() + run.diagnostics->dropped(); }

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
    if (s.motion != nullptr) static_cast<void>(motion_word(run, program::modal_of(*s.motion), *s.motion));
    if (b.has(Code::feed)) technology(run);
    if (run.stopped) return;
    begin_motion(run);
    if (!run.stopped) static_cast<void>(path_motion(run));
    run.path->end_block(run);
    if ((b.present & ~b.used) != 0) report_unused(run);
}

}  // namespace

bool runs_plain_block(Cycling& run, const program::Statement& statement, std::uint32_t index) {
    const std::uint32_t end = run.unit().words_end(index);
    const Scanned s = scan(run, statement.first, end);
    if (s.words == 0) return false;
    const Modal motion = s.motion != nullptr ? program::modal_of(*s.motion) : run.modal.motion;
    PlainKinds::Kind& kind = place_of(run.plain_kinds, s);
    if (kind.words == s.words && kind.motion == motion) return run_as_before(run, statement, s, end), true;
    const std::size_t before = said(run);
    const bool moved = run_block(run, statement, index);
    const bool in_order = moved && !run.stopped && !run.complained && said(run) == before;
    if (in_order && run.block.present == s.present && nothing_else_is_due(run)) {
        kind = {s.words, motion};
        run.plain_kinds.any = true;
    } else {
        run.plain_kinds.forget();
    }
    return true;
}

bool keeps_plain_kinds(const Reckoning& run, const program::Statement& s, std::uint32_t index) {
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
        case StatementKind::block: break;
        default: return false;
    }
    const Unit& unit = run.unit();
    const std::uint32_t end = unit.words_end(index);
    for (std::uint32_t i = s.first; i < end; ++i) {
        if (program::code_of(unit.words[i]) != Code::assign) return false;
        const program::Assign& a = unit.assigns[static_cast<std::size_t>(unit.words[i].payload)];
        const program::Expr& target = unit.exprs[a.target];
        if (target.kind != program::ExprKind::parameter || !is_programs_own(run, target.a)) return false;
    }
    return end > s.first;
}

}  // namespace obrys::interp
