#include "read/sinumerik/call.hpp"

#include "read/sinumerik/archive.hpp"
#include "read/sinumerik/expression.hpp"
#include "read/sinumerik/word.hpp"

namespace obrys::read::sinumerik {

using program::Call;
using program::CallKind;
using program::Code;
using program::no_expr;
using program::StatementKind;

namespace {

void add_call(State& s, Call call, const char* from) {
    s.unit.calls.push_back(std::move(call));
    add_control(s, StatementKind::call, s.unit.calls.size() - 1, from);
}

/// `(…)` and `P3` or `P=3` behind the name.
bool read_tail(State& s, Call& call) {
    Cursor& c = s.cursor;
    const char* end = c.p;
    if (c.take('(')) {
        --c.p;
        call.has_arguments = true;
        if (!read_arguments(s, call.arguments)) return false;
        end = c.p;
    }
    c.skip_blanks();
    if (base::upper(c.peek()) == 'P' && (!is_name_part(c.peek(1)) || base::is_digit(c.peek(1)))) {
        ++c.p;
        c.take_assignment();
        call.passes = read_expression(s);
        if (call.passes == no_expr) return false;
        end = c.p;
    }
    c.p = end;
    return true;
}

}  // namespace

void read_call(State& s, const char* from, const char* to) {
    Call call;
    call.name = s.names.id(plain_name({from, static_cast<std::size_t>(to - from)}));
    call.where = s.span(from, to);
    s.cursor.p = to;
    if (read_tail(s, call)) add_call(s, std::move(call), from);
}

namespace {

/// A cycle of the control: what is said where it is not run stands beside the call.
void add_cycle_call(State& s, Call call, const dialect::sinumerik::Entry& entry, const char* from) {
    program::Problem problem;
    problem.where = s.span(from, s.cursor.p);
    problem.text = base::as_utf8({from, static_cast<std::size_t>(s.cursor.p - from)});
    problem.reason = entry.reason;
    call.control_cycle = static_cast<program::ControlCycle>(entry.value);
    call.form = entry.number;
    call.problem = static_cast<std::uint32_t>(s.unit.problems.size());
    s.unit.problems.push_back(std::move(problem));
    add_call(s, std::move(call), from);
}

}  // namespace

void read_control_cycle(State& s, const dialect::sinumerik::Entry& entry, std::size_t length) {
    const char* from = s.cursor.p;
    s.cursor.p += length;
    Call call;
    call.name = s.names.id(entry.name);
    call.where = s.span(from, s.cursor.p);
    if (read_tail(s, call)) add_cycle_call(s, std::move(call), entry, from);
}

void read_mcall(State& s, const char* from) {
    Cursor& c = s.cursor;
    Call call;
    call.where = s.span(from, c.p);
    if (c.at_end()) {
        call.kind = CallKind::modal_end;
        c.p = from + 5;
        return add_call(s, std::move(call), from);
    }
    const std::string_view name = c.name();
    if (name.empty()) return fail_here(s, "MCALL needs the name of a program, found " + here(s));
    const auto* entry = dialect::sinumerik::find_word(base::to_upper(name));
    call.kind = CallKind::modal;
    call.name = s.names.id(plain_name(name));
    call.where = s.span(c.p, c.p + name.size());
    c.p += name.size();
    if (!read_tail(s, call)) return;
    if (entry != nullptr && entry->use == dialect::sinumerik::Use::control_cycle)
        return add_cycle_call(s, std::move(call), *entry, from);
    if (entry != nullptr && entry->use == dialect::sinumerik::Use::unsupported)
        return add_problem(s, Code::unsupported, from, entry->reason);
    add_call(s, std::move(call), from);
}

void read_indirect_call(State& s, const char* from) {
    Cursor& c = s.cursor;
    if (c.at_end()) return fail(s, from, c.p, "CALL needs the name of a program", "write CALL \"NAME\"");
    const auto is_block = [&] { return base::equals_ignoring_case(c.name(), "BLOCK"); };
    if (is_block()) {
        skip_line(s);
        return add_problem(s, Code::unsupported, from, "call of a program section");
    }
    Call call;
    call.kind = CallKind::indirect;
    const char* name_begin = c.p;
    call.target = read_expression(s, Level::concat);
    if (call.target == no_expr) return;
    call.where = s.span(name_begin, c.p);
    c.skip_blanks();
    if (is_block()) {
        skip_line(s);
        return add_problem(s, Code::unsupported, from, "call of a program section");
    }
    if (!read_tail(s, call)) return;
    add_call(s, std::move(call), from);
}

void read_external_call(State& s, const char* from) {
    Call call;
    call.kind = CallKind::indirect;
    s.cursor.skip_blanks();
    const char* name = s.cursor.p;
    if (s.cursor.at_end()) return fail(s, from, name, "EXTCALL needs the name of a program", "write EXTCALL \"NAME\"");
    call.target = read_expression(s);
    if (call.target == no_expr) return;
    call.where = s.span(name, s.cursor.p);
    add_call(s, std::move(call), from);
}

void read_path_call(State& s, const char* from) {
    Cursor& c = s.cursor;
    c.skip_blanks();
    const char* path = c.p;
    while (c.p < c.end && *c.p != '(' && *c.p != ';' && !base::is_blank(*c.p)) ++c.p;
    if (c.p == path) return fail(s, from, c.p, "PCALL needs a path", "write PCALL /_N_SPF_DIR/NAME");
    const char* name = c.p;
    while (name > path && name[-1] != '/') --name;
    if (name == c.p) return fail(s, path, c.p, "the path ends without the name of a program");
    Call call;
    call.name = s.names.id(plain_name({name, static_cast<std::size_t>(c.p - name)}));
    call.where = s.span(name, c.p);
    if (read_tail(s, call)) add_call(s, std::move(call), from);
}

void read_procedure(State& s, program::Procedure procedure, std::size_t length) {
    Cursor& c = s.cursor;
    const char* from = c.p;
    c.p += length;
    program::ProcedureCall call;
    call.procedure = procedure;
    call.where = s.span(from, c.p);
    const char* end = c.p;
    if (c.take('(')) {
        --c.p;
        if (!read_arguments(s, call.arguments)) return;
    } else {
        c.p = end;
        if (procedure != program::Procedure::master_spindle)
            return fail(s, from, end, "the arguments are missing", "add them in parentheses");
    }
    s.unit.procedures.push_back(std::move(call));
    add_control(s, StatementKind::procedure, s.unit.procedures.size() - 1, from);
}

}  // namespace obrys::read::sinumerik
