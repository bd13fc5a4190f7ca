#include "report/json_parts.hpp"
#include "report/report.hpp"

namespace obrys::report {

namespace {

Json point(geom::Vec3 p) {
    return {{"x", number_or_null(p.x)}, {"y", number_or_null(p.y)}, {"z", number_or_null(p.z)}};
}

Json site(const base::Sources& sources, const base::Span& span) {
    const Place p = place(sources, span);
    if (p.file.empty()) return {{"file", nullptr}, {"line", nullptr}, {"column", nullptr}, {"block", nullptr}};
    Json j{{"file", p.file},
           {"line", p.line},
           {"column", p.column},
           {"end_line", p.end_line},
           {"end_column", p.end_column}};
    j["block"] = p.block ? Json(*p.block) : Json(nullptr);
    j["text"] = p.text;
    return j;
}

Json where(const base::Sources& sources, const base::Span& span, const std::vector<base::Span>& stack) {
    Json j = site(sources, span);
    j["stack"] = Json::array();
    for (const base::Span& s : stack) j["stack"].push_back(site(sources, s));
    return j;
}

void add_move(Json& j, const check::Finding& f) {
    j["move"] = f.move ? Json(*f.move) : Json(nullptr);
    if (f.from) j["from_mm"] = point(*f.from);
    if (f.to) j["to_mm"] = point(*f.to);
    for (const check::Amount& a : f.amounts) j[std::string(a.key)] = number_or_null(a.value);
}

/// What each move of a group did.
Json members(const check::Group& group, const Subject& s) {
    Json all = Json::array();
    for (const std::size_t i : group.members) {
        const check::Finding& f = s.result.findings[i];
        Json j{{"message", f.text}};
        j["where"] = where(s.sources, f.where, f.stack);
        add_move(j, f);
        j["more"] = f.more;
        all.push_back(std::move(j));
    }
    return all;
}

/// The worst of the group speaks for it.
Json finding(const check::Group& group, const Subject& s, bool all) {
    const check::Finding& f = s.result.findings[group.worst];
    Json j{{"code", f.code}, {"severity", base::name(f.severity)}, {"message", f.text}};
    if (!f.remedy.empty()) j["remedy"] = f.remedy;
    j["where"] = where(s.sources, f.where, f.stack);
    j["times"] = group.times;
    j["first_move"] = group.first_move ? Json(*group.first_move) : Json(nullptr);
    if (s.result.has_baseline) j["known"] = group.known;
    add_move(j, f);
    if (const auto lines = lines_of(s, group); lines.size() > 1 || (!lines.empty() && lines.front().second.size() > 1))
        for (const auto& [file, numbers] : lines) j["lines"].push_back({{"file", file}, {"lines", numbers}});
    if (all) j["moves"] = members(group, s);
    const std::vector<base::Related> related = check::related_of(s.result, group);
    if (!related.empty()) j["related"] = Json::array();
    for (const base::Related& r : related)
        j["related"].push_back({{"message", r.text}, {"where", site(s.sources, r.where)}});
    return j;
}

Json notes(const std::vector<check::Note>& list, const base::Sources& sources) {
    Json all = Json::array();
    for (const check::Note& n : list) {
        Json j{{"code", n.code}, {"message", n.text}};
        if (!n.remedy.empty()) j["remedy"] = n.remedy;
        j["where"] = where(sources, n.where, n.stack);
        j["times"] = n.times;
        all.push_back(std::move(j));
    }
    return all;
}

Json stats(const check::Stats& s) {
    return {{"moves", s.moves},
            {"rapid_moves", s.rapid_moves},
            {"feed_moves", s.feed_moves},
            {"rapid_length_mm", s.rapid_length_mm},
            {"feed_length_mm", s.feed_length_mm},
            {"blocks_executed", s.blocks_executed}};
}

Json figures(const std::optional<check::StockFigures>& f) {
    if (!f) return nullptr;
    return {{"area_mm2", f->area_mm2}, {"volume_mm3", f->volume_mm3}};
}

Json tools(const Subject& s) {
    Json all = Json::array();
    for (const check::ToolUse& t : s.result.tools)
        all.push_back({{"number", t.number},
                       {"edge", t.edge},
                       {"name", t.name},
                       {"listed", t.listed.has_value()},
                       {"moves", t.moves},
                       {"feed_length_mm", t.feed_length_mm},
                       {"rapid_length_mm", t.rapid_length_mm},
                       {"volume_mm3", t.volume_mm3},
                       {"first", site(s.sources, t.first)},
                       {"last", site(s.sources, t.last)}});
    return all;
}

Json milled_json(const check::Milled& m) {
    const check::MillingFigures& f = m.figures;
    Json j{{"tolerance_mm", f.tolerance_mm},
           {"step_mm", {f.step.x, f.step.y, f.step.z}},
           {"memory_mb", f.memory_mb},
           {"before_mm3", f.before_mm3},
           {"after_mm3", f.after_mm3},
           {"contact_length_mm", f.contact_length_mm},
           {"contact_accuracy_mm", f.contact_accuracy_mm}};
    if (!m.surface.empty()) {
        j["refined_cells"] = f.refined_cells;
        j["finest_mm"] = f.finest_mm;
    }
    if (m.comparison) {
        j["largest_gouge_mm"] = m.comparison->largest_gouge;
        j["largest_excess_mm"] = m.comparison->largest_excess;
    }
    return j;
}

}  // namespace

std::string unreadable_json(const Unreadable& input) {
    Json j{{"format", "obrys-check"}, {"version", json_version}, {"program", input.input}, {"verdict", nullptr}};
    j["errors"] = Json::array();
    for (const base::Diagnostic& d : input.diagnostics) j["errors"].push_back({{"code", d.code}, {"message", d.text}});
    return j.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string to_json(const Subject& s, bool all) {
    const check::Result& r = s.result;
    Json j{{"format", "obrys-check"}, {"version", json_version}, {"tool", {{"name", "obrys"}, {"version", s.version}}}};
    j["program"] = s.program;
    j["control"] = s.control;
    j["machine"] = s.setup.machine.name;
    if (!s.date.empty()) j["date"] = s.date;
    j["verdict"] = check::name(r.verdict);
    j["scope"] = shop::name(r.scope);
    j["findings"] = Json::array();
    for (const check::Group& g : check::groups_of(r)) j["findings"].push_back(finding(g, s, all));
    j["findings_dropped"] = r.findings_dropped;
    j["unchecked"] = notes(r.unchecked, s.sources);
    j["assumptions"] = notes(r.assumptions, s.sources);
    j["listed"] = notes(r.listed, s.sources);
    j["stats"] = stats(r.stats);
    j["stock"] = {{"before", figures(r.before)}, {"after", figures(r.after)}};
    j["tools"] = tools(s);
    if (r.milled != nullptr) j["milling"] = milled_json(*r.milled);
    return j.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace obrys::report
