#pragma once
/// A milling check as one page that needs no network: 3D view, plan view and three projections, program text beside it,
/// linked both ways. Plain values in; lengths in mm, times in s, everything in the workpiece frame. The script that
/// draws is made of web/ when the library is built (docs/adr/0014-web-page.md).

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "base/diagnostic.hpp"
#include "check/result.hpp"
#include "geom/vec.hpp"

namespace obrys::report {

/// No move, no file: for triangles that no move cut, and for places that have no text.
inline constexpr std::uint32_t page_none = 0xFFFFFFFF;

/// A place in one of the page's program texts. Lines count from 1; 0: no line.
struct PageSite {
    std::uint32_t file = page_none;
    std::uint32_t line = 0;
};

struct PageText {
    std::string name;  ///< as the user wrote it; UTF-8, else taken as CP1252
    std::string text;  ///< alike
};

struct PageAmount {
    std::string label, value, unit;  ///< "depth", "0.131", "mm"
};

struct PageFinding {
    std::string code, text, remedy;
    base::Severity severity = base::Severity::error;
    PageSite where;
    std::optional<std::uint32_t> move;  ///< index; the worst one
    std::vector<std::uint32_t> moves;   ///< indices of all that did it
    std::string passes;                 ///< what is said of them together; empty: it is one
    std::optional<geom::Vec3> place;
    std::vector<PageAmount> amounts;  ///< the first one is also shown at the mark in the picture
};

/// A thing that was not checked, or was assumed.
struct PageNote {
    std::string text, remedy;
    PageSite where;
};

struct PageMove {
    bool rapid = false;
    PageSite where;
    std::int32_t tool = 0;     ///< its number, as in PageTool
    double end_s = 0;          ///< run time when the move has ended; NaN: not known
    double end_mm = 0;         ///< path length alike
    std::uint64_t number = 0;  ///< of the run's moves, as every report counts them
};

/// All moves in order. Arcs and curves are chains of points here; point k ends a straight piece that begins at point
/// k - 1 and belongs to the move `move_of_point[k]` (not decreasing; point 0 is where the run begins). A point with NaN
/// is a place that is not known: no piece ends or begins there.
struct PagePath {
    std::vector<PageMove> moves;
    std::vector<float> points;                 ///< x y z each
    std::vector<std::uint32_t> move_of_point;  ///< one a point
    /// Direction from tip to spindle, x y z each move; empty: +z in all of them.
    std::vector<float> axes;
};

/// A cone piece of shank or holder, from bottom to top. `from` counts from the tip along the axis.
struct PageToolBody {
    double from = 0, to = 0;
    double radius_from = 0, radius_to = 0;
    bool holder = false;
};
/// The cutting part is a cylinder with a corner radius (ball: equal to the radius); `outline` where it is anything
/// else.
struct PageTool {
    std::int32_t number = 0;
    std::string name, kind;
    double radius = 0, corner_radius = 0;
    double cutting_length = 0;                ///< above the tip
    std::vector<geom::Vec2> outline;          ///< (radius, height above the tip) from tip to end of the cutting part
    std::vector<PageToolBody> bodies;         ///< shank and holder; may be empty
    std::optional<double> volume_mm3;         ///< removed by it
    std::uint64_t moves = 0;                  ///< made with it
    std::optional<double> feed_mm, rapid_mm;  ///< path lengths
};

/// The machined surface: closed triangles with the finished shape at the end of the run.
struct PageSurface {
    std::vector<float> vertices;         ///< x y z each
    std::vector<std::uint32_t> indices;  ///< three a triangle, counter-clockwise from outside
    std::vector<std::uint32_t> move_of;  ///< one a triangle: the move that cut it last; page_none: the stock's own face
    std::vector<float>
        deviation;  ///< one a triangle, mm from the part: > 0 excess, < 0 gouge; NaN: not known; or empty
};

struct PageBox {
    geom::Vec3 min, max;
    std::string name;  ///< "clamp 1", "vice"
};

/// A row of the table of figures.
struct PageFigure {
    std::string label, value, unit;
};

struct MillingPage {
    std::string title;                            ///< the program, as the user wrote it
    std::string control, machine, date, version;  ///< each may be empty
    check::Verdict verdict = check::Verdict::not_fully_checked;
    std::string verdict_line;            ///< in plain words: report::verdict_line()
    std::vector<PageFinding> findings;   ///< the most dangerous ones first; numbered as they stand
    std::uint64_t findings_dropped = 0;  ///< counted only
    std::vector<PageNote> unchecked, assumptions;
    std::vector<PageText> texts;
    PagePath path;
    std::vector<PageTool> tools;
    PageSurface surface;
    std::optional<PageBox> stock;
    std::vector<PageBox> clamps;
    double tolerance = 0;  ///< of the surface, mm; 0: not said
    /// Deviations beyond it count as gouge or excess and end the colour scale's neutral part, mm; 0: a tenth of the
    /// largest.
    double deviation_limit = 0;
    std::vector<PageFigure> figures;
    std::uint64_t moves_all = 0;       ///< of the run, with those that were not simulated
    std::uint64_t moves_left_out = 0;  ///< simulated behind those that path holds
};

/// False where the library was built without node and npm (OBRYS_PAGE): milling_page() must not be called then.
[[nodiscard]] bool milling_page_available();

/// The whole document, UTF-8. Arrays whose lengths do not fit each other are cut to what fits; indices that point
/// nowhere are left out.
[[nodiscard]] std::string milling_page(const MillingPage& page);

/// The parts that the page's script decodes, for tests: JSON that may stand in a <script> element.
[[nodiscard]] std::string milling_page_data(const MillingPage& page);

}  // namespace obrys::report
