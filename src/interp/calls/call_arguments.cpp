/// Arguments of a call, and the variables that the called program begins with.

#include <array>

#include "base/codes.hpp"
#include "base/whole.hpp"
#include "interp/calls/calls.hpp"
#include "interp/stream/path_stage.hpp"

namespace obrys::interp {

using program::Call;
using program::ExprKind;
using program::Parameter;
namespace codes = base::codes;

namespace {

/// Binds a VAR parameter to the caller's variable. False where the argument is no variable.
bool bind_reference(Reckoning& run, const Parameter& p, const Unit& caller, ExprId argument, Scope& locals) {
    const program::Expr& e = caller.exprs[argument];
    const Binding* b = e.kind == ExprKind::variable ? find_variable(run, e.a) : nullptr;
    if (b == nullptr) return false;
    if (e.count == 0) {
        locals.bind({p.name, b->array, b->offset, b->element, nullptr});
        return true;
    }
    std::size_t index = 0;
    if (!element_of(run, e, *b->array, index)) return true;  // the alarm has been raised
    locals.bind({p.name, b->array, index, true, nullptr});
    return true;
}

/// What a VAR parameter is given must be a variable; what cannot be written back is said.
void note_lost_reference(Saying& run, const Parameter& p, const Unit& caller, ExprId argument) {
    const ExprKind kind = caller.exprs[argument].kind;
    if (kind == ExprKind::variable) return;  // not defined: reported where it is read
    const std::string& name = run.env.names.text(p.name);
    if (kind == ExprKind::parameter || kind == ExprKind::parameter_at || kind == ExprKind::system)
        unchecked(
            run, codes::unsupported, caller.span(argument),
            "VAR " + name + " is given no variable made by DEF: what the program writes to it is not handed back");
    else
        alarm(run, codes::bad_argument, caller.span(argument), "VAR " + name + " needs a variable here");
}

/// What is bound to a parameter, as the stream tells it.
void note_argument(const Saying& run, const Parameter& p, Activation& callee) {
    const Binding* b = callee.locals.find(p.name);
    if (b == nullptr) return;
    const Value v = b->array->get(b->offset);
    cl::PartArgument told{run.env.names.text(p.name), std::nan(""), {}};
    const bool known = !v.is_unknown() && !p.is_array;
    if (known && v.is_text())
        told.text = v.as_text();
    else if (known && v.is_number())
        told.value = v.number;
    callee.arguments.push_back(std::move(told));
}

}  // namespace

void bind_value(Saying& run, const Parameter& p, Value v, const base::Span& where, Scope& locals) {
    auto array = std::make_shared<Array>();
    array->type = p.type;
    array->allocate();
    const Type given = v.type;
    const Conversion c = convert(v, p.type);
    if (c != Conversion::ok) {
        alarm(run, codes::type_mismatch, where,
              "a " + std::string(name(given)) + " does not fit the parameter " + run.env.names.text(p.name) +
                  " of type " + std::string(name(p.type)));
        return;
    }
    array->set(0, v);
    locals.bind({p.name, std::move(array), 0, false, nullptr});
}

Value zero_value(Type t) {
    if (t == Type::string) return Value::string({});
    if (t == Type::axis) return Value::axis({});
    if (t == Type::frame) return Value::of_frame({});
    return {t, 0, nullptr, nullptr};
}

void bind_arguments(Reckoning& run, const Unit& unit, const Call& call, Activation& callee) {
    const Unit& caller = run.unit();
    if (call.arguments.size() > unit.parameters.size()) {
        alarm(run, codes::bad_argument, call.where,
              unit.name + " takes " + std::to_string(unit.parameters.size()) + " arguments, " +
                  std::to_string(call.arguments.size()) + " are given");
        return;
    }
    for (std::size_t i = 0; i < unit.parameters.size() && !run.stopped; ++i) {
        const Parameter& p = unit.parameters[i];
        const ExprId argument = i < call.arguments.size() ? call.arguments[i] : program::no_expr;
        if (argument == program::no_expr) {
            bind_value(run, p, zero_value(p.type), call.where, callee.locals);
            continue;
        }
        if (i < 32) callee.arguments_given |= 1u << i;
        const bool reference = p.by_reference || p.is_array;
        if (reference && bind_reference(run, p, caller, argument, callee.locals)) {
            note_argument(run, p, callee);
            continue;
        }
        if (reference) note_lost_reference(run, p, caller, argument);
        Value v = evaluate(run, argument);
        if (run.stopped) return;
        if (v.type == Type::string && p.type == Type::axis && !v.is_unknown()) v.type = Type::axis;
        bind_value(run, p, std::move(v), caller.span(argument), callee.locals);
        note_argument(run, p, callee);
    }
}

void bind_main_arguments(Reckoning& run, const Unit& unit) {
    Activation& main = run.top();
    for (std::size_t i = 0; i < unit.parameters.size() && !run.stopped; ++i) {
        const Parameter& p = unit.parameters[i];
        auto array = std::make_shared<Array>();
        array->type = p.type;
        array->name = p.name;
        for (std::size_t k = 0; p.is_array && k < 3 && p.dimensions[k] != program::no_expr; ++k) {
            const double n = number(run, p.dimensions[k]);
            const auto size = base::cut<std::uint32_t>(n, 1, 100'000);
            if (!size) break;
            array->dimensions[k] = *size;
            array->rank = static_cast<int>(k) + 1;
        }
        array->allocate_unknown(Held::argument);
        if (give_argument(run, *array, run.env.names.text(p.name)) && i < 32) main.arguments_given |= 1u << i;
        main.locals.bind({p.name, std::move(array), 0, false, nullptr});
    }
}

void bind_presets(Reckoning& run, const Unit& unit) {
    Activation& callee = run.top();
    for (std::size_t i = 0; i < unit.parameters.size() && i < 32 && !run.stopped; ++i) {
        const Parameter& p = unit.parameters[i];
        if (((callee.arguments_given >> i) & 1u) != 0 || p.preset == program::no_expr) continue;
        Value v = evaluate(run, p.preset);
        const Binding* b = callee.locals.find(p.name);
        if (run.stopped || b == nullptr || convert(v, p.type) != Conversion::ok) continue;
        b->array->set(0, v);
        if (!b->array->held.empty()) b->array->held[0] = Held::definition;
    }
}

void hide_locals(Reckoning& run, const Unit& unit, Activation& callee) {
    std::uint32_t n = 0;
    for (const program::ParameterBank& bank : unit.traits->banks) {
        for (std::uint32_t i = 0; bank.local && i < bank.count; ++i, ++n) {
            if (!run.calls.empty()) callee.outer_locals.emplace_back(run.parameters.get(n), run.parameters.is_set(n));
            run.parameters.forget(n);
        }
        if (!bank.local) n += bank.count;
    }
}

void show_locals(Reckoning& run, const Activation& callee) {
    std::uint32_t n = 0;
    std::size_t at = 0;
    for (const program::ParameterBank& bank : callee.unit->traits->banks) {
        for (std::uint32_t i = 0; bank.local && i < bank.count && at < callee.outer_locals.size(); ++i, ++at) {
            run.parameters.forget(n + i);
            if (callee.outer_locals[at].second) run.parameters.set(n + i, callee.outer_locals[at].first);
        }
        n += bank.count;
    }
}

void pass_arguments(Reckoning& run, const Call* call, Activation& callee) {
    const std::uint32_t count = run.traits->argument_parameters;
    if (count == 0 || run.calls.empty() || (call != nullptr && call->shares_parameters)) return;
    std::array<double, 64> values{};
    std::array<bool, 64> given{};
    for (std::size_t i = 0; call != nullptr && i < call->arguments.size() && i < count && i < 64; ++i) {
        if (call->arguments[i] == program::no_expr || is_empty(run, call->arguments[i])) continue;
        values[i] = number(run, call->arguments[i]);
        given[i] = true;
        callee.arguments.push_back(
            {program::parameter_name(*run.traits, static_cast<std::uint32_t>(i) + 1), values[i], {}});
    }
    for (std::uint32_t n = 1; n <= count && n <= 64; ++n) {
        callee.outer_arguments.emplace_back(run.parameters.get(n), run.parameters.is_set(n));
        run.parameters.forget(n);
        const bool zero = run.traits->parameters_begin_at_zero && !run.traits->empty_parameters;
        if (given[n - 1] || zero) run.parameters.set(n, values[n - 1]);
    }
}

void return_arguments(Reckoning& run, const Activation& callee) {
    for (std::uint32_t n = 1; n <= callee.outer_arguments.size(); ++n) {
        run.parameters.forget(n);
        if (callee.outer_arguments[n - 1].second) run.parameters.set(n, callee.outer_arguments[n - 1].first);
    }
}

}  // namespace obrys::interp
