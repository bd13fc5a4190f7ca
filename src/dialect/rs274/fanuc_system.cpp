/// Arguments of macro calls and system variables. Sources: FANUC series 16i operator's manual B-63684EN, 16.2 and 16.7
/// (argument specification I and II, page 278); Haas mill operator's manual 96-8000, pages 93 to 113 (macro variables).

#include <algorithm>
#include <array>

#include "dialect/rs274/fanuc.hpp"

namespace obrys::dialect::rs274 {

int argument_parameter(char letter) {
    //                                  A  B  C  D  E  F  G  H   I  J  K  L  M   N  O  P  Q   R   S   T   U   V   W   X
    constexpr std::array<int, 26> table{1, 2, 3, 7,  8,  9,  0,  11, 4,  5,  6,  0,  13,
                                        0, 0, 0, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26};
    return letter < 'A' || letter > 'Z' ? 0 : table[static_cast<std::size_t>(letter - 'A')];
}

int argument_parameter(char letter, int n) {
    if (letter < 'I' || letter > 'K' || n < 1 || n > 10) return 0;
    return 4 + (n - 1) * 3 + (letter - 'I');
}

namespace {

using enum FanucSystem;

struct Range {
    std::uint32_t first = 0, last = 0;
    FanucSystem system = storage;
};

/// Ordinary parameters where no range says otherwise. Work offsets (#5201 … #5328, #7001 …) are parameters that the
/// run reads and writes; tool offsets are unknown to the program unless the job has the tools.
constexpr std::array ranges{
    Range{1000, 1199, unknown},  // signals between control and machine
    Range{2000, 2999, unknown},  // tool offsets
    Range{3000, 3000, alarm},    Range{3001, 3002, timer},   Range{3003, 3005, option},
    Range{3006, 3006, stop},     Range{3007, 3007, unknown},  // mirror image
    Range{3008, 3010, option},   Range{3011, 3012, unknown},  // date and time
    Range{3013, 3028, timer},                                 // timers of the machine
    Range{3030, 3033, option},   Range{3201, 3399, unknown}, Range{3901, 3902, unknown},
    Range{4000, 4999, unknown},  // modal information: those known are in the table below
    Range{5001, 5009, position}, Range{5021, 5029, machine}, Range{5041, 5049, position},
    Range{5061, 5069, probed},   Range{5081, 5149, unknown},  // tool offset in force, servo deviation
    Range{8000, 19999, unknown},                              // tool data and others of newer series
};

struct Modal {
    std::uint32_t number = 0;
    FanucSystem system = unknown;
    int index = 0;
};
constexpr int at(FanucGroup g) { return static_cast<int>(g); }

/// Groups are numbered differently on mills and lathes.
constexpr std::array mill{
    Modal{4001, group, at(FanucGroup::motion)},
    Modal{4002, group, at(FanucGroup::plane)},
    Modal{4003, group, at(FanucGroup::distance)},
    Modal{4005, group, at(FanucGroup::feed_mode)},
    Modal{4006, group, at(FanucGroup::units)},
    Modal{4007, group, at(FanucGroup::compensation)},
    Modal{4013, group, at(FanucGroup::surface_speed)},
    Modal{4014, group, at(FanucGroup::datum)},
    Modal{4109, feed, 0},
    Modal{4119, speed, 0},
    Modal{4120, tool, 0},
};
constexpr std::array lathe{
    Modal{4001, group, at(FanucGroup::motion)},
    Modal{4002, group, at(FanucGroup::surface_speed)},
    Modal{4003, group, at(FanucGroup::distance)},
    Modal{4005, group, at(FanucGroup::feed_mode)},
    Modal{4006, group, at(FanucGroup::units)},
    Modal{4007, group, at(FanucGroup::compensation)},
    Modal{4014, group, at(FanucGroup::datum)},
    Modal{4016, group, at(FanucGroup::plane)},
    Modal{4109, feed, 0},
    Modal{4119, speed, 0},
    Modal{4120, tool, 0},
};

/// Axis of the control's n-th coordinate, 1 X … 9 W: mills X Y Z A B C U V W, lathes X Z and then C, Y.
int axis_number(std::uint32_t n, const FanucControl& control) {
    constexpr std::array<int, 4> turning{1, 3, 6, 2};
    if (!control.is_lathe()) return static_cast<int>(n);
    return n <= turning.size() ? turning[n - 1] : 0;
}

}  // namespace

FanucVariable system_variable(std::uint32_t number, const FanucControl& control) {
    const std::span<const Modal> modal =
        control.is_lathe() ? std::span<const Modal>(lathe) : std::span<const Modal>(mill);
    for (const Modal& m : modal)
        if (m.number == number) return {m.system, m.index};
    if (control.haas && number >= 10000 && number <= 10999) return {};  // general purpose on newer controls
    for (const Range& r : ranges) {
        if (number < r.first || number > r.last) continue;
        const bool axis = r.system == position || r.system == machine || r.system == probed;
        const int index = axis ? axis_number(number - r.first + 1, control) : 0;
        return {axis && index == 0 ? unknown : r.system, index};
    }
    return {};
}

}  // namespace obrys::dialect::rs274
