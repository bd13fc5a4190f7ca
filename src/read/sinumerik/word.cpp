#include "read/sinumerik/word.hpp"

#include <array>
#include <limits>

#include "read/sinumerik/call.hpp"
#include "read/sinumerik/expression.hpp"

namespace obrys::read::sinumerik {

namespace words = dialect::sinumerik;
using program::Code;
using program::ExprId;
using program::ExprKind;
using program::Form;
using program::no_expr;

namespace {

void add_literal(State& s, Code code, const Number& n, bool negative, const char* from) {
    const std::int64_t mantissa = negative ? -n.mantissa : n.mantissa;
    const bool fits = n.plain && n.decimals <= 9 && mantissa >= std::numeric_limits<std::int32_t>::min() &&
                      mantissa <= std::numeric_limits<std::int32_t>::max();
    if (fits) return add_word(s, code, static_cast<Form>(n.decimals), static_cast<std::int32_t>(mantissa), from);
    s.unit.numbers.push_back(negative ? -n.value : n.value);
    add_word(s, code, Form::pooled, static_cast<std::int32_t>(s.unit.numbers.size() - 1), from);
}

void add_named(State& s, Code code, std::string_view name, ExprId index, ExprId value, const char* from,
               program::NamedKind kind = program::NamedKind::extended, Code plain = Code::named_value) {
    s.unit.named.push_back({intern(s, name), index, value, kind, plain});
    add_word(s, code, Form::index, static_cast<std::int32_t>(s.unit.named.size() - 1), from);
}

void read_g(State& s, const Number& n, bool negative, const char* from) {
    if (negative || !n.plain || n.decimals != 0 || n.mantissa > 9999)
        return add_problem(s, Code::unknown, from, "no such G function");
    const auto g = words::find_g(static_cast<int>(n.mantissa));
    if (!g) return add_problem(s, Code::unknown, from, "no such G function");
    switch (g->use) {
        case words::Use::modal:
            if (g->modal == program::Modal::exact_stop_block)
                add_ignored(s, from, s.cursor.p);  // not told by the stream
            return add_word(s, Code::modal, Form::index, program::modal_word(g->modal, g->code), from);
        case words::Use::ignored: return add_ignored(s, from, s.cursor.p);
        case words::Use::unsupported_block: skip_line(s); [[fallthrough]];
        default: return add_problem(s, Code::unsupported, from, g->reason);
    }
}

/// `G=expr`, `G[group]=expr`.
void read_computed_g(State& s, const char* from) {
    Cursor& c = s.cursor;
    const char* back = c.p;
    if (c.take_assignment()) {
        c.skip_blanks();
        const Number n = read_number(s);
        if (n.found && (c.at_end() || is_name_start(c.peek()))) return read_g(s, n, false, from);
        c.p = back;
    }
    skip_operand(s);
    if (!s.failed) add_problem(s, Code::unsupported, from, "computed G function");
}

/// Axes and addresses with a number behind the letter: X1=, S2=, M2=, R1=.
void read_extended(State& s, char letter, const Number& number, const char* from) {
    Cursor& c = s.cursor;
    const std::string_view name(from, static_cast<std::size_t>(c.p - from));
    constexpr std::string_view centre = "IJK", extended = "SMHTD", axes = "XYZABCUVWEQO";
    if (letter == 'R') {
        c.p = from;
        return read_assignment(s);
    }
    const auto* entry = words::find_word(base::to_upper(name));  // A3=, B3=, C3=: orientation, no axes
    if (entry != nullptr && entry->use == words::Use::unsupported) {
        skip_operand(s);
        if (!s.failed) add_problem(s, Code::unsupported, from, entry->reason);
        return;
    }
    if (number.value == 1 && centre.find(letter) != std::string_view::npos)
        return read_value(s, letter == 'I' ? Code::i1 : letter == 'J' ? Code::j1 : Code::k1, from);
    const bool is_axis = axes.find(letter) != std::string_view::npos;
    if (!is_axis && extended.find(letter) == std::string_view::npos) {
        skip_operand(s);
        if (!s.failed) add_problem(s, Code::unknown, from, {});
        return;
    }
    c.take_assignment();
    const ExprId value = read_expression(s);
    if (value == no_expr) return;
    if (is_axis) return add_named(s, Code::named_axis, name, no_expr, value, from);
    const char* behind = c.p;
    c.p = from + 1;
    const ExprId index = read_expression(s, Level::unary);
    c.p = behind;
    add_named(s, Code::named_value, name.substr(0, 1), index, value, from, program::NamedKind::extended,
              words::address_code(letter));
}

/// F[X]=, S[2]=, X[1]=: an address with an index in brackets.
void read_bracketed(State& s, std::string_view name, Code plain, const char* from,
                    program::NamedKind kind = program::NamedKind::extended) {
    Cursor& c = s.cursor;
    ++c.p;
    const ExprId index = read_expression(s);
    if (index == no_expr) return;
    if (!c.take(']')) return fail_here(s, "expected ']', found " + here(s), "close the index");
    if (!c.take_assignment()) return fail_here(s, "expected '=' behind the index, found " + here(s));
    const ExprId value = read_expression(s);
    if (value == no_expr) return;
    const bool is_axis = plain == Code::named_axis || (plain >= Code::x && plain <= Code::w);
    add_named(s, is_axis ? Code::named_axis : Code::named_value, name, index, value, from, kind, plain);
}

void read_literal(State& s, char letter, const char* from) {
    Cursor& c = s.cursor;
    const bool is_signed = c.peek() == '+' || c.peek() == '-';
    const bool negative = c.peek() == '-';
    if (is_signed) ++c.p;
    c.skip_blanks();
    const char* digits = c.p;
    const Number n = read_number(s);
    if (s.failed) return;
    if (!n.found) return fail_here(s, std::string("expected a number behind ") + letter + ", found " + here(s));
    const char* behind = c.p;
    if (n.integer && !is_signed && digits == from + 1) {
        if (c.at_assignment()) return read_extended(s, letter, n, from);
        c.skip_blanks();
        if (c.peek() == '[') {
            skip_operand(s);
            if (!s.failed) add_problem(s, Code::unknown, from, {});
            return;
        }
    }
    c.p = behind;
    if (letter == 'G') return read_g(s, n, negative, from);
    if (letter == 'L' && n.integer && !is_signed && digits == from + 1) return read_call(s, from, behind);
    const Code code = words::address_code(letter);
    if (code == Code::unknown)
        return add_problem(s, Code::unknown, from,
                           letter == 'N' ? "a block number stands only at the begin of a block" : "");
    add_literal(s, code, n, negative, from);
}

}  // namespace

void skip_line(State& s) {
    Cursor& c = s.cursor;
    bool quoted = false;
    while (c.p < c.end && (quoted || *c.p != ';')) {
        if (*c.p == '"') quoted = !quoted;
        ++c.p;
    }
    while (base::is_blank(c.p[-1])) --c.p;
}

void skip_operand(State& s) {
    std::vector<ExprId> dropped;
    const char* end = s.cursor.p;
    while (s.cursor.take('[')) {
        do {
            if (read_expression(s) == no_expr) return;
        } while (s.cursor.take(','));
        if (!s.cursor.take(']')) return fail_here(s, "expected ']', found " + here(s), "close the index");
        end = s.cursor.p;
    }
    if (s.cursor.take('(')) {
        --s.cursor.p;
        if (!read_arguments(s, dropped)) return;
        end = s.cursor.p;
    }
    if (s.cursor.take_assignment()) {
        if (read_expression(s) == no_expr) return;
        end = s.cursor.p;
    }
    s.cursor.p = end;
}

void read_value(State& s, Code code, const char* from) {
    s.cursor.take('=');
    const ExprId value = read_expression(s);
    if (value == no_expr) return;
    if (s.unit.exprs[value].kind == ExprKind::number && value + 1 == s.unit.exprs.size()) {
        const auto pooled = static_cast<std::int32_t>(s.unit.exprs[value].a);
        s.unit.exprs.pop_back();
        return add_word(s, code, Form::pooled, pooled, from);
    }
    add_word(s, code, Form::expression, static_cast<std::int32_t>(value), from);
}

void read_assignment(State& s) {
    const char* from = s.cursor.p;
    const ExprId target = read_target(s);
    if (target == no_expr) return;
    if (!s.cursor.take_assignment())
        return fail_here(s, "expected '=', found " + here(s), "a block cannot consist of a value alone");
    const ExprId value = read_expression(s);
    if (value == no_expr) return;
    s.unit.assigns.push_back({target, value});
    add_word(s, Code::assign, Form::index, static_cast<std::int32_t>(s.unit.assigns.size() - 1), from);
}

void read_unknown(State& s, std::string_view reason) {
    const char* from = s.cursor.p;
    s.cursor.p += s.cursor.name().size();
    skip_operand(s);
    if (!s.failed) add_problem(s, Code::unknown, from, reason);
}

void read_address(State& s) {
    Cursor& c = s.cursor;
    const char* from = c.p++;
    const char letter = base::upper(*from);
    c.skip_blanks();
    if (c.at_assignment()) {
        if (letter == 'G') return read_computed_g(s, from);
        const Code code = words::address_code(letter);
        if (code != Code::unknown) return read_value(s, code, from);
        c.p = from;
        return read_assignment(s);
    }
    if (c.peek() == '[') {
        if (letter == 'G') return read_computed_g(s, from);
        const Code code = words::address_code(letter);
        if (code != Code::unknown) return read_bracketed(s, {from, 1}, code, from);
        c.p = from;
        return read_assignment(s);
    }
    const char next = c.peek();
    if (base::is_digit(next) || next == '.' || next == '+' || next == '-') return read_literal(s, letter, from);
    const std::string name(1, letter);
    fail(s, from, from + 1, "the address " + name + " has no value", "write " + name + "10 or " + name + "=…");
}

void read_table_word(State& s, const words::Entry& entry, std::size_t length) {
    Cursor& c = s.cursor;
    const char* from = c.p;
    c.p += length;
    const char* name_end = c.p;
    switch (entry.use) {
        case words::Use::modal:
            return add_word(s, Code::modal, Form::index, program::modal_word(static_cast<program::Modal>(entry.value)),
                            from);
        case words::Use::ignored:
            skip_operand(s);
            if (!s.failed) add_ignored(s, from, name_end);
            return;
        case words::Use::unsupported_block: skip_line(s); [[fallthrough]];
        case words::Use::unsupported:
            skip_operand(s);
            if (!s.failed) add_problem(s, Code::unsupported, from, entry.reason);
            return;
        default: break;
    }
    const bool named = entry.use == words::Use::named_value;
    const Code code = named ? Code::named_value : static_cast<Code>(entry.value);
    const auto kind = named ? static_cast<program::NamedKind>(entry.value) : program::NamedKind::extended;
    c.skip_blanks();
    if (c.peek() == '[') return read_bracketed(s, entry.name, code, from, kind);
    if (!c.at_assignment()) {
        c.p = name_end;
        const std::string name(entry.name);
        return fail(s, from, name_end, name + " has no value", "write " + name + "=…");
    }
    if (code != Code::named_value && code != Code::named_axis) return read_value(s, code, from);
    c.take_assignment();
    const ExprId value = read_expression(s);
    if (value != no_expr) add_named(s, code, entry.name, no_expr, value, from, kind);
}

void read_machine_axis(State& s, std::size_t length) {
    Cursor& c = s.cursor;
    const char* from = c.p;
    c.p += length;
    c.take_assignment();
    const ExprId value = read_expression(s);
    if (value != no_expr) add_named(s, Code::named_axis, {from, length}, no_expr, value, from);
}

}  // namespace obrys::read::sinumerik
