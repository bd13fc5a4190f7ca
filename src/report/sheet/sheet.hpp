#pragma once
/// Sheets of programs: their tools, their set-up, their times. Lengths in mm, times in seconds; NaN is not known.
/// Times are estimates: path by feed and rapid, without acceleration.

#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "motion/cursor.hpp"
#include "shop/machine.hpp"

namespace obrys::report::sheet {

/// Where the tool was; nothing yet where `low` is above `high`.
struct Extent {
    geom::Vec3 low{INFINITY, INFINITY, INFINITY}, high{-INFINITY, -INFINITY, -INFINITY};
    void add(const geom::Vec3& point);  ///< coordinates that are not known are left out
};
/// Start, end and what an arc or a spline reaches between them.
void add_way(Extent& extent, const motion::Step& step);

/// Path and times of moves. What is not known is counted apart, never as 0.
struct Times {
    double feed_mm = 0, rapid_mm = 0;
    double feed_s = 0, rapid_s = 0, dwell_s = 0;
    double untimed_mm = 0;             ///< of the feed path: its feed, or the speed that it counts with, is not known
    std::uint64_t untimed_dwells = 0;  ///< in revolutions of a spindle whose speed is not known
    std::uint64_t unmeasured = 0;      ///< moves that begin or end where nobody knows
    std::uint64_t rotary = 0;          ///< moves of rotary axes alone, in no path and no time
    void add(const Times& other);
    [[nodiscard]] double seconds() const { return feed_s + rapid_s + dwell_s; }
    [[nodiscard]] bool is_whole() const { return untimed_mm == 0 && untimed_dwells + unmeasured + rotary == 0; }
};

struct ToolUse {
    std::uint32_t number = 0, edge = 0;                              ///< cl::unknown_tool: not known
    std::string name, kind;                                          ///< kind: as in job files; empty: not in a list
    double diameter = NAN, width = NAN, corner = NAN, length = NAN;  ///< width: of grooving inserts
    std::uint64_t calls = 0;
    Times times;
    Extent cut;                                  ///< of its feed moves, in the zero in force
    double least_feed = NAN, most_feed = NAN;    ///< mm/min, of moves whose feed is known
    double least_speed = NAN, most_speed = NAN;  ///< 1/min
    std::map<std::string, std::uint64_t> cycles;
    bool flood = false, mist = false;
};

struct ZeroUse {
    std::uint32_t number = 0;
    geom::Vec3 origin{NAN, NAN, NAN};  ///< in the machine
    std::uint64_t moves = 0;
    Extent extent;
};

struct Program {
    std::string name, control, machine, stock;  ///< stock: in words; empty: not known
    double rapid = NAN;                         ///< mm/min of the slowest linear axis
    bool lathe = false;                         ///< x is a radius
    std::vector<std::string> clamps;
    std::uint64_t moves = 0, tool_changes = 0, stops = 0, optional_stops = 0;
    Extent travel, cut;  ///< seen from the first zero
    Times times;
    std::vector<ToolUse> tools;  ///< in the order of their use
    std::vector<ZeroUse> zeros;
    std::vector<std::string> called;    ///< programs that it calls
    std::vector<std::string> messages;  ///< for the operator
    std::string not_whole;              ///< why it is not all of the program; empty: it is
};

class Collector {
public:
    /// Both outlive the collector.
    Collector(std::span<const shop::Tool> tools, const shop::Machine& machine);
    void take(const cl::Record& record);
    /// To be called once; name, stock and the like are left to the caller.
    [[nodiscard]] Program finish();

private:
    void take_move(const motion::Step& step);
    void take_feed(const motion::Step& step, double way, ToolUse& tool);
    void take_dwell(const cl::Dwell& dwell);
    [[nodiscard]] double speed_at(double radius) const;
    ToolUse& tool();
    ZeroUse& zero();

    const shop::Machine& machine_;
    double highest_ = INFINITY;
    motion::Cursor cursor_;
    Program program_;
};

struct Options {
    bool job = false;  ///< one list of tools and one time for all programs together, first
};

/// What differs from an older sheet, line by line.
struct Since {
    std::string name;
    std::vector<std::string> lines;
};
/// Nothing where the text is no sheet of this version.
[[nodiscard]] std::optional<Since> since(const std::string& name, const std::string& old_json,
                                         const std::vector<Program>& programs);

struct Table {
    std::string title;
    std::vector<std::string> head;
    std::vector<std::vector<std::string>> rows;
};
/// A sheet in words, before it is a document.
struct Page {
    std::string title;
    std::vector<std::pair<std::string, std::string>> facts;
    std::vector<Table> tables;
    std::vector<std::string> remarks;
};
[[nodiscard]] std::vector<Page> pages(const std::vector<Program>& programs, const Options& options,
                                      const std::optional<Since>& since);

[[nodiscard]] std::string as_text(const std::vector<Page>& pages);
[[nodiscard]] std::string as_html(const std::vector<Page>& pages);
[[nodiscard]] std::string as_pdf(const std::vector<Page>& pages);
/// docs/report-json.md
[[nodiscard]] std::string as_json(const std::vector<Program>& programs);

}  // namespace obrys::report::sheet
