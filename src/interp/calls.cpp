/// Calls of programs, their arguments, and the control's own procedures.

#include <algorithm>
#include <array>
#include <cmath>

#include "base/codes.hpp"
#include "base/number.hpp"
#include "base/text.hpp"
#include "base/whole.hpp"
#include "interp/path_stage.hpp"
#include "interp/run.hpp"

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

Value zero_of(Type t) {
    if (t == Type::string) return Value::string({});
    if (t == Type::axis) return Value::axis({});
    if (t == Type::frame) return Value::of_frame({});
    return {t, 0, nullptr, nullptr};
}

/// Evaluates the arguments in the caller and binds them in `callee`.
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
            bind_value(run, p, zero_of(p.type), call.where, callee.locals);
            continue;
        }
        if (i < 32) callee.arguments_given |= 1u << i;
        const bool reference = p.by_reference || p.is_array;
        if (reference && bind_reference(run, p, caller, argument, callee.locals)) continue;
        if (reference) note_lost_reference(run, p, caller, argument);
        Value v = evaluate(run, argument);
        if (run.stopped) return;
        if (v.type == Type::string && p.type == Type::axis && !v.is_unknown()) v.type = Type::axis;
        bind_value(run, p, std::move(v), caller.span(argument), callee.locals);
    }
}

/// A program that is run without its call: arguments are what the job gives, their default values, or not known.
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

/// Default values of parameters are evaluated inside the called program.
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

std::string program_name(std::string_view written) {
    std::string s = base::to_upper(base::trim(written));
    if (const auto slash = s.find_last_of("/\\:"); slash != std::string::npos) s.erase(0, slash + 1);
    if (s.starts_with("_N_")) s.erase(0, 3);
    for (const std::string_view suffix : {"_SPF", "_MPF", ".SPF", ".MPF", ".H"})
        if (s.ends_with(suffix)) s.resize(s.size() - suffix.size());
    return s;
}

const Unit* find(Saying& run, const std::string& name, const base::Span& where, const Call* call = nullptr) {
    if (const Unit* unit = run.env.find_program(name)) return unit;
    if (run.traits->missing_program_stops) {
        refuse_call(run, name, call);
        return nullptr;
    }
    unchecked(run, codes::missing_subprogram, where, "the program " + name + " was not found; the call is left out",
              "put its file beside the calling program or name the folder with --search");
    return nullptr;
}

}  // namespace

bool find_file(Saying& run, const std::string& written) {
    return run.env.find_program(program_name(written)) != nullptr;
}

const Unit* find_named_program(Saying& run, const std::string& written, const base::Span& where) {
    return find(run, program_name(written), where);
}

namespace {

/// Local numbered parameters begin unset in every program; the caller's are put aside.
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

}  // namespace

namespace {

/// Arguments of a call as the numbered parameters 1, 2 … of the called program, whose others are 0.
void pass_arguments(Reckoning& run, const Call* call, Activation& callee) {
    const std::uint32_t count = run.traits->argument_parameters;
    if (count == 0 || run.calls.empty() || (call != nullptr && call->shares_parameters)) return;
    std::array<double, 64> values{};
    std::array<bool, 64> given{};
    for (std::size_t i = 0; call != nullptr && i < call->arguments.size() && i < count && i < 64; ++i) {
        if (call->arguments[i] == program::no_expr || is_empty(run, call->arguments[i])) continue;
        values[i] = number(run, call->arguments[i]);
        given[i] = true;
    }
    for (std::uint32_t n = 1; n <= count && n <= 64; ++n) {
        callee.outer_arguments.emplace_back(run.parameters.get(n), run.parameters.is_set(n));
        run.parameters.forget(n);
        const bool zero = run.traits->parameters_begin_at_zero && !run.traits->empty_parameters;
        if (given[n - 1] || zero) run.parameters.set(n, values[n - 1]);
    }
}

/// Runs of the call beyond the first; nothing where it is not made at all.
std::optional<std::uint64_t> repeats_of(Reckoning& run, const Call& call, const base::Span& where) {
    if (call.passes == program::no_expr) return 0;
    const double passes = number(run, call.passes);
    if (std::isnan(passes))
        unchecked(run, codes::unknown_value, where, "how often this call is made depends on a value that is not known");
    if (!(passes >= 1)) return std::nullopt;
    return times_of(passes) - 1;
}

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

void return_arguments(Reckoning& run, const Activation& callee) {
    for (std::uint32_t n = 1; n <= callee.outer_arguments.size(); ++n) {
        run.parameters.forget(n);
        if (callee.outer_arguments[n - 1].second) run.parameters.set(n, callee.outer_arguments[n - 1].first);
    }
}

}  // namespace

namespace {

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
    if (!main) begin_part(run, cl::PartKind::call, unit.name, 1, callee.repeats + 1);
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

}  // namespace

namespace {

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

}  // namespace

namespace {

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
        begin_part(run, cl::PartKind::call, act.unit->name, act.repeats + 1 - act.repeats_left, act.repeats + 1);
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
    const Unit* unit = find(run, name, where, &call);
    if (unit == nullptr && call.kind == program::CallKind::modal) run.modal_call = {};
    if (unit == nullptr) return;
    if (call.kind == program::CallKind::modal) {
        set_modal_call(run, *unit, call);
        return;
    }
    enter(run, *unit, &call, where);
}

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
    ModalCall modal{&unit, {}, {}, call.where, {}, 0};
    for (std::size_t i = 0; i < unit.parameters.size(); ++i) {
        const ExprId argument = i < call.arguments.size() ? call.arguments[i] : program::no_expr;
        modal.given.push_back(argument != program::no_expr);
        modal.arguments.push_back(argument != program::no_expr ? evaluate(run, argument)
                                                               : zero_of(unit.parameters[i].type));
    }
    if (run.traits->argument_parameters > 0) set_modal_parameters(run, call, modal);
    const auto repeats = repeats_of(run, call, call.where);
    if (!repeats) modal.unit = nullptr;
    modal.repeats = repeats.value_or(0);
    if (!run.stopped) run.modal_call = std::move(modal);
}

void run_modal_call(Calling& run) {
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
