#include "base/text.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace obrys::base {

std::string to_upper(std::string_view s) {
    std::string out(s);
    std::transform(out.begin(), out.end(), out.begin(), upper);
    return out;
}

bool equals_ignoring_case(std::string_view a, std::string_view b) {
    return a.size() == b.size() &&
           std::equal(a.begin(), a.end(), b.begin(), [](char x, char y) { return upper(x) == upper(y); });
}

std::string_view trim(std::string_view s) {
    const auto outside = [](char c) { return is_blank(c) || c == '\r' || c == '\n'; };
    while (!s.empty() && outside(s.front())) s.remove_prefix(1);
    while (!s.empty() && outside(s.back())) s.remove_suffix(1);
    return s;
}

namespace {

/// Length of the UTF-8 sequence at `s[i]`, 0 where it is not valid.
std::size_t utf8_length(std::string_view s, std::size_t i) {
    const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(s[k]); };
    const unsigned char first = byte(i);
    if (first < 0x80) return 1;
    const std::size_t n = first >= 0xC2 && first < 0xE0   ? 2
                          : first >= 0xE0 && first < 0xF0 ? 3
                          : first >= 0xF0 && first < 0xF5 ? 4
                                                          : 0;
    if (n == 0 || i + n > s.size()) return 0;
    for (std::size_t k = 1; k < n; ++k)
        if ((byte(i + k) & 0xC0) != 0x80) return 0;
    if (first == 0xE0 && byte(i + 1) < 0xA0) return 0;  // overlong
    if (first == 0xED && byte(i + 1) > 0x9F) return 0;  // surrogate
    if (first == 0xF0 && byte(i + 1) < 0x90) return 0;  // overlong
    if (first == 0xF4 && byte(i + 1) > 0x8F) return 0;  // past U+10FFFF
    return n;
}

/// CP1252 bytes 0x80 to 0x9F; 0xFFFD where the code page leaves a hole. Source: Unicode mapping table CP1252.TXT.
constexpr std::array<char32_t, 32> cp1252_high{0x20AC, 0xFFFD, 0x201A, 0x0192, 0x201E, 0x2026, 0x2020, 0x2021,
                                               0x02C6, 0x2030, 0x0160, 0x2039, 0x0152, 0xFFFD, 0x017D, 0xFFFD,
                                               0xFFFD, 0x2018, 0x2019, 0x201C, 0x201D, 0x2022, 0x2013, 0x2014,
                                               0x02DC, 0x2122, 0x0161, 0x203A, 0x0153, 0xFFFD, 0x017E, 0x0178};

void append_utf8(std::string& out, char32_t c) {
    if (c < 0x80) {
        out += static_cast<char>(c);
    } else if (c < 0x800) {
        out += static_cast<char>(0xC0 | (c >> 6));
        out += static_cast<char>(0x80 | (c & 0x3F));
    } else {
        out += static_cast<char>(0xE0 | (c >> 12));
        out += static_cast<char>(0x80 | ((c >> 6) & 0x3F));
        out += static_cast<char>(0x80 | (c & 0x3F));
    }
}

/// None of so many bytes, a multiple of eight, is above 127.
template <std::size_t count>
bool is_ascii(const char* bytes) {
    std::uint64_t words[count / sizeof(std::uint64_t)], any = 0;
    std::memcpy(words, bytes, sizeof words);
    for (const std::uint64_t w : words) any |= w;
    return (any & 0x8080808080808080u) == 0;
}

}  // namespace

bool is_utf8(std::string_view s) {
    for (std::size_t i = 0; i < s.size();) {
        constexpr std::size_t many = 64, few = 8;  // programs are ASCII but for comments
        if (i + many <= s.size() && is_ascii<many>(s.data() + i)) {
            i += many;
            continue;
        }
        if (i + few <= s.size() && is_ascii<few>(s.data() + i)) {
            i += few;
            continue;
        }
        const std::size_t n = utf8_length(s, i);
        if (n == 0) return false;
        i += n;
    }
    return true;
}

std::string cp1252_to_utf8(std::string_view s) {
    std::string out;
    out.reserve(s.size() + s.size() / 8);
    for (const char c : s) {
        const auto byte = static_cast<unsigned char>(c);
        append_utf8(out, byte >= 0x80 && byte < 0xA0 ? cp1252_high[byte - 0x80u] : char32_t{byte});
    }
    return out;
}

std::string utf8_to_cp1252(std::string_view s, char instead) {
    std::string out;
    for (std::size_t i = 0; i < s.size();) {
        const std::size_t n = std::max<std::size_t>(1, utf8_length(s, i));
        const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(s[i + k]); };
        const char32_t c = n == 1   ? char32_t{byte(0)}
                           : n == 2 ? ((byte(0) & 0x1Fu) << 6) | (byte(1) & 0x3Fu)
                           : n == 3 ? ((byte(0) & 0x0Fu) << 12) | ((byte(1) & 0x3Fu) << 6) | (byte(2) & 0x3Fu)
                                    : char32_t{0xFFFD};  // beyond what the code page has
        const auto high = std::find(cp1252_high.begin(), cp1252_high.end(), c);
        if (c < 0x80 || (c >= 0xA0 && c <= 0xFF))
            out += static_cast<char>(static_cast<unsigned char>(c));
        else if (c != 0xFFFD && high != cp1252_high.end())
            out += static_cast<char>(0x80 + (high - cp1252_high.begin()));
        else
            out += instead;
        i += n;
    }
    return out;
}

void cut_utf8(std::string& s, std::size_t most) {
    if (most == 0 || s.size() <= most) return;
    while (most > 0 && (static_cast<unsigned char>(s[most]) & 0xC0) == 0x80) --most;
    s.resize(most);
}

std::string as_utf8(std::string_view s) { return is_utf8(s) ? std::string(s) : cp1252_to_utf8(s); }

std::size_t character_count(std::string_view s) {
    if (!is_utf8(s)) return s.size();
    return static_cast<std::size_t>(
        std::count_if(s.begin(), s.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

std::string csv_field(std::string_view s) {
    if (s.find_first_of(",\"\n\r") == std::string_view::npos) return std::string(s);
    std::string out = "\"";
    for (const char c : s) out += c == '"' ? std::string("\"\"") : std::string(1, c);
    return out + "\"";
}

std::string_view without_end_signs(std::string_view text) {
    std::size_t end = text.size();
    for (std::size_t i = text.size(); i > 0; --i) {
        const char c = text[i - 1];
        if (c == '\x1A' || c == '\0' || c == '\x03' || c == '\x04')
            end = i - 1;
        else if (!is_blank(c) && c != '\r' && c != '\n')
            break;
    }
    return text.substr(0, end);
}

bool looks_binary(std::string_view s) {
    const auto odd = [](char c) {
        const auto byte = static_cast<unsigned char>(c);
        return byte < 0x20 && c != '\t' && c != '\n' && c != '\r' && c != '\f' && c != '\x1A';
    };
    const std::string_view head = s.substr(0, telling_bytes);
    const auto odds = static_cast<std::size_t>(std::count_if(head.begin(), head.end(), odd));
    return head.find('\0') != std::string_view::npos || odds * 100 > head.size();
}

std::string_view stem(std::string_view path) {
    if (const std::size_t slash = path.find_last_of("/\\"); slash != std::string_view::npos)
        path.remove_prefix(slash + 1);
    if (const std::size_t dot = path.rfind('.'); dot != std::string_view::npos && dot > 0) path = path.substr(0, dot);
    return path;
}

}  // namespace obrys::base
