#include <algorithm>

#include "base/text.hpp"
#include "report/path.hpp"
#include "report/sheet/sheet.hpp"

namespace obrys::report::sheet {

namespace {

constexpr std::string_view style = R"css(
body{font:14px/1.4 system-ui,sans-serif;color:#1e2228;margin:24px auto;max-width:1200px;padding:0 12px}
h1{font-size:20px;margin:24px 0 8px}h2{font-size:15px;margin:16px 0 4px}
table{border-collapse:collapse;width:100%}th,td{border:1px solid #c8ccd2;padding:2px 8px;text-align:left;vertical-align:top}
th{background:#f0f3f7;font-weight:600}p{margin:4px 0}section+section{break-before:page}
)css";

void pad(std::string& out, const std::string& cell, std::size_t width) {
    out += cell;
    const std::size_t length = base::character_count(cell);
    if (length < width) out.append(width - length, ' ');
}

void put_row(std::string& out, const std::vector<std::string>& row, const std::vector<std::size_t>& widths) {
    std::string line = " ";
    for (std::size_t i = 0; i < row.size(); ++i) line += ' ', pad(line, row[i], widths[i] + 1);
    line.erase(line.find_last_not_of(' ') + 1);
    out += line + "\n";
}

void put_table(std::string& out, const Table& table) {
    out += "\n" + table.title + "\n";
    std::vector<std::size_t> widths(table.head.size(), 0);
    const auto widen = [&](const std::vector<std::string>& row) {
        for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], base::character_count(row[i]));
    };
    widen(table.head);
    for (const auto& row : table.rows) widen(row);
    if (table.head.size() > 1) put_row(out, table.head, widths);
    for (const auto& row : table.rows) put_row(out, row, widths);
}

}  // namespace

std::string as_text(const std::vector<Page>& pages) {
    std::string out;
    for (const Page& page : pages) {
        out += (out.empty() ? "" : "\n\n") + page.title + "\n";
        out.append(base::character_count(page.title), '=');
        out += "\n";
        std::size_t widest = 0;
        for (const auto& [name, value] : page.facts) widest = std::max(widest, name.size());
        for (const auto& [name, value] : page.facts) pad(out, name + ":", widest + 2), out += value + "\n";
        for (const Table& table : page.tables) put_table(out, table);
        if (!page.remarks.empty()) out += "\n";
        for (const std::string& remark : page.remarks) out += remark + "\n";
    }
    return out;
}

std::string as_html(const std::vector<Page>& pages) {
    const std::string title = pages.empty() ? "" : escaped(pages.front().title);
    std::string out = "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>" + title +
                      "</title><style>" + std::string(style) + "</style></head><body>\n";
    for (const Page& page : pages) {
        out += "<section><h1>" + escaped(page.title) + "</h1>\n";
        if (!page.facts.empty()) out += "<table>\n";
        for (const auto& [name, value] : page.facts)
            out += "<tr><th>" + escaped(name) + "</th><td>" + escaped(value) + "</td></tr>\n";
        if (!page.facts.empty()) out += "</table>\n";
        for (const Table& table : page.tables) {
            out += "<h2>" + escaped(table.title) + "</h2><table>\n";
            if (table.head.size() > 1) {
                out += "<tr>";
                for (const std::string& cell : table.head) out += "<th>" + escaped(cell) + "</th>";
                out += "</tr>\n";
            }
            for (const auto& row : table.rows) {
                out += "<tr>";
                for (const std::string& cell : row) out += "<td>" + escaped(cell) + "</td>";
                out += "</tr>\n";
            }
            out += "</table>\n";
        }
        for (const std::string& remark : page.remarks) out += "<p>" + escaped(remark) + "</p>\n";
        out += "</section>\n";
    }
    return out + "</body></html>\n";
}

}  // namespace obrys::report::sheet
