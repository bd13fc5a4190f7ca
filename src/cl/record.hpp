#pragma once
/// The cutter-location stream: what a program makes the machine do, whatever control it was written for.
/// Meaning of each record: docs/cl-stream.md. Lengths in millimetres, angles in radians, workpiece frame, tool tip
/// (the point the control moves). On lathes x is a radius. A coordinate that is not known yet is NaN.

#include <array>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "base/function_ref.hpp"
#include "base/source.hpp"
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
    bool operator==(const Spindle&) const = default;
};

struct ToolChange {
    std::uint32_t number = 0;  ///< 0 where the tool is known by name only, or none is in the spindle
    std::uint32_t edge = 0;    ///< cutting edge (D); 0 = no offsets
    std::string name;
    bool operator==(const ToolChange&) const = default;
};

/// Synchronised thread pass: moves like Linear, spindle and axis coupled.
struct Thread {
    geom::Vec3 to;
    double pitch = 0;  ///< mm per revolution along the move; negative = left hand
    bool rigid_tap = false;
    bool operator==(const Thread&) const = default;
};

enum class CoolantState : std::uint8_t { off, flood, mist };
struct Coolant {
    CoolantState state = CoolantState::off;
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
    bool operator==(const Comment&) const = default;
};

/// Zero of the workpiece frame in machine coordinates, from here on; NaN where it is not known.
struct Datum {
    std::uint32_t number = 0;  ///< 54, 505; 500: none selected; 1000 …: presets 0 …; 0 = machine frame itself
    geom::Vec3 origin;
    bool operator==(const Datum&) const = default;
};

enum class Filter : std::uint8_t { none, finishing, semi_finishing, roughing, precision };
/// How far the control may leave the contour to move smoothly, from here on (HEIDENHAIN cycle 32, SINUMERIK CYCLE832).
struct Tolerance {
    double contour = 0;  ///< mm; 0: what the machine is set to
    double rotary = 0;   ///< degrees; 0: what the machine is set to
    Filter filter = Filter::none;
    bool operator==(const Tolerance&) const = default;
};

/// Auxiliary function passed to the machine: M or H with its number.
struct Auxiliary {
    char letter = 'M';
    std::int64_t number = 0;
    bool operator==(const Auxiliary&) const = default;
};

struct CycleParameter {
    std::string name;
    double value = 0;
    bool operator==(const CycleParameter&) const = default;
};
/// The records up to the matching CycleEnd are the expansion of this cycle call.
struct CycleBegin {
    std::string name;
    std::vector<CycleParameter> parameters;
    bool operator==(const CycleBegin&) const = default;
};
struct CycleEnd {
    bool operator==(const CycleEnd&) const = default;
};

/// One step of the tool's life. Closed on purpose: a new kind must break every visitor that names all kinds.
using Step = std::variant<Linear, Arc, Spline, Axis, Thread, Dwell, Feed, Spindle, ToolChange, Coolant, Stop, Comment,
                          Datum, Tolerance, Auxiliary, CycleBegin, CycleEnd>;

/// Identifies a call stack in `CallStacks`; 0 is the main program.
using StackId = std::uint32_t;

struct Record {
    Step step;
    base::Span from;    ///< the source text that caused it
    StackId stack = 0;  ///< where it was called from
};

/// Takes records one by one; memory does not grow with the length of the program.
using Sink = base::FunctionRef<void(const Record&)>;

[[nodiscard]] inline bool is_move(const Step& s) {
    return std::holds_alternative<Linear>(s) || std::holds_alternative<Arc>(s) || std::holds_alternative<Spline>(s) ||
           std::holds_alternative<Thread>(s);
}
[[nodiscard]] inline bool is_rapid(const Step& s) {
    const auto* linear = std::get_if<Linear>(&s);
    return linear != nullptr && linear->rapid;
}

}  // namespace obrys::cl
