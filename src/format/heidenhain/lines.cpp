#include "format/heidenhain/lines.hpp"

#include <algorithm>

#include "base/text.hpp"

namespace obrys::format::heidenhain {

std::vector<Line> split_lines(std::string_view text) {
    std::vector<Line> lines;
    const char mark = text.find('\n') == std::string_view::npos ? '\r' : '\n';
    while (!text.empty()) {
        const std::size_t at = text.find(mark);
        if (at == std::string_view::npos) {
            lines.push_back({text, {}});
            break;
        }
        const std::size_t from = mark == '\n' && at > 0 && text[at - 1] == '\r' ? at - 1 : at;
        lines.push_back({text.substr(0, from), text.substr(from, at + 1 - from)});
        text.remove_prefix(at + 1);
    }
    return lines;
}

std::string_view trim_right(std::string_view s) {
    while (!s.empty() && base::is_blank(s.back())) s.remove_suffix(1);
    return s;
}

std::string_view trim_left(std::string_view s) {
    while (!s.empty() && base::is_blank(s.front())) s.remove_prefix(1);
    return s;
}

bool goes_on(std::string_view line) { return trim_right(line).ends_with('~'); }

bool blanks_only(std::string_view line) { return !line.empty() && trim_right(line).empty(); }

bool has_control_characters(std::string_view line) {
    return std::any_of(line.begin(), line.end(),
                       [](char c) { return static_cast<unsigned char>(c) < ' ' && c != '\t'; });
}

Parts split_comment(std::string_view line, bool texts) {
    bool inside = false;
    std::size_t at = 0;
    for (; at < line.size(); ++at) {
        if (texts && line[at] == '"') inside = !inside;
        if (line[at] == ';' && !inside) break;
    }
    Parts p;
    p.code = trim_right(line.substr(0, at));
    p.comment = trim_right(line.substr(at));
    if (p.comment.empty() && p.code.ends_with('~')) {
        p.goes_on = true;
        p.code = trim_right(p.code.substr(0, p.code.size() - 1));
    }
    return p;
}

void Writer::line(std::string_view text, std::string_view end) {
    out_ += text;
    if (end.empty() || ends_ == LineEnds::keep)
        out_ += end;
    else
        out_ += ends_ == LineEnds::lf ? "\n" : "\r\n";
}

}  // namespace obrys::format::heidenhain
