/// Branches, loops and jumps.

#include "interp/flow/flow.hpp"
#include "base/text.hpp"
#include "interp/flow/plain_block.hpp"

namespace obrys::interp {

using program::Statement;
using program::StatementKind;

namespace {

/// The cycle, and the words of its block that do not belong to it.
void cycle_definition(Cycling& run, const program::Statement& s, std::uint32_t index) {
    const Unit& unit = run.unit();
    define_cycle(run, unit.cycles[static_cast<std::size_t>(unit.words[s.first].payload)]);
    for (std::uint32_t w = s.first + 1; w < unit.words_end(index) && !run.stopped; ++w) gather(run, s, unit.words[w]);
}

/// What the program has written to end: "M99", "RET", "return" of `o100 return`.
std::string return_word(const Reckoning& run, const Statement& s) {
    const std::string text(run.env.sources.text(run.unit().span(s, run.unit().words[s.first])));
    const std::string word = base::to_upper(text.substr(0, text.find_first_of(" \t(;")));
    return word.starts_with('O') ? "return" : word;
}

/// The main program would begin anew: one pass of it has been run.
bool return_repeats(const Reckoning& run, const Statement& s) {
    return run.calls.size() == 1 && !run.traits->repeats_program.empty() &&
           return_word(run, s) == run.traits->repeats_program;
}

/// Kinds that are run elsewhere and have no entry in a table; false where `s` is none of them.
bool run_plain(Cycling& run, const Statement& s, std::uint32_t index) {
    switch (s.kind) {
        case StatementKind::block: run_block(run, s, index); return true;
        case StatementKind::frame: frame_statement(run, s, index); return true;
        case StatementKind::special: run_special(run, s, index); return true;
        case StatementKind::return_: {
            const auto to = static_cast<std::size_t>(run.unit().words[s.first].payload);
            // Often the same one comes again: the program's text is not asked then.
            if (!run.ends_told.contains({run.top().unit, run.top().pc})) say_blocks_behind(run, return_word(run, s));
            if (to == 0) {
                leave(run);
                run.repeats = run.stopped && run.ending == Ending::regular && return_repeats(run, s);
                return true;
            }
            return return_to_block(run, run.unit().jumps[to - 1]), true;
        }
        case StatementKind::label_end: end_label(run); return true;
        default: return false;
    }
}

void run_by_kind(Cycling& run, const Statement& s, std::uint32_t index) {
    const Unit& unit = run.unit();
    if (run.look > Look::next_element && say_foreign_statement(run, s)) return;
    if (run_plain(run, s, index)) return;
    const auto table = static_cast<std::size_t>(unit.words[s.first].payload);
    switch (s.kind) {
        case StatementKind::if_:
        case StatementKind::while_: {
            const program::Branch& b = unit.branches[table];
            if (!owns_label(run, b, index)) return;
            const bool yes = truth(run, b.condition);
            if (!run.stopped && !yes) go_on_at(run, b.target);
            if (!yes && s.kind == StatementKind::while_) pass_over(run, b);
            return;
        }
        case StatementKind::else_: go_on_at(run, unit.branches[table].target); return;
        case StatementKind::repeat_: static_cast<void>(owns_label(run, unit.branches[table], index)); return;
        case StatementKind::endif:
        case StatementKind::loop_: return;
        case StatementKind::endwhile:
        case StatementKind::endloop:
            if (unit.branches[table].target != program::no_target) go_back(run, unit.branches[table].target);
            return;
        case StatementKind::until: {
            const program::Branch& b = unit.branches[table];
            const bool done = ends_do(run, truth(run, b.condition, true));  // an unknown UNTIL must not loop for ever
            if (!run.stopped && !done && b.target != program::no_target) go_back(run, b.target);
            return;
        }
        case StatementKind::repeat_count: begin_repeat(run, unit.branches[table], index); return;
        case StatementKind::end_repeat_count: end_repeat(run, unit.branches[table]); return;
        case StatementKind::for_: begin_for(run, unit.fors[table], index); return;
        case StatementKind::endfor: end_for(run, unit.fors[table]); return;
        case StatementKind::case_: run_case(run, unit.cases[table]); return;
        case StatementKind::jump: jump(run, unit.jumps[table]); return;
        case StatementKind::repeat_section: repeat_section(run, unit.sections[table], index); return;
        case StatementKind::label_call: return call_label(run, unit.label_calls[table], index);
        case StatementKind::cycle_definition: return cycle_definition(run, s, index);
        case StatementKind::pattern: return define_pattern(run, unit.patterns[table]);
        case StatementKind::contour: return contour_statement(run, unit.contours[table]);
        case StatementKind::call: call_program(run, unit.calls[table]); return;
        case StatementKind::procedure: procedure(run, unit.procedures[table]); return;
        case StatementKind::define:
            if (!run.top().is_text) judge_place_of_definition(run, unit, index);
            return define(run, unit.defines[table], run.top().locals, unit);
        default: return;
    }
}

/// Any other than a plain block.
void run_other(Cycling& run, const Statement& s, std::uint32_t index) {
    if (run.plain_kinds.any && runs_assignments(run, s, index)) return;
    const bool keeps = run.plain_kinds.any && keeps_plain_kinds(s);
    if (!keeps) run.plain_kinds.forget();
    run_by_kind(run, s, index);
    if (!keeps) run.plain_kinds.forget();  // of blocks that it has run itself
}

}  // namespace

void run_statement(Cycling& run, const Statement& s, std::uint32_t index) {
    if (run.block.motion_behind) settle_motion(run);
    if (!begins_plain(run, s) || !runs_plain_block(run, s, index)) run_other(run, s, index);
}

}  // namespace obrys::interp
