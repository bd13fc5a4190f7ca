#include <array>
#include <optional>

#include "base/number.hpp"
#include "dialect/sinumerik/tables.hpp"
#include "read/sinumerik/read.hpp"
#include "read/sinumerik/expression.hpp"

namespace obrys::read::sinumerik {

namespace words = dialect::sinumerik;
using program::Expr;
using program::ExprId;
using program::ExprKind;
using program::no_expr;
using program::Operator;

namespace {

/// Stores children side by side and gives them to `e`.
void adopt(State& s, Expr& e, const std::vector<ExprId>& children) {
    e.b = static_cast<std::uint32_t>(s.unit.children.size());
    e.count = static_cast<std::uint16_t>(children.size());
    s.unit.children.insert(s.unit.children.end(), children.begin(), children.end());
}

/// `[a,b]` or `[a][b]` behind a variable.
bool read_indices(State& s, std::vector<ExprId>& out, int depth) {
    while (s.cursor.take('[')) {
        do {
            const ExprId index = read_level(s, Level::compare, depth + 1);
            if (index == no_expr) return false;
            out.push_back(index);
        } while (s.cursor.take(','));
        if (!s.cursor.take(']')) {
            fail_here(s, "expected ']', found " + here(s), "close the index");
            return false;
        }
    }
    if (out.size() > 3) {
        fail_here(s, "more than three indices");
        return false;
    }
    return true;
}

ExprId read_parameter(State& s, const char* from, std::string_view digits) {
    const auto number = base::parse_integer(digits);
    if (!number || *number > 0x7FFFFFFF) {
        fail(s, from, s.cursor.p, "the parameter number is too large");
        return no_expr;
    }
    Expr e;
    e.kind = ExprKind::parameter;
    e.a = static_cast<std::uint32_t>(*number);
    return add_expr(s, e, from);
}

/// Length of `R12` at the start of a name: digits only behind the letter, nothing where it is another name.
std::size_t parameter_length(State& s, std::string_view name) {
    if (name.size() < 2 || base::upper(name[0]) != 'R' || !base::is_digit(name[1])) return 0;
    std::size_t i = 1;
    while (i < name.size() && base::is_digit(name[i])) ++i;
    if (i < name.size() && (name[i] == '_' || s.is_variable(base::to_upper(name)))) return 0;
    return i;
}

ExprId read_indexed(State& s, Expr e, const char* from, int depth) {
    std::vector<ExprId> indices;
    if (s.cursor.take('[')) {
        --s.cursor.p;
        if (!read_indices(s, indices, depth)) return no_expr;
    }
    adopt(s, e, indices);
    return add_expr(s, e, from);
}

ExprId read_system_variable(State& s, int depth) {
    Cursor& c = s.cursor;
    const char* from = c.p++;
    const std::string_view name = c.name();
    if (name.empty()) {
        fail(s, from, c.p, "a system variable needs a name behind '$'");
        return no_expr;
    }
    if (const std::size_t n = parameter_length(s, name); n == name.size()) {
        c.p += n;
        return read_parameter(s, from, name.substr(1));
    }
    c.p += name.size();
    const std::string upper = base::to_upper({from, static_cast<std::size_t>(c.p - from)});
    Expr e;
    e.kind = ExprKind::system;
    e.op = static_cast<std::uint8_t>(words::find_system_variable(upper));
    e.a = s.names.id(upper);
    return read_indexed(s, e, from, depth);
}

ExprId read_function(State& s, std::string_view name, const char* from, int depth) {
    const std::string upper = base::to_upper(name);
    std::vector<ExprId> arguments;
    Expr e;
    if (const auto reference = words::find_reference(upper)) {
        if (!s.cursor.take('(')) return no_expr;
        const ExprId value = read_level(s, Level::compare, depth + 1);
        if (value == no_expr) return no_expr;
        if (!s.cursor.take(')')) {
            fail_here(s, "expected ')', found " + here(s), "close the parenthesis of " + upper);
            return no_expr;
        }
        e.kind = ExprKind::qualified;
        e.op = static_cast<std::uint8_t>(*reference);
        e.a = value;
        return add_expr(s, e, from);
    }
    if (!read_arguments(s, arguments, depth)) return no_expr;
    if (upper == "QU" && arguments.size() == 1 && arguments[0] != no_expr)
        return arguments[0];  // quick output, same value
    if (const auto function = words::find_function(upper)) {
        e.kind = ExprKind::function;
        e.op = static_cast<std::uint8_t>(*function);
    } else {
        e.kind = ExprKind::unknown_function;
        e.a = s.names.id(upper);
    }
    adopt(s, e, arguments);
    return add_expr(s, e, from);
}

ExprId read_named(State& s, int depth) {
    Cursor& c = s.cursor;
    const char* from = c.p;
    const std::string_view name = c.name();
    if (const std::size_t n = parameter_length(s, name); n > 0) {
        c.p += n;
        return read_parameter(s, from, name.substr(1, n - 1));
    }
    c.p += name.size();
    if (c.take('(')) {
        --c.p;
        return read_function(s, name, from, depth);
    }
    Expr e;
    if (base::equals_ignoring_case(name, "TRUE") || base::equals_ignoring_case(name, "FALSE")) {
        e.kind = ExprKind::boolean;
        e.a = name.size() == 4 ? 1 : 0;
        c.p = from + name.size();
        return add_expr(s, e, from);
    }
    if (base::equals_ignoring_case(name, "R") && c.take('[')) {
        const ExprId index = read_level(s, Level::compare, depth + 1);
        if (index == no_expr) return no_expr;
        if (!c.take(']')) {
            fail_here(s, "expected ']', found " + here(s), "close the index");
            return no_expr;
        }
        e.kind = ExprKind::parameter_at;
        e.a = index;
        return add_expr(s, e, from);
    }
    c.p = from + name.size();
    e.kind = ExprKind::variable;
    e.a = intern(s, name);
    return read_indexed(s, e, from, depth);
}

bool is_operator_word(std::string_view name) {
    constexpr std::array<std::string_view, 8> all{"AND", "OR", "XOR", "DIV", "MOD", "B_AND", "B_OR", "B_XOR"};
    for (const std::string_view w : all)
        if (base::equals_ignoring_case(w, name)) return true;
    return false;
}

/// A sign or NOT in front of an operand. A sign in front of a number becomes part of the number.
ExprId read_unary(State& s, Operator op, std::size_t length, int depth) {
    const char* from = s.cursor.p;
    s.cursor.p += length;
    const ExprId child = read_operand(s, depth + 1);
    if (child == no_expr) return no_expr;
    Expr& operand = s.unit.exprs[child];
    if (operand.kind == ExprKind::number && (op == Operator::negate || op == Operator::plus)) {
        if (op == Operator::negate) s.unit.numbers[operand.a] = -s.unit.numbers[operand.a];
        operand.begin = s.cursor.from(from);
        return child;
    }
    Expr e;
    e.kind = ExprKind::unary;
    e.op = static_cast<std::uint8_t>(op);
    e.a = child;
    return add_expr(s, e, from);
}

ExprId read_group(State& s, int depth) {
    const char* open = s.cursor.p++;
    const ExprId inner = read_level(s, Level::compare, depth + 1);
    if (inner == no_expr) return no_expr;
    if (s.cursor.take(')')) return inner;
    if (s.cursor.at_end())
        fail(s, open, open + 1, "this parenthesis is not closed", "add ')'");
    else
        fail_here(s, "expected ')' or an operator, found " + here(s));
    return no_expr;
}

/// `<<x` in front: x as text.
ExprId read_leading_concat(State& s, int depth) {
    const char* from = s.cursor.p;
    const ExprId empty = add_text(s, {}, from);
    s.cursor.p += 2;
    const ExprId right = read_level(s, Level::logical_or, depth + 1);
    if (right == no_expr) return no_expr;
    Expr e;
    e.kind = ExprKind::binary;
    e.op = static_cast<std::uint8_t>(Operator::concat);
    e.a = empty;
    e.b = right;
    return add_expr(s, e, from);
}

}  // namespace

bool read_arguments(State& s, std::vector<ExprId>& out, int depth) {
    Cursor& c = s.cursor;
    const char* open = c.p++;
    for (;;) {
        if (c.at_end()) {
            fail(s, open, open + 1, "this parenthesis is not closed", "add ')'");
            return false;
        }
        if (c.take(')')) {
            if (!out.empty()) out.push_back(no_expr);  // `(a,)`: the last argument is left out
            return true;
        }
        if (out.size() == most_arguments) {
            fail_here(s, "more than 1000 arguments");
            return false;
        }
        if (c.peek() == ',') {
            out.push_back(no_expr);
            ++c.p;
            continue;
        }
        const ExprId value = read_level(s, Level::compare, depth + 1);
        if (value == no_expr) return false;
        out.push_back(value);
        if (c.take(')')) return true;
        if (!c.take(',')) {
            if (c.at_end())
                fail(s, open, open + 1, "this parenthesis is not closed", "add ')'");
            else
                fail_here(s, "expected ',' or ')', found " + here(s));
            return false;
        }
    }
}

ExprId read_operand(State& s, int depth) {
    Cursor& c = s.cursor;
    c.skip_blanks();
    if (depth > deepest) {
        fail_here(s, "the expression is nested more than 200 deep", "split it over several assignments");
        return no_expr;
    }
    const char first = c.peek();
    if (base::is_digit(first) || first == '.') {
        const char* from = c.p;
        const Number n = read_number(s);
        if (n.found) return s.failed ? no_expr : add_number(s, n.value, n.integer, from);
    }
    switch (first) {
        case '"': return read_string(s);
        case '\'': return read_quoted_constant(s);
        case '$': return read_system_variable(s, depth);
        case '(': return read_group(s, depth);
        case '-': return read_unary(s, Operator::negate, 1, depth);
        case '+': return read_unary(s, Operator::plus, 1, depth);
        case '<':
            if (c.peek(1) == '<') return read_leading_concat(s, depth);
            break;
        default: break;
    }
    const std::string_view name = c.name();
    if (base::equals_ignoring_case(name, "NOT")) return read_unary(s, Operator::logical_not, 3, depth);
    if (base::equals_ignoring_case(name, "B_NOT")) return read_unary(s, Operator::bit_not, 5, depth);
    if (!name.empty() && !is_operator_word(name)) return read_named(s, depth);
    fail_here(s, "expected a value, found " + here(s));
    return no_expr;
}

ExprId read_target(State& s) {
    const char* from = s.cursor.p;
    const ExprId target = s.cursor.peek() == '$' ? read_system_variable(s, 0) : read_named(s, 0);
    if (target == no_expr) return no_expr;
    const ExprKind kind = s.unit.exprs[target].kind;
    if (kind == ExprKind::parameter || kind == ExprKind::parameter_at || kind == ExprKind::variable ||
        kind == ExprKind::system)
        return target;
    fail(s, from, s.cursor.p, "a value cannot be assigned to this");
    return no_expr;
}

bool is_own_word(std::string_view upper) {
    return words::find_word(upper) != nullptr || words::find_function(upper) || words::find_reference(upper) ||
           words::find_type(upper) || is_operator_word(upper) || upper == "NOT" || upper == "TO" || upper == "TRUE" ||
           upper == "FALSE";
}

}  // namespace obrys::read::sinumerik
