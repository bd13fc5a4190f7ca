#pragma once
/// Where the tools of a program stand in the magazine, and which of the control's offsets are theirs. The table
/// [magazine] of a post.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace obrys::write {

/// What the post says of single tools.
struct MagazineTool {
    std::uint32_t number = 0;
    std::uint32_t place = 0;    ///< 0: where the balance puts it
    std::uint32_t offsets = 0;  ///< 0: as many as of the others
};
struct MagazineForm {
    std::uint32_t places = 0;
    bool balanced = true;       ///< tools are spread evenly; else each stands at the place of its number
    std::uint32_t offsets = 2;  ///< of each tool: one, two or four
    std::uint32_t first_offset = 1, last_offset = 99;
    std::vector<MagazineTool> tools;
};

/// A tool where it stands. Its first offset holds while it approaches the material, the second, where it has one, while
/// it goes into it.
struct MagazineSlot {
    std::uint32_t number = 0, place = 0, offset = 0, offsets = 0;
    [[nodiscard]] std::uint32_t approach() const { return offset; }
    [[nodiscard]] std::uint32_t entry() const { return offsets > 1 ? offset + 1 : offset; }
};

/// Gives the tools of a program their places and offsets in the order in which it calls them. However many it calls,
/// they are spread evenly: each one halves the widest gap that is left, as far as places are free.
class Magazine {
public:
    /// `form` outlives this.
    explicit Magazine(const MagazineForm& form);
    /// Nothing, and why, where the magazine or its offsets are full.
    [[nodiscard]] const MagazineSlot* take(std::uint32_t number, std::string& why);
    [[nodiscard]] const std::vector<MagazineSlot>& slots() const { return slots_; }

private:
    [[nodiscard]] std::uint32_t place_for(std::uint32_t number);

    const MagazineForm& form_;
    std::vector<bool> taken_;          ///< places, from 1
    std::vector<MagazineSlot> slots_;  ///< never more than places: they stay where they are
    std::uint32_t next_offset_;
};

/// The list of tools with their places and offsets, a line each; empty where there are none.
[[nodiscard]] std::string text_of(const std::vector<MagazineSlot>& slots);

}  // namespace obrys::write
