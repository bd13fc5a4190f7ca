#include "interp/flow/machine.hpp"

#include "interp/capture.hpp"
#include "interp/flow/flow.hpp"
#include "interp/flow/look_ahead.hpp"
#include "interp/stream/path_stage.hpp"

namespace obrys::interp {

Machine::Machine(const program::Unit& main, const Environment& environment, cl::CallStacks& stacks, cl::Sink sink,
                 base::Diagnostics& diagnostics, std::optional<Listener> listener)
    : run_(std::make_unique<Run>(environment, stacks, sink, diagnostics, program::parameter_count(*main.traits))),
      main_(main) {
    run_->listener = listener;
    begin(*run_, main);
}

Machine::Machine(const Machine& other, cl::CallStacks& stacks, cl::Sink sink, base::Diagnostics& diagnostics)
    : run_(std::make_unique<Run>(*other.run_, stacks, sink, diagnostics)), main_(other.main_) {}

Machine::~Machine() = default;

bool Machine::ended() const { return run_->stopped; }

std::optional<base::Span> Machine::next() const {
    if (run_->stopped || run_->calls.empty()) return std::nullopt;
    const Activation& act = run_->calls.back();
    if (act.pc >= act.unit->statements.size()) return std::nullopt;
    return act.unit->span(act.unit->statements[act.pc]);
}

bool Machine::step() {
    Run& run = *run_;
    if (run.stopped) return false;
    if (run.env.looked_ahead_in_vain != 0) look_ahead_in_vain(run, run.env.looked_ahead_in_vain);
    interp::step(run);
    return !run.stopped;
}

Outcome Machine::finish() {
    Run& run = *run_;
    if (run.entered.empty()) return {run.ending, 0, {}, {}, {}, 0};
    flush_path(run);
    while (run.told.open_cycles > 0) end_bracket(run);  // an alarm ends cycles half-way
    run.path->tell_lead_end(run);
    run.path->tell_end(run);
    Outcome outcome{run.ending, run.blocks, {}, {run.entered.begin(), run.entered.end()}, std::move(run.overrides_met),
                    run.steps};
    outcome.carried = std::move(run.carried);
    outcome.repeats = run.repeats;
    outcome.repeats_from = run.repeats_from;
    for (std::uint32_t n = 0; n < run.parameters.count(); ++n)
        if (run.parameters.is_assigned(n))
            outcome.parameters.push_back({program::parameter_name(*main_.traits, n), run.parameters.get(n)});
    return outcome;
}

}  // namespace obrys::interp
