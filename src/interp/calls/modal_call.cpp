/// MCALL: the call that follows every block with motion.

#include "base/codes.hpp"
#include "interp/calls/calls.hpp"

namespace obrys::interp {

using program::Call;
namespace codes = base::codes;

namespace {

/// Arguments of G66 as the numbered parameters of the called program.
void set_modal_parameters(Reckoning& run, const Call& call, ModalCall& modal) {
    modal.parameters.assign(run.traits->argument_parameters, {0.0, false});
    for (std::size_t i = 0; i < call.arguments.size() && i < modal.parameters.size(); ++i)
        if (call.arguments[i] != program::no_expr && !is_empty(run, call.arguments[i]))
            modal.parameters[i] = {number(run, call.arguments[i]), true};
}

}  // namespace

void set_modal_call(Calling& run, const Unit& unit, const Call& call) {
    if (run.traits->modal_calls_nest && run.modal_call.unit != nullptr)
        unchecked(run, codes::unsupported, call.where,
                  "a second modal call while one is in force is not run as the control nests them: it replaces the "
                  "first");
    ModalCall modal{&unit, {}, {}, call.where, {}, 0, {}};
    for (std::size_t i = 0; i < unit.parameters.size(); ++i) {
        const ExprId argument = i < call.arguments.size() ? call.arguments[i] : program::no_expr;
        modal.given.push_back(argument != program::no_expr);
        modal.arguments.push_back(argument != program::no_expr ? evaluate(run, argument)
                                                               : zero_value(unit.parameters[i].type));
    }
    if (run.traits->argument_parameters > 0) set_modal_parameters(run, call, modal);
    const auto repeats = repeats_of(run, call, call.where);
    if (!repeats) modal.unit = nullptr;
    modal.repeats = repeats.value_or(0);
    if (!run.stopped) run.modal_call = std::move(modal);
}

void run_modal_call(Calling& run) {
    if (run.modal_call.hole.cycle != nullptr) return call_hole(run, run.modal_call.hole, {cl::CycleCall::modal});
    const ModalCall& modal = run.modal_call;
    if (modal.unit == nullptr || run.stopped) return;
    for (const Activation& a : run.calls)
        if (a.from_modal_call) return;
    const std::size_t depth = run.calls.size();
    enter(run, *modal.unit, nullptr, run.here(), modal.repeats);
    if (run.calls.size() == depth || run.stopped) return;
    Activation& act = run.top();
    act.from_modal_call = true;
    for (std::uint32_t n = 1; n <= modal.parameters.size(); ++n)
        if (modal.parameters[n - 1].second) run.parameters.set(n, modal.parameters[n - 1].first);
    for (std::size_t i = 0; i < modal.arguments.size() && !run.stopped; ++i) {
        if (modal.given[i] != 0 && i < 32) act.arguments_given |= 1u << i;
        bind_value(run, modal.unit->parameters[i], modal.arguments[i], modal.where, act.locals);
    }
    if (run.stopped) return;
    bind_presets(run, *modal.unit);
    act.own_bindings = act.locals.size();
}

}  // namespace obrys::interp
