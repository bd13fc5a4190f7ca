#include <algorithm>
#include <array>

#include "base/text.hpp"
#include "read/rs274/acramatic_read.hpp"

namespace obrys::read::rs274 {

namespace {

/// Lines of the text in upper case without blanks and without what stands behind a semicolon; no empty ones.
std::vector<std::string> lines_of(std::string_view text) {
    std::vector<std::string> lines(1);
    bool comment = false;
    for (const char c : text.substr(0, base::telling_bytes)) {
        if (c == '\n') {
            comment = false;
            if (!lines.back().empty()) lines.emplace_back();
            continue;
        }
        comment = comment || c == ';';
        if (!comment && !base::is_blank(c) && c != '\r') lines.back() += base::upper(c);
    }
    return lines;
}

/// A block that begins with `:`: nothing behind it, a number, or a word.
bool is_alignment(std::string_view line) {
    if (!line.starts_with(':')) return false;
    line.remove_prefix(1);
    return line.empty() || base::is_digit(line.front()) || line.starts_with("(PGM,") ||
           (line.size() > 1 && base::is_letter(line[0]) && base::is_digit(line[1]));
}

}  // namespace

int acramatic_likelihood(std::string_view text, std::string_view, std::vector<std::string>* signs) {
    int table = 0, alignment = 0, named = 0, words = 0, rigid = 0, all = 0;
    for (const std::string& line : lines_of(text)) {
        if (line.empty() || line == "%") continue;
        ++all;
        table += line.find("[$CYCLE_PARAMS(") != std::string::npos;
        alignment += is_alignment(line);
        named += line.find("(PGM,NAME=") != std::string::npos;
        rigid += line.find("G84.1") != std::string::npos;
        words += line.size() > 1 && std::string_view("NGMXYZFST").find(line[0]) != std::string_view::npos &&
                 (base::is_digit(line[1]) || line[1] == '-' || line[1] == '.');
    }
    int score = 0;
    const auto sign = [&](int times, int points, std::string_view word) {
        if (times == 0) return;
        score += points;
        if (signs != nullptr) signs->emplace_back(word);
    };
    sign(table, 70, "[$CYCLE_PARAMS(");
    sign(named, 40, "(PGM, NAME=");
    sign(alignment, 55, "a block that begins with :");
    if (score > 0 && rigid > 0) score += 10;
    if (score > 0 && words * 2 >= all) score += 15;
    return std::clamp(score, 0, 100);
}

}  // namespace obrys::read::rs274
