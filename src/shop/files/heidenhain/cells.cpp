#include "shop/files/heidenhain/cells.hpp"

#include <algorithm>

#include "base/codes.hpp"
#include "base/number.hpp"
#include "base/text.hpp"
#include "base/whole.hpp"
#include "shop/size_range.hpp"

namespace obrys::shop {

namespace {
constexpr double mm_per_inch = 25.4;

bool is_number_part(char c) { return base::is_digit(c) || c == '.' || c == ','; }
}  // namespace

bool Cells::next() {
    while (next_ < t_.rows.size() && !t_.rows[next_].data) ++next_;
    if (next_ >= t_.rows.size()) return false;
    row_ = next_++;
    return true;
}

bool Cells::need(std::initializer_list<std::string_view> columns) {
    bool all = true;
    for (const std::string_view c : columns) {
        if (has(c)) continue;
        all = false;
        if (t_.columns.empty()) continue;  // already said
        std::string names;
        for (const TableColumn& column : t_.columns) names += (names.empty() ? "" : " ") + column.name;
        diagnostics_.add({base::Severity::error,
                          base::codes::job_file,
                          {t_.file, 0, 0},
                          "the table has no column " + std::string(c),
                          "its columns are: " + names.substr(0, 200),
                          {},
                          {}});
    }
    return all;
}

void Cells::complain(std::size_t column, std::string what, std::string remedy) {
    diagnostics_.add({base::Severity::error,
                      base::codes::job_value,
                      cell_span(t_, row_, column),
                      "row " + std::string(cell(t_, row_, 0)) + ", column " + base::as_utf8(t_.columns[column].name) +
                          ": " + std::move(what),
                      std::move(remedy),
                      {},
                      {}});
}

std::optional<Cells::Number> Cells::number(std::uint32_t most_whole, std::uint32_t most_part) {
    const std::string_view s = cell(t_, row_, 0);
    const std::size_t dot = s.find('.');
    const auto whole = base::parse_integer(s.substr(0, dot));
    const auto part =
        dot == std::string_view::npos ? std::optional<std::int64_t>(0) : base::parse_integer(s.substr(dot + 1));
    if (whole && part && *whole >= 0 && *part >= 0 && *whole <= most_whole && *part <= most_part)
        return Number{static_cast<std::uint32_t>(*whole), static_cast<std::uint32_t>(*part)};
    std::string range = "row numbers go up to " + std::to_string(most_whole);
    if (most_part > 0) range += "." + std::to_string(most_part);
    complain(0, std::move(range), {});
    return std::nullopt;
}

/// A number that goes on in the next column has moved: what the cell holds is only a part of it.
bool Cells::runs_over(std::size_t column) const {
    const TableColumn& c = t_.columns[column];
    const std::string_view text = t_.rows[row_].text;
    if (t_.utf8 && base::character_count(text) != text.size()) return false;  // columns are not bytes in this row
    const auto joined = [&](std::uint32_t at) {
        return at > 0 && at < text.size() && is_number_part(text[at]) && !base::is_blank(text[at - 1]);
    };
    const bool from_left = column > 0 && joined(c.begin) && is_number_part(text[c.begin - 1]);
    return from_left || (c.end != TableColumn::no_limit && joined(c.end) && is_number_part(text[c.end - 1]));
}

std::optional<double> Cells::real(std::string_view column) {
    const auto found = find_column(t_, column);
    if (!found) return std::nullopt;
    std::string s(cell(t_, row_, *found));
    if (s.empty() || s == "-") return std::nullopt;
    if (runs_over(*found)) {
        complain(*found, "the value runs over into the next column", "the values stand below the column names");
        return std::nullopt;
    }
    std::replace(s.begin(), s.end(), ',', '.');
    const base::NumberScan scan = base::scan_decimal(s);
    if (scan.length == s.size()) return scan.value;
    complain(*found, "\"" + cell_text(t_, row_, *found) + "\" is not a number", "write a number like +5 or +5.25");
    return std::nullopt;
}

std::optional<double> Cells::sized(std::string_view column, bool radius) {
    const auto v = real(column);
    if (!v) return v;
    const double size = t_.unit == TableUnit::inch ? *v * mm_per_inch : *v;
    const std::string problem = size_problem(size, radius);
    if (problem.empty()) return size;
    complain(*find_column(t_, column), "the value " + problem + " mm", {});
    return std::nullopt;
}

std::optional<double> Cells::length(std::string_view column) { return sized(column, false); }
std::optional<double> Cells::radius(std::string_view column) { return sized(column, true); }

std::optional<std::int64_t> Cells::integer(std::string_view column, std::int64_t least, std::int64_t most) {
    const auto v = real(column);
    if (!v) return std::nullopt;
    if (const auto n = base::whole<std::int64_t>(*v, least, most)) return n;
    const std::size_t at = *find_column(t_, column);
    complain(at,
             "\"" + cell_text(t_, row_, at) + "\" is not a whole number from " + std::to_string(least) + " to " +
                 std::to_string(most),
             {});
    return std::nullopt;
}

std::string Cells::text(std::string_view column) const {
    const auto found = find_column(t_, column);
    return found ? cell_text(t_, row_, *found) : std::string{};
}

}  // namespace obrys::shop
