#include "report/svg_window.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "base/number.hpp"
#include "base/whole.hpp"
#include "check/turning/rest.hpp"

namespace obrys::report {

namespace svg {

namespace {

constexpr std::string_view style = R"svg(<style>
text{font-family:Helvetica,Arial,sans-serif;font-size:12px;fill:#111}
.title{font-size:19px;font-weight:bold}.small{font-size:11px;fill:#333}.mono{font-family:monospace;font-size:11.5px}
.frame{fill:#fff;stroke:#444;stroke-width:1}.grid{stroke:#dcdcdc;stroke-width:.6}.tick{stroke:#444;stroke-width:1}
.before{fill:#f6f1e4;stroke:#8a8a8a;stroke-width:1;stroke-dasharray:1.5 3}.after{fill:#c9d3dc;stroke:#4a5560;stroke-width:.9}
.clamp{fill:#e2b9c2;stroke:#7a3040;stroke-width:1}.part{fill:none;stroke:#000;stroke-width:2}.allowance{fill:none;stroke:#000;stroke-width:1.1;stroke-dasharray:9 4}
.other{fill:none;stroke:#f0a000;stroke-width:3;stroke-opacity:.6}.programmed{fill:none;stroke:#7a7a7a;stroke-width:.7;stroke-dasharray:1.5 2}.feed{fill:none;stroke:#0a8f3c;stroke-width:.9}.rapid{fill:none;stroke:#d40000;stroke-width:.8;stroke-dasharray:5 3}
.bad{fill:url(#hatch);stroke:#a00060;stroke-width:1.2}.centre{stroke:#333;stroke-width:1;stroke-dasharray:18 4 3 4}
.band{fill:#7b3fb5;fill-opacity:.25;stroke:#5b2a8c;stroke-width:.6}.stairs{fill:none;stroke:#5b2a8c;stroke-width:1.3}.ideal{fill:none;stroke:#0a8f3c;stroke-width:1.3}
.zoomed{fill:none;stroke:#555;stroke-width:1;stroke-dasharray:3 3}.leader{stroke:#a00060;stroke-width:1}.mark{fill:#fff;stroke:#a00060;stroke-width:1.8}.marktext{font-size:11px;font-weight:bold;text-anchor:middle;fill:#700040}
</style>
<defs><pattern id="hatch" width="5" height="5" patternUnits="userSpaceOnUse" patternTransform="rotate(45)"><rect width="5" height="5" fill="#ff9ad2"/><path d="M0 0V5" stroke="#a00060" stroke-width="2"/></pattern></defs>
)svg";

}  // namespace

double round_step(double least) {
    const double power = std::pow(10, std::floor(std::log10(least)));
    for (const double k : {1.0, 2.0, 5.0})
        if (least <= k * power) return k * power;
    return 10 * power;
}

std::string document(double width, double height, const std::string& content) {
    const std::string w = number(width, 0), h = number(std::ceil(height), 0);
    return "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + w + "\" height=\"" + h + "\" viewBox=\"0 0 " + w +
           " " + h + "\">\n" + std::string(style) + "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n" + content +
           "</svg>\n";
}

std::string line(const char* cls, double x1, double y1, double x2, double y2) {
    return std::string("<line class=\"") + cls + "\" x1=\"" + number(x1, 2) + "\" y1=\"" + number(y1, 2) + "\" x2=\"" +
           number(x2, 2) + "\" y2=\"" + number(y2, 2) + "\"/>\n";
}

std::string text(const char* cls, double x, double y, const std::string& content, const char* anchor) {
    return std::string("<text class=\"") + cls + "\" x=\"" + number(x, 2) + "\" y=\"" + number(y, 2) +
           "\" text-anchor=\"" + anchor + "\">" + escaped(content) + "</text>\n";
}

}  // namespace svg

namespace {

constexpr double mark_radius = 9;
constexpr double tick_distance = 75;  ///< wanted between two scale marks

std::optional<geom::Vec2> place_of(const check::Finding& f) {
    if (f.at) return f.at;
    const check::Box b = check::box_of(f.region);
    if (!b.empty()) return geom::Vec2{(b.min_z + b.max_z) / 2, (b.min_x + b.max_x) / 2};
    if (f.to && std::isfinite(f.to->x + f.to->z)) return geom::Vec2{f.to->z, f.to->x};
    return std::nullopt;
}

}  // namespace

std::vector<Mark> marks_of(const check::Result& result) {
    std::vector<Mark> marks;
    const std::vector<check::Group> groups = check::groups_of(result);
    const auto worst = [&](std::size_t i) -> const check::Finding& { return result.findings[groups[i].worst]; };
    for (std::size_t i = 0; i < groups.size();) {
        std::size_t last = i;
        while (worst(i).move && last + 1 < groups.size() && worst(last + 1).move == worst(i).move) ++last;
        std::string label = std::to_string(i + 1);
        if (last > i) label += "-" + std::to_string(last + 1);
        if (const auto at = place_of(worst(i))) marks.push_back({std::move(label), *at, i + 1});
        i = last + 1;
    }
    return marks;
}

Window::Window(std::string name, const check::Box& box, double left, double top, double width, double height,
               Scales scales)
    : name_(std::move(name)), box_(box), left_(left), top_(top), scales_(std::move(scales)) {
    const double span_z = box.max_z - box.min_z, span_x = box.max_x - box.min_x;
    to_.scale = std::min(width / span_z, height / span_x);
    width_ = span_z * to_.scale;
    height_ = span_x * to_.scale;
    to_.left = left - box.min_z * to_.scale;
    to_.base = top + height_ + box.min_x * to_.scale;
}

void Window::axes(std::string& out) const {
    constexpr std::int64_t most_steps = 1'000'000'000'000;
    const double step = svg::round_step(tick_distance / to_.scale);
    const int decimals = step < 1 ? base::clipped<int>(std::ceil(-std::log10(step) - 1e-9), 0, 15) : 0;
    const auto first = [step](double v) {
        return base::clipped<std::int64_t>(std::ceil(v / step - 1e-9), -most_steps, most_steps);
    };
    const auto last = [step](double v) {
        return base::clipped<std::int64_t>(std::floor(v / step + 1e-9), -most_steps, most_steps);
    };
    for (std::int64_t i = first(box_.min_z); i <= last(box_.max_z); ++i) {
        const double z = static_cast<double>(i) * step, x = to_({z, 0}).x;
        out += svg::line("grid", x, top_, x, bottom()) + svg::line("tick", x, bottom(), x, bottom() + 5);
        out += svg::text("small", x, bottom() + 18, base::fixed(z, decimals), "middle");
    }
    for (std::int64_t i = first(box_.min_x); i <= last(box_.max_x); ++i) {
        const double x = static_cast<double>(i) * step, y = to_({0, x}).y;
        out += svg::line("grid", left_, y, right(), y) + svg::line("tick", left_ - 5, y, left_, y);
        out += svg::text("small", left_ - 8, y + 4, base::fixed(x, decimals), "end");
    }
    out += svg::text("", right(), bottom() + 34, scales_.right, "end");
    out += svg::text("", left_ - 8, top_ - 8, scales_.up);
    if (scales_.axis && box_.min_x < 0 && box_.max_x > 0)
        out += svg::line("centre", left_, to_.base, right(), to_.base);
}

void Window::regions(std::string& out, const Subject& s) const {
    const auto path = [&](const char* cls, const geom::Region& region) {
        if (!region.empty())
            out +=
                std::string("<path class=\"") + cls + "\" fill-rule=\"evenodd\" d=\"" + path_of(region, to_) + "\"/>\n";
    };
    for (const check::TurnedClamp& c : s.setup.turned_clamps) path("clamp", c.body);
    if (s.setup.stock) path("before", *s.setup.stock);
    path("after", s.result.stock_after);
    if (s.setup.allowance) path("allowance", *s.setup.allowance);
    if (s.setup.part) path("part", *s.setup.part);
    MovePath rapid(to_), feed(to_);
    for (const check::MoveTrace& m : s.result.moves) (m.rapid ? rapid : feed).add(m);
    if (!rapid.data().empty()) out += "<path class=\"rapid\" d=\"" + rapid.data() + "\"/>\n";
    if (!feed.data().empty()) out += "<path class=\"feed\" d=\"" + feed.data() + "\"/>\n";
    for (const check::Finding& f : s.result.findings) path("bad", f.region);
}

/// A numbered sign beside each point, moved on round it until it covers no other.
void Window::marks(std::string& out, const std::vector<Mark>& marks) const {
    std::vector<geom::Vec2> taken;
    for (const Mark& m : marks) {
        const geom::Vec2 at = to_(m.at);
        if (!box_.meets({m.at.x, m.at.x, m.at.y, m.at.y}, 0)) continue;
        geom::Vec2 centre{at.x + 24, at.y - 20};
        const auto bad = [&] {
            const bool outside =
                centre.x < left_ + 14 || centre.x > right() - 14 || centre.y < top_ + 10 || centre.y > bottom() - 10;
            return outside || std::any_of(taken.begin(), taken.end(), [&](geom::Vec2 t) {
                       return std::abs(t.x - centre.x) < 34 && std::abs(t.y - centre.y) < 2 * mark_radius + 2;
                   });
        };
        for (int ring = 0; bad() && ring < 300; ++ring) {
            const double angle = -geom::pi / 4 + ring * 0.45, r = 30 + ring * 1.8;
            centre = {at.x + r * std::cos(angle), at.y + r * std::sin(angle)};
        }
        taken.push_back(centre);
        const double half = m.label.size() > 2 ? 6.0 + 3.2 * static_cast<double>(m.label.size()) : mark_radius;
        out += svg::line("leader", at.x, at.y, centre.x, centre.y);
        out += "<rect class=\"mark\" x=\"" + number(centre.x - half, 2) + "\" y=\"" +
               number(centre.y - mark_radius, 2) + "\" width=\"" + number(2 * half, 2) +
               "\" height=\"18\" rx=\"9\"/>\n";
        out += svg::text("marktext", centre.x, centre.y + 4, m.label, "middle");
    }
}

std::string Window::frame(const std::string& content) const {
    const std::string rect = "x=\"" + number(left_, 2) + "\" y=\"" + number(top_, 2) + "\" width=\"" +
                             number(width_, 2) + "\" height=\"" + number(height_, 2) + "\"";
    std::string out =
        "<clipPath id=\"" + name_ + "\"><rect " + rect + "/></clipPath>\n<rect class=\"frame\" " + rect + "/>\n";
    axes(out);
    return out + "<g clip-path=\"url(#" + name_ + ")\">\n" + content + "</g>\n";
}

std::string Window::draw(const Subject& subject, const std::vector<Mark>& shown) const {
    std::string content;
    regions(content, subject);
    std::string out = frame(content);
    marks(out, shown);
    return out;
}

}  // namespace obrys::report
