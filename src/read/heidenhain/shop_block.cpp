/// Blocks about tables and datums: SEL TABLE, TRANS DATUM; FN 15, 16, 17, 25, 26, 27, 28.
/// Source: iTNC 530 User's Manual Conversational Programming, "Q parameters: additional functions", "Defining a datum
/// shift: TRANS DATUM".

#include "dialect/heidenhain/cycles.hpp"
#include "read/heidenhain/state.hpp"

namespace obrys::read::heidenhain {

using program::no_expr;
using program::Procedure;

namespace {

void add_procedure(State& s, Procedure what, std::vector<ExprId> arguments, std::uint32_t begin) {
    if (s.failed) return;
    program::ProcedureCall call;
    call.procedure = what;
    call.arguments = std::move(arguments);
    call.where = s.build.span(begin, s.in.at());
    s.build.unit().procedures.push_back(std::move(call));
    s.build.control(StatementKind::procedure, s.build.unit().procedures.size() - 1, s.block, s.in.at());
}

/// The name of a file without its folders: TNC:\DIR\NAME.TAB, "NAME.TAB" or a QS parameter. A `/` ends it.
ExprId file_name(State& s) {
    s.in.skip_blanks();
    if (stands_parameter(s) || s.in.peek() == '"') {
        const std::uint32_t begin = s.in.at();
        const ExprId text = read_text(s);
        if (text == no_expr || s.build.unit().exprs[text].kind != program::ExprKind::text) return text;
        const std::string path = s.build.unit().texts[s.build.unit().exprs[text].a];
        return s.build.text(path.substr(path.find_last_of("\\:/") + 1), begin, s.in.at());
    }
    const std::uint32_t begin = s.in.at();
    const auto ends = [](char c) { return c == '\0' || c == '/' || c == ';' || c == '\n' || c == '\r'; };
    while (!ends(s.in.peek()) && !base::is_blank(s.in.peek())) s.in.step();
    const std::string_view path = s.in.between(begin, s.in.at());
    const std::string_view name = path.ends_with(':') ? path.substr(0, path.size() - 1)  // SCREEN:
                                                      : path.substr(path.find_last_of("\\:") + 1);
    if (name.empty()) {
        fail_here(s, "the name of a file is due here, found " + here(s));
        return no_expr;
    }
    return s.build.text(base::as_utf8(name), begin, s.in.at());
}

/// FN 16: F-PRINT TNC:\FORM.A / TNC:\RESULT.TXT
void print_form(State& s, std::uint32_t begin) {
    if (!expect(s, "F-PRINT")) return;
    const ExprId form = file_name(s);
    if (s.failed) return;
    s.in.skip_blanks();
    if (!s.in.take('/')) return fail_here(s, "'/' and the file to print to are due here, found " + here(s));
    const ExprId file = file_name(s);
    add_procedure(s, Procedure::print_form, {form, file}, begin);
}

/// FN 15: PRINT Q1/Q2/20
void print_values(State& s, std::uint32_t begin) {
    if (!expect(s, "PRINT")) return;
    std::vector<ExprId> values{read_compared(s)};
    while (!s.failed && s.in.take('/')) values.push_back(read_compared(s));
    add_procedure(s, Procedure::print_values, std::move(values), begin);
}

/// FN 17: SYSWRITE ID 50 NR 1 IDX 5 = +Q1: dimensions of tools; what else it changes is not followed.
void system_write(State& s, std::uint32_t begin) {
    s.build.statement(StatementKind::block, s.block);
    if (!expect(s, "SYSWRITE")) return;
    std::vector<ExprId> numbers;
    for (const std::string_view word : {"ID", "NR", "IDX"}) {
        if (word == "IDX" ? !s.in.take_prefix(word) : !expect(s, word)) break;
        numbers.push_back(value_expr(s));
        if (s.failed) return;
    }
    if (numbers.size() < 2) return;
    const ExprId to = system_datum(s, numbers[0], numbers[1], numbers.size() > 2 ? numbers[2] : no_expr, begin);
    if (!expect(s, "=")) return;
    const ExprId value = value_expr(s);
    if (s.failed) return;
    const auto what = static_cast<program::SystemVariable>(s.build.unit().exprs[to].op);
    if (what >= program::SystemVariable::table_length && what <= program::SystemVariable::table_delta_corner)
        return s.build.assign(to, value, begin, s.in.at());
    s.build.problem(Code::unsupported, begin, s.in.at(), "it changes data of the control that are not followed");
}

/// FN 25: PRESET = X/+100/+50
void set_datum(State& s, std::uint32_t begin) {
    if (!expect(s, "PRESET") || !expect(s, "=")) return;
    s.in.skip_blanks();
    const std::uint32_t at = s.in.at();
    if (!axis_of(base::upper(s.in.peek()))) return fail_here(s, "an axis is due here, found " + here(s));
    std::vector<ExprId> values{s.build.text(std::string(1, base::upper(s.in.peek())), at, at + 1)};
    s.in.step();
    for (int k = 0; k < 2 && !s.failed; ++k) {
        s.in.skip_blanks();
        if (!s.in.take('/')) return fail_here(s, "'/' is due here, found " + here(s));
        values.push_back(value_expr(s));
    }
    add_procedure(s, Procedure::set_datum, std::move(values), begin);
}

void open_table(State& s, std::uint32_t begin) {
    if (!expect(s, "TABOPEN")) return;
    const ExprId name = file_name(s);
    add_procedure(s, Procedure::open_table, {name}, begin);
}

/// 5/"RADIUS,DEPTH": row and columns.
std::vector<ExprId> row_and_columns(State& s) {
    std::vector<ExprId> place{value_expr(s)};
    s.in.skip_blanks();
    if (!s.failed && !s.in.take('/')) fail_here(s, "'/' and the names of columns are due here, found " + here(s));
    if (!s.failed) place.push_back(read_text(s));
    return place;
}

/// The parameter that the first column goes to or comes from.
ExprId first_parameter(State& s) {
    s.in.skip_blanks();
    const ExprId q = read_parameter(s);
    if (q == no_expr) fail_here(s, "a Q parameter is due here, found " + here(s));
    return q;
}

/// FN 27: TABWRITE 5/"RADIUS,DEPTH" = Q5
void write_table(State& s, std::uint32_t begin) {
    if (!expect(s, "TABWRITE")) return;
    std::vector<ExprId> values = row_and_columns(s);
    if (s.failed || !expect(s, "=")) return;
    values.push_back(first_parameter(s));
    add_procedure(s, Procedure::write_table, std::move(values), begin);
}

/// FN 28: TABREAD Q10 = 6/"RADIUS,DEPTH"
void read_table(State& s, std::uint32_t begin) {
    if (!expect(s, "TABREAD")) return;
    std::vector<ExprId> values{first_parameter(s)};
    if (s.failed || !expect(s, "=")) return;
    for (const ExprId e : row_and_columns(s)) values.push_back(e);
    add_procedure(s, Procedure::read_table, std::move(values), begin);
}

/// A datum shift as cycle 7 makes it, under the name of its block.
program::CycleDefinition& start_shift(State& s, std::uint32_t begin) {
    start_cycle(s, 7, dialect::heidenhain::find_cycle(7), begin);
    program::CycleDefinition& c = s.build.unit().cycles.back();
    c.name = "TRANS DATUM";
    return c;
}

void add_axis(State& s, char letter, ExprId value, bool incremental, std::uint32_t begin) {
    if (const auto* p =
            dialect::heidenhain::find_parameter(*dialect::heidenhain::find_cycle(7), 1, std::string_view(&letter, 1)))
        add_setting(s, *p, value, incremental, begin);
}

/// TRANS DATUM AXIS X+10 IY+5, TRANS DATUM TABLE TABLINE 5, TRANS DATUM RESET.
void datum_shift(State& s, std::uint32_t begin) {
    const bool reset = s.in.take_word("RESET"), table = !reset && s.in.take_word("TABLE");
    if (!reset && !table && !expect(s, "AXIS")) return;
    start_shift(s, begin);
    if (table && expect(s, "TABLINE")) {
        const std::uint32_t at = s.in.at();
        const ExprId row = value_expr(s);
        if (!s.failed) add_axis(s, '#', row, false, at);
    }
    for (const char letter : {'X', 'Y', 'Z'})
        if (reset) add_axis(s, letter, s.build.number(0, true, begin, s.in.at()), false, begin);
    unsigned given = 0;
    while (!reset && !table && !s.failed && !s.in.at_end()) {
        const std::uint32_t at = s.in.at();
        const bool incremental = base::upper(s.in.peek()) == 'I';
        if (incremental) s.in.step();
        const char letter = base::upper(s.in.peek());
        if (!axis_of(letter)) return fail_here(s, "an axis with its value is due here, found " + here(s));
        s.in.step();
        const ExprId value = value_expr(s);
        if (!s.failed && (given & (1U << (letter - 'A'))) != 0)
            return fail(s, at, std::string("the axis ") + letter + " stands twice in TRANS DATUM");
        given |= 1U << (letter - 'A');
        if (!s.failed) add_axis(s, letter, value, incremental, at);
    }
    s.open_cycle = program::no_target;
}

}  // namespace

bool read_shop_function(State& s, int n, std::uint32_t begin) {
    switch (n) {
        case 15: return print_values(s, begin), true;
        case 16: return print_form(s, begin), true;
        case 17: return system_write(s, begin), true;
        case 25: return set_datum(s, begin), true;
        case 26: return open_table(s, begin), true;
        case 27: return write_table(s, begin), true;
        case 28: return read_table(s, begin), true;
        default: return false;
    }
}

bool read_shop_block(State& s, std::string_view word) {
    const std::uint32_t begin = s.in.at();
    s.in.step(word.size());
    if (base::equals_ignoring_case(word, "SEL") && s.in.take_word("TABLE")) {
        const ExprId name = file_name(s);
        add_procedure(s, Procedure::select_datums, {name}, begin);
        return true;
    }
    if (base::equals_ignoring_case(word, "TRANS") && s.in.take_word("DATUM")) return datum_shift(s, begin), true;
    s.in.go_to(begin);
    return false;
}

}  // namespace obrys::read::heidenhain
