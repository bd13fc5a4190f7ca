#include "report/page_data.hpp"

#include <cmath>
#include <map>
#include <set>

#include "base/number.hpp"
#include "base/text.hpp"
#include "check/turning/turning_tool.hpp"
#include "report/json_parts.hpp"
#include "report/page_parts.hpp"
#include "report/path.hpp"
#include "report/svg_window.hpp"

namespace obrys::report {

namespace {

/// The page draws in millimetres with y downwards.
constexpr Projection millimetres{1, 0, 0, 4};

/// Four decimals are plenty to look at; null where not known.
Json rounded(double v) {
    if (!std::isfinite(v)) return nullptr;
    return std::round(v * 1e4) / 1e4 + 0.0;
}
Json point(geom::Vec2 p) { return {rounded(p.x), rounded(-p.y)}; }

/// Collects the page's parts; files are numbered as the page shows them.
class Data {
public:
    Data(const Subject& subject, const HtmlOptions& options) : s_(subject), r_(subject.result), options_(options) {}
    Json all();

private:
    Json files();
    Json moves();
    Json findings();
    Json marks();
    Json notes(const std::vector<check::Note>& list);
    Json tools();
    Json regions();
    Json head();
    Json stats();
    Json site(const base::Span& span);
    Json stack(const std::vector<base::Span>& sites);
    [[nodiscard]] std::size_t move_count() const { return std::min(r_.moves.size(), options_.most_moves); }

    const Subject& s_;
    const check::Result& r_;
    const HtmlOptions& options_;
    std::map<std::uint32_t, std::size_t> shown_;  ///< file of the sources -> file of the page
};

/// {f: file of the page or -1, l: line, b: block, n: file name, t: text}
Json Data::site(const base::Span& span) {
    const Place p = place(s_.sources, span);
    if (p.file.empty()) return nullptr;
    const auto shown = shown_.find(span.file);
    Json j{{"f", shown == shown_.end() ? -1 : static_cast<int>(shown->second)},
           {"l", p.line},
           {"n", p.file},
           {"t", p.text}};
    if (p.block) j["b"] = *p.block;
    return j;
}

Json Data::stack(const std::vector<base::Span>& sites) {
    Json all = Json::array();
    for (const base::Span& s : sites) all.push_back(site(s));
    return all;
}

/// [{name, lines, cut: lines left out}]: program texts, and whatever a finding points at.
Json Data::files() {
    std::set<std::uint32_t> wanted;
    for (std::uint32_t i = 0; i < s_.sources.size(); ++i)
        if (s_.sources[i].block_numbers != base::BlockNumbers::none) wanted.insert(i);
    for (const check::MoveTrace& m : r_.moves) wanted.insert(m.where.file);
    for (const check::Finding& f : r_.findings) wanted.insert(f.where.file);
    Json all = Json::array();
    std::size_t room = options_.most_lines;
    for (const std::uint32_t file : wanted) {
        if (file >= s_.sources.size()) continue;
        shown_[file] = all.size();
        const base::Source& source = s_.sources[file];
        Json lines = Json::array();
        const std::uint32_t count = s_.sources.position(file, static_cast<std::uint32_t>(source.text.size())).line;
        for (std::uint32_t n = 1; n <= count && room > 0; ++n, --room) {
            const std::string_view raw = s_.sources.line(file, n);
            lines.push_back(source.utf8 ? std::string(raw) : base::cp1252_to_utf8(raw));
        }
        const std::size_t kept = lines.size();
        all.push_back({{"name", base::as_utf8(source.name)}, {"lines", std::move(lines)}, {"cut", count - kept}});
    }
    return all;
}

/// Arrays by move: end point p (z, -x flat), kind "r"/"f", file f, line l, call stack k, tool t, area a, depth d;
/// by index where there is one: arc [cz, -cx, sweep], points of a curve between its ends (z, -x flat), start point of a
/// move that does not begin where the last one ended, removed region. `stacks` holds the call stacks by their number.
Json Data::moves() {
    Json p = Json::array(), f = Json::array(), l = Json::array(), k = Json::array(), t = Json::array(),
         a = Json::array(), d = Json::array(), arcs = Json::object(), starts = Json::object(), removed = Json::object(),
         vias = Json::object(), stacks = Json::object();
    std::string kinds;
    geom::Vec2 pen{NAN, NAN};
    for (std::size_t i = 0; i < move_count(); ++i) {
        const check::MoveTrace& m = r_.moves[i];
        const std::string key = std::to_string(i);
        p.push_back(rounded(m.to.x));
        p.push_back(rounded(-m.to.y));
        kinds += m.rapid ? 'r' : 'f';
        const auto shown = shown_.find(m.where.file);
        f.push_back(shown == shown_.end() ? -1 : static_cast<int>(shown->second));
        l.push_back(shown == shown_.end() ? 0 : s_.sources.position(m.where).line);
        k.push_back(m.stack);
        t.push_back(m.tool);
        a.push_back(rounded(m.area));
        d.push_back(rounded(m.depth_x));
        if (m.sweep != 0) arcs[key] = {rounded(m.centre.x), rounded(-m.centre.y), m.sweep};
        for (const geom::Vec2& v : m.via) {
            vias[key].push_back(rounded(v.x));
            vias[key].push_back(rounded(-v.y));
        }
        if (!(pen == m.from) && std::isfinite(m.from.x + m.from.y)) starts[key] = point(m.from);
        if (!m.removed.empty()) removed[key] = path_of(m.removed, millimetres);
        const std::string stack_key = std::to_string(m.stack);
        if (m.stack != 0 && !stacks.contains(stack_key)) stacks[stack_key] = stack(s_.stacks.sites(m.stack));
        pen = m.to;
    }
    return {{"n", move_count()},
            {"p", p},
            {"kind", kinds},
            {"f", f},
            {"l", l},
            {"k", k},
            {"t", t},
            {"a", a},
            {"d", d},
            {"arc", arcs},
            {"via", vias},
            {"start", starts},
            {"removed", removed},
            {"stacks", stacks}};
}

/// Sorted by danger; `no` is the number in the order of the program, as in text and picture. `moves`: all that did it.
Json Data::findings() {
    Json all = Json::array();
    const std::vector<check::Group> groups = check::groups_of(r_);
    for (const std::size_t i : by_danger(r_, groups)) {
        const check::Finding& f = r_.findings[groups[i].worst];
        Json j{{"no", i + 1},
               {"code", f.code},
               {"severity", base::name(f.severity)},
               {"text", f.text},
               {"remedy", f.remedy}};
        j["where"] = site(f.where);
        j["stack"] = stack(f.stack);
        j["move"] = f.move ? Json(*f.move) : Json(nullptr);
        j["passes"] = passes_line(s_, groups[i]);
        j["moves"] = Json::array();
        std::string region;
        for (const std::size_t k : groups[i].members) {
            region += path_of(r_.findings[k].region, millimetres);
            if (r_.findings[k].move) j["moves"].push_back(*r_.findings[k].move);
        }
        j["region"] = region;
        j["amounts"] = Json::array();
        for (const check::Amount& a : f.amounts) {
            const AmountWords w = amount_words(a.key);
            j["amounts"].push_back({w.label, base::fixed(a.value, 3), w.unit});
        }
        all.push_back(std::move(j));
    }
    return all;
}

/// [{label, at, no: the first finding of the mark}]
Json Data::marks() {
    Json all = Json::array();
    for (const Mark& m : marks_of(r_)) all.push_back({{"label", m.label}, {"at", point(m.at)}, {"no", m.first}});
    return all;
}

Json Data::notes(const std::vector<check::Note>& list) {
    Json all = Json::array();
    for (const check::Note& n : list)
        all.push_back(
            {{"code", n.code}, {"text", n.text}, {"remedy", n.remedy}, {"where", site(n.where)}, {"times", n.times}});
    return all;
}

std::string describe(const shop::Tool& t) {
    const auto mm = [](double v) { return base::shortest(std::round(v * 1e4) / 1e4); };
    if (t.kind == shop::ToolKind::groove)
        return "grooving insert, width " + mm(t.width) + " mm, corner radius " + mm(t.corner_radius) +
               " mm, reference " + (t.reference == shop::ReferenceCorner::left ? "left" : "right") + " corner";
    if (t.kind == shop::ToolKind::turning)
        return "turning insert, nose radius " + mm(t.nose_radius) + " mm, orientation " +
               std::to_string(t.orientation) + ", tip angle " + mm(t.tip_angle) + " degrees";
    if (shop::is_milling(t.kind) && !check::turning_outline(t).vertices.empty())
        return std::string(shop::kind_word(t.kind)) + ", diameter " + mm(2 * t.radius) + " mm, on the turning axis";
    return "not simulated";
}

Json Data::tools() {
    Json all = Json::array();
    for (const check::ToolUse& t : r_.tools) {
        const shop::Tool* tool = t.listed ? &s_.setup.tools[*t.listed] : nullptr;
        Json j{
            {"number", t.number}, {"edge", t.edge}, {"name", t.name.empty() && tool != nullptr ? tool->name : t.name}};
        j["kind"] = tool != nullptr ? describe(*tool) : "not in the tool list";
        j["outline"] = tool != nullptr ? path_of(check::turning_outline(*tool), millimetres) : "";
        j["holder"] = "";
        if (tool != nullptr) j["holder"] = path_of(geom::Region{tool->bodies}, millimetres);
        j["first"] = site(t.first);
        j["last"] = site(t.last);
        j["moves"] = t.moves;
        j["feed_mm"] = base::fixed(t.feed_length_mm, 1);
        j["rapid_mm"] = base::fixed(t.rapid_length_mm, 1);
        j["volume_cm3"] = base::fixed(t.volume_mm3 / 1000, 2);
        all.push_back(std::move(j));
    }
    return all;
}

Json Data::regions() {
    const auto path = [](const std::optional<geom::Region>& r) { return r ? path_of(*r, millimetres) : std::string(); };
    Json snapshots = Json::array();
    for (const check::Snapshot& s : r_.snapshots)
        if (s.moves <= move_count()) snapshots.push_back({s.moves, path_of(s.stock, millimetres)});
    std::string clamps;
    for (const check::TurnedClamp& c : s_.setup.turned_clamps) clamps += path_of(c.body, millimetres);
    return {{"before", path(s_.setup.stock)},
            {"clamp", std::move(clamps)},
            {"after", path_of(r_.stock_after, millimetres)},
            {"part", path(s_.setup.part)},
            {"allowance", path(s_.setup.allowance)},
            {"snapshots", std::move(snapshots)}};
}

Json Data::head() {
    return {{"program", s_.program},    {"control", s_.control},       {"machine", s_.setup.machine.name},
            {"date", s_.date},          {"version", s_.version},       {"verdict", check::name(r_.verdict)},
            {"line", verdict_line(r_)}, {"moves_all", r_.stats.moves}, {"dropped", r_.findings_dropped}};
}

/// Rows of the table of figures: [label, value, unit].
Json Data::stats() {
    const check::Stats& t = r_.stats;
    Json rows = Json::array();
    const auto row = [&rows](const char* label, const std::string& value, const char* unit) {
        rows.push_back({label, value, unit});
    };
    row("moves", std::to_string(t.moves), "");
    row("rapid moves", std::to_string(t.rapid_moves), "");
    row("feed moves", std::to_string(t.feed_moves), "");
    row("rapid path", base::fixed(t.rapid_length_mm, 3), "mm");
    row("feed path", base::fixed(t.feed_length_mm, 3), "mm");
    row("blocks executed", std::to_string(t.blocks_executed), "");
    if (r_.before && r_.after) {
        row("stock before", base::fixed(r_.before->volume_mm3 / 1000, 3), "cm3");
        row("stock after", base::fixed(r_.after->volume_mm3 / 1000, 3), "cm3");
        row("section before", base::fixed(r_.before->area_mm2, 3), "mm2");
        row("section after", base::fixed(r_.after->area_mm2, 3), "mm2");
    }
    return rows;
}

Json Data::all() {
    Json j{{"head", head()}};
    j["files"] = files();
    j["moves"] = moves();
    j["regions"] = regions();
    j["findings"] = findings();
    j["marks"] = marks();
    j["unchecked"] = notes(r_.unchecked);
    j["assumptions"] = notes(r_.assumptions);
    j["listed"] = notes(r_.listed);
    j["tools"] = tools();
    j["stats"] = stats();
    return j;
}

}  // namespace

std::string page_data(const Subject& subject, const HtmlOptions& options) {
    return for_script(Data(subject, options).all().dump(-1, ' ', false, Json::error_handler_t::replace));
}

}  // namespace obrys::report
