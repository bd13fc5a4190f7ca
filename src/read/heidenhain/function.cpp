/// Q parameter functions: `FN 9: IF +Q1 EQU +Q2 GOTO LBL 5`, and formulas `Q1 = Q2 + 3`.

#include <array>

#include "dialect/heidenhain/functions.hpp"
#include "read/heidenhain/state.hpp"

namespace obrys::read::heidenhain {

using program::Function;
using program::no_expr;
using program::Operator;

namespace {

struct Sign {
    std::string_view text;
    Operator op;
};

bool expect(State& s, std::string_view word) {
    if (s.in.take_prefix(word)) return true;
    fail_here(s, "'" + std::string(word) + "' is due here, found " + here(s));
    return false;
}

/// The parameter that is assigned, and `=`.
ExprId target(State& s) {
    s.in.skip_blanks();
    const ExprId q = read_parameter(s);
    if (q == no_expr) {
        fail_here(s, "a Q parameter is due here, found " + here(s));
        return no_expr;
    }
    return !s.failed && expect(s, "=") ? q : no_expr;
}

void assign(State& s, ExprId to, ExprId value) {
    if (s.failed || to == no_expr || value == no_expr) return;
    s.build.assign(to, value, s.build.unit().exprs[to].begin, s.build.unit().exprs[value].end);
}

/// FN 1 … FN 4, FN 8, FN 13: two values with a word between.
void two_values(State& s, std::string_view word, int n) {
    const ExprId to = target(s);
    if (to == no_expr) return;
    const ExprId a = value_expr(s);
    if (s.failed || !expect(s, word)) return;
    const ExprId b = value_expr(s);
    if (s.failed) return;
    const std::uint32_t begin = s.build.unit().exprs[a].begin, end = s.in.at();
    switch (n) {
        case 1: return assign(s, to, s.build.binary(Operator::add, a, b, begin, end));
        case 2: return assign(s, to, s.build.binary(Operator::subtract, a, b, begin, end));
        case 3: return assign(s, to, s.build.binary(Operator::multiply, a, b, begin, end));
        case 4: return assign(s, to, s.build.binary(Operator::divide, a, b, begin, end));
        case 8: return assign(s, to, s.build.function(Function::root_of_squares, {a, b}, begin, end));
        default: return assign(s, to, s.build.function(Function::angle_of, {a, b}, begin, end));
    }
}

void one_value(State& s, std::string_view word, Function f) {
    const ExprId to = target(s);
    if (to == no_expr || !expect(s, word)) return;
    const std::uint32_t begin = s.in.at();
    const ExprId a = value_expr(s);
    if (!s.failed) assign(s, to, s.build.function(f, {a}, begin, s.in.at()));
}

void condition(State& s, std::string_view word, Operator op) {
    s.in.take_word("IF");
    s.in.skip_blanks();
    const std::uint32_t begin = s.in.at();
    const bool text = s.in.peek() == '"' || (stands_parameter(s) && base::upper(s.in.peek(1)) == 'S');
    const ExprId a = text ? read_text(s) : value_expr(s);
    if (s.failed || !expect(s, word)) return;
    const ExprId b = text ? read_text(s) : value_expr(s);
    if (s.failed) return;
    const ExprId test = s.build.binary(op, a, b, begin, s.in.at());
    if (expect(s, "GOTO")) read_goto(s, test);
}

/// FN 14: ERROR = 1005: the program stops itself.
void error(State& s, std::uint32_t begin) {
    s.in.take_word("ERROR");
    s.in.take('=');
    const ExprId number = value_expr(s);
    if (s.failed) return;
    program::ProcedureCall call;
    call.procedure = program::Procedure::alarm;
    call.arguments = {number};
    call.where = s.build.span(begin, s.in.at());
    s.build.unit().procedures.push_back(std::move(call));
    s.build.control(StatementKind::procedure, s.build.unit().procedures.size() - 1, s.block, s.in.at());
}

/// FN 18: SYSREAD Q5 = ID20 NR1 IDX2.
void system_read(State& s) {
    s.in.take_word("SYSREAD");
    const ExprId to = target(s);
    if (to == no_expr) return;
    s.in.skip_blanks();
    const std::uint32_t begin = s.in.at();
    std::vector<ExprId> numbers;
    for (const std::string_view word : {"ID", "NR", "IDX"}) {
        if (word == "IDX" ? !s.in.take_prefix(word) : !expect(s, word)) break;
        numbers.push_back(value_expr(s));
        if (s.failed) return;
    }
    if (!s.failed) assign(s, to, s.build.function(Function::system_read, numbers, begin, s.in.at()));
}

/// FN 15 and what else is not run: listed, refused, or not known at all, as the control's table says.
void not_run(State& s, int n, std::uint32_t begin) {
    const dialect::heidenhain::FnFunction* known = dialect::heidenhain::find_fn(n);
    s.in.skip_block();
    if (known != nullptr && known->use == dialect::heidenhain::Use::accepted)
        return s.build.ignored("FN " + std::to_string(n) + ": " + std::string(known->name), begin, s.in.at());
    if (known != nullptr) return s.build.problem(Code::unsupported, begin, s.in.at(), "");
    s.build.problem(Code::unknown, begin, s.in.at(), "the control has no FN " + std::to_string(n));
}

void read_numbered(State& s, int n, std::uint32_t begin) {
    if (n == 9) return condition(s, "EQU", Operator::equal);
    if (n == 10) return condition(s, "NE", Operator::not_equal);
    if (n == 11) return condition(s, "GT", Operator::greater);
    if (n == 12) return condition(s, "LT", Operator::less);
    if (n == 14) return error(s, begin);
    s.build.statement(StatementKind::block, s.block);
    switch (n) {
        case 0: {
            const ExprId to = target(s);
            if (to == no_expr) return;
            return assign(s, to, value_expr(s));
        }
        case 1: return two_values(s, "+", n);
        case 2: return two_values(s, "-", n);
        case 3: return two_values(s, "*", n);
        case 4: return two_values(s, "DIV", n);
        case 5: return one_value(s, "SQRT", Function::sqrt);
        case 6: return one_value(s, "SIN", Function::sin);
        case 7: return one_value(s, "COS", Function::cos);
        case 8: return two_values(s, "LEN", n);
        case 13: return two_values(s, "ANG", n);
        case 18: return system_read(s);
        default: break;
    }
    not_run(s, n, begin);
}

}  // namespace

bool read_function(State& s) {
    const std::uint32_t begin = s.in.at();
    if (!s.in.take_prefix("FN")) return false;
    s.in.skip_blanks();
    const base::NumberScan n = s.in.number();
    if (n.length == 0 || !n.integer || n.value > 99) {
        s.build.statement(StatementKind::block, s.block);
        fail(s, begin, "FN needs the number of a function", "FN 0 to FN 29, FN 37, FN 38");
        return true;
    }
    s.in.take(':');
    read_numbered(s, static_cast<int>(n.value), begin);
    return true;
}

void read_assignment(State& s) {
    s.build.statement(StatementKind::block, s.block);
    const ExprId to = target(s);
    if (to == no_expr) return;
    assign(s, to, read_formula(s));
}

}  // namespace obrys::read::heidenhain
