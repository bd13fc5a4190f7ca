#include "shop/files/linuxcnc/table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>

#include "base/codes.hpp"
#include "base/number.hpp"
#include "base/text.hpp"
#include "base/whole.hpp"
#include "shop/files/lines.hpp"
#include "shop/size_range.hpp"

namespace obrys::shop {

namespace {

constexpr std::string_view letters = "TPXYZABCUVWDIJQ", whole_letters = "TPQ";
constexpr std::string_view mill_columns = "TPZD", lathe_columns = "TPZXDIJQ";

bool is_whole(char letter) { return whole_letters.find(letter) != std::string_view::npos; }

/// A number as C reads it, but the whole text: "+1.5", "-.5", "2e1"; of T P Q a whole one (also as "3.000000").
std::optional<double> number_of(std::string_view s, bool whole) {
    const auto sign = [](char c) { return c == '+' || c == '-'; };
    if (s.empty() || (s.size() > 1 && sign(s[0]) && sign(s[1]))) return std::nullopt;
    const auto v = base::parse_double(s);
    if (v && whole && (*v != std::floor(*v) || std::abs(*v) > std::numeric_limits<std::int32_t>::max()))
        return std::nullopt;
    return v;
}

struct Token {
    std::string_view text;
    std::uint32_t at = 0;  ///< in the line
};

/// The words of a line up to `end`.
std::vector<Token> tokens_of(std::string_view line, std::size_t end) {
    std::vector<Token> out;
    for (std::size_t i = 0; i < end;) {
        if (base::is_blank(line[i])) {
            ++i;
            continue;
        }
        std::size_t stop = i;
        while (stop < end && !base::is_blank(line[stop])) ++stop;
        out.push_back({line.substr(i, stop - i), static_cast<std::uint32_t>(i)});
        i = stop;
    }
    return out;
}

LinuxcncField field_at(char letter, const Token& number, double value) {
    return {letter, number.at, number.at + static_cast<std::uint32_t>(number.text.size()), value};
}

class TableReader {
public:
    TableReader(LinuxcncTable& table, base::Diagnostics& diagnostics) : t_(table), diagnostics_(diagnostics) {}

    void line(const TableLine& text);

private:
    void words(LinuxcncLine& line, std::size_t end);
    bool word(LinuxcncLine& line, const Token& token);
    bool field(LinuxcncLine& line, char letter, const Token& whole, const Token& number);
    void columns(LinuxcncLine& line);
    void check(LinuxcncLine& line, LinuxcncLine::Form form);
    void tell(base::Severity severity, std::string_view code, const Token& where, std::string text,
              std::string remedy) {
        const std::uint32_t at = t_.lines.back().at + where.at;
        diagnostics_.add({severity,
                          code,
                          {t_.file, at, at + static_cast<std::uint32_t>(where.text.size())},
                          std::move(text),
                          std::move(remedy),
                          {},
                          {}});
    }
    void error(const Token& where, std::string text, std::string remedy) {
        tell(base::Severity::error, base::codes::job_value, where, std::move(text), std::move(remedy));
    }
    void warning(const Token& where, std::string text, std::string remedy) {
        tell(base::Severity::warning, base::codes::job_file, where, std::move(text), std::move(remedy));
    }

    LinuxcncTable& t_;
    base::Diagnostics& diagnostics_;
    std::set<double> numbers_;
    bool told_columns_ = false;
};

/// The line of column names of old files: `POC FMS LEN DIAM COMMENT`, `TOOLNO POCKET LENGTH DIAMETER COMMENT`.
bool is_header(const std::vector<Token>& tokens) {
    return tokens.size() > 2 &&
           (base::equals_ignoring_case(tokens[0].text, "POC") || base::equals_ignoring_case(tokens[0].text, "TOOLNO"));
}

void TableReader::line(const TableLine& text) {
    LinuxcncLine& line = t_.lines.emplace_back();
    line.text = text.text;
    line.line_end = text.end;
    line.at = text.at;
    line.comment = static_cast<std::uint32_t>(line.text.size());
    const std::size_t semicolon = std::min(line.text.find(';'), line.text.size());
    const std::vector<Token> tokens = tokens_of(line.text, semicolon);
    if (semicolon < line.text.size()) line.comment = static_cast<std::uint32_t>(semicolon) + 1;
    if (tokens.empty() || is_header(tokens)) return;
    const char first = tokens[0].text[0];
    if (base::is_digit(first) || first == '+' || first == '-') return columns(line);
    words(line, semicolon);
}

/// A value that stands in `whole`; false where the line is lost by it.
bool TableReader::field(LinuxcncLine& line, char letter, const Token& whole, const Token& number) {
    const auto value = number_of(number.text, is_whole(letter));
    if (!value) {
        error(whole, std::string(1, letter) + (is_whole(letter) ? " needs a whole number" : " needs a number"),
              "LinuxCNC reads as far as it understands, or passes over the line");
        return false;
    }
    const std::string problem = is_whole(letter) ? "" : size_problem(*value, letter == 'D');
    if (!problem.empty()) {
        error(whole, std::string(1, letter) + " " + problem, "");
        return false;
    }
    if (value_of(line, letter)) warning(whole, std::string("the line has two words ") + letter, "the last one counts");
    line.fields.push_back(field_at(letter, number, *value));
    return true;
}

/// One word; false where the line is lost by it.
bool TableReader::word(LinuxcncLine& line, const Token& token) {
    const char letter = base::upper(token.text[0]);
    const std::string name(token.text);
    if (letters.find(letter) == std::string_view::npos) {
        error(token, "\"" + base::as_utf8(name) + "\" is no word of a tool table",
              "the letters are T P X Y Z A B C U V W D I J Q, a comment begins with ;");
        return false;
    }
    return field(line, letter, token, {token.text.substr(1), token.at + 1});
}

void TableReader::words(LinuxcncLine& line, std::size_t end) {
    bool good = true;
    for (const Token& token : tokens_of(line.text, end)) good = word(line, token) && good;
    if (!good) return;
    if (const std::size_t tab = line.text.substr(0, end).find('\t'); tab != std::string::npos)
        warning({std::string_view(line.text).substr(tab, 1), static_cast<std::uint32_t>(tab)},
                "a tab between the words of a tool", "LinuxCNC parts words at blanks only: write a blank");
    check(line, LinuxcncLine::Form::words);
}

void TableReader::columns(LinuxcncLine& line) {
    const std::vector<Token> tokens = tokens_of(line.text, line.text.size());
    const auto fits = [&](std::string_view names) {
        if (tokens.size() < names.size()) return false;
        for (std::size_t i = 0; i < names.size(); ++i)
            if (!number_of(tokens[i].text, is_whole(names[i]))) return false;
        return true;
    };
    const std::string_view names = fits(lathe_columns) ? lathe_columns : mill_columns;
    if (!fits(names)) {
        line.comment = static_cast<std::uint32_t>(line.text.size());
        return error({line.text, 0}, "this is no line of a tool table",
                     "a tool is written T1 P1 D6.0 Z-20.5 ; comment");
    }
    for (std::size_t i = 0; i < names.size(); ++i)
        if (!field(line, names[i], tokens[i], tokens[i])) return;
    line.comment =
        tokens.size() > names.size() ? tokens[names.size()].at : static_cast<std::uint32_t>(line.text.size());
    if (line.comment < line.text.size() && line.text[line.comment] == ';') ++line.comment;
    if (!told_columns_)
        warning({line.text, 0}, "a tool table in columns, as LinuxCNC before 2.4 wrote it",
                "LinuxCNC 2.9 passes over such lines: write T1 P1 D6.0 Z-20.5 ; comment");
    told_columns_ = true;
    check(line, LinuxcncLine::Form::columns);
}

/// What a tool needs. The line counts from here on.
void TableReader::check(LinuxcncLine& line, LinuxcncLine::Form form) {
    const auto tool = value_of(line, 'T');
    const Token all{line.text, 0};
    if (!tool) return error(all, "the tool has no number", "write T and its number");
    if (*tool < 0) return error(all, "a tool number is 0 or more", "");
    if (!value_of(line, 'P'))
        return error(all, "T" + base::shortest(*tool) + " has no pocket",
                     "write P and a number: without it the tool does not come into LinuxCNC's list");
    line.form = form;
    if (!numbers_.insert(*tool).second && *tool != 0)
        warning(all, "T" + base::shortest(*tool) + " is already there", "the first line counts");
}

std::string written(double value, std::string_view before) {
    std::string out = base::shortest(value);
    if (before.starts_with('+') && value >= 0) out.insert(0, 1, '+');
    return out;
}

void shift(LinuxcncLine& line, std::uint32_t from, std::size_t removed, std::size_t added) {
    const auto move = [&](std::uint32_t& at) {
        if (at >= from + removed) at = static_cast<std::uint32_t>(at - removed + added);
    };
    for (LinuxcncField& f : line.fields)
        if (f.begin > from) move(f.begin), move(f.end);
    move(line.comment);
}

std::optional<std::string> refusal(const LinuxcncTable& t, std::size_t line, char letter, double value) {
    if (line >= t.lines.size() || t.lines[line].form == LinuxcncLine::Form::none) return "the line is no tool";
    if (letters.find(letter) == std::string_view::npos) return std::string("a tool table has no letter ") + letter;
    if (!std::isfinite(value)) return std::string(1, letter) + ": the value is not finite";
    const auto n = base::whole<std::int32_t>(value, 0);
    if (is_whole(letter) && !n) return std::string(1, letter) + ": the value is a whole number, 0 or more";
    if (letter == 'T' && value != 0 && find_line(t, *n).value_or(line) != line)
        return "T" + base::shortest(value) + " is already there";
    if (t.lines[line].form == LinuxcncLine::Form::columns && !value_of(t.lines[line], letter))
        return std::string("the table has no column for ") + letter;
    return std::nullopt;
}

}  // namespace

LinuxcncTable read_linuxcnc_table(std::uint32_t file, const base::Sources& sources, base::Diagnostics& diagnostics) {
    LinuxcncTable t;
    t.file = file;
    TableReader reader(t, diagnostics);
    for (TableLines lines(sources[file].text); !lines.done();) reader.line(lines.take());
    return t;
}

std::string write_linuxcnc_table(const LinuxcncTable& t) {
    std::string out;
    for (const LinuxcncLine& l : t.lines) {
        out += l.text;
        out += l.line_end;
    }
    return out;
}

std::optional<double> value_of(const LinuxcncLine& line, char letter) {
    for (auto f = line.fields.rbegin(); f != line.fields.rend(); ++f)
        if (f->letter == letter) return f->value;
    return std::nullopt;
}

std::string comment_of(const LinuxcncLine& line) {
    return base::as_utf8(base::trim(std::string_view(line.text).substr(line.comment)));
}

std::optional<std::size_t> find_line(const LinuxcncTable& t, std::int64_t number) {
    for (std::size_t i = 0; i < t.lines.size(); ++i)
        if (t.lines[i].form != LinuxcncLine::Form::none && value_of(t.lines[i], 'T') == static_cast<double>(number))
            return i;
    return std::nullopt;
}

std::optional<std::string> set_field(LinuxcncTable& t, std::size_t index, char letter, double value) {
    if (auto problem = refusal(t, index, letter, value)) return problem;
    LinuxcncLine& line = t.lines[index];
    const auto found = std::find_if(line.fields.rbegin(), line.fields.rend(),
                                    [&](const LinuxcncField& f) { return f.letter == letter; });
    if (found == line.fields.rend()) {
        const std::uint32_t at = line.fields.back().end;
        const std::string text = base::shortest(value);
        line.text.insert(at, std::string(" ") + letter + text);
        shift(line, at, 0, text.size() + 2);
        line.fields.push_back({letter, at + 2, at + 2 + static_cast<std::uint32_t>(text.size()), value});
        return std::nullopt;
    }
    LinuxcncField& f = *found;
    const std::size_t length = f.end - f.begin;
    const std::string text = written(value, std::string_view(line.text).substr(f.begin, length));
    line.text.replace(f.begin, length, text);
    shift(line, f.begin, length, text.size());
    f.end = f.begin + static_cast<std::uint32_t>(text.size());
    f.value = value;
    return std::nullopt;
}

std::optional<std::string> add_tool(LinuxcncTable& t, std::int64_t number, std::int64_t pocket) {
    constexpr std::int64_t most = std::numeric_limits<std::int32_t>::max();
    if (number < 0 || number > most || pocket < 0 || pocket > most)
        return "tool and pocket are whole numbers, 0 or more";
    if (find_line(t, number)) return "T" + std::to_string(number) + " is already there";
    std::size_t at = t.lines.size();
    while (at > 0 && t.lines[at - 1].form == LinuxcncLine::Form::none) --at;
    if (at == 0) at = t.lines.size();
    const auto ended =
        std::find_if(t.lines.begin(), t.lines.end(), [](const LinuxcncLine& l) { return !l.line_end.empty(); });
    LinuxcncLine line;
    line.form = LinuxcncLine::Form::words;
    line.line_end = ended == t.lines.end() ? "\n" : ended->line_end;
    const std::string tool = std::to_string(number), place = std::to_string(pocket);
    line.text = "T" + tool + " P" + place;
    const auto size = static_cast<std::uint32_t>(line.text.size()),
               middle = static_cast<std::uint32_t>(tool.size()) + 1;
    line.fields = {{'T', 1, middle, static_cast<double>(number)}, {'P', middle + 2, size, static_cast<double>(pocket)}};
    line.comment = size;
    if (at > 0 && t.lines[at - 1].line_end.empty()) std::swap(line.line_end, t.lines[at - 1].line_end);
    t.lines.insert(t.lines.begin() + static_cast<std::ptrdiff_t>(at), std::move(line));
    return std::nullopt;
}

}  // namespace obrys::shop
