#pragma once
/// Words of FANUC controls (series 0i, 16i, 18i, 30i; mills and lathes) and of Haas, as data. Sources:
/// docs/dialects/fanuc.md.

#include <cstdint>
#include <span>
#include <string_view>

#include "dialect/rs274/tables.hpp"
#include "program/unit.hpp"

namespace obrys::dialect::rs274 {

enum class FanucMachine : std::uint8_t { mill, lathe };
/// G codes of lathes; chosen by the machine's builder (parameter 3401, bits GSB and GSC).
enum class GSystem : std::uint8_t { a, b, c };
/// What a length without decimal point means: least input increments (FANUC parameter 3401 bit DPI = 0, Haas setting
/// 162 off) or millimetres, inches, degrees ("pocket calculator" input).
enum class WholeNumbers : std::uint8_t { increments, units };

/// The control a program is written for.
struct FanucControl {
    bool haas = false;
    FanucMachine machine = FanucMachine::mill;
    GSystem system = GSystem::a;
    WholeNumbers whole_numbers = WholeNumbers::increments;

    [[nodiscard]] bool is_lathe() const { return machine == FanucMachine::lathe; }
};

enum class FanucUse : std::uint8_t {
    modal,     ///< a word of the tree
    special,   ///< see FanucSpecial
    accepted,  ///< known, no effect on the path
    refused,   ///< known, not run
};

/// G codes that are more than one word.
enum class FanucSpecial : std::uint8_t {
    none,
    dwell,         ///< X, U or P
    home,          ///< G30 P says which
    probe,         ///< G31
    set_data,      ///< G10 and its words
    position,      ///< G92, G50 of lathes: S is a limit, axis words shift
    datum_number,  ///< Haas G110 … G129: the extended zero `number`
    canned,        ///< hole cycles; number = G number * 10
    thread,        ///< G32, G33: F is the lead
    macro_call,
    macro_modal,
    macro_end,
    repetitive,     ///< G70 … G76 of lathes
    turning_cycle,  ///< G90, G92, G94 of lathes: modal
    rotation,
    rotation_off,
    tilt,          ///< G68.2
    tilt_spatial,  ///< Haas G268
    tilt_by_axes,  ///< Haas G254
    tilt_off,      ///< Haas G255, G269
    take_up_tilt,  ///< G53.1, Haas G253
    scaling,
    scaling_off,
    mirror,
    mirror_off,  ///< transformations about a centre
    polar,
    polar_off,
    polar_face,
    cylinder_face,
    interpolation_off,  ///< G12.1, G7.1, G13.1 of FANUC
    local_pattern,      ///< Haas G70, G71 of mills: points for the hole cycle
};

struct FanucG {
    std::int16_t code = 0;  ///< G number * 10
    FanucUse use = FanucUse::modal;
    program::Modal modal = program::Modal::linear;  ///< of refused ones `canned`: in force until another motion
    std::int16_t number = 0;
    Order order = Order::motion;
    FanucSpecial special = FanucSpecial::none;
    std::string_view says;       ///< of refused and accepted ones: what the control does
    std::string_view letters{};  ///< of accepted ones: words of its own
};
/// The entry of G number * 10; null where the control's manuals have none.
[[nodiscard]] const FanucG* find_fanuc_g(int code, const FanucControl& control);

/// A G code of lathes by what it does: its number in systems A, B and C, * 10; -1 where the system has none.
struct LatheG {
    std::int16_t a = -1, b = -1, c = -1;
    FanucG meaning;
};
[[nodiscard]] std::span<const LatheG> lathe_g_table();
[[nodiscard]] std::span<const FanucG> mill_g_table();
[[nodiscard]] std::span<const FanucG> haas_mill_g_table();   ///< what differs from mill_g_table
[[nodiscard]] std::span<const FanucG> haas_lathe_g_table();  ///< and from lathe_g_table

enum class FanucMUse : std::uint8_t {
    function,    ///< stays an M function in the stream, before the motion
    behind,      ///< as `function`, behind the motion
    call,        ///< M98
    return_,     ///< M99
    local_call,  ///< Haas M97
    accepted,
    refused,
    unknown,  ///< the machine builder's
};
struct FanucM {
    std::int16_t code = 0;
    FanucMUse use = FanucMUse::function;
    std::string_view says;
};
[[nodiscard]] FanucM find_fanuc_m(int code, const FanucControl& control);
/// Numbers of those that are accepted: they go to the machine as they stand.
[[nodiscard]] std::span<const std::int16_t> accepted_fanuc_m(bool haas);

/// Parameter that an argument letter of G65 and G66 sets (argument specification I); 0: the letter is none.
[[nodiscard]] int argument_parameter(char letter);
/// Parameter of the n-th I, J or K (n from 1, at most 10): argument specification II. 0 past the last.
[[nodiscard]] int argument_parameter(char letter, int n);

/// What the system variable with a given number says.
enum class FanucSystem : std::uint8_t {
    storage,   ///< an ordinary parameter
    unknown,   ///< set by the machine
    alarm,     ///< #3000
    stop,      ///< #3006
    option,    ///< #3003, #3004 …: what is written there has no effect on the path
    timer,     ///< #3001, #3002
    position,  ///< coordinate `index` (1 X … 9 W) of the last block's end
    machine,   ///< machine coordinate
    probed,    ///< where the skip signal came
    group,     ///< G code in force: `index` is the number of a query
    feed,
    speed,
    tool,
    offset_number,  ///< #4111, #4107
};
struct FanucVariable {
    FanucSystem system = FanucSystem::storage;
    int index = 0;
};
/// Modal groups that #4001 … show, in the order of FanucVariable::index.
enum class FanucGroup : std::uint8_t { motion, plane, distance, feed_mode, units, compensation, surface_speed, datum };

[[nodiscard]] FanucVariable system_variable(std::uint32_t number, const FanucControl& control);

/// How the number of a turning cycle's word is meant where it has no point.
enum class TurningNumber : std::uint8_t {
    length,
    increments,  ///< always, however the control takes other numbers
    depth,       ///< as `increments`; on Haas as `length`
    plain,
    half_angle,  ///< degrees between the flanks; the role is half of it
    lead,
    angle,  ///< in thousandths of a degree
};
struct TurningWord {
    char letter = 0;
    cl::CycleRole role = cl::CycleRole::infeed;
    TurningNumber number = TurningNumber::length;
    bool across = false;  ///< a diameter
};
/// A multiple repetitive cycle of lathes: G70 … G76 of system A, by its number there * 10.
struct FanucTurningCycle {
    int number = 0;
    cl::CycleKind kind = cl::CycleKind::lathe_finish;
    std::uint8_t store = 0;                     ///< cycles with the same one share what their first blocks say
    std::span<const TurningWord> data, call;    ///< two blocks: the first, the second
    std::span<const TurningWord> single, haas;  ///< one block
    std::span<const program::CycleDefault> parameters, settings;  ///< of FANUC, of Haas
};
/// Null where there is none of that number.
[[nodiscard]] const FanucTurningCycle* find_turning_cycle(int number);

[[nodiscard]] std::span<const program::CannedCycle> fanuc_mill_cycles();
[[nodiscard]] std::span<const program::CannedCycle> haas_mill_cycles();
[[nodiscard]] const program::Traits& fanuc_traits(const FanucControl& control);
/// Operators, functions and grammar; its G and M tables are empty: those are above.
[[nodiscard]] const Dialect& fanuc_dialect(const FanucControl& control);

}  // namespace obrys::dialect::rs274
