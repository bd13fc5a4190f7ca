#include <algorithm>
#include <cmath>

#include "base/number.hpp"
#include "base/whole.hpp"
#include "report/path_plot.hpp"
#include "report/subject.hpp"

namespace obrys::report {

namespace {

/// Three digits below the unit, and never fewer than six.
int decimals_of(double unit) { return base::clipped<int>(std::ceil(-std::log10(unit)) + 3, 6, 15); }

std::string right(const std::string& text, std::size_t width) {
    return text.size() < width ? std::string(width - text.size(), ' ') + text : text;
}
std::string left(const std::string& text, std::size_t width) {
    return text.size() < width ? text + std::string(width - text.size(), ' ') : text;
}

std::string row(const std::string& move, const std::string& length, const std::string& steps,
                const std::string& largest, const std::string& mean, const std::string& kind,
                const std::string& where) {
    return right(move, 6) + right(length, 12) + right(steps, 11) + right(largest, 13) + right(mean, 13) + "  " +
           left(kind, 8) + where + "\n";
}

std::string line_of(const base::Sources& sources, const base::Span& where) {
    const Place p = place(sources, where);
    return p.file.empty() ? "?" : p.file + ":" + std::to_string(p.line);
}

}  // namespace

std::string table_head(double unit) {
    return "deviations of a staircase of single-axis steps, basic length unit " + base::shortest(unit) + " mm\n" +
           row("move", "length mm", "steps", "largest mm", "mean mm", "kind", "line");
}

std::string table_row(const InterpolatedMove& move, const base::Sources& sources, double unit) {
    const int decimals = decimals_of(unit);
    const geom::Staircase& f = move.figures;
    const bool run = f.end_reason == geom::StaircaseEnd::reached;
    const auto figure = [&](double v) { return run ? base::fixed(v, decimals) : std::string("?"); };
    return row(std::to_string(move.index), std::isfinite(move.length) ? base::fixed(move.length, 3) : "?",
               run ? std::to_string(f.steps) : "?", figure(f.largest), figure(f.mean), move.kind,
               line_of(sources, move.where));
}

std::string table_end(const Interpolation& all, const base::Sources& sources) {
    const int decimals = decimals_of(all.unit);
    std::string out = "overall: " + count_of(all.moves, "move") + ", " + base::fixed(all.length, 3) + " mm, " +
                      count_of(all.steps, "step");
    if (all.moves > 0)
        out += ": largest deviation " + base::fixed(all.largest, decimals) + " mm in move " +
               std::to_string(all.worst.index) + " (" + line_of(sources, all.worst.where) + "), mean " +
               base::fixed(all.sum / static_cast<double>(all.steps + all.moves), decimals) + " mm";
    out += "\n";
    if (all.rapids > 0) out += count_of(all.rapids, "rapid move") + " left out\n";
    if (all.not_known > 0)
        out += count_of(all.not_known, "move") + " not computed: position not known, or beyond the grid\n";
    if (all.not_run > 0) out += count_of(all.not_run, "move") + " not computed: too many steps\n";
    return out;
}

}  // namespace obrys::report
