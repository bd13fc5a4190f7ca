/// What a sheet says, in words.

#include <algorithm>

#include "base/number.hpp"
#include "cl/unknown_tool.hpp"
#include "report/clock.hpp"
#include "report/sheet/sheet.hpp"

namespace obrys::report::sheet {

namespace {

/// Without the zeros at its end; "?" where it is not known.
std::string decimal(double value, int decimals = 3) {
    if (!std::isfinite(value)) return "?";
    std::string text = base::fixed(value, decimals);
    if (text.find('.') != std::string::npos) {
        text.erase(text.find_last_not_of('0') + 1);
        if (text.ends_with('.')) text.pop_back();
    }
    return text;
}

std::string number_text(std::uint32_t number) { return number == cl::unknown_tool ? "?" : std::to_string(number); }

/// "(40; 100) x (20; 20) x (16.996; 150) mm"
std::string extent_text(const Extent& e) {
    const auto one = [](double low, double high) { return "(" + decimal(low) + "; " + decimal(high) + ")"; };
    return one(e.low.x, e.high.x) + " x " + one(e.low.y, e.high.y) + " x " + one(e.low.z, e.high.z) + " mm";
}

std::string range_text(double least, double most, int decimals) {
    if (std::isnan(least)) return "";
    return least == most ? decimal(most, decimals) : decimal(least, decimals) + " - " + decimal(most, decimals);
}

std::string tool_text(const ToolUse& t) {
    std::string out = "T" + number_text(t.number);
    if (t.number == 0) out = t.name.empty() ? "none" : t.name;
    return t.edge == 0 || t.number == 0 ? out : out + " D" + number_text(t.edge);
}

std::string cycles_text(const ToolUse& t) {
    std::string out;
    for (const auto& [kind, count] : t.cycles) out += (out.empty() ? "" : ", ") + std::to_string(count) + " " + kind;
    return out;
}

std::string size_of(const ToolUse& t) { return decimal(std::isnan(t.width) ? t.diameter : t.width); }

Table tool_table(const std::vector<ToolUse>& tools) {
    Table t{"Tools",
            {"tool", "name", "kind", "diameter or width mm", "corner mm", "length mm", "speed 1/min", "feed mm/min",
             "coolant", "lowest z mm", "cycles"},
            {}};
    for (const ToolUse& u : tools)
        t.rows.push_back({tool_text(u), u.name, u.kind.empty() ? "not in a list" : u.kind, size_of(u),
                          decimal(u.corner), decimal(u.length), range_text(u.least_speed, u.most_speed, 0),
                          range_text(u.least_feed, u.most_feed, 1),
                          u.flood && u.mist ? "flood, mist"
                          : u.flood         ? "flood"
                          : u.mist          ? "mist"
                                            : "",
                          decimal(u.cut.low.z), cycles_text(u)});
    return t;
}

std::vector<std::string> time_row(const std::string& what, const Times& t) {
    return {what,
            decimal(t.feed_mm, 1),
            decimal(t.rapid_mm, 1),
            decimal(t.feed_s, 1),
            decimal(t.rapid_s, 1),
            decimal(t.dwell_s, 1),
            decimal(t.seconds(), 1),
            t.is_whole() ? "" : "and more"};
}

Table time_table(const std::vector<ToolUse>& tools, const Times& all) {
    Table t{"Times, estimated without acceleration",
            {"tool", "feed path mm", "rapid path mm", "feed s", "rapid s", "dwell s", "together s", ""},
            {}};
    for (const ToolUse& u : tools) t.rows.push_back(time_row(tool_text(u), u.times));
    t.rows.push_back(time_row("all", all));
    return t;
}

Table zero_table(const std::vector<ZeroUse>& zeros) {
    Table t{"Zeros", {"zero", "X in the machine mm", "Y mm", "Z mm", "moves", "travel"}, {}};
    for (const ZeroUse& z : zeros)
        t.rows.push_back({z.number == 0 ? "machine" : std::to_string(z.number), decimal(z.origin.x),
                          decimal(z.origin.y), decimal(z.origin.z), std::to_string(z.moves), extent_text(z.extent)});
    return t;
}

Table list_of(const std::string& title, const std::vector<std::string>& lines) {
    Table t{title, {""}, {}};
    for (const std::string& line : lines) t.rows.push_back({line});
    return t;
}

void add_remarks(std::vector<std::string>& to, const Times& t) {
    if (t.untimed_mm > 0)
        to.push_back("not in the times: " + decimal(t.untimed_mm, 1) +
                     " mm whose feed, or the speed it counts with, is not known");
    if (t.untimed_dwells > 0)
        to.push_back("not in the times: " + std::to_string(t.untimed_dwells) +
                     " dwells in revolutions of a speed that is not known");
    if (t.unmeasured > 0)
        to.push_back("in no path and no time: " + std::to_string(t.unmeasured) +
                     " moves from or to where it is not known");
    if (t.rotary > 0)
        to.push_back("in no path and no time: " + std::to_string(t.rotary) + " moves of rotary axes alone");
}

std::string total_text(const Times& t) { return (t.is_whole() ? "" : "at least ") + clock(t.seconds()); }

/// One tool is named with its diameter; of several the table tells.
std::string tools_text(const std::vector<ToolUse>& tools) {
    if (tools.size() != 1) return std::to_string(tools.size()) + ", see below";
    return tool_text(tools[0]) + (tools[0].kind.empty() ? "" : ", " + tools[0].kind) +
           (std::isnan(tools[0].width) ? ", diameter " : ", width ") + size_of(tools[0]) + " mm";
}

Page page_of(const Program& p) {
    Page page;
    page.title = p.name;
    page.facts = {{"program", p.name},
                  {"control", p.control},
                  {"machine", p.machine},
                  {"stock", p.stock.empty() ? "?" : p.stock},
                  {p.lathe ? "tool travel (X radius, Y, Z)" : "tool travel (X x Y x Z)", extent_text(p.travel)},
                  {"travel at feed", extent_text(p.cut)},
                  {"tools", tools_text(p.tools)},
                  {"estimated time", total_text(p.times)},
                  {"tool changes, stops", std::to_string(p.tool_changes) + ", " + std::to_string(p.stops) + " and " +
                                              std::to_string(p.optional_stops) + " optional"}};
    page.tables.push_back(tool_table(p.tools));
    page.tables.push_back(zero_table(p.zeros));
    if (!p.clamps.empty()) page.tables.push_back(list_of("Clamps", p.clamps));
    page.tables.push_back(time_table(p.tools, p.times));
    if (!p.called.empty()) page.tables.push_back(list_of("Programs that it calls", p.called));
    if (!p.messages.empty()) page.tables.push_back(list_of("Messages for the operator", p.messages));
    page.remarks.push_back("Times follow from path, feed and rapid (" + decimal(p.rapid, 0) +
                           " mm/min, the slowest linear axis of " + p.machine +
                           "), without acceleration and tool changes.");
    if (!p.not_whole.empty()) page.remarks.push_back(p.not_whole);
    add_remarks(page.remarks, p.times);
    return page;
}

/// Tools of the same number, edge, name and diameter are one.
Page job_page(const std::vector<Program>& programs) {
    std::vector<ToolUse> tools;
    Times all;
    Page page;
    page.title = "Job of " + std::to_string(programs.size()) + " programs";
    Table list{"Programs", {"program", "machine", "tool changes", "estimated time"}, {}};
    for (const Program& p : programs) {
        all.add(p.times);
        list.rows.push_back({p.name, p.machine, std::to_string(p.tool_changes), total_text(p.times)});
        for (const ToolUse& use : p.tools) {
            const auto same = std::find_if(tools.begin(), tools.end(), [&](const ToolUse& t) {
                return t.number == use.number && t.edge == use.edge && t.name == use.name &&
                       (t.diameter == use.diameter || (std::isnan(t.diameter) && std::isnan(use.diameter)));
            });
            if (same == tools.end()) {
                tools.push_back(use);
                continue;
            }
            same->times.add(use.times);
            same->calls += use.calls;
            same->cut.add(use.cut.low);
            same->cut.add(use.cut.high);
            same->least_feed = std::fmin(same->least_feed, use.least_feed);
            same->most_feed = std::fmax(same->most_feed, use.most_feed);
            same->least_speed = std::fmin(same->least_speed, use.least_speed);
            same->most_speed = std::fmax(same->most_speed, use.most_speed);
            same->flood = same->flood || use.flood;
            same->mist = same->mist || use.mist;
            for (const auto& [kind, count] : use.cycles) same->cycles[kind] += count;
        }
    }
    page.facts = {{"programs", std::to_string(programs.size())},
                  {"tools", tools_text(tools)},
                  {"estimated time", total_text(all)}};
    page.tables = {std::move(list), tool_table(tools), time_table(tools, all)};
    add_remarks(page.remarks, all);
    return page;
}

Page since_page(const Since& since) {
    Page page;
    page.title = "Since " + since.name;
    if (since.lines.empty())
        page.remarks.push_back("Nothing differs.");
    else
        page.tables.push_back(list_of("Differences", since.lines));
    return page;
}

}  // namespace

std::vector<Page> pages(const std::vector<Program>& programs, const Options& options,
                        const std::optional<Since>& since) {
    std::vector<Page> out;
    if (since) out.push_back(since_page(*since));
    if (options.job) out.push_back(job_page(programs));
    for (const Program& p : programs) out.push_back(page_of(p));
    return out;
}

}  // namespace obrys::report::sheet
