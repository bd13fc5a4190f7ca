/// Expressions: a quick way for numbers, a general one for everything else.

#include <cmath>
#include <limits>

#include "base/codes.hpp"
#include "base/whole.hpp"
#include "interp/values/values.hpp"

namespace obrys::interp {

using program::Expr;
using program::ExprKind;
using program::Function;
using program::Operator;
namespace codes = base::codes;

namespace {

/// What a parameter holds; one that the control writes itself may hold what nobody knows.
double held_value(Reckoning& run, std::uint32_t n, const base::Span& where) {
    const double v = run.parameters.get(n);
    if (std::isnan(v) && !run.parameters.is_assigned(n) && !run.traits->set_by_control.empty())
        unchecked(run, codes::unknown_value, where,
                  "the control writes " + program::parameter_name(*run.unit().traits, n) +
                      ", and what it holds here is not known",
                  "give what it follows from (tool, machine), or its value in [variables] of the job");
    return v;
}

}  // namespace

double parameter_value(Reckoning& run, double index, const base::Span& where) {
    if (std::isnan(index)) {
        unchecked(run, codes::unknown_value, where, "which parameter this is depends on a value that is not known");
        return index;
    }
    if (!(index >= 0) || index >= run.parameters.count()) {
        alarm(run, codes::index_range, where,
              "parameter number " + printed(Value::real(index)) + " lies outside " +
                  program::parameter_name(*run.unit().traits, 0) + " to " +
                  program::parameter_name(*run.unit().traits, run.parameters.count() - 1));
        return 0;
    }
    const auto n = base::clipped<std::uint32_t>(index, 0, run.parameters.count() - 1);
    if (refuse_absent(run, n, where)) return 0;
    if (!run.traits->live.empty() && is_live(run, n)) return live_parameter(run, n, where);
    if (run.parameters.is_set(n)) return held_value(run, n, where);
    if (run.parameter_overridden[n] != 0) {
        const std::string name = program::parameter_name(*run.unit().traits, n);
        unchecked(run, codes::unknown_value, where,
                  name + " is read before the program assigns it: what is set from outside replaces assignments alone",
                  given_remedy(name));
        return std::numeric_limits<double>::quiet_NaN();
    }
    if (run.traits->parameters_begin_at_zero || is_kept_unknown(run, n)) return kept_parameter(run, n, where);
    const std::string name = program::parameter_name(*run.unit().traits, n);
    unchecked(run, codes::unknown_value, where,
              name + " is read before the program sets it: what it holds then is not known", given_remedy(name));
    return std::numeric_limits<double>::quiet_NaN();
}

namespace {

double parameter_value(Reckoning& run, const Expr& e, double index) {
    return parameter_value(run, index, {run.unit().file, e.begin, e.end});
}

}  // namespace

bool is_empty(Reckoning& run, ExprId id) {
    if (!run.traits->empty_parameters || id == program::no_expr || run.stopped) return false;
    const Expr& e = run.unit().exprs[id];
    if (e.kind == ExprKind::qualified) return is_empty(run, e.a);
    if (e.kind == ExprKind::unary && static_cast<Operator>(e.op) == Operator::negate) return is_empty(run, e.a);
    if (e.kind != ExprKind::parameter && e.kind != ExprKind::parameter_at) return false;
    const double index = e.kind == ExprKind::parameter ? e.a : number(run, e.a);
    if (run.stopped || !(index >= 0) || index >= run.parameters.count()) return false;
    const auto n = base::clipped<std::uint32_t>(index, 0, run.parameters.count() - 1);
    return n == 0 || (!run.parameters.is_set(n) && !is_absent(run, n) && !is_live(run, n) && !is_kept_unknown(run, n));
}

namespace {

bool is_numeric(Operator op) {
    return op != Operator::concat && op != Operator::frame_chain && op != Operator::equal && op != Operator::not_equal;
}

double variable_number(Reckoning& run, const Expr& e, ExprId id) {
    if (const Binding* b = find_variable(run, e.a);
        b != nullptr && e.count == 0 && b->array->type <= Type::real && b->array->held.empty())
        return b->array->numbers[b->offset];
    const Value v = evaluate(run, id);
    if (run.stopped || v.is_number()) return v.number;
    alarm(run, codes::type_mismatch, run.unit().span(id),
          "a number is needed here, this is a " + std::string(name(v.type)));
    return 0;
}

/// `number` of what expressions are mostly made of, without going into it.
inline double operand(Reckoning& run, const Unit& unit, ExprId id) {
    if (id == program::no_expr) return 0;
    const Expr& e = unit.exprs[id];
    if (e.kind == ExprKind::number) return unit.numbers[e.a];
    if (e.kind == ExprKind::parameter && e.a < run.parameters.count() && run.parameters.is_set(e.a))
        if (const double v = run.parameters.get(e.a); !std::isnan(v)) return v;
    return number(run, id);
}

double function_number(Reckoning& run, const Expr& e, ExprId id) {
    const auto f = static_cast<Function>(e.op);
    if (e.count == 1 && (f == Function::sin || f == Function::cos) && run.unit().children[e.b] != program::no_expr) {
        const double a = geom::radians(operand(run, run.unit(), run.unit().children[e.b]));
        return f == Function::sin ? std::sin(a) : std::cos(a);
    }
    const Value v = call_function(run, e);
    if (run.stopped || v.is_number()) return v.number;
    alarm(run, codes::type_mismatch, run.unit().span(id),
          "a number is needed here, this is a " + std::string(name(v.type)));
    return 0;
}

/// `binary_number` of known operands where nothing is to be said; NaN: it has to look.
inline double plain_result(Operator op, double a, double b) {
    double v = std::numeric_limits<double>::quiet_NaN();
    if (op == Operator::add) v = a + b;
    if (op == Operator::subtract) v = a - b;
    if (op == Operator::multiply) v = a * b;
    if (op == Operator::divide && b != 0) v = a / b;
    return std::abs(v) <= largest_result ? v : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

double number(Reckoning& run, ExprId id) {
    if (id == program::no_expr || run.stopped) return 0;
    const Unit& unit = run.unit();
    const Expr& e = unit.exprs[id];
    switch (e.kind) {
        case ExprKind::number: return unit.numbers[e.a];
        case ExprKind::boolean: return e.a;
        case ExprKind::parameter:
            if (e.a < run.parameters.count() && run.parameters.is_set(e.a))
                if (const double v = run.parameters.get(e.a); !std::isnan(v)) return v;
            return parameter_value(run, e, e.a);
        case ExprKind::parameter_at: return parameter_value(run, e, number(run, e.a));
        case ExprKind::binary:
            if (is_numeric(static_cast<Operator>(e.op))) {
                const double a = operand(run, unit, e.a);
                const double b = operand(run, unit, e.b);
                if (run.stopped) return 0;
                const double v = plain_result(static_cast<Operator>(e.op), a, b);
                return std::isnan(v) ? binary_number(run, e, a, b) : v;
            }
            break;
        case ExprKind::unary: {
            const double a = operand(run, unit, e.a);
            switch (static_cast<Operator>(e.op)) {
                case Operator::negate: return -a;
                case Operator::logical_not: return std::isnan(a) ? a : a == 0 ? 1 : 0;
                case Operator::bit_not: return std::isnan(a) ? a : -1 - std::trunc(a);
                default: return a;
            }
        }
        case ExprKind::function: return function_number(run, e, id);
        case ExprKind::qualified: return number(run, e.a);
        case ExprKind::variable: return variable_number(run, e, id);
        default: break;
    }
    const Value v = evaluate(run, id);
    if (run.stopped || v.is_number()) return v.number;
    alarm(run, codes::type_mismatch, unit.span(id), "a number is needed here, this is a " + std::string(name(v.type)));
    return 0;
}

namespace {

/// Truth as a number: 0, not 0, or NaN where it is unknown. Strings are true when they hold something.
double condition(Reckoning& run, ExprId id) {
    const Expr& e = run.unit().exprs[id];
    if (e.kind != ExprKind::variable && e.kind != ExprKind::system) return number(run, id);
    const Value v = evaluate(run, id);
    return v.type == Type::string && !v.is_unknown() ? (v.as_text().empty() ? 0.0 : 1.0) : v.number;
}

}  // namespace

namespace {
constexpr std::uint64_t most_unknown_conditions = 100'000;
}

bool truth(Reckoning& run, ExprId id, bool when_unknown) {
    const double v = condition(run, id);
    if (!std::isnan(v)) return v != 0;
    if (++run.unknown_conditions > most_unknown_conditions) {
        unchecked(run, codes::budget, run.here(),
                  "the run was ended here: conditions with values that are not known were met " +
                      std::to_string(most_unknown_conditions) + " times, so that its loops may have no end",
                  "give what is not known, e.g. the tools in the job");
        run.stopped = true;
        run.ending = Ending::budget;
        return when_unknown;
    }
    unchecked(run, codes::unknown_value, run.unit().span(id), "this condition depends on a value that is not known",
              std::string("it is taken as ") + (when_unknown ? "fulfilled" : "not fulfilled") +
                  "; the run may go another way on the machine");
    return when_unknown;
}

namespace {

/// F_1[X,TR], or of an array F_1[3,X,TR].
Value read_frame_variable(Reckoning& run, const Binding& b, const Expr& e) {
    Expr whole = e;
    whole.count = static_cast<std::uint16_t>(e.count - 2);
    std::size_t index = b.offset;
    if (!b.element && !element_of(run, whole, *b.array, index)) return Value::unknown();
    note_held(run, *b.array, index, {run.unit().file, e.begin, e.end});
    const Value frame = b.array->get(index);
    return frame.is_unknown() ? Value::unknown() : read_component(run, e, frame.as_frame());
}

Value read_variable(Reckoning& run, const Expr& e, ExprId id) {
    const Unit& unit = run.unit();
    if (const Binding* b = find_variable(run, e.a)) {
        if (is_character_access(*b, e)) return read_character(run, *b, e);
        std::size_t index = b->offset;
        if (b->array->type == Type::frame && is_component(run, e)) return read_frame_variable(run, *b, e);
        if (!b->element && !element_of(run, e, *b->array, index)) return Value::unknown();
        note_held(run, *b->array, index, unit.span(id));
        return b->array->get(index);
    }
    const std::string& text = run.env.names.text(e.a);
    if (const std::string_view letters = unit.traits->text_letters; !letters.empty() && text.starts_with(letters)) {
        unchecked(run, codes::unknown_value, unit.span(id),
                  text + " is read before the program sets it: what it holds then is not known",
                  "set it in the program");
        return Value::unknown(Type::string);
    }
    for (const shop::MachineAxis& axis : run.env.machine.axes)
        if (axis.name == text && e.count == 0) return Value::axis(text);
    if (e.count == 0 && text.size() == 1 && std::string_view("XYZABCUVW").find(text[0]) != std::string_view::npos)
        return Value::axis(text);
    if (const auto axis = machine_axis_name(run, text); axis && e.count == 0) return Value::axis(*axis);
    if (unit.traits->variables_by_assignment) {
        alarm(run, codes::undefined_name, unit.span(id), "the named parameter #<" + text + "> is not defined",
              "assign it before it is read, or ask with EXISTS[#<" + text + ">]");
        return Value::unknown();
    }
    const std::string key = variable_key(run, e);
    const Value held = run.undefined.get(e.a, undefined_key(run, e));
    if (!held.is_unknown() && given_value(run, key)) return held;
    unchecked(run, codes::undefined_name, unit.span(id), text + " is not defined in this program",
              "if it is global user data (GUD), put its definition file beside the program or give its value in "
              "[variables] of the job: " +
                  job_key(key) + " = …; it is unknown until then");
    return held;
}

Value evaluate_binary(Reckoning& run, const Expr& e) {
    const auto op = static_cast<Operator>(e.op);
    if (op == Operator::logical_and || op == Operator::logical_or) {
        const double left = condition(run, e.a), right = condition(run, e.b);
        return run.stopped ? Value{} : Value{Type::boolean, binary_number(run, e, left, right), nullptr, nullptr};
    }
    if (run.traits->empty_parameters && (op == Operator::equal || op == Operator::not_equal)) {
        const bool left = is_empty(run, e.a), right = is_empty(run, e.b);
        if (left != right)
            if (const Value other = evaluate(run, left ? e.b : e.a); other.is_unknown()) return other;
        if (left || right) return Value::boolean((left && right) == (op == Operator::equal));
    }
    const Value a = evaluate(run, e.a);
    const Value b = evaluate(run, e.b);
    return run.stopped ? Value{} : binary_value(run, e, a, b);
}

Value evaluate_unary(Reckoning& run, const Expr& e, ExprId id) {
    const Value a = evaluate(run, e.a);
    if (a.is_unknown()) return a;
    if (static_cast<Operator>(e.op) == Operator::logical_not) return Value::boolean(a.number == 0);
    if (a.type == Type::integer) return Value::integer(number(run, id));
    return Value::real(number(run, id));
}

}  // namespace

Value evaluate(Reckoning& run, ExprId id) {
    if (id == program::no_expr || run.stopped) return {};
    const Unit& unit = run.unit();
    const Expr& e = unit.exprs[id];
    switch (e.kind) {
        case ExprKind::number: return e.op == 1 ? Value::integer(unit.numbers[e.a]) : Value::real(unit.numbers[e.a]);
        case ExprKind::boolean: return Value::boolean(e.a != 0);
        case ExprKind::text: return Value::string(unit.texts[e.a]);
        case ExprKind::parameter:
        case ExprKind::parameter_at: return Value::real(number(run, id));
        case ExprKind::variable: return read_variable(run, e, id);
        case ExprKind::system: return read_system(run, e);
        case ExprKind::unary: return evaluate_unary(run, e, id);
        case ExprKind::binary: return evaluate_binary(run, e);
        case ExprKind::function: return call_function(run, e);
        case ExprKind::qualified: return evaluate(run, e.a);
        case ExprKind::unknown_function: break;
    }
    for (std::size_t k = 0; k < e.count; ++k) static_cast<void>(evaluate(run, unit.children[e.b + k]));
    unchecked(run, codes::unsupported, unit.span(id), "the function " + run.env.names.text(e.a) + "() is not run",
              "its result is unknown");
    return Value::unknown();
}

std::string axis_of(Reckoning& run, ExprId id) {
    if (id == program::no_expr) return {};
    const Value v = evaluate(run, id);
    if (v.is_unknown()) return "?";
    if (v.is_text()) return v.as_text();
    const auto& axes = run.env.machine.axes;
    if (const auto n = base::cut<std::size_t>(v.number, 1, axes.size()); n) return axes[*n - 1].name;
    if (!run.stopped)
        alarm(run, codes::value_range, run.unit().span(id),
              "there is no axis number " + printed(v) + " on this machine");
    return {};
}

}  // namespace obrys::interp
