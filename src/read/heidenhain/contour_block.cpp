/// Contours made of several: CONTOUR DEF, SEL CONTOUR, DECLARE CONTOUR and formulas of contours (QC10 = QC1 | QC2).

#include <algorithm>

#include "read/heidenhain/state.hpp"

namespace obrys::read::heidenhain {

using program::ContourNode;
using program::ContourOperator;
using program::ContourPart;
using program::ContourStatement;
using program::no_expr;
using ContourKind = ContourStatement::Kind;

namespace {

constexpr int most_nested = 100;

/// LBL 1, "NAME.H" or QS5, and the depth behind it.
void read_source(State& s, ContourPart& part, std::uint32_t begin) {
    if (s.in.take_word("LBL"))
        part.label = read_label_name(s);
    else
        part.program = read_file_name(s, "LBL with a label, or the name of a program is due here");
    if (!s.failed && s.in.take_prefix("DEPTH")) part.depth = value_expr(s);
    part.where = s.build.span(begin, s.in.at());
}

void read_part(State& s, ContourStatement& c) {
    s.in.skip_blanks();
    const std::uint32_t begin = s.in.at();
    const char kind = base::upper(s.in.peek());
    if ((kind != 'P' && kind != 'I') || !base::is_digit(s.in.peek(1)))
        return fail_here(s, "P with a number (pocket) or I with a number (island) is due here, found " + here(s));
    s.in.step();
    ContourPart part;
    part.island = kind == 'I';
    if (part.island && c.parts.empty()) return fail(s, begin, "the first contour must be a pocket");
    const int number = s.in.integer();
    if (number < 0) return fail(s, begin, "this number of a contour is too large");
    part.number = static_cast<std::uint32_t>(number);
    s.in.take('=');
    read_source(s, part, begin);
    c.parts.push_back(part);
}

/// The number of QC1; -1 after a complaint.
int read_contour_number(State& s) {
    if (!s.in.take_prefix("QC")) {
        fail_here(s, "a contour (QC with a number) is due here, found " + here(s));
        return -1;
    }
    const int number = s.in.integer();
    if (number < 0) fail_here(s, "a number is due behind QC, found " + here(s));
    return number;
}

ContourOperator take_operator(State& s) {
    if (s.in.take('|')) return ContourOperator::unite;
    if (s.in.take('&')) return ContourOperator::intersect;
    if (s.in.take('\\')) return ContourOperator::subtract;
    if (s.in.take('^')) return ContourOperator::either;
    return ContourOperator::contour;
}

std::uint32_t add(ContourStatement& c, ContourNode n) {
    c.nodes.push_back(n);
    return static_cast<std::uint32_t>(c.nodes.size() - 1);
}

std::uint32_t read_formula(State& s, ContourStatement& c, int depth);

std::uint32_t read_operand(State& s, ContourStatement& c, int depth) {
    s.in.skip_blanks();
    const std::uint32_t begin = s.in.at();
    if (!s.in.take('(')) {
        const int number = read_contour_number(s);
        return add(c, {ContourOperator::contour, static_cast<std::uint32_t>(std::max(number, 0)), 0, 0});
    }
    if (depth >= most_nested) fail(s, begin, "the parentheses of this formula are nested too deep");
    if (s.failed) return 0;
    const std::uint32_t inside = read_formula(s, c, depth + 1);
    if (!s.failed && !s.in.take(')')) fail(s, begin, "this parenthesis is not closed");
    return inside;
}

std::uint32_t read_formula(State& s, ContourStatement& c, int depth) {
    std::uint32_t left = read_operand(s, c, depth);
    ContourOperator before = ContourOperator::contour;
    while (!s.failed) {
        const ContourOperator op = take_operator(s);
        if (op == ContourOperator::contour) break;
        c.mixed = c.mixed || (before != ContourOperator::contour && op != before);
        before = op;
        const std::uint32_t right = read_operand(s, c, depth);
        left = add(c, {op, 0, left, right});
    }
    return left;
}

void read_own(State& s, ContourStatement& c) {
    switch (c.kind) {
        case ContourKind::definition:
            if (s.in.at_end()) return fail_here(s, "CONTOUR DEF needs a contour: P1 = LBL 1, P1 = \"NAME.H\"");
            while (!s.failed && !s.in.at_end()) read_part(s, c);
            return;
        case ContourKind::selection:
            c.program = read_file_name(s, "the name of a program is due behind SEL CONTOUR");
            return;
        case ContourKind::declaration:
        case ContourKind::formula: break;
    }
    s.in.skip_blanks();
    const std::uint32_t begin = s.in.at();
    const int number = read_contour_number(s);
    if (s.failed) return;
    c.number = static_cast<std::uint32_t>(number);
    if (!s.in.take('=')) return fail_here(s, "'=' is due here, found " + here(s));
    if (c.kind == ContourKind::formula) return static_cast<void>(read_formula(s, c, 0));
    ContourPart part;
    part.number = c.number;
    read_source(s, part, begin);
    c.parts.push_back(part);
}

void read_statement(State& s, ContourKind kind) {
    ContourStatement c;
    c.kind = kind;
    const std::size_t index = s.build.unit().contours.size();
    s.build.control(StatementKind::contour, index, s.block, s.in.at());
    read_own(s, c);
    if (!s.failed && !s.in.at_end()) fail_here(s, "this does not belong to a contour: " + here(s));
    c.where = s.build.span(s.block, s.in.at());
    if (!s.failed) return s.build.unit().contours.push_back(std::move(c));
    s.build.unit().contours.push_back({});  // without parts: a cycle says that there is no contour
    s.build.unit().contours.back().where = c.where;
}

}  // namespace

bool read_contour_block(State& s, std::string_view word) {
    const std::uint32_t begin = s.in.at();
    if (base::equals_ignoring_case(word, "QC")) return read_statement(s, ContourKind::formula), true;
    if (s.in.take_word("CONTOUR") && s.in.take_word("DEF")) return read_statement(s, ContourKind::definition), true;
    s.in.go_to(begin);
    if (s.in.take_word("SEL") && s.in.take_word("CONTOUR")) return read_statement(s, ContourKind::selection), true;
    s.in.go_to(begin);
    if (s.in.take_word("DECLARE") && s.in.take_word("CONTOUR"))
        return read_statement(s, ContourKind::declaration), true;
    s.in.go_to(begin);
    return false;
}

}  // namespace obrys::read::heidenhain
