/// Numbers without decimal point, and what each letter of a block is.

#include <algorithm>
#include <cmath>

#include "read/rs274/fanuc/state.hpp"

namespace obrys::read::rs274 {

using program::Operator;
using program::Reference;

namespace {

constexpr std::array<double, 10> powers{1, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9};

Value shifted(Value v, int decimals) {
    if (decimals == 0) return v;
    base::NumberScan& n = v.literal;
    n.value /= powers[static_cast<std::size_t>(decimals)];
    n.integer = false;
    if (n.decimal) n.decimal->decimals += decimals;
    return v;
}

void say_whole_numbers(FanucState& s, const Value& v) {
    if (s.whole_number_said) return;
    s.whole_number_said = true;
    const bool increments = s.control.whole_numbers == WholeNumbers::increments;
    base::Diagnostic d;
    d.severity = base::Severity::warning;
    d.code = base::codes::assumption;
    d.where = s.build().span(v.begin, v.end);
    d.text = increments ? "numbers without a decimal point are read as least input increments (0.001 mm, 0.0001 inch, "
                          "0.001 degrees), here and in the rest of the program"
                        : "numbers without a decimal point are read as millimetres, inches and degrees, here and in "
                          "the rest of the program";
    d.remedy = s.control.haas ? "as with setting 162 (Default To Float) " + std::string(increments ? "off" : "on")
                              : "as with bit DPI of parameter 3401 = " + std::string(increments ? "0" : "1");
    d.remedy += "; write the point, or say how the control is set";
    s.diagnostics.add(std::move(d));
}

/// Without G20 or G21 in the text the caller's unit holds: the increment is computed when the block is run.
Value by_unit(FanucState& s, const Value& v, int metric, int inch) {
    program::Builder& b = s.build();
    const auto constant = [&](double x) { return b.number(x, false, v.begin, v.end); };
    const double mm = 1 / powers[static_cast<std::size_t>(metric)], in = 1 / powers[static_cast<std::size_t>(inch)];
    program::Expr query;
    query.kind = program::ExprKind::system;
    query.op = static_cast<std::uint8_t>(program::SystemVariable::state);
    query.a = b.name("G20");
    b.adopt(query, {b.number(static_cast<double>(program::StateQuery::imperial), true, v.begin, v.end)});
    const ExprId is_inch = b.add(query, v.begin, v.end);
    const ExprId less = b.binary(Operator::multiply, constant(in - mm), is_inch, v.begin, v.end);
    const ExprId unit = b.binary(Operator::add, constant(mm), less, v.begin, v.end);
    Value out = v;
    out.expr = b.binary(Operator::multiply, as_expr(s, v), unit, v.begin, v.end);
    return out;
}

}  // namespace

Value in_increments(FanucState& s, const Value& v, int metric, int inch) {
    if (metric == inch) return shifted(v, metric);
    const auto in_inches = s.inch.said();
    if (!in_inches) return by_unit(s, v, metric, inch);
    return shifted(v, *in_inches ? inch : metric);
}

Value feed_in_force(FanucState& s, std::uint32_t begin, std::uint32_t end) {
    program::Builder& b = s.build();
    program::Expr query;
    query.kind = program::ExprKind::system;
    query.op = static_cast<std::uint8_t>(program::SystemVariable::state);
    query.a = b.name("F");
    b.adopt(query, {b.number(static_cast<double>(program::StateQuery::feed), true, begin, end)});
    Value v;
    v.found = true;
    v.expr = b.add(query, begin, end);
    v.begin = begin;
    v.end = end;
    return v;
}

namespace {

/// Decimals of F. Sources: FANUC parameter 1403 MIF = 0 (1 mm/min, 0.01 inch/min); per revolution 0.01 mm, 0.0001 inch
/// on mills, 0.0001 mm, 0.000001 inch on lathes. Haas: setting 77 at its default.
Value feed(FanucState& s, const Value& v) {
    if (s.control.haas) return in_increments(s, v, 3, 4);
    if (!s.per_rev) return in_increments(s, v, 0, 2);
    return s.control.is_lathe() ? in_increments(s, v, 4, 6) : in_increments(s, v, 2, 4);
}

/// Milliseconds or thousandths of an expression.
Value divided(FanucState& s, const Value& v) {
    Value out = v;
    const ExprId thousand = s.build().number(1000, true, v.begin, v.end);
    out.expr = s.build().binary(Operator::divide, v.expr, thousand, v.begin, v.end);
    return out;
}

/// Words of G10, G68 and hole cycles keep their letters; the rest of the alphabet by machine.
Code code_of(const FanucState& s, char letter) {
    const bool fanuc_mill = !s.control.is_lathe() && !s.control.haas;
    if (letter == 'K' && fanuc_mill && hole_of(s) != 0) return Code::l;  // repeats
    // Of G87, see fanuc_canned.cpp.
    if ((letter == 'Z' || letter == 'R') && fanuc_mill && !s.hole_apart && s.hole.is_back_bore())
        return letter == 'Z' ? Code::e : Code::z;
    return dialect::rs274::letter_code(letter);
}

/// U, W, V and H of lathes in system A: the next X, Z, Y, C from where the tool is.
std::optional<Code> incremental_code(const FanucState& s, char letter) {
    if (!s.control.is_lathe() || s.control.system != dialect::rs274::GSystem::a) return std::nullopt;
    switch (letter) {
        case 'U': return Code::x;
        case 'V': return Code::y;
        case 'W': return Code::z;
        case 'H': return Code::c;
        default: return std::nullopt;
    }
}

/// The tool comes in at once. `parted`: else its number holds the offset, too.
void add_change(FanucState& s, const Address& a, bool parted) {
    BlockWord w;
    w.order = Order::technology;
    w.code = Code::tool_change;
    w.form = parted ? program::Form::bare : program::Form::expression;
    w.value.literal = base::scan_decimal("1");
    w.begin = a.begin;
    w.end = a.end;
    s.words.push_back(w);
}

/// T0203 of a lathe: tool 2 with offset 3, which acts at once.
void turret(FanucState& s, const Address& a) {
    const auto n = as_integer(a.value);
    if (!n) {  // T#1: parted when the block is run
        put_value(s, Order::technology, Code::tool, a.value, a);
        return add_change(s, a, false);
    }
    const auto whole = [&](int x) {
        Value v = a.value;
        v.negative = false;
        v.literal = base::scan_decimal(std::to_string(x));
        return v;
    };
    constexpr std::uint32_t all_digits = 5;  // T0008: the tool stays, its offset is 8; T0: none
    if (*n == 0 || (*n < 100 && a.end - a.begin >= all_digits))
        return put_value(s, Order::technology, Code::edge, whole(*n), a);
    if (*n < 100 || *n > 9999)
        add_problem(s, Code::unsupported, a.begin, a.end,
                    *n < 100 ? "one number for tool and offset: which it is (T0003, T0303) depends on the machine"
                             : "more than four digits: which of them are the tool depends on the machine");
    if (*n < 100) {
        put_value(s, Order::technology, Code::tool, a.value, a);
        put_value(s, Order::technology, Code::edge, whole(*n), a);  // T0303, the reading that changes the tool
    } else {
        put_value(s, Order::technology, Code::tool, whole(*n / 100), a);
        put_value(s, Order::technology, Code::edge, whole(*n % 100), a);
    }
    add_change(s, a, true);
}

}  // namespace

Quantity quantity_of(const FanucState& s, char letter) {
    switch (letter) {
        case 'A':
        case 'B':
        case 'C': return Quantity::angle;
        case 'H': return s.control.is_lathe() ? Quantity::angle : Quantity::plain;
        case 'F': return Quantity::feed;
        case 'K':
            return !s.control.is_lathe() && !s.control.haas && hole_of(s) != 0 ? Quantity::plain : Quantity::length;
        case 'P': return hole_of(s) != 0 ? Quantity::milliseconds : Quantity::plain;
        case 'X':
        case 'Y':
        case 'Z':
        case 'U':
        case 'V':
        case 'W':
        case 'I':
        case 'J':
        case 'Q':
        case 'R': return Quantity::length;
        default: return Quantity::plain;
    }
}

namespace {

/// Where most lengths have a point, those without one may lack it.
void note_point(FanucState& s, const Value& v) {
    constexpr double small = 1000;  // increments
    if (!v.literal.integer)
        ++s.unit().lengths_with_point;
    else if (s.control.whole_numbers == WholeNumbers::increments && std::abs(v.number()) < small && v.number() != 0)
        s.unit().small_lengths.emplace_back(v.begin, v.end);
}

}  // namespace

Value scaled(FanucState& s, const Value& v, Quantity q) {
    if (q == Quantity::plain || !v.found) return v;
    if (q == Quantity::length && v.is_literal()) note_point(s, v);
    const bool thousands = q == Quantity::milliseconds || q == Quantity::thousandths;
    if (!v.is_literal()) return q == Quantity::milliseconds ? divided(s, v) : v;
    if (!v.literal.integer || v.number() == 0) return v;
    if (thousands) return shifted(v, 3);
    const bool whole_feed = q == Quantity::feed && !s.control.haas && !s.per_rev && s.inch.said() == false;
    if (whole_feed) return v;  // 1 mm/min either way
    say_whole_numbers(s, v);
    if (s.control.whole_numbers == WholeNumbers::units) return v;
    if (q == Quantity::feed && !s.control.haas) note_point(s, v);  // per revolution: a hundredth and less
    switch (q) {
        case Quantity::length: return in_increments(s, v, 3, 4);
        case Quantity::angle: return shifted(v, 3);
        default: return feed(s, v);
    }
}

namespace {

void round_in(FanucState& s, ExprId id, const Value& one, bool angle, int depth) {
    constexpr int deepest = 100;
    if (id == no_expr || depth > deepest) return;
    const program::Expr e = s.unit().exprs[id];
    const auto within = [&](ExprId x) { round_in(s, x, one, angle, depth + 1); };
    switch (e.kind) {
        case program::ExprKind::unary:
        case program::ExprKind::qualified: return within(e.a);
        case program::ExprKind::binary: within(e.a); return within(e.b);
        case program::ExprKind::function: break;
        default: return;
    }
    const std::vector<ExprId> arguments(s.unit().children.begin() + e.b, s.unit().children.begin() + e.b + e.count);
    if (e.op != static_cast<std::uint8_t>(program::Function::round_away) || arguments.size() != 1) {
        std::for_each(arguments.begin(), arguments.end(), within);
        return;
    }
    const ExprId step = as_expr(s, angle ? shifted(one, 3) : in_increments(s, one, 3, 4));
    const ExprId count = s.build().binary(Operator::divide, arguments[0], step, e.begin, e.end);
    const ExprId whole = s.build().function(program::Function::round_away, {count}, e.begin, e.end);
    program::Expr scaled_back;
    scaled_back.kind = program::ExprKind::binary;
    scaled_back.op = static_cast<std::uint8_t>(Operator::multiply);
    scaled_back.a = whole;
    scaled_back.b = step;
    scaled_back.begin = e.begin;
    scaled_back.end = e.end;
    s.unit().exprs[id] = scaled_back;
}

}  // namespace

void round_to_increments(FanucState& s, const Address& a) {
    if (a.value.expr == no_expr) return;
    const Quantity q = quantity_of(s, a.letter);
    if (q != Quantity::length && q != Quantity::angle) return;
    Value one;
    one.found = true;
    one.literal = base::scan_decimal("1");
    one.begin = a.begin;
    one.end = a.begin;
    round_in(s, a.value.expr, one, q == Quantity::angle, 0);
}

void put_value(FanucState& s, Order order, Code code, const Value& v, const Address& a) {
    s.facts.letters |= 1ULL << static_cast<unsigned>(code);
    add_value(s, order, code, v, a.begin, a.end);
}

namespace {

/// S1000.0: the control may stop there.
void say_pointed_speed(FanucState& s, const Address& a) {
    if (a.letter != 'S' || s.control.haas || !a.value.is_literal() || a.value.literal.integer || s.pointed_speed_said)
        return;
    s.pointed_speed_said = true;
    base::Diagnostic d;
    d.severity = base::Severity::warning;
    d.code = base::codes::assumption;
    d.where = s.build().span(a.begin, a.end);
    d.text = "S is a whole number: with a point it is an alarm of the control (7), unless a parameter (3451 bit 2 of "
             "mills) allows one decimal, which is rounded; it is taken as rounded here and in the rest of the program";
    d.remedy = "write S without a point";
    s.diagnostics.add(std::move(d));
}

}  // namespace

void emit_address(FanucState& s, Address& a) {
    a.used = true;
    say_pointed_speed(s, a);
    if (surface_word(s, a) || corner_word(s, a)) return;
    if (a.letter == 'T' && s.control.is_lathe()) return turret(s, a);
    if (const auto code = polar_code(s, a.letter)) {
        if (s.incremental) return add_problem(s, Code::unsupported, a.begin, a.end, "an incremental polar coordinate");
        const Quantity q = *code == Code::polar_angle ? Quantity::angle : Quantity::length;
        return put_value(s, Order::value, *code, scaled(s, a.value, q), a);
    }
    const Value v = scaled(s, a.value, quantity_of(s, a.letter));
    if (const auto code = incremental_code(s, a.letter)) {
        Value by = v;
        by.expr = s.build().with_reference(Reference::incremental, as_expr(s, v), a.begin, a.end);
        return put_value(s, Order::value, *code, by, a);
    }
    const Code code = code_of(s, a.letter);
    const bool technology = code == Code::feed || code == Code::spindle || code == Code::tool;
    put_value(s, technology ? Order::technology : Order::value, code, v, a);
}

}  // namespace obrys::read::rs274
