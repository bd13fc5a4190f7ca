#pragma once
/// What the parts of the DIN/ISO reader share with each other only.

#include <vector>

#include "dialect/heidenhain/g_codes.hpp"
#include "read/heidenhain/state.hpp"

namespace obrys::read::heidenhain {

/// What stands in a block, found before it is read: the meaning of its letters depends on its G codes.
struct IsoBlock {
    std::vector<int> g;         ///< in order
    std::uint32_t letters = 0;  ///< bit 0: A; those that begin a word
    bool rapid = false;         ///< F MAX

    [[nodiscard]] bool has(char letter) const { return (letters >> (letter - 'A') & 1U) != 0; }
    [[nodiscard]] bool has_any(std::string_view any) const;
    [[nodiscard]] bool has_g(int number) const;
    /// The first G code that defines a cycle, or null.
    [[nodiscard]] const dialect::heidenhain::GCode* cycle() const;
};

/// The block from the scanner on; does not move.
[[nodiscard]] IsoBlock look_over(State& s);

/// One block, its number and its star included.
void read_iso_block(State& s);
/// Puts G90 or G91 that came behind the coordinates of the block before into a statement of its own.
void flush_pending(State& s);
/// G90, G91: `coordinates`: some were read in this block already; false where it acts from the next block on only.
void dimension(State& s, bool incremental, std::uint32_t begin, bool coordinates);

inline constexpr std::string_view pole_letters = "IJK";

enum class MotionFamily : std::uint8_t {
    unknown,
    straight,
    arc,
    tangential,
    polar_straight,
    polar_arc,
    polar_tangential
};
[[nodiscard]] MotionFamily family_of(int motion);
/// I J K and G29: the pole, from before the block's motion.
void read_pole(State& s);
/// The block behind G27.
void depart(State& s);
/// iso_words.cpp: positions, tool, spindle, feed, M functions.
void read_iso_words(State& s, const IsoBlock& b);
/// The number behind G, P, D or N at the scanner, which stands on the letter; -1 and a complaint where there is none.
[[nodiscard]] int read_code(State& s);
/// A word whose coordinate is absolute or incremental by itself; without `reference` the run knows what holds.
void coordinate_word(State& s, Code code, std::uint32_t begin, std::optional<program::Reference> reference);
void read_iso_cycle(State& s, const dialect::heidenhain::GCode& g);  ///< iso_cycle.cpp
void read_iso_function(State& s);                                    ///< iso_function.cpp: D00 … D37
/// P01, P02 …: moves behind it; false and a complaint where another word stands.
bool take_p(State& s, int number);

}  // namespace obrys::read::heidenhain
