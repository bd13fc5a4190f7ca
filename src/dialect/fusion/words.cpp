#include "dialect/fusion/words.hpp"

#include <algorithm>

namespace obrys::dialect::fusion {

namespace {

constexpr std::array<std::string_view, 21> first_commands{
    "",
    "stop",
    "optional stop",
    "end",
    "spindle clockwise",
    "spindle counter-clockwise",
    "start spindle",
    "stop spindle",
    "orientate spindle",
    "load tool",
    "coolant on",
    "coolant off",
    "feed coupled to the spindle",
    "feed no longer coupled to the spindle",
    "lock axes",
    "unlock axes",
    "exact stop",
    "start chip transport",
    "stop chip transport",
    "open door",
    "close door",
};

constexpr std::array<std::string_view, 4> describing{"http://", "operation:", "movement:", "autodeskcam:"};
constexpr std::array<std::string_view, 4> known_alone{"kind", "leads-supported", "ncprogram-id",
                                                      "axisSubstitutionRadius"};

}  // namespace

std::string_view command_name(std::uint32_t number) {
    if (number < first_commands.size()) return first_commands[number];
    if (number == 29) return "power on";
    if (number == 30) return "power off";
    if (number == 38) return "probe on";
    if (number == 39) return "probe off";
    return {};
}

const Coolant* find_coolant(std::string_view name) {
    const auto found = std::find_if(coolants.begin(), coolants.end(), [&](const Coolant& c) { return c.name == name; });
    return found == coolants.end() ? nullptr : &*found;
}

bool describes(std::string_view parameter) {
    const auto begins = [&](std::string_view head) { return parameter.starts_with(head); };
    return std::any_of(describing.begin(), describing.end(), begins) ||
           std::find(known_alone.begin(), known_alone.end(), parameter) != known_alone.end();
}

}  // namespace obrys::dialect::fusion
