#include "write/values.hpp"

#include <algorithm>

namespace obrys::write {

namespace {

// clang-format off
constexpr std::array<std::string_view, static_cast<std::size_t>(Value::count)> names{  // sizes: table
    "x", "y", "z", "i", "j", "k", "cx", "cy", "cz", "via-x", "via-y", "via-z", "radius", "sweep", "turns", "more-turns", "axis", "pitch",
    "pitch-x", "pitch-y", "pitch-z", "pitch-change", "start", "size", "own-feed", "length", "tool-radius",
    "handle-i", "handle-j", "handle-k", "handle-p", "handle-q", "handle-r",
    "first-x", "first-y", "first-z", "second-x", "second-y", "second-z", "third-x", "third-y", "third-z", "k1-x", "k1-y", "k1-z", "k2-x",
    "k2-y", "k2-z", "k3-x", "k3-y", "k3-z", "lead-x", "lead-y", "lead-z", "hole-top", "hole-way", "hole-gap", "hole-end", "speed-back", "feed", "speed", "limit", "held",
    "number", "value", "edge", "turret", "raised", "wider", "offset", "own-diameter", "nose", "place", "approach", "entry",
    "around", "sharp", "way", "merge",
    "contour", "rotary", "purpose", "purpose-angle", "filter", "seconds", "revolutions", "machine-x", "machine-y", "machine-z", "shift-x",
    "shift-y", "shift-z", "angle", "angle-x", "angle-y", "angle-z", "euler-1", "euler-2", "euler-3", "side", "turn-side", "table-turns", "distance", "factor-x", "factor-y", "factor-z",
    "mirror-x", "mirror-y", "mirror-z", "block", "passes"};
// clang-format on
constexpr std::array<std::string_view, static_cast<std::size_t>(Text::count)> texts{"name", "text", "letter"};

}  // namespace

std::string_view name_of(Value v) { return names[static_cast<std::size_t>(v)]; }

std::optional<ValueIndex> value_named(std::string_view name, bool in_cycle) {
    if (in_cycle)
        if (const auto role = cl::cycle_role_spelt(name)) return index_of(*role);
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) return std::nullopt;
    return static_cast<ValueIndex>(found - names.begin());
}

std::optional<Text> text_named(std::string_view name) {
    const auto found = std::find(texts.begin(), texts.end(), name);
    if (found == texts.end()) return std::nullopt;
    return static_cast<Text>(found - texts.begin());
}

}  // namespace obrys::write
