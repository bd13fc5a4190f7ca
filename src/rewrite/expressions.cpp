/// Expressions.

#include <algorithm>
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

/// INT and BOOL of the program, or nothing where the name is none of its numbers.
std::optional<program::Type> type_of(const Unit& unit, program::NameId name) {
    for (const program::Parameter& p : unit.parameters)
        if (p.name == name) return p.type;
    for (const program::Define& d : unit.defines)
        for (const program::Variable& v : d.variables)
            if (v.name == name) return d.type;
    return std::nullopt;
}

bool compares(Operator op) {
    return (op >= Operator::equal && op <= Operator::greater_equal) || op == Operator::logical_and ||
           op == Operator::logical_or || op == Operator::logical_xor;
}

/// The value is a whole number whatever the parameters hold.
bool is_whole(const Unit& unit, ExprId id) {
    const Expr& e = unit.exprs[id];
    const auto op = static_cast<Operator>(e.op);
    switch (e.kind) {
        case ExprKind::number: return unit.numbers[e.a] == std::trunc(unit.numbers[e.a]);
        case ExprKind::boolean: return true;
        case ExprKind::variable: return type_of(unit, e.a).value_or(program::Type::real) < program::Type::real;
        case ExprKind::unary: return op == Operator::logical_not || is_whole(unit, e.a);
        case ExprKind::binary:
            if (compares(op)) return true;
            return op != Operator::divide && op != Operator::power && is_whole(unit, e.a) && is_whole(unit, e.b);
        case ExprKind::function: {
            const auto f = static_cast<Function>(e.op);
            return f == Function::trunc || f == Function::round || f == Function::round_up ||
                   f == Function::round_outwards;
        }
        default: return false;
    }
}

}  // namespace

Text Writing::as_type(program::Type type, Text v, ExprId from) {
    if (type != program::Type::integer || from == program::no_expr || is_whole(*unit, from)) return v;
    return rounded(v, from);
}

Text Writing::of_type(ExprId target, Text v, ExprId from) {
    const Expr& e = unit->exprs[target];
    if (e.kind != ExprKind::variable || from == program::no_expr) return v;
    const auto type = type_of(*unit, e.a);
    if (type == program::Type::integer) return as_type(*type, std::move(v), from);
    if (type && *type != program::Type::real && !is_whole(*unit, from)) refuse_type(target);
    return v;
}

void Writing::refuse_type(ExprId target) {
    refuse(span(target), source(span(target)) + " is no REAL: what rounds this value is not translated by structure",
           "round it in the program (ROUND, TRUNC), or make the variable a REAL");
}

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

bool Writing::means_more(std::uint32_t number) const {
    const program::Traits& t = *unit->traits;
    if (program::is_of_control(t, number)) return true;
    const auto live = [&](const program::LiveParameters& l) { return number >= l.first && number < l.first + l.count; };
    const auto acts = [&](const program::KeptParameters& k) { return k.acts && number >= k.first && number <= k.last; };
    const bool offsets = t.offsets.datum_first != 0 && number >= t.offsets.datum_first - 120 &&
                         number < t.offsets.datum_first + t.offsets.datum_step * t.offsets.datum_count;
    return offsets || std::any_of(t.live.begin(), t.live.end(), live) ||
           std::any_of(t.kept.begin(), t.kept.end(), acts);
}

std::optional<Text> Writing::target_of(ExprId id) {
    const Expr& e = unit->exprs[id];
    if (e.kind == ExprKind::parameter && means_more(e.a)) {
        refuse(span(id), source(span(id)) + " is one of the control's own: it is not translated by structure");
        return std::nullopt;
    }
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
        case ExprKind::system: return system(e, id);
        default: break;
    }
    refuse(span(id), source(span(id)) + " is not translated by structure");
    return number_text(0);
}

}  // namespace obrys::rewrite
