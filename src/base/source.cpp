#include "base/source.hpp"

#include <algorithm>
#include <cstring>

#include "base/text.hpp"

namespace obrys::base {

std::uint32_t Sources::add(std::string name, std::string text, BlockNumbers numbers) {
    if (text.starts_with("\xEF\xBB\xBF")) text.erase(0, 3);
    const bool utf8 = is_utf8(text);
    files_.push_back({std::move(name), std::move(text), numbers, utf8});
    line_starts_.emplace_back();
    return size() - 1;
}

const std::vector<std::uint32_t>& Sources::line_starts(std::uint32_t file) const {
    std::vector<std::uint32_t>& starts = line_starts_[file];
    if (!starts.empty()) return starts;
    const std::string& text = files_[file].text;
    starts.push_back(0);
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '\n' || (text[i] == '\r' && (i + 1 == text.size() || text[i + 1] != '\n')))
            starts.push_back(static_cast<std::uint32_t>(i + 1));
    }
    return starts;
}

Position Sources::position(std::uint32_t file, std::uint32_t offset) const {
    const auto& starts = line_starts(file);
    const auto after = std::upper_bound(starts.begin(), starts.end(), offset);
    const auto line = static_cast<std::uint32_t>(after - starts.begin());
    const std::uint32_t begin = starts[line - 1];
    const std::string& text = files_[file].text;
    const std::size_t end = std::min<std::size_t>(offset, text.size());
    std::size_t column = end - std::min<std::size_t>(begin, end);
    if (files_[file].utf8) column = character_count(std::string_view(text).substr(begin, column));
    return {line, static_cast<std::uint32_t>(column + 1)};
}

std::string_view Sources::line(std::uint32_t file, std::uint32_t number) const {
    const auto& starts = line_starts(file);
    if (number == 0 || number > starts.size()) return {};
    const std::string_view text = files_[file].text;
    const std::size_t begin = starts[number - 1];
    std::size_t end = number < starts.size() ? starts[number] : text.size();
    while (end > begin && (text[end - 1] == '\n' || text[end - 1] == '\r')) --end;
    return text.substr(begin, end - begin);
}

std::string Sources::line_utf8(const Span& span) const {
    const std::string_view raw = line(span.file, position(span).line);
    return files_[span.file].utf8 ? std::string(raw) : cp1252_to_utf8(raw);
}

std::string_view Sources::text(const Span& span) const {
    const std::string_view text = files_[span.file].text;
    const std::size_t begin = std::min<std::size_t>(span.begin, text.size());
    const std::size_t end = std::clamp<std::size_t>(span.end, begin, text.size());
    return text.substr(begin, end - begin);
}

std::optional<std::uint32_t> Sources::block_number(std::uint32_t file, std::uint32_t offset) const {
    const BlockNumbers style = files_[file].block_numbers;
    if (style == BlockNumbers::none) return std::nullopt;
    std::string_view rest = trim(line(file, position(file, offset).line));
    if (style == BlockNumbers::n_word) {
        if (!rest.empty() && rest.front() == '/') {  // skip level: `/`, `/3`
            rest.remove_prefix(1);
            if (!rest.empty() && is_digit(rest.front())) rest.remove_prefix(1);
            rest = trim(rest);
        }
        if (rest.size() < 2 || upper(rest.front()) != 'N') return std::nullopt;
        rest.remove_prefix(1);
    }
    std::uint32_t number = 0;
    std::size_t digits = 0;
    while (digits < rest.size() && digits < 9 && is_digit(rest[digits]))
        number = number * 10 + static_cast<std::uint32_t>(rest[digits++] - '0');
    if (digits == 0) return std::nullopt;
    return number;
}

}  // namespace obrys::base
