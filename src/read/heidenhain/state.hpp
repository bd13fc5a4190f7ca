#pragma once
/// What the parts of the Klartext reader share. Private to the folder.

#include <map>
#include <string>
#include <vector>

#include "program/builder.hpp"
#include "read/heidenhain/scanner.hpp"

namespace obrys::read::heidenhain {

using program::Code;
using program::ExprId;
using program::Modal;
using program::StatementKind;

struct State {
    program::Builder build;
    Scanner in;
    std::uint32_t block = 0;      ///< where the block at hand begins
    std::size_t statements = 0;   ///< how many there were before it
    bool numbered = false;        ///< … with a number
    bool first_numbered = false;  ///< the text's first block has a number: a line without one goes on with a cycle
    bool failed = false;          ///< a complaint was made about it
    bool begun = false;           ///< BEGIN PGM was read
    bool ended = false;           ///< … and its END PGM: what follows is no part of the program
    std::uint32_t last_path = program::no_target;   ///< the block before, where it is a contour element
    bool after_stop = false;                        ///< the block before was STOP: a comment is its message
    std::uint32_t open_cycle = program::no_target;  ///< entry in Unit::cycles that further lines belong to
};

/// Complains about the text from `begin` to the scanner, or about what stands there; once a block.
void fail(State& s, std::uint32_t begin, std::string text, std::string remedy = {});
/// About the thing that stands at the scanner, which is passed over.
void fail_here(State& s, std::string text, std::string remedy = {});
/// What stands here as the programmer wrote it; "end of block" at the end.
[[nodiscard]] std::string here(State& s);

// --- values (value.cpp)
/// A number or Q parameter with its sign, as words of a block hold it.
struct Value {
    bool found = false;
    bool negative = false;
    base::NumberScan literal;        ///< where `expr` is no_expr; unsigned
    ExprId expr = program::no_expr;  ///< a parameter, its sign included
    std::uint32_t begin = 0, end = 0;
    [[nodiscard]] bool is_literal() const { return expr == program::no_expr; }
    [[nodiscard]] double number() const { return negative ? -literal.value : literal.value; }
};
[[nodiscard]] Value read_value(State& s);
/// Complains about a number, begun at `begin`, that is too large for a double; the block is not run then.
void limit(State& s, base::NumberScan& n, std::uint32_t begin);
/// As an expression; no_expr where there is no value (a complaint was made).
[[nodiscard]] ExprId value_expr(State& s);
[[nodiscard]] ExprId as_expr(State& s, const Value& v);
/// Q5, QL5, QR5, QS5 at the scanner; no_expr and nothing moved where there is none.
[[nodiscard]] ExprId read_parameter(State& s);
[[nodiscard]] bool stands_parameter(const State& s);
/// A word with the value that stands at the scanner.
void value_word(State& s, Code code, std::uint32_t begin, bool incremental = false);

// --- formulas (formula.cpp)
[[nodiscard]] ExprId read_formula(State& s);
[[nodiscard]] ExprId read_text(State& s);  ///< "text" or QS parameter

// --- blocks
void read_block(State& s);                              ///< block.cpp
bool read_path_block(State& s, std::string_view word);  ///< path_block.cpp: L C CC CR CT CP LP CTP CHF RND
void read_words(State& s, bool arc);                    ///< words of a path block up to its end
void read_m(State& s, std::uint32_t begin);             ///< m_word.cpp: the number of an M function
void read_tool_block(State& s, std::uint32_t begin);    ///< tool_block.cpp
bool read_function(State& s);                           ///< function.cpp: FN n:
void read_assignment(State& s);                         ///< function.cpp: Q5 = formula
void read_label_block(State& s);                        ///< label.cpp: LBL
void read_call_block(State& s);                         ///< label.cpp: CALL LBL, CALL PGM
void read_cycle_block(State& s);                        ///< cycle.cpp: CYCL DEF, CYCL CALL
void resolve_labels(State& s);                          ///< label.cpp, at the end
[[nodiscard]] std::string program_name(std::string_view path);
/// GOTO LBL behind a condition.
void read_goto(State& s, ExprId condition);

}  // namespace obrys::read::heidenhain
