#pragma once
/// Expressions. Each function returns no_expr after a complaint; the caller gives up the rest of the line then.

#include "read/sinumerik/state.hpp"

namespace obrys::read::sinumerik {

/// Binding strength of operators, loosest first (Job Planning manual, priority of the operations).
enum class Level : std::uint8_t {
    compare,
    concat,
    logical_or,
    logical_xor,
    logical_and,
    bit_or,
    bit_xor,
    bit_and,
    add,
    multiply,
    unary
};

program::ExprId read_expression(State& s, Level loosest = Level::compare);
/// A variable, parameter or system variable that can be written to.
program::ExprId read_target(State& s);
/// `(a,,b)` with the cursor on the parenthesis; false after a complaint. Left-out arguments are no_expr.
bool read_arguments(State& s, std::vector<program::ExprId>& out, int depth = 0);
/// A text that stands in the source as [from, to), e.g. a label.
program::ExprId read_text_literal(State& s, std::string_view text, const char* from, const char* to);

// Parts shared between expression.cpp, operand.cpp and constant.cpp
program::ExprId read_operand(State& s, int depth);
program::ExprId read_level(State& s, Level loosest, int depth);
program::ExprId read_string(State& s);
program::ExprId read_quoted_constant(State& s);
program::ExprId add_number(State& s, double value, bool integer, const char* from);
program::ExprId add_text(State& s, std::string text, const char* from);
program::ExprId add_expr(State& s, program::Expr e, const char* from);
/// An unsigned number at the cursor, with `EX` exponent; length 0 where there is none. The cursor moves behind it.
struct Number {
    double value = 0;
    bool integer = false;
    bool found = false;
    bool plain = false;  ///< mantissa and decimals are set
    std::int64_t mantissa = 0;
    int decimals = 0;
};
Number read_number(State& s);
inline constexpr int deepest = 200;   ///< nesting of parentheses, functions and signs
inline constexpr int longest = 1000;  ///< operators of one expression: the tree is walked recursively
inline constexpr std::size_t most_arguments = 1000;

}  // namespace obrys::read::sinumerik
