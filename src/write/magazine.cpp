#include "write/magazine.hpp"

#include <algorithm>

namespace obrys::write {

Magazine::Magazine(const MagazineForm& form)
    : form_(form), taken_(form.places + std::size_t{1}, false), next_offset_(form.first_offset) {
    slots_.reserve(form.places);
    for (const MagazineTool& tool : form.tools)
        if (tool.place != 0) taken_[tool.place] = true;  // kept for it
}

/// 0: none is free.
std::uint32_t Magazine::place_for(std::uint32_t number) {
    if (!form_.balanced) {
        const bool free = number >= 1 && number <= form_.places && !taken_[number];
        return free ? number : 0;
    }
    // The middle of the longest row of free places of the ring; the first one of several. An empty ring begins at 1.
    const std::uint32_t places = form_.places;
    if (std::none_of(taken_.begin(), taken_.end(), [](bool t) { return t; })) return places > 0 ? 1 : 0;
    std::uint32_t best = 0, longest = 0;
    for (std::uint32_t p = 1; p <= places; ++p) {
        if (!taken_[p]) continue;
        std::uint32_t row = 0;
        while (row < places && !taken_[(p + row) % places + 1]) ++row;
        if (row > longest) longest = row, best = (p + row / 2) % places + 1;
    }
    return best;
}

const MagazineSlot* Magazine::take(std::uint32_t number, std::string& why) {
    const auto there = std::find_if(slots_.begin(), slots_.end(), [&](const auto& s) { return s.number == number; });
    if (there != slots_.end()) return &*there;
    const auto own =
        std::find_if(form_.tools.begin(), form_.tools.end(), [&](const auto& t) { return t.number == number; });
    MagazineSlot slot;
    slot.number = number;
    slot.offsets = own != form_.tools.end() && own->offsets != 0 ? own->offsets : form_.offsets;
    slot.place = own != form_.tools.end() && own->place != 0 ? own->place : place_for(number);
    slot.offset = next_offset_;
    if (slot.place == 0) {
        why = "the magazine of " + std::to_string(form_.places) + " places has none for it";
        return nullptr;
    }
    if (slot.offset + slot.offsets - 1 > form_.last_offset) {
        why = "the offsets up to number " + std::to_string(form_.last_offset) + " belong to other tools";
        return nullptr;
    }
    next_offset_ += slot.offsets;
    taken_[slot.place] = true;
    slots_.push_back(slot);
    return &slots_.back();
}

std::string text_of(const std::vector<MagazineSlot>& slots) {
    std::string out;
    for (const MagazineSlot& s : slots) {
        out += "tool " + std::to_string(s.number) + ": place " + std::to_string(s.place) + ", offset";
        out += s.offsets == 1 ? " " + std::to_string(s.offset)
                              : "s " + std::to_string(s.offset) + " to " + std::to_string(s.offset + s.offsets - 1);
        out += "\n";
    }
    return out;
}

}  // namespace obrys::write
