#pragma once
/// What all parts of the rewriting share: the language, the program at hand and the text so far. Private to rewrite.

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "rewrite/graph.hpp"
#include "rewrite/held.hpp"
#include "rewrite/language.hpp"
#include "rewrite/names.hpp"
#include "rewrite/rewrite.hpp"
#include "rewrite/structured.hpp"

namespace obrys::rewrite {

using program::Expr;
using program::ExprId;
using program::ExprKind;
using program::Function;
using program::Operator;
using program::StatementKind;
using program::Unit;

/// How tight a text holds together.
enum class Level : std::uint8_t { atom, sign, product, sum, comparison, logic };

/// An expression in the other language.
struct Text {
    std::string text;
    Level level = Level::atom;
    std::optional<double> number{};  ///< it is one
};

/// A condition whose operands stand ready.
struct Condition {
    enum class Kind : std::uint8_t { comparison, all, any, constant };
    Kind kind = Kind::constant;
    bool holds = true;  ///< of a constant
    Operator op = Operator::equal;
    Text a{}, b{};
    std::vector<Condition> parts{};
};

struct Line {
    std::string text;
    base::Span from;
};

struct ContourText;

class Writing {
public:
    Writing(const Input& input, const Language& language);
    Rewritten run(const std::string& name);

    // expressions.cpp
    Text value(ExprId id);
    /// A number, a parameter or a place that holds the value.
    Text atom(ExprId id) { return atom(value(id), id); }
    Text atom(Text value, ExprId where);
    [[nodiscard]] std::string within(const Text& t, Level loosest) const;
    [[nodiscard]] std::string number(double v) const;
    [[nodiscard]] Text number_text(double v) const;
    Text joined(std::string_view op, const Text& a, const Text& b, Level level);
    Text place_for(ExprId where);
    void assign(const Text& to, const Text& from);
    std::optional<Text> target_of(ExprId id);
    /// `v`, the value of `from`, as a variable of that type takes it: INT rounds.
    Text as_type(program::Type type, Text v, ExprId from);
    /// The same of the variable that is assigned to; refuses what a BOOL would make of it.
    Text of_type(ExprId target, Text v, ExprId from);
    void refuse_type(ExprId target);

    // functions.cpp
    /// To the nearest whole number, halves up.
    Text rounded(const Text& v, ExprId from);
    Text function(const Expr& e, ExprId id);

    // conditions.cpp
    Condition condition(ExprId id, bool negated = false);
    [[nodiscard]] std::optional<std::string> as_text(const Condition& c) const;
    void jump_when(const Condition& c, const std::string& label);
    /// `then` where a and b compare so.
    void when(const Text& a, Operator op, const Text& b, const std::function<void()>& then);
    Text truth(ExprId id);

    // statements.cpp
    void statements(const Unit& unit);
    std::string label_of(std::uint32_t statement);
    std::string fresh_label();
    void place(const std::string& label);
    void jump(const std::string& label);

    // calls.cpp
    void call(const program::Call& c);
    // passes.cpp
    /// How often it is to be done; nothing after a complaint.
    std::optional<int> passes_of(const program::Call& c);
    void repeated(int passes, const std::function<void()>& what);
    void label_call(const program::LabelCall& c, std::uint32_t statement);
    /// A repeated part (REP) that can be said there.
    [[nodiscard]] bool repeats_label(std::uint32_t statement) const;
    void repeat_label(const program::LabelCall& c);
    void begin_repeats(std::size_t top);
    void procedure(const program::ProcedureCall& p);
    /// An alarm of the program: its number, a blank and its text.
    void alarm(const std::string& said);
    void define(const program::Define& d);
    void begin_program(const Unit& unit, bool main);
    void end_program(const Unit& unit, bool main);
    void leave();
    void end_all();
    [[nodiscard]] std::string program_name(const Unit& unit);

    // cycles.cpp
    void cycle_definition(const program::CycleDefinition& d);
    void cycle_call();

    // frames.cpp
    void frame_cycle(const program::CycleDefinition& d);
    void frame(const program::FrameCall& call);
    /// G52, G68, G69.
    void frame_block(program::Modal m);
    /// What a part of the frame is before this statement; nothing where that is not known.
    std::optional<Text> frame_part(Mode part);
    [[nodiscard]] Text nothing_of(Mode part) const;
    /// A part that has different values by the way that the run has come, all of them in one place.
    [[nodiscard]] bool frame_varies(Mode part);
    /// Some statement gives it a value.
    [[nodiscard]] bool frame_acts(Mode part);
    std::optional<Text> frame_keeper(Mode part);
    void begin_frames();
    /// What the frame is behind it.
    void keep_frame(const std::array<Text, 6>& parts);
    /// There are more statements than one that change a frame.
    [[nodiscard]] bool says_frames_again();

    // contour_text.cpp
    /// The contour in these statements; nothing after a complaint.
    std::optional<ContourText> contour_text(const Unit& of, const Range& range);
    /// Its blocks behind the first point.
    std::string contour_blocks(const ContourText& contour, const std::string& feed);

    // system.cpp
    Text system(const Expr& e, ExprId id);

    // remarks.cpp
    /// What is said before a statement, once.
    void remarks(std::uint32_t statement);
    /// Those of statements that are not written as statements.
    void tell_missing_remarks();

    // blocks.cpp
    void block(std::uint32_t statement);

    /// A line of the text.
    void say(std::string text);
    /// A text of the language with its places filled; refuses where the language has none.
    bool say(std::string_view key, const Places& places, std::string_view what);
    void refuse(const base::Span& where, std::string what, std::string remedy = {});
    void tell(const base::Span& where, std::string what);
    [[nodiscard]] std::string source(const base::Span& where) const;
    [[nodiscard]] base::Span span(ExprId id) const { return unit->span(id); }
    [[nodiscard]] bool tools_wait() const;
    /// The length of a tool that waits for a block with Z stands in a block of its own.
    void write_length();
    [[nodiscard]] const Held& held() const { return modes.at(unit)[at]; }

    const Input& input;
    const Language& language;
    Naming naming;
    std::vector<const Unit*> programs;
    std::map<const Unit*, Graph> graphs;
    HeldModes modes;
    const Unit* unit = nullptr;
    std::uint32_t at = 0;  ///< the statement
    base::Span here;       ///< its place
    std::vector<Line> lines;
    std::vector<Note> notes;
    std::map<int, std::pair<Text, Text>> poles;  ///< by their places
    std::map<int, std::pair<Text, Text>>
        pole_increments;                ///< the same of those that count on from where the tool stands
    std::optional<Text> prepared_edge;  ///< said last, and not changed to yet
    int tool_in_spindle = 0;            ///< 0: none, or that depends on the way
    std::string length_waits;           ///< its words, for the next straight move along Z

private:
    void remark(const std::string& text);
    const Unit* callee(const Unit& caller, const program::Call& c) const;
    bool collect(const Unit& unit, std::vector<const Unit*>& open);
    /// Statements [first, end).
    void range(std::uint32_t first, std::uint32_t end, bool only_inline);
    void statement(std::uint32_t i);
    /// The name under which a called part of the unit is a program of its own.
    std::string part(const Range& r);
    void parts_of_unit();
    bool may_jump();
    /// A parameter in which the control keeps something of its own, or that is no storage alone.
    [[nodiscard]] bool means_more(std::uint32_t number) const;
    /// What a call does not hand over as it is: VAR, arrays, types but numbers. Refuses it.
    bool takes_numbers(const Unit& called);
    // references.cpp
    /// Where the called program leaves what argument `a` has become.
    std::optional<std::string> place_of_reference(const Unit& called, const Argument& a);
    /// What goes where behind the call; nothing after a complaint.
    std::optional<std::vector<std::pair<Text, Text>>> given_back(const program::Call& c, const Unit& called);
    /// Before the program goes back.
    void hand_back();
    Text given_value(const Unit& called, std::size_t n, ExprId id);
    /// Argument n is set by the program before it reads it.
    [[nodiscard]] bool is_set_first(const Unit& unit, std::uint32_t n) const;
    void structure(std::uint32_t i);
    void branch(std::uint32_t i);
    void loop(std::uint32_t i);
    void counted(std::uint32_t i);
    void case_of(const program::Case& c);
    // jumps.cpp
    void find_structure();
    std::string region_number(std::size_t region);
    void borders(std::uint32_t i);
    void structured_jump(const program::Jump& j);
    void tail(const program::Jump& j);
    void begin_counting(std::size_t region);
    void end_counting(const program::LabelCall& c);
    /// The end of a loop that goes on while the jump's condition holds.
    void say_again(const program::Jump& j, const std::string& loop);
    void jump_statement(const program::Jump& j);
    void section(std::uint32_t i);
    [[nodiscard]] bool keeps_structures() const { return language.has("flow.while"); }
    std::string structure_number(std::uint32_t opener);
    /// Of a language that has no loop with its condition at the end.
    [[nodiscard]] bool ends_by_break() const { return !language.has("flow.repeat") && language.has("flow.break"); }
    /// The end of such a loop.
    void break_when(const std::string& condition, const std::string& loop);
    /// SAVE of the unit: refused where it has an effect.
    void saves();
    /// Declares the unit's own names, in front of what stands behind line `top`.
    void declare(std::size_t top);
    Rewritten finished(const std::string& name);
    void say_behind();
    void parts_first(std::size_t first, std::size_t middle);
    std::optional<Text> tool_of(const Expr& e);
    struct NamedContour;
    std::optional<NamedContour> contour_here();
    /// The name of the program that stands for a cycle here; null after a complaint.
    const std::string* cycle_program(const program::CycleDefinition& d, const CycleProgram& p);
    std::string& name_of_cycle(const program::CycleDefinition& d, int contour);
    [[nodiscard]] std::string fresh_cycle_name(const program::CycleDefinition& d) const;
    void set_of_cycle(const program::CycleDefinition& d, const program::CycleSetting& s);
    /// The programs give it a value somewhere.
    [[nodiscard]] bool is_assigned(std::uint32_t parameter);

    std::map<std::uint32_t, std::string> labels_;   ///< of the unit's statements, as the program calls them
    std::map<std::uint32_t, std::string> settled_;  ///< … and as they are called there
    std::set<std::uint32_t> wanted_;                ///< statements that need a label
    std::set<std::string> all_labels_;
    std::map<const Unit*, std::string> program_names_;
    std::uint32_t numbered_ = 0;     ///< programs that have been given a number
    std::set<std::uint32_t> again_;  ///< loops whose conditions need lines before them
    std::map<std::uint32_t, std::string> counters_;
    std::map<std::uint32_t, std::string> numbers_;  ///< of structures
    std::vector<std::uint32_t> open_ifs_;           ///< their statements, the innermost last
    std::vector<std::string> rep_keepers_;          ///< whether a part is being repeated
    int next_label_ = 0, next_number_ = 0;
    std::string end_label_;
    struct Part {
        std::string name;
        Range range;
    };
    std::map<std::pair<const Unit*, std::uint32_t>, Part> parts_;  ///< by their first statement
    std::vector<std::uint32_t> waiting_;                           ///< parts of the unit to be written
    std::set<std::uint32_t> inline_;  ///< statements to which more than calls of labels lead
    std::map<std::pair<cl::CycleKind, int>, std::string> cycle_programs_;  ///< names, by the place of the contour
    struct Frames {
        std::size_t count;         ///< statements that change one
        std::set<Mode> act, vary;  ///< parts that are given values; those that depend on the way
    };
    void look_at_frames();
    std::optional<Frames> frames_;
    std::optional<std::set<std::uint32_t>> assigned_;  ///< parameters
    std::map<std::pair<const Unit*, Mode>, std::string> frame_keepers_;
    std::map<std::pair<int, Mode>, Text> frame_values_;  ///< by the place that says them
    std::vector<Line> said_behind_;                      ///< texts of programs
    std::optional<Structured> structured_;               ///< the jumps of the unit, where the control has none
    std::map<std::uint32_t, std::vector<std::size_t>> ends_at_, begins_at_;  ///< of branches and loops among them
    std::vector<std::string> region_numbers_;                                ///< of their regions
    bool jumps_refused_ = false;
    std::map<std::size_t, std::pair<Text, Text>> counting_;  ///< what counts the passes of regions, and whether it does
    bool in_tail_ = false;                                   ///< statements are written where a jump to them stands
    std::string last_message_;
    std::map<std::pair<const Unit*, std::size_t>, std::optional<std::string>> references_;  ///< by program and argument
    std::set<std::pair<const Unit*, std::uint32_t>> remarked_;  ///< statements whose remarks are written
};

/// The same turned round: less for greater or equal.
[[nodiscard]] Operator opposite(Operator op);

}  // namespace obrys::rewrite
