#pragma once
/// The block number in front of a line. Private to the folder.

#include <cstdint>
#include <string>
#include <string_view>

namespace obrys::format::heidenhain {

/// `12 L …`, `/12 L`, `12 /L`, `N10 G01`, `/N10`, `N10/`.
struct Numbered {
    bool skip_before = false, number = false, skip_behind = false;
    bool understood = true;   ///< false: digits that go on as something else (12.5)
    std::string_view digits;  ///< of the number
    std::string_view body;    ///< behind it, blanks in front gone
};
[[nodiscard]] Numbered split_number(std::string_view line, bool n_word);

/// Counts the blocks and writes their numbers.
class Counter {
public:
    Counter(std::string_view letter, std::uint64_t first, std::uint64_t step)
        : letter_(letter), first_(first), next_(first), step_(step) {}
    void restart() { next_ = first_; }
    /// From now on blocks keep the numbers they have, and get none where they have none.
    void keep() { kept_ = true; }
    /// The number's text with its skip signs, as it stands in front of the body.
    [[nodiscard]] std::string next(const Numbered& n);

private:
    std::string_view letter_;
    std::uint64_t first_, next_, step_;
    bool kept_ = false;
};

}  // namespace obrys::format::heidenhain
