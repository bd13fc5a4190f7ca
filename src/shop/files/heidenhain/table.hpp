#pragma once
/// Tables of HEIDENHAIN controls as files: tools (.T), pockets (.TCH), datums (.D), points (.PNT), presets (.PR),
/// cutting data (.CDT), materials and freely definable tables (.TAB). What they mean: shop/files/heidenhain/views.hpp.
///
/// Form: `BEGIN TOOL .T MM`, for tables with own columns their description (`#STRUCTBEGIN` … `#STRUCTEND`, on newer
/// controls `TableDescription ( … )`), the line of column names, rows, `[END]`. Where a name begins in the line of
/// names its column begins; the last column takes the rest of the line. The first column numbers the rows (`5`, tools
/// also `5.1`). Sources: iTNC 530 User's Manual, "Tool data", "Point tables", "Freely definable tables"; files of the
/// control. Everything is kept as it was read, so what is not understood is not lost: `write(read(text)) == text`.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostic.hpp"
#include "base/source.hpp"

namespace obrys::shop {

struct TableColumn {
    std::string name;         ///< as written: "CUR.TIME"
    std::uint32_t begin = 0;  ///< its first character in every row, from 0
    std::uint32_t end = 0;    ///< where the next column begins; `no_limit` for the last
    std::uint32_t width = 0;  ///< characters that a value may have; `no_limit` for a last column without description

    static constexpr std::uint32_t no_limit = 0xFFFFFFFF;
};

/// A line below the column names. Empty lines and comments (`;`, `*`, `#` in front) are kept, but hold no data.
struct TableRow {
    std::string text;             ///< without its line end
    std::string line_end;         ///< "\r\n", "\n", "\r" or, at the end of the text, nothing
    std::uint32_t at = no_place;  ///< where the line begins in the file; `no_place` where it was added
    bool data = false;            ///< begins with a row number and can be read

    static constexpr std::uint32_t no_place = 0xFFFFFFFF;
};

enum class TableUnit : std::uint8_t { none, mm, inch };

struct HeidenhainTable {
    std::string name, extension;       ///< upper case: "TOOL", "T"
    TableUnit unit = TableUnit::none;  ///< as the first line says; `none` where it says nothing
    std::vector<TableColumn> columns;  ///< from left to right; none where the table has no line of column names
    std::string head;                  ///< the lines above the rows, as read
    std::vector<TableRow> rows;
    std::string tail;  ///< `[END]` and what follows, as read
    std::uint32_t file = 0;
    bool utf8 = false;  ///< the text has characters above 127 in UTF-8; else they are CP1252
};

/// Reads the text. Reported with its place: no `BEGIN`, no column names, a name used twice, a description without end,
/// a line without row number, a row number used twice, a tab (columns are counted in characters); as a warning a table
/// without `[END]`. All of it is read and kept nevertheless.
[[nodiscard]] HeidenhainTable read_heidenhain_table(std::uint32_t file, const base::Sources& sources,
                                                    base::Diagnostics& diagnostics);
/// The table as text: what was read byte for byte, but for cells that were changed and rows that were added.
[[nodiscard]] std::string write_heidenhain_table(const HeidenhainTable& table);

/// Index of a column by its name, capitals or not.
[[nodiscard]] std::optional<std::size_t> find_column(const HeidenhainTable& table, std::string_view name);
/// Index of the row with this number as written ("5", "5.1"); leading zeros do not count.
[[nodiscard]] std::optional<std::size_t> find_row(const HeidenhainTable& table, std::string_view number);
/// The bytes of a cell without the blanks around it; empty where the row ends before it.
[[nodiscard]] std::string_view cell(const HeidenhainTable& table, std::size_t row, std::size_t column);
/// The same as UTF-8.
[[nodiscard]] std::string cell_text(const HeidenhainTable& table, std::size_t row, std::size_t column);
/// Place of a cell in the file as read; the whole cell where it is empty.
[[nodiscard]] base::Span cell_span(const HeidenhainTable& table, std::size_t row, std::size_t column);

/// Changes a cell; `value` is UTF-8. No other column moves. Gives what is wrong and changes nothing where the value is
/// longer than the column, has line breaks or tabs, or cannot be written in the table's characters.
[[nodiscard]] std::optional<std::string> set_cell(HeidenhainTable& table, std::size_t row, std::size_t column,
                                                  std::string_view value);
/// Adds an empty row behind the last one; gives what is wrong where the number cannot be one or is already there.
[[nodiscard]] std::optional<std::string> add_row(HeidenhainTable& table, std::string_view number);

}  // namespace obrys::shop
