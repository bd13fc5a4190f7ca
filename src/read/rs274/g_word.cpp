#include <cmath>

#include "base/whole.hpp"

#include "read/rs274/state.hpp"

namespace obrys::read::rs274 {

using dialect::rs274::GCode;
using dialect::rs274::MCode;

namespace {

constexpr double number_tolerance = 1e-3;  // of ten times a G number, as LinuxCNC reads it

/// A number, or an expression without parameters.
std::optional<double> fixed_value(const State& s, const Value& v) {
    if (v.is_literal()) return v.number();
    return constant(s.unit(), v.expr);
}

std::optional<std::int32_t> near_integer(double x) {
    const double whole = std::round(x);
    if (!(std::abs(x - whole) <= number_tolerance)) return std::nullopt;
    return base::cut<std::int32_t>(whole, -1'000'000, 1'000'000);
}

std::string source(const State& s, std::uint32_t begin, std::uint32_t end) {
    return base::as_utf8(s.text.substr(begin, end - begin));
}

/// Index of a canned cycle in the traits.
std::optional<int> canned_index(const State& s, const GCode& g) {
    const auto canned = s.variant.traits->canned;
    for (std::size_t i = 0; i < canned.size(); ++i)
        if (canned[i].number == g.number) return static_cast<int>(i);
    return std::nullopt;
}

void add_g(State& s, const GCode& g, std::uint32_t begin, std::uint32_t end) {
    s.facts.g.push_back(g.number);
    if (g.group == 1) s.facts.motion = &g;
    if (g.axes == Axes::own || g.axes == Axes::own_required) s.facts.own = &g;
    if (g.use == Use::ignored) return s.build().ignored(source(s, begin, end), begin, end);
    if (g.use == Use::modal) return add_modal(s, g.order, g.modal, g.modal_number, begin, end);
    if (g.use == Use::canned)
        if (const auto index = canned_index(s, g)) return add_modal(s, g.order, Modal::canned, *index, begin, end);
    s.facts.refused = s.facts.refused || g.group <= 1;
    add_problem(s, Code::unsupported, begin, end, g.use == Use::canned ? "this canned cycle" : g.reason);
}

void add_m(State& s, const MCode& m, std::int32_t number, const Value& v, std::uint32_t begin, std::uint32_t end) {
    s.facts.m.push_back(static_cast<std::uint16_t>(number));
    switch (m.use) {
        case Use::ignored: s.build().ignored(source(s, begin, end), begin, end); [[fallthrough]];
        case Use::m_word: {
            Value plain = v;
            plain.literal = {};
            plain.literal.value = number;
            plain.literal.integer = true;
            plain.literal.decimal = base::Decimal{number, 0};
            plain.negative = false;
            plain.expr = no_expr;
            return add_value(s, m.order, Code::m, plain, begin, end);
        }
        case Use::modal: return add_modal(s, m.order, m.modal, 0, begin, end);
        case Use::unsupported: return add_problem(s, Code::unsupported, begin, end, m.reason);
        default: return fail(s, begin, end, "M" + std::to_string(number) + " stands first in its block");
    }
}

/// Of a G or M word that the tables have not.
std::string no_code(const State& s, std::uint32_t begin, std::uint32_t end) {
    const std::string word = source(s, begin, end), control(s.variant.control);
    const std::string kind(1, base::upper(s.text[begin]));
    if (s.variant.whole_lists) return control + " has no " + kind + " code " + word;
    return word + " is not among the " + kind + " codes that are known of " + control;
}

bool take_group(State& s, std::uint32_t& groups, std::uint8_t group, char letter, std::uint32_t begin,
                std::uint32_t end) {
    if (group >= 32) return true;
    const std::uint32_t bit = 1U << group;
    if ((groups & bit) != 0) {
        fail(s, begin, end, std::string("two ") + letter + " codes of one group in the block: " + source(s, begin, end),
             "write them in two blocks");
        return false;
    }
    groups |= bit;
    return true;
}

}  // namespace

std::optional<double> constant(const program::Unit& unit, ExprId e) {
    const program::Expr& x = unit.exprs[e];
    if (x.kind == program::ExprKind::number) return unit.numbers[x.a];
    const auto op = static_cast<program::Operator>(x.op);
    if (x.kind == program::ExprKind::unary && op == program::Operator::negate)
        if (const auto a = constant(unit, x.a)) return -*a;
    if (x.kind != program::ExprKind::binary) return std::nullopt;
    const auto a = constant(unit, x.a), b = constant(unit, x.b);
    if (!a || !b) return std::nullopt;
    switch (op) {
        case program::Operator::add: return *a + *b;
        case program::Operator::subtract: return *a - *b;
        case program::Operator::multiply: return *a * *b;
        case program::Operator::divide: return *b != 0 ? std::optional(*a / *b) : std::nullopt;
        default: return std::nullopt;
    }
}

void read_g(State& s, std::uint32_t begin) {
    const Value v = read_due_value(s, "G", begin);
    if (s.failed) return;
    const auto number = fixed_value(s, v);
    if (!number) {
        s.facts.refused = true;
        return add_problem(s, Code::unsupported, begin, v.end, "a computed G code");
    }
    const auto tenths = near_integer(*number * 10);
    const GCode* g = tenths ? dialect::rs274::find_g(s.variant, *tenths) : nullptr;
    if (g == nullptr) return fail(s, begin, v.end, no_code(s, begin, v.end));
    if (g->use == Use::modal && g->modal == Modal::canned_off) {
        s.facts.cancel = g;
        s.facts.cancel_begin = begin;
        s.facts.cancel_end = v.end;
        return;
    }
    if (take_group(s, s.facts.g_groups, g->group, 'G', begin, v.end)) add_g(s, *g, begin, v.end);
}

void take_cancel(State& s) {
    const GCode* g = s.facts.cancel;
    if (g == nullptr) return;
    const std::uint32_t begin = s.facts.cancel_begin, end = s.facts.cancel_end;
    if (s.facts.motion != nullptr) return s.build().ignored(source(s, begin, end), begin, end);
    s.facts.g_groups |= 1U << g->group;
    add_g(s, *g, begin, end);
}

void read_m(State& s, std::uint32_t begin) {
    const Value v = read_due_value(s, "M", begin);
    if (s.failed) return;
    const auto value = fixed_value(s, v);
    if (!value) return add_problem(s, Code::unsupported, begin, v.end, "a computed M code");
    const auto number = near_integer(*value);
    const MCode* m = number ? dialect::rs274::find_m(s.variant, *number) : nullptr;
    if (m == nullptr) return fail(s, begin, v.end, no_code(s, begin, v.end));
    if (take_group(s, s.facts.m_groups, m->group, 'M', begin, v.end)) add_m(s, *m, *number, v, begin, v.end);
}

}  // namespace obrys::read::rs274
