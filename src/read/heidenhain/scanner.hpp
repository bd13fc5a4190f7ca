#pragma once
/// Moves over Klartext block by block: a block ends with its line, unless `~` stands at the line's end. In DIN/ISO `*`
/// ends a block, too.

#include <cstdint>
#include <string_view>

#include "base/number.hpp"
#include "base/text.hpp"

namespace obrys::read::heidenhain {

class Scanner {
public:
    Scanner() = default;
    /// A NUL must stand behind the text. `star_ends`: DIN/ISO, where `*` ends a block when nothing or the next block's
    /// number follows in its line; else it multiplies.
    explicit Scanner(std::string_view text, bool star_ends = false);

    /// Byte of the text at which the scanner stands.
    [[nodiscard]] std::uint32_t at() const { return static_cast<std::uint32_t>(p_ - base_); }
    void go_to(std::uint32_t byte) { p_ = base_ + byte; }
    [[nodiscard]] std::string_view between(std::uint32_t from, std::uint32_t to) const {
        return {base_ + from, to - from};
    }

    /// Moves to the next line that holds something; false at the text's end.
    bool next_line();
    /// Blanks, and the line's end behind `~`.
    void skip_blanks();
    /// Skips blanks; true at the end of the block. Comments are taken with it; a comment may end with `~`.
    bool at_end();
    /// To the end of the block, whatever is in it; in DIN/ISO the scanner stands on its star or comment then.
    void skip_block();
    /// DIN/ISO: behind the end of the block, where the next one may stand in the same line.
    void leave_block();
    /// As above for a block that is a comment from here on: lines behind `~` are comment, too.
    void skip_comment();
    /// A star stands here that ends the block.
    [[nodiscard]] bool at_star() const;
    /// To the end of the line, whatever is in it; the text that was there.
    std::string_view rest_of_line();

    /// The text from here on; it ends with a NUL that is not part of it.
    [[nodiscard]] const char* here() const { return p_; }
    [[nodiscard]] const char* text_end() const { return end_; }
    /// What stands here, without moving; '\0' at the text's end.
    [[nodiscard]] char peek(std::ptrdiff_t k = 0) const { return end_ - p_ > k ? p_[k] : '\0'; }
    void step(std::size_t n = 1) { p_ += n; }
    /// Takes `c`, behind blanks or not.
    bool take(char c);
    /// Takes a keyword in any case that no further letter follows, behind blanks or not.
    bool take_word(std::string_view upper);
    /// As above; what follows may be a letter, too.
    bool take_prefix(std::string_view upper);
    /// The letters that stand here.
    [[nodiscard]] std::string_view letters() const;
    /// The text up to the next blank, comment or end of the block.
    std::string_view token();
    /// As above, up to a star, too: the name of a program.
    std::string_view path();
    /// Digits alone, as numbers of labels and words have them; -1 where there are none or too many. Moves behind them.
    int integer();
    /// Unsigned number with decimal point or comma, exponent allowed; length 0 where there is none, infinite where it
    /// is too large for a double. Moves behind it.
    base::NumberScan number();
    /// The comment at the end of the block at hand, where it has one; the scanner stands on its `;`.
    [[nodiscard]] std::string_view comment() const;

private:
    [[nodiscard]] const char* line_end(const char* from) const;

    const char* base_ = nullptr;
    const char* p_ = nullptr;
    const char* end_ = nullptr;
    bool cr_alone_ = false;
    bool star_ends_ = false;
};

}  // namespace obrys::read::heidenhain
