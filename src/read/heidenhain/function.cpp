/// Q parameter functions: `FN 9: IF +Q1 EQU +Q2 GOTO LBL 5`, and formulas `Q1 = Q2 + 3`.

#include <array>
#include <optional>

#include "base/text.hpp"
#include "base/whole.hpp"
#include "dialect/heidenhain/functions.hpp"
#include "read/heidenhain/state.hpp"

namespace obrys::read::heidenhain {

using program::Function;
using program::no_expr;
using program::Operator;

namespace {

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

}  // namespace

void read_assigned(State& s, ExprId to, ExprId value) {
    if (s.failed || to == no_expr || value == no_expr) return;
    s.build.assign(to, value, s.build.unit().exprs[to].begin, s.build.unit().exprs[value].end);
}

void assign_function(State& s, int n, ExprId to, const std::vector<ExprId>& values) {
    const std::uint32_t begin = s.build.unit().exprs[values.front()].begin, end = s.in.at();
    const auto result = [&] {
        switch (n) {
            case 0: return values[0];
            case 1: return s.build.binary(Operator::add, values[0], values[1], begin, end);
            case 2: return s.build.binary(Operator::subtract, values[0], values[1], begin, end);
            case 3: return s.build.binary(Operator::multiply, values[0], values[1], begin, end);
            case 4: return s.build.binary(Operator::divide, values[0], values[1], begin, end);
            case 5: return s.build.function(Function::sqrt, values, begin, end);
            case 6: return s.build.function(Function::sin, values, begin, end);
            case 7: return s.build.function(Function::cos, values, begin, end);
            case 8: return s.build.function(Function::root_of_squares, values, begin, end);
            default: return s.build.function(Function::angle_of, values, begin, end);
        }
    };
    read_assigned(s, to, result());
}

std::optional<Operator> comparison_of(int n) {
    constexpr std::array operators{Operator::equal, Operator::not_equal, Operator::greater, Operator::less};
    if (n < 9 || n > 12) return std::nullopt;
    return operators[static_cast<std::size_t>(n - 9)];
}

ExprId read_compared(State& s) {
    s.in.skip_blanks();
    const bool text = s.in.peek() == '"' || (stands_parameter(s) && base::upper(s.in.peek(1)) == 'S');
    return text ? read_text(s) : value_expr(s);
}

void stop_with_error(State& s, ExprId number, std::uint32_t begin) {
    program::ProcedureCall call;
    call.procedure = program::Procedure::alarm;
    call.arguments = {number};
    call.where = s.build.span(begin, s.in.at());
    s.build.unit().procedures.push_back(std::move(call));
    s.build.control(StatementKind::procedure, s.build.unit().procedures.size() - 1, s.block, s.in.at());
}

namespace {

/// FN 1 … FN 4, FN 8, FN 13: two values with a word between.
void two_values(State& s, std::string_view word, int n) {
    const ExprId to = target(s);
    if (to == no_expr) return;
    const ExprId a = value_expr(s);
    if (s.failed || !expect(s, word)) return;
    const ExprId b = value_expr(s);
    if (!s.failed) assign_function(s, n, to, {a, b});
}

/// FN 0, FN 5 … FN 7; `word` is empty where no function's name stands.
void one_value(State& s, std::string_view word, int n) {
    const ExprId to = target(s);
    if (to == no_expr || !expect(s, word)) return;
    const ExprId a = value_expr(s);
    if (!s.failed) assign_function(s, n, to, {a});
}

void condition(State& s, std::string_view word, int n) {
    s.in.take_word("IF");
    s.in.skip_blanks();
    const std::uint32_t begin = s.in.at();
    const ExprId a = read_compared(s);
    if (s.failed || !expect(s, word)) return;
    const ExprId b = read_compared(s);
    if (s.failed) return;
    const ExprId test = s.build.binary(*comparison_of(n), a, b, begin, s.in.at());
    if (!expect(s, "GOTO")) return;
    s.in.skip_blanks();
    if (!base::equals_ignoring_case(s.in.letters(), "LBL"))
        return fail_here(s, "LBL is due behind GOTO, found " + here(s));
    read_goto(s, test);
}

/// FN 14: ERROR = 1005: the program stops itself.
void error(State& s, std::uint32_t begin) {
    s.in.take_word("ERROR");
    s.in.take('=');
    const ExprId number = value_expr(s);
    if (!s.failed) stop_with_error(s, number, begin);
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
    numbers.resize(3, no_expr);
    read_assigned(s, to, system_datum(s, numbers[0], numbers[1], numbers[2], begin));
}

}  // namespace

void leave_function(State& s, int n, std::uint32_t begin) {
    s.in.skip_block();
    const auto* fn = dialect::heidenhain::find_fn(n);
    if (fn != nullptr && fn->use == dialect::heidenhain::Use::accepted)
        return s.build.ignored("FN " + std::to_string(n) + " (" + std::string(fn->text) + ")", begin, s.in.at());
    if (fn != nullptr) return s.build.problem(Code::unsupported, begin, s.in.at(), fn->text);
    s.build.problem(Code::unknown, begin, s.in.at(), "the control has no FN " + std::to_string(n));
}

void read_numbered(State& s, int n, std::uint32_t begin) {
    if (n == 9) return condition(s, "EQU", n);
    if (n == 10) return condition(s, "NE", n);
    if (n == 11) return condition(s, "GT", n);
    if (n == 12) return condition(s, "LT", n);
    if (n == 14) return error(s, begin);
    if (read_shop_function(s, n, begin)) return;
    s.build.statement(StatementKind::block, s.block);
    switch (n) {
        case 0: return one_value(s, "", n);
        case 1: return two_values(s, "+", n);
        case 2: return two_values(s, "-", n);
        case 3: return two_values(s, "*", n);
        case 4: return two_values(s, "DIV", n);
        case 5: return one_value(s, "SQRT", n);
        case 6: return one_value(s, "SIN", n);
        case 7: return one_value(s, "COS", n);
        case 8: return two_values(s, "LEN", n);
        case 13: return two_values(s, "ANG", n);
        case 18: return system_read(s);
        default: break;
    }
    leave_function(s, n, begin);
}

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
    read_numbered(s, base::clipped<int>(n.value, 0, 99), begin);
    return true;
}

void read_assignment(State& s) {
    s.build.statement(StatementKind::block, s.block);
    const ExprId to = target(s);
    if (to == no_expr) return;
    read_assigned(s, to, read_formula(s));
}

}  // namespace obrys::read::heidenhain
