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

}  // namespace

std::string_view name_of(LedgerFate fate) {
    return fate == LedgerFate::mapped ? "mapped" : fate == LedgerFate::expanded ? "expanded" : "lost";
}

std::uint64_t count_of(const Ledger& ledger, LedgerFate fate) {
    return static_cast<std::uint64_t>(std::count_if(ledger.entries.begin(), ledger.entries.end(),
                                                    [&](const LedgerEntry& e) { return e.fate == fate; }));
}

std::string summary(const Ledger& ledger) {
    std::string out;
    for (const LedgerFate fate : {LedgerFate::mapped, LedgerFate::expanded, LedgerFate::lost})
        out += (out.empty() ? "" : ", ") + std::to_string(count_of(ledger, fate)) + " " + std::string(name_of(fate));
    return out;
}

std::string ledger_text(const Ledger& ledger) {
    std::string out = ledger.program + " (" + ledger.control + ") -> " + ledger.output + " (" + ledger.post +
                      "): " + ledger.proof + (ledger.written ? "" : ", not written") + "\n" + summary(ledger) + "\n\n";
    std::size_t widest = 0;
    for (const LedgerEntry& e : ledger.entries) widest = std::max(widest, as_text(e.from).size());
    for (const LedgerEntry& e : ledger.entries) {
        std::string fate(name_of(e.fate)), from = as_text(e.from);
        fate.resize(std::max<std::size_t>(fate.size(), name_of(LedgerFate::expanded).size()), ' ');
        from.resize(widest, ' ');
        out += fate + "  " + from + "  " + as_text(e.to) + "  " + e.what;
        if (e.times > 1) out += " (" + std::to_string(e.times) + " times)";
        out += "\n";
    }
    return out;
}

std::string ledger_json(const Ledger& ledger) {
    Json out{
        {"format", "obrys-ledger"}, {"version", 1},        {"program", ledger.program}, {"control", ledger.control},
        {"output", ledger.output},  {"post", ledger.post}, {"proof", ledger.proof},     {"written", ledger.written}};
    for (const LedgerFate fate : {LedgerFate::mapped, LedgerFate::expanded, LedgerFate::lost})
        out["counts"][std::string(name_of(fate))] = count_of(ledger, fate);
    out["entries"] = Json::array();
    for (const LedgerEntry& e : ledger.entries)
        out["entries"].push_back({{"what", e.what},
                                  {"fate", name_of(e.fate)},
                                  {"from", as_json(e.from)},
                                  {"to", as_json(e.to)},
                                  {"times", e.times}});
    return out.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace obrys::report
