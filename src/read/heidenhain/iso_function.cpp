/// Q parameter functions of DIN/ISO: `D01 Q1 P01 +Q2 P02 +5`. They are the FN functions of Klartext under another
/// letter. Source: HEIDENHAIN ISO Programming User's Manuals, chapter "Q parameters" (TNC 360: page 7-5; iTNC 530).

#include "read/heidenhain/iso.hpp"

namespace obrys::read::heidenhain {

using program::no_expr;

bool take_p(State& s, int number) {
    s.in.skip_blanks();
    const std::uint32_t begin = s.in.at();
    if (base::upper(s.in.peek()) == 'P') {
        s.in.step();
        if (s.in.integer() == number) return true;
        s.in.go_to(begin);
    }
    fail_here(s, "P0" + std::to_string(number) + " is due here, found " + here(s),
              "the values of a function stand behind P01, P02, P03");
    return false;
}

namespace {

/// How many values stand behind P01 …; 0 where the function is no assignment of values.
int values_of(int n) {
    switch (n) {
        case 0:
        case 5:
        case 6:
        case 7: return 1;
        case 1:
        case 2:
        case 3:
        case 4:
        case 8:
        case 13: return 2;
        default: return 0;
    }
}

void assignment(State& s, int n) {
    s.build.statement(StatementKind::block, s.block);
    s.in.skip_blanks();
    const ExprId to = read_parameter(s);
    if (to == no_expr) return fail_here(s, "a Q parameter is due here, found " + here(s));
    std::vector<ExprId> values;
    for (int k = 1; k <= values_of(n); ++k) {
        if (!take_p(s, k)) return;
        s.in.skip_blanks();
        values.push_back(n == 0 ? read_compared(s) : value_expr(s));
        if (s.failed) return;
    }
    assign_function(s, n, to, values);
}

/// D18 Q1 P01 210 P02 4 P03 3: ID, NR and, where one is needed, IDX.
void iso_system_read(State& s) {
    s.build.statement(StatementKind::block, s.block);
    s.in.skip_blanks();
    const ExprId to = read_parameter(s);
    if (to == no_expr) return fail_here(s, "a Q parameter is due here, found " + here(s));
    s.in.skip_blanks();
    const std::uint32_t begin = s.in.at();
    std::vector<ExprId> numbers;
    for (int k = 1; k <= 3 && !(k == 3 && s.in.at_end()); ++k) {
        if (!take_p(s, k)) return;
        numbers.push_back(value_expr(s));
        if (s.failed) return;
    }
    numbers.resize(3, no_expr);
    read_assigned(s, to, system_datum(s, numbers[0], numbers[1], numbers[2], begin));
}

void iso_condition(State& s, int n) {
    if (!take_p(s, 1)) return;
    s.in.skip_blanks();
    const std::uint32_t begin = s.in.at();
    const ExprId a = read_compared(s);
    if (s.failed || !take_p(s, 2)) return;
    const ExprId b = read_compared(s);
    if (s.failed) return;
    const ExprId test = s.build.binary(*comparison_of(n), a, b, begin, s.in.at());
    if (take_p(s, 3)) read_goto(s, test);
}

void iso_error(State& s, std::uint32_t begin) {
    if (!take_p(s, 1)) return;
    const ExprId number = value_expr(s);
    if (!s.failed) stop_with_error(s, number, begin);
}

/// `D18: SYSREAD Q1 = ID20 NR1`, `D14: ERROR = 1000`: later software writes them as Klartext does.
bool stands_as_in_klartext(State& s) {
    s.in.skip_blanks();
    const char c = base::upper(s.in.peek());
    return c == ':' || (base::is_letter(c) && c != 'Q' && c != 'P');
}

}  // namespace

void read_iso_function(State& s) {
    const std::uint32_t begin = s.in.at();
    const int n = read_code(s);
    if (n < 0) return;
    if (stands_as_in_klartext(s)) {
        s.in.take(':');
        return read_numbered(s, n, begin);
    }
    if (values_of(n) > 0) return assignment(s, n);
    if (comparison_of(n)) return iso_condition(s, n);
    if (n == 14) return iso_error(s, begin);
    if (n == 18) return iso_system_read(s);
    s.build.statement(StatementKind::block, s.block);
    leave_function(s, n, begin);
}

}  // namespace obrys::read::heidenhain
