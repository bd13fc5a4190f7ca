#include "report/milling_page.hpp"

#include <algorithm>
#include <cmath>

#include "base/text.hpp"
#include "report/json_parts.hpp"
#include "report/milling_arrays.hpp"
#include "report/page_parts.hpp"
#include "report/path.hpp"
#include "report/report.hpp"

namespace obrys::report {

namespace {

Json value_or_null(const std::optional<double>& v) { return v ? number_or_null(*v) : Json(nullptr); }
Json page_point(geom::Vec3 p) { return {number_or_null(p.x), number_or_null(p.y), number_or_null(p.z)}; }

/// {f: text of the page or -1, l: line, n: the text's name}; null: nowhere
Json page_site(const MillingPage& page, const PageSite& where) {
    if (where.file >= page.texts.size()) return nullptr;
    return {{"f", where.file}, {"l", where.line}, {"n", base::as_utf8(page.texts[where.file].name)}};
}

Json box(const PageBox& b) { return {{"min", page_point(b.min)}, {"max", page_point(b.max)}, {"name", b.name}}; }

Json finding(const MillingPage& page, const PageFinding& f, std::size_t number_of) {
    Json j{{"no", number_of}, {"code", f.code}, {"severity", base::name(f.severity)}, {"text", f.text}};
    j["remedy"] = f.remedy;
    j["where"] = page_site(page, f.where);
    j["move"] = f.move && *f.move < page.path.moves.size() ? Json(*f.move) : Json(nullptr);
    j["passes"] = f.passes;
    j["moves"] = Json::array();
    for (const std::uint32_t m : f.moves)
        if (m < page.path.moves.size()) j["moves"].push_back(m);
    const bool placed = f.place && std::isfinite(f.place->x + f.place->y + f.place->z);
    j["at"] = placed ? page_point(*f.place) : Json(nullptr);
    j["amounts"] = Json::array();
    for (const PageAmount& a : f.amounts) j["amounts"].push_back({a.label, a.value, a.unit});
    return j;
}

Json tool(const PageTool& t) {
    Json j{{"number", t.number},
           {"name", t.name},
           {"kind", t.kind},
           {"radius", value_or_null(t.radius)},
           {"corner", value_or_null(t.corner_radius)},
           {"cutting", value_or_null(t.cutting_length)}};
    j["outline"] = Json::array();
    for (const geom::Vec2 p : t.outline)
        if (std::isfinite(p.x + p.y)) j["outline"].push_back({p.x, p.y});
    j["bodies"] = Json::array();
    for (const PageToolBody& b : t.bodies)
        if (std::isfinite(b.from + b.to + b.radius_from + b.radius_to))
            j["bodies"].push_back({b.from, b.to, b.radius_from, b.radius_to, b.holder});
    j["volume"] = value_or_null(t.volume_mm3);
    j["moves"] = t.moves;
    j["feed"] = value_or_null(t.feed_mm);
    j["rapid"] = value_or_null(t.rapid_mm);
    return j;
}

Json notes(const MillingPage& page, const std::vector<PageNote>& list) {
    Json all = Json::array();
    for (const PageNote& n : list)
        all.push_back({{"text", n.text}, {"remedy", n.remedy}, {"where", page_site(page, n.where)}});
    return all;
}

Json head(const MillingPage& page) {
    return {{"program", page.title},
            {"control", page.control},
            {"machine", page.machine},
            {"date", page.date},
            {"version", page.version},
            {"verdict", check::name(page.verdict)},
            {"line", page.verdict_line},
            {"dropped", page.findings_dropped},
            {"moves_all", std::max<std::uint64_t>(page.moves_all, page.path.moves.size())},
            {"moves_left_out", page.moves_left_out}};
}

Json all_of(const MillingPage& page) {
    Json j{{"head", head(page)}};
    for (const char* list : {"findings", "texts", "tools", "clamps", "figures"}) j[list] = Json::array();
    for (const PageFinding& f : page.findings) j["findings"].push_back(finding(page, f, j["findings"].size() + 1));
    for (const PageText& t : page.texts)
        j["texts"].push_back({{"name", base::as_utf8(t.name)}, {"text", base::as_utf8(t.text)}});
    for (const PageTool& t : page.tools) j["tools"].push_back(tool(t));
    for (const PageBox& c : page.clamps) j["clamps"].push_back(box(c));
    for (const PageFigure& f : page.figures) j["figures"].push_back({f.label, f.value, f.unit});
    j["unchecked"] = notes(page, page.unchecked);
    j["assumptions"] = notes(page, page.assumptions);
    j["stock"] = page.stock ? box(*page.stock) : Json(nullptr);
    j["tolerance"] = number_or_null(page.tolerance);
    j["deviation_limit"] = number_or_null(page.deviation_limit);
    return j;
}

}  // namespace

bool milling_page_available() { return !milling_js.empty(); }

std::string milling_page_data(const MillingPage& page) {
    return for_script(all_of(page).dump(-1, ' ', false, Json::error_handler_t::replace));
}

std::string milling_page(const MillingPage& page) {
    std::string out(milling_html);
    // From the end to the start, so that no mark is looked for in text that was put in.
    put(out, "@SCRIPT@", milling_js);
    put(out, "@ARRAYS@", page_arrays(page));
    put(out, "@DATA@", milling_page_data(page));
    put(out, "@MILLING_STYLE@", milling_css);
    put(out, "@STYLE@", page_css);
    put(out, "@TITLE@", escaped(page.title + ": " + page.verdict_line));
    return out;
}

}  // namespace obrys::report
