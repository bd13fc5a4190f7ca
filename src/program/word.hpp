#pragma once
/// Words: the smallest parts of a block, by meaning. Eight bytes each, so that a million blocks stay small.

#include <bit>
#include <cstdint>

#include "base/float_chars.hpp"

namespace obrys::program {

enum class Code : std::uint8_t {
    // positions
    x,
    y,
    z,
    a,
    b,
    c,
    u,
    v,
    w,
    named_axis,  ///< AX[…], X1=, EX=…: payload = index into Unit::named
    // circles and polar coordinates
    i,
    j,
    k,  ///< centre relative to the start; pitch of a thread
    i1,
    j1,
    k1,  ///< intermediate point (CIP)
    radius,
    opening_angle,
    turns,  ///< CR=, AR=, TURN=
    polar_angle,
    polar_radius,  ///< AP=, RP=
    // technology
    feed,
    spindle,
    speed_limit,
    tool,
    edge,
    spindle_position,
    m,
    h,
    named_value,  ///< S2=, M[2]=, F[X]=, FA[X]=…: payload = index into Unit::named
    // contour
    chamfer_length,
    chamfer_leg,
    round,
    round_modal,
    corner_feed,
    corner_feed_modal,
    line_angle,      ///< ANG=: angle of a straight line
    plane_rotation,  ///< RPL= of ROT/AROT
    // structure
    modal,        ///< payload = modal_word(…)
    assign,       ///< payload = index into Unit::assigns
    unsupported,  ///< known to the control, not run here: payload = index into Unit::problems
    unknown,      ///< not in the control's tables: payload = index into Unit::problems
    control,      ///< of a statement that is no block: payload = index into the kind's table
    // bare words: something the block does besides its values
    centre_at_pole,   ///< the arc is about the pole (C, CP)
    tool_change,      ///< the block's tool comes into the spindle at once (TOOL CALL); as a literal: its number is that
                      ///< of the tool and, in the last two digits, of the offset (T0203 of turrets)
    tool_definition,  ///< the block says what the tool is (TOOL DEF)
    feed_auto,        ///< the feed given with the tool
    cycle_call,       ///< the cycle defined last, behind the block's motion (CYCL CALL, M99)
    cycle_call_modal,  ///< … from now on behind every block with motion (M89)
    // tools and feeds as millers write them
    tool_length,
    tool_radius,  ///< of tool_definition
    delta_length,
    delta_radius,
    delta_corner,  ///< allowances of the block's tool (DL, DR, DR2)
    feed_per_rev,
    feed_per_tooth,  ///< FU, FZ
    pole_angle,      ///< angle about the pole that an arc sweeps, any number of turns (CP IPA)
    // letters whose meaning depends on the G code beside them (RS-274)
    p,
    q,
    l,
    e,
    offset_h,
    offset_d,  ///< H and D of tool offsets
    // No value in the block.
    act = 64,  ///< F, S, T and M of the block act here, before the words that follow: the control's own order
    comment,   ///< goes into the stream: payload = index into Unit::texts
};
/// Values of a block are kept in as many places.
inline constexpr unsigned value_codes = 64;
static_assert(static_cast<unsigned>(Code::offset_d) < value_codes);

/// What a Modal::set_data writes: P says which row, R or the axis words the value.
enum class DataTable : std::uint8_t {
    by_l,            ///< L says which table (LinuxCNC)
    external_datum,  ///< what is added to every zero offset
    datum,           ///< a zero offset; in G91 the values are added
    extended_datum,  ///< G54.1 P
    tool_length,     ///< R, as all that follow; in G91 it is added
    tool_length_wear,
    tool_radius,
    tool_radius_wear,
    tool_diameter,
    tool_diameter_wear,
};

/// What G codes and their named relatives mean. `number` goes with some of them.
enum class Modal : std::uint16_t {
    rapid,
    linear,
    arc_cw,
    arc_ccw,
    arc_via,
    arc_tangent,
    arc_about,  ///< about the axis through I J K (absolute) along I1 J1 K1, counter-clockwise, in any plane
    thread,
    thread_rising,
    thread_falling,
    tap,
    tap_retract,
    dwell,
    reference_point,
    fixed_point,
    plane_xy,
    plane_zx,
    plane_yz,
    compensation_off,
    compensation_left,
    compensation_right,
    datum,            ///< number: 54…57, 505…599; 500 = off
    suppress_frames,  ///< this block: no datum and no programmed frame (G53)
    suppress_all,     ///< this block: machine coordinates (SUPA, G153); number `position_ignored`: the control takes no
                      ///< notice of it
    exact_stop,
    exact_stop_block,
    continuous,    ///< number of continuous: 64, 641…645
    exact_window,  ///< number: 601, 602, 603
    inch_geometry,
    metric_geometry,
    inch_all,
    metric_all,
    absolute,
    incremental,
    feed_inverse_time,
    feed_per_minute,
    feed_per_rev,
    surface_speed_on,
    surface_speed_off,
    pole_from_position,
    pole_from_zero,
    pole_from_pole,
    approach_normal,
    approach_contour,  ///< NORM, KONT
    corner_arc,
    corner_intersection,  ///< G450, G451
    diameter_on,
    diameter_off,
    diameter_absolute_only,
    pole_given,   ///< CC: the pole by its coordinates, or where the tool stands
    rapid_block,  ///< this block: its arc, approach or departure in rapid (C … FMAX)
    paraxial,     ///< this block: along its axis alone
    paraxial_longer,
    paraxial_shorter,  ///< … by the tool's radius (R+, R-)
    corner_crossing,   ///< this block's end: M97
    corner_open,       ///< this block's end: M98
    look_ahead,        ///< number of contour elements that compensation looks ahead; 0: off (M120 LA)
    arc_same_sense,    ///< an arc in the sense of the last one
    cycle_position,    ///< this block: the coordinates are where the cycle is called
    feed_at_contour,
    feed_at_tool,
    feed_at_inside,  ///< CFC, CFTCP, CFIN
    cycle_pattern,   ///< this block: the cycle is called at every point of the pattern
    plunge_feed,   ///< number: hundredths of a percent of F that the part along the tool axis may have; 0: all (M103 F)
    retract_tool,  ///< this block: first away along the tool axis by Q, at feed E or rapid; number 1: to its limit
                   ///< (M140 MB)
    // RS-274, Fanuc
    canned,      ///< motion: number = index in Traits::canned; ended by canned_off
    canned_off,  ///< G80
    retract_initial,
    retract_clearance,       ///< canned cycles leave to the level they began at, or to R: G98, G99
    tool_length,             ///< G43: of tool or offset H, else of the tool in the spindle
    tool_length_negative,    ///< G44
    tool_length_by_axes,     ///< G43.1: the block's axis words
    tool_length_added,       ///< G43.2: a further offset
    tool_length_off,         ///< G49
    set_data,                ///< this block: G10 with its words; the number is a DataTable
    position_becomes,        ///< this block: G92
    position_reset,          ///< G92.1
    position_suspend,        ///< G92.2
    position_restore,        ///< G92.3
    local_shift,             ///< this block: G52
    home,                    ///< this block: by way of the axis words to home position `number` (G28: 1, G30: 2 …)
    home_store,              ///< G28.1, G30.1
    from_home,               ///< this block: G29
    arc_centre_absolute,     ///< G90.1
    arc_centre_incremental,  ///< G91.1
    compensation_left_by,    ///< G41.1: the diameter stands in the block
    compensation_right_by,   ///< G42.1
    probe,                   ///< motion: number 2 … 5 of G38.2 … G38.5; 1 = G31
    rigid_tap,               ///< this block: G33.1, down and back
    spline_cubic,            ///< motion: G5
    spline_quadratic,        ///< motion: G5.1
    nurbs,                   ///< motion: G5.2, control points until nurbs_end
    nurbs_end,               ///< G5.3
    turning_cycle,           ///< this block: number = G number * 10: 700 … 762
    circle_pocket,           ///< this block: number 1 counter-clockwise, 0 clockwise (G13, G12)
    path_exact,              ///< G61
    path_stop,               ///< G61.1
    path_blend,              ///< G64 P Q
    scaling_on,              ///< this block: G51
    scaling_off,             ///< G50
    mirror_on,               ///< this block: G51.1
    mirror_off,              ///< G50.1
    rotation_on,             ///< this block: G68
    rotation_off,            ///< G69
    polar_on,                ///< G16
    polar_off,               ///< G15
    circle_pocket_cw,        ///< this block: G12, G13
    circle_pocket_ccw,
    save_modal,             ///< M70
    forget_saved_modal,     ///< M71
    restore_modal,          ///< M72
    save_modal_for_call,    ///< M73
    datum_extended,         ///< G54.1: P says which
    compensation_in_plane,  ///< CUT2D: radius compensation in the plane of G17 … G19, whatever frames turn
    compensation_in_frame,  ///< CUT2DF: in the plane as the frame turns it
    compressor_on,          ///< COMPON …: short blocks become curves within a tolerance
    compressor_off,
    polar_face,         ///< G12.1: X and Y lie on the face of the turning workpiece, run by X and C
    cylinder_face,      ///< G7.1, radius P: Y is the way on the cylinder, run by C
    interpolation_off,  ///< G13.1: the axes as they are
    tool_along,         ///< the tool lies along I1 J1 K1, which stand before it, at this block's end and from there on
    program_stop,       ///< this block's end: STOP without the function of its own
};

/// How the payload is to be read.
enum class Form : std::uint8_t {
    // 0 … 9: literal, payload / 10^form
    pooled = 10,      ///< literal: index into Unit::numbers
    expression = 11,  ///< ExprId
    index = 12,       ///< index or packed modal, see Code
    bare = 13,        ///< no value
};

struct Word {
    std::uint32_t code : 8;
    std::uint32_t form : 4;
    std::uint32_t offset : 12;  ///< bytes from the statement's begin, at most 4095
    std::uint32_t length : 8;   ///< bytes, at most 255
    std::int32_t payload;
};
static_assert(sizeof(Word) == 8);

/// A word of these fields, each cut to its bits; put together in a register. Set field by field in memory, every one
/// waits for the one before: 5 % of the whole run of a program of straight blocks.
[[nodiscard]] inline Word make_word(Code code, std::uint32_t form, std::int32_t payload, std::uint32_t offset,
                                    std::uint32_t length) {
    if constexpr (std::endian::native == std::endian::little) {
        const std::uint32_t place =
            static_cast<std::uint32_t>(code) | (form & 0xF) << 8 | (offset & 0xFFF) << 12 | (length & 0xFF) << 24;
        return base::bit_cast<Word>(place | std::uint64_t{static_cast<std::uint32_t>(payload)} << 32);
    }
    return {.code = static_cast<std::uint32_t>(code) & 0xFF,
            .form = form & 0xF,
            .offset = offset & 0xFFF,
            .length = length & 0xFF,
            .payload = payload};
}

/// With Modal::suppress_all: G53 whose coordinates are ways. Other numbers are those of G codes.
inline constexpr int position_ignored = 1;
/// Numbers that go with words of motion. `cartesian_path`: the path function takes no polar coordinates;
/// `polar_path`: it takes no others in the plane; `whole_block`: of rapid_block, also of a straight block.
inline constexpr int cartesian_path = 1, polar_path = 2, whole_block = 1;
/// With Modal::inch_all and metric_all: not by the program's head, which says the unit of all of it.
inline constexpr int unit_inside = 1;
/// Of Modal::paraxial, where R+ and R- hold from block to block: what the block does, and that none of them holds.
inline constexpr int paraxial_feed = 1, paraxial_rapid = 2, paraxial_alone = 4;

[[nodiscard]] constexpr std::int32_t modal_word(Modal m, int number = 0) {
    return static_cast<std::int32_t>((static_cast<std::uint32_t>(number) << 16) | static_cast<std::uint32_t>(m));
}
[[nodiscard]] constexpr Modal modal_of(const Word& w) {
    return static_cast<Modal>(static_cast<std::uint32_t>(w.payload) & 0xFFFF);
}
[[nodiscard]] constexpr int modal_number(const Word& w) {
    return static_cast<int>(static_cast<std::uint32_t>(w.payload) >> 16);
}
[[nodiscard]] constexpr Code code_of(const Word& w) { return static_cast<Code>(w.code); }
/// For sets of codes.
[[nodiscard]] constexpr std::uint64_t bit(Code c) { return std::uint64_t{1} << static_cast<unsigned>(c); }
[[nodiscard]] constexpr Form form_of(const Word& w) { return static_cast<Form>(w.form); }
[[nodiscard]] constexpr bool is_literal(const Word& w) { return w.form <= 10; }

}  // namespace obrys::program
