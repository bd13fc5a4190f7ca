#pragma once
/// What a check found: verdict, findings, what was not checked, what was assumed, figures. Plain values for the
/// reports.

#include <cmath>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostic.hpp"
#include "cl/record.hpp"
#include "geom/contour.hpp"
#include "mesh/compare.hpp"
#include "shop/job.hpp"

namespace obrys::check {

enum class Verdict : std::uint8_t {
    clean,              ///< everything was run and checked, nothing was found
    findings,           ///< everything was run and checked
    not_fully_checked,  ///< something was not understood, not run or not simulated; findings may be there as well
};
[[nodiscard]] std::string_view name(Verdict v);  ///< "clean", "findings", "not-fully-checked"
[[nodiscard]] int exit_code(Verdict v);          ///< 0, 1, 3

/// File number of a span that points nowhere.
inline constexpr std::uint32_t no_file = 0xFFFFFFFF;
inline constexpr base::Span nowhere{no_file, 0, 0};
[[nodiscard]] inline bool is_placed(const base::Span& s) { return s.file != no_file; }

/// A figure of a finding; the key ends with the unit: `depth_mm`, `area_mm2`, `speed_rpm`. All keys:
/// docs/report-json.md.
struct Amount {
    std::string_view key;  ///< static storage
    double value = 0;
};

struct Finding {
    std::string_view code;  ///< one of base::codes
    base::Severity severity = base::Severity::error;
    std::string text;    ///< what is wrong, with figures and units
    std::string remedy;  ///< may be empty
    base::Span where = nowhere;
    std::vector<base::Span> stack;  ///< call sites, innermost first
    std::vector<base::Related> related;
    std::optional<std::uint64_t> move;   ///< counts Linear, Arc, Spline and Thread from 0
    std::optional<geom::Vec3> from, to;  ///< of that move; unknown coordinates are NaN
    std::vector<Amount> amounts;
    geom::Region region;              ///< the material concerned, (z, x) plane; empty where there is none
    std::optional<geom::Vec2> at;     ///< the worst point, (z, x)
    std::optional<geom::Vec3> place;  ///< the same of milling, frame of the stock
    /// What is to be mended, where it is not the line: "tool 5 holder". Findings of one code and cause are one group
    /// (check/group.hpp).
    std::string cause;
    std::uint64_t more = 0;  ///< further moves of the same cause that are only counted
};

/// A place in the program where findings of one cause come up.
struct Site {
    base::Span where = nowhere;
    std::vector<base::Span> stack;  ///< call sites, innermost first
    std::optional<double> worst;    ///< chief amount of the worst one there; none where findings have none
};

/// Of a cause that is no line (Finding::cause): every line and call that it comes up in, in the order of the text.
struct Sites {
    static constexpr std::size_t most = 10000;
    std::map<std::vector<std::uint64_t>, Site> all;  ///< by files and places of `where` and `stack`
    bool more = false;                               ///< there are others
};

/// Something that was not checked, was assumed, or is only listed.
struct Note {
    std::string_view code;
    std::string text;
    std::string remedy;
    base::Span where = nowhere;
    std::vector<base::Span> stack;
    std::uint64_t times = 1;  ///< how often it came up; the place is the first one
};

struct Stats {
    std::uint64_t moves = 0, rapid_moves = 0, feed_moves = 0;
    double rapid_length_mm = 0, feed_length_mm = 0;  ///< of moves whose both ends are known
    std::uint64_t blocks_executed = 0;               ///< set by the caller, who ran the program
    std::uint64_t cuts = 0;                          ///< feed moves that go somewhere: only these can cut
};

struct StockFigures {
    double area_mm2 = 0, volume_mm3 = 0;
};

/// One tool and edge in the order of first use.
struct ToolUse {
    std::uint32_t number = 0, edge = 0;
    std::string name;
    std::optional<std::size_t> listed;  ///< index in Setup::tools
    base::Span first = nowhere, last = nowhere;
    std::uint64_t moves = 0;
    double feed_length_mm = 0, rapid_length_mm = 0, volume_mm3 = 0;
};

/// One move as the pictures need it, in the (z, x) plane.
struct MoveTrace {
    geom::Vec2 from, to, centre;  ///< NaN where unknown
    double sweep = 0;             ///< radians, counter-clockwise positive; 0: straight, or along `via`
    std::vector<geom::Vec2> via;  ///< points between the ends of a curve that is no arc in this plane, 0.01 mm near it
    bool rapid = false;
    base::Span where = nowhere;
    cl::StackId stack = 0;
    std::uint32_t tool = 0;  ///< index in Result::tools + 1; 0: none
    double area = 0, volume = 0, depth_x = 0, contact_length = 0;
    geom::Region removed;
};

/// The stock after `moves` moves.
struct Snapshot {
    std::uint64_t moves = 0;
    geom::Region stock;
};

/// A milling move as findings, pages and force models need it. Frame of the stock.
struct MilledMove {
    std::uint64_t index = 0;  ///< as Finding::move counts
    base::Span where = nowhere;
    cl::StackId stack = 0;
    geom::Vec3 from, to;
    std::uint32_t tool = 0;  ///< index in Result::tools + 1; 0: none
    bool rapid = false;
    bool plunging = false;  ///< straight along the axis into the material
    bool along = false;     ///< a contour cycle's, along the contour element at `where`
    // What it met (sim/milling: Engagement).
    double volume_mm3 = 0;
    double contact_length_mm = 0;  ///< way over which it removed material
    double axial_depth_mm = 0;     ///< along the tool's axis, of what was removed
    /// Beside the way, seen against the axis, left positive; rightmost above leftmost: nothing was measured.
    double rightmost_mm = INFINITY, leftmost_mm = -INFINITY;
    double reach_mm = 0;  ///< how high above the tip the edge met material, at most
    // How it was made; check/engagement.hpp makes chip thickness of it.
    double sinking = 0;            ///< part of the way that leads down along the axis: 1 straight down, -1 up
    double feed_per_rev_mm = NAN;  ///< not of rapids; NaN: not known
    double feed_mm_per_min = NAN;  ///< the same
    double speed_rpm = NAN;        ///< 0 while the spindle stands; NaN: not known
    std::int8_t spindle = 0;       ///< +1 clockwise (M3), -1 counter-clockwise, 0 standing
    std::int8_t thread = 0;        ///< coupled to the spindle: +1 right-hand, -1 left-hand thread
    std::uint32_t points_end = 0;  ///< in Milled::points: one past the last of this move; kept moves only
    double seconds = 0;            ///< at the programmed feed, or the machine's rapid; NaN: not known
};

struct MillingFigures {
    double tolerance_mm = 0;
    geom::Vec3 step;  ///< of the lattice, mm
    double memory_mb = 0;
    double before_mm3 = 0, after_mm3 = 0;
    double contact_length_mm = 0;    ///< way of feed moves over which material was removed
    double contact_accuracy_mm = 0;  ///< pieces in which that way was measured
    /// Of the surface: cells of the lattice that were halved, once or more often, and the width of the smallest: the
    /// narrowest wall or gap that is seen. The lattice's own where none was.
    std::size_t refined_cells = 0;
    double finest_mm = 0;
};

/// How far merged flat faces may leave the simulated surface, of the simulation's tolerance.
inline constexpr double flat_share = 0.05;

/// What milling left.
struct Milled {
    MillingFigures figures;
    std::vector<MilledMove> moves;
    /// The way as a chain of points, for pictures; the first one is where the first move began. Only of the moves that
    /// MillingSetup::keep_moves lets keep.
    std::vector<geom::Vec3> points;
    std::size_t moves_with_points = 0;
    mesh::Mesh surface;    ///< empty where nobody asked for it; tags: index in `moves` + 1, 0 the stock's own face
    std::size_t thin = 0;  ///< walls thinner than a step, which the surface leaves out
    std::optional<mesh::Comparison> comparison;  ///< with the part
    /// As it was when MillingSetup::at was made, with tags as of `surface`; none: not asked for, or made in no stock.
    std::optional<mesh::Mesh> at_move;
};

struct Result {
    Verdict verdict = Verdict::clean;
    shop::Scope scope = shop::Scope::all;  ///< within which the verdict holds
    bool has_baseline = false;
    std::set<std::string> known;         ///< causes (cause_key) that a baseline knows already
    std::map<std::string, Sites> sites;  ///< by cause_key, of findings that have a cause
    std::vector<Finding> findings;       ///< in the order in which they happen; rest material last
    std::uint64_t findings_dropped = 0;  ///< of causes past the limit per code: counted only
    std::vector<Note> unchecked, assumptions, listed;
    Stats stats;
    std::optional<StockFigures> before, after;
    geom::Region stock_after;
    std::vector<ToolUse> tools;
    std::vector<MoveTrace> moves;     ///< the first Setup::keep_moves moves
    std::vector<Snapshot> snapshots;  ///< of the kept moves, increasing
    std::shared_ptr<const Milled> milled;
};

/// The verdict that follows from the lists: not fully checked wins.
[[nodiscard]] Verdict verdict_of(const Result& r);
/// Takes over what the reader and the interpreter complained about, by the kind of its code, and updates the verdict.
void merge(Result& result, const base::Diagnostics& diagnostics);
/// A run that cannot have cut anything has checked nothing: said of `program`, and the verdict updated. To be called
/// where the run came to its end.
void require_cuts(Result& result, const std::string& program);
/// Findings outside the scope are only counted, as something assumed; updates the verdict.
void restrict_to(Result& result, shop::Scope scope);

}  // namespace obrys::check
