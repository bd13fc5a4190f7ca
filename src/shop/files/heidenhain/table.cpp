#include "shop/files/heidenhain/table.hpp"

#include <algorithm>
#include <set>

#include "base/codes.hpp"
#include "base/text.hpp"
#include "shop/files/heidenhain/header.hpp"

namespace obrys::shop {

namespace {

/// "005.1" -> "5.1"; empty where the text is no row number.
std::string row_number(std::string_view s) {
    const std::size_t dot = s.find('.');
    const auto digits = [](std::string_view d) {
        return !d.empty() && std::all_of(d.begin(), d.end(), base::is_digit);
    };
    if (!digits(s.substr(0, dot)) || (dot != std::string_view::npos && !digits(s.substr(dot + 1)))) return {};
    while (s.size() > 1 && s[0] == '0' && base::is_digit(s[1])) s.remove_prefix(1);
    return std::string(s);
}

/// Offset of the `n`-th character; the size of the text where it has fewer.
std::size_t byte_of(std::string_view s, std::uint32_t n, bool utf8) {
    if (!utf8) return std::min<std::size_t>(n, s.size());
    std::size_t i = 0;
    for (; i < s.size() && n > 0; --n) {
        ++i;
        while (i < s.size() && (static_cast<unsigned char>(s[i]) & 0xC0) == 0x80) ++i;
    }
    return i;
}

struct Bytes {
    std::size_t begin = 0, end = 0;
};

Bytes bytes_of(const HeidenhainTable& t, std::size_t row, std::size_t column) {
    const std::string& text = t.rows[row].text;
    const TableColumn& c = t.columns[column];
    return {byte_of(text, c.begin, t.utf8), byte_of(text, c.end, t.utf8)};
}

/// CP1252 has one byte for each of its characters, so the way back is a search over 128.
std::optional<std::string> utf8_to_cp1252(std::string_view s) {
    std::string out;
    for (std::size_t i = 0; i < s.size();) {
        if (static_cast<unsigned char>(s[i]) < 0x80) {
            out += s[i++];
            continue;
        }
        int found = 0;
        std::string character;
        for (int byte = 0x80; byte < 0x100 && found == 0; ++byte) {
            character = base::cp1252_to_utf8(std::string(1, static_cast<char>(byte)));
            if (s.substr(i).starts_with(character) && character != "\xEF\xBF\xBD") found = byte;
        }
        if (found == 0) return std::nullopt;
        out += static_cast<char>(found);
        i += character.size();
    }
    return out;
}

bool holds_no_row(std::string_view line) {
    const std::string_view s = base::trim(line);
    return s.empty() || s.front() == ';' || s.front() == '*' || s.front() == '#';
}

class RowReader {
public:
    RowReader(HeidenhainTable& table, base::Diagnostics& diagnostics) : t_(table), diagnostics_(diagnostics) {}

    void row(const TableLine& line);
    void finish(std::uint32_t size, bool ended) {
        if (!ended)
            complain({t_.file, size, size}, base::Severity::warning, "the table ends without [END]",
                     "see whether the file is complete");
    }

private:
    void complain(base::Span where, base::Severity severity, std::string text, std::string remedy) {
        diagnostics_.add({severity, base::codes::job_file, where, std::move(text), std::move(remedy), {}, {}});
    }
    HeidenhainTable& t_;
    base::Diagnostics& diagnostics_;
    std::set<std::string> numbers_;
};

void RowReader::row(const TableLine& line) {
    t_.rows.push_back({std::string(line.text), std::string(line.end), line.at, false});
    if (t_.columns.empty() || holds_no_row(line.text)) return;
    const auto size = static_cast<std::uint32_t>(line.text.size());
    if (const std::size_t tab = line.text.find('\t'); tab != std::string_view::npos) {
        const std::uint32_t at = line.at + static_cast<std::uint32_t>(tab);
        return complain({t_.file, at, at + 1}, base::Severity::error, "a tab in a row of a table with fixed columns",
                        "replace it by as many blanks as the columns need");
    }
    const std::size_t row = t_.rows.size() - 1;
    t_.rows[row].data = true;
    const std::string number = row_number(cell(t_, row, 0));
    if (number.empty()) {
        t_.rows[row].data = false;
        return complain({t_.file, line.at, line.at + size}, base::Severity::error,
                        "this line has no row number in column " + t_.columns[0].name,
                        "a row begins with its number; the values stand below the column names");
    }
    if (numbers_.insert(number).second) return;
    t_.rows[row].data = false;
    complain(cell_span(t_, row, 0), base::Severity::error,
             "row " + number + " is already there (column " + t_.columns[0].name + ")", "number each row once");
}

}  // namespace

HeidenhainTable read_heidenhain_table(std::uint32_t file, const base::Sources& sources,
                                      base::Diagnostics& diagnostics) {
    const base::Source& source = sources[file];
    HeidenhainTable t;
    t.file = file;
    t.utf8 = source.utf8 && std::any_of(source.text.begin(), source.text.end(),
                                        [](char c) { return static_cast<unsigned char>(c) >= 0x80; });
    TableLines lines(source.text);
    read_table_head(lines, t, diagnostics);
    t.head = source.text.substr(0, lines.at());
    RowReader reader(t, diagnostics);
    bool ended = false;
    while (!lines.done()) {
        const std::uint32_t begin = lines.at();
        const TableLine line = lines.take();
        ended = base::equals_ignoring_case(base::trim(line.text), "[END]");
        if (ended) {
            t.tail = source.text.substr(begin);
            break;
        }
        reader.row(line);
    }
    reader.finish(static_cast<std::uint32_t>(source.text.size()), ended);
    return t;
}

std::string write_heidenhain_table(const HeidenhainTable& t) {
    std::string out = t.head;
    for (const TableRow& r : t.rows) {
        out += r.text;
        out += r.line_end;
    }
    return out + t.tail;
}

std::optional<std::size_t> find_column(const HeidenhainTable& t, std::string_view name) {
    for (std::size_t i = 0; i < t.columns.size(); ++i)
        if (base::equals_ignoring_case(t.columns[i].name, name)) return i;
    return std::nullopt;
}

std::optional<std::size_t> find_row(const HeidenhainTable& t, std::string_view number) {
    const std::string wanted = row_number(base::trim(number));
    for (std::size_t i = 0; i < t.rows.size() && !wanted.empty(); ++i)
        if (t.rows[i].data && row_number(cell(t, i, 0)) == wanted) return i;
    return std::nullopt;
}

std::string_view cell(const HeidenhainTable& t, std::size_t row, std::size_t column) {
    const Bytes b = bytes_of(t, row, column);
    return base::trim(std::string_view(t.rows[row].text).substr(b.begin, b.end - b.begin));
}

std::string cell_text(const HeidenhainTable& t, std::size_t row, std::size_t column) {
    const std::string_view s = cell(t, row, column);
    return t.utf8 ? std::string(s) : base::cp1252_to_utf8(s);
}

base::Span cell_span(const HeidenhainTable& t, std::size_t row, std::size_t column) {
    const TableRow& r = t.rows[row];
    if (r.at == TableRow::no_place) return {t.file, 0, 0};
    Bytes b = bytes_of(t, row, column);
    const std::string_view s = cell(t, row, column);
    if (!s.empty()) {
        b.begin = static_cast<std::size_t>(s.data() - r.text.data());
        b.end = b.begin + s.size();
    }
    return {t.file, r.at + static_cast<std::uint32_t>(b.begin), r.at + static_cast<std::uint32_t>(b.end)};
}

std::optional<std::string> set_cell(HeidenhainTable& t, std::size_t row, std::size_t column, std::string_view value) {
    const TableColumn& c = t.columns[column];
    value = base::trim(value);
    if (column == 0) return "column " + c.name + " numbers the rows: add a row with the new number";
    const bool is_text = std::none_of(value.begin(), value.end(), [](char ch) { return ch >= 0 && ch < ' '; });
    if (!is_text || !base::is_utf8(value))
        return "column " + c.name + ": the value has line breaks, tabs or bytes that are no characters";
    const auto encoded = t.utf8 ? std::optional(std::string(value)) : utf8_to_cp1252(value);
    if (!encoded)
        return "column " + c.name + ": \"" + std::string(value) + "\" has characters that the table's code page lacks";
    const std::size_t length = base::character_count(value);
    if (length > c.width)
        return "column " + c.name + ": \"" + std::string(value) + "\" has " + std::to_string(length) +
               " characters, the column holds " + std::to_string(c.width);
    if (*encoded == cell(t, row, column)) return std::nullopt;
    std::string& text = t.rows[row].text;
    const std::size_t characters = t.utf8 ? base::character_count(text) : text.size();
    if (characters < c.begin) text.append(c.begin - characters, ' ');
    const Bytes b = bytes_of(t, row, column);
    // What followed keeps its place; where nothing follows, the line is not made longer than it was.
    const std::size_t reach = characters > c.begin ? std::min<std::size_t>(characters, c.end) - c.begin : 0;
    std::string padded = *encoded;
    if (length < reach) padded.append(reach - length, ' ');
    text.replace(b.begin, b.end - b.begin, padded);
    return std::nullopt;
}

std::optional<std::string> add_row(HeidenhainTable& t, std::string_view number) {
    const std::string wanted = row_number(base::trim(number));
    if (t.columns.empty()) return "the table has no columns";
    if (wanted.empty()) return "\"" + std::string(number) + "\" is not a row number";
    if (find_row(t, wanted)) return "row " + wanted + " is already there";
    if (wanted.size() > t.columns[0].width)
        return "row number " + wanted + " is longer than column " + t.columns[0].name;
    const std::size_t line_break = t.head.find_first_of("\r\n");
    std::string line_end = "\r\n";  // what the control writes
    if (line_break != std::string::npos)
        line_end = t.head.substr(line_break, t.head.compare(line_break, 2, "\r\n") == 0 ? 2 : 1);
    std::size_t at = t.rows.size();
    while (at > 0 && !t.rows[at - 1].data) --at;
    if (at == 0) at = t.rows.size();
    TableRow row{wanted, line_end, TableRow::no_place, true};
    const std::size_t length = at > 0 ? t.rows[at - 1].text.size() : 0;
    if (row.text.size() < length) row.text.append(length - row.text.size(), ' ');
    if (at > 0 && t.rows[at - 1].line_end.empty()) std::swap(row.line_end, t.rows[at - 1].line_end);
    if (at == 0 && !t.head.empty() && t.head.back() != '\n' && t.head.back() != '\r') t.head += line_end;
    t.rows.insert(t.rows.begin() + static_cast<std::ptrdiff_t>(at), std::move(row));
    return std::nullopt;
}

}  // namespace obrys::shop
