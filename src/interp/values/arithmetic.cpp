/// Operators. Integers stay integers where both sides are; a division is real.

#include <cmath>

#include "base/codes.hpp"
#include "base/whole.hpp"
#include "interp/values/values.hpp"

namespace obrys::interp {

using program::Expr;
using program::Operator;
namespace codes = base::codes;

namespace {

base::Span span_of(const Saying& run, const Expr& e) { return {run.unit().file, e.begin, e.end}; }

double divided(Saying& run, const Expr& e, double a, double b) {
    if (b != 0) return a / b;
    alarm(run, codes::arithmetic, span_of(run, e), "division by zero",
          "guard the block with IF or correct the divisor");
    return 0;
}

bool nearly_equal(const Saying& run, double a, double b) {
    if (a == b) return true;
    const program::Equality& e = run.unit().traits->equality;
    return std::abs(a - b) <= std::max(e.relative * std::max(std::abs(a), std::abs(b)), e.absolute);
}

/// As `nearly_equal`, where less and greater ask for it.
bool counts_as_equal(const Saying& run, double a, double b) {
    return run.unit().traits->equality.orders_exactly ? a == b : nearly_equal(run, a, b);
}

std::int32_t bits(double v) {
    return static_cast<std::int32_t>(base::cut<std::int64_t>(std::fmod(v, 4294967296.0)).value_or(0));
}

double checked(Saying& run, const Expr& e, double v) {
    if (std::isnan(v) || std::abs(v) <= largest_result) return v;  // unknown operands give an unknown result
    alarm(run, codes::arithmetic, span_of(run, e), "the result is too large for the control");
    return 0;
}

}  // namespace

namespace {

/// With an unknown operand: known only where the other one decides alone.
double with_unknown(Operator op, double a, double b) {
    if (op == Operator::logical_and && (a == 0 || b == 0)) return 0;
    const bool decided = (!std::isnan(a) && a != 0) || (!std::isnan(b) && b != 0);
    if (op == Operator::logical_or && decided) return 1;
    return std::isnan(a) ? a : b;
}

}  // namespace

double binary_number(Saying& run, const Expr& e, double a, double b) {
    if (std::isnan(a) || std::isnan(b)) return with_unknown(static_cast<Operator>(e.op), a, b);
    switch (static_cast<Operator>(e.op)) {
        case Operator::add: return checked(run, e, a + b);
        case Operator::subtract: return checked(run, e, a - b);
        case Operator::multiply: return checked(run, e, a * b);
        case Operator::divide: return checked(run, e, divided(run, e, a, b));
        case Operator::integer_divide: return std::trunc(checked(run, e, divided(run, e, a, b)));
        case Operator::modulo: {
            const double quotient = std::trunc(checked(run, e, divided(run, e, a, b)));
            const double rest = a - quotient * b;
            return rest < 0 && run.traits->modulo_is_positive ? rest + std::abs(b) : rest;
        }
        case Operator::power: {
            const double v = std::pow(a, b);
            if (!std::isnan(v)) return checked(run, e, v);
            alarm(run, codes::arithmetic, span_of(run, e), "a negative number has no power with a broken exponent");
            return 0;
        }
        case Operator::equal: return nearly_equal(run, a, b);
        case Operator::not_equal: return !nearly_equal(run, a, b);
        case Operator::less: return a < b && !counts_as_equal(run, a, b);
        case Operator::less_equal: return a < b || counts_as_equal(run, a, b);
        case Operator::greater: return a > b && !counts_as_equal(run, a, b);
        case Operator::greater_equal: return a > b || counts_as_equal(run, a, b);
        case Operator::logical_and: return a != 0 && b != 0;
        case Operator::logical_or: return a != 0 || b != 0;
        case Operator::logical_xor: return (a != 0) != (b != 0);
        case Operator::bit_and: return bits(a) & bits(b);
        case Operator::bit_or: return bits(a) | bits(b);
        case Operator::bit_xor: return bits(a) ^ bits(b);
        default: break;
    }
    alarm(run, codes::type_mismatch, span_of(run, e), "this operator does not work on numbers");
    return 0;
}

namespace {

bool compares(Operator op) { return op >= Operator::equal && op <= Operator::greater_equal; }

Value compare_texts(const Expr& e, const Value& a, const Value& b) {
    const int order = a.as_text().compare(b.as_text());
    switch (static_cast<Operator>(e.op)) {
        case Operator::equal: return Value::boolean(order == 0);
        case Operator::not_equal: return Value::boolean(order != 0);
        case Operator::less: return Value::boolean(order < 0);
        case Operator::less_equal: return Value::boolean(order <= 0);
        case Operator::greater: return Value::boolean(order > 0);
        default: return Value::boolean(order >= 0);
    }
}

Value as_string(const Value& v) { return Value::string(printed(v)); }

}  // namespace

Value binary_value(Saying& run, const Expr& e, const Value& a, const Value& b) {
    const auto op = static_cast<Operator>(e.op);
    if (op == Operator::concat)
        return a.is_unknown() || b.is_unknown() ? Value::unknown_text(printed(a) + printed(b))
                                                : Value::string(printed(a) + printed(b));
    if (op == Operator::frame_chain && (a.is_unknown() || b.is_unknown())) return Value::unknown(Type::frame);
    if (op == Operator::frame_chain && a.type == Type::frame && b.type == Type::frame)
        return Value::of_frame(a.as_frame() * b.as_frame());
    if (a.is_unknown() || b.is_unknown()) return Value::unknown();
    const bool text = a.is_text() || b.is_text();
    const bool comparable = a.is_text() ? b.is_text() || b.type == Type::character : a.type == Type::character;
    if (compares(op) && text && comparable) return compare_texts(e, as_string(a), as_string(b));
    if (!a.is_number() || !b.is_number()) {
        alarm(run, codes::type_mismatch, span_of(run, e),
              "a " + std::string(name(a.type)) + " and a " + std::string(name(b.type)) +
                  " cannot be combined by this operator");
        return {};
    }
    const double result = binary_number(run, e, a.number, b.number);
    if (compares(op) || op == Operator::logical_and || op == Operator::logical_or || op == Operator::logical_xor)
        return Value::boolean(result != 0);
    const bool whole = a.type != Type::real && b.type != Type::real && op != Operator::divide;
    const bool always_whole = op == Operator::bit_and || op == Operator::bit_or || op == Operator::bit_xor;
    return whole || always_whole ? Value::integer(result) : Value::real(result);
}

}  // namespace obrys::interp
