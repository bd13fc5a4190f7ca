#include <cmath>

#include "base/slip.hpp"
#include "base/whole.hpp"

#include "read/rs274/state.hpp"

namespace obrys::read::rs274 {

using dialect::rs274::Argument;
using dialect::rs274::FunctionName;
using dialect::rs274::OperatorName;
using program::Operator;

namespace {

constexpr std::size_t most_digits = 300;  // a double holds numbers of so many for certain
constexpr double integer_tolerance = 1e-4;

Value fail_value(State& s, std::string text, std::string remedy = {}) {
    fail_here(s, std::move(text), std::move(remedy));
    return {};
}

const OperatorName* operator_here(const State& s) {
    for (const OperatorName& o : s.variant.operators)
        if (s.line.rest().starts_with(o.text)) return &o;
    return nullptr;
}

ExprId read_level(State& s, std::uint8_t loosest, int depth) {
    const std::uint32_t begin = s.line.here();
    const Value first = read_value(s, depth + 1);
    if (!first.found) {
        fail_here(s, "expected a value, found " + here(s));
        return no_expr;
    }
    ExprId left = as_expr(s, first);
    while (!s.failed) {
        const OperatorName* o = operator_here(s);
        if (o == nullptr || o->level < loosest) break;
        if (++s.operators > longest) {
            fail_here(s, "the expression has more than 1000 operators", "split it over several assignments");
            break;
        }
        s.line.step(o->text.size());
        const ExprId right = read_level(s, static_cast<std::uint8_t>(o->level + 1), depth);
        if (right == no_expr) break;
        left = s.build().binary(o->op, left, right, begin, s.line.behind());
    }
    return s.failed ? no_expr : left;
}

/// The function whose name stands here with its bracket; `named`: a name of one stands here at all.
const FunctionName* function_here(const State& s, bool& named) {
    const std::string_view rest = s.line.rest();
    named = false;
    for (const FunctionName& f : s.variant.functions) {
        if (!rest.starts_with(f.text)) continue;
        named = true;
        if (rest.size() > f.text.size() && rest[f.text.size()] == '[') return &f;
    }
    return nullptr;
}

/// `[#…]`: 1 for what the control has anyway, a question for a parameter with a name of the program's own, for pins and
/// for settings.
ExprId read_exists(State& s, const FunctionName& f, std::uint32_t begin, int depth) {
    s.line.step();
    if (s.line.peek() != '#') {
        fail_here(s, "expected # in EXISTS, found " + here(s));
        return no_expr;
    }
    const ExprId asked = read_parameter(s, false, depth);
    if (asked == no_expr) return no_expr;
    if (!s.line.take(']')) {
        fail_here(s, "expected ] behind the parameter, found " + here(s));
        return no_expr;
    }
    const program::Expr e = s.unit().exprs[asked];
    const auto what = static_cast<program::SystemVariable>(e.op);
    const bool of_machine = e.kind == program::ExprKind::system &&
                            (what == program::SystemVariable::unknown || what == program::SystemVariable::ini_value);
    if (e.kind != program::ExprKind::variable && !of_machine) return s.build().number(1, true, begin, s.line.behind());
    const ExprId name = s.build().text(s.names.text(e.a), e.begin, e.end);
    return s.build().function(f.function, {name}, begin, s.line.behind());
}

/// `/[b]` behind ATAN[a].
ExprId read_second(State& s, int depth) {
    if (!s.line.take('/')) {
        fail_here(s, "expected / behind the first argument of ATAN, found " + here(s), "write ATAN[a]/[b]");
        return no_expr;
    }
    if (s.line.peek() != '[') {
        fail_here(s, "expected [ behind the / of ATAN, found " + here(s), "write ATAN[a]/[b]");
        return no_expr;
    }
    return read_bracket(s, depth);
}

ExprId read_function(State& s, int depth) {
    bool named = false;
    const FunctionName* f = function_here(s, named);
    if (f == nullptr) {
        if (named) fail_here(s, "the name of a function is not followed by [", "put its argument in brackets");
        return no_expr;
    }
    const std::uint32_t begin = s.line.here();
    s.line.step(f->text.size());
    if (f->argument == Argument::refused) {
        fail(s, begin, s.line.behind(), "the function " + std::string(f->text) + " is not run");
        return no_expr;
    }
    if (f->argument == Argument::parameter) return read_exists(s, *f, begin, depth);
    std::vector<ExprId> arguments{read_bracket(s, depth)};
    if (s.failed) return no_expr;
    const bool has_second = f->argument == Argument::ratio || (f->argument == Argument::either && s.line.peek() == '/');
    if (has_second) arguments.push_back(read_second(s, depth));
    if (s.failed) return no_expr;
    // One argument of a function of two: the angle of a gradient.
    const auto what = f->argument == Argument::either && !has_second ? program::Function::atan : f->function;
    return s.build().function(what, arguments, begin, s.line.behind());
}

Value read_number(State& s, std::uint32_t begin, bool negative) {
    Value v;
    v.literal = s.line.scan_number();
    v.negative = negative;
    if (v.literal.length == 0 || v.literal.length > most_digits)
        return fail_value(s, v.literal.length == 0 ? "a point is no number" : "the number has too many digits");
    s.line.step(v.literal.length);
    if (s.line.peek() == '.') return fail_value(s, "the number has two points");
    v.found = true;
    v.begin = begin;
    v.end = s.line.behind();
    return v;
}

Value read_negated(State& s, std::uint32_t begin, int depth) {
    Value v = read_value(s, depth + 1);
    if (!v.found) return v;
    v.begin = begin;
    if (v.is_literal())
        v.negative = !v.negative;
    else
        v.expr = s.build().unary(Operator::negate, v.expr, begin, v.end);
    return v;
}

}  // namespace

ExprId read_expression(State& s) {
    s.operators = 0;
    return read_level(s, 0, 0);
}

ExprId read_bracket(State& s, int depth) {
    const std::uint32_t open = s.line.here();
    s.line.step();
    const ExprId inner = read_level(s, 0, depth);
    if (s.failed || s.line.take(']')) return inner;
    if (s.line.at_end() || s.line.peek() == ';')
        fail(s, open, open + 1, "this bracket is not closed", "add ]");
    else
        fail_here(s, "expected ] or an operator, found " + here(s));
    return no_expr;
}

Value read_value(State& s, int depth) {
    if (s.failed) return {};
    if (depth > deepest) return fail_value(s, "the expression is nested too deep", "split it over several assignments");
    const std::uint32_t begin = s.line.here();
    const char c = s.line.peek();
    if (c == '+' || c == '-') {
        s.line.step();
        if (c == '-') return read_negated(s, begin, depth);
        Value v = read_value(s, depth + 1);
        v.begin = begin;
        return v;
    }
    if (base::is_digit(c) || c == '.') return read_number(s, begin, false);
    Value v;
    v.begin = begin;
    if (c == '[')
        v.expr = read_bracket(s, depth);
    else if (c == '#')
        v.expr = read_parameter(s, false, depth);
    else if (base::is_letter(c))
        v.expr = read_function(s, depth);
    v.found = v.expr != no_expr && !s.failed;
    v.end = s.line.behind();
    return v;
}

Value read_due_value(State& s, std::string_view word, std::uint32_t begin) {
    s.operators = 0;
    Value v = read_value(s);
    if (v.found || s.failed) return v;
    const auto slip = base::slip_in_number(s.text, s.line.here());
    fail(s, begin, s.line.behind(), std::string(word) + " has no value",
         slip.empty() ? "write a number behind it" : std::string(slip));
    return v;
}

ExprId as_expr(State& s, const Value& v) {
    if (!v.found) return no_expr;
    return v.is_literal() ? s.build().number(v.number(), v.literal.integer, v.begin, v.end) : v.expr;
}

std::optional<std::int32_t> as_integer(const Value& v) {
    if (!v.found || !v.is_literal()) return std::nullopt;
    const double x = v.number();
    const double whole = std::round(x);
    if (std::abs(x - whole) > integer_tolerance) return std::nullopt;
    return base::cut<std::int32_t>(whole, -1'000'000'000, 1'000'000'000);
}

}  // namespace obrys::read::rs274
