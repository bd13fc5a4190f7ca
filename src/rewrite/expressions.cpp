/// Expressions.

#include <cmath>

#include "base/number.hpp"
#include "rewrite/writing.hpp"

namespace obrys::rewrite {

namespace {

constexpr double most = 1e15;  ///< numbers up to there are written without an exponent

std::string_view key_of(Operator op) {
    switch (op) {
        case Operator::add: return "operators.add";
        case Operator::subtract: return "operators.subtract";
        case Operator::multiply: return "operators.multiply";
        case Operator::divide: return "operators.divide";
        case Operator::integer_divide: return "operators.integer-divide";
        case Operator::modulo: return "operators.modulo";
        default: return {};
    }
}

Level level_of(Operator op) { return op == Operator::add || op == Operator::subtract ? Level::sum : Level::product; }

bool compares(Operator op) {
    return (op >= Operator::equal && op <= Operator::greater_equal) || op == Operator::logical_and ||
           op == Operator::logical_or || op == Operator::logical_xor;
}

}  // namespace

std::string Writing::number(double v) const {
    std::string text = base::shortest(v);
    if (language.point && text.find('.') == std::string::npos) text += '.';
    return text;
}

Text Writing::number_text(double v) const { return {number(v), v < 0 ? Level::sign : Level::atom, v}; }

std::string Writing::within(const Text& t, Level loosest) const {
    return t.level <= loosest ? t.text : language.open + t.text + language.close;
}

Text Writing::joined(std::string_view key, const Text& a, const Text& b, Level level) {
    const std::string* op = language.find(key);
    if (op == nullptr) {
        refuse(here, "the control has no operator for this (" + std::string(key) + ")");
        return number_text(0);
    }
    const Level left = a.level == Level::sign ? Level::atom : level;
    // What stands behind an operator is bracketed unless it holds together more tightly; signs always are.
    const Level right = level == Level::sum && b.level == Level::product ? Level::product : Level::atom;
    return {within(a, left) + *op + within(b, right), level, std::nullopt};
}

Text Writing::place_for(ExprId where) {
    if (const auto name = naming.scratch(*unit)) return {*name, Level::atom, std::nullopt};
    refuse(where == program::no_expr ? here : span(where), "there is no parameter left to hold an intermediate value",
           "split the expression, or use fewer variables in this program");
    return number_text(0);
}

void Writing::assign(const Text& to, const Text& from) {
    static_cast<void>(
        say("expressions.assign",
            {{"to", to.text},
             {"value", from.text},
             {"bracketed",
              from.number || from.level == Level::atom ? from.text : language.open + from.text + language.close}},
            "an assignment"));
}

Text Writing::atom(Text v, ExprId where) {
    if (v.level == Level::atom && (v.number || v.text.find_first_of("([ ") == std::string::npos)) return v;
    if (v.number) return v;
    const Text to = place_for(where);
    assign(to, v);
    return to;
}

std::optional<Text> Writing::target_of(ExprId id) {
    const Expr& e = unit->exprs[id];
    std::optional<std::string> name;
    if (e.kind == ExprKind::parameter) name = naming.parameter(*unit, e.a);
    if (e.kind == ExprKind::variable && e.count == 0) name = naming.variable(*unit, e.a);
    if (name) return Text{*name, Level::atom, std::nullopt};
    const bool room = e.kind == ExprKind::parameter || (e.kind == ExprKind::variable && e.count == 0);
    if (room && !(e.kind == ExprKind::parameter && e.a == 0))
        refuse(span(id), source(span(id)) + " finds no free parameter");
    else
        refuse(span(id), source(span(id)) + ": this kind of variable is not translated by structure",
               e.kind == ExprKind::parameter_at ? "name the parameter by its number" : "");
    return std::nullopt;
}

Text Writing::value(ExprId id) {
    if (id == program::no_expr) return number_text(0);
    const Expr& e = unit->exprs[id];
    switch (e.kind) {
        case ExprKind::number:
            if (const double v = unit->numbers[e.a]; std::abs(v) < most) return number_text(v);
            refuse(span(id), "a number as large as this is not translated by structure");
            return number_text(0);
        case ExprKind::boolean: return number_text(e.a);
        case ExprKind::parameter:
        case ExprKind::parameter_at:
        case ExprKind::variable: return target_of(id).value_or(number_text(0));
        case ExprKind::qualified: return value(e.a);
        case ExprKind::unary: {
            const auto op = static_cast<Operator>(e.op);
            if (op == Operator::logical_not) return truth(id);
            const Text v = value(e.a);
            if (op == Operator::plus) return v;
            if (op == Operator::negate)
                return v.number ? number_text(-*v.number)
                                : Text{"-" + within(v, Level::atom), Level::sign, std::nullopt};
            break;
        }
        case ExprKind::binary: {
            const auto op = static_cast<Operator>(e.op);
            if (compares(op)) return truth(id);
            if (op == Operator::integer_divide || op == Operator::modulo || op == Operator::power)
                return function(e, id);
            if (key_of(op).empty()) break;
            const Text a = value(e.a), b = value(e.b);
            return joined(key_of(op), a, b, level_of(op));
        }
        case ExprKind::function: return function(e, id);
        case ExprKind::system:
            if (static_cast<program::SystemVariable>(e.op) == program::SystemVariable::pi)
                return number_text(3.14159265358979323846);
            break;
        default: break;
    }
    refuse(span(id), source(span(id)) + " is not translated by structure");
    return number_text(0);
}

}  // namespace obrys::rewrite
