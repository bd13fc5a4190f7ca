#pragma once
/// What the parts of the readers of Klartext and DIN/ISO share. Private to the folder.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "dialect/heidenhain/cycles.hpp"
#include "program/builder.hpp"
#include "read/heidenhain/scanner.hpp"

namespace obrys::read::heidenhain {

using program::Code;
using program::ExprId;
using program::Modal;
using program::StatementKind;

/// What holds from block to block in DIN/ISO, as the text has it. A block may be reached by another way than through
/// the text, so that G90 and G91, G43 and G44 and, behind a label, the path function are the run's alone.
struct IsoState {
    int motion = -1;                      ///< G00 … G06, G10 … G16; -1: not known here, what the run did last holds
    bool uses_incremental = false;        ///< G91 stood somewhere before
    std::optional<bool> incremental;      ///< G91 or G90 stands in the block at hand, before the scanner
    std::optional<Modal> pending;         ///< G90 or G91 behind the coordinates of its block: from the next one on
    ExprId departure = program::no_expr;  ///< G27: radius of the departure that the next block makes
    ExprId departure_feed = program::no_expr;
    std::uint8_t departure_skip = 0;
    bool ended_by_star = false;  ///< the block before
};

struct State {
    program::Builder build;
    Scanner in;
    std::uint32_t block = 0;      ///< where the block at hand begins
    std::uint32_t number = 0;     ///< of the block at hand, 0 where it has none
    std::size_t statements = 0;   ///< how many there were before it
    bool numbered = false;        ///< … with a number
    bool first_numbered = false;  ///< the text's first block has a number: a line without one goes on with a cycle
    bool failed = false;          ///< a complaint was made about it
    bool rapid_counts = false;    ///< FMAX in the block at hand is how it moves
    bool rapid_is_word = false;   ///< … and stands in the tree as a word of its own: arcs, APPR, DEP
    bool machine_counts = false;  ///< M91 in it, too
    bool rapid_said = false, feed_said = false;  ///< FMAX and a feed in numbers in the block at hand
    bool exponents = false;                      ///< the block's numbers may have one (splines)
    std::string name{};                          ///< of BEGIN PGM
    bool begun = false;                          ///< BEGIN PGM or %NAME G71 was read
    bool ended = false;  ///< … and its END PGM or last %NAME: what follows is no part of the program
    std::uint32_t last_path = program::no_target;   ///< the block before, where it is a contour element
    bool after_stop = false;                        ///< the block before was STOP: a comment is its message
    std::uint32_t open_cycle = program::no_target;  ///< entry in Unit::cycles that further lines belong to
    /// Of the numbered form, bit n for line n of the open cycle: that must stand there, and that were read.
    std::uint32_t lines_needed = 0, lines_read = 0;
    IsoState iso;

    [[nodiscard]] std::uint32_t lines_missing() const { return lines_needed & ~lines_read; }
};

[[nodiscard]] inline program::CycleDefinition& open_cycle(State& s) { return s.build.unit().cycles[s.open_cycle]; }

/// Complains about the text from `begin` to the scanner, or about what stands there; once a block.
void fail(State& s, std::uint32_t begin, std::string text, std::string remedy = {});
/// About the thing that stands at the scanner, which is passed over.
void fail_here(State& s, std::string text, std::string remedy = {});
/// Takes the word, or complains that it is due.
bool expect(State& s, std::string_view word);
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
void read_block(State& s);  ///< block.cpp
/// The text before the scanner is read; where that is.
std::uint32_t lay_aside(State& s, const base::Sources& sources);                         ///< read.cpp
[[nodiscard]] program::Unit begin_unit(std::uint32_t file, const base::Source& source);  ///< read.cpp
/// Postprocessors and editors write headings in front of the program, which begins in the line of byte `begin` (npos:
/// there is none).
void skip_preface(State& s, std::size_t begin, std::string_view mark, base::Diagnostics& diagnostics);
/// A program that was cut off on its way here has no last block; what an editor has left behind it is not run.
void check_end(State& s, std::string_view first, std::string_view last, base::Diagnostics& diagnostics);
void read_comment(State& s, bool after_stop);  ///< block.cpp: behind STOP it is a message, else nothing
/// A stop of the program, unless an M0, M2 or M30 stands among the words from `words` on.
void stop_here(State& s, std::size_t words, std::uint32_t begin, std::uint32_t end);
bool read_path_block(State& s, std::string_view word);  ///< path_block.cpp: L C CC CR CT CP LP CTP CHF RND
void read_words(State& s, bool arc);                    ///< words of a path block up to its end
/// The words of a block without motion: M and F.
void read_functions(State& s);
/// Complains about a word, begun at `begin`, whose number has an exponent.
void no_exponent(State& s, std::uint32_t begin);
[[nodiscard]] std::optional<Code> axis_of(char c);  ///< X … W
void read_feed(State& s);                           ///< F and its relatives, the scanner stands on the F
[[nodiscard]] bool has_rapid(State& s);             ///< the rest of the block holds F MAX: its motion is rapid
/// CHF and RND belong to the corner behind the element before them: they become words of that element's block.
void read_corner(State& s, bool chamfer, bool has_r, std::uint32_t begin);  ///< `has_r`: R stands before the value
/// The block at hand, whose words go to the last statement, is left out by the switch that leaves out that one.
[[nodiscard]] bool skipped_with_last(State& s);
void read_word(State& s, bool arc);                        ///< one of them
bool read_special_block(State& s, std::string_view word);  ///< special_block.cpp: APPR DEP FL … SPL PLANE
bool read_pattern_block(State& s, std::string_view word);  ///< pattern_block.cpp: PATTERN DEF, SEL PATTERN
/// contour_block.cpp: CONTOUR DEF, SEL CONTOUR, DECLARE CONTOUR, QC1 = …
bool read_contour_block(State& s, std::string_view word);
/// "TNC:\DIR\NAME.H", the same without quotes, or QS5; `due` says what is missing where there is none.
[[nodiscard]] ExprId read_file_name(State& s, std::string_view due);
bool read_shop_block(State& s, std::string_view word);          ///< shop_block.cpp: SEL TABLE, TRANS DATUM
bool read_shop_function(State& s, int n, std::uint32_t begin);  ///< shop_block.cpp: FN 15 … 17, 25 … 28
void read_m(State& s, std::uint32_t begin);                     ///< m_word.cpp: the number of an M function
void read_tool_block(State& s, std::uint32_t begin);            ///< tool_block.cpp
void read_tool(State& s);                                       ///< its number, name or parameter, where one stands
void read_oversize(State& s, std::uint32_t begin);              ///< DL, DR, DR2
void preselect_tool(State& s, std::uint32_t begin);             ///< the next tool, which is made ready
bool read_function(State& s);                                   ///< function.cpp: FN n:
/// The Klartext form behind FN n:, a statement for it included.
void read_numbered(State& s, int n, std::uint32_t begin);
void read_assigned(State& s, ExprId to, ExprId value);
/// An FN function that is not run, up to the block's end.
void leave_function(State& s, int n, std::uint32_t begin);
/// FN 0 … 8 and 13 of their values.
void assign_function(State& s, int n, ExprId to, const std::vector<ExprId>& values);
[[nodiscard]] std::optional<program::Operator> comparison_of(int n);  ///< of FN 9 … FN 12
[[nodiscard]] ExprId read_compared(State& s);                         ///< a value or text
void stop_with_error(State& s, ExprId number, std::uint32_t begin);   ///< FN 14
void read_assignment(State& s);                                       ///< function.cpp: Q5 = formula
void read_label_block(State& s);                                      ///< label.cpp: LBL
void read_call_block(State& s);                                       ///< label.cpp: CALL LBL, CALL PGM
[[nodiscard]] ExprId read_label_name(State& s);
void call_label(State& s, ExprId label, ExprId repeats);
/// The name of a program, and the call; `suffix` is what the language adds to a name without one.
void read_program_call(State& s, std::string_view behind, std::string_view suffix);
void read_cycle_block(State& s);    ///< cycle.cpp: CYCL DEF, CYCL CALL
void read_global_values(State& s);  ///< cycle.cpp: GLOBAL DEF
bool read_cycle_line(State& s);     ///< a further line of the open cycle; false where it is none
/// Q200=2 of the named form; false where none stands here.
[[nodiscard]] bool read_parameter_line(State& s);
// The following ones: cycle_names.cpp
void read_name_word(State& s);  ///< a word of the cycle's name, in whatever language
/// The words in front of a value: `SET UP`, `V.ZEIT`, `HSC-MODE:`.
[[nodiscard]] std::string read_keyword(State& s);
void read_names(State& s);  ///< labels of contours and names of programs
void read_program_name(State& s);
[[nodiscard]] ExprId read_sense(State& s);  ///< DR+ and DR-: the sign alone
void read_named(State& s);                  ///< Q200=2 … of the open cycle
/// No further line belongs to the open cycle: complains where one is missing.
void end_cycle(State& s);
void start_cycle(State& s, int number, const dialect::heidenhain::Cycle* cycle, std::uint32_t begin);
void add_setting(State& s, const dialect::heidenhain::CycleParameter& p, ExprId value, bool incremental,
                 std::uint32_t begin);
/// FN 18: what ID, NR and IDX mean, as an expression; `index` may be no_expr.
[[nodiscard]] ExprId system_datum(State& s, ExprId id, ExprId nr, ExprId index, std::uint32_t begin);
/// An approach or departure by an arc of that radius and a line; the statement's first word, its others follow.
void add_smooth(State& s, bool departure, ExprId radius, std::uint32_t begin);
void resolve_labels(State& s);  ///< label.cpp, at the end
[[nodiscard]] std::string program_name(std::string_view path);
/// As above; with the suffix where it is not .H, which a name without one has.
[[nodiscard]] std::string called_name(std::string_view path, std::string_view suffix);
/// GOTO LBL behind a condition.
void read_goto(State& s, ExprId condition);

}  // namespace obrys::read::heidenhain
