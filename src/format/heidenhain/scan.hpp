#pragma once
/// Reads the words of one line's code and writes them in the control's way. Private to the folder.

#include <cstddef>
#include <string>
#include <string_view>

#include "format/heidenhain/format.hpp"

namespace obrys::format::heidenhain {

enum class Sign : std::uint8_t { as_written, always };

class Scan {
public:
    Scan(std::string_view code, Decimal decimal) : code_(code), decimal_(decimal) {}

    void skip_blanks();
    /// Skips blanks; true where nothing is left.
    [[nodiscard]] bool at_end();
    [[nodiscard]] char peek(std::size_t k = 0) const;   ///< as written; '\0' behind the end
    [[nodiscard]] char upper(std::size_t k = 0) const;  ///< … in upper case
    [[nodiscard]] std::string_view rest() const { return code_.substr(at_); }
    [[nodiscard]] std::size_t at() const { return at_; }
    void go_to(std::size_t at) { at_ = at; }
    void step(std::size_t n = 1) { at_ += n; }
    /// The letters that stand here, upper case.
    [[nodiscard]] std::string letters() const;
    /// Takes a keyword in any case that no further letter follows, behind blanks or not.
    bool take_word(std::string_view upper);
    bool take(char c);

    // Each appends to `out` and returns true, or returns false with nothing moved.
    bool parameter(std::string& out);  ///< Q5 QL5 QR5 QS5
    bool number(std::string& out);     ///< unsigned, with point or comma and exponent
    bool value(std::string& out, Sign sign);
    bool text(std::string& out);  ///< "…" on one line

private:
    std::string_view code_;
    std::size_t at_ = 0;
    Decimal decimal_;
};

/// Appends a word, one blank before it unless it is the first.
void append_word(std::string& out, std::string_view word);
/// Runs of blanks outside texts become one blank; outside texts also upper case where asked for. Nothing where a text
/// is not closed or an apostrophe stands (a text to some readers, part of a name to others).
[[nodiscard]] std::optional<std::string> collapsed(std::string_view code, bool upper_case);
/// The decimal sign of every number outside texts.
[[nodiscard]] std::string with_decimals(std::string code, Decimal decimal);

}  // namespace obrys::format::heidenhain
