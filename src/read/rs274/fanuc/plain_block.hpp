#pragma once
/// Blocks that hold nothing but G0 … G3 and numbers with a decimal point, which long programs are made of. What such a
/// block means depends on its letters and on the modes in force, not on its numbers: the full reader reads the first
/// one of a kind, the others are read as that one was.

#include <array>
#include <cstdint>
#include <string_view>

#include "program/modes.hpp"
#include "program/word.hpp"

namespace obrys::read::rs274 {

struct FanucState;

/// A block's words as they stand in the text, before anybody knows what they mean.
struct PlainBlock {
    static constexpr std::size_t most_words = 12;
    struct Number {
        std::int32_t mantissa = 0;
        std::uint32_t decimals = 0;
        std::uint32_t begin = 0, length = 0;  ///< of the word, from the block's begin
    };
    std::uint64_t letters = 0;  ///< five bits a word, in their order
    std::uint32_t count = 0;
    std::array<Number, most_words> numbers{};
    std::uint32_t begin = 0, end = 0;  ///< of the block, without blanks around it
    bool numbered = false;             ///< N
    std::uint32_t number = 0;
};

/// What the full reader has made of blocks with these letters in this state.
class PlainBlocks {
public:
    /// What it told the program about itself is another one's from here on.
    void begin_program() { kinds_ = {}; }
    /// Adds the block to the tree as its like was read; false where none was.
    [[nodiscard]] bool add(FanucState& s, const PlainBlock& block) const;
    /// What holds, and what there is.
    struct Before {
        program::Modes modes{};
        std::size_t statements = 0, words = 0, exprs = 0, diagnostics = 0, lengths_with_point = 0;
    };
    [[nodiscard]] static Before before(const FanucState& s);
    /// The full reader has just read the block.
    void learn(const FanucState& s, const PlainBlock& block, const Before& before);

private:
    struct Kind {
        std::uint64_t letters = 0;  ///< 0: none yet
        program::Modes before{}, after{};
        std::uint32_t use = 0;  ///< in ModeTable::uses
        bool has_use = false, changes = false;
        std::size_t lengths_with_point = 0;
        std::array<program::Word, PlainBlock::most_words> words{};  ///< in the tree's order, without their numbers
        std::array<std::uint8_t, PlainBlock::most_words> from{};    ///< in PlainBlock::numbers
    };
    static constexpr std::size_t kinds = 64;
    [[nodiscard]] static std::size_t place_of(std::uint64_t letters);
    std::array<Kind, kinds> kinds_{};
};

/// The block that begins at `begin` of the text; false where it holds anything else. `end`: behind what may be read.
[[nodiscard]] bool scan_plain_block(std::string_view text, std::size_t begin, std::size_t end, bool lathe,
                                    PlainBlock& block);

}  // namespace obrys::read::rs274
