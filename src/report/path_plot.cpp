#include "report/path_plot.hpp"

#include <algorithm>
#include <cmath>

#include "base/number.hpp"
#include "report/subject.hpp"
#include "report/svg_window.hpp"

namespace obrys::report {

namespace {

constexpr double lower_height = 240;  ///< of the view from the side
constexpr double widest_detail = 420;
constexpr double wanted_band = 10;  ///< picture units that the largest deviation is drawn high, at most

const Scales turning{}, from_above{"X mm →", "↑ Y mm", false}, from_side{"X mm →", "↑ Z mm", false};

/// Which coordinates a view shows.
using View = geom::Vec2 (*)(geom::Vec3);
geom::Vec2 zx(geom::Vec3 p) { return {p.z, p.x}; }
geom::Vec2 xy(geom::Vec3 p) { return {p.x, p.y}; }
geom::Vec2 xz(geom::Vec3 p) { return {p.x, p.z}; }

/// Empty where no move has a place in this view.
check::Box extent(const PathPlot& plot, View view) {
    check::Box box;
    for (const std::vector<PlotMove>* moves : {&plot.moves, &plot.other})
        for (const PlotMove& m : *moves)
            for (const geom::Vec3& p : m.points)
                if (const geom::Vec2 v = view(p); std::isfinite(v.x + v.y)) box.add(v);
    return box;
}

/// The extent with air around it, and no flatter than can be looked at.
check::Box bounds(const PathPlot& plot, View view) {
    const check::Box box = extent(plot, view);
    if (box.empty()) return {0, 100, 0, 50};
    const double z = box.max_z - box.min_z, x = box.max_x - box.min_x;
    const double far = std::max({std::abs(box.min_z), std::abs(box.max_z), std::abs(box.min_x), std::abs(box.max_x)});
    const double air = std::max({0.05 * z, 0.05 * x, 1e-3, 1e-9 * far});
    const double narrow = air + std::max(0.0, 0.15 * x - z) / 2, flat = air + std::max(0.0, 0.15 * z - x) / 2;
    return {box.min_z - narrow, box.max_z + narrow, box.min_x - flat, box.max_x + flat};
}

void append_chain(std::string& out, const std::vector<geom::Vec2>& points, const Projection& to) {
    bool pen = false;
    for (const geom::Vec2& p : points) {
        if (!std::isfinite(p.x + p.y)) continue;
        out += pen ? "L" : "M";
        append_point(out, to(p), to.decimals);
        pen = true;
    }
}

std::string path(const char* cls, const std::string& data) {
    return data.empty() ? "" : std::string("<path class=\"") + cls + "\" d=\"" + data + "\"/>\n";
}

std::string parting_of(const PathPlot& plot, View view, const Projection& to) {
    if (!plot.parting || !geom::is_finite(*plot.parting)) return {};
    const geom::Vec2 at = to(view(*plot.parting));
    return "<circle class=\"mark\" cx=\"" + number(at.x, 2) + "\" cy=\"" + number(at.y, 2) + "\" r=\"5\"/>\n";
}

std::string moves_of(const PathPlot& plot, View view, const Projection& to) {
    std::string rapid, feed;
    for (const PlotMove& m : plot.moves) {
        std::vector<geom::Vec2> points;
        for (const geom::Vec3& p : m.points) points.push_back(view(p));
        append_chain(m.rapid ? rapid : feed, points, to);
    }
    const auto all = [&](const std::vector<PlotMove>& moves) {
        std::string data;
        for (const PlotMove& m : moves) {
            std::vector<geom::Vec2> points;
            for (const geom::Vec3& p : m.points) points.push_back(view(p));
            append_chain(data, points, to);
        }
        return data;
    };
    return path("other", all(plot.other)) + path("programmed", all(plot.contour)) + path("rapid", rapid) +
           path("feed", feed) + parting_of(plot, view, to);
}

/// The room between the farthest steps of either side, `times` as wide as it is.
std::string bands_of(const PathPlot& plot, double times, const Projection& to) {
    std::string data;
    if (!plot.interpolation) return data;
    for (const PlotMove& m : plot.moves) {
        if (m.left.empty() && m.right.empty()) continue;
        std::vector<geom::Vec2> outline{project(plot.plane, m.points.front())};
        for (const Excursion& e : m.left) outline.push_back(e.ideal + times * e.off);
        outline.push_back(project(plot.plane, m.points.back()));
        for (auto e = m.right.rbegin(); e != m.right.rend(); ++e) outline.push_back(e->ideal + times * e->off);
        append_chain(data, outline, to);
        data += "Z";
    }
    return path("band", data);
}

/// How many times larger than the path the deviations are drawn: 1, 2 or 5 times a power of ten.
double magnification(const PathPlot& plot, double scale) {
    if (!plot.interpolation || !(plot.interpolation->largest > 1e-12)) return 1;
    const double wanted = wanted_band / (scale * plot.interpolation->largest);
    return std::max(1.0, svg::round_step(wanted / 2.5));
}

std::string without_folder(const std::string& path) {
    const auto slash = path.find_last_of("/\\");
    return slash == std::string::npos ? path : path.substr(slash + 1);
}

std::string detail(const Interpolation& i, const Window& window, const base::Sources& sources) {
    std::string stairs, ideal;
    for (const auto& chain : i.stairs) append_chain(stairs, chain, window.projection());
    for (const auto& chain : i.ideal) append_chain(ideal, chain, window.projection());
    const geom::Vec2 at = window.projection()(i.place);
    const Place p = place(sources, i.worst.where);
    const std::string line = p.file.empty() ? "" : " (" + without_folder(p.file) + ":" + std::to_string(p.line) + ")";
    return window.frame(path("ideal", ideal) + path("stairs", stairs) + "<circle class=\"mark\" cx=\"" +
                        number(at.x, 2) + "\" cy=\"" + number(at.y, 2) + "\" r=\"4\"/>\n") +
           svg::text("small", window.left(), window.bottom() + 52,
                     "The largest deviation, " + base::fixed(i.largest, 6) + " mm, true to scale:") +
           svg::text("small", window.left(), window.bottom() + 68, "move " + std::to_string(i.worst.index) + line);
}

std::string legend(const PathPlot& plot, double times, double y) {
    std::string out;
    double x = svg::margin;
    const auto entry = [&](const char* cls, const char* shape, const std::string& label, double width) {
        out += std::string("<path class=\"") + cls + "\" d=\"M" + number(x, 1) + " " + number(y, 1) + shape + "\"/>\n" +
               svg::text("", x + 34, y + 5, label);
        x += width;
    };
    entry("feed", "h28", "feed", 72);
    entry("rapid", "h28", "rapid", 76);
    if (!plot.contour.empty()) entry("programmed", "h28", "contour as programmed", 170);
    if (plot.parting) entry("other", "h28", "the other program", 150);
    if (plot.parting) entry("mark", "m14 0m-5 0a5 5 0 1 0 10 0a5 5 0 1 0 -10 0", "from here on they differ", 180);
    if (!plot.interpolation) return out;
    entry("band", "m0 -7h26v14h-26z",
          times > 1 ? "deviations, drawn " + base::fixed(times, 0) + " times as large" : "deviations, true to scale",
          290);
    entry("stairs", "h28", "steps of the interpolator", 180);
    return out;
}

std::string heading(const PathPlot& plot) {
    if (plot.parting)
        return svg::text("title", svg::margin, 30, escaped(plot.program)) +
               svg::text("small", svg::margin, 50, escaped(plot.difference));
    std::string first = without_folder(plot.program) + ": tool path, " + count_of(plot.all_moves, "move");
    std::string below = "control " + plot.control + ", machine " + plot.machine + ". All figures in mm";
    if (plot.plane == PlotPlane::zx) below += ", X is a radius";
    if (const auto& i = plot.interpolation) {
        first = without_folder(plot.program) + ": interpolation with a basic length unit of " +
                base::shortest(i->unit) + " mm";
    }
    below += ".";
    const std::uint64_t missing = plot.all_moves - plot.moves.size();
    if (missing > plot.unplaced_moves)
        below += " The first " + std::to_string(plot.all_moves - missing + plot.unplaced_moves) + " moves are drawn.";
    if (plot.unplaced_moves > 0) below += " Without a known place: " + count_of(plot.unplaced_moves, "move") + ".";
    return svg::text("title", svg::margin, 30, first) + svg::text("small", svg::margin, 50, below);
}

}  // namespace

geom::Vec2 project(PlotPlane plane, geom::Vec3 p) { return plane == PlotPlane::zx ? zx(p) : xy(p); }

std::string to_svg(const PathPlot& plot, const base::Sources& sources, double width) {
    const bool lathe = plot.plane == PlotPlane::zx;
    const View view = lathe ? zx : xy;
    const bool zoomed = plot.interpolation && !plot.interpolation->stairs.empty();
    const double room = width - svg::margin - svg::margin_right - (zoomed ? svg::detail_width + svg::detail_gap : 0);
    const Window main("drawing", bounds(plot, view), svg::margin, svg::top_of_window, room, svg::most_height,
                      lathe ? turning : from_above);
    const double times = magnification(plot, main.projection().scale);
    std::string out = heading(plot);
    out += main.frame(bands_of(plot, times, main.projection()) + moves_of(plot, view, main.projection()));
    double bottom = main.bottom();
    const check::Box heights = extent(plot, xz);
    if (!lathe && heights.max_x > heights.min_x) {
        const check::Box above = bounds(plot, view), side = bounds(plot, xz);
        const Window lower("side", {above.min_z, above.max_z, side.min_x, side.max_x}, svg::margin,
                           bottom + svg::axis_room + 24, main.right() - main.left(), lower_height, from_side);
        out += lower.frame(moves_of(plot, xz, lower.projection()));
        bottom = lower.bottom();
    }
    if (zoomed) {
        const Interpolation& i = *plot.interpolation;
        const double half = 8 * i.unit, left = main.right() + svg::detail_gap;
        const Window near("detail", {i.place.x - half, i.place.x + half, i.place.y - half, i.place.y + half}, left,
                          svg::top_of_window, std::min(width - svg::margin_right - left, widest_detail),
                          svg::most_height, lathe ? turning : from_above);
        const geom::Vec2 at = main.projection()(i.place);
        out += svg::line("zoomed", at.x, at.y, near.left(), near.bottom()) +
               svg::line("zoomed", at.x, at.y, near.left(), svg::top_of_window) + detail(i, near, sources);
        bottom = std::max(bottom, near.bottom() + 36);
    }
    const double y = bottom + svg::axis_room + 12;
    return svg::document(width, y + svg::legend_room, out + legend(plot, times, y));
}

}  // namespace obrys::report
