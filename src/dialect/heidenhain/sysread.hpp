#pragma once
/// System data of FN 18: SYSREAD (`FN 18: SYSREAD Q5 = ID20 NR1 IDX0`). Sources: Technical Manual iTNC 530 HSCI (July
/// 2013), 9.5.4, pages 1725-1733; where a page of it was not at hand Technical Manual TNC 426/430 (December
/// 2001), 7.3.4. Lengths are mm whatever the program's unit (manual of the newer TNC7; the older ones do not say),
/// angles degrees.

#include <span>

#include "dialect/heidenhain/use.hpp"

namespace obrys::dialect::heidenhain {

/// What a datum of the control is. `other`: known by name only, its value is not known to a simulation.
enum class SysRead : std::uint8_t {
    program_unit,     ///< 0 mm, 1 inch
    overlap_factor,   ///< of pocket milling, MP7430
    active_cycle,     ///< number of the cycle that is active
    tool_number,      ///< in the spindle
    prepared_tool,    ///< of TOOL DEF
    tool_axis,        ///< 0 X, 1 Y, 2 Z, 6 U, 7 V, 8 W
    spindle_speed,    ///< programmed, 1/min
    spindle_state,    ///< -1 undefined, 0 M3, 1 M4, 2 M5 after M3, 3 M5 after M4
    coolant_state,    ///< 0 off, 1 on
    feed,             ///< active
    tool_index,       ///< of the tool in the spindle
    cycle_parameter,  ///< NR 1 … 15 of the cycle that is defined (numbered form)
    table_tool,       ///< column NR of the tool IDX in the tool table; IDX 0: the tool in the spindle
    called_tool,      ///< NR 1 number, 2 axis, 3 speed, 4 DL, 5 DR, 6 automatic, 7 DR2 of the last TOOL CALL
    active_radius,    ///< with oversizes
    active_length,    ///< with oversizes
    basic_rotation,
    program_rotation,  ///< cycle 10
    mirror_bits,       ///< bits 0-2 and 6-8: X Y Z U V W
    scaling,           ///< IDX 1-3, 7-9: X Y Z U V W
    plane_angle,       ///< tilted plane, IDX 1-3: A B C
    plane_active,      ///< 0 no, -1 yes
    path_tolerance,    ///< of cycle 32
    datum_shift,       ///< cycle 7, IDX 1-9: X Y Z A B C U V W
    limit_negative,    ///< software limit switch of axis IDX
    limit_positive,
    machine_position,   ///< nominal position of axis IDX in machine coordinates
    position,           ///< current position of axis IDX in the active coordinate system
    tcpm_active,        ///< M128: 0 no, -1 yes
    active_preset,      ///< row of the preset table
    datum_table_value,  ///< row NR, column IDX of the active datum table
    datum_table_open,   ///< 0 no, 1 yes
    other,
};

struct SysReadEntry {
    int id = 0, nr = 0;
    int nr_last = 0;                  ///< numbers NR `nr` … `nr_last` belong together
    int idx_first = 0, idx_last = 0;  ///< allowed IDX; 0 … 0: none is needed
    SysRead what = SysRead::other;
    Use use = Use::refused;
    std::string_view text;
};

/// The entry of a datum; null where the lists have none, or none with this IDX.
[[nodiscard]] const SysReadEntry* find_sysread(int id, int nr, int idx = 0);
/// Sorted by ID and NR.
[[nodiscard]] std::span<const SysReadEntry> all_sysread();

}  // namespace obrys::dialect::heidenhain
