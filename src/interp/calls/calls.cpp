/// Calls of programs, their arguments, and the control's own procedures.

#include <algorithm>
#include <cmath>

#include "base/codes.hpp"
#include "interp/calls/calls.hpp"
#include "interp/stream/path_stage.hpp"

namespace obrys::interp {

using program::Call;
namespace codes = base::codes;

namespace {

/// Complaints and lists that belong to a program as a whole, once when it is first entered.
void note_unit(Calling& run, const Unit& unit) {
    if (run.look == Look::next_element) return;  // the run comes here again
    if (!run.entered.insert(&unit).second) return;
    for (const program::Ignored& i : unit.ignored)
        run.diagnostics->add(
            {base::Severity::note,
             codes::no_effect,
             i.where,
             i.text + " has no effect on the path" + (i.count > 1 ? " (" + std::to_string(i.count) + " times)" : ""),
             {},
             {},
             {}});
}

}  // namespace

std::optional<std::uint64_t> repeats_of(Reckoning& run, const Call& call, const base::Span& where) {
    if (call.passes == program::no_expr) return 0;
    const double passes = number(run, call.passes);
    if (std::isnan(passes))
        unchecked(run, codes::unknown_value, where, "how often this call is made depends on a value that is not known");
    if (!(passes >= 1)) return std::nullopt;
    return times_of(passes) - 1;
}

namespace {

/// The program just called begins with block number `n`; false after an alarm.
bool begin_at(Saying& run, double n, const base::Span& where) {
    const std::vector<std::uint32_t> at = numbered_statements(run, n);
    if (!at.empty()) {
        run.top().entry = run.top().pc = at.front();
        return true;
    }
    alarm(run, codes::missing_label, where,
          "the program " + run.unit().name + " has no block N" + printed(Value::real(n)) + " to begin with");
    return false;
}

/// Traits::dimensions_per_program.
void begin_dimensions(Reckoning& run) {
    run.modal.absolute = true;
    run.modal.cartesian_path = false;
    run.modal.paraxial = Modal::paraxial;
}

void end_dimensions(Moving& run, const ModalState& caller) {
    settle_motion(run);
    run.modal.absolute = caller.absolute;
    run.modal.paraxial = caller.paraxial;
    run.modal.motion = caller.motion;
    run.modal.motion_number = caller.motion_number;
    run.modal.cartesian_path = caller.cartesian_path;
}

}  // namespace

void enter(Calling& run, const Unit& unit, const Call* call, const base::Span& where, std::uint64_t repeats) {
    if (run.calls.size() >= run.env.budgets.call_depth) {
        unchecked(run, codes::budget, where,
                  "programs call each other more than " + std::to_string(run.env.budgets.call_depth) + " levels deep",
                  "the control allows no more; raise call_depth in [budget] of the job if yours does");
        run.stopped = true;
        run.ending = Ending::budget;
        return;
    }
    if (const std::uint32_t most = run.traits->call_levels; most != 0 && run.calls.size() >= most)
        return alarm(run, codes::syntax, where,
                     "programs call each other more than " + std::to_string(most - 1) + " levels deep",
                     "the control allows no more: call fewer from each other");
    const std::uint32_t common = run.traits->common_call_levels;
    if (common != 0 && run.calls.size() > common)
        assume(run, where,
               "programs call each other more than " + std::to_string(common) +
                   " levels deep, at which some series of the control stop: this one is taken to go on",
               "call fewer from each other");
    settle_motion(run);
    Activation callee;
    callee.unit = &unit;
    callee.stack = run.calls.empty() ? 0 : run.stacks->push(run.top().stack, where);
    callee.saves = unit.save;
    callee.saved = run.modal;
    if (call != nullptr && run.traits->argument_parameters == 0) bind_arguments(run, unit, *call, callee);
    const auto more = call != nullptr ? repeats_of(run, *call, where) : std::optional(repeats);
    if (!more || run.stopped) return;
    callee.repeats = callee.repeats_left = *more;
    const double first = call != nullptr && call->first_block != program::no_expr ? number(run, call->first_block) : -1;
    const bool main = run.calls.empty();
    hide_locals(run, unit, callee);
    pass_arguments(run, call, callee);
    if (run.stopped) return;
    if (!main) begin_part(run, cl::PartKind::call, unit.name, 1, callee.repeats + 1, callee.arguments);
    run.calls.push_back(std::move(callee));
    if (call != nullptr && call->first_block != program::no_expr && !begin_at(run, first, where)) return;
    if (unit.traits->unit_per_program) run.modal.inch_geometry = run.modal.inch_feed = unit.inch;
    if (unit.traits->dimensions_per_program && !main) begin_dimensions(run);
    if (main) bind_main_arguments(run, unit);
    bind_presets(run, unit);
    run.top().own_bindings = run.top().locals.size();
    note_unit(run, unit);
}

namespace {

/// The modal state SAVE brings back; what the stream has to be told again is told.
void restore(Telling& run, const ModalState& saved) {
    flush_path(run);
    if (saved.feed_mode != run.modal.feed_mode) {
        run.feed_valid = false;
        run.feed_dropped = true;
    }
    const bool mode = saved.surface_speed != run.modal.surface_speed;
    run.modal = saved;
    if (mode) {
        std::swap(run.spindle.speed, run.spindle.surface);
        run.spindle.mode_changed = true;
    }
    update_frame(run);
}

/// What a program called by G66 leaves in its own parameters is there at its next call: the arguments are set once, by
/// G66 (FANUC B-63684EN, 16.7.2, limitations of modal calls).
void keep_modal_parameters(Calling& run) {
    auto& kept = run.modal_call.parameters;
    for (std::uint32_t n = 1; n <= kept.size(); ++n) kept[n - 1] = {run.parameters.get(n), run.parameters.is_set(n)};
}

/// The block that called a label behind which there is no LBL 0 at all; a jump out of a label is no mistake.
std::uint32_t unended_label(const Activation& act) {
    for (const LabelReturn& r : act.labels) {
        const std::uint32_t call = r.pc - 1;
        if (act.unit->statements[call].kind != program::StatementKind::label_call) continue;  // a contour's label
        const auto index = static_cast<std::size_t>(act.unit->words[act.unit->statements[call].first].payload);
        const std::uint32_t target = act.unit->label_calls[index].target;
        if (target == program::no_target) continue;
        const auto from = act.unit->statements.begin() + static_cast<std::ptrdiff_t>(target);
        const auto is_end = [](const program::Statement& s) { return s.kind == program::StatementKind::label_end; };
        if (std::none_of(from, act.unit->statements.end(), is_end)) return call;
    }
    return program::no_target;
}

/// What is repeated when the program is left.
void end_sections(Telling& run) {
    for (const ActiveSection& s : run.top().sections)
        if (s.pass > 1) end_part(run);
}

}  // namespace

void leave(Calling& run) {
    Activation& act = run.top();
    if (act.is_piece) {
        run.calls.pop_back();
        run.statement = &run.unit().statements[run.top().pc - 1];
        return;
    }
    if (const std::uint32_t call = unended_label(act); call != program::no_target)
        return alarm(run, codes::missing_label, act.unit->span(act.unit->statements[call]),
                     "the program ends before the LBL 0 of the label that is called here");
    if (act.repeats_left > 0) {
        --act.repeats_left;
        act.pc = act.entry;
        end_sections(run);
        end_part(run);
        begin_part(run, cl::PartKind::call, act.unit->name, act.repeats + 1 - act.repeats_left, act.repeats + 1,
                   act.arguments);
        act.sections.clear();
        act.locals.truncate(act.own_bindings);
        return;
    }
    if (act.saves) restore(run, act.saved);
    if (act.restores_modes && run.calls.size() > 1) restore_modes(run);
    if (run.calls.size() == 1) {
        run.stopped = true;
        return;
    }
    end_sections(run);
    end_part(run);
    show_locals(run, act);
    if (run.traits->dimensions_per_program) end_dimensions(run, act.saved);
    if (act.from_modal_call) keep_modal_parameters(run);
    return_arguments(run, act);
    run.calls.pop_back();
    if (run.unit().traits->unit_per_program) run.modal.inch_geometry = run.modal.inch_feed = run.unit().inch;
    run.statement = &run.unit().statements[run.top().pc - 1];
}

void return_to_block(Calling& run, const program::Jump& j) {
    if (run.calls.size() == 1) return jump(run, j);
    const double n = number(run, j.destination);
    const base::Span where = run.unit().span(j.destination);
    if (run.stopped) return;
    if (run.top().repeats_left > 0) return leave(run);
    leave(run);
    while (!run.stopped && run.top().is_piece) leave(run);
    if (run.stopped) return;
    const std::vector<std::uint32_t> at = numbered_statements(run, n);
    if (std::isnan(n) || at.empty())
        return alarm(
            run, std::isnan(n) ? codes::unknown_value : codes::missing_label, where,
            "the calling program " + run.unit().name + " has no block N" + printed(Value::real(n)) + " to go on with");
    const auto behind = std::find_if(at.begin(), at.end(), [&](std::uint32_t s) { return s >= run.top().pc; });
    const std::uint32_t target = behind != at.end() ? *behind : at.front();
    if (target < run.top().pc) count_pass(run, program::no_target);
    run.top().pc = target;
}

void call_program(Calling& run, const Call& call) {
    if (call.kind == program::CallKind::modal_end) {
        run.modal_call = {};
        return;
    }
    if (run.traits->calls_end_compensation && run.modal.compensation != Modal::compensation_off) {
        flush_path(run);
        switch_compensation_off(run);
        run.modal.look_ahead = 0;
    }
    std::string name;
    base::Span where = call.where;
    if (call.target != program::no_expr) {
        const Value v = evaluate(run, call.target);
        if (run.stopped) return;
        if (v.is_unknown())
            return unchecked(run, codes::unknown_value, run.unit().span(call.target),
                             "which program is called depends on a value that is not known: the call is left out");
        if (!v.is_text() && !run.traits->programs_by_number)
            return alarm(run, codes::type_mismatch, run.unit().span(call.target),
                         "CALL needs a text that names a program");
        name = v.is_text() ? program_name(v.as_text()) : "O" + printed(Value::real(std::trunc(v.number)));
    } else {
        name = run.env.names.text(call.name);
    }
    if (call.control_cycle != program::ControlCycle::none && run.env.find_program(name) == nullptr)
        return control_cycle(run, call);
    const Unit* unit = find_program(run, name, where, &call);
    if (unit == nullptr && call.kind == program::CallKind::modal) run.modal_call = {};
    if (unit == nullptr) return;
    if (call.kind == program::CallKind::modal) {
        set_modal_call(run, *unit, call);
        return;
    }
    enter(run, *unit, &call, where);
}

}  // namespace obrys::interp
