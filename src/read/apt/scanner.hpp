#pragma once
/// Lines of APT text as statements: comments off, continued lines joined, words and numbers with their places.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/number.hpp"

namespace obrys::read::apt {

enum class TokenKind : std::uint8_t { word, number, text, slash, comma, open, close, equals, other };

struct Token {
    TokenKind kind = TokenKind::other;
    std::uint32_t begin = 0, end = 0;  ///< bytes of the source
    base::NumberScan number{};
    std::string_view chars{};  ///< as written; of a text without its quotes
};

/// One statement. Blanks mean nothing outside of texts.
struct Line {
    /// Words, numbers and signs that it may have: a hundred times what the longest need (tables of points).
    static constexpr std::size_t most_tokens = std::size_t{1} << 16;

    std::uint32_t begin = 0, end = 0;
    std::vector<Token> tokens;
    std::string_view comment{};  ///< what stands behind `$$`, without it
    bool unended = false;        ///< the text ends behind a `$` that wants a further line
    bool too_long = false;       ///< it has more than may be; those have been passed by
};

class Scanner {
public:
    /// `text` must outlive it.
    explicit Scanner(std::string_view text);

    /// The next statement or comment; false at the end of the text.
    [[nodiscard]] bool next(Line& line);
    [[nodiscard]] std::uint32_t at() const { return at_; }
    /// The words of the statement as they stand, from this byte on to the line's end (of PPRINT and its like).
    [[nodiscard]] std::string_view rest_of_line(std::uint32_t from) const;

private:
    [[nodiscard]] std::uint32_t line_end(std::uint32_t from) const;
    /// The part of the line up to what is no part of the statement: columns 73 to 80, blanks.
    [[nodiscard]] std::uint32_t body_end(std::uint32_t from) const;
    /// Tokens of a line; true where a `$` says that the next one goes on with it.
    bool scan(Line& line, std::uint32_t from, std::uint32_t to);
    /// Numbers of Creo's `$$-> CSYS / …, $` go on in the next lines.
    void go_on_with_comment(Line& line);
    std::uint32_t scan_number_or_word(Line& line, std::uint32_t from, std::uint32_t to) const;

    std::string_view text_;
    std::uint32_t at_ = 0;
    bool numbered_ = false;  ///< columns 73 to 80 hold numbers of cards
};

/// Cards of 80 columns whose last eight number them.
[[nodiscard]] bool has_card_numbers(std::string_view text);

}  // namespace obrys::read::apt
