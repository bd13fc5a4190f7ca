#pragma once
/// What Traits are made of: how a control numbers its parameters and zeros, what its words and blocks mean.

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "cl/cycle.hpp"
#include "program/expr.hpp"
#include "program/word.hpp"

namespace obrys::program {

/// Numbered parameters of one kind, in the order of their numbers: R0 …, Q0 …, QL0 ….
struct ParameterBank {
    std::string_view letters;  ///< empty: there is no such bank
    std::uint32_t count = 0;
    bool local = false;  ///< every program has its own, and begins with none set
};

/// When a parameter counts as equal to another number.
struct Equality {
    double relative = 0;  ///< of the larger of the two
    double absolute = 0;
    bool orders_exactly = false;  ///< it is asked by equal and not equal alone, not by less and greater
};

/// How a control calls its workpiece zeros. Numbers are those of cl::Datum; 500: none was selected.
struct DatumNames {
    std::string_view prefix = "G";                  ///< before the number: "G54", "preset 5"
    std::string_view article = "the zero offset ";  ///< before that in a sentence
    std::string_view key = "G";                     ///< before the number in [datum] of the job
    std::uint32_t first = 0;                        ///< number in the stream of the one that the control calls 0
    std::string_view none = "G500", none_key = "G500";
    bool more_by_decimals = false;     ///< 591 is G59.1, 5403 is G54.1 P3
    bool none_is_machine_zero = true;  ///< without one coordinates are the machine's; else they are in one not known
};

/// The control's own numbers of alarms, which its operator looks up: "34". Empty: it has none, or it is not known.
struct AlarmNumbers {
    std::string_view late_definition{};     ///< a definition behind a block that is run
    std::string_view circle_compensates{};  ///< radius compensation begins or ends on a circle
};

/// How axes that begin a rapid move together end it.
enum class RapidWay : std::uint8_t {
    straight,   ///< all at once
    each_axis,  ///< each at its own rapid, so that the way bends, as the control is delivered
    by_setting  ///< the builder of the machine decides
};
struct Rapids {
    RapidWay way = RapidWay::straight;
    std::string_view setting{};  ///< with which each axis goes by itself
};

/// What the control itself writes into numbered parameters while a program runs.
enum class ControlValue : std::uint8_t {
    tool_radius,     ///< with all allowances
    tool_axis,       ///< -1 none yet, 0 X, 1 Y, 2 Z
    spindle_state,   ///< -1 none yet, 0 M3, 1 M4, 2 M5 behind M3, 3 M5 behind M4
    coolant_state,   ///< 0 off, 1 on
    pocket_overlap,  ///< of the machine's settings
    main_unit,       ///< of the main program: 0 mm, 1 inch
    tool_length,     ///< with all allowances
    probed,          ///< result of a touch probe
    // Positions of rotary axes for the tilted plane.
    tilted_a,
    tilted_b,
    tilted_c,
};
struct ControlParameter {
    std::uint32_t number = 0;
    ControlValue value = ControlValue::tool_radius;
};

/// Numbered parameters in which the control shows its own state (#5420 …: where it stands), one an axis or one in all.
struct LiveParameters {
    std::uint32_t first = 0, count = 1;
    SystemVariable value = SystemVariable::unknown;
};

/// Numbered parameters that hold something from before the program begins.
struct KeptParameters {
    std::uint32_t first = 0, last = 0;  ///< inclusive
    /// Not empty: by this setting of the control they are empty when a program begins, which is taken.
    std::string_view cleared_by{};
    bool acts = false;  ///< what is written there changes what the control or the machine does
};

/// Where the control keeps its offsets among the numbered parameters: an axis each, X Y Z A B C U V W, in the machine's
/// unit. 0: there are none, and offsets are those of the machine file and the job.
struct OffsetParameters {
    std::uint32_t datum_first = 0;  ///< X of the first zero offset (G54); the others follow at `datum_step`
    std::uint32_t datum_step = 20;
    std::uint32_t datum_count = 0;
    std::uint32_t rotation = 0;      ///< of a zero offset about Z, degrees: so far behind its X; 0: it has none
    std::uint32_t active_datum = 0;  ///< 1 = G54
    std::uint32_t shift_first = 0, shift_active = 0;  ///< G92; whether it is in force
    std::uint32_t home_first = 0, home_second = 0;    ///< G28, G30
    std::uint32_t external_first = 0;                 ///< X of what is added to every zero offset; 0: there is none
    std::uint32_t extended_first = 0;                 ///< X of G54.1 P1; the others follow at `datum_step`
    std::uint32_t extended_count = 0;
};

/// A word of a canned cycle's block and what it says.
struct CannedWord {
    Code code = Code::p;
    cl::CycleRole role = cl::CycleRole::dwell_bottom;
    bool length = false;  ///< in the program's unit
    double factor = 1;    ///< dwell in milliseconds: 0.001
    bool across = false;  ///< a diameter where the program has diameters
    bool sign_ignored = false;
    /// Where the cycle has that word and not this other one, it says something else: K of Haas' G73 beside Q, without
    /// I.
    struct Beside {
        Code word = Code::p, unless = Code::p;
        cl::CycleRole role = cl::CycleRole::dwell_bottom;
    };
    const Beside* beside = nullptr;
};
/// A cycle that the words of motion blocks call (G81 X Y Z R).
struct CannedCycle {
    int number = 0;  ///< G number * 10
    cl::CycleKind kind = cl::CycleKind::drill;
    std::string_view name;                  ///< "G81"
    std::span<const CannedWord> words;      ///< besides X Y Z, R and L; they hold until the cycle is cancelled
    std::span<const cl::CycleValue> fixed;  ///< what the control itself adds; mm, degrees, s
    bool adds_in_units = false;             ///< it adds up infeeds as binary numbers of the program's unit
    bool turns_axes = false;                ///< a fault of the control: outside G17 it feeds to another place
};

/// What an argument of a cycle at one hole says that is called like a program (CYCLE81). Lengths in the program's unit;
/// planes and bottoms are coordinates of the tool axis.
enum class HoleArgument : std::uint8_t {
    ignored,       ///< says nothing about the path
    unknown,       ///< only a call that leaves it out, or writes 0, is run
    return_plane,  ///< where the cycle ends
    reference_plane,
    clearance,        ///< above the reference plane, without sign
    bottom,           ///< the end of the hole
    depth,            ///< … or its distance below the reference plane; counts where both are written
    dwell,            ///< s
    dwell_or_turns,   ///< s; negative: turns of the spindle
    first_bottom,     ///< of deep drilling: where the first infeed ends
    first_depth,      ///< … or its distance below the reference plane
    degression,       ///< of the infeeds; negative: a factor
    dwell_first,      ///< before each infeed, as dwell_or_turns
    feed_factor,      ///< of the first infeed
    way_out,          ///< 0 a little back after each infeed, 1 out of the hole
    axis,             ///< along which it drills: 3 or left out, the tool axis
    least_infeed,     ///< of deep drilling
    way_back,         ///< after an infeed
    dwell_last,       ///< at the bottom, as dwell_or_turns; 0 that of the others
    stop_distance,    ///< above the depth reached, where the rapid way back into the hole ends; 0 by a rule
    direction_after,  ///< of the spindle: 3 M3, 4 M4, 5 M5
    direction_back,   ///< of the spindle on the way out of a thread
    direction,        ///< of the spindle in the hole
    encoder,          ///< of the spindle: how the thread is made
    size,             ///< of an ISO metric thread with coarse pitch
    pitch,            ///< positive right-hand
    pitch_unit,       ///< 0 of the program, 1 mm, 2 threads an inch, 3 inches
    spindle_angle,    ///< at which the spindle stops, degrees
    speed_in,         ///< 1/min
    speed_out,
    steps,   ///< of a tap: 0 none, 1 a little back, 2 out after each
    infeed,  ///< of these
    feed_in,
    feed_out,
    shift_u,  ///< away from the wall of the hole
    shift_v,
    shift_w,
    plane,  ///< in which the cycle works: 0 the one in force, 1 G17 …
    modes,  ///< how other arguments count; CalledHole::known_modes
};

/// What a called cycle does at the hole.
enum class HoleShape : std::uint8_t { drill, deep_drill, tap_rigid, tap_floating, bore_feed, bore_orient, bore_stop };

/// A cycle at one hole that is called like a program.
struct CalledHole {
    std::string_view name;
    HoleShape shape = HoleShape::drill;
    std::span<const HoleArgument> arguments;
    std::span<const int> known_modes{};  ///< besides 0: they change nothing but what `HoleArgument` says
    bool stops_program = false;          ///< at the bottom
};

/// The way along which the pitch of a thread counts.
enum class PitchAlong : std::uint8_t {
    axis_of_word,   ///< the axis whose word says it (I, J, K)
    farthest_axis,  ///< the one that goes farthest, whatever word says it
    move
};

/// What a control does with something that a block says twice.
enum class Repeated : std::uint8_t {
    stops,        ///< an alarm
    last_counts,  ///< the last one acts; the manual says so
    last_or_stop  ///< as a machine parameter says
};

/// An M function that stops the spindle, besides M5 and M19.
struct SpindleStop {
    std::int16_t function = 0;
    bool before_motion = false;
    bool certain = true;     ///< else machine or operator say whether it does
    bool coolant = false;    ///< which it switches off, too
    bool does_more = false;  ///< which is the machine's own: the stream has the function, too
};

/// Letters that belong to an M function, where its block has them: "PQ".
struct FunctionLetters {
    std::int16_t first = 0, last = 0;  ///< M functions, inclusive
    std::string_view letters;
};

/// How the names of variables are written that the control has beside its numbered parameters.
enum class NamedVariables : std::uint8_t {
    none,
    plain,     ///< MY_I[2], $A_IN[1]
    in_angles  ///< #<_gap>
};

/// The kind of machine that a program is taken to be for where nobody names one. It decides whether X words are halved.
enum class GuessedMachine : std::uint8_t {
    mill,      ///< whatever the program writes: the control drives no lathe, or its reader has read it as a mill's
    lathe,     ///< its reader has read it as a lathe's
    by_words,  ///< what the program writes is weighed: DIAMON, G18, M6, Y
};

/// Blocks without motion, one behind the other, between two elements of a compensated contour.
struct IdleBlocks {
    std::uint32_t seen_past = 0;  ///< so many the control sees past to the corner behind them; 0: no limit
    std::string_view setting{};   ///< that says how many
    std::string_view beyond{};    ///< what the control does behind more of them
};

}  // namespace obrys::program
