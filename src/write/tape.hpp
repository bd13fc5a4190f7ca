#pragma once
/// Codes of punched tape. A byte is a row of holes: its lowest bit is track 1, its highest track 8.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace obrys::write {

enum class Tape : std::uint8_t {
    none,
    iso,  ///< ISO 840: seven bits and a hole in track 8 that makes their number even
    eia   ///< EIA RS-244: an odd number of holes by track 5; small letters are the capitals, no brackets
};
[[nodiscard]] std::string_view name_of(Tape tape);

/// The rows of a text; characters that the code has not are left out. Line ends of two characters are one row in EIA.
[[nodiscard]] std::string punched(std::string_view text, Tape tape);

/// A character that the code has not, and the first line with it, counted from 1.
struct MissingCharacter {
    std::string character;
    std::uint64_t line = 0;
};
[[nodiscard]] std::vector<MissingCharacter> missing_characters(std::string_view text, Tape tape);

}  // namespace obrys::write
