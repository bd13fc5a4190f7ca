#pragma once
/// What a program tells its control, as often as it tells it and in the order in which it acts: for those who print
/// what a control has heard (LinuxCNC's canonical calls, write/canon). No part of the stream: what it makes the machine
/// do stands there, once. Hearing changes nothing of the run.

#include <array>
#include <cstdint>
#include <optional>
#include <variant>

#include "base/function_ref.hpp"
#include "base/source.hpp"
#include "cl/technology.hpp"
#include "geom/frame.hpp"

namespace obrys::interp {

/// mm, of rotary axes degrees: X Y Z A B C U V W.
using Axes = std::array<double, 9>;

namespace heard {

/// The zero offset in force: selected, or set anew.
struct Zero {
    std::uint32_t number = 54;  ///< 54 … 59, 591 …: as of cl::Datum
    Axes at{};
    std::optional<Axes> shift{};   ///< of G92 and G52, where it is said again
    std::optional<double> turn{};  ///< degrees about Z, where it is said again
};
/// The zero offset that was in force already.
struct SameZero {};
/// Offsets of a zero that is not in force.
struct OtherZero {};
/// Of G92 and G52.
struct Shift {
    Axes by{};
    bool at_end = false;  ///< as the program ends
};
/// How coordinates are counted from here on: from programmed ones to those of the first zero in the stream. The stream
/// tells it with the first move that is programmed so, and machine coordinates (G53) may come before.
struct Counting {
    geom::Frame frame;
    Axes axes{};  ///< of A … W: what is added
};
struct ToolOffset {
    Axes by{};
};
struct Unit {
    bool inch = false;
};
struct Plane {
    int number = 17;  ///< 17, 18, 19
};
struct FeedKind {
    cl::FeedMode mode = cl::FeedMode::per_minute;
};
/// F as it stands in the program; of inverse time the feed per minute that the move comes to.
struct FeedNumber {
    double value = 0;
};
/// How moves are joined, the steps of cycles too; mm.
struct Joining {
    cl::PathKind kind = cl::PathKind::exact;  ///< `free` and `within` are one: what is rounded
    double tolerance = 0, merge = 0;
};
enum class Side : std::uint8_t { off, left, right };
struct Compensation {
    Side side = Side::off;
};
/// Coordinates, or those of circle centres, are incremental now and were absolute, or the other way round.
struct Increments {
    bool on = false, of_centres = false;
};
struct Diameters {
    bool on = false;
};
/// Canned cycles leave to R (G99), or to the level that they began at (G98).
struct RetractLevel {
    bool at_r = false;
};
struct NoMotion {  ///< G80
};
struct ToolWord {
    int number = 0;
};
struct ToolChanged {  ///< M6
};
struct ToolNumbered {  ///< M61
    int place = 0;     ///< in the tool list, 1 the first; 0: it is not there
};
/// A row of the tool list is written.
struct ToolEntry {
    int place = 0, number = 0;
    Axes offset{};
    double front_angle = 0, back_angle = 0;  ///< degrees
    int orientation = 0;
};
struct SpeedKind {
    double surface_limit = 0;  ///< G96: 1/min at most; 0: G97
};
struct SpeedNumber {
    double value = 0;
};
struct SpindleTurn {
    int direction = 0;  ///< as of cl::Spindle
};
struct SpindleOrient {
    double angle = 0;  ///< degrees
    int sense = 0;     ///< 0 the shorter way, 1 clockwise, 2 counter-clockwise
    double wait = 0;   ///< s that it may take; 0: nobody waits
};
struct CoolantWord {
    int function = 9;  ///< M7, M8, M9
};
/// A curve whose pieces follow.
struct Curve {
    int points = 0;  ///< control points
};
struct PalletChange {  ///< M60, M30
};

}  // namespace heard

using Heard =
    std::variant<heard::Zero, heard::SameZero, heard::OtherZero, heard::Shift, heard::Counting, heard::ToolOffset,
                 heard::Unit, heard::Plane, heard::FeedKind, heard::FeedNumber, heard::Joining, heard::Compensation,
                 heard::Increments, heard::Diameters, heard::RetractLevel, heard::NoMotion, heard::ToolWord,
                 heard::ToolChanged, heard::ToolNumbered, heard::ToolEntry, heard::SpeedKind, heard::SpeedNumber,
                 heard::SpindleTurn, heard::SpindleOrient, heard::CoolantWord, heard::Curve, heard::PalletChange>;

/// Takes what is heard between the records of the stream, in one order with them; `from`: the text that said it.
using Listener = base::FunctionRef<void(const Heard& what, const base::Span& from)>;

}  // namespace obrys::interp
