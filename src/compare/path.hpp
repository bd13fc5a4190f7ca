#pragma once
/// A stream as far as it is compared: its moves with what holds there, and what stands between them.

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "cl/record.hpp"
#include "compare/kept.hpp"
#include "motion/cursor.hpp"

namespace obrys::compare {

/// What holds while the tool moves.
struct Holding {
    cl::Feed feed;
    cl::Spindle spindle;
    cl::Coolant coolant;
    cl::ToolChange tool;
    /// Whose length is compensated: 0 none, -1 that of the tool, -2 and -4 values, else 1 + its number or -3 times
    /// that.
    std::int64_t length = 0;
    std::optional<geom::Vec3> length_by;  ///< the values
    cl::Datum datum;
    cl::Frame frame;
    cl::Tolerance tolerance;
    std::optional<cl::PathMode> path;
    bool leads_out = false;  ///< at rapid, of a hole that was tapped: the spindle turns, or stands as before the tap
    bool operator==(const Holding&) const = default;
};

/// Two moves with this are the same as one that leads as far: none takes a time of its own, none ends standing still.
[[nodiscard]] bool can_be_joined(const Holding& holding, bool rapid);

/// How the axes turn to the tilted plane in force, where the control does that by itself and no move tells it.
[[nodiscard]] const cl::PlaneTurn* turn_by_control(const cl::Frame& frame);

struct Item {
    cl::Step step;
    base::Span from;
    cl::StackId stack = 0;
    std::size_t moves = 0;  ///< that stand before it
    std::shared_ptr<const Holding> holding{};
    bool changes_side = false;  ///< the end of a compensated contour, in whose block the next one begins
};

struct Move {
    cl::Step step;      ///< Linear, Arc, Spline, Thread
    cl::AxisEnds axes;  ///< those that move
    std::shared_ptr<const Holding> holding;
    base::Span from;
    cl::StackId stack = 0;
};

/// Moves that lead nowhere (`same_place`) and comments are left out, arcs that go on about the same axis are one, and
/// so is a tool that is called while it is in the spindle.
class Path {
public:
    /// `joins_freely`: until the stream says how moves are joined.
    explicit Path(double same_place, bool is_axis_by_axis = false, bool joins_freely = false)
        : same_place_(same_place), is_axis_by_axis_(is_axis_by_axis), joins_freely_(joins_freely) {}
    void take(const cl::Record& record);
    /// Who compares as the records come has done with those before.
    void forget(std::size_t move, const std::array<std::size_t, 5>& items) {
        moves.forget(move), events.forget(items[0]), cycles.forget(items[1]), contours.forget(items[2]);
        parts.forget(items[3]), preparations.forget(items[4]);
    }
    /// What stands between the moves, by aspects.
    [[nodiscard]] std::array<const Kept<Item>*, 5> items() const {
        return {&events, &cycles, &contours, &parts, &preparations};
    }

    /// How many items of each aspect there are.
    [[nodiscard]] std::array<std::size_t, 5> all_items() const {
        std::array<std::size_t, 5> out{};
        for (std::size_t i = 0; i < out.size(); ++i) out[i] = items()[i]->size();
        return out;
    }

    /// After all that has been taken.
    [[nodiscard]] const motion::State& state() const { return cursor_.state(); }
    /// Nothing turns or flows there.
    [[nodiscard]] bool is_at_rest() const { return state().spindle.direction == 0 && state().coolant == cl::Coolant{}; }
    [[nodiscard]] bool says_its_end() const { return ends_; }

    Kept<Move> moves;                  ///< the last may go on while records come
    bool compensates_length = false;   ///< anywhere
    bool has_several_tools = false;    ///< that move
    std::size_t calls_again = 0;       ///< of a tool that is in the spindle, by which nothing of it changes
    std::optional<Item> called_again;  ///< the first of them
    Kept<Item> events, cycles, contours, parts, preparations;  ///< as moves

private:
    void take_move(const cl::Record& record, const geom::Vec3& to);
    [[nodiscard]] bool is_of_no_length(const cl::Arc& arc) const;
    [[nodiscard]] bool leads_nowhere(const cl::Step& step, const geom::Vec3& to) const;
    [[nodiscard]] bool has_turned_before(const cl::Step& step) const;
    [[nodiscard]] bool is_turned() const;
    [[nodiscard]] geom::Vec3 as_said(geom::Vec3 to, const geom::Vec3& others) const;
    void take_said();
    void note_tool();
    void take_axis(const cl::AxisEnd& axis);
    void take_event(const cl::Record& record);
    void take_tool_data(const cl::Record& record, const cl::ToolData& data);
    void take_item(Kept<Item>& items, cl::Step step, const cl::Record& record);
    [[nodiscard]] bool goes_on(const cl::Record& record) const;
    [[nodiscard]] std::shared_ptr<const Holding> holding_of(const cl::Step& step);
    void hold();

    double same_place_;
    bool is_axis_by_axis_, joins_freely_;
    motion::Cursor cursor_;
    std::shared_ptr<const Holding> moving_;  ///< what held at the last move under a tool
    std::shared_ptr<const Holding> holding_ = std::make_shared<const Holding>();
    Holding marked_;             ///< the same, with numbers in the place of those that nobody knows
    bool ends_ = false;          ///< the end of the program has been said
    bool held_ = false;          ///< nothing came since that would change it
    cl::ToolChange changed_to_;  ///< last, also where it does not count (to_holder_)
    bool to_holder_ = false;     ///< the next move leads what holds the tool to a place of the machine
    enum class Tap : std::uint8_t { none, in, back };
    Tap tap_ = Tap::none;    ///< the last move, of a rigid tap
    cl::Spindle tap_sense_;  ///< on its way in
    geom::Vec3 arc_from_;    ///< where the last arc began
    /// End of the last move that counts; NaN: of that coordinate nobody has said anything yet.
    std::optional<geom::Vec3> at_;
    std::optional<cl::Record> said_;      ///< a MachinePlace of the frame, of the move that follows
    geom::Vec3 tool_{NAN, NAN, NAN};      ///< its axis there
    bool tilts_ = false;                  ///< another frame since then
    bool was_turned_ = false;             ///< one of those since then had its axes turned by the control
    bool turns_alone_ = false;            ///< the last move, at rapid, of axes that its frame does not count
    cl::ToolLength length_there_;         ///< that was compensated there
    std::optional<std::size_t> item_at_;  ///< moves before the last event, cycle or element of a contour
    cl::AxisEnds axes_;                   ///< since the last move that counts
    struct Stand {
        double to = NAN;
        bool counted = false;
    };
    std::map<std::array<char, 8>, Stand> stands_;  ///< where additional axes stand
};

}  // namespace obrys::compare
