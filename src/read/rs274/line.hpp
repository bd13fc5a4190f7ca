#pragma once
/// One line of RS-274 text as the control sees it: without blanks, in upper case; comments as they stand. Every byte
/// knows where it came from.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/number.hpp"
#include "base/text.hpp"

namespace obrys::read::rs274 {

/// What is wrong with the comments of a line.
enum class CommentFault : std::uint8_t { none, unclosed, nested };

class Line {
public:
    /// Takes the bytes [begin, end) of `source`. `nested`: a comment may hold `(` that has its own `)`.
    /// `semicolon`: `;` begins a comment to the line's end, whose bytes stay as they are.
    void load(std::string_view source, std::uint32_t begin, std::uint32_t end, bool nested, bool semicolon);

    [[nodiscard]] CommentFault fault() const { return fault_; }
    [[nodiscard]] std::uint32_t fault_begin() const { return fault_begin_; }

    /// The byte `k` places ahead; NUL behind the line.
    [[nodiscard]] char peek(std::size_t k = 0) const { return at_ + k < text_.size() ? text_[at_ + k] : '\0'; }
    [[nodiscard]] bool at_end() const { return at_ >= text_.size(); }
    [[nodiscard]] std::string_view rest() const { return std::string_view(text_).substr(at_); }
    [[nodiscard]] std::size_t place() const { return at_; }
    void go(std::size_t place) { at_ = place; }
    void step(std::size_t n = 1) { at_ = std::min(at_ + n, text_.size()); }
    bool take(char c) {
        if (peek() != c || at_end()) return false;
        ++at_;
        return true;
    }
    bool take(std::string_view word) {
        if (!rest().starts_with(word)) return false;
        at_ += word.size();
        return true;
    }
    /// A number without sign at the place, which is not moved.
    [[nodiscard]] base::NumberScan scan_number() const {
        return base::is_digit(peek()) || peek() == '.' ? base::scan_decimal(rest()) : base::NumberScan{};
    }

    /// Source byte of a place, as the begin of a span; and of what stands in front of it, as its end.
    [[nodiscard]] std::uint32_t from(std::size_t place) const { return place < from_.size() ? from_[place] : end_; }
    [[nodiscard]] std::uint32_t to(std::size_t place) const {
        return place > 0 && place <= from_.size() ? from_[place - 1] + 1 : begin_;
    }
    [[nodiscard]] std::uint32_t here() const { return from(at_); }
    [[nodiscard]] std::uint32_t behind() const { return to(at_); }
    [[nodiscard]] std::uint32_t begin() const { return begin_; }  ///< the line's first byte that is no blank
    [[nodiscard]] std::uint32_t end() const { return end_; }

private:
    std::string text_;
    std::vector<std::uint32_t> from_;
    std::size_t at_ = 0;
    std::uint32_t begin_ = 0, end_ = 0, fault_begin_ = 0;
    CommentFault fault_ = CommentFault::none;
};

}  // namespace obrys::read::rs274
