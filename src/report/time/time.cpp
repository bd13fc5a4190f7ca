#include "report/time/time.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "base/number.hpp"
#include "cl/unknown_tool.hpp"
#include "report/clock.hpp"
#include "report/time/parts.hpp"

namespace obrys::report::time {

using sim::time::Cause;
using sim::time::Place;
using sim::time::Seconds;
using sim::time::sum;
using sim::time::Times;

namespace {

std::string padded(std::string text, std::size_t width, bool right = false) {
    if (text.size() >= width) return text;
    return right ? std::string(width - text.size(), ' ') + text : text + std::string(width - text.size(), ' ');
}

void put_row(std::string& out, const std::string& name, double part, double all) {
    out += "  " + padded(name, 14) + padded(seconds(part), 14, true) + padded(percent(part, all), 9, true) + "\n";
}

std::string tool_name(std::uint32_t number) {
    return number == cl::unknown_tool ? "tool ?" : "T" + std::to_string(number);
}

void put_lines(std::string& out, const Times& t, const base::Sources& sources, std::size_t most) {
    const std::vector<Line> lines = slow_lines(t, sources, most);
    if (lines.empty() || most == 0) return;
    const double all = sum(t.all);
    out += t.places_short ? "\nslowest lines, of those that were kept:\n" : "\nslowest lines:\n";
    for (std::size_t i = 0; i < std::min(most, lines.size()); ++i) {
        const Line& l = lines[i];
        out += "  " + padded(seconds(l.all), 12, true) + padded(percent(l.all, all), 9, true) + "  " +
               padded(std::string(name_of(largest(l.seconds))), 13) + sources[l.file].name + ":" +
               std::to_string(l.line) + ": " + std::string(sources.line(l.file, l.line)) + "\n";
    }
}

void put_variants(std::string& out, const Subject& s) {
    if (s.variants.size() < 2) return;
    out += "\nwith other values:\n";
    const double as_it_is = sum(s.variants.front().times.all);
    for (std::size_t i = 1; i < s.variants.size(); ++i) {
        const double then = sum(s.variants[i].times.all);
        out += "  " + padded(s.variants[i].name, 24) + padded(seconds(then), 14, true) + "  " +
               (then <= as_it_is ? seconds(as_it_is - then) + " less" : seconds(then - as_it_is) + " more") + "\n";
    }
}

void put_unknown(std::string& out, const Subject& s, const base::Sources& sources) {
    const Times& t = s.variants.front().times;
    if (!s.not_whole.empty()) out += "not fully timed: " + s.not_whole + "\n";
    if (t.untimed > 0) {
        const base::Position at = sources.position(t.first_untimed);
        out += "not fully timed: " + std::to_string(t.untimed) +
               (t.untimed == 1 ? " move whose feed, place or axis is not known: "
                               : " moves whose feed, place or axis is not known, the first: ") +
               sources[t.first_untimed.file].name + ":" + std::to_string(at.line) + "\n";
    }
    if (t.untimed_speeds > 0)
        out += "not timed: " + std::to_string(t.untimed_speeds) + (t.untimed_speeds == 1 ? " change" : " changes") +
               " of the spindle's speed, from or to one that is not known\n";
    if (t.stops > 0)
        out += "not timed: " + std::to_string(t.stops) + (t.stops == 1 ? " stop" : " stops") +
               " of the program, for as long as the operator likes\n";
    if (t.from_nowhere > 0)
        out += "not timed: " +
               (t.from_nowhere == 1 ? std::string("the first rapid move, which begins")
                                    : "the first " + std::to_string(t.from_nowhere) + " rapid moves, which begin") +
               " where nobody knows\n";
    if (t.probings > 0)
        out += "timed to their end: " + std::to_string(t.probings) +
               " probing moves, which are over where the probe touches\n";
    if (t.untimed_dwells > 0)
        out += "not fully timed: " + std::to_string(t.untimed_dwells) +
               " dwells in revolutions of a spindle whose speed is not known\n";
}

void put_assumed(std::string& out, const std::vector<sim::time::Value>& values) {
    bool any = false;
    for (const sim::time::Value& v : values) {
        if (!v.assumed) continue;
        if (!std::exchange(any, true)) out += "\nassumed of the machine:\n";
        out += "  " + v.name + " = " +
               (std::isnan(v.value) ? "\"" + v.unit + "\"" : base::shortest(v.value) + " " + v.unit) +
               (v.origin == "assumed" ? "" : " (" + v.origin + ")") + "\n";
    }
}

}  // namespace

std::string seconds(double s) { return base::fixed(s, s < 100 ? 2 : 1) + " s"; }

std::string percent(double part, double all) { return base::fixed(all > 0 ? 100 * part / all : 0, 1) + " %"; }

std::string_view name_of(Cause c) { return sim::time::cause_names[static_cast<std::size_t>(c)]; }

Cause largest(const Seconds& s) { return static_cast<Cause>(std::max_element(s.begin(), s.end()) - s.begin()); }

std::vector<Line> slow_lines(const Times& t, const base::Sources& sources, std::size_t most) {
    std::vector<Line> lines;
    Place last;
    for (const sim::time::Spent& spent : t.places) {  // in their order, so that those of a line stand together
        if (lines.empty() || spent.place != last) {
            const std::uint32_t line = sources.position(spent.place.file, spent.place.begin).line;
            if (lines.empty() || lines.back().file != spent.place.file || lines.back().line != line)
                lines.push_back({spent.place.file, line, spent.place.begin, 0, {}});
            last = spent.place;
        }
        lines.back().seconds[static_cast<std::size_t>(spent.cause)] += spent.seconds;
    }
    for (Line& l : lines) l.all = sum(l.seconds);
    const auto slower = [](const Line& a, const Line& b) {
        return std::tuple(-a.all, a.file, a.line) < std::tuple(-b.all, b.file, b.line);
    };
    const std::size_t n = std::min(most, lines.size());
    std::partial_sort(lines.begin(), lines.begin() + static_cast<std::ptrdiff_t>(n), lines.end(), slower);
    lines.resize(n);
    return lines;
}

std::string as_text(const Subject& s, const base::Sources& sources, const Options& options) {
    const Times& t = s.variants.front().times;
    const double all = sum(t.all);
    const Range range = range_of(t, s.values);
    std::string out = s.name + " (" + s.control + ") on " + s.machine + "\n";
    put_unknown(out, s, sources);
    out += "estimated time: " + std::string(s.not_whole.empty() && t.is_whole() ? "" : "at least ") + seconds(all) +
           " (" + clock(all) + ")";
    if (range.high > range.low)
        out += ", between " + seconds(range.low) + " and " + seconds(range.high) + " by what is assumed";
    out += "\n" + std::to_string(t.moves) + " moves, " + base::fixed(t.way, 3) + " mm\n\nspent on:\n";
    for (std::size_t i = 0; i < t.all.size(); ++i)
        if (t.all[i] != 0) put_row(out, std::string(sim::time::cause_names[i]), t.all[i], all);
    if (t.tools.size() > 1) {
        out += "\nby tool:\n";
        for (const auto& [number, spent] : t.tools) put_row(out, tool_name(number), sum(spent), all);
    }
    put_lines(out, t, sources, options.lines);
    put_variants(out, s);
    put_tolerances(out, s, sources);
    put_assumed(out, s.values);
    return out;
}

}  // namespace obrys::report::time
