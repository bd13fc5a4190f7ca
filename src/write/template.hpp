#pragma once
/// Templates of a post: blocks of words as the control wants them, with the places where values go.
///
/// A block is tokens with blanks between them:
///   G1            stands as it is; left out where it is one of a modal group of the post and in force already
///   X{x}          a word: the value where it is known; left out where it is absent, or where X is modal and has it
///   X{x!}         always, where the value is there
///   X{x~}         the same, and it does not count as the X in force
///   Z{depth*-1}   times a number; F{feed:whole} in another style of numbers
///   {return-level?G98|G99}   the first text where the value is there, else the second
///   {filter=3?1|0}           the same, where it has this number
///   {letter}{number}   a word whose letters come with it
///   $P[{number},{edge}]={length}   values among the letters, which do not say anything by themselves
///   ?             at the begin: the block is left out where none of its values is there
///   {comp} {feed} {corner} {axes} {length} {coolant}   what compensation, feed, corner, additional axes, the
///                 compensation of the tool's length and coolant have to say here; {feed!}: also what is in force

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "write/number_style.hpp"
#include "write/values.hpp"

namespace obrys::write {

/// Places in a template for what other templates print.
enum class Part : std::uint8_t { compensation, feed, corner, axes, length, coolant };
inline constexpr std::size_t part_count = static_cast<std::size_t>(Part::coolant) + 1;

struct Token {
    enum class Kind : std::uint8_t { literal, word, text, choice, part };
    /// A value among the letters of a word: the T of $TC_DP3[T,D]=.
    struct Index {
        std::string before;  ///< letters that stand before it
        ValueIndex value = 0;
        double factor = 1;
        std::size_t style = 0;
    };
    Kind kind = Kind::literal;
    std::string before, after;     ///< of a choice: both texts
    std::optional<Text> first;     ///< of a word: stands before `before`
    std::vector<Index> indices{};  ///< of a word: they stand before `before`
    ValueIndex value = 0;
    Text text = Text::name;
    Part part = Part::feed;
    double factor = 1;
    std::optional<double> equals{};  ///< of a choice: the first text where the value is this
    std::size_t style = 0;
    bool always = false;
    int slot = -1;    ///< where the word's last text is remembered; -1: it is not modal
    int spoils = -1;  ///< the slot of a word that holds another value behind this one: F of a thread; -1: none
    int group = -1;   ///< modal group of a literal; -1: none
    /// A word of which the number tells all: X{x}.
    [[nodiscard]] bool is_number_alone() const { return !first && indices.empty() && after.empty(); }
};

using Block = std::vector<Token>;
using Template = std::vector<Block>;

/// Whether a template prints the value, or asks whether it is there.
[[nodiscard]] bool says(const Template& text, ValueIndex value);
/// Whether it has a place for such a part.
[[nodiscard]] bool has_part(const Template& text, Part part);

/// What a move asks of its template, found once.
struct Places {
    Places() = default;
    explicit Places(const Template& text);
    [[nodiscard]] bool has(Part part) const { return parts_[static_cast<std::size_t>(part)]; }
    /// Whether it says X, Y, Z (0, 1, 2), or all of them by an angle.
    [[nodiscard]] bool says_axis(std::size_t axis) const { return axes_[axis]; }

private:
    std::array<bool, part_count> parts_{};
    std::array<bool, 3> axes_{};
};

/// What templates are read with.
struct Grammar {
    std::vector<std::string> style_names;          ///< of numbers, in the order of the post's styles
    std::vector<std::size_t> style_of;             ///< by Value: the style where the template names none
    std::vector<std::string> modal_words;          ///< letters that stay in force: "X"
    std::vector<std::vector<std::string>> groups;  ///< words of which one is in force
    bool in_cycle = false;
};

/// One block; an error as a sentence, and nothing, where it cannot be read.
[[nodiscard]] std::optional<Block> parse_block(std::string_view text, const Grammar& grammar, std::string& error);

}  // namespace obrys::write
