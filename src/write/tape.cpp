#include "write/tape.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <optional>

#include "base/text.hpp"

namespace obrys::write {

namespace {

struct EiaRow {
    char character;
    std::uint8_t row;
};
/// EIA RS-244-A. The end of a block (CR) is track 8 alone, % the end of record (stop of the rewinding tape).
constexpr std::array eia_rows{
    // sizes: table
    EiaRow{'0', 0x20}, EiaRow{'1', 0x01},  EiaRow{'2', 0x02}, EiaRow{'3', 0x13},  EiaRow{'4', 0x04}, EiaRow{'5', 0x15},
    EiaRow{'6', 0x16}, EiaRow{'7', 0x07},  EiaRow{'8', 0x08}, EiaRow{'9', 0x19},  EiaRow{'A', 0x61}, EiaRow{'B', 0x62},
    EiaRow{'C', 0x73}, EiaRow{'D', 0x64},  EiaRow{'E', 0x75}, EiaRow{'F', 0x76},  EiaRow{'G', 0x67}, EiaRow{'H', 0x68},
    EiaRow{'I', 0x79}, EiaRow{'J', 0x51},  EiaRow{'K', 0x52}, EiaRow{'L', 0x43},  EiaRow{'M', 0x54}, EiaRow{'N', 0x45},
    EiaRow{'O', 0x46}, EiaRow{'P', 0x57},  EiaRow{'Q', 0x58}, EiaRow{'R', 0x49},  EiaRow{'S', 0x32}, EiaRow{'T', 0x23},
    EiaRow{'U', 0x34}, EiaRow{'V', 0x25},  EiaRow{'W', 0x26}, EiaRow{'X', 0x37},  EiaRow{'Y', 0x38}, EiaRow{'Z', 0x29},
    EiaRow{' ', 0x10}, EiaRow{'\t', 0x3E}, EiaRow{'%', 0x0B}, EiaRow{'&', 0x0E},  EiaRow{'+', 0x70}, EiaRow{'-', 0x40},
    EiaRow{'/', 0x31}, EiaRow{',', 0x3B},  EiaRow{'.', 0x6B}, EiaRow{'\n', 0x80},
};

std::optional<std::uint8_t> row_of(char c, Tape tape) {
    const auto code = static_cast<std::uint8_t>(c);
    if (tape == Tape::none) return code;
    if (tape == Tape::iso) {
        constexpr std::uint8_t parity = 0x80, highest = 0x7E;
        const bool known = c == '\n' || c == '\r' || c == '\t' || (code >= ' ' && code <= highest);
        if (!known) return std::nullopt;
        return static_cast<std::uint8_t>(std::popcount(code) % 2 == 0 ? code : code | parity);
    }
    const char letter = base::upper(c);  // it has no small ones
    const auto found =
        std::find_if(eia_rows.begin(), eia_rows.end(), [&](const EiaRow& r) { return r.character == letter; });
    if (found == eia_rows.end()) return std::nullopt;
    return found->row;
}

/// Bytes of the character of UTF-8 that begins there.
std::size_t length_of(std::string_view text, std::size_t at) {
    constexpr unsigned marks = 0xC0, goes_on = 0x80;
    std::size_t length = 1;
    while (at + length < text.size() && (static_cast<unsigned char>(text[at + length]) & marks) == goes_on) ++length;
    return length;
}

/// The carriage return before a line feed is a part of the end of block.
bool is_silent(std::string_view text, std::size_t at, Tape tape) {
    return tape == Tape::eia && text[at] == '\r' && at + 1 < text.size() && text[at + 1] == '\n';
}

}  // namespace

std::string_view name_of(Tape tape) { return tape == Tape::iso ? "ISO" : tape == Tape::eia ? "EIA" : "no"; }

std::string punched(std::string_view text, Tape tape) {
    std::string rows;
    rows.reserve(text.size());
    for (std::size_t i = 0; i < text.size(); ++i)
        if (const auto row = row_of(text[i], tape); row && !is_silent(text, i, tape))
            rows.push_back(static_cast<char>(*row));
    return rows;
}

std::vector<MissingCharacter> missing_characters(std::string_view text, Tape tape) {
    std::vector<MissingCharacter> missing;
    std::uint64_t line = 1;
    for (std::size_t i = 0; i < text.size();) {
        const std::size_t length = length_of(text, i);
        const std::string_view character = text.substr(i, length);
        const bool there = is_silent(text, i, tape) || (length == 1 && row_of(text[i], tape));
        const bool said = std::any_of(missing.begin(), missing.end(), [&](const MissingCharacter& m) {
            return m.character == base::as_utf8(character);
        });
        if (!there && !said && tape != Tape::none) missing.push_back({base::as_utf8(character), line});
        if (text[i] == '\n') ++line;
        i += length;
    }
    return missing;
}

}  // namespace obrys::write
