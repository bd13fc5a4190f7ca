#include "write/hooks.hpp"

#include <algorithm>

namespace obrys::write {

base::Span place_in(const HookText& text, std::size_t line, std::string_view near) {
    if (!text.verbatim) return text.where;
    std::size_t begin = 0;
    for (std::size_t n = 1; n < line; ++n) {
        const std::size_t end = text.text.find('\n', begin);
        if (end == std::string::npos) break;
        begin = end + 1;
    }
    std::size_t end = std::min(text.text.find('\n', begin), text.text.size());
    const std::size_t found = near.empty() ? std::string::npos : text.text.find(near, begin);
    if (found < end) {
        begin = found;
        end = std::min(end, found + near.size());
    } else {
        begin = std::min(text.text.find_first_not_of(" \t", begin), end);
    }
    const auto at = [&](std::size_t offset) { return text.where.begin + static_cast<std::uint32_t>(offset); };
    return {text.where.file, at(begin), at(end)};
}

}  // namespace obrys::write
