#include "interp/interp.hpp"
#include "interp/cycle_call.hpp"

#include <cmath>

#include "base/codes.hpp"
#include "base/number.hpp"
#include "base/text.hpp"
#include "base/whole.hpp"
#include "interp/capture.hpp"
#include "interp/path_stage.hpp"

namespace obrys::interp {

namespace codes = base::codes;

namespace {

/// The coordinates the machine starts with: unknown, except axes a lathe or mill does not have.
geom::Vec3 start_position(const shop::Machine& machine) {
    geom::Vec3 p{unknown_number, unknown_number, unknown_number};
    if (machine.axes.empty()) {
        if (machine.kind == shop::MachineKind::lathe) p.y = 0;
        return p;
    }
    for (int k = 0; k < 3; ++k) {
        const char name = "XYZ"[k];
        bool exists = false;
        for (const shop::MachineAxis& a : machine.axes) exists = exists || (a.name.size() == 1 && a.name[0] == name);
        if (!exists) coordinate(p, k) = 0;
    }
    return p;
}

void take_overrides(Run& run, const program::Traits& main_traits) {
    const std::uint32_t n = run.parameters.count();
    run.parameter_overridden.assign(n, 0);
    run.parameter_override.assign(n, 0);
    for (const shop::Override& o : run.env.overrides) {
        const std::uint32_t number = program::find_parameter(main_traits, o.name);
        if (number < n) {
            run.parameter_overridden[number] = 1;
            run.parameter_override[number] = o.value;
        } else {
            run.overrides_by_name[run.env.names.id(o.name)] = o.value;
        }
    }
}

void define_globals(Run& run) {
    for (const Unit* unit : run.env.definitions) {
        run.calls.push_back({});
        run.calls.back().unit = unit;
        for (const program::Statement& s : unit->statements) {
            run.statement = &s;
            if (s.kind == program::StatementKind::define && !run.stopped)
                define(run, unit->defines[static_cast<std::size_t>(unit->words[s.first].payload)], run.globals, *unit);
        }
        run.calls.pop_back();
    }
}

/// The first preset that a cycle of the program selects by a plain number.
std::uint32_t first_preset(const Run& run, const Unit& main) {
    for (const program::CycleDefinition& c : main.cycles)
        for (const program::CycleSetting& s : c.settings) {
            if (s.role != cl::CycleRole::preset_number || main.exprs[s.value].kind != program::ExprKind::number)
                continue;
            const double n = main.numbers[main.exprs[s.value].a];
            if (const auto preset = base::whole<std::uint32_t>(n, 0, 99'999)) return run.traits->datum.first + *preset;
        }
    return program::no_datum;
}

/// The stream's coordinates are in the first settable datum that the main program selects.
void choose_reference_datum(Run& run, const Unit& main) {
    if (keeps_offsets(run)) {
        run.modal.datum = 54;
        for (const program::Word& w : main.words)
            if (program::code_of(w) == Code::modal && program::modal_of(w) >= Modal::tool_length &&
                program::modal_of(w) <= Modal::tool_length_added)
                run.offsets.compensates = true;
        return begin_offsets(run);
    }
    for (const program::Word& w : main.words) {
        if (program::code_of(w) != Code::modal || program::modal_of(w) != Modal::datum ||
            program::modal_number(w) == 500)
            continue;
        run.reference_datum = static_cast<std::uint32_t>(program::modal_number(w));
        break;
    }
    if (run.reference_datum == program::no_datum) run.reference_datum = first_preset(run, main);
    update_frame(run);
}

}  // namespace

bool over_budget(Run& run, bool check_clock) {
    const shop::Budgets& b = run.env.budgets;
    const auto seconds = [&] { return b.bounds_check ? run.time.by_clock() : run.time.by_processor(); };
    run.out_of_time = run.out_of_time || (check_clock && seconds() > b.seconds);
    if (run.blocks <= b.blocks && !run.out_of_time) return false;
    const std::string limit = run.blocks > b.blocks
                                  ? std::to_string(b.blocks) + " blocks"
                                  : base::shortest(b.seconds) + (b.bounds_check ? " s" : " s of work");
    const std::string loop = loop_being_run(run);
    unchecked(run, codes::budget, run.here(),
              "the run was ended here after " + limit + (loop.empty() ? "" : "; " + loop),
              std::string(loop.empty() ? "" : "see whether that loop ends; ") +
                  "raise the limit in [budget] of the job if the program really needs more");
    run.ending = Ending::budget;
    run.stopped = true;
    return true;
}

namespace {

bool skipped(const Run& run, const program::Statement& s) {
    const int level = (s.flags & program::skip_mask) - 1;
    if (level < 0) return false;
    for (const int on : run.env.skip_levels)
        if (on == level) return true;
    return false;
}

/// A block with / is run: once a run it is said that its switch was taken to be off.
void say_not_skipped(Run& run, const program::Statement& s) {
    const int level = (s.flags & program::skip_mask) - 1;
    assume(run, run.here(), "block skip is taken to be off: the blocks with / are run",
           "where the machine skips them: skip = [" + std::to_string(level) + "] in the job");
}

/// Goes back to the start of a repeated section, or behind the REPEAT when it is done.
void end_of_section(Run& run) {
    Activation& act = run.top();
    ActiveSection& section = act.sections.back();
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

}  // namespace

void begin_repetition(Run& run, ActiveSection section) {
    section.pass = 2;
    section.passes = section.left + 1;
    begin_part(run, cl::PartKind::repetition, section.name, section.pass, section.passes);
    run.top().pc = section.first;
    run.top().sections.push_back(std::move(section));
}

Run::Run(const Environment& e, cl::CallStacks& s, cl::Sink k, base::Diagnostics& d, std::uint32_t parameter_count)
    : RunState(e.tools, parameter_count, start_position(e.machine)),
      env(e),
      stacks(s),
      zero(k),
      sink(zero),
      diagnostics(d) {
    path = std::make_unique<PathStage>();
    for (const shop::MachineAxis& axis : e.machine.axes)
        for (int i = 0; i < 9; ++i)
            if (axis.name == axis_name(i)) known_axes |= std::uint64_t{1} << static_cast<unsigned>(axis_code(i));
    modal.plane = e.machine.defaults.plane;
    modal.inch_geometry = modal.inch_feed = e.machine.defaults.inch;
    modal.diameter = e.machine.defaults.diameter_programming ? DiameterMode::on : DiameterMode::off;
    modal.feed_mode = e.machine.defaults.feed_per_rev ? cl::FeedMode::per_rev : cl::FeedMode::per_minute;
}

Run::~Run() = default;

void step(Run& run) {
    Activation& act = run.top();
    while (!act.sections.empty() && act.pc == act.sections.back().last + 1 && !run.stopped) end_of_section(run);
    if (run.stopped) return;
    if (act.pc >= act.unit->statements.size()) {
        const bool due = run.calls.size() == 1 || act.unit->startable || run.traits->text_may_end;
        if (due && !act.is_text && !act.unit->unended.empty()) refuse_end(run);
        if (run.stopped) return;
        if (run.calls.size() == 1) flush_path(run);
        const bool ends = run.calls.size() == 1 && run.traits->text_end_ends_program && run.statement != nullptr;
        if (ends) emit(run, cl::Stop{cl::StopKind::end});
        leave(run);
        return;
    }
    if (act.pc == 0 && !act.is_text && !act.unit->unbegun.empty()) say_missing_beginning(run);
    const std::uint32_t index = act.pc++;
    const program::Statement& s = act.unit->statements[index];
    run.statement = &s;
    if (run.watched.depth != 0 &&
        (index < run.watched.first || index > run.watched.last || run.calls.size() != run.watched.depth))
        run.watched.depth = 0;
    const bool passed_over = s.flags != 0 && skipped(run, s);
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

namespace {

/// Diameters, the plane of X and Z, feed per revolution; they count as said.
void begin_as_lathe(ModalState& m) {
    m.diameter = DiameterMode::on;
    m.plane = 18;
    m.plane_said = true;
    m.feed_mode = cl::FeedMode::per_rev;
    for (const Modal word : {Modal::diameter_on, Modal::plane_zx, Modal::feed_per_rev})
        m.groups_said |= std::uint32_t{1} << static_cast<unsigned>(program::group_of(word));
}

}  // namespace

Outcome run(const program::Unit& main, const Environment& environment, cl::CallStacks& stacks, cl::Sink sink,
            base::Diagnostics& diagnostics) {
    Run run(environment, stacks, sink, diagnostics, program::parameter_count(*main.traits));
    run.traits = main.traits;
    if (main.traits->radius_at_start) run.modal.diameter = DiameterMode::off;
    if (main.traits->radius_at_start && environment.machine.more_axes) {  // a machine that is guessed says nothing
        run.modal.plane = 17;
        run.modal.feed_mode = cl::FeedMode::per_minute;
    }
    if (main.traits->begins_as_lathe) begin_as_lathe(run.modal);
    run.modes = main.modes.begin;
    run.modal.clear_to_retract_plane = main.traits->clearance_at_start;
    if (main.traits->feed_at_tool_first) run.modal.feed_reference = Modal::feed_at_tool;
    if (main.traits->rapid_at_start) run.modal.motion = Modal::rapid;
    if (main.traits->cancel_leaves_no_motion) run.modal.motion = Modal::canned_off;
    if (main.traits->variables_by_assignment)
        for (const char* name : {"_VALUE", "_VALUE_RETURNED"}) create_variable(run, environment.names.id(name), 0);
    take_overrides(run, *main.traits);
    define_globals(run);
    take_given(run);
    if (run.stopped) return {run.ending, 0, {}, {}, {}, 0};
    choose_reference_datum(run, main);
    enter(run, main, nullptr, {});
    if (!run.unit().statements.empty()) run.statement = run.unit().statements.data();
    begin_telling(run);
    begin_said(run);
    if (environment.first_tool != 0) begin_with_tool(run, environment.first_tool);
    control_sets_all(run);
    if (environment.looked_ahead_in_vain != 0)
        while (!run.stopped) {
            look_ahead_in_vain(run, environment.looked_ahead_in_vain);
            step(run);
        }
    while (!run.stopped) step(run);
    flush_path(run);
    while (run.told.open_cycles > 0) end_bracket(run);  // an alarm ends cycles half-way
    run.path->tell_lead_end(run);
    run.path->tell_end(run);
    Outcome outcome{run.ending, run.blocks, {}, {run.entered.begin(), run.entered.end()}, std::move(run.overrides_met),
                    run.steps};
    outcome.carried = std::move(run.carried);
    for (std::uint32_t n = 0; n < run.parameters.count(); ++n)
        if (run.parameters.is_assigned(n))
            outcome.parameters.push_back({program::parameter_name(*main.traits, n), run.parameters.get(n)});
    return outcome;
}

}  // namespace obrys::interp
