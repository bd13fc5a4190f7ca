#include "report/ledger/ledger.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace obrys::report {

namespace {

using Json = nlohmann::ordered_json;

Json as_json(const std::optional<LedgerPlace>& place) {
    if (!place) return nullptr;
    return {{"file", place->file}, {"line", place->line}};
}

std::string as_text(const std::optional<LedgerPlace>& place) {
    return place ? place->file + ":" + std::to_string(place->line) : "-";
}

Json proof_json(const std::string& proof) {
    return proof == "equal" ? Json(true) : proof == "differs" ? Json(false) : Json(nullptr);
}

Json names_json(const std::vector<LedgerName>& names) {
    Json out = Json::array();
    for (const LedgerName& n : names) {
        Json one{{"from", n.from}, {"to", n.to}};
        if (!n.program.empty()) one["program"] = n.program;
        out.push_back(std::move(one));
    }
    return out;
}

void add_structure(Json& out, const LedgerOfStructure& s) {
    out["names"] = names_json(s.names);
    out["programs"] = names_json(s.programs);
    out["lines"] = Json::array();
    for (const LedgerLine& l : s.lines)
        out["lines"].push_back({{"file", l.from.file}, {"line", l.from.line}, {"to", l.to}});
    out["runs"] = Json::array();
    for (const LedgerRun& run : s.runs) out["runs"].push_back({{"set", run.set}, {"equal", proof_json(run.proof)}});
}

std::string structure_text(const LedgerOfStructure& s) {
    std::string out;
    const auto named = [&](const LedgerName& n) {
        out += n.from + (n.program.empty() ? "" : " of " + n.program) + " is " + n.to + "\n";
    };
    std::for_each(s.programs.begin(), s.programs.end(), named);
    std::for_each(s.names.begin(), s.names.end(), named);
    for (const LedgerRun& run : s.runs) {
        std::string set;
        for (const std::string& one : run.set) set += (set.empty() ? "" : " ") + one;
        out += run.proof + ": " + (set.empty() ? "with the program's own values" : set) + "\n";
    }
    return out.empty() ? "" : out + "\n";
}

}  // namespace

std::uint64_t count_of(const Ledger& ledger, base::Fate fate) {
    return static_cast<std::uint64_t>(std::count_if(ledger.entries.begin(), ledger.entries.end(),
                                                    [&](const LedgerEntry& e) { return e.fate == fate; }));
}

std::string summary(const Ledger& ledger) {
    std::string out;
    for (const base::Fate fate : {base::Fate::mapped, base::Fate::expanded, base::Fate::lost})
        out +=
            (out.empty() ? "" : ", ") + std::to_string(count_of(ledger, fate)) + " " + std::string(base::name_of(fate));
    return out;
}

std::string ledger_text(const Ledger& ledger) {
    std::string out = ledger.program + " (" + ledger.control + ") -> " + ledger.output + " (" + ledger.post +
                      "): " + ledger.proof + (ledger.written ? "" : ", not written") + "\n" + summary(ledger) + "\n\n";
    if (ledger.structure) out += structure_text(*ledger.structure);
    std::size_t widest = 0;
    for (const LedgerEntry& e : ledger.entries) widest = std::max(widest, as_text(e.from).size());
    for (const LedgerEntry& e : ledger.entries) {
        std::string fate(base::name_of(e.fate)), from = as_text(e.from);
        fate.resize(std::max<std::size_t>(fate.size(), base::name_of(base::Fate::expanded).size()), ' ');
        from.resize(widest, ' ');
        out += fate + "  " + from + "  " + as_text(e.to) + "  " + e.what;
        if (e.times > 1) out += " (" + std::to_string(e.times) + " times)";
        out += "\n";
    }
    return out;
}

std::string ledger_json(const Ledger& ledger) {
    Json out{{"format", "obrys-ledger"},          {"version", 1},
             {"program", ledger.program},         {"control", ledger.control},
             {"output", ledger.output},           {"post", ledger.post},
             {"to_control", ledger.post_control}, {"proof", ledger.proof},
             {"equal", proof_json(ledger.proof)}, {"written", ledger.written}};
    for (const base::Fate fate : {base::Fate::mapped, base::Fate::expanded, base::Fate::lost})
        out["counts"][std::string(base::name_of(fate))] = count_of(ledger, fate);
    out["entries"] = Json::array();
    for (const LedgerEntry& e : ledger.entries)
        out["entries"].push_back({{"what", e.what},
                                  {"fate", base::name_of(e.fate)},
                                  {"from", as_json(e.from)},
                                  {"to", as_json(e.to)},
                                  {"times", e.times}});
    if (ledger.structure) add_structure(out, *ledger.structure);
    return out.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace obrys::report
