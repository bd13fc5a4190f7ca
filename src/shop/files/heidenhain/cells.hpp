#pragma once
/// Typed cells of a HEIDENHAIN table, row by row, with complaints. Private to this room.

#include <initializer_list>
#include <limits>

#include "shop/files/heidenhain/table.hpp"

namespace obrys::shop {

/// Not a number: a value that the table does not say.
inline constexpr double no_entry = std::numeric_limits<double>::quiet_NaN();

class Cells {
public:
    Cells(const HeidenhainTable& table, base::Diagnostics& diagnostics) : t_(table), diagnostics_(diagnostics) {}

    /// The next row with data; false behind the last.
    bool next();
    /// Complains once where a column of the kind of table is not there.
    bool need(std::initializer_list<std::string_view> columns);

    [[nodiscard]] bool has(std::string_view column) const { return find_column(t_, column).has_value(); }
    /// Row number and what stands behind its point, "5.1" -> 5 and 1. Complains where one is above its limit.
    struct Number {
        std::uint32_t whole = 0, part = 0;
    };
    std::optional<Number> number(std::uint32_t most_whole, std::uint32_t most_part);

    /// Nothing where the column or a value is missing, `-` stands there, or the value was reported.
    std::optional<double> real(std::string_view column);
    std::optional<double> length(std::string_view column);  ///< mm
    std::optional<double> radius(std::string_view column);  ///< mm, of a tool
    std::optional<std::int64_t> integer(std::string_view column, std::int64_t least, std::int64_t most);
    [[nodiscard]] std::string text(std::string_view column) const;
    [[nodiscard]] bool filled(std::string_view column) const { return !text(column).empty(); }
    /// A mark stands there: anything but nothing and 0 (`L` for locked, on newer controls 1).
    [[nodiscard]] bool marked(std::string_view column) const { return filled(column) && text(column) != "0"; }
    [[nodiscard]] base::Span where() const { return cell_span(t_, row_, 0); }

private:
    std::optional<double> sized(std::string_view column, bool radius);
    void complain(std::size_t column, std::string what, std::string remedy);
    bool runs_over(std::size_t column) const;

    const HeidenhainTable& t_;
    base::Diagnostics& diagnostics_;
    std::size_t row_ = 0, next_ = 0;
};

}  // namespace obrys::shop
