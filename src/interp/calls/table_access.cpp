/// Freely definable tables (FN 26 TABOPEN, FN 27 TABWRITE, FN 28 TABREAD). Rows are named by their number, columns by
/// their names; several columns take or fill parameters that follow one another. What is written stays in memory.
/// Source: iTNC 530 User's Manual Conversational Programming, "Accessing tables with FN 26, 27, 28".

#include <cmath>

#include "base/codes.hpp"
#include "base/number.hpp"
#include "base/text.hpp"
#include "base/whole.hpp"
#include "interp/calls/calls.hpp"

namespace obrys::interp {

namespace codes = base::codes;

namespace {

std::vector<std::string> column_names(std::string_view text) {
    std::vector<std::string> names;
    while (!text.empty()) {
        const std::size_t comma = std::min(text.find(','), text.size());
        names.emplace_back(base::trim(text.substr(0, comma)));
        text.remove_prefix(std::min(comma + 1, text.size()));
    }
    return names;
}

/// The parameters that a table's cells go to or come from.
struct Cells {
    shop::HeidenhainTable* table = nullptr;
    std::size_t row = 0;
    std::vector<std::size_t> columns;
    const program::Expr* first = nullptr;  ///< parameter, or variable that holds text
    ExprId first_id = program::no_expr;
};

/// Nothing after a complaint; `add` makes a row that is not there.
std::optional<Cells> cells_of(Reckoning& run, const program::ProcedureCall& p, ExprId row, ExprId columns, ExprId first,
                              bool add) {
    Cells c;
    c.first = &run.unit().exprs[first];
    c.first_id = first;
    const double n = number(run, row);
    const std::string names = printed(evaluate(run, columns));
    if (run.stopped) return std::nullopt;
    c.table = run.env.files == nullptr || run.open_table.empty() ? nullptr : run.env.files->table(run.open_table);
    const auto missing = [&](const std::string& what) {
        unchecked(run, codes::unknown_value, p.where, what,
                  "put the table beside the program, with the rows and columns that it uses");
        return std::nullopt;
    };
    if (c.table == nullptr)
        return missing(run.open_table.empty() ? "no table is open here (FN 26)"
                                              : "the table " + run.open_table + " is not at hand");
    const auto whole = base::whole<std::int64_t>(n, 0, 99'999'999);
    const std::string row_name = whole ? std::to_string(*whole) : "?";
    auto at = whole ? shop::find_row(*c.table, row_name) : std::nullopt;
    if (!at && whole && add && !shop::add_row(*c.table, row_name)) at = shop::find_row(*c.table, row_name);
    if (!at) return missing("the table " + run.open_table + " has no row " + printed(Value::real(n)));
    c.row = *at;
    for (const std::string& name : column_names(names)) {
        const auto column = shop::find_column(*c.table, name);
        if (!column) return missing("the table " + run.open_table + " has no column " + name);
        c.columns.push_back(*column);
    }
    return c;
}

/// Number of the parameter for the n-th column; nothing after an alarm.
std::optional<std::uint32_t> parameter_of(Reckoning& run, const program::ProcedureCall& p, const Cells& c,
                                          std::size_t n) {
    const std::uint64_t number = std::uint64_t{c.first->a} + n;
    if (c.first->kind == program::ExprKind::parameter && number < run.parameters.count())
        return static_cast<std::uint32_t>(number);
    alarm(run, codes::index_range, p.where,
          "there are not as many parameters behind the first one as columns are named");
    return std::nullopt;
}

bool holds_text(const Cells& c) { return c.first->kind == program::ExprKind::variable; }

double number_in(std::string text) {
    for (char& letter : text)
        if (letter == ',') letter = '.';
    if (!text.empty() && text.front() == '+') text.erase(0, 1);
    return base::parse_double(text).value_or(std::numeric_limits<double>::quiet_NaN());
}

}  // namespace

void open_table(Reckoning& run, const program::ProcedureCall& p) {
    run.open_table = base::to_upper(printed(evaluate(run, p.arguments[0])));
    if (run.env.files != nullptr && run.env.files->table(run.open_table) != nullptr) return;
    unchecked(run, codes::unknown_value, p.where, "the table " + run.open_table + " is not at hand",
              "put it beside the program");
}

void write_table(Reckoning& run, const program::ProcedureCall& p) {
    const auto c = cells_of(run, p, p.arguments[0], p.arguments[1], p.arguments[2], true);
    if (!c || run.capture != nullptr) return;
    for (std::size_t n = 0; n < c->columns.size(); ++n) {
        std::string text;
        if (holds_text(*c)) {
            text = printed(evaluate(run, c->first_id));
        } else {
            const auto parameter = parameter_of(run, p, *c, n);
            if (!parameter) return;
            const double v = run.parameters.get(*parameter);
            text = std::isnan(v) ? std::string("-") : base::shortest(v);
        }
        if (const auto wrong = shop::set_cell(*c->table, c->row, c->columns[n], text))
            unchecked(run, codes::value_range, p.where, "TABWRITE into " + run.open_table + ": " + *wrong);
    }
    assume(run, p.where, "what the program writes into the table " + run.open_table + " is kept for this run alone");
}

void read_table(Reckoning& run, const program::ProcedureCall& p) {
    const auto c = cells_of(run, p, p.arguments[1], p.arguments[2], p.arguments[0], false);
    const program::Expr& first = run.unit().exprs[p.arguments[0]];
    if (run.stopped) return;
    if (!c) {
        if (first.kind == program::ExprKind::parameter && first.a < run.parameters.count())
            run.parameters.set(first.a, std::numeric_limits<double>::quiet_NaN());
        return;
    }
    if (holds_text(*c)) {
        const std::string text = shop::cell_text(*c->table, c->row, c->columns.front());
        return assign_text(run, p.arguments[0], text);
    }
    for (std::size_t n = 0; n < c->columns.size(); ++n) {
        const auto parameter = parameter_of(run, p, *c, n);
        if (!parameter) return;
        const double v = number_in(shop::cell_text(*c->table, c->row, c->columns[n]));
        run.parameters.set(*parameter, v);
        if (std::isnan(v))
            unchecked(run, codes::unknown_value, p.where,
                      "a cell that is read here holds no number: the parameter is not known");
    }
}

}  // namespace obrys::interp
