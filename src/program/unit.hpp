#pragma once
/// One program as a tree: statements in order, each with its words or its control data. It speaks meaning, not letters:
/// which letter or G code means what ends in the reader.

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/source.hpp"
#include "cl/cycle.hpp"
#include "program/cycle_definition.hpp"
#include "program/expr.hpp"
#include "program/jumps.hpp"
#include "program/modes.hpp"
#include "program/names.hpp"
#include "program/pattern.hpp"
#include "program/special.hpp"
#include "program/traits.hpp"
#include "program/word.hpp"

namespace obrys::program {

enum class StatementKind : std::uint8_t {
    block,  ///< words
    if_,
    else_,
    endif,
    while_,
    endwhile,
    repeat_,
    until,
    loop_,
    endloop,
    for_,
    endfor,            ///< Unit::branches / fors
    case_,             ///< Unit::cases
    jump,              ///< Unit::jumps, with or without condition
    repeat_section,    ///< REPEAT label …: Unit::sections
    call,              ///< Unit::calls
    procedure,         ///< built-in procedure: Unit::procedures
    frame,             ///< programmable frame: words are its axes; the first word is `control` into Unit::frames
    define,            ///< variable definition: Unit::defines
    return_,           ///< RET; 1 + index into Unit::jumps: the caller goes on there; 0: behind the call
    label_call,        ///< CALL LBL: Unit::label_calls
    label_end,         ///< LBL 0: back to the call, where there is one
    cycle_definition,  ///< CYCL DEF: Unit::cycles
    special,           ///< APPR, FL, SPL, PLANE …: Unit::specials; its first word is `control`, then ordinary words
    pattern,           ///< points for cycle calls: Unit::patterns
    contour,           ///< contours of contour cycles: Unit::contours
    repeat_count,      ///< o… repeat [n]: Unit::branches; its condition is the count, taken once
    end_repeat_count,
};

struct Statement {
    std::uint32_t begin = 0;   ///< byte in the source text
    std::uint32_t first = 0;   ///< its first word; the next statement's `first` ends its words
    std::uint16_t length = 0;  ///< bytes, at most 65535
    StatementKind kind = StatementKind::block;
    std::uint8_t flags = 0;  ///< see below
};
inline constexpr std::uint8_t skip_mask = 0x0F;   ///< block skip level + 1; 0 = not skippable
inline constexpr std::uint8_t line_start = 0x10;  ///< first statement of its block (counts as one executed block)
static_assert(sizeof(Statement) == 12);

/// BLK FORM CYLINDER: about the tool axis through the datum, from `top` down by `length`, mm.
struct BlankCylinder {
    double radius = 0, length = 0, top = 0;
};

/// The stock as the program itself states it (BLK FORM): a block in the program's coordinates and unit.
struct Blank {
    int tool_axis = 2;  ///< 0 = x …
    std::array<double, 3> min{}, max{};
    std::optional<BlankCylinder> cylinder{};  ///< instead of the box
    base::Span where;
};

/// What a call is where no program of its name is found: a cycle of the control itself.
enum class ControlCycle : std::uint8_t {
    none,
    not_run,         ///< known, and not run
    path_tolerance,  ///< CYCLE832: tolerances, compressors and dynamics; it moves nothing
    swivel,          ///< CYCLE800: run as far as it only resets the tilted plane
    hole,            ///< at one hole (CYCLE81 …): Call::form says which
    hole_row,        ///< HOLES1: the modal cycle at each of them
    hole_circle,     ///< HOLES2
};

enum class CallKind : std::uint8_t {
    by_name,    ///< NAME, NAME(…), L123 P3
    indirect,   ///< CALL expression
    modal,      ///< MCALL NAME(…): from now on after every block with motion
    modal_end,  ///< MCALL alone
};
struct Call {
    CallKind kind = CallKind::by_name;
    NameId name = 0;
    ExprId target = no_expr;     ///< of an indirect call: the text that names the program
    bool has_arguments = false;  ///< parentheses were written
    /// M98: the called program has the caller's own parameters (Traits::argument_parameters).
    bool shares_parameters = false;
    std::vector<ExprId> arguments;  ///< no_expr where left out
    ExprId passes = no_expr;        ///< P=
    ExprId first_block = no_expr;   ///< number of the block with which the called program begins (M98 P Q)
    base::Span where;               ///< of the name
    ControlCycle control_cycle = ControlCycle::none;
    std::uint16_t form = 0;     ///< of a control_cycle `hole`: index in Traits::called_holes
    std::uint32_t problem = 0;  ///< of a control_cycle: index into Unit::problems, what is said where it is not run
};

/// Procedures of the control itself.
enum class Procedure : std::uint8_t {
    message,         ///< MSG(text): shown to the operator
    alarm,           ///< SETAL(number): the program stops itself
    master_spindle,  ///< SETMS(n)
    wait_axes,       ///< WAITP(axis, …): until they have come where POSA sends them
    select_datums,   ///< the datum table that shifts by number refer to: its name
    set_datum,       ///< letter of an axis, coordinate, what it shall be from now on (FN 25)
    print_form,      ///< file with the form, file that the filled form goes to (FN 16)
    print_values,    ///< values, one a line (FN 15)
    open_table,      ///< name of a table (FN 26)
    write_table,     ///< row, names of columns with commas between, first parameter that is written (FN 27)
    read_table,      ///< first parameter that is set, row, names of columns (FN 28)
    abort,           ///< text: the program stops itself (LinuxCNC "(abort, …)")
    print,           ///< text for the operator's terminal ("(print, …)")
    log_open,        ///< name of a file; begins it anew ("(logopen, …)")
    log_append,      ///< name of a file; goes on at its end
    log_close,
    log,             ///< text, a line of the open log
    run_text,        ///< EXECSTRING(text): the text is a block of the program
    probe_log_open,  ///< name of a file for what probing finds
    probe_log_close,
};
struct ProcedureCall {
    Procedure procedure = Procedure::message;
    std::vector<ExprId> arguments;
    base::Span where;
};

enum class FrameOp : std::uint8_t { shift, rotate, scale, mirror };
struct FrameCall {
    FrameOp op = FrameOp::shift;
    bool additive = false;      ///< ATRANS … : on top of what is programmed already
    bool beside_words = false;  ///< words that are no G functions stand before it in its block
};

enum class Type : std::uint8_t { boolean, character, integer, real, string, axis, frame };
enum class Initialiser : std::uint8_t { none, single, set, repeat };
struct Variable {
    NameId name = 0;
    std::array<ExprId, 3> dimensions{no_expr, no_expr, no_expr};
    Initialiser initialiser = Initialiser::none;
    std::vector<ExprId> values;
    base::Span where;
};
struct Define {
    Type type = Type::real;
    bool global = false;  ///< NCK or CHAN: global user data
    ExprId string_length = no_expr;
    std::vector<Variable> variables;
};

struct Assign {
    ExprId target = no_expr;  ///< parameter, parameter_at, variable or system
    ExprId value = no_expr;
};

/// What a named value is.
enum class NamedKind : std::uint8_t {
    extended,                 ///< S2=, M2=, F[X]=: the address with another spindle or axis
    rounding_distance,        ///< ADIS=: way before and behind a corner within which G641 may leave the contour
    rounding_distance_rapid,  ///< ADISPOS=: the same between rapids
    contour_tolerance,        ///< CTOL=: of compressors and of G642 … G645
    corner_overshoot,         ///< DISC=: per cent of the way from the arc round an outer corner to the crossing
    contour_allowance,        ///< OFFN=: of radius compensation, added to the tool's radius
    sum_offset,               ///< DL=: offset added to that of the edge
    position,                 ///< POS[axis]=: an axis moves on its own, and the block waits for it
    position_meanwhile,       ///< POSA[axis]=: the program goes on while it moves
    axis_feed,                ///< FA[axis]=
    block_feed,               ///< FB=: feed of the block's path alone
    thread_start,             ///< SF=: degrees of the spindle at which a thread begins
};
/// A word with a computed or extended address: AX[expr]=, X1=, S2=, F[X]=.
struct Named {
    NameId name = 0;         ///< "X1"; the letter for an extended address ("S", "F"); "AX" for AX[…]
    ExprId index = no_expr;  ///< extension: 2 of S2=, the expression in brackets
    ExprId value = no_expr;
    NamedKind kind = NamedKind::extended;
    Code plain = Code::named_value;  ///< of an extended address: what it is without its extension
};

/// A word that is not run. `text` names it in the programmer's spelling; `reason` may be empty.
struct Problem {
    base::Span where;
    std::string text, reason;
};

struct Parameter {
    NameId name = 0;
    Type type = Type::real;
    bool by_reference = false;                                    ///< VAR
    ExprId preset = no_expr;                                      ///< default value
    std::array<ExprId, 3> dimensions{no_expr, no_expr, no_expr};  ///< no_expr with is_array: any size
    bool is_array = false;
};

/// Known words without effect on motion: listed once each.
struct Ignored {
    std::string text;
    base::Span where;
    std::uint32_t count = 1;
};

/// What the programmer has written for people, before the statement before or beside which it stands.
struct Remark {
    std::uint32_t statement = 0;
    std::string text;
};

/// What spoke for a kind of machine where the reader has taken one from the text (GuessedMachine::mill, lathe).
struct MachineSigns {
    std::vector<base::Span> lathe, mill;  ///< words of the text
    bool doubtful = false;                ///< as much speaks for the other one
};

struct Unit {
    std::string name;  ///< upper case, without suffix: "PODPROG_ZL"
    std::uint32_t file = 0;
    std::uint32_t begin = 0, end = 0;  ///< its part of the source text (an archive holds several)
    const Traits* traits = nullptr;
    MachineSigns machine_signs;
    /// The operator can start it: where it stands in the file of the main program and is never run, that is said.
    bool startable = false;
    bool has_proc = false;
    bool inch =
        false;  ///< lengths are inches from its first block on, whatever the caller uses (with unit_per_program)
    std::string
        unended;  ///< not empty: the text has no end that the control wants, and what it says when it comes there
    std::string unbegun;  ///< not empty: the text has no first block that the control wants, and what is not said so
    bool save = false;    ///< SAVE: the caller's modal G codes and frames come back at the end
    std::vector<Parameter> parameters;

    std::vector<Statement> statements;
    std::vector<Word> words;
    std::vector<Expr> exprs;
    std::vector<ExprId> children;
    std::vector<double> numbers;
    std::vector<std::string> texts;
    std::vector<Branch> branches;
    std::vector<For> fors;
    std::vector<Case> cases;
    std::vector<Jump> jumps;
    std::vector<Section> sections;
    std::vector<LabelCall> label_calls;
    std::vector<CycleDefinition> cycles;
    std::vector<Special> specials;
    std::vector<Pattern> patterns;
    std::vector<ContourStatement> contours;
    std::optional<Blank> blank;
    std::vector<Call> calls;
    std::vector<ProcedureCall> procedures;
    std::vector<FrameCall> frames;
    std::vector<Define> defines;
    std::vector<Assign> assigns;
    std::vector<Named> named;
    std::vector<Problem> problems;
    std::vector<Ignored> ignored;
    std::vector<Remark> remarks;  ///< in order of their statements; none where nobody asks for them
    /// Lengths without a decimal point that are read as less than 1 mm (least input increments), in order: places of
    /// the text from the number's begin to its end. And how many lengths have a point.
    std::vector<std::pair<std::uint32_t, std::uint32_t>> small_lengths;
    std::size_t lengths_with_point = 0;
    std::vector<std::uint32_t> tool_definitions;          ///< statements that say what a tool is, in order
    std::map<NameId, std::vector<std::uint32_t>> labels;  ///< statements, in order
    ModeTable modes;                                      ///< of controls whose words mean what the state says

    [[nodiscard]] std::uint32_t words_end(std::uint32_t statement) const {
        return statement + 1 < statements.size() ? statements[statement + 1].first
                                                 : static_cast<std::uint32_t>(words.size());
    }
    [[nodiscard]] base::Span span(const Statement& s) const { return {file, s.begin, s.begin + s.length}; }
    [[nodiscard]] base::Span span(const Statement& s, const Word& w) const;
    [[nodiscard]] base::Span span(ExprId e) const { return {file, exprs[e].begin, exprs[e].end}; }
    /// What stands before a statement.
    [[nodiscard]] std::span<const Remark> remarks_of(std::uint32_t statement) const;
    /// Room for the tree of so many bytes of text, so that it need not be moved while it grows. It is memory of the
    /// machine only where the tree comes to fill it.
    void reserve(std::size_t bytes);
    /// Value of a literal word.
    [[nodiscard]] double literal(const Word& w) const {
        constexpr std::array<double, 10> power_of_ten{1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9};
        if (form_of(w) == Form::pooled) return numbers[static_cast<std::size_t>(w.payload)];
        return static_cast<double>(w.payload) / power_of_ten[w.form];
    }
    /// What a word is; of an extended address (T1=) what it is without its extension.
    [[nodiscard]] Code address(const Word& w) const {
        return code_of(w) == Code::named_value ? named[static_cast<std::size_t>(w.payload)].plain : code_of(w);
    }
};

}  // namespace obrys::program
