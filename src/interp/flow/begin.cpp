/// How a run begins: what machine, job and program say before the first block.

#include <algorithm>

#include "base/whole.hpp"
#include "interp/capture.hpp"
#include "interp/flow/flow.hpp"
#include "interp/flow/look_ahead.hpp"
#include "interp/stream/path_stage.hpp"

namespace obrys::interp {

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

void take_overrides(Reckoning& run, const program::Traits& main_traits) {
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

void define_globals(Reckoning& run) {
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
std::uint32_t first_preset(const Saying& run, const Unit& main) {
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
void choose_reference_datum(Telling& run, const Unit& main) {
    if (keeps_offsets(run)) {
        run.modal.datum = 54;
        const bool compensates = std::any_of(main.words.begin(), main.words.end(), [](const program::Word& w) {
            return program::code_of(w) == Code::modal && program::modal_of(w) >= Modal::tool_length &&
                   program::modal_of(w) <= Modal::tool_length_added;
        });
        run.offsets.compensates = run.offsets.compensates || compensates;
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

Telling::Telling(const Environment& e, std::uint32_t parameter_count, const geom::Vec3& start, cl::Sink to)
    : Reckoning(e, parameter_count, start), sink(to) {
    path = std::make_unique<PathStage>();
}

Telling::~Telling() = default;

Run::Run(const Environment& e, cl::CallStacks& s, cl::Sink k, base::Diagnostics& d, std::uint32_t parameter_count)
    : RunState(e, parameter_count, start_position(e.machine), k), zero(k), ahead(look_ahead(*this)) {
    stacks = &s;
    diagnostics = &d;
    sink = cl::Sink(zero);
    onward = ahead.get();
    for (const shop::MachineAxis& axis : e.machine.axes)
        for (int i = 0; i < 9; ++i)
            if (axis.name == axis_name(i)) known_axes |= std::uint64_t{1} << static_cast<unsigned>(axis_code(i));
    modal.plane = e.machine.defaults.plane;
    modal.inch_geometry = modal.inch_feed = e.machine.defaults.inch;
    modal.diameter = e.machine.defaults.diameter_programming ? DiameterMode::on : DiameterMode::off;
    modal.feed_mode = e.machine.defaults.feed_per_rev ? cl::FeedMode::per_rev : cl::FeedMode::per_minute;
}

Run::~Run() = default;

Run::Run(const Run& other, cl::CallStacks& s, cl::Sink k, base::Diagnostics& d)
    : RunState(other), zero(other.zero, k), ahead(look_ahead(*this)) {
    stacks = &s;
    diagnostics = &d;
    sink = cl::Sink(zero);
    listener.reset();  // who listens to the other one does not hear this one
    onward = ahead.get();
    reported.take(other.reported);
    assumed.take(other.assumed);
    given.take(other.given);
    overrides_by_name.take(other.overrides_by_name);
    parameter_overridden.take(other.parameter_overridden);
    parameter_override.take(other.parameter_override);
    overrides_met.take(other.overrides_met);
    path = std::make_unique<PathStage>(*other.path);
    entered.take(other.entered);
    printed_files.take(other.printed_files);
}

void begin(Calling& run, const Unit& main) {
    const program::Traits& traits = *main.traits;
    const shop::Machine& machine = run.env.machine;
    run.traits = &traits;
    if (traits.radius_at_start) run.modal.diameter = DiameterMode::off;
    if (traits.radius_at_start && machine.more_axes) {  // a machine that is guessed says nothing
        run.modal.plane = 17;
        run.modal.feed_mode = cl::FeedMode::per_minute;
    }
    if (traits.begins_as_lathe) begin_as_lathe(run.modal);
    run.modes = main.modes.begin;
    run.modal.clear_to_retract_plane = traits.clearance_at_start;
    if (traits.feed_at_tool_first) run.modal.feed_reference = Modal::feed_at_tool;
    if (traits.rapid_at_start) run.modal.motion = Modal::rapid;
    if (traits.cancel_leaves_no_motion) run.modal.motion = Modal::canned_off;
    if (traits.variables_by_assignment)
        for (const char* name : {"_VALUE", "_VALUE_RETURNED"}) create_variable(run, run.env.names.id(name), 0);
    take_overrides(run, traits);
    define_globals(run);
    take_given(run);
    if (run.stopped) return;
    choose_reference_datum(run, main);
    enter(run, main, nullptr, {});
    if (!run.unit().statements.empty()) run.statement = run.unit().statements.data();
    hear_beginning(run);
    begin_said(run);
    if (run.env.first_tool != 0) begin_with_tool(run, run.env.first_tool);
    control_sets_all(run);
}

}  // namespace obrys::interp
