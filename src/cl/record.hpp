#pragma once
/// The cutter-location stream: what a program makes the machine do, whatever control it was written for.
/// Meaning of each record: docs/cl-stream.md. Lengths in millimetres, angles in radians, workpiece frame, tool tip
/// (the point the control moves). On lathes x is a radius. A coordinate that is not known yet is NaN.

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "base/function_ref.hpp"
#include "base/shared_value.hpp"
#include "base/source.hpp"
#include "cl/cycle.hpp"
#include "geom/frame.hpp"
#include "geom/vec.hpp"

namespace obrys::cl {

/// Straight move; `axis` is the unit vector along the tool, from the tip into the holder.
struct Linear {
    geom::Vec3 to;
    geom::Vec3 axis{0, 0, 1};
    bool rapid = false;
    bool operator==(const Linear&) const = default;
};

/// Circular or helical move about `normal` through `centre`; `sweep` positive counter-clockwise seen against `normal`.
/// `to - from` along `normal` is the helix' rise. |sweep| may exceed a full turn.
struct Arc {
    geom::Vec3 to;
    geom::Vec3 centre;
    geom::Vec3 normal{0, 0, 1};
    double sweep = 0;
    bool rapid = false;
    bool operator==(const Arc&) const = default;
};

/// One additional axis on a Spline: ((k3 t + k2) t + k1) t + to, degrees where rotary, else mm.
struct SplineAxis {
    std::array<char, 8> name{};  ///< as the control names it ("A", "C2"), zero-padded
    double to = 0, k1 = 0, k2 = 0, k3 = 0;
    bool rotary = true;
    bool operator==(const SplineAxis&) const = default;
};

/// Cubic move: x, y and z are ((k3 t + k2) t + k1) t + to, the parameter t runs from 1 at the start to 0 at the end.
/// Where the move starts follows from the record itself; cl/spline.hpp says how far that is from where the tool stands.
struct Spline {
    geom::Vec3 to;
    geom::Vec3 k1, k2, k3;
    geom::Vec3 axis{0, 0, 1};      ///< as of Linear, at the end
    std::vector<SplineAxis> axes;  ///< at most two
    bool operator==(const Spline&) const = default;
};

/// Position that an additional axis (rotary: degrees; linear: mm) reaches with the next Linear or Arc.
struct Axis {
    std::array<char, 8> name{};  ///< as the control names it ("C", "C2"), zero-padded
    double to = 0;
    bool rotary = false;
    /// The control counts where this rotary axis stands (tilted working plane): points stay in the workpiece frame.
    /// Else points are in the machine's directions, as though the axis stood at 0.
    bool counted = false;
    bool operator==(const Axis&) const = default;
};

struct Dwell {
    double seconds = 0;
    double revolutions = 0;  ///< of the spindle; used where seconds is 0
    bool operator==(const Dwell&) const = default;
};

enum class FeedMode : std::uint8_t {
    per_minute,    ///< mm/min
    per_rev,       ///< mm per spindle revolution
    inverse_time,  ///< 1/min: the move takes 1/value minutes
};
struct Feed {
    double value = 0;
    FeedMode mode = FeedMode::per_minute;
    bool operator==(const Feed&) const = default;
};

enum class SpindleMode : std::uint8_t {
    rpm,      ///< speed in 1/min
    surface,  ///< constant cutting speed in m/min (G96)
};
struct Spindle {
    double speed = 0;  ///< never negative
    SpindleMode mode = SpindleMode::rpm;
    std::int8_t direction = 0;  ///< +1 clockwise (M3), -1 counter-clockwise (M4), 0 standing
    double limit = 0;           ///< highest speed in 1/min while mode is surface; 0 = none
    std::optional<double>
        held{};  ///< degrees at which it is held, standing (M19 R, SPOS); NaN: where the machine is set to
    bool operator==(const Spindle&) const = default;
};

struct ToolChange {
    std::uint32_t number = 0;  ///< 0 where the tool is known by name only, or none is in the spindle
    std::uint32_t edge = 0;    ///< cutting edge (D); 0 = no offsets
    std::string name;
    double raised = 0;  ///< mm by which the tip stands above the points of the moves, along the tool (HEIDENHAIN DL)
    double wider = 0;   ///< mm that radius compensation takes its radius to be larger (HEIDENHAIN DR)
    bool standing = false;     ///< it is in the spindle already: no change is made (M61; the job says so)
    bool with_length = false;  ///< its length is compensated from here on, without a word of its own
    std::uint32_t offset = 0;  ///< number of its offset, where the program names that (T0203: 3); 0: it names an edge
    bool operator==(const ToolChange&) const = default;
};

/// What the program itself says a tool is (TOOL DEF).
struct ToolData {
    std::uint32_t number = 0, edge = 1;
    std::optional<double> length{}, radius{};  ///< mm; neither: something else of it (wear, other axes, its kind)
    bool operator==(const ToolData&) const = default;
};

/// Compensation of the tool's length from here on, where a program says it apart from the tool (G43 H); points are
/// those of the tip all the same.
struct ToolLength {
    std::int8_t sense = 0;           ///< +1 added (G43), -1 subtracted (G44), 0 off (G49)
    std::uint32_t offset = 0;        ///< its number (H); 0: `by` says it
    std::optional<geom::Vec3> by{};  ///< mm (G43.1)
    bool operator==(const ToolLength&) const = default;
};

enum class PlaceKind : std::uint8_t {
    coordinates,  ///< as the program says them (G53, SUPA, M91)
    home,         ///< a reference point (G28, G74)
    fixed,        ///< another place that the machine keeps (G75)
};
/// The next move leads to a place of the machine along these axes, however the workpiece lies.
struct MachinePlace {
    PlaceKind kind = PlaceKind::coordinates;
    std::uint8_t number = 1;       ///< of reference points and fixed ones: which
    std::array<bool, 3> axes{};    ///< X, Y, Z go there
    geom::Vec3 to{NAN, NAN, NAN};  ///< machine coordinates as the control counts them, mm; NaN: not known
    bool operator==(const MachinePlace&) const = default;
};

/// Synchronised thread pass: moves like Linear, spindle and axis coupled.
struct Thread {
    geom::Vec3 to;
    double pitch = 0;  ///< mm per revolution along the move; negative = left hand
    bool rigid_tap = false;
    bool operator==(const Thread&) const = default;
};

/// What flows from here on.
struct Coolant {
    bool flood = false, mist = false;
    bool operator==(const Coolant&) const = default;
};

enum class StopKind : std::uint8_t { program, optional, end };
struct Stop {
    StopKind kind = StopKind::program;
    bool operator==(const Stop&) const = default;
};

/// Text without effect: an operator message (`message`) or a note for the reader.
struct Comment {
    std::string text;
    bool message = false;
    bool terminal = false;  ///< a line for the operator's terminal ("(print, …)")
    bool operator==(const Comment&) const = default;
};

/// Zero of the workpiece frame in machine coordinates, from here on, as the program selects it or as it is set anew;
/// NaN where it is not known: along such an axis it is taken to lie where the zero before lay.
struct Datum {
    std::uint32_t number = 0;  ///< 54, 505; 500: none selected; 1000 …: presets 0 …; 0 = machine frame itself
    geom::Vec3 origin;
    bool operator==(const Datum&) const = default;
};

/// What the program itself says a zero is (G10 L2); Datum tells what follows for the moves.
struct DatumData {
    std::uint32_t number = 0;          ///< 0: what is added to all of them
    geom::Vec3 origin{NAN, NAN, NAN};  ///< machine coordinates, mm; NaN: stays as it is, or is not known
    std::optional<double> turn{};      ///< radians about Z
    bool added = false;                ///< `origin` is added to where it lay (G91 G10)
    bool operator==(const DatumData&) const = default;
};

enum class FrameKind : std::uint8_t {
    datum,       ///< what the selected zero has besides its place: a turn
    shift,       ///< G52, G92, TRANS, cycle 7
    rotation,    ///< G68, ROT, cycle 10
    mirror,      ///< G51.1, MIRROR, cycle 8
    scaling,     ///< G51, SCALE, cycle 11; of all axes or of each
    plane,       ///< a tilted working plane
    programmed,  ///< several of these, which the control keeps as one frame
};
struct FramePart {
    FrameKind kind = FrameKind::shift;
    geom::Frame frame;
    bool operator==(const FramePart&) const = default;
};
/// How coordinates are programmed from here on: the product of the parts, the first the outermost, takes them into the
/// workpiece frame, where the points of the stream are all the same. No part: they are programmed there.
struct Frame {
    std::vector<FramePart> parts;
    bool operator==(const Frame&) const = default;
};

enum class Filter : std::uint8_t { none, finishing, semi_finishing, roughing, precision };
/// How far the control may leave the contour to move smoothly, from here on (HEIDENHAIN cycle 32, SINUMERIK CYCLE832).
struct Tolerance {
    double contour = 0;  ///< mm; 0: what the machine is set to
    double rotary = 0;   ///< degrees; 0: what the machine is set to
    Filter filter = Filter::none;
    bool operator==(const Tolerance&) const = default;
};

enum class PathKind : std::uint8_t {
    exact,       ///< through every point
    exact_stop,  ///< the same, standing still there
    free,        ///< corners are rounded as far as speed and accelerations need
    within,      ///< the same, within a tolerance
};
/// How the control goes from one move to the next, from here on, where a program says it (G61, G64, G641).
struct PathMode {
    PathKind kind = PathKind::exact;
    double tolerance = 0;   ///< mm, of `within`; 0: what the machine is set to
    double merge = 0;       ///< mm within which moves are joined to one (G64 Q); 0: none
    std::uint16_t way = 0;  ///< of several that a control has for it: 642 … 645; 0: there is one
    bool operator==(const PathMode&) const = default;
};

/// Auxiliary function passed to the machine: M or H with its number.
struct Auxiliary {
    char letter = 'M';
    std::int64_t number = 0;
    bool operator==(const Auxiliary&) const = default;
};

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
    feed_override,       ///< number: 1 allowed, 0 not
    speed_override,
    adaptive_feed,
    feed_hold,
    synchronised,   ///< number: 1 begins, value: mm per revolution; 0 ends
    tap_there,      ///< number: 1 the next move is the way down of a rigid tap
    probing,        ///< number: 1 begins, 0 ends
    coolant,        ///< number: 7, 8, 9
    dwell,          ///< value: seconds as programmed
    curve,          ///< number: control points of the curve whose pieces follow
    output_bit,     ///< number: output; value: 1 on, 0 off, + 2 with the next motion
    output_value,   ///< number: output; value; value 1: 1 with the next motion
    pallet_change,  ///< M60, M30
};
/// Only where someone asks for it (interp::Environment::tell_settings): moves are complete without it.
struct Setting {
    SettingKind kind = SettingKind::unit;
    std::int32_t number = 0;
    std::int32_t second = 0;  ///< tool_entry: number of the tool
    std::array<double, 12> values{};
    bool operator==(const Setting&) const = default;
};

struct CycleParameter {
    std::string name;
    double value = 0;
    bool operator==(const CycleParameter&) const = default;
};
/// What a cycle does, the same at all its places.
struct Cycle {
    CycleKind kind = CycleKind::drill;
    geom::Frame plane;                    ///< (u, v, w) of the working plane -> frame of the stream
    std::vector<CycleValue> values;       ///< each role at most once; counted in `plane`
    std::string name;                     ///< a remark: as the source spells it
    std::vector<CycleParameter> written;  ///< a remark: its parameters there, in the source's own units
    bool operator==(const Cycle&) const = default;
};

enum class CycleCall : std::uint8_t {
    single,   ///< where it stands in the program
    modal,    ///< by every block that positions, until it is cancelled (G81, M89)
    pattern,  ///< at the points of a pattern
};
/// The records up to the matching CycleEnd are this cycle at one place; brackets may lie one in another (the points of
/// a pattern). What lies inside: docs/cl-stream.md.
struct CycleBegin {
    base::SharedValue<Cycle> cycle;
    geom::Vec3 place;  ///< where the tool stands
    CycleCall call = CycleCall::single;
    std::uint64_t pass = 1;    ///< of a pattern's points, of the holes that one block makes
    std::uint64_t passes = 1;  ///< of them all
    bool operator==(const CycleBegin&) const = default;
};
struct CycleEnd {
    bool operator==(const CycleEnd&) const = default;
};

enum class CompensationSide : std::uint8_t {
    left,
    right
};  ///< of the contour, seen along it against the plane's normal
/// How the tool comes to the contour.
enum class Approach : std::uint8_t {
    normal,  ///< to the point square to the contour's start (NORM)
    around,  ///< the same, about the start where it lies behind it (KONT)
    smooth,  ///< by a line or an arc that ends along the contour (APPR, G147)
};
/// Radius compensation is in force for the records up to the matching CompensationEnd. Their points are the tool's
/// path; Programmed tells the contour.
struct CompensationBegin {
    CompensationSide side = CompensationSide::left;
    double radius = 0;         ///< mm; negative: the other side
    std::uint32_t offset = 0;  ///< D, or the tool's edge; 0: none
    Approach approach = Approach::normal;
    bool sharp = false;          ///< outer corners go out to the crossing of the parallels (G451); else arcs
    geom::Vec3 normal{0, 0, 1};  ///< of the plane in which it acts
    bool operator==(const CompensationBegin&) const = default;
};
struct CompensationEnd {
    bool operator==(const CompensationEnd&) const = default;
};

enum class Corner : std::uint8_t {
    none,
    chamfer,      ///< by its length (CHF)
    chamfer_leg,  ///< by its legs (CHR, ,C)
    rounding,     ///< by its radius (RND, ,R)
};
/// An element of the contour as it is programmed, where compensation or a corner makes another path of it: the moves
/// with its source up to the next Programmed. Straight where `sweep` is 0, else as Arc.
struct Programmed {
    geom::Vec3 from, to;
    geom::Vec3 centre, normal{0, 0, 1};
    double sweep = 0;
    bool rapid = false;
    Corner corner = Corner::none;  ///< at its end
    double size = 0;               ///< of that, mm in the programmed frame
    double corner_feed = 0;        ///< of that alone (FRC, RND F), as Feed counts it; 0: none of its own
    bool operator==(const Programmed&) const = default;
};

enum class LeadKind : std::uint8_t {
    tangent_line,  ///< along the contour's tangent (APPR LT)
    normal_line,   ///< square to the contour (APPR LN)
    tangent_arc,   ///< on an arc that ends along the contour (APPR CT)
    arc_and_line,  ///< the same, with a line that is tangential to the arc (APPR LCT)
};
/// The records up to the matching LeadEnd are the control's own way onto a contour or off it.
struct LeadBegin {
    LeadKind kind = LeadKind::tangent_line;
    bool onto = true;  ///< the contour; else off it
    geom::Vec3 at;     ///< onto: the contour's first point; off by arc_and_line: the point to go to; else where it ends
    double length = 0;  ///< of the line, mm
    double radius = 0;  ///< of the arc that the tool's centre runs, mm; negative: on the other side
    double angle = 0;   ///< of the arc, radians
    bool rapid = false;
    double feed = 0;  ///< of it alone, as Feed counts it; 0: none of its own
    bool operator==(const LeadBegin&) const = default;
};
struct LeadEnd {
    bool operator==(const LeadEnd&) const = default;
};

enum class PartKind : std::uint8_t {
    call,        ///< of a program
    label,       ///< of a section of the same program (CALL LBL)
    repetition,  ///< of a section that has been run before (REP, REPEAT): its further passes
};
/// The records up to the matching PartEnd come from a part of the program that is called or repeated; parts lie one in
/// another. A Stop that ends the program ends them all.
struct PartBegin {
    PartKind kind = PartKind::call;
    std::string name;          ///< of the program or label, as the control names it; empty: it has none
    std::uint64_t pass = 1;    ///< of a call that is repeated, from 1; of a repetition from 2
    std::uint64_t passes = 1;  ///< of them all
    bool operator==(const PartBegin&) const = default;
};
struct PartEnd {
    bool operator==(const PartEnd&) const = default;
};

/// One step of the tool's life. Closed on purpose: a new kind must break every visitor that names all kinds.
using Step =
    std::variant<Linear, Arc, Spline, Axis, MachinePlace, Thread, Dwell, Feed, Spindle, ToolChange, ToolData, DatumData,
                 ToolLength, Coolant, Stop, Comment, Datum, Frame, Tolerance, PathMode, Auxiliary, Setting, CycleBegin,
                 CycleEnd, PartBegin, PartEnd, CompensationBegin, CompensationEnd, Programmed, LeadBegin, LeadEnd>;

/// Identifies a call stack in `CallStacks`; 0 is the main program.
using StackId = std::uint32_t;

struct Record {
    Step step;
    base::Span from;    ///< the source text that caused it; along a contour cycle's contour: the block of that element
    StackId stack = 0;  ///< where it was called from
};

/// Takes records one by one; memory does not grow with the length of the program.
using Sink = base::FunctionRef<void(const Record&)>;

[[nodiscard]] inline bool is_move(const Step& s) {
    return std::holds_alternative<Linear>(s) || std::holds_alternative<Arc>(s) || std::holds_alternative<Spline>(s) ||
           std::holds_alternative<Thread>(s);
}
[[nodiscard]] inline bool is_rapid(const Step& s) {
    if (const auto* arc = std::get_if<Arc>(&s)) return arc->rapid;
    const auto* linear = std::get_if<Linear>(&s);
    return linear != nullptr && linear->rapid;
}

}  // namespace obrys::cl
