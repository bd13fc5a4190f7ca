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
    geom::Vec3 to_stock;  ///< from the frame in force to the stock's: Position
    bool rapid;
    const State& state;
};

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

    std::span<const shop::Tool> tools_;
    State state_;
    Position position_;
    std::uint64_t moves_ = 0;
};

}  // namespace obrys::motion
