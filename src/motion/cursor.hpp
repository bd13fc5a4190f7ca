#pragma once
/// Folds records into steps. Points in mm, in the frame of the zero offset in force, as the stream has them.

#include <span>

#include "motion/position.hpp"
#include "motion/state.hpp"

namespace obrys::motion {

/// The tool of the list that a record means: by its number, else by its name; edge 0 is any. Null: none.
[[nodiscard]] const shop::Tool* find_tool(std::span<const shop::Tool> tools, const cl::ToolChange& wanted);

/// A move with what belongs to it.
struct Step {
    const cl::Record& record;
    std::uint64_t index;  ///< of moves, from 0
    geom::Vec3 from, to;  ///< NaN where not known
    /// Unit vectors along the tool, from the tip into the holder, at both ends; NaN before the first move.
    geom::Vec3 axis_from, axis_to;
    /// Where the additional axes stand at both ends (rotary: degrees, linear: mm), those that have been told to go
    /// somewhere: in the order in which they were first. NaN: not known.
    const cl::AxisEnds &axes_from, &axes_to;
    geom::Vec3 to_stock;  ///< from the frame in force to the stock's: Position
    bool rapid;
    const State& state;
};

/// One of them by its name; null: it has not been told to go anywhere.
[[nodiscard]] const cl::AxisEnd* find_axis(const cl::AxisEnds& axes, const std::array<char, 8>& name);

class Cursor {
public:
    Cursor() = default;
    /// `tools`: the job's list, which outlives the cursor.
    explicit Cursor(std::span<const shop::Tool> tools) : tools_(tools) {}

    /// Takes a record. A move comes back as a step, which holds until the next call; else nothing.
    std::optional<Step> take(const cl::Record& record);
    /// Behind the last record.
    [[nodiscard]] const State& state() const { return state_; }
    [[nodiscard]] const Position& position() const { return position_; }
    [[nodiscard]] std::uint64_t moves() const { return moves_; }

private:
    void take_modal(const cl::Record& record);
    void take_axes(const cl::Step& step);

    std::span<const shop::Tool> tools_;
    State state_;
    Position position_;
    geom::Vec3 axis_{NAN, NAN, NAN};
    cl::AxisEnds axes_from_, axes_;
    bool axes_moved_ = false;  ///< in the last move: `axes_from_` is that of its begin
    std::uint64_t moves_ = 0;
};

}  // namespace obrys::motion
