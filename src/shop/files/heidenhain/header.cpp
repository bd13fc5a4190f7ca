#include "shop/files/heidenhain/header.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "base/codes.hpp"
#include "base/number.hpp"
#include "base/text.hpp"

namespace obrys::shop {

namespace {

constexpr std::size_t most_columns = 1000;  // controls have at most 200 characters in a row of an own table

/// A column as the description names it; width 0 where it says none.
struct Described {
    std::string name;
    std::uint32_t width = 0;
};

class HeadReader {
public:
    HeadReader(TableLines& lines, HeidenhainTable& table, base::Diagnostics& diagnostics)
        : lines_(lines), t_(table), diagnostics_(diagnostics) {}

    void read();

private:
    void complain(std::uint32_t begin, std::size_t size, std::string text, std::string remedy) {
        const base::Span where{t_.file, begin, begin + static_cast<std::uint32_t>(size)};
        diagnostics_.add(
            {base::Severity::error, base::codes::job_file, where, std::move(text), std::move(remedy), {}, {}});
    }
    void skip_empty();
    void first_line();
    void description();
    void describe(std::string_view line);
    void column_names();
    bool at_described_places(std::string_view line);
    void column(std::string_view line, std::size_t begin, std::size_t end);
    void close_columns();

    TableLines& lines_;
    HeidenhainTable& t_;
    base::Diagnostics& diagnostics_;
    std::vector<Described> described_;
    bool too_many_ = false;
};

bool starts_with_word(std::string_view line, std::string_view word) {
    return base::equals_ignoring_case(line.substr(0, word.size()), word);
}

void HeadReader::skip_empty() {
    while (!lines_.done() && base::trim(lines_.peek().text).empty()) lines_.take();
}

void HeadReader::read() {
    skip_empty();
    first_line();
    skip_empty();
    description();
    skip_empty();
    while (!lines_.done() && lines_.peek().text.starts_with(';')) lines_.take();
    column_names();
}

/// BEGIN TOOL .T MM; also BEGIN TOOL.T MM Version: 'Update:110.24', BEGIN FRAES.CDT.
void HeadReader::first_line() {
    const TableLine line = lines_.peek();
    std::string_view s = base::trim(line.text);
    if (!starts_with_word(s, "BEGIN") || (s.size() > 5 && !base::is_blank(s[5])))
        return complain(line.at, line.text.size(), "a table begins with BEGIN, its name and its unit",
                        "write for example: BEGIN TOOL .T MM");
    lines_.take();
    s = base::trim(s.substr(5));
    const auto word = [&s] {
        const std::string w = base::to_upper(s.substr(0, s.find_first_of(" \t")));
        s = base::trim(s.substr(w.size()));
        return w;
    };
    const std::size_t dot = s.find('.');
    const std::size_t blank = s.find_first_of(" \t");
    // A dot behind the second word belongs to something else: BEGIN TOOL MM Version: 'Update:110.24'.
    if (dot != std::string_view::npos && base::trim(s.substr(0, dot)).find_first_of(" \t") == std::string_view::npos) {
        t_.name = base::to_upper(base::trim(s.substr(0, dot)));
        s = base::trim(s.substr(dot + 1));
        t_.extension = word();
    } else {
        t_.name = base::to_upper(s.substr(0, blank));
        s = base::trim(s.substr(std::min(t_.name.size(), s.size())));
    }
    const std::string unit = word();
    if (unit == "MM") t_.unit = TableUnit::mm;
    if (unit == "INCH") t_.unit = TableUnit::inch;
}

void HeadReader::description() {
    if (lines_.done()) return;
    const TableLine first = lines_.peek();
    const bool structure = starts_with_word(base::trim(first.text), "#STRUCTBEGIN");
    if (!structure && !starts_with_word(base::trim(first.text), "TableDescription")) return;
    lines_.take();
    while (!lines_.done()) {
        const TableLine line = lines_.take();
        if (structure ? starts_with_word(base::trim(line.text), "#STRUCTEND") : line.text.starts_with(')')) return;
        describe(base::trim(line.text));
    }
    complain(first.at, first.text.size(), "the description of the columns has no end",
             structure ? "it ends with #STRUCTEND" : "it ends with ) at the beginning of a line");
}

/// NAME = WMAT, WIDTH = 16; or key:="NAME", width:=15.
void HeadReader::describe(std::string_view line) {
    const std::size_t equal = line.find('=');
    if (equal == std::string_view::npos) return;
    std::string_view key = line.substr(0, equal), value = base::trim(line.substr(equal + 1));
    if (key.ends_with(':')) key.remove_suffix(1);
    key = base::trim(key);
    if (value.ends_with(',')) value.remove_suffix(1);
    if (value.size() >= 2 && value.front() == '"' && value.back() == '"') value = value.substr(1, value.size() - 2);
    if (base::equals_ignoring_case(key, "NAME") || base::equals_ignoring_case(key, "key"))
        if (described_.size() < most_columns) described_.push_back({std::string(value), 0});
    if (base::equals_ignoring_case(key, "WIDTH") && !described_.empty()) {
        const auto width = base::parse_integer(value);
        if (width && *width > 0 && *width <= 10'000) described_.back().width = static_cast<std::uint32_t>(*width);
    }
}

void HeadReader::column(std::string_view line, std::size_t begin, std::size_t end) {
    const std::uint32_t at = lines_.peek().at + static_cast<std::uint32_t>(begin);
    if (t_.columns.size() == most_columns) {
        if (!std::exchange(too_many_, true))
            complain(at, end - begin, "a table has at most " + std::to_string(most_columns) + " columns",
                     "see whether this line holds the column names");
        return;
    }
    TableColumn c;
    c.name = std::string(line.substr(begin, end - begin));
    const std::string_view before = line.substr(0, begin);
    c.begin = static_cast<std::uint32_t>(t_.utf8 ? base::character_count(before) : before.size());
    if (t_.columns.empty()) c.begin = 0;  // a number may stand right-aligned below its name
    if (const auto same = find_column(t_, c.name))
        complain(at, end - begin, "column " + c.name + " is already there",
                 "name each column once: the first one is taken");
    t_.columns.push_back(std::move(c));
}

/// Names as wide as their columns stand without a blank between them: then the description tells where each begins.
bool HeadReader::at_described_places(std::string_view line) {
    std::size_t at = 0;
    std::vector<std::size_t> begins;
    for (const Described& d : described_) {
        const std::size_t begin = line.find_first_not_of(" \t", at);
        if (begin == std::string_view::npos || d.name.empty() || !line.substr(begin).starts_with(d.name)) return false;
        begins.push_back(begin);
        at = begin + d.name.size();
    }
    if (!base::trim(line.substr(at)).empty()) return false;
    for (std::size_t i = 0; i < begins.size(); ++i) column(line, begins[i], begins[i] + described_[i].name.size());
    return true;
}

void HeadReader::column_names() {
    if (lines_.done() || base::equals_ignoring_case(base::trim(lines_.peek().text), "[END]"))
        return complain(lines_.at(), 0, "the table has no line of column names",
                        "the names stand above the rows, each where its column begins");
    const TableLine line = lines_.peek();
    if (const std::size_t tab = line.text.find('\t'); tab != std::string_view::npos)
        complain(line.at + static_cast<std::uint32_t>(tab), 1, "a tab in the line of column names",
                 "replace it by as many blanks as the columns need");
    if (described_.empty() || !at_described_places(line.text))
        for (std::size_t at = line.text.find_first_not_of(" \t"); at != std::string_view::npos;) {
            const std::size_t end = std::min(line.text.find_first_of(" \t", at), line.text.size());
            column(line.text, at, end);
            at = line.text.find_first_not_of(" \t", end);
        }
    close_columns();
    lines_.take();
}

void HeadReader::close_columns() {
    std::map<std::string_view, std::uint32_t> widths;
    for (const Described& d : described_) widths.emplace(d.name, d.width);
    for (std::size_t i = 0; i < t_.columns.size(); ++i) {
        TableColumn& c = t_.columns[i];
        const bool last = i + 1 == t_.columns.size();
        c.end = last ? TableColumn::no_limit : t_.columns[i + 1].begin;
        // Without description one blank keeps two values apart.
        c.width = last ? TableColumn::no_limit : c.end - c.begin - 1;
        if (const auto w = widths.find(c.name); w != widths.end() && w->second > 0)
            c.width = std::min(w->second, last ? w->second : c.end - c.begin);
    }
}

}  // namespace

void read_table_head(TableLines& lines, HeidenhainTable& table, base::Diagnostics& diagnostics) {
    HeadReader(lines, table, diagnostics).read();
}

}  // namespace obrys::shop
