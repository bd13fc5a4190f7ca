#pragma once
/// Tools as the shop lists them. File format: docs/job-file.md.

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/diagnostic.hpp"
#include "base/source.hpp"
#include "geom/contour.hpp"

namespace obrys::shop {

enum class ToolKind : std::uint8_t {
    groove,   ///< grooving or parting insert: width, corner radii, reference corner
    turning,  ///< ISO insert: nose radius, cutting edge orientation 1-9, entering angle, tip angle
    other,    ///< named and numbered only. With a radius it is a mill whose form its file does not say: `assumed_kind`
    // Milling and drilling tools turn about their own axis; the programmed point is the lowest point of that axis.
    end_mill,      ///< radius
    ball,          ///< radius, round end of that radius
    bull_nose,     ///< radius, corner_radius at most that
    drill,         ///< radius, point_angle
    centre_drill,  ///< as drill
    countersink,   ///< radius, point_angle between its flanks, tip_diameter of its flat tip
    tap,           ///< radius, pitch; flat
    reamer,        ///< radius; flat
    chamfer,       ///< as countersink
    t_slot,        ///< radius, width of the disc, corner_radius on both its rims, neck_diameter above it
    form,          ///< profile
};
/// mm; the length of a shorter tool was not measured from the gauge plane.
inline constexpr double least_gauge_length = 10;
[[nodiscard]] constexpr bool is_milling(ToolKind kind) { return kind > ToolKind::other; }
enum class ReferenceCorner : std::uint8_t {
    left,
    right
};  ///< smaller or larger z (face: nearer to or farther from the axis)
/// Where a grooving blade goes on from its cutting edge; orientation 9 of a turning insert knows out and in.
enum class BladeDirection : std::uint8_t {
    out,   ///< towards +x: cuts from outside
    in,    ///< towards -x: cuts inside a bore
    face,  ///< towards +z: cuts the right face; the width lies along x
};

/// What a line of a LinuxCNC tool table says, for #5400 … #5413, G43 and G41 D: lengths in mm, angles in degrees. The
/// letters are the table's: LinuxCNC documentation, "Tool Table", "Lathe User Information".
struct TableTool {
    std::uint32_t index = 0;         ///< place in the control's list, 1 for the first line; `CHANGE_TOOL` names it
    std::int32_t pocket = 0;         ///< P
    std::array<double, 9> offset{};  ///< X Y Z A B C U V W
    double diameter = 0;             ///< D, as written: of a mill, or of a lathe tool's nose
    double front_angle = 0, back_angle = 0;  ///< I, J: from +Z towards +X
    int orientation = 0;                     ///< Q, 0-9 in the table's count, which is not that of Tool::orientation
    bool operator==(const TableTool&) const = default;
};

/// One of the stacked bodies of a shank or holder, mm: a cylinder where the diameters agree, else a cone.
struct ToolBody {
    double lower_diameter = 0, upper_diameter = 0, length = 0;
    bool operator==(const ToolBody&) const = default;
};
[[nodiscard]] double height_of(const std::vector<ToolBody>& bodies);

struct Tool {
    std::uint32_t number = 0;
    std::string name;
    std::uint32_t edge = 1;   ///< D
    bool edge_given = false;  ///< else 1, or its own number where a control's T names an offset
    ToolKind kind = ToolKind::other;
    // grooving insert, mm
    double width = 0;          ///< also of a T-slot cutter's disc
    double corner_radius = 0;  ///< both corners, unless the next two say otherwise; mills: R2, a ball where = radius
    double corner_radius_left = 0, corner_radius_right = 0;
    ReferenceCorner reference = ReferenceCorner::left;
    BladeDirection direction = BladeDirection::out;
    double cutting_depth = 0;  ///< length of the blade, 0 = not limited
    // turning insert
    double nose_radius = 0;      ///< mm
    int orientation = 3;         ///< 1-9, position of the imaginary tip P as seen by the nose centre
    double tip_angle = 80;       ///< degrees
    double entering_angle = 95;  ///< degrees, main cutting edge to the feed direction
    double edge_length = 12;     ///< mm
    /// How far the insert goes on from its tip was said (edge_length, cutting_depth) and is not the default.
    bool reach_given = false;
    std::vector<geom::Contour> bodies;  ///< holder of a turning tool: as `outline`, without the insert
    // any
    double radius = 0;           ///< mm, milling tools
    bool has_no_radius = false;  ///< radius 0 is what its source says; else 0 is not known
    double length = 0;           ///< mm, length 1: of a mill from the gauge plane (spindle nose) to its tip
    // milling tools, mm; with cutting_length, point_angle, pitch and teeth below
    double tip_diameter = 0, neck_diameter = 0;
    /// Form tools: half section, x the radius, y the height above the tip, which starts at 0 and never decreases.
    std::vector<geom::Vertex> profile;
    std::vector<ToolBody> shank;   ///< from the end of the cutting edges upwards
    std::vector<ToolBody> holder;  ///< from the end of the shank upwards
    std::optional<bool> plunges;   ///< cuts at its centre too; not said: `may_plunge`
    bool left_hand = false;        ///< cuts while the spindle turns counter-clockwise (M4)
    // milling and drilling tools as HEIDENHAIN tool tables have them; a delta is added to its dimension
    double delta_length = 0, delta_radius = 0, delta_corner_radius = 0;  ///< mm: DL, DR, DR2
    std::uint32_t index = 0;  ///< 5.1 has index 1; its edge is index + 1, so number and edge name it alone
    std::string type;         ///< TYP as written: "MILL", "DRILL", "9"; empty: not said
    std::optional<double> cutting_length, pitch;      ///< mm: LCUTS, PITCH; from the tip, the point included
    std::optional<double> plunge_angle, point_angle;  ///< degrees: ANGLE (ramp, at most), T-ANGLE
    std::optional<double> max_speed;                  ///< 1/min: NMAX
    int teeth = 0;                                    ///< CUT., 0 = not said
    bool locked = false;                              ///< TL
    std::optional<std::uint32_t> replacement;         ///< RT, number of the tool that takes its place
    std::string cutter_material, cutting_data;        ///< TMAT; CDT, the name of its cutting data table
    std::optional<TableTool> table;                   ///< of tools from a LinuxCNC table
    std::map<int, double> parameters;                 ///< $TC_DPn as read, n = 1 … 25, from TOA files
    std::string assumed;                              ///< what its file does not say and was assumed; empty: nothing
    base::Span where;                                 ///< where it is defined
    bool operator==(const Tool&) const = default;
};

/// Outline of the cutting part in the (z, x) plane relative to the programmed point, mm: counter-clockwise, closed.
/// x points away from the turning axis. An empty contour where the kind has none or the dimensions make no shape.
/// A blade without cutting depth is 1000 mm long. With corner radii the programmed point is the sharp corner without
/// them.
[[nodiscard]] geom::Contour outline(const Tool& tool);
/// The part of the outline that is there whatever was left to defaults: where `reach_given` is false, of blades inside
/// a bore and of inserts, the corners or the nose alone. Other blades go on until their holder begins.
[[nodiscard]] geom::Contour sure_outline(const Tool& tool);

/// Kind by which a tool's removal is computed: its own; of `other` with a radius end mill, bull nose or ball by its
/// corner radius, which nobody said: who uses it tells the user. `other` where there is no radius.
[[nodiscard]] ToolKind assumed_kind(const Tool& tool);
/// As written in job files: "end-mill"; "groove", "turning", "other" too.
[[nodiscard]] std::string_view kind_word(ToolKind kind);

/// What makes no tool of a milling tool's dimensions: the key of the job file and a text for the user; both empty where
/// nothing does. Of other kinds nothing is said.
struct DimensionFault {
    std::string_view key;
    std::string text;
    [[nodiscard]] bool ok() const { return key.empty(); }
};
[[nodiscard]] DimensionFault dimension_fault(const Tool& tool);

/// Height of the cone below the full diameter, mm: of drills, countersinks, chamfer mills; 0 of other kinds.
[[nodiscard]] double point_height(const Tool& tool);
/// Whether it may go straight down into full material: as `plunges` says; else not with a plunge angle below 90
/// degrees, not taps, reamers, T-slot cutters, not what has a flat tip or a profile that begins off the axis.
[[nodiscard]] bool may_plunge(const Tool& tool);
/// From the tip to the end of the cutting edges, mm: as given; a T-slot cutter's width, a profile's height; else
/// length less shank and holder; nothing where that is not above 0.
[[nodiscard]] std::optional<double> cutting_height(const Tool& tool);

/// $TC_DPn: as read; else what the dimensions say for n = 2 (orientation), 3 (length 1) and 6 (radius); else nothing.
[[nodiscard]] std::optional<double> parameter(const Tool& tool, int n);

/// The tools of `first` and those of `second` whose number and edge `first` does not have, in the order of number and
/// edge. A tool of both keeps what `first` says and takes parameters that only `second` has.
[[nodiscard]] std::vector<Tool> merge_tools(std::vector<Tool> first, const std::vector<Tool>& second);

}  // namespace obrys::shop
