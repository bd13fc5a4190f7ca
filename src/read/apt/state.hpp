#pragma once
/// What holds where the text is read. Cutter locations run in the order in which they stand, so the reader knows the
/// point and the axis of the tool; all lengths here are in the text's unit. Private to read/apt.

#include <array>
#include <map>
#include <optional>
#include <string>

#include "dialect/apt/cycles.hpp"
#include "dialect/apt/systems.hpp"
#include "dialect/apt/words.hpp"
#include "geom/vec.hpp"
#include "program/builder.hpp"
#include "read/apt/scanner.hpp"

namespace obrys::read::apt {

struct Feed {
    double value = 0;   ///< in the text's unit
    double factor = 1;  ///< from its number to the text's unit
    program::Modal mode = program::Modal::feed_per_minute;
    std::uint32_t begin = 0, end = 0;  ///< where it stands
    bool operator==(const Feed& o) const { return value == o.value && mode == o.mode; }
};

/// CIRCLE before its points.
struct Circle {
    geom::Vec3 centre, axis{0, 0, 1};  ///< counter-clockwise about `axis`
    double radius = 0;                 ///< 0: not written
    int turns = 0;                     ///< TIMES
    bool rapid = false;                ///< RAPID stood before it
    std::uint32_t begin = 0, end = 0;
    bool begun = false;  ///< a point of it was run
};

/// What the words of a cycle say, each as it stands.
struct HoleSizes {
    std::optional<double> rapid_to, clearance, depth, retract, dwell, first_step, step, back, pitch;
    std::optional<Feed> feed;
    bool retract_to_start = false;  ///< RTRCTO,AUTO
};

/// CYCLE in force.
struct HoleCycle {
    dialect::apt::Hole hole = dialect::apt::Hole::drill;
    dialect::apt::Hole kind = dialect::apt::Hole::drill;  ///< as its word says, before its sizes say more
    bool named = false;                                   ///< its word is known
    HoleSizes said;
    double depth = 0, clearance = 0;
    std::optional<double> retract, dwell, first_step, step, back, pitch;
    std::optional<double> start;  ///< the height to which RTRCTO,AUTO goes out
    std::optional<Feed> feed;
    std::uint32_t begin = 0, end = 0;
    bool refused = false;  ///< said; its points are not run
};

struct State {
    State(std::uint32_t file, const base::Sources& sources, program::Unit& unit, program::Names& names,
          base::Diagnostics& diagnostics);

    std::uint32_t file;
    std::string_view text;
    base::Diagnostics& diagnostics;
    program::Builder build;
    Scanner scanner;
    Line line;
    const dialect::apt::System& system;

    std::optional<geom::Vec3> at;     ///< where the tool stands
    geom::Vec3 axis{0, 0, 1};         ///< of the tool, as the text has it
    geom::Vec3 told_axis{0, 0, 1};    ///< as the tree has it
    bool aims = false;                ///< TLAXIS, CSYS: the next point carries it
    std::optional<geom::Vec3> along;  ///< INDIRV
    bool rapid = false;
    std::optional<Circle> circle;
    std::optional<Feed> feed;
    bool feed_told = false;  ///< the tree has `feed`; a cycle's own feed takes its place
    std::optional<HoleCycle> cycle, last_cycle;
    bool path_closed = false;  ///< the last statement was END-OF-PATH

    double inch = 0;  ///< mm of the unit: 25.4, 1; 0: not said yet
    bool unit_told = false;

    std::optional<double> tool;    ///< in the spindle
    std::optional<double> cutter;  ///< diameter that was said for the tool to come
    std::uint32_t cutter_begin = 0, cutter_end = 0;
    bool tool_has_size = false, moved_with_tool = false, turns = false;
    int spindle = 3;  ///< M3, M4: the direction that ON means
    int coolant = 9;  ///< M7, M8, M9: as the text has it
    bool surface = false;
    bool surface_in_feet = false;
    double speed = 0;  ///< of the spindle in 1/min; 0: not known
    std::optional<std::array<double, 12>> placement;
    int setups = 0;

    bool ended = false, told_behind = false;
    std::map<std::string, std::string> synonyms;
    std::map<std::string_view, bool> warned;
    std::string word_before;                         ///< of the last statement, in capitals …
    const dialect::apt::MajorWord* known = nullptr;  ///< … and what the table says of it
};

/// The numbers and words behind the slash.
struct Arguments {
    const Token* first = nullptr;
    const Token* last = nullptr;
    [[nodiscard]] const Token* begin() const { return first; }
    [[nodiscard]] const Token* end() const { return last; }
};
[[nodiscard]] Arguments arguments(const Line& line);
/// Only numbers stand there, divided by commas: they are.
[[nodiscard]] std::optional<std::vector<double>> numbers(const Arguments& a);
[[nodiscard]] std::string upper_of(const Token& t);

/// A block of the tree over the whole statement.
void begin_block(State& s);
void end_block(State& s);
/// The statement is known and not run.
void refuse(State& s, std::string_view reason);
/// Words of the statement behind the first `known` of its list: nobody reads them. The rest of it is run.
void refuse_rest(State& s, const Arguments& a, std::size_t known);
/// The statement is not as it has to be.
void fail(State& s, const Token* at, std::string text, std::string remedy = {});
/// What was taken for granted: said once for each `text`, which must be a literal.
void assume(State& s, std::uint32_t begin, std::uint32_t end, std::string_view text, std::string_view remedy = {});
/// Words of a feed that differs from what the tree has; the block is begun.
void tell_feed(State& s, const Feed& feed);
/// A unit of length, as a word says it.
void set_unit(State& s, double mm);
/// The same, before the first length where nothing has said one.
void need_unit(State& s);

void read_statement(State& s);
void read_comment(State& s);
void read_point(State& s, const Arguments& a);  // motion.cpp
void read_from(State& s, const Arguments& a);
void read_delta(State& s, const Arguments& a);
void read_direction(State& s, const Arguments& a, bool of_tool);
void read_shift(State& s, const Arguments& a, bool origin);
void read_system(State& s, const Arguments& a);
void read_placement(State& s, const Arguments& a);
/// Where the part lies, said again otherwise.
void place_part(State& s, const std::vector<double>& n);
void read_circle(State& s, const Arguments& a);  // circle.cpp
void read_apt_arc(State& s);
/// CIRCLE without a point behind it is said.
void drop_circle(State& s);
/// The point ends an arc of the circle in force: it is run; false: it is a straight move's.
[[nodiscard]] bool run_on_circle(State& s, const geom::Vec3& to);
void read_cycle(State& s, const Arguments& a);  // cycle.cpp
/// The couplets behind the first `known` words; a complaint where something else stands there.
[[nodiscard]] std::string read_couplets(State& s, HoleSizes& sizes, const Arguments& a, std::size_t known);
void run_hole(State& s, const geom::Vec3& at);  // hole.cpp
/// At rapid to X and Y of `to` at the height where the tool stands, with the axis that the text has now.
void tell_upright(State& s, const geom::Vec3& to);  // motion.cpp
void read_feed(State& s, const Arguments& a);       // technology.cpp
void read_spindle(State& s, const Arguments& a);
void read_coolant(State& s, const Arguments& a);
void read_delay(State& s, const Arguments& a);
void read_compensation(State& s, const Arguments& a);
void read_load(State& s, const Arguments& a, bool tool_word);  // tool.cpp
void read_cutter(State& s, const Arguments& a);
void read_tool_kind(State& s, const Arguments& a);

}  // namespace obrys::read::apt
