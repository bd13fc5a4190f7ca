#include "read/sinumerik/statement.hpp"

#include <algorithm>

#include "read/sinumerik/call.hpp"
#include "read/sinumerik/control.hpp"
#include "read/sinumerik/expression.hpp"
#include "read/sinumerik/word.hpp"

namespace obrys::read::sinumerik {

using dialect::sinumerik::Keyword;
using program::Code;
using program::ExprId;
using program::Form;
using program::no_expr;
using program::StatementKind;

namespace {

bool line_has_jump(State& s) {
    for (const char* q = s.cursor.p; q + 4 <= s.cursor.end && *q != ';'; ++q)
        if (base::equals_ignoring_case({q, 4}, "GOTO")) return true;
    return false;
}

/// A condition; `=` behind it is the usual slip for `==`.
ExprId read_condition(State& s) {
    const ExprId condition = read_expression(s);
    if (condition == no_expr || !s.cursor.at_assignment()) return condition;
    fail_here(s, "'=' assigns a value and cannot stand in a condition", "compare with '=='");
    return no_expr;
}

void read_if(State& s, const char* from) {
    const ExprId condition = read_condition(s);
    if (condition == no_expr) {
        if (line_has_jump(s)) return;
        keep_failure(s);
        return open_broken(s, StatementKind::if_, from);
    }
    const JumpWord jump = jump_word(s);
    if (jump.length == 0) return open_branch(s, StatementKind::if_, condition, from);
    s.cursor.p += jump.length;
    read_jump(s, jump.keyword, condition, from);
}

void read_while(State& s, const char* from) {
    const ExprId condition = read_condition(s);
    if (condition != no_expr) return open_branch(s, StatementKind::while_, condition, from);
    keep_failure(s);
    open_broken(s, StatementKind::while_, from);
}

void read_until(State& s, const char* from) {
    ExprId condition = read_condition(s);
    if (condition == no_expr) {
        keep_failure(s);
        condition = add_boolean(s, true, from);
    }
    close_structure(s, StatementKind::until, condition, from);
}

bool read_for_head(State& s, program::For& loop) {
    Cursor& c = s.cursor;
    c.skip_blanks();
    if (!is_name_start(c.peek()) && c.peek() != '$') {
        fail_here(s, "FOR needs a variable, found " + here(s), "write FOR R1=1 TO 10");
        return false;
    }
    loop.variable = read_target(s);
    if (loop.variable == no_expr) return false;
    if (!c.take('=')) {
        fail_here(s, "expected '=' in FOR, found " + here(s), "write FOR R1=1 TO 10");
        return false;
    }
    loop.from = read_expression(s);
    if (loop.from == no_expr) return false;
    c.skip_blanks();
    if (!base::equals_ignoring_case(c.name(), "TO")) {
        fail_here(s, "expected TO in FOR, found " + here(s), "write FOR R1=1 TO 10");
        return false;
    }
    c.p += 2;
    loop.to = read_expression(s);
    return loop.to != no_expr;
}

void read_for(State& s, const char* from) {
    program::For loop;
    if (read_for_head(s, loop)) return open_for(s, loop, from);
    keep_failure(s);
    open_broken(s, StatementKind::for_, from);
}

void read_return(State& s, const char* from) {
    Cursor& c = s.cursor;
    const char* end = c.p;
    if (c.take('(')) {
        std::vector<ExprId> arguments;
        --c.p;
        if (!read_arguments(s, arguments)) return;
        if (!arguments.empty()) {
            add_problem(s, Code::unsupported, from, "return to another place than the call");
            close_block(s);
        }
        end = c.p;
    }
    c.p = end;
    add_control(s, StatementKind::return_, 0, from);
}

void read_not_run(State& s, const char* from, std::string_view reason) {
    skip_line(s);
    add_problem(s, Code::unsupported, from, reason);
}

}  // namespace

namespace {

/// The block at hand has words that are no G functions.
bool has_other_words(const State& s) {
    if (!s.block_open || s.unit.statements.empty()) return false;
    const auto first = s.unit.words.begin() + static_cast<std::ptrdiff_t>(s.unit.statements.back().first);
    return std::any_of(first, s.unit.words.end(),
                       [](const program::Word& w) { return program::code_of(w) != Code::modal; });
}

}  // namespace

void read_frame(State& s, const dialect::sinumerik::Entry& entry, std::size_t length) {
    const char* from = s.cursor.p;
    s.cursor.p += length;
    s.unit.frames.push_back({static_cast<program::FrameOp>(entry.value), entry.number != 0, has_other_words(s)});
    add_control(s, StatementKind::frame, s.unit.frames.size() - 1, from);
    s.block_open = true;  // the rest of the line are its axes
}

void read_statement(State& s, Keyword keyword, std::size_t length) {
    const char* from = s.cursor.p;
    s.cursor.p += length;
    switch (keyword) {
        case Keyword::if_: return read_if(s, from);
        case Keyword::else_: return read_else(s, from);
        case Keyword::endif: return close_structure(s, StatementKind::endif, no_expr, from);
        case Keyword::while_: return read_while(s, from);
        case Keyword::endwhile: return close_structure(s, StatementKind::endwhile, no_expr, from);
        case Keyword::repeat:
            if (!read_section(s, false, from)) open_branch(s, StatementKind::repeat_, no_expr, from);
            return;
        case Keyword::repeatb:
            if (!read_section(s, true, from)) fail_here(s, "REPEATB needs a label, found " + here(s));
            return;
        case Keyword::until: return read_until(s, from);
        case Keyword::loop: return open_branch(s, StatementKind::loop_, no_expr, from);
        case Keyword::endloop: return close_structure(s, StatementKind::endloop, no_expr, from);
        case Keyword::for_: return read_for(s, from);
        case Keyword::endfor: return close_structure(s, StatementKind::endfor, no_expr, from);
        case Keyword::case_: return read_case(s, from);
        case Keyword::goto_:
        case Keyword::gotof:
        case Keyword::gotob:
        case Keyword::gotoc:
        case Keyword::gotos: return read_jump(s, keyword, no_expr, from);
        case Keyword::def: return read_def(s, from);
        case Keyword::redef: return read_not_run(s, from, "redefinition of a system variable");
        case Keyword::proc: return read_proc(s, from);
        case Keyword::extern_: return read_extern(s, from);
        case Keyword::define: return read_define(s, from);
        case Keyword::call: return read_indirect_call(s, from);
        case Keyword::extcall: return read_external_call(s, from);
        case Keyword::mcall: return read_mcall(s, from);
        case Keyword::pcall: return read_path_call(s, from);
        case Keyword::ret: return read_return(s, from);
    }
}

}  // namespace obrys::read::sinumerik
