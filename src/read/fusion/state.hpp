#pragma once
/// What holds where the listing is read. Records run in the order in which they stand, so the reader knows the point
/// and the axis of the tool; lengths are millimetres. Private to read/fusion.

#include <map>
#include <optional>
#include <string>

#include "dialect/fusion/cycles.hpp"
#include "geom/frame.hpp"
#include "geom/vec.hpp"
#include "program/builder.hpp"
#include "read/fusion/line.hpp"

namespace obrys::read::fusion {

/// A place in the text.
struct Place {
    std::uint32_t begin = 0, end = 0;
};

/// What a context record says of the operation behind it.
struct Context {
    double work_offset = 0;
    bool turning = false, second_spindle = false;
    geom::Frame into_setup;  ///< the operation's coordinates into those of the setup
    Place where;
};

/// A tool as its record says it.
struct Tool {
    double number = 0, diameter = 0, speed = 0, pitch = 0, offset = 0;
    std::optional<double> coolant;  ///< number
    bool clockwise = true, turns = false;
    Place where, coolant_where;
};

/// Cycle in force.
struct Cycle {
    const dialect::fusion::CycleWord* word = nullptr;
    std::map<std::string, double, std::less<>> values;
    Place where;
    bool begun = false;    ///< a point of it was run
    bool refused = false;  ///< said; its points are not run

    [[nodiscard]] double get(std::string_view name, double otherwise = 0) const {
        const auto found = values.find(name);
        return found == values.end() ? otherwise : found->second;
    }
    [[nodiscard]] bool has(std::string_view name) const { return values.find(name) != values.end(); }
};

enum class Side : std::uint8_t { none, left, right };

struct State {
    State(std::uint32_t file, const base::Sources& sources, program::Unit& unit, program::Names& names,
          base::Diagnostics& diagnostics);

    std::uint32_t file;
    std::string_view text;
    base::Diagnostics& diagnostics;
    program::Builder build;
    LineScanner scanner;
    Line line;

    std::map<std::string, std::string, std::less<>> parameters;  ///< those that are looked at, as they stand
    Context context;
    bool has_context = false, in_section = false, turns = false;
    std::optional<Tool> tool;                    ///< of the operation at hand
    bool has_run = false, tool_changed = false;  ///< an operation, and since it began
    std::optional<double> in_spindle;            ///< number of the tool
    double speed = -1;                           ///< that the tree has; -1: none yet
    int direction = 0;                           ///< +1, -1
    bool speed_is_surface = false;
    const void* coolant = nullptr;  ///< entry of dialect::fusion::coolants that holds
    double offset_told = -1;        ///< work offset that the tree has
    bool uses_offsets = false;      ///< the file has more than the first one

    std::optional<geom::Vec3> at;   ///< where the tool stands, in the frame that the tree has
    geom::Vec3 told_axis{0, 0, 1};  ///< of the tool, as the tree has it, in its frame
    geom::Frame told_frame;         ///< tilted plane that the tree has, into the setup
    geom::Vec3 shift;               ///< from the operation's coordinates to those of that plane
    bool direct = true;             ///< no plane: the reader itself takes points into the setup
    std::optional<double> feed;     ///< that the tree has
    bool feed_per_turn = false, told_per_turn = false;
    Side side = Side::none;              ///< of compensation
    std::optional<double> thread_pitch;  ///< the feed is coupled to the spindle
    std::optional<Cycle> cycle;

    std::map<std::string_view, bool> warned;
};

/// A block of the tree over the line's record.
void begin_block(State& s, const Place& where);
void end_block(State& s, const Place& where);
[[nodiscard]] Place place_of(const Line& line);
/// A word of the line with the value behind it; the whole line where it has none.
[[nodiscard]] Place place_of(const Line& line, std::string_view word);
/// The record is known and not run.
void refuse(State& s, const Place& where, std::string_view reason);
/// The record is not as it has to be.
void fail(State& s, std::string text);
/// What was taken for granted: said once for each `text`, which must be a literal.
void assume(State& s, const Place& where, std::string_view text, std::string_view remedy = {});
/// A parameter of the operation; empty: there is none.
[[nodiscard]] std::string_view parameter(const State& s, std::string_view name);
[[nodiscard]] std::optional<double> number_of(const State& s, std::string_view name);

void read_parameter(State& s);  // operation.cpp
void read_context(State& s);
void begin_section(State& s);
void end_section(State& s);
void read_command(State& s);
void read_tool(State& s);  // tool.cpp
void read_turning_tool(State& s);
/// Speed and coolant of the operation's tool.
void tell_technology(State& s);
/// M3 or M4 with this speed, where the tree has another one; 0: M5.
void tell_spindle(State& s, const Place& where, double speed, bool clockwise);

/// Moves, in the coordinates of the tree's frame.
void read_linear(State& s, bool rapid, bool five_axis);  // motion.cpp
void read_arc(State& s, bool clockwise);
void run_straight(State& s, const Place& where, const geom::Vec3& to, bool rapid);
/// A feed that differs from what the tree has; the block is begun.
void tell_feed(State& s, const Place& where, double feed);
[[nodiscard]] geom::Vec3 into_frame(const State& s, const geom::Vec3& p);

void read_cycle(State& s);  // cycle.cpp
void end_cycle(State& s);
void read_cycle_value(State& s, std::string_view name);
void run_point(State& s, const geom::Vec3& at);
void run_break_through(State& s, const Cycle& c, const geom::Vec3& bottom);  // drill_by_moves.cpp
void run_guided(State& s, const Cycle& c, const geom::Vec3& bottom);
void run_feed_out(State& s, const Cycle& c, const geom::Vec3& bottom);
void run_thread_pass(State& s, const Cycle& c, const geom::Vec3& to);  // turning.cpp
void run_thread(State& s, const Place& where, const geom::Vec3& to);
void couple_feed(State& s, bool coupled);

}  // namespace obrys::read::fusion
