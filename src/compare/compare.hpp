#pragma once
/// Two streams held against each other: the same way of the tool, with the same feed, speed and all else that holds,
/// and the same cycles, contours and frames. Where the source texts stand and how calls are nested does not count.

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cl/record.hpp"
#include "motion/cursor.hpp"

namespace obrys::compare {

/// What is compared, each for itself; what a machine does first, then how the program says it.
enum class Aspect : std::uint8_t {
    motion,        ///< moves: places, centres, sweeps, rapid or feed, additional axes
    feed,          ///< of moves at feed
    spindle,       ///< while the tool moves
    coolant,       ///< the same
    tool,          ///< the same: number, edge, name, rise
    events,        ///< stops, dwells, functions, texts, tool changes, and where they stand between the moves
    datum,         ///< zeros while the tool moves
    frame,         ///< in which coordinates are programmed, while the tool moves
    tolerance,     ///< of the contour and how moves are joined, while the tool moves
    cycles,        ///< kinds, values and places
    compensation,  ///< sides, radii, programmed elements and corners
    count,
};
inline constexpr std::size_t aspect_count = static_cast<std::size_t>(Aspect::count);
[[nodiscard]] std::string_view name_of(Aspect a);
/// Motion to events: what the machine does. The others say how the program says it.
[[nodiscard]] constexpr bool is_done(Aspect a) { return a <= Aspect::events; }
/// It holds while the tool moves, and is compared move by move.
[[nodiscard]] constexpr bool holds(Aspect a) {
    return (a >= Aspect::feed && a <= Aspect::tool) || (a >= Aspect::datum && a <= Aspect::tolerance);
}

/// What holds while the tool moves.
struct Holding {
    cl::Feed feed;
    cl::Spindle spindle;
    cl::Coolant coolant;
    cl::ToolChange tool;
    /// Whose length is compensated: 0 none, -1 that of the tool, -2 values, else 1 + its number.
    std::int64_t length = 0;
    std::optional<geom::Vec3> length_by;  ///< the values
    cl::Datum datum;
    cl::Frame frame;
    cl::Tolerance tolerance;
    std::optional<cl::PathMode> path;
    bool operator==(const Holding&) const = default;
};

struct Item {
    cl::Step step;
    base::Span from;
    cl::StackId stack = 0;
    std::size_t moves = 0;  ///< that stand before it
    std::shared_ptr<const Holding> holding{};
};

struct Move {
    cl::Step step;  ///< Linear, Arc, Spline, Thread
    std::vector<cl::Axis> axes;
    std::shared_ptr<const Holding> holding;
    base::Span from;
    cl::StackId stack = 0;
};

/// A stream as far as it is compared. Moves that lead nowhere (`same_place`) and comments are left out, arcs that go on
/// about the same axis are one, and so is a tool that is called while it is in the spindle.
class Path {
public:
    explicit Path(double same_place) : same_place_(same_place) {}
    void take(const cl::Record& record);

    std::vector<Move> moves;
    bool compensates_length = false;  ///< anywhere
    std::vector<Item> events, cycles, contours;

private:
    void take_move(const cl::Record& record, const geom::Vec3& to);
    void take_axis(const cl::Axis& axis);
    void take_event(const cl::Record& record);
    void take_tool_data(const cl::Record& record, const cl::ToolData& data);
    [[nodiscard]] bool goes_on(const cl::Record& record) const;
    void hold();

    double same_place_;
    motion::Cursor cursor_;
    std::shared_ptr<const Holding> holding_ = std::make_shared<const Holding>();
    Holding marked_;                ///< the same, with numbers in the place of those that nobody knows
    geom::Vec3 arc_from_;           ///< where the last arc began
    std::optional<geom::Vec3> at_;  ///< end of the last move that counts
    cl::ToolLength length_there_;   ///< that was compensated there
    std::vector<cl::Axis> axes_;
    std::map<std::array<char, 8>, double> stands_;  ///< where additional axes stand
};

/// The first place where two streams differ in an aspect.
struct Difference {
    Aspect aspect = Aspect::motion;
    std::string what;  ///< "feed 200 mm/min, in B 150 mm/min"
    std::size_t move = 0;
    std::optional<base::Span> in_a, in_b;  ///< none: the stream has ended
    cl::StackId stack_a = 0, stack_b = 0;
};

struct Result {
    std::vector<Difference> first;  ///< at most one of each aspect
    std::size_t moves_a = 0, moves_b = 0;
    /// Moves up to which feed and all else that holds has been compared, where the moves behind do not stand side by
    /// side.
    std::optional<std::size_t> looked_to;
    [[nodiscard]] const Difference* of(Aspect a) const;
    /// It does not differ, and all of it has been looked at.
    [[nodiscard]] bool is_equal(Aspect a) const;
};

struct Tolerance {
    double length = 1e-4;  ///< mm, between places
    double angle = 1e-3;   ///< degrees, of additional axes and of values in degrees
    double share = 1e-6;   ///< of speeds, feeds and factors
};

[[nodiscard]] Result compare(const Path& a, const Path& b, const Tolerance& tolerance);

}  // namespace obrys::compare
