#include "dialect/heidenhain/sysread.hpp"

#include <algorithm>
#include <array>

namespace obrys::dialect::heidenhain {

namespace {

using enum SysRead;
using enum Use;

constexpr int axes = 9, tools = 32'767, rows = 9'999'999;

// A value is run where the program and the tables of the job make it; the machine's own state is refused.
constexpr std::array entries{
    SysReadEntry{10, 1, 1, 0, 0, program_unit, run, "unit of the program: 0 mm, 1 inch"},
    SysReadEntry{10, 2, 2, 0, 0, overlap_factor, refused, "overlap factor of pocket milling (machine parameter)"},
    SysReadEntry{10, 3, 3, 0, 0, active_cycle, refused, "number of the active cycle"},
    SysReadEntry{10, 4, 4, 0, 0, other, refused, "number of the last OEM cycle"},
    SysReadEntry{20, 1, 1, 0, 0, tool_number, run, "number of the active tool"},
    SysReadEntry{20, 2, 2, 0, 0, prepared_tool, run, "number of the prepared tool"},
    SysReadEntry{20, 3, 3, 0, 0, tool_axis, run, "active tool axis"},
    SysReadEntry{20, 4, 4, 0, 0, spindle_speed, run, "programmed spindle speed"},
    SysReadEntry{20, 5, 5, 0, 0, spindle_state, run, "spindle: -1 undefined, 0 M3, 1 M4, 2 M5 after M3, 3 M5 after M4"},
    SysReadEntry{20, 8, 8, 0, 0, coolant_state, run, "coolant: 0 off, 1 on"},
    SysReadEntry{20, 9, 9, 0, 0, feed, run, "active feed"},
    SysReadEntry{20, 11, 11, 0, 0, tool_index, refused, "index of the active tool"},
    SysReadEntry{20, 13, 13, 0, 0, other, refused, "number of the active spindle"},
    SysReadEntry{20, 15, 15, 0, axes, other, refused, "axis that belongs to a logical axis"},
    SysReadEntry{20, 17, 17, 0, 0, other, refused, "active range of traverse"},
    SysReadEntry{30, 1, 15, 0, 0, cycle_parameter, refused, "parameter of the active cycle (numbered form)"},
    SysReadEntry{50, 1, 6, 0, tools, table_tool, run, "tool table: L, R, R2, DL, DR, DR2"},
    SysReadEntry{50, 7, 8, 0, tools, table_tool, refused, "tool table: TL (0, 1), RT"},
    SysReadEntry{50, 9, 12, 0, tools, other, refused, "tool table: TIME1, TIME2, CUR.TIME, PLC"},
    SysReadEntry{50, 13, 15, 0, tools, table_tool, refused, "tool table: LCUTS, ANGLE, CUT."},
    SysReadEntry{
        50, 16, 27, 0, tools, other, refused,
        "tool table: LTOL, RTOL, DIRECT, R-OFFS, L-OFFS, LBREAK, RBREAK, PLC, CAL-OF1, CAL-OF2, CAL-ANG, PTYP"},
    SysReadEntry{50, 28, 28, 0, tools, table_tool, refused, "tool table: NMAX"},
    SysReadEntry{50, 29, 31, 0, tools, other, refused, "tool table: P1, P2, P3"},
    SysReadEntry{50, 32, 33, 0, tools, table_tool, refused, "tool table: T-ANGLE, PITCH"},
    SysReadEntry{51, 1, 16, 0, rows, other, refused,
                 "pocket table: tool, ST, F, L, PLC, type, P1 to P5, reserved, neighbours"},
    SysReadEntry{52, 1, 1, 0, tools, other, refused, "pocket of a tool"},
    SysReadEntry{60, 1, 5, 0, 0, called_tool, run, "TOOL CALL: number, axis, speed, DL, DR"},
    SysReadEntry{60, 6, 6, 0, 0, other, refused, "TOOL CALL: automatic or by hand"},
    SysReadEntry{60, 7, 7, 0, 0, called_tool, run, "TOOL CALL: DR2"},
    SysReadEntry{61, 0, 0, 0, tools, other, refused, "kind of the tool change"},
    SysReadEntry{70, 1, 3, 0, 3, other, refused, "position and feed programmed behind TOOL CALL"},
    SysReadEntry{200, 1, 1, 0, 0, active_radius, run, "active radius with oversizes"},
    SysReadEntry{200, 2, 2, 0, 0, active_length, run, "active length with oversizes"},
    SysReadEntry{210, 1, 1, 0, 0, basic_rotation, refused, "basic rotation"},
    SysReadEntry{210, 2, 2, 0, 0, program_rotation, run, "programmed rotation (cycle 10)"},
    SysReadEntry{210, 3, 3, 0, 0, mirror_bits, refused, "mirrored axes, one bit each"},
    SysReadEntry{210, 4, 4, 1, axes, scaling, run, "scaling factor of an axis"},
    SysReadEntry{210, 5, 5, 1, 3, plane_angle, refused, "angles A, B, C of the tilted plane"},
    SysReadEntry{210, 6, 6, 0, 0, plane_active, refused, "tilted plane in the program: 0 no, -1 yes"},
    SysReadEntry{210, 7, 7, 0, 0, other, refused, "tilted plane in manual operation"},
    SysReadEntry{210, 8, 8, 0, 0, other, refused, "angle between the spindle and the tilted coordinate system"},
    SysReadEntry{214, 8, 8, 0, 0, path_tolerance, refused, "tolerance of cycle 32"},
    SysReadEntry{220, 2, 2, 1, axes, datum_shift, run, "active datum shift of an axis"},
    SysReadEntry{220, 3, 3, 1, axes, other, refused, "difference between reference point and datum"},
    SysReadEntry{220, 4, 4, 1, axes, other, refused, "datum shift of the PLC"},
    SysReadEntry{230, 2, 2, 1, axes, limit_negative, run, "negative limit of an axis"},
    SysReadEntry{230, 3, 3, 1, axes, limit_positive, run, "positive limit of an axis"},
    SysReadEntry{240, 1, 1, 1, axes, machine_position, run, "nominal position of an axis, machine coordinates"},
    SysReadEntry{270, 1, 1, 1, axes, position, run, "position of an axis, active coordinate system"},
    SysReadEntry{280, 1, 1, 0, 0, tcpm_active, refused, "M128: 0 no, -1 yes"},
    SysReadEntry{280, 2, 2, 0, 0, other, refused, "feed of M128"},
    SysReadEntry{290, 1, 2, 0, 31, other, refused, "kinematics of the tilting axes"},
    SysReadEntry{310, 144, 144, 0, 0, other, refused, "M144: 0 no, -1 yes"},
    SysReadEntry{350, 10, 15, 0, 2, other, refused, "touch probe: axis, radius, length, calibration ring, offset"},
    SysReadEntry{350, 20, 36, 0, 3, other, refused, "tool touch probe and measuring touch probe"},
    SysReadEntry{360, 1, 3, 0, axes, other, refused, "result of a touch probe cycle"},
    SysReadEntry{500, 0, rows, 0, axes, datum_table_value, refused, "value of the active datum table"},
    SysReadEntry{501, 0, rows, 0, axes, other, refused, "value of the active datum table, machine coordinates"},
    SysReadEntry{502, 0, rows, 0, axes, other, refused, "value of the preset table, active coordinate system"},
    SysReadEntry{503, 0, rows, 0, axes, other, refused, "value of the preset table"},
    SysReadEntry{504, 0, rows, 0, 0, other, refused, "basic rotation of the preset table"},
    SysReadEntry{505, 1, 1, 0, 0, datum_table_open, refused, "datum table selected: 0 no, 1 yes"},
    SysReadEntry{510, 1, 69, 0, 0, other, refused, "pallet table"},
    SysReadEntry{530, 1, 1, 0, 0, active_preset, run, "active row of the preset table"},
    SysReadEntry{530, 2, 2, 0, rows, other, refused, "write protection of a row of the preset table"},
    SysReadEntry{540, 1, 1, 0, 0, other, refused, "active row of the pallet preset table"},
};

}  // namespace

std::span<const SysReadEntry> all_sysread() { return entries; }

const SysReadEntry* find_sysread(int id, int nr, int idx) {
    // The last entry that does not begin behind ID and NR.
    const auto after = std::upper_bound(entries.begin(), entries.end(), std::pair(id, nr),
                                        [](const auto& key, const auto& e) { return key < std::pair(e.id, e.nr); });
    if (after == entries.begin()) return nullptr;
    const SysReadEntry& e = *std::prev(after);
    const bool found = e.id == id && nr <= e.nr_last && idx >= e.idx_first && idx <= e.idx_last;
    return found ? &e : nullptr;
}

}  // namespace obrys::dialect::heidenhain
