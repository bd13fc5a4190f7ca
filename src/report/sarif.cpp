#include <nlohmann/json.hpp>

#include "base/codes.hpp"
#include "base/text.hpp"
#include "report/report.hpp"

namespace obrys::report {

namespace {

using Json = nlohmann::ordered_json;

/// A path as a relative URI reference: blanks and what is not ASCII percent-encoded.
std::string uri(const std::string& path) {
    constexpr std::string_view hex = "0123456789ABCDEF", plain = "/-._~!$&'()*+,;=@";
    std::string out;
    for (const char c : path) {
        const auto byte = static_cast<unsigned char>(c);
        if (c == '\\') {
            out += '/';
        } else if (base::is_letter(c) || base::is_digit(c) || plain.find(c) != std::string_view::npos) {
            out += c;
        } else {
            out += '%';
            out += hex[byte >> 4];
            out += hex[byte & 15];
        }
    }
    return out;
}

Json location(const base::Sources& sources, const base::Span& span, const std::string& message = {}) {
    const Place p = place(sources, span);
    Json region{{"startLine", p.line}, {"startColumn", p.column}, {"endLine", p.end_line}, {"endColumn", p.end_column}};
    region["snippet"] = {{"text", p.text}};
    Json j{{"physicalLocation", {{"artifactLocation", {{"uri", uri(p.file)}}}, {"region", std::move(region)}}}};
    if (!message.empty()) j["message"] = {{"text", message}};
    return j;
}

Json rules() {
    Json all = Json::array();
    for (const base::Code& c : base::all_codes) {
        const bool info = c.kind == base::CodeKind::info;
        const char* level = info ? "note" : c.kind == base::CodeKind::unchecked ? "warning" : "error";
        all.push_back({{"id", c.name},
                       {"shortDescription", {{"text", c.meaning}}},
                       {"defaultConfiguration", {{"level", level}}}});
    }
    return all;
}

Json rule_index(std::string_view code) {
    for (std::size_t i = 0; i < base::all_codes.size(); ++i)
        if (base::all_codes[i].name == code) return i;
    return -1;
}

/// The calls that led there, the main program first.
Json code_flows(const base::Sources& sources, const base::Span& where, const std::vector<base::Span>& stack) {
    Json steps = Json::array();
    for (auto site = stack.rbegin(); site != stack.rend(); ++site)
        steps.push_back({{"location", location(sources, *site, "calls")}});
    steps.push_back({{"location", location(sources, where, "here")}});
    Json flow{{"threadFlows", Json::array({Json{{"locations", std::move(steps)}}})}};
    return Json::array({std::move(flow)});
}

Json result(const base::Sources& sources, std::string_view code, const char* level, const std::string& text,
            const base::Span& where, const std::vector<base::Span>& stack) {
    Json j{{"ruleId", code}, {"ruleIndex", rule_index(code)}, {"level", level}, {"message", {{"text", text}}}};
    j["locations"] = Json::array();
    if (where.file >= sources.size()) return j;
    j["locations"].push_back(location(sources, where));
    if (!stack.empty()) j["codeFlows"] = code_flows(sources, where, stack);
    return j;
}

/// `passes`: what is said of the others of its cause; may be empty.
Json finding(const check::Finding& f, const base::Sources& sources, std::uint64_t times, const std::string& passes) {
    const char* level = f.severity == base::Severity::error     ? "error"
                        : f.severity == base::Severity::warning ? "warning"
                                                                : "note";
    std::string text = f.text;
    if (!passes.empty()) text += "\n" + passes;
    if (!f.remedy.empty()) text += "\n" + f.remedy;
    Json j = result(sources, f.code, level, text, f.where, f.stack);
    j["occurrenceCount"] = times;
    int id = 0;
    for (const base::Related& r : f.related) {
        if (r.where.file >= sources.size()) continue;
        Json related = location(sources, r.where, r.text);
        related["id"] = id++;
        j["relatedLocations"].push_back(std::move(related));
    }
    Json properties = Json::object();
    if (f.move) properties["move"] = *f.move;
    for (const check::Amount& a : f.amounts)
        if (std::isfinite(a.value)) properties[std::string(a.key)] = a.value;
    if (!properties.empty()) j["properties"] = std::move(properties);
    return j;
}

void add_findings(Json& results, const Subject& s, bool all) {
    for (const check::Group& g : check::groups_of(s.result)) {
        if (all) {
            for (const std::size_t i : g.members)
                results.push_back(finding(s.result.findings[i], s.sources, 1 + s.result.findings[i].more, ""));
            continue;
        }
        results.push_back(finding(s.result.findings[g.worst], s.sources, g.times, passes_line(s, g)));
        if (g.first_move) results.back()["properties"]["first_move"] = *g.first_move;
    }
}

}  // namespace

std::string to_sarif(const Subject& s, bool all) {
    const check::Result& r = s.result;
    Json results = Json::array();
    add_findings(results, s, all);
    for (const check::Note& n : r.unchecked)
        results.push_back(result(s.sources, n.code, "warning", "not checked: " + n.text, n.where, n.stack));
    for (const check::Note& n : r.assumptions)
        results.push_back(result(s.sources, n.code, "note", "assumed: " + n.text, n.where, n.stack));
    Json driver{{"name", "obrys"}, {"rules", rules()}};
    if (!s.version.empty()) driver["version"] = s.version;
    Json run{{"tool", {{"driver", std::move(driver)}}},
             {"invocations", Json::array({Json{{"executionSuccessful", true}}})},
             {"columnKind", "unicodeCodePoints"},
             {"results", std::move(results)},
             {"properties", {{"verdict", check::name(r.verdict)}}}};
    const Json j{{"$schema", "https://json.schemastore.org/sarif-2.1.0.json"},
                 {"version", "2.1.0"},
                 {"runs", Json::array({std::move(run)})}};
    return j.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace obrys::report
