/// M functions. Sources: FANUC series 16i operator's manual, auxiliary function; Haas mill operator's manual 96-8000, M
/// codes. All others belong to the machine's builder.

#include <algorithm>
#include <array>

#include "dialect/rs274/fanuc.hpp"

namespace obrys::dialect::rs274 {

using enum FanucMUse;

namespace {

constexpr std::array common{
    FanucM{0, function, {}},
    FanucM{1, function, {}},
    FanucM{2, function, {}},
    FanucM{3, function, {}},
    FanucM{4, function, {}},
    FanucM{5, function, {}},
    FanucM{6, function, {}},
    FanucM{7, function, {}},
    FanucM{8, function, {}},
    FanucM{9, function, {}},
    FanucM{10, accepted, "clamp"},
    FanucM{11, accepted, "unclamp"},
    FanucM{19, function, {}},  // spindle orientation: it stands
    FanucM{29, accepted, "rigid tapping"},
    FanucM{30, function, {}},
    FanucM{98, call, {}},
    FanucM{99, return_, {}},
};

constexpr std::array haas{
    FanucM{12, accepted, "rotary brake"},
    FanucM{13, accepted, "rotary brake"},
    FanucM{16, function, {}},  // tool change, as M6
    FanucM{17, accepted, "pallet unclamp"},
    FanucM{18, accepted, "pallet clamp"},
    FanucM{21, accepted, "optional user function"},
    FanucM{22, accepted, "optional user function"},
    FanucM{23, accepted, "optional user function"},
    FanucM{24, accepted, "optional user function"},
    FanucM{25, accepted, "optional user function"},
    FanucM{26, accepted, "optional user function"},
    FanucM{27, accepted, "optional user function"},
    FanucM{28, accepted, "optional user function"},
    FanucM{31, accepted, "chip conveyor"},
    FanucM{32, accepted, "chip conveyor"},
    FanucM{33, accepted, "chip conveyor off"},
    FanucM{34, accepted, "coolant spigot"},
    FanucM{35, accepted, "coolant spigot"},
    FanucM{36, accepted, "pallet rotation"},
    FanucM{39, accepted, "tool turret"},
    FanucM{41, accepted, "low gear"},
    FanucM{42, accepted, "high gear"},
    FanucM{46, refused, "jump when a pallet is loaded"},
    FanucM{48, accepted, "check of the program"},
    FanucM{49, accepted, "pallet status"},
    FanucM{50, refused, "pallet change"},
    FanucM{59, accepted, "output relay on"},
    FanucM{69, accepted, "output relay off"},
    FanucM{73, accepted, "tool air blast"},
    FanucM{74, accepted, "tool air blast off"},
    FanucM{75, refused, "reference point of a measurement"},
    FanucM{76, accepted, "display off"},
    FanucM{77, accepted, "display on"},
    FanucM{78, refused, "alarm where the skip signal comes"},
    FanucM{79, refused, "alarm where the skip signal does not come"},
    FanucM{80, accepted, "automatic door"},
    FanucM{81, accepted, "automatic door"},
    FanucM{82, accepted, "tool unclamp"},
    FanucM{83, accepted, "air gun"},
    FanucM{84, accepted, "air gun off"},
    FanucM{86, accepted, "tool clamp"},
    FanucM{88, accepted, "coolant through the spindle"},
    FanucM{89, accepted, "coolant through the spindle off"},
    FanucM{95, accepted, "sleep"},
    FanucM{96, refused, "jump where an input is off"},
    FanucM{97, local_call, {}},
    FanucM{104, accepted, "probe arm"},
    FanucM{105, accepted, "probe arm"},
    FanucM{109, refused, "input by the operator"},
};

constexpr bool is_accepted(const FanucM& m) { return m.use == accepted; }
template <std::size_t n>
constexpr std::array<std::int16_t, n> accepted_of(bool with_haas) {
    std::array<std::int16_t, n> out{};
    std::size_t at = 0;
    for (const FanucM& m : common)
        if (is_accepted(m)) out[at++] = m.code;
    for (const FanucM& m : haas)
        if (with_haas && is_accepted(m)) out[at++] = m.code;
    return out;
}
constexpr std::size_t in_common = std::count_if(common.begin(), common.end(), is_accepted);
constexpr std::size_t in_haas = std::count_if(haas.begin(), haas.end(), is_accepted);
constexpr auto fanuc_accepted = accepted_of<in_common>(false);
constexpr auto haas_accepted = accepted_of<in_common + in_haas>(true);

}  // namespace

std::span<const std::int16_t> accepted_fanuc_m(bool with_haas) {
    return with_haas ? std::span<const std::int16_t>(haas_accepted) : fanuc_accepted;
}

FanucM find_fanuc_m(int code, const FanucControl& control) {
    for (const FanucM& m : common)
        if (m.code == code) return m;
    if (control.haas)
        for (const FanucM& m : haas)
            if (m.code == code) return m;
    return {static_cast<std::int16_t>(code), unknown, {}};
}

}  // namespace obrys::dialect::rs274
