#include "interp/interp.hpp"

#include "interp/flow/flow.hpp"
#include "interp/flow/machine.hpp"

namespace obrys::interp {

namespace {

bool skipped(const Saying& run, const program::Statement& s) {
    const int level = (s.flags & program::skip_mask) - 1;
    if (level < 0) return false;
    for (const int on : run.env.skip_levels)
        if (on == level) return true;
    return false;
}

/// A block with / is run: once a run it is said that its switch was taken to be off.
void say_not_skipped(Saying& run, const program::Statement& s) {
    const int level = (s.flags & program::skip_mask) - 1;
    assume(run, run.here(), "block skip is taken to be off: the blocks with / are run",
           "where the machine skips them: skip = [" + std::to_string(level) + "] in the job");
}

/// Goes back to the start of a repeated section, or behind the REPEAT when it is done.
void end_of_section(Moving& run) {
    Activation& act = run.top();
    ActiveSection& section = act.sections.back();
    run.plain_kinds.forget();
    if (section.pass > 1) end_part(run);
    if (section.left > 1) {
        --section.left;
        act.pc = section.first;
        begin_part(run, cl::PartKind::repetition, section.name, ++section.pass, section.passes);
        return;
    }
    act.pc = section.back;
    const ActiveSection done = section;
    act.sections.pop_back();
    if (done.finishing != nullptr) end_finishing(run, done);
}

/// Nothing is left of the program at hand.
void end_of_text(RunState& run) {
    const Activation& act = run.top();
    run.plain_kinds.forget();
    const bool due = run.calls.size() == 1 || act.unit->startable || run.traits->text_may_end;
    if (due && !act.is_text && !act.unit->unended.empty()) refuse_end(run);
    if (run.stopped) return;
    if (run.calls.size() == 1) flush_path(run);
    const bool ends = run.calls.size() == 1 && run.traits->text_end_ends_program && run.statement != nullptr;
    if (ends) emit(run, cl::Stop{cl::StopKind::end});
    leave(run);
}

}  // namespace

void step(RunState& run) {
    Activation& act = run.top();
    while (!act.sections.empty() && act.pc == act.sections.back().last + 1 && !run.stopped) end_of_section(run);
    if (run.stopped) return;
    if (act.pc >= act.unit->statements.size()) return end_of_text(run);
    if (act.pc == 0 && !act.is_text && !act.unit->unbegun.empty()) say_missing_beginning(run);
    const std::uint32_t index = act.pc++;
    const program::Statement& s = act.unit->statements[index];
    run.statement = &s;
    if (run.watched.depth != 0 &&
        (index < run.watched.first || index > run.watched.last || run.calls.size() != run.watched.depth))
        run.watched.depth = 0;
    const bool passed_over = s.flags != 0 && skipped(run, s);
    if (!passed_over && !act.unit->remarks.empty())
        for (const program::Remark& remark : act.unit->remarks_of(index))
            emit(run, cl::Comment{remark.text, false, false});
    if (!passed_over && !act.unit->modes.spans.empty() && runs_read_again(run, index)) return;
    if (run.stopped) return;
    if (s.flags != 0) {
        if ((s.flags & program::line_start) != 0) ++run.blocks;
        if (passed_over) return;
        if ((s.flags & program::skip_mask) != 0) say_not_skipped(run, s);
    }
    const bool look = (++run.steps & 0xFF) == 0;
    if ((look || run.out_of_time || run.blocks > run.env.budgets.blocks) && over_budget(run, look)) return;
    run_statement(run, s, index);
}

Outcome run(const program::Unit& main, const Environment& environment, cl::CallStacks& stacks, cl::Sink sink,
            base::Diagnostics& diagnostics) {
    Machine machine(main, environment, stacks, sink, diagnostics);
    while (machine.step()) {
    }
    return machine.finish();
}

}  // namespace obrys::interp
