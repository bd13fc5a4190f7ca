#include "read/sinumerik/expression.hpp"

#include <array>
#include <optional>

namespace obrys::read::sinumerik {

using program::Expr;
using program::ExprId;
using program::ExprKind;
using program::no_expr;
using program::Operator;

namespace {

struct Binary {
    std::string_view text;
    Operator op;
    Level level;
};

// Longer signs before their beginnings.
constexpr std::array binary_signs{
    Binary{"==", Operator::equal, Level::compare},      Binary{"<>", Operator::not_equal, Level::compare},
    Binary{"<=", Operator::less_equal, Level::compare}, Binary{">=", Operator::greater_equal, Level::compare},
    Binary{"<<", Operator::concat, Level::concat},      Binary{"<", Operator::less, Level::compare},
    Binary{">", Operator::greater, Level::compare},     Binary{"+", Operator::add, Level::add},
    Binary{"-", Operator::subtract, Level::add},        Binary{"*", Operator::multiply, Level::multiply},
    Binary{"/", Operator::divide, Level::multiply},     Binary{":", Operator::frame_chain, Level::multiply},
};
constexpr std::array words{
    Binary{"OR", Operator::logical_or, Level::logical_or},    Binary{"XOR", Operator::logical_xor, Level::logical_xor},
    Binary{"AND", Operator::logical_and, Level::logical_and}, Binary{"B_OR", Operator::bit_or, Level::bit_or},
    Binary{"B_XOR", Operator::bit_xor, Level::bit_xor},       Binary{"B_AND", Operator::bit_and, Level::bit_and},
    Binary{"DIV", Operator::integer_divide, Level::multiply}, Binary{"MOD", Operator::modulo, Level::multiply},
};

std::optional<Binary> operator_here(State& s) {
    Cursor& c = s.cursor;
    c.skip_blanks();
    if (c.p == c.end) return std::nullopt;
    if (base::is_letter(*c.p)) {
        const std::string_view name = c.name();
        for (const Binary& b : words)
            if (base::equals_ignoring_case(b.text, name)) return b;
        return std::nullopt;
    }
    const std::string_view rest(c.p, static_cast<std::size_t>(c.end - c.p));
    for (const Binary& b : binary_signs)
        if (rest.starts_with(b.text)) return b;
    return std::nullopt;
}

}  // namespace

ExprId add_expr(State& s, Expr e, const char* from) {
    return s.build.add(e, s.cursor.from(from), s.cursor.to(s.cursor.p));
}

ExprId read_level(State& s, Level loosest, int depth) {
    s.cursor.skip_blanks();
    const char* from = s.cursor.p;
    ExprId left = read_operand(s, depth);
    while (left != no_expr) {
        const char* behind = s.cursor.p;
        const auto found = operator_here(s);
        if (!found || found->level < loosest) {
            s.cursor.p = behind;  // the blanks in front of what follows are not the expression's
            break;
        }
        if (++s.operators > longest) {
            fail_here(s, "the expression has more than 1000 operators", "split it over several assignments");
            return no_expr;
        }
        s.cursor.p += found->text.size();
        const ExprId right = read_level(s, static_cast<Level>(static_cast<int>(found->level) + 1), depth);
        if (right == no_expr) return no_expr;
        Expr e;
        e.kind = ExprKind::binary;
        e.op = static_cast<std::uint8_t>(found->op);
        e.a = left;
        e.b = right;
        left = add_expr(s, e, from);
    }
    return left;
}

ExprId read_expression(State& s, Level loosest) {
    s.operators = 0;
    return read_level(s, loosest, 0);
}

}  // namespace obrys::read::sinumerik
