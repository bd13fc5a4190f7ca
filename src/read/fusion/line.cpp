#include "read/fusion/line.hpp"

#include <algorithm>
#include <cmath>

#include "base/number.hpp"
#include "base/text.hpp"

namespace obrys::read::fusion {

std::optional<std::vector<double>> Line::numbers(std::size_t first, std::size_t count) const {
    std::vector<double> found;
    for (std::size_t i = first; i < first + count; ++i) {
        if (i >= tokens.size() || tokens[i].kind != TokenKind::number) return std::nullopt;
        found.push_back(tokens[i].value);
    }
    return found;
}

std::optional<std::vector<double>> Line::numbers(std::string_view word, std::size_t count) const {
    for (std::size_t i = 0; i < tokens.size(); ++i)
        if (tokens[i].kind == TokenKind::word && tokens[i].chars == word) return numbers(i + 1, count);
    return std::nullopt;
}

std::optional<double> Line::number(std::string_view word) const {
    const auto found = numbers(word, 1);
    return found ? std::optional(found->front()) : std::nullopt;
}

bool Line::has(std::string_view word) const {
    return std::any_of(tokens.begin(), tokens.end(),
                       [&](const Token& t) { return t.kind == TokenKind::word && t.chars == word; });
}

Token LineScanner::token(std::size_t& i, std::size_t end) const {
    Token t;
    t.begin = static_cast<std::uint32_t>(i);
    if (text_[i] == '"') {
        std::size_t k = i + 1;
        while (k < end && text_[k] != '"') k += text_[k] == '\\' ? 2 : 1;
        k = std::min(k, end);
        t.kind = TokenKind::text;
        t.chars = text_.substr(i + 1, k - i - 1);
        i = std::min(k + 1, end);
        if (text_.substr(i, 3) == "...") i = std::min(i + 3, end);
    } else {
        std::size_t k = i;
        while (k < end && !base::is_blank(text_[k])) ++k;
        t.chars = text_.substr(i, k - i);
        i = k;
        const auto value = base::parse_double(t.chars);
        if (value && std::isfinite(*value)) {
            t.kind = TokenKind::number;
            t.value = *value;
        }
    }
    t.end = static_cast<std::uint32_t>(i);
    return t;
}

bool LineScanner::next(Line& line) {
    std::size_t begin = at_;
    while (begin < text_.size() && (base::is_blank(text_[begin]) || text_[begin] == '\n' || text_[begin] == '\r'))
        ++begin;
    if (begin >= text_.size()) return at_ = text_.size(), false;
    std::size_t end = std::min(text_.find('\n', begin), text_.size());
    at_ = std::min(end + 1, text_.size());
    while (end > begin && (base::is_blank(text_[end - 1]) || text_[end - 1] == '\r')) --end;
    line.tokens.clear();
    line.name = {};
    line.byte = 0;
    line.begin = static_cast<std::uint32_t>(begin);
    line.end = static_cast<std::uint32_t>(end);
    for (std::size_t i = begin; i < end;) {
        if (base::is_blank(text_[i])) {
            ++i;
            continue;
        }
        line.tokens.push_back(token(i, end));
    }
    const bool record =
        line.tokens.size() > 1 && line.tokens[0].kind == TokenKind::number && line.tokens[1].kind == TokenKind::word;
    if (!record) return true;
    line.byte = line.tokens[0].value;
    line.name = line.tokens[1].chars;
    line.begin = line.tokens[1].begin;
    line.tokens.erase(line.tokens.begin(), line.tokens.begin() + 2);
    return true;
}

std::string unquoted(std::string_view chars) {
    std::string out;
    const auto digit = [](char c) { return c >= 'A' ? (c & ~0x20) - 'A' + 10 : c - '0'; };
    for (std::size_t i = 0; i < chars.size(); ++i) {
        if (chars[i] != '\\' || i + 1 == chars.size()) {
            out += chars[i];
            continue;
        }
        const char c = chars[++i];
        if (c == 'x' && i + 2 < chars.size()) {
            out += static_cast<char>(digit(chars[i + 1]) << 4 | digit(chars[i + 2]));
            i += 2;
        } else {
            out += c == 'n' ? '\n' : c;
        }
    }
    return out;
}

}  // namespace obrys::read::fusion
