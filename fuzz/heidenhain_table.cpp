// Any bytes are read without crash as a HEIDENHAIN table and come back byte for byte; every span lies inside the text.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "shop/files/heidenhain/views.hpp"

namespace {

using namespace obrys;

void require(bool holds) {
    if (!holds) std::abort();
}

void check_span(const base::Span& s, std::size_t size) { require(s.begin <= s.end && s.end <= size); }

void check_edits(shop::HeidenhainTable table) {
    const std::string before = shop::write_heidenhain_table(table);
    for (std::size_t row = 0; row < table.rows.size() && row < 8; ++row)
        for (std::size_t column = 1; column < table.columns.size() && column < 8; ++column) {
            if (!table.rows[row].data) continue;
            // What a cell holds may be put into it again: nothing changes, or it was longer than the column.
            const std::string value = shop::cell_text(table, row, column);
            (void)shop::set_cell(table, row, column, value);
            require(shop::write_heidenhain_table(table) == before);
        }
    for (std::size_t row = 0; row < table.rows.size() && row < 8; ++row)
        for (std::size_t column = 1; column < table.columns.size() && column < 8; ++column)
            if (table.rows[row].data && !shop::set_cell(table, row, column, "7"))
                require(shop::cell(table, row, column) == "7");
    (void)shop::add_row(table, "31");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    base::Sources sources;
    const auto file = sources.add("FUZZ.T", std::string(data, data + size));
    base::Diagnostics diagnostics;
    const shop::HeidenhainTable table = shop::read_heidenhain_table(file, sources, diagnostics);
    const std::size_t length = sources[file].text.size();
    require(shop::write_heidenhain_table(table) == sources[file].text);
    for (const shop::Tool& t : shop::tools_of(table, diagnostics)) check_span(t.where, length);
    for (const shop::Pocket& p : shop::pockets_of(table, diagnostics)) check_span(p.where, length);
    for (const auto& [number, datum] : shop::datums_of(table, diagnostics)) check_span(datum.where, length);
    for (const shop::PatternPoint& p : shop::points_of(table, diagnostics)) check_span(p.where, length);
    (void)shop::cutting_data_of(table, diagnostics);
    (void)shop::materials_of(table);
    for (const base::Diagnostic& d : diagnostics.all()) check_span(d.where, length), (void)base::render(d, sources);
    check_edits(table);
    return 0;
}
