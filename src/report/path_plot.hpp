#pragma once
/// The tool path by itself, for programs of every kind of machine, and what an interpolator with a basic length unit
/// makes of it: picture and table.

#include <optional>
#include <string>
#include <vector>

#include "base/source.hpp"
#include "geom/interpolation.hpp"

namespace obrys::report {

/// What the picture shows: a lathe's z to the right and x up, or a mill's x to the right and y up (and z below it).
enum class PlotPlane : std::uint8_t { zx, xy };
[[nodiscard]] geom::Vec2 project(PlotPlane plane, geom::Vec3 p);

/// A place of the staircase beside its element, in the plane of the picture, mm.
struct Excursion {
    geom::Vec2 ideal, off;
};

struct PlotMove {
    std::vector<geom::Vec3> points;  ///< from the start to the end, curves as chains
    bool rapid = false;
    std::vector<Excursion> left, right;  ///< the largest ones of either side piece by piece, in the order of the motion
};

/// A row of the table.
struct InterpolatedMove {
    std::uint64_t index = 0;  ///< number of the move
    base::Span where;
    const char* kind = "";  ///< static storage: "linear", "arc", "spline", "thread"
    double length = 0;      ///< mm
    geom::Staircase figures;
};

struct Interpolation {
    double unit = 0;  ///< mm
    std::uint64_t moves = 0, rapids = 0, not_known = 0, not_run = 0, steps = 0;
    double length = 0;                            ///< mm, of the moves that were run
    double largest = 0;                           ///< mm
    double sum = 0;                               ///< of the deviations of all grid points
    InterpolatedMove worst;                       ///< the move of the largest
    std::vector<std::vector<geom::Vec2>> stairs;  ///< the staircase next to the worst place, in the picture's plane
    std::vector<std::vector<geom::Vec2>> ideal;   ///< the element there
    geom::Vec2 place;
};

struct PathPlot {
    PlotPlane plane = PlotPlane::zx;
    std::string program, control, machine;
    std::vector<PlotMove> moves;    ///< the first ones; those whose place is not known are left out
    std::vector<PlotMove> contour;  ///< as programmed, where compensation, chamfers or roundings change it
    /// The same part of another program, and where the two begin to differ; `program` then names both.
    std::vector<PlotMove> other;
    std::optional<geom::Vec3> parting;
    std::string difference;  ///< what differs there
    std::uint64_t all_moves = 0, unplaced_moves = 0;
    double feed_length = 0, rapid_length = 0;  ///< mm
    std::optional<Interpolation> interpolation;
};

[[nodiscard]] std::string to_svg(const PathPlot& plot, const base::Sources& sources, double width = 1040);

/// The table, piece by piece: what stands above, a line for each move, what stands below. mm.
[[nodiscard]] std::string table_head(double unit);
[[nodiscard]] std::string table_row(const InterpolatedMove& move, const base::Sources& sources, double unit);
[[nodiscard]] std::string table_end(const Interpolation& all, const base::Sources& sources);

}  // namespace obrys::report
