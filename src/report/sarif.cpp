#include <filesystem>

#include "base/codes.hpp"
#include "base/text.hpp"
#include "report/baseline.hpp"
#include "report/json_parts.hpp"
#include "report/report.hpp"

namespace obrys::report {

namespace {

constexpr const char* fingerprint_name = "obrysCause/v1";

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

/// Paths count from the root: "../lib/A.SPF" of a call in a folder beside is "lib/A.SPF".
Json artifact(const Subject& s, const std::string& written) {
    const std::filesystem::path name(written);
    const std::string path =
        s.here.empty() || name.is_absolute() ? written : (s.here / name).lexically_normal().generic_string();
    const bool drive = path.size() > 2 && path[1] == ':';
    if (!s.root.empty() && path.starts_with(s.root))
        return {{"uri", uri(path.substr(s.root.size()))}, {"uriBaseId", "%SRCROOT%"}};
    if (drive || path.starts_with('/')) return {{"uri", (drive ? "file:///" : "file://") + uri(path)}};
    return {{"uri", uri(path)}, {"uriBaseId", "%SRCROOT%"}};
}

Json root_of(const Subject& s) {
    Json j = Json::object();
    if (!s.root.empty()) j["uri"] = (s.root.starts_with('/') ? "file://" : "file:///") + uri(s.root);
    j["description"] = {{"text", "The folder from which the paths count."}};
    return j;
}

Json location(const Subject& s, const base::Span& span, const std::string& message = {}) {
    const Place p = place(s.sources, span);
    Json region{{"startLine", p.line}, {"startColumn", p.column}, {"endLine", p.end_line}, {"endColumn", p.end_column}};
    region["snippet"] = {{"text", p.text}};
    Json j{{"physicalLocation", {{"artifactLocation", artifact(s, p.file)}, {"region", std::move(region)}}}};
    if (!message.empty()) j["message"] = {{"text", message}};
    return j;
}

std::string sentence(std::string_view text) {
    std::string out(text);
    if (!out.empty() && out[0] >= 'a' && out[0] <= 'z') out[0] = base::upper(out[0]);
    return out + ".";
}

std::string help_of(const base::Code& c) {
    const char* effect = "";
    switch (c.kind) {
        case base::CodeKind::finding: effect = "A finding: the program, the job or the machine has to change."; break;
        case base::CodeKind::unchecked:
            effect = "Not checked: until this is mended the result may be incomplete and is never clean.";
            break;
        case base::CodeKind::input: effect = "Input that could not be read."; break;
        case base::CodeKind::info: effect = "Listed only; it has no effect on the verdict."; break;
    }
    return sentence(c.meaning) + " " + effect + " docs/diagnostics.md says exactly when it is raised and what to do.";
}

Json rules() {
    Json all = Json::array();
    for (const base::Code& c : base::all_codes) {
        const bool info = c.kind == base::CodeKind::info;
        const char* level = info ? "note" : c.kind == base::CodeKind::unchecked ? "warning" : "error";
        const std::string name(c.name);
        all.push_back({{"id", name},
                       {"shortDescription", {{"text", sentence(c.meaning)}}},
                       {"help", {{"text", help_of(c)}}},
                       {"helpUri", OBRYS_DOCS_URL "#" + name},
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
Json code_flows(const Subject& s, const base::Span& where, const std::vector<base::Span>& stack) {
    Json steps = Json::array();
    for (auto site = stack.rbegin(); site != stack.rend(); ++site)
        steps.push_back({{"location", location(s, *site, "calls")}});
    steps.push_back({{"location", location(s, where, "here")}});
    Json flow{{"threadFlows", Json::array({Json{{"locations", std::move(steps)}}})}};
    return Json::array({std::move(flow)});
}

/// What has no place of its own is about the program as a whole.
Json result(const Subject& s, std::string_view code, const char* level, const std::string& text,
            const base::Span& where, const std::vector<base::Span>& stack) {
    const base::Sources& sources = s.sources;
    Json j{{"ruleId", code}, {"ruleIndex", rule_index(code)}, {"level", level}, {"message", {{"text", text}}}};
    j["locations"] = Json::array();
    if (where.file >= sources.size()) {
        j["locations"].push_back({{"physicalLocation", {{"artifactLocation", artifact(s, base::as_utf8(s.program))}}}});
        return j;
    }
    j["locations"].push_back(location(s, where));
    if (!stack.empty()) j["codeFlows"] = code_flows(s, where, stack);
    return j;
}

/// `passes`: what is said of the others of its cause; may be empty.
Json finding(const check::Finding& f, const Subject& s, std::uint64_t times, const std::string& passes) {
    const base::Sources& sources = s.sources;
    const char* level = f.severity == base::Severity::error     ? "error"
                        : f.severity == base::Severity::warning ? "warning"
                                                                : "note";
    std::string text = f.text;
    if (!passes.empty()) text += "\n" + passes;
    if (!f.remedy.empty()) text += "\n" + f.remedy;
    Json j = result(s, f.code, level, text, f.where, f.stack);
    j["occurrenceCount"] = times;
    int id = 0;
    for (const base::Related& r : f.related) {
        if (r.where.file >= sources.size()) continue;
        Json related = location(s, r.where, r.text);
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
    const std::vector<check::Group> groups = check::groups_of(s.result);
    const std::vector<std::string> prints = fingerprints(s, groups);
    for (std::size_t k = 0; k < groups.size(); ++k) {
        const check::Group& g = groups[k];
        const auto add = [&](Json j) {
            j["partialFingerprints"] = {{fingerprint_name, prints[k]}};
            if (s.result.has_baseline) j["baselineState"] = g.known ? "unchanged" : "new";
            results.push_back(std::move(j));
        };
        if (all)
            for (const std::size_t i : g.members)
                add(finding(s.result.findings[i], s, 1 + s.result.findings[i].more, ""));
        else
            add(finding(s.result.findings[g.worst], s, g.times, passes_line(s, g)));
        if (!all && g.first_move) results.back()["properties"]["first_move"] = *g.first_move;
    }
}

void add_notes(Json& results, const Subject& s, const std::vector<check::Note>& notes, const char* level,
               const std::string& prefix) {
    for (const check::Note& n : notes) {
        std::string text = prefix + n.text;
        if (!n.remedy.empty()) text += "\n" + n.remedy;
        Json j = result(s, n.code, level, text, n.where, n.stack);
        j["occurrenceCount"] = n.times;
        j["partialFingerprints"] = {{fingerprint_name, fingerprint(s, n)}};
        results.push_back(std::move(j));
    }
}

Json run_of(const Subject& s, bool all) {
    Json results = Json::array();
    add_findings(results, s, all);
    add_notes(results, s, s.result.unchecked, "warning", "not checked: ");
    add_notes(results, s, s.result.assumptions, "note", "assumed: ");
    Json driver{{"name", "obrys"}, {"rules", rules()}};
    if (!s.version.empty()) driver["version"] = s.version;
    return {{"tool", {{"driver", std::move(driver)}}},
            {"invocations", Json::array({Json{{"executionSuccessful", true}}})},
            {"originalUriBaseIds", {{"%SRCROOT%", root_of(s)}}},
            {"columnKind", "unicodeCodePoints"},
            {"results", std::move(results)},
            {"properties",
             {{"verdict", check::name(s.result.verdict)},
              {"scope", shop::name(s.result.scope)},
              {"program", base::as_utf8(s.program)}}}};
}

Json log_of(Json runs) {
    return {
        {"$schema", "https://json.schemastore.org/sarif-2.1.0.json"}, {"version", "2.1.0"}, {"runs", std::move(runs)}};
}

std::string text_of(const Json& j) { return j.dump(2, ' ', false, Json::error_handler_t::replace) + "\n"; }

}  // namespace

std::string to_sarif(const Subject& s, bool all) { return text_of(log_of(Json::array({run_of(s, all)}))); }

std::string joined_sarif(const std::vector<std::string>& logs) {
    Json runs = Json::array();
    for (const std::string& log : logs) {
        Json parsed = Json::parse(log);
        for (Json& run : parsed["runs"]) runs.push_back(std::move(run));
    }
    return text_of(log_of(std::move(runs)));
}

std::string unreadable_sarif(const Unreadable& input) {
    Json notes = Json::array();
    for (const base::Diagnostic& d : input.diagnostics)
        notes.push_back({{"level", "error"}, {"message", {{"text", d.text}}}, {"descriptor", {{"id", d.code}}}});
    Json run{{"tool", {{"driver", {{"name", "obrys"}, {"rules", rules()}}}}}};
    run["invocations"] =
        Json::array({Json{{"executionSuccessful", false}, {"toolExecutionNotifications", std::move(notes)}}});
    run["results"] = Json::array();
    run["properties"] = {{"program", base::as_utf8(input.input)}};
    return text_of(log_of(Json::array({std::move(run)})));
}

}  // namespace obrys::report
