#pragma once
/// What LinuxCNC's canonical calls say beside the stream's other records.

#include <array>
#include <cstdint>

namespace obrys::cl {

/// What a program sets besides its moves: what number and values say stands with each kind. Lengths in mm, angles in
/// degrees, axes in the order X Y Z A B C U V W.
enum class SettingKind : std::uint8_t {
    frame,           ///< values: 3 x 4, row by row: programmed coordinates (mm) -> stream
    axis_offsets,    ///< values 3 … 8: what is added to programmed A … W
    unit,            ///< number: 0 mm, 1 inch
    plane,           ///< number: 17, 18, 19
    feed_mode,       ///< number: 93, 94, 95
    feed_rate,       ///< value: F as it stands in the program
    datum,           ///< number: 1 … 9 of G54 … G59.3; values: its offsets
    datum_rotation,  ///< value: degrees about Z
    datum_kept,      ///< number: selected while it was active
    datum_written,   ///< number: offsets set while another one is active
    shift,           ///< values: G92 and G52; number: 1 as the program ends
    tool_offset,     ///< values
    path_mode,       ///< number: 0 exact path, 1 exact stop, 2 blended; values: tolerance, tolerance of merged lines
    compensation,    ///< number: 0 off, 1 left, 2 right
    incremental,     ///< number: 0 absolute, 1 incremental
    centre_incremental,  ///< number: circle centres absolute 0, incremental 1
    diameter,            ///< number: 0 radius, 1 diameter
    retract_clearance,   ///< number: canned cycles leave to the level they began at 0, to R 1
    motion_off,          ///< G80
    tool_selected,       ///< number: T
    tool_changed,        ///< number: place in the tool list, 1 the first; M6
    tool_numbered,       ///< number: as tool_changed, M61
    tool_entry,          ///< number: place in the tool list; values: offsets, diameter, front angle, back angle
    surface_speed,       ///< number: 96, 97; value: highest speed
    spindle_speed,       ///< value: S
    spindle_turn,        ///< number: +1, -1, 0
    spindle_orient,      ///< number: sense; values: degrees, s that it may take
    synchronised,        ///< number: 1 begins, value: mm per revolution; 0 ends
    tap_there,           ///< number: 1 the next move is the way down of a rigid tap
    coolant,             ///< number: 7, 8, 9
    dwell,               ///< value: seconds as programmed
    curve,               ///< number: control points of the curve whose pieces follow
    pallet_change,       ///< M60, M30
};
/// Only where someone asks for it (interp::Environment::tell_settings): moves are complete without it.
struct Setting {
    SettingKind kind = SettingKind::unit;
    std::int32_t number = 0;
    std::int32_t second = 0;  ///< tool_entry: number of the tool
    std::array<double, 12> values{};
    bool operator==(const Setting&) const = default;
};

}  // namespace obrys::cl
