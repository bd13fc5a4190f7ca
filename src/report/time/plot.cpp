/// Speed over time, and time over the way, with the slowest lines named.

#include <algorithm>
#include <cmath>

#include "base/number.hpp"
#include "report/clock.hpp"
#include "report/path.hpp"
#include "report/time/parts.hpp"
#include "sim/time/speed_curve.hpp"

namespace obrys::report::time {

using sim::time::SpeedCurve;

namespace {

constexpr double plot_left = 80, plot_width = 900, plot_height = 260, plot_gap = 60, plot_top = 50, line_height = 18;
constexpr std::size_t named = 10;

std::string at(double v) { return base::fixed(v, 1); }

std::string text_at(double x, double y, const std::string& anchor, const std::string& text) {
    return "<text x=\"" + at(x) + "\" y=\"" + at(y) + "\" text-anchor=\"" + anchor + "\">" + escaped(text) +
           "</text>\n";
}

/// 1, 2 or 5 times a power of ten, so that a few of them make up `most`.
double step_for(double most) {
    const double rough = most / 6, power = std::pow(10, std::floor(std::log10(rough)));
    for (const double m : {1.0, 2.0, 5.0})
        if (rough <= m * power) return m * power;
    return 10 * power;
}

/// A box with lines at round values: `x` and `y` end at these.
struct Axes {
    double y0, most_x, most_y;
    [[nodiscard]] double x(double v) const { return plot_left + plot_width * v / most_x; }
    [[nodiscard]] double y(double v) const { return y0 + plot_height * (1 - v / most_y); }

    [[nodiscard]] std::string drawn(const std::string& x_title, const std::string& y_title) const {
        std::string out;
        for (double v = 0, s = step_for(most_x); v <= most_x * (1 + 1e-9); v += s)
            out += "<path class=\"grid\" d=\"M" + at(x(v)) + " " + at(y0) + "v" + at(plot_height) + "\"/>\n" +
                   text_at(x(v), y0 + plot_height + 15, "middle", base::shortest(v));
        for (double v = 0, s = step_for(most_y); v <= most_y * (1 + 1e-9); v += s)
            out += "<path class=\"grid\" d=\"M" + at(plot_left) + " " + at(y(v)) + "h" + at(plot_width) + "\"/>\n" +
                   text_at(plot_left - 6, y(v) + 4, "end", base::shortest(v));
        return out + text_at(plot_left + plot_width, y0 + plot_height + 30, "end", x_title) +
               text_at(plot_left - 70, y0 - 8, "start", y_title);
    }
};

/// The band between the lowest and the highest speed of each piece.
std::string speeds(const SpeedCurve& curve, const Axes& axes) {
    const auto& samples = curve.samples();
    std::string up, down;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const double from = curve.step() * static_cast<double>(i), to = std::min(curve.seconds(), from + curve.step());
        const auto edge = [&](double v) { return at(axes.x(from)) + " " + at(axes.y(60 * v)) + "H" + at(axes.x(to)); };
        up += (i == 0 ? "M" : "L") + edge(samples[i].high);
        const double low = axes.y(60 * samples[i].low);
        down = "L" + at(axes.x(to)) + " " + at(low) + "H" + at(axes.x(from)) + down;
    }
    return "<path class=\"speed\" d=\"" + up + down + "Z\"/>\n";
}

std::string times(const SpeedCurve& curve, const Axes& axes) {
    std::string line = "M" + at(axes.x(0)) + " " + at(axes.y(0));
    const auto& samples = curve.samples();
    for (std::size_t i = 0; i < samples.size(); ++i)
        line += "L" + at(axes.x(samples[i].way)) + " " +
                at(axes.y(std::min(curve.seconds(), curve.step() * static_cast<double>(i + 1))));
    return "<path class=\"line\" d=\"" + line + "\"/>\n";
}

/// Numbers of the slowest lines where they begin, and what they say.
std::string marks(const Subject& s, const SpeedCurve& curve, const base::Sources& sources, const Axes& axes, double y) {
    const sim::time::Times& t = s.variants.front().times;
    const std::vector<Line> lines = slow_lines(t, sources, named);
    std::vector<std::pair<std::uint32_t, std::uint32_t>> of;  // of each sample: file, line
    for (const SpeedCurve::Sample& sample : curve.samples())
        of.emplace_back(sample.place.file, sources.position(sample.place.file, sample.place.begin).line);
    std::string out = text_at(plot_left, y, "start", "slowest lines");
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const Line& l = lines[i];
        const std::string number = std::to_string(i + 1);
        const auto found = std::find(of.begin(), of.end(), std::pair(l.file, l.line));
        if (found != of.end())
            out +=
                "<g class=\"mark\">" +
                text_at(axes.x(curve.step() * static_cast<double>(found - of.begin())), axes.y0 - 4, "start", number) +
                "</g>\n";
        out += text_at(plot_left, y + line_height * static_cast<double>(i + 1), "start",
                       number + "   " + seconds(l.all) + "   " + std::string(name_of(largest(l.seconds))) + "   " +
                           sources[l.file].name + ":" + std::to_string(l.line) + ": " +
                           sources.line_utf8({l.file, l.begin, l.begin}));
    }
    return out;
}

}  // namespace

std::string as_svg(const Subject& s, const SpeedCurve& curve, const base::Sources& sources) {
    double most = 0, way = 0;
    for (const SpeedCurve::Sample& sample : curve.samples()) most = std::max(most, sample.high), way = sample.way;
    const double all = std::max(curve.seconds(), 1e-3);
    const Axes upper{plot_top + 20, all, std::max(60 * most, 1e-3)},
        lower{upper.y0 + plot_height + plot_gap, std::max(way, 1e-3), all};
    const double below = lower.y0 + plot_height + plot_gap;
    const double bottom = below + line_height * static_cast<double>(named + 1);
    std::string out =
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 1020 " + at(bottom) +
        "\" font-family=\"sans-serif\" font-size=\"12\">\n<style>.grid{stroke:#ddd;fill:none}"
        ".speed{fill:#2a7a3a;stroke:#2a7a3a;stroke-width:0.5}.line{fill:none;stroke:#1f5fa8;stroke-width:1.5}"
        ".mark{fill:#b00020;font-weight:bold}</style>\n<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n";
    out +=
        text_at(plot_left, 24, "start", s.name + " (" + s.control + ") on " + s.machine + ": estimated " + clock(all));
    out += upper.drawn("s →", "↑ mm/min") + speeds(curve, upper);
    out += lower.drawn("mm →", "↑ s") + times(curve, lower);
    return out + marks(s, curve, sources, upper, below) + "</svg>\n";
}

}  // namespace obrys::report::time
