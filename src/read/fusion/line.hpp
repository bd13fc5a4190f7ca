#pragma once
/// One line of a listing: the record's byte, its name, its values. Private to read/fusion.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace obrys::read::fusion {

enum class TokenKind : std::uint8_t { number, text, word };
struct Token {
    TokenKind kind = TokenKind::word;
    std::string_view chars;  ///< of texts what stands between the quotes, as it stands there
    double value = 0;
    std::uint32_t begin = 0, end = 0;
};

struct Line {
    std::uint32_t begin = 0, end = 0;  ///< from the record's name on; without the line's end
    double byte = 0;                   ///< where the record begins in the file
    std::string_view name;
    std::vector<Token> tokens;  ///< behind the name

    /// Numbers from token `first` on, as many as are asked for; nothing where one is missing or not finite.
    [[nodiscard]] std::optional<std::vector<double>> numbers(std::size_t first, std::size_t count) const;
    /// The numbers behind the word.
    [[nodiscard]] std::optional<std::vector<double>> numbers(std::string_view word, std::size_t count) const;
    [[nodiscard]] std::optional<double> number(std::string_view word) const;
    [[nodiscard]] bool has(std::string_view word) const;
};

class LineScanner {
public:
    explicit LineScanner(std::string_view text) : text_(text) {}
    /// The next line that is not empty; false: there is none. A line that does not begin with a number and a word has
    /// an empty name.
    [[nodiscard]] bool next(Line& line);
    [[nodiscard]] std::uint32_t at() const { return static_cast<std::uint32_t>(at_); }

private:
    Token token(std::size_t& i, std::size_t end) const;

    std::string_view text_;
    std::size_t at_ = 0;
};

/// A quoted text as it was.
[[nodiscard]] std::string unquoted(std::string_view chars);

}  // namespace obrys::read::fusion
