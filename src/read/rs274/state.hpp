#pragma once
/// What the parts of the RS-274 readers share: the line at hand, the units that grow, how a complaint is made. Private
/// to the folder.

#include <deque>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <unordered_map>
#include <vector>

#include "base/codes.hpp"
#include "dialect/rs274/tables.hpp"
#include "program/builder.hpp"
#include "read/rs274/line.hpp"

namespace obrys::read::rs274 {

using dialect::rs274::Axes;
using dialect::rs274::Dialect;
using dialect::rs274::Order;
using dialect::rs274::Use;
using program::Code;
using program::ExprId;
using program::Modal;
using program::no_expr;
using program::StatementKind;

/// A number, parameter or expression with its sign, as words hold it.
struct Value {
    bool found = false;
    bool negative = false;
    base::NumberScan literal;  ///< where `expr` is no_expr; unsigned
    ExprId expr = no_expr;     ///< sign included
    std::uint32_t begin = 0, end = 0;
    [[nodiscard]] bool is_literal() const { return expr == no_expr; }
    [[nodiscard]] double number() const { return negative ? -literal.value : literal.value; }
};

/// A word of the block at hand, until the block is known to be good and its words are put in order.
struct BlockWord {
    Order order = Order::value;
    Code code = Code::modal;
    program::Form form = program::Form::index;  ///< expression: `value` holds the word's value; index: payload
    Modal modal = Modal::rapid;
    std::int32_t payload = 0;
    Value value;
    std::string_view reason{};  ///< of unsupported and unknown words
    std::uint32_t begin = 0, end = 0;
};

/// What the words of the block at hand have in common, as far as its checks and its order ask.
struct Facts {
    std::uint64_t letters = 0;   ///< a bit for each Code with a value
    std::uint32_t g_groups = 0;  ///< a bit for each modal group that has its code
    std::uint32_t m_groups = 0;
    const dialect::rs274::GCode* motion = nullptr;  ///< of group 1
    const dialect::rs274::GCode* own = nullptr;     ///< one that takes the coordinates for itself
    std::vector<std::uint16_t> g, m;                ///< all of them, in the order of the text; G numbers times ten
    bool refused = false;                           ///< a word that is not run: what the coordinates mean is not known
    const dialect::rs274::GCode* cancel = nullptr;  ///< G80, which counts only where nothing else of group 1 stands
    std::uint32_t cancel_begin = 0, cancel_end = 0;
    [[nodiscard]] bool has(Code c) const { return (letters >> static_cast<unsigned>(c) & 1U) != 0; }
    [[nodiscard]] bool has_g(std::uint16_t tenths) const;
    [[nodiscard]] bool has_m(std::uint16_t first, std::uint16_t last) const;
    void clear();
};

/// The comment of a block that counts: its last one.
struct Comment {
    bool found = false;
    std::uint32_t begin = 0, end = 0;  ///< with its parentheses
};

/// An opened if, while, do or repeat whose end has not come yet.
struct Opened {
    StatementKind kind = StatementKind::if_;
    std::string label;
    std::vector<std::uint32_t> openers;          ///< its statement; of an if those of its elseif too
    std::vector<std::uint32_t> elses;            ///< else_ statements in order
    bool has_else = false;                       ///< not only elseif
    std::vector<std::size_t> breaks, continues;  ///< entries in Unit::jumps
    base::Span word;                             ///< for the message where its end is missing
};

/// Where a label of a structure was used first.
struct LabelUse {
    std::uint32_t begin = 0;
    std::uint32_t statement = 0;
    std::size_t depth = 0;     ///< branches around it
    std::uint64_t branch = 0;  ///< the innermost one (branch_at in structure.cpp)
};

/// A unit that grows.
struct Part {
    Part(std::uint32_t file, const Dialect& d, program::Names& names, base::Diagnostics& complaints,
         std::string_view text)
        : build(unit, names, complaints, text), diagnostics(complaints) {
        unit.file = file;
        unit.traits = d.traits;
    }
    Part(const Part&) = delete;
    Part& operator=(const Part&) = delete;

    program::Unit unit;
    program::Builder build;
    base::Diagnostics& diagnostics;
    enum class Kind : std::uint8_t { main, o_sub, program_number } kind = Kind::main;
    Part* outer = nullptr;  ///< in which an `o100 sub` stands
    std::string label;      ///< of its o-word: "100", "<FOO>"; empty in the main program
    std::string refused;    ///< label of a definition within it
    bool dropped = false;   ///< defined a second time: read, but not kept
    bool ended = false;     ///< what follows is not reached
    bool told_unreached = false;
    std::vector<Opened> opened;
    std::unordered_map<std::string, std::vector<std::size_t>> opened_by_label;  ///< places in `opened`
    std::map<std::string, LabelUse> labels;                                     ///< of structures
    base::Span word;                                                            ///< `o100 sub`
};

/// `O1234` alone in its block.
struct ProgramNumber {
    std::string label;
    std::uint32_t begin = 0, behind = 0;  ///< source bytes of the line
    bool after_end = false;               ///< it stands behind the main program's end
};

/// A call by number, until it is known what the number stands for.
struct NumberCall {
    std::string label;
    bool by_m98 = false;
    base::Span where;
};

struct State {
    State(std::uint32_t file_number, const Dialect& dialect, program::Names& n, base::Diagnostics& d,
          const base::Sources& all)
        : variant(dialect), names(n), diagnostics(d), sources(all), text(all[file_number].text), file(file_number) {}

    const Dialect& variant;
    program::Names& names;
    base::Diagnostics& diagnostics;
    const base::Sources& sources;
    base::Diagnostics repeated{};  ///< complaints about text that is read a second time
    std::string_view text;         ///< what was read is laid aside: what looks back takes it from `sources`
    std::uint32_t file = 0;
    std::deque<Part> parts{};  ///< the main program first
    Part* part = nullptr;      ///< the one at hand
    Line line{};

    std::vector<BlockWord> words{};  ///< of the block at hand
    Facts facts{};
    Comment comment{};
    std::uint8_t skip = 0;  ///< block skip level + 1
    bool failed = false;    ///< a complaint was made about the line
    int operators = 0;      ///< of the expression at hand
    /// What a numbered parameter that the control owns says; no_expr: it is an ordinary one. Null: all are.
    ExprId (*system)(State&, std::uint32_t number, std::uint32_t begin) = nullptr;
    bool percent = false;  ///< the text begins with `%`
    bool stopped = false;  ///< its last `%` was read
    std::vector<ProgramNumber> numbers{};
    std::set<std::string> subs{};            ///< labels of o-word subprograms
    std::set<std::string> called_numbers{};  ///< labels that M98 calls
    std::vector<NumberCall> number_calls{};
    bool calls_any_number = false;  ///< M98 P with an expression

    Part& add_part(base::Diagnostics& complaints) { return parts.emplace_back(file, variant, names, complaints, text); }
    [[nodiscard]] program::Builder& build() const { return part->build; }
    [[nodiscard]] program::Unit& unit() const { return part->unit; }
};

/// Complains about the source bytes [begin, end); once a line. The block is then one unknown word.
void fail(State& s, std::uint32_t begin, std::uint32_t end, std::string text, std::string remedy = {});
/// About the thing that stands here.
void fail_here(State& s, std::string text, std::string remedy = {});
/// What stands here as the programmer wrote it; "end of block" at the end.
[[nodiscard]] std::string here(const State& s);

// --- expressions (expression.cpp, operand.cpp, parameter.cpp). no_expr after a complaint.
/// A number, `#…`, `[…]` or function with its signs. Where nothing of this kind stands here `found` is false without a
/// complaint.
[[nodiscard]] Value read_value(State& s, int depth = 0);
/// As above; its absence is an error: "X has no value".
[[nodiscard]] Value read_due_value(State& s, std::string_view word, std::uint32_t begin);
/// An expression without brackets around it: what stands behind `#1=` in Macro B.
[[nodiscard]] ExprId read_expression(State& s);
/// `[…]` with the bracket here.
[[nodiscard]] ExprId read_bracket(State& s, int depth = 0);
[[nodiscard]] ExprId as_expr(State& s, const Value& v);
/// `#…` that stands here. `target`: it is to be written.
[[nodiscard]] ExprId read_parameter(State& s, bool target, int depth = 0);
/// An integer that the value is within 0.0001 of; nothing for expressions and other numbers.
[[nodiscard]] std::optional<std::int32_t> as_integer(const Value& v);
/// `<name>` with the sign here: the name between; nothing after a complaint.
[[nodiscard]] std::optional<std::string> read_name(State& s);
inline constexpr int deepest = 100;   ///< nesting of brackets, functions and signs
inline constexpr int longest = 1000;  ///< operators of one expression: the tree is walked recursively

// --- blocks
/// The block skip sign and the block number; the state's `skip` is set.
void read_block_head(State& s);
void begin_words(State& s);                  ///< forgets the words of the block before
void read_words(State& s);                   ///< block.cpp: all words of a block, to the line's end
void read_word(State& s);                    ///< block.cpp: one of them
void read_comment(State& s);                 ///< block.cpp: `( … )` or `; …` that stands here
void read_g(State& s, std::uint32_t begin);  ///< g_word.cpp: the number behind G
void take_cancel(State& s);                  ///< g_word.cpp: G80 of the block, behind its other words
void read_m(State& s, std::uint32_t begin);  ///< g_word.cpp: the number behind M
/// Value of an expression without parameters.
[[nodiscard]] std::optional<double> constant(const program::Unit& unit, ExprId e);
void check_block(State& s);  ///< checks.cpp: what a block may not hold together
/// checks.cpp: complains about a line with more bytes than the control reads.
[[nodiscard]] bool is_too_long(State& s);
/// A plain motion block at `p`, read without allocation; the end of its line, or null where the full reader is needed.
[[nodiscard]] const char* read_literal_block(State& s, const char* p, const char* end);

// --- words.cpp
/// Puts the words of the block in order into the tree: one statement, or two where it dwells before it moves.
void emit_block(State& s);
/// Words of the block that act before the rest of it: a statement of their own.
void emit_words(State& s, std::vector<BlockWord> words);
void add_modal(State& s, Order order, Modal m, int number, std::uint32_t begin, std::uint32_t end);
void add_value(State& s, Order order, Code code, const Value& v, std::uint32_t begin, std::uint32_t end);
void add_problem(State& s, Code code, std::uint32_t begin, std::uint32_t end, std::string_view reason);
/// The value of a letter of the block at hand, which is taken out of it.
[[nodiscard]] std::optional<BlockWord> take_letter(State& s, Code code);
/// As a span of the source, for messages.
[[nodiscard]] const BlockWord* find_letter(const State& s, Code code);

// --- o-words (o_word.cpp, structure.cpp, sub.cpp)
/// A line that begins with an o-word, which stands here. In text behind the program's end only definitions count.
void read_o_line(State& s);
/// `M98 …` or `M99 …` that stands here.
void read_m98(State& s);
void read_m99(State& s);
/// The number behind M at the begin of a block, where it is 98 or 99; else 0. Nothing moves.
[[nodiscard]] int call_number(const State& s);
void open_structure(State& s, StatementKind kind, const std::string& label, ExprId condition, std::uint32_t begin);
[[nodiscard]] bool has_opened(const State& s, StatementKind kind, const std::string& label);
void read_elseif(State& s, const std::string& label, ExprId condition, std::uint32_t begin);
void read_else(State& s, const std::string& label, std::uint32_t begin);
/// `word`: how the end is written: "endif".
void close_structure(State& s, StatementKind kind, const std::string& label, ExprId condition, std::string_view word,
                     std::uint32_t begin);
void leave_structure(State& s, const std::string& label, bool goes_on, std::uint32_t begin);
/// Complains about what was not closed and closes it.
void close_all(State& s);
/// M98 calls `O100`, o100 call calls `o100 sub`: LinuxCNC refuses the other way about.
void check_styles(State& s);
/// At the end of the text: what was begun and not ended.
void end_text(State& s);
void begin_sub(State& s, const std::string& label, std::uint32_t begin);
/// endsub, return or M99; `value` may be no_expr.
void read_return(State& s, const std::string& label, ExprId value, bool ends, std::uint32_t begin);
void read_program_number(State& s, const std::string& label, std::uint32_t begin);
void call_program(State& s, program::Call call, std::uint32_t begin);
void note_end(State& s, std::uint16_t m);  ///< M2, M30 and M99 outside of structures: the program goes no further
/// A block behind M2 or M30 that nothing leads to; what stands behind an O number is a program of its own.
void say_unreached(State& s);
void read_lines(State& s, std::uint32_t begin);  ///< read.cpp: until the text or the part ends

// --- comments (comment.cpp)
/// The block's comment as statement or word; `(debug, …)` acts before the block.
void emit_comment(State& s);

}  // namespace obrys::read::rs274
