#pragma once
/// What a template of a post may print: numbers by name, and a few texts. Lengths in mm, angles in degrees, feeds in
/// mm/min, mm per revolution or 1/min, times in seconds.

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "cl/cycle.hpp"

namespace obrys::write {

enum class Value : std::uint8_t {
    // Moves, in the frame in which coordinates are programmed.
    x,
    y,
    z,
    i,  ///< from the start of an arc to its centre
    j,
    k,
    centre_x,
    centre_y,
    centre_z,
    via_x,  ///< a point that it passes, in the middle of its way
    via_y,
    via_z,
    radius,      ///< of an arc
    sweep,       ///< of an arc, counter-clockwise positive
    turns,       ///< of an arc of more than one; else absent
    more_turns,  ///< those less one
    axis,        ///< where an additional axis goes
    pitch,
    pitch_x,  ///< the pitch where the thread runs along that axis; else absent
    pitch_y,
    pitch_z,
    pitch_change,  ///< with every revolution, of threads whose pitch rises or falls
    start,         ///< degrees at which a thread begins; absent where it is 0
    size,          ///< of a chamfer or rounding, a line onto a contour
    own_feed,      ///< of a chamfer, a rounding, a way onto a contour alone; else absent
    length,        ///< of a tool
    tool_radius,
    handle_i,  ///< of a spline: from its start to the second of its four control points
    handle_j,
    handle_k,
    handle_p,  ///< from its end to the third one
    handle_q,
    handle_r,
    first_x,  ///< the four control points where they stand; the last one is x, y, z
    first_y,
    first_z,
    second_x,
    second_y,
    second_z,
    third_x,
    third_y,
    third_z,
    k1_x,  ///< its coefficients; the parameter runs from 1 at the start to 0 at the end
    k1_y,
    k1_z,
    k2_x,
    k2_y,
    k2_z,
    k3_x,
    k3_y,
    k3_z,
    lead_x,  ///< of a helix along that axis, per turn; else absent
    lead_y,
    lead_z,
    // Holes of canned cycles.
    hole_top,    ///< w of the surface, where the cycle says it, else of the retract plane
    hole_way,    ///< from there down to the bottom, positive
    hole_gap,    ///< from there up to the retract plane
    hole_end,    ///< where the cycle ends: the return level, else the retract plane
    speed_back,  ///< of a tap on its way out, 1/min
    // What holds.
    feed,
    speed,
    limit,  ///< highest speed at constant cutting speed
    held,   ///< angle of a spindle that stands
    number,
    value,  ///< of an output
    edge,
    turret,  ///< tool and edge in one number, the edge in its last two digits (T0303)
    raised,
    wider,
    offset,
    own_diameter,  ///< twice the radius of compensation that the program says; negative: on the other side
    nose,          ///< where the tip lies on that radius; absent: in its centre
    place,         ///< of the tool in the magazine
    approach,      ///< the offset with which it approaches the material, where Z moves; else absent
    entry,         ///< and goes into it
    around,        ///< 1 where compensation comes on about the contour's start (KONT); else absent
    sharp,         ///< 1 where outer corners go out to the crossing of the parallels; else absent
    way,           ///< of joining moves: 642 … 645; absent where there is one
    merge,         ///< absent where there is none
    contour,       ///< of a tolerance
    rotary,
    purpose,        ///< filter, 10 more where the tolerance of rotary axes counts
    purpose_angle,  ///< that one, 1 where it does not count
    filter,         ///< 1 finishing, 2 semi-finishing, 3 roughing, 4 precision
    seconds,
    revolutions,
    // Places of the machine; absent along axes that do not go there.
    machine_x,
    machine_y,
    machine_z,
    // Frames.
    shift_x,
    shift_y,
    shift_z,
    angle,    ///< about the normal of the working plane
    angle_x,  ///< turns about the axes as they stand, x first, then y, then z
    angle_y,
    angle_z,
    euler_1,  ///< turns about z, about x as it then lies, about z as it then lies; of planes alone
    euler_2,
    euler_3,
    side,         ///< 1 or -1: the sign of the rotary axis that the plane is to take; absent: the control chooses
    turn_side,    ///< side, 1 where the control chooses
    table_turns,  ///< 1: a table turns where turning the coordinates alone would do; else absent
    distance,     ///< from the tip to the place that the tool turns about
    factor_x,
    factor_y,
    factor_z,
    mirror_x,  ///< 0 where that axis is mirrored; else absent
    mirror_y,
    mirror_z,
    // The file.
    block,   ///< number of the block
    passes,  ///< of a call that is repeated
    count,
};

/// What a token prints: a value, or what a cycle says by role.
using ValueIndex = std::uint16_t;
inline constexpr ValueIndex first_role = static_cast<ValueIndex>(Value::count);
inline constexpr ValueIndex value_count = first_role + static_cast<ValueIndex>(cl::CycleRole::turned_axes) + 1;
[[nodiscard]] constexpr ValueIndex index_of(Value v) { return static_cast<ValueIndex>(v); }
[[nodiscard]] constexpr ValueIndex index_of(cl::CycleRole r) { return first_role + static_cast<ValueIndex>(r); }

/// By its name in a post; in templates of cycles roles come first.
[[nodiscard]] std::optional<ValueIndex> value_named(std::string_view name, bool in_cycle);
[[nodiscard]] std::string_view name_of(Value v);

enum class Text : std::uint8_t { name, text, letter, count };
[[nodiscard]] std::optional<Text> text_named(std::string_view name);

class Values {
public:
    Values() { clear(); }
    void clear() { state_.fill(State::absent); }
    void set(ValueIndex v, double number) {
        number_[v] = number;
        state_[v] = number == number ? State::known : State::unknown;
    }
    void set(Value v, double number) { set(index_of(v), number); }
    void set(Text t, std::string_view text) { text_[static_cast<std::size_t>(t)] = text; }
    void drop(ValueIndex v) { state_[v] = State::absent; }
    void drop(Value v) { drop(index_of(v)); }

    [[nodiscard]] bool has(ValueIndex v) const { return state_[v] != State::absent; }
    /// It is there, but nobody knows it.
    [[nodiscard]] bool is_unknown(ValueIndex v) const { return state_[v] == State::unknown; }
    [[nodiscard]] double number(ValueIndex v) const { return number_[v]; }
    [[nodiscard]] std::string_view text(Text t) const { return text_[static_cast<std::size_t>(t)]; }

private:
    enum class State : std::uint8_t { absent, unknown, known };
    std::array<double, value_count> number_{};
    std::array<State, value_count> state_{};
    std::array<std::string, static_cast<std::size_t>(Text::count)> text_;
};

}  // namespace obrys::write
