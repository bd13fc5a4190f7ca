#include <algorithm>
#include <cmath>

#include "check/turning/rest.hpp"
#include "report/report.hpp"
#include "report/svg_window.hpp"

namespace obrys::report {

namespace {

constexpr std::size_t most_marks = 40;     ///< marks in the picture
constexpr std::size_t most_entries = 14;   ///< findings listed below it
constexpr std::size_t widest_entry = 136;  ///< characters

check::Box grown(const check::Box& b, double by) { return {b.min_z - by, b.max_z + by, b.min_x - by, b.max_x + by}; }
double size_of(const check::Box& b) { return std::max({b.max_z - b.min_z, b.max_x - b.min_x, 1.0}); }

void add(check::Box& box, const check::Box& other) {
    if (other.empty()) return;
    box.add({other.min_z, other.min_x});
    box.add({other.max_z, other.max_x});
}

/// Stock and part decide; the tool path only as far as a bit around them.
check::Box bounds(const Subject& s) {
    check::Box box, path;
    if (s.setup.stock) add(box, check::box_of(*s.setup.stock));
    if (s.setup.part) add(box, check::box_of(*s.setup.part));
    for (const check::MoveTrace& m : s.result.moves) {
        for (const geom::Vec2 p : {m.from, m.to})
            if (std::isfinite(p.x + p.y)) path.add(p);
        for (const geom::Vec2 p : m.via) path.add(p);
    }
    if (box.empty()) add(box, path);
    if (box.empty()) add(box, {0, 100, 0, 50});
    const double around = 0.12 * size_of(box), air = 0.03 * size_of(box);
    check::Box limit = grown(box, 3 * around);  // a chuck is seen as one where it cannot be shown whole
    for (const check::TurnedClamp& c : s.setup.turned_clamps) {
        const check::Box clamp = check::box_of(c.body);
        add(box, {std::max(clamp.min_z, limit.min_z), std::min(clamp.max_z, limit.max_z),
                  std::max(clamp.min_x, limit.min_x), std::min(clamp.max_x, limit.max_x)});
    }
    limit = grown(box, around);
    if (!path.empty())
        add(box,
            {std::clamp(path.min_z, limit.min_z, box.min_z + 0.0), std::clamp(path.max_z, box.max_z, limit.max_z),
             std::clamp(path.min_x, limit.min_x, box.min_x + 0.0), std::clamp(path.max_x, box.max_x, limit.max_x)});
    return grown(box, air);
}

/// Where the findings lie, if that is so small a place in the whole that it is worth a drawing of its own.
std::optional<check::Box> detail_of(const Subject& s, const check::Box& whole) {
    check::Box box;
    for (const check::Finding& f : s.result.findings) add(box, check::box_of(f.region));
    if (box.empty()) return std::nullopt;
    box = grown(box, 0.15 * size_of(box));
    // As tall and wide as the room it gets, so that nothing of it stays empty.
    const double ratio = svg::detail_width / svg::most_height, z = box.max_z - box.min_z, x = box.max_x - box.min_x;
    const double missing_z = std::max(0.0, x * ratio - z), missing_x = std::max(0.0, z * 0.6 - x);
    box = {box.min_z - missing_z / 2, box.max_z + missing_z / 2, box.min_x - missing_x / 2, box.max_x + missing_x / 2};
    if (size_of(box) > 0.45 * size_of(whole)) return std::nullopt;
    return box;
}

std::string legend(const Subject& s, double y) {
    std::string out;
    double x = svg::margin;
    const auto entry = [&](const char* cls, const char* shape, const char* label, double width) {
        out += std::string("<path class=\"") + cls + "\" d=\"M" + number(x, 1) + " " + number(y, 1) + shape + "\"/>\n" +
               svg::text("", x + 34, y + 5, label);
        x += width;
    };
    constexpr const char* patch = "m0 -7h26v14h-26z";
    constexpr const char* stroke = "h28";
    if (s.setup.stock) {
        entry("before", patch, "removed stock", 130);
        entry("after", patch, "stock at the end", 140);
    }
    if (!s.setup.turned_clamps.empty()) entry("clamp", patch, "clamp", 90);
    if (s.setup.part) entry("part", stroke, "finished part", 124);
    if (s.setup.allowance) entry("allowance", stroke, "allowance", 106);
    if (!s.result.moves.empty()) {
        entry("feed", stroke, "feed", 72);
        entry("rapid", stroke, "rapid", 76);
    }
    const auto& all = s.result.findings;
    if (std::any_of(all.begin(), all.end(), [](const check::Finding& f) { return !f.region.empty(); }))
        entry("bad", patch, "finding, numbered as below", 200);
    return out;
}

/// One line of the list below the picture.
std::string entry_of(const Subject& s, const check::Group& group, std::size_t i) {
    const check::Finding& f = s.result.findings[group.worst];
    const Place p = place(s.sources, f.where);
    std::string entry = std::to_string(i + 1) + "  ";
    if (!p.file.empty()) entry += p.file + ":" + std::to_string(p.line) + " ";
    entry += "[" + std::string(f.code) + "] ";
    if (group.times > 1) entry += passes_line(s, group) + ": ";
    entry += f.text;
    if (entry.size() <= widest_entry) return entry;
    return entry.substr(0, entry.rfind(' ', widest_entry - 4)) + " …";
}

std::string list(const Subject& s, double& y) {
    std::string out;
    const auto line = [&](const char* cls, const std::string& text) {
        out += svg::text(cls, svg::margin, y, text);
        y += 16;
    };
    const check::Result& r = s.result;
    const std::vector<check::Group> groups = check::groups_of(r);
    const std::size_t shown = std::min(groups.size(), most_entries);
    for (std::size_t i = 0; i < shown; ++i) line("mono", entry_of(s, groups[i], i));
    if (groups.size() > shown) line("mono", "… and " + count_of(groups.size() - shown, "more finding"));
    if (!r.moves.empty() && r.moves.size() < r.stats.moves)
        line("small",
             "Tool path: the first " + std::to_string(r.moves.size()) + " of " + count_of(r.stats.moves, "move") + ".");
    return out;
}

std::string title(const Subject& s) {
    std::string below = "machine " + s.setup.machine.name;
    if (!s.control.empty()) below = "control " + s.control + ", " + below;
    if (!s.date.empty()) below += ", " + s.date;
    return svg::text("title", svg::margin, 30, s.program + ": " + verdict_line(s.result)) +
           svg::text("small", svg::margin, 50, below + ". All figures in mm, X is a radius. Profiles are exact.");
}

}  // namespace

std::string to_svg(const Subject& s, const SvgOptions& options) {
    const check::Box whole = bounds(s);
    const std::optional<check::Box> part = detail_of(s, whole);
    std::vector<Mark> marks = marks_of(s.result);
    if (marks.size() > most_marks) marks.resize(most_marks);
    const double room =
        options.width - svg::margin - svg::margin_right - (part ? svg::detail_width + svg::detail_gap : 0);
    const Window main("drawing", whole, svg::margin, svg::top_of_window, room, svg::most_height);
    std::string out = title(s) + main.draw(s, part ? std::vector<Mark>{} : marks);
    double bottom = main.bottom();
    if (part) {
        const Window detail("detail", *part, main.right() + svg::detail_gap, svg::top_of_window,
                            options.width - svg::margin_right - main.right() - svg::detail_gap, svg::most_height);
        const geom::Vec2 a = main.projection()({part->min_z, part->max_x}),
                         b = main.projection()({part->max_z, part->min_x});
        out += "<rect class=\"zoomed\" x=\"" + number(a.x, 2) + "\" y=\"" + number(a.y, 2) + "\" width=\"" +
               number(b.x - a.x, 2) + "\" height=\"" + number(b.y - a.y, 2) + "\"/>\n" +
               svg::line("zoomed", b.x, a.y, detail.left(), svg::top_of_window) +
               svg::line("zoomed", b.x, b.y, detail.left(), detail.bottom()) + detail.draw(s, marks);
        bottom = std::max(bottom, detail.bottom());
    }
    double y = bottom + svg::axis_room + 12;
    out += legend(s, y);
    y += svg::legend_room;
    out += list(s, y);
    return svg::document(options.width, y + 6, out);
}

}  // namespace obrys::report
