/// Values of words: numbers and Q parameters with a sign.

#include <cmath>

#include "dialect/heidenhain/traits.hpp"
#include "read/heidenhain/state.hpp"

namespace obrys::read::heidenhain {

using program::Expr;
using program::ExprKind;
using program::no_expr;

namespace {

constexpr std::int64_t text_parameters = 2000;

void no_such_parameter(State& s, std::uint32_t begin, const std::string& name) {
    fail(s, begin, "there is no parameter " + name, "Q0 to Q1999, QL0 to QL499, QR0 to QR499, QS0 to QS1999");
}

}  // namespace

bool stands_parameter(const State& s) {
    if (base::upper(s.in.peek()) != 'Q') return false;
    const char next = base::upper(s.in.peek(1));
    return base::is_digit(next) || ((next == 'L' || next == 'R' || next == 'S') && base::is_digit(s.in.peek(2)));
}

ExprId read_parameter(State& s) {
    if (!stands_parameter(s)) return no_expr;
    const std::uint32_t begin = s.in.at();
    s.in.step();
    if (!base::is_digit(s.in.peek())) s.in.step();
    while (base::is_digit(s.in.peek())) s.in.step();
    const std::uint32_t end = s.in.at();
    const std::string name = base::to_upper(s.in.between(begin, end));
    Expr e;
    if (name[1] == 'S') {
        const auto number = base::parse_integer(std::string_view(name).substr(2));
        if (!number || *number >= text_parameters) no_such_parameter(s, begin, name);
        e.kind = ExprKind::variable;
        e.a = s.build.name(name);
        return s.build.add(e, begin, end);
    }
    const program::Traits& traits = dialect::heidenhain::traits;
    e.kind = ExprKind::parameter;
    e.a = program::find_parameter(traits, name);
    if (e.a == program::parameter_count(traits)) no_such_parameter(s, begin, name);
    return s.build.add(e, begin, end);
}

void limit(State& s, base::NumberScan& n, std::uint32_t begin) {
    if (std::isfinite(n.value)) return;
    fail(s, begin, "this number is too large");
    n.value = 0;
}

Value read_value(State& s) {
    s.in.skip_blanks();
    Value v;
    v.begin = s.in.at();
    if (s.in.peek() == '-' || s.in.peek() == '+') {
        v.negative = s.in.peek() == '-';
        s.in.step();
        s.in.skip_blanks();
    }
    if (const ExprId parameter = read_parameter(s); parameter != no_expr) {
        v.found = true;
        v.end = s.in.at();
        v.expr = v.negative ? s.build.unary(program::Operator::negate, parameter, v.begin, v.end) : parameter;
        return v;
    }
    v.literal = s.in.number();
    v.found = v.literal.length > 0;
    v.end = s.in.at();
    if (v.found) limit(s, v.literal, v.begin);
    no_exponent(s, v.begin);
    if (!v.found) s.in.go_to(v.begin);
    return v;
}

ExprId as_expr(State& s, const Value& v) {
    if (!v.found) return no_expr;
    return v.is_literal() ? s.build.number(v.number(), v.literal.integer, v.begin, v.end) : v.expr;
}

ExprId value_expr(State& s) {
    const Value v = read_value(s);
    if (!v.found) fail_here(s, "a number or a Q parameter is missing here, found " + here(s));
    return as_expr(s, v);
}

void value_word(State& s, Code code, std::uint32_t begin, bool incremental) {
    const std::uint32_t behind = s.in.at();
    const Value v = read_value(s);
    if (!v.found) {
        s.in.go_to(behind);
        fail(s, begin,
             "the word '" + base::as_utf8(base::trim(s.in.between(begin, s.in.at()))) +
                 "' has no value: a number or a Q parameter must follow");
        return;
    }
    if (s.failed) return;  // a value that cannot be: the word is left out
    if (incremental)
        s.build.expression(code, s.build.with_reference(program::Reference::incremental, as_expr(s, v), v.begin, v.end),
                           begin, v.end);
    else if (v.is_literal())
        s.build.literal(code, v.literal, v.negative, begin, v.end);
    else
        s.build.expression(code, v.expr, begin, v.end);
}

}  // namespace obrys::read::heidenhain
