#pragma once
/// Expressions of the program tree: nodes in one array of their unit, children by number.

#include <cstdint>

namespace obrys::program {

using ExprId = std::uint32_t;
inline constexpr ExprId no_expr = 0xFFFFFFFF;

enum class ExprKind : std::uint8_t {
    number,        ///< a = index into Unit::numbers; op = 1 where written as an integer
    boolean,       ///< a = 0 or 1
    text,          ///< a = index into Unit::texts; 'A' in quotes too
    parameter,     ///< numbered parameter (R5, Q5, #5): a = number
    parameter_at,  ///< numbered parameter, number computed: a = child
    variable,      ///< a = NameId; indices in children [b, b + count)
    system,    ///< system variable ($AA_IM[X]): op = SystemVariable, a = NameId with its `$`; indices as for variable
    unary,     ///< op = Operator, a = child
    binary,    ///< op = Operator, a and b = children
    function,  ///< op = Function, arguments in children [b, b + count); no_expr where left out
    unknown_function,  ///< a = NameId, arguments as for function
    qualified,         ///< position with its own reference: op = Reference, a = child
};

enum class Operator : std::uint8_t {
    negate,
    plus,
    logical_not,
    bit_not,
    add,
    subtract,
    multiply,
    divide,
    integer_divide,
    modulo,
    concat,  ///< text chaining <<
    equal,
    not_equal,
    less,
    less_equal,
    greater,
    greater_equal,
    logical_and,
    logical_or,
    logical_xor,
    bit_and,
    bit_or,
    bit_xor,
    frame_chain,  ///< chaining of frames (SINUMERIK `:`)
    power,
};

enum class Reference : std::uint8_t {
    absolute,
    incremental,
    shortest,  ///< rotary axis, shortest way (DC)
    positive,
    negative,  ///< rotary axis, given sense (ACP, ACN)
    // A transverse axis in this word alone, whatever the diameter mode is (DAC, DIC, RAC, RIC).
    diameter_absolute,
    diameter_incremental,
    radius_absolute,
    radius_incremental,
};

/// Built-in functions; angles in degrees.
enum class Function : std::uint8_t {
    sin,
    cos,
    tan,
    asin,
    acos,
    atan2,
    sqrt,
    abs,
    square,
    trunc,
    round,
    round_up,
    ln,
    exp,
    min,
    max,
    bound,
    string_length,
    to_upper,
    to_lower,
    index,
    rindex,
    mindex,
    substring,
    number,
    is_number,
    axis_name,
    axis_string,
    is_axis,
    is_variable,
    modulo_axis,
    frame_shift,
    frame_rotation,
    frame_plane_rotation,
    frame_scale,
    frame_mirror,
    frame_fine,
    frame_inverse,
    atan,
    log10,
    fraction,
    sign,
    root_of_squares,  ///< FN 8 LEN
    angle_of,         ///< FN 13 ANG: 0 to 360 degrees, of opposite and adjacent side
    to_text,
    find_text,
    compare_texts,  ///< TOCHAR, INSTR, STRCOMP
    format_text,    ///< SPRINT: a text with % where the values go
    file_exists,    ///< ISFILE
    set_list,
    repeat_list,     ///< SET(…) and REP(…): only as the value of an array assignment
    round_down,      ///< to the next integer below
    round_away,      ///< to the nearest integer, halves away from zero
    round_outwards,  ///< away from zero to the next whole number
};

/// Questions to the modal state (SystemVariable::state); yes is 1, no is 0.
enum class StateQuery : std::uint8_t {
    version_major,
    version_minor,
    line,
    motion_mode,
    plane,
    compensation,
    metric,
    imperial,
    absolute,
    incremental,
    inverse_time,
    feed_per_minute,
    feed_per_rev,
    coordinate_system,
    tool_offset,
    retract_clearance,
    retract_initial,
    spindle_rpm_mode,
    spindle_surface_mode,
    arc_centre_absolute,
    diameter_mode,
    radius_mode,
    spindle_on,
    spindle_clockwise,
    mist,
    flood,
    speed_override,
    feed_override,
    adaptive_feed,
    feed_hold,
    feed,
    speed,
    x,
    y,
    z,
    a,
    b,
    c,
    u,
    v,
    w,  ///< as SystemVariable::coordinate
    machine_x,
    machine_y,
    machine_z,
    machine_a,
    machine_b,
    machine_c,
    machine_u,
    machine_v,
    machine_w,
    current_tool,
    current_pocket,
    selected_tool,
    selected_pocket,
    is_task,
    call_level,
    remap_level,
};

/// What a system variable means. Names the tables do not know are `unknown`: reading them is reported, never guessed.
enum class SystemVariable : std::uint8_t {
    unknown,
    numbered_parameter,   ///< $R[n]
    machine_position,     ///< $AA_IM[axis]: machine coordinates
    work_position,        ///< $AA_IW[axis]: workpiece coordinates, where the axis is
    programmed_position,  ///< $P_EP[axis]: last programmed end position
    tool_radius,
    tool_length,  ///< $P_TOOLR, $P_TOOLL[1…3]
    tool_number,
    tool_edge,       ///< $P_TOOLNO, $P_TOOL
    tool_parameter,  ///< $TC_DPn[T, D]: n stands at the end of the name
    tool_name,
    tool_exists,  ///< $TC_TP2[T], $P_TOOLEXIST[T]
    feed,
    spindle_speed,      ///< $P_F, $AC_F; $P_S[n], $AA_S[n]
    spindle_direction,  ///< $P_SDIR[n], $AC_SDIR[n]: 3, 4, 5
    active_g,           ///< $P_GG[group]
    machine_data,       ///< $MC_…, $MN_…, $MA_…: from the machine file
    datum_frame,        ///< $P_UIFR[n]: settable frame number n
    base_frame,
    programmed_frame,
    active_frame,
    settable_frame,  ///< $P_BFRAME, $P_PFRAME, $P_ACTFRAME, $P_IFRAME
    marker,
    parameter,  ///< $AC_MARKER[n], $AC_PARAM[n]: read back what the program wrote
    timer,      ///< $AC_TIME, $AC_TIMER[n]
    is_simulation,
    is_search,
    is_test,
    is_dry_run,      ///< $P_SIM, $P_SEARCH, $P_ISTEST, $P_DRYRUN
    argument_given,  ///< $P_SUBPAR[n]
    stack_depth,
    program_name,       ///< $P_STACK, $P_PROG[n]
    channel_axis_name,  ///< $P_AXN1 … 3
    pi,                 ///< $PI
    digital_output,     ///< $A_OUT[n]
    analog_output,      ///< $A_OUTA[n]
    clock,              ///< $A_YEAR … $A_SECOND: when the program runs
    // FN 18: SYSREAD
    inch_program,  ///< 0 mm, 1 inch
    prepared_tool,
    tool_axis,      ///< 0 X, 1 Y, 2 Z
    spindle_state,  ///< 0 M3, 1 M4, 2 M5 behind M3, 3 M5 behind M4
    coolant_state,  ///< 0 off, 1 on
    table_length,
    table_radius,
    table_corner_radius,
    table_delta_length,
    table_delta_radius,
    table_delta_corner,  ///< of the tool [n] in the list; 0: of the one in the spindle
    call_delta_length,
    call_delta_radius,
    call_delta_corner,  ///< of the last TOOL CALL
    active_radius,
    active_length,    ///< with all allowances
    active_rotation,  ///< cycle 10, degrees
    shift_of_axis,    ///< [axis] cycle 7
    scale_of_axis,    ///< [axis] cycle 11
    travel_min,
    travel_max,    ///< [axis] of the machine
    active_datum,  ///< number of the preset
    // RS-274
    state,               ///< [StateQuery]: what the control's modal state is
    coordinate,          ///< [1 … 9] X … W in the active coordinate system, in the program's unit
    machine_coordinate,  ///< [1 … 9] in machine coordinates, in the machine's unit (mm)
    probed_coordinate,   ///< [1 … 9] of the last probing move
    probe_success,       ///< 1 where it touched
    tool_table_column,   ///< [0 … 13] of the tool in the spindle: number, X … W, diameter, front, back angle,
                         ///< orientation
    input_value,         ///< of the last M66
    ini_value,           ///< [section, key] of the control's settings
    sub_argument,        ///< [n] of G65
    code_in_force,  ///< [StateQuery, code where it is so, code where not]: of the group, as the program has said it
};

struct Expr {
    ExprKind kind = ExprKind::number;
    std::uint8_t op = 0;
    std::uint16_t count = 0;
    std::uint32_t a = 0, b = 0;
    std::uint32_t begin = 0, end = 0;  ///< bytes in the unit's source text
};

}  // namespace obrys::program
