/// Tools: which one is in the spindle, and what the text says it is.

#include <algorithm>
#include <cmath>

#include "base/whole.hpp"
#include "read/apt/state.hpp"

namespace obrys::read::apt {

using program::Code;
using program::Modal;

namespace {

/// Words behind the number of a tool that tell posts which registers to write.
constexpr std::array<std::string_view, 10> register_words{"ADJUST", "OSETNO", "SETOOL", "LENGTH", "IN",
                                                          "OUT",    "CUTCOM", "MODE",   "MANUAL", "AUTO"};

bool is_register_word(const Token& t) {
    const std::string word = upper_of(t);
    for (const std::string_view known : register_words)
        if (word == known) return true;
    return false;
}

/// CUTTER for the tool `number`: half of what it says.
void define_tool(State& s, double number) {
    need_unit(s);
    begin_block(s);
    s.build.bare(Code::tool_definition, s.cutter_begin, s.cutter_end);
    s.build.literal(Code::tool, number, s.line.begin, s.line.end);
    s.build.literal(Code::tool_radius, *s.cutter / 2, s.cutter_begin, s.cutter_end);
    end_block(s);
    s.tool_has_size = true;
    s.cutter.reset();
}

}  // namespace

void read_load(State& s, const Arguments& a, bool tool_word) {
    const Token* t = a.begin();
    if (tool_word) {
        if (t == a.end() || upper_of(*t) != "TOOL") return refuse(s, "only LOAD/TOOL is known");
        t += t + 1 < a.end() ? 2 : 1;
    }
    const auto number =
        t < a.end() && t->kind == TokenKind::number ? base::whole<int>(t->number.value, 0, 99'999'999) : std::nullopt;
    if (!number) return fail(s, t, "this is no tool number: a whole number is due");
    for (const Token* more = t + 1; more < a.end(); ++more)
        if (more->kind == TokenKind::word && !is_register_word(*more))
            return fail(s, more, "what this says of the tool is not known");
    s.moved_with_tool = false;
    if (s.tool && *s.tool == *number) {
        if (s.cutter) define_tool(s, *number);
        return s.build.ignored("LOADTL of the tool in the spindle", s.line.begin, s.line.end);
    }
    s.tool = *number;
    s.tool_has_size = false;
    if (s.cutter) define_tool(s, *number);
    begin_block(s);
    s.build.literal(Code::tool, *number, t->begin, t->end);
    s.build.bare(Code::tool_change, t->begin, t->end);
    end_block(s);
}

namespace {

/// TLDATA/MILL,d,… and TLDATA/DRILL,MILL,d,…, whose second word names the module of NX. Null: nothing is left to read.
const Token* diameter_of_data(State& s, const Arguments& a) {
    const Token* t = a.begin();
    const std::string word = upper_of(*t);
    if (word == "TURN" || word == "TTURN" || word == "GROOVE" || word == "THREAD") {
        s.turns = true;
        return s.build.ignored("TLDATA", s.line.begin, s.line.end), nullptr;
    }
    t += 2;
    if (word == "DRILL" && t < a.end() && t->kind == TokenKind::word) t += 2;
    if (word == "MILL" || word == "DRILL") return t;
    assume(s, s.line.begin, s.line.end, "what this says of the tool is not known: its radius is unknown",
           "give the tool in a tool table or in the job");
    return nullptr;
}

}  // namespace

void read_cutter(State& s, const Arguments& a) {
    const Token* t = a.begin();
    if (t < a.end() && t->kind == TokenKind::word && (t = diameter_of_data(s, a)) == nullptr) return;
    if (t >= a.end() || t->kind != TokenKind::number) return fail(s, t, "a cutter begins with its diameter");
    if (!(t->number.value >= 0)) return fail(s, t, "the diameter of this cutter is negative");
    const Token* const foreign =
        std::find_if(t, a.end(), [](const Token& more) { return more.kind == TokenKind::word; });
    if (foreign != a.end()) return fail(s, foreign, "what this says of the tool is not known");
    s.cutter = t->number.value;
    s.cutter_begin = s.line.begin;
    s.cutter_end = s.line.end;
    if (s.tool && !s.tool_has_size && !s.moved_with_tool) define_tool(s, *s.tool);
}

void read_tool_kind(State& s, const Arguments& a) {
    for (const Token& t : a)
        if (t.kind == TokenKind::word && upper_of(t) == "TURN") s.turns = true;
    s.build.ignored("TOOLNO", s.line.begin, s.line.end);
}

}  // namespace obrys::read::apt
