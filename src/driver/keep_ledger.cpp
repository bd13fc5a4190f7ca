/// The ledger of a translation by structure: written as one of any translation, its names read again.

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/text.hpp"
#include "driver/keep.hpp"

namespace obrys::driver {

namespace {

using Json = nlohmann::ordered_json;

std::optional<report::LedgerPlace> place_of(const Session& s, const base::Span& at) {
    if (at.file >= s.sources.size()) return std::nullopt;
    return report::LedgerPlace{s.sources[at.file].name, s.sources.position(at).line};
}

std::vector<report::LedgerName> shown_names(const std::vector<rewrite::Renamed>& names) {
    std::vector<report::LedgerName> out;
    for (const rewrite::Renamed& n : names) out.push_back({n.from, n.to, n.program});
    return out;
}

}  // namespace

report::Ledger ledger(const Session& s, const Kept& kept, const std::string& output, const std::vector<KeptRun>& runs) {
    const rewrite::Rewritten& r = kept.rewritten;
    report::Ledger out;
    out.program = s.program;
    out.control = s.control;
    out.output = output;
    for (const rewrite::Note& n : r.notes) {
        report::LedgerEntry entry{n.what, n.fate, place_of(s, n.from), std::nullopt, 1};
        if (n.line != 0) entry.to = {output, n.line};
        out.entries.push_back(std::move(entry));
    }
    report::LedgerOfStructure& structure = out.structure.emplace();
    structure.names = shown_names(r.names);
    structure.programs = shown_names(r.programs);
    std::vector<std::uint32_t> files;
    for (const auto& [line, from] : r.lines) {
        const auto place = place_of(s, from);
        if (!place) continue;
        structure.lines.push_back({*place, line});
        if (std::find(files.begin(), files.end(), from.file) == files.end()) files.push_back(from.file);
    }
    for (const KeptRun& run : runs) structure.runs.push_back({run.set, std::string(name_of(run.proof))});
    for (const std::uint32_t file : files) {
        s.sources.fetch(file);
        out.sources.push_back({s.sources[file].name, base::as_utf8(s.sources[file].text)});
    }
    out.outputs.push_back({output, base::as_utf8(r.text)});
    return out;
}

std::optional<NameMap> names_of_ledger(const std::string& text) {
    const Json json = Json::parse(text, nullptr, false);
    if (!json.is_object() || !json.contains("names") || !json["names"].is_array()) return std::nullopt;
    NameMap out;
    for (const Json& n : json["names"]) {
        if (!n.is_object() || !n.contains("from") || !n.contains("to") || !n["from"].is_string() ||
            !n["to"].is_string())
            return std::nullopt;
        if (!n.contains("program")) out.emplace_back(n["from"].get<std::string>(), n["to"].get<std::string>());
    }
    return out;
}

}  // namespace obrys::driver
