#include "dialect/heidenhain/m_functions.hpp"

#include <algorithm>
#include <array>

namespace obrys::dialect::heidenhain {

namespace {

using enum When;
using enum Use;

constexpr bool in_block = true;

// Feed, spindle, coolant and stops are records of the stream: their functions are run. What only concerns the
// controller, its display, its monitoring or a message is accepted. Whatever moves points and is not run is refused.
constexpr std::array functions{
    MFunction{0, end, run, "stop of the program, spindle and coolant off", {}, in_block},
    MFunction{1, end, run, "stop of the program where the operator wants it", {}, in_block},
    MFunction{2, end, run, "end of the program, spindle and coolant off", {}, in_block},
    MFunction{3, start, run, "spindle on, clockwise"},
    MFunction{4, start, run, "spindle on, counter-clockwise"},
    MFunction{5, end, run, "spindle stop"},
    MFunction{6, end, run, "tool change, spindle stop, program stop where the machine says so", {}, in_block},
    MFunction{7, start, run, "mist coolant on, as most machines have it"},
    MFunction{8, start, run, "coolant on"},
    MFunction{9, end, run, "coolant off"},
    MFunction{13, start, run, "spindle on, clockwise, and coolant on"},
    MFunction{14, start, run, "spindle on, counter-clockwise, and coolant on"},
    MFunction{19, end, run, "spindle stop at the angle of cycle 13, as most machines have it"},
    MFunction{30, end, run, "as M2", {}, in_block},
    MFunction{89, end, run, "modal cycle call: after every positioning block, until M99"},
    MFunction{90, start, accepted, "constant speed at corners without radius compensation (lag mode)", {}, in_block},
    MFunction{91, start, run, "coordinates of this block refer to the machine datum", {}, in_block},
    MFunction{92, start, refused, "coordinates of this block refer to a point of the machine's builder", {}, in_block},
    MFunction{93, start, refused, "reserved", {}, in_block},
    MFunction{94, start, accepted, "display of rotary axes reduced to a value below 360 degrees", "A B C U V W",
              in_block},
    MFunction{95, start, refused, "reserved", {}, in_block},
    MFunction{96, start, refused, "reserved", {}, in_block},
    MFunction{97,
              end,
              run,
              "small contour steps: intersection of the compensated elements instead of an error",
              {},
              in_block},
    MFunction{98, end, run, "end of compensation: an open contour is machined completely", {}, in_block},
    MFunction{99, end, run, "cycle call; ends M89", {}, in_block},
    MFunction{101, end, refused, "changes to the replacement tool when the tool life is over: its time is not known",
              "BT"},
    MFunction{102, end, accepted, "ends M101"},
    MFunction{103, start, run, "feed reduced to a factor where the tool moves into the material along its axis", "F"},
    MFunction{104, end, refused, "reactivates the datum last set by hand"},
    MFunction{105, end, accepted, "second kv factor of the controller"},
    MFunction{106, end, accepted, "first kv factor of the controller"},
    MFunction{107, start, accepted, "no message for replacement tools with oversize"},
    MFunction{108, start, accepted, "ends M107"},
    MFunction{109, start, run, "on arcs the feed holds at the cutting edge, inside and outside"},
    MFunction{110, start, run, "on inner arcs the feed holds at the cutting edge"},
    MFunction{111, end, run, "ends M109 and M110"},
    MFunction{112, start, refused, "inserts transitions between contour elements", "T A"},
    MFunction{113, end, accepted, "ends M112"},
    MFunction{114, start, refused, "correction of the machine geometry for tilted axes"},
    MFunction{115, end, accepted, "ends M114"},
    MFunction{116, start, refused,
              "feed of rotary axes in mm/min: it depends on their distance from the axis of rotation"},
    MFunction{117, end, accepted, "ends M116"},
    MFunction{118, start, refused, "handwheel moves are added to the program's", "X Y Z A B C U V W"},
    MFunction{120, start, run, "looks ahead up to 99 blocks and leaves out elements the tool does not fit into", "LA"},
    MFunction{124, start, refused, "leaves out points of straight blocks that are too close together", "T"},
    MFunction{126, start, accepted, "rotary axes take the shorter way"},
    MFunction{127, end, accepted, "ends M126"},
    MFunction{128, start, refused, "the tool tip keeps its place while tilting axes move (TCPM)", "F"},
    MFunction{129, end, accepted, "ends M128"},
    MFunction{
        130, start, refused, "points of this block refer to the coordinate system that is not tilted", {}, in_block},
    MFunction{134, start, accepted, "exact stop at transitions with rotary axes"},
    MFunction{135, end, accepted, "ends M134"},
    MFunction{136, start, run, "F in mm per revolution of the spindle"},
    MFunction{137, end, run, "F in mm per minute"},
    MFunction{138, start, refused, "selects the tilting axes that count", "A B C"},
    MFunction{140, start, run, "retracts along the tool axis", "MB F", in_block},
    MFunction{141, start, accepted, "no monitoring of the touch probe", {}, in_block},
    MFunction{142, start, refused, "deletes modal program information", {}, in_block},
    MFunction{143, start, refused, "deletes the basic rotation", {}, in_block},
    MFunction{144, start, refused, "counts the kinematics of tilted axes in positions at the block's end"},
    MFunction{145, end, accepted, "ends M144"},
    MFunction{148, start, accepted, "lifts the tool off when the machine is stopped"},
    MFunction{149, end, accepted, "ends M148"},
    MFunction{
        150, start, refused, "no message of the limit switches: the block ends where the travel ends", {}, in_block},
    MFunction{200, start, refused, "laser cutting: output of a voltage", "V"},
    MFunction{201, start, refused, "laser cutting: voltage by the distance", "V"},
    MFunction{202, start, refused, "laser cutting: voltage by the speed", "V"},
    MFunction{203, start, refused, "laser cutting: voltage by the time, ramp", "V TIME"},
    MFunction{204, start, refused, "laser cutting: voltage by the time, pulse", "V TIME"},
};

}  // namespace

std::span<const MFunction> all_m() { return functions; }

const MFunction* find_m(int number) {
    const auto found = std::lower_bound(functions.begin(), functions.end(), number,
                                        [](const MFunction& m, int n) { return m.number < n; });
    return found != functions.end() && found->number == number ? &*found : nullptr;
}

}  // namespace obrys::dialect::heidenhain
