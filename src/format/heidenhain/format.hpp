#pragma once
/// Formatter for HEIDENHAIN programs: Klartext (.H) and DIN/ISO (.I). Text in, text out; the program stays the same.
///
/// Blocks are numbered anew (Klartext 0, 1, 2 …; DIN/ISO N10, N20 …: only free contours refer to block numbers, and a
/// program in which one does keeps them), one blank stands between words, keywords are upper case, coordinates carry
/// their sign, blanks at line ends go. Comments, texts, names and paths stay as they are. formatted(formatted(p)) ==
/// formatted(p). Source of the looks: iTNC 530 User's Manual Conversational Programming (606 42x) and DIN/ISO
/// Programming, listings.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace obrys::format::heidenhain {

enum class Language : std::uint8_t { klartext, iso };
enum class Decimal : std::uint8_t { keep, point, comma };
enum class LineEnds : std::uint8_t { keep, lf, crlf };

struct Options {
    Decimal decimal = Decimal::keep;  ///< of values; numbers of cycles and blanks (7.1, 0.1) always have a point
    LineEnds line_ends = LineEnds::keep;
};

/// A block whose words stay byte for byte, because something in it is not understood; in a text without block numbers
/// no block gets one then, and lines of a cycle behind it stay, too.
struct Left {
    std::uint32_t line = 1;  ///< counted from 1
    std::string text;        ///< its first line, as written
};

struct Formatted {
    std::string text;
    std::vector<Left> left;
    bool numbers_kept = false;  ///< free contours refer to blocks by number (RX 13, PAR 17): the numbers stay
};

/// By content and suffix; nothing where the text is neither language (a .h file may be anything).
[[nodiscard]] std::optional<Language> language_of(std::string_view text, std::string_view file_name);

[[nodiscard]] Formatted formatted(std::string_view text, Language language, const Options& options = {});

}  // namespace obrys::format::heidenhain
