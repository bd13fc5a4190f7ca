#pragma once
/// Records of the stream about feed, spindle, tools and what else holds while the tool moves. Units stand with each
/// value; NaN: not known. Meaning: docs/cl-stream.md.

#include <cstdint>
#include <limits>
#include <optional>
#include <string>

#include "geom/vec.hpp"

namespace obrys::cl {

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

/// What a spindle is told that is not the one of the moves here (S2=, M2=3, SPOS[2]=): another one of a lathe, or of a
/// channel with several. Only what the program has said of it is known.
struct OtherSpindle {
    std::uint32_t number = 2;
    std::optional<double> speed{};           ///< 1/min, or m/min where the program counts so; NaN: not known
    std::optional<std::int8_t> direction{};  ///< as of Spindle
    std::optional<double> held{};            ///< degrees (SPOS[2]); NaN: where the machine is set to
    std::optional<double> limit{};           ///< highest speed, 1/min (LIMS[2])
    std::int64_t function = 0;               ///< another M function of it (M2=41); 0: none
    bool operator==(const OtherSpindle&) const = default;
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

/// How long a dwell is while the spindle does `s`, s; NaN: it is counted in revolutions, and how fast they come is not
/// known.
[[nodiscard]] inline double seconds_of(const Dwell& dwell, const Spindle& s) {
    if (dwell.seconds != 0 || dwell.revolutions == 0) return dwell.seconds;
    const bool turns = s.direction != 0 && s.mode == SpindleMode::rpm && s.speed > 0;
    return turns ? dwell.revolutions * 60 / s.speed : std::numeric_limits<double>::quiet_NaN();
}

/// The tool that will be wanted next: a magazine may bring it to where it is changed (T without M6, TOOL DEF).
struct ToolSelection {
    std::uint32_t number = 0;  ///< 0 where it is known by name only, or none is wanted
    std::string name;
    bool operator==(const ToolSelection&) const = default;
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

/// What flows from here on.
struct Coolant {
    bool flood = false, mist = false;
    bool operator==(const Coolant&) const = default;
};

enum class StopKind : std::uint8_t { program, optional, end };
struct Stop {
    StopKind kind = StopKind::program;
    bool pallets = false;  ///< pallets are changed with it (M60 and M30 of LinuxCNC)
    /// Of the end: the program may stay where it is, by the control's settings, and is not begun anew (M2 of FANUC).
    bool stays = false;
    bool operator==(const Stop&) const = default;
};

/// Text without effect: an operator message (`message`) or a note for the reader.
struct Comment {
    std::string text;
    bool message = false;
    bool terminal = false;  ///< a line for the operator's terminal ("(print, …)")
    bool operator==(const Comment&) const = default;
};

/// Auxiliary function passed to the machine: M or H with its number.
struct Auxiliary {
    char letter = 'M';
    std::int64_t number = 0;
    std::uint32_t extension = 0;  ///< of its address (H2=5); 0: none
    bool operator==(const Auxiliary&) const = default;
};

enum class OverrideKind : std::uint8_t { feed, spindle, adaptive_feed, feed_hold };
/// What the operator may change from here on (M48 … M53); `on` is how a program finds it.
struct Override {
    OverrideKind kind = OverrideKind::feed;
    bool on = true;
    bool operator==(const Override&) const = default;
};

/// A signal to the machine (M62 … M65, M67, M68; SINUMERIK's $A_OUT).
struct Output {
    std::uint32_t number = 0;
    bool analog = false;
    double value = 0;          ///< of digital ones 0 or 1
    bool with_motion = false;  ///< with the next move, else at once
    bool operator==(const Output&) const = default;
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

}  // namespace obrys::cl
