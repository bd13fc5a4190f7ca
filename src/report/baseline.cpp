#include "report/baseline.hpp"

#include <cstdint>
#include <nlohmann/json.hpp>

#include "base/text.hpp"

namespace obrys::report {

namespace {

using Json = nlohmann::ordered_json;

constexpr int baseline_version = 1;

/// FNV-1a: the same on every machine.
class Hash {
public:
    void add(std::string_view text) {
        for (const char c : text) byte(static_cast<unsigned char>(c));
        byte(0);
    }
    [[nodiscard]] std::string digits() const {
        constexpr std::string_view hex = "0123456789abcdef";
        std::string out;
        for (int shift = 60; shift >= 0; shift -= 4) out += hex[(value_ >> shift) & 15U];
        return out;
    }

private:
    void byte(unsigned char b) {
        value_ ^= b;
        value_ *= 0x100000001b3U;
    }
    std::uint64_t value_ = 0xcbf29ce484222325U;
};

std::string_view file_name(std::string_view path) { return path.substr(path.find_last_of("/\\") + 1); }

/// A line as it reads without its block number and with single blanks.
std::string plain(const Place& p) {
    std::string_view text = p.text;
    if (p.block) {
        if (text.starts_with('N') || text.starts_with('n')) text.remove_prefix(1);
        while (!text.empty() && base::is_digit(text.front())) text.remove_prefix(1);
    }
    std::string out;
    for (const char c : base::trim(text)) {
        const bool blank = c == ' ' || c == '\t';
        if (!blank || !out.ends_with(' ')) out += blank ? ' ' : c;
    }
    return out;
}

void add(Hash& hash, const Subject& s, const base::Span& where, const std::vector<base::Span>& stack) {
    const auto site = [&](const base::Span& span) {
        const Place p = place(s.sources, span);
        hash.add(file_name(p.file));
        hash.add(plain(p));
    };
    site(where);
    for (const base::Span& span : stack) site(span);
}

std::optional<double> amount_of(const check::Finding& f) {
    const check::Amount* a = check::chief_amount(f);
    return a == nullptr ? std::nullopt : std::optional(a->value);
}

}  // namespace

std::vector<std::string> fingerprints(const Subject& s, const std::vector<check::Group>& groups) {
    std::vector<std::string> out;
    std::map<std::string, int> seen;
    for (const check::Group& g : groups) {
        const check::Finding& f = s.result.findings[g.worst];
        Hash hash;
        hash.add(f.code);
        hash.add(file_name(s.program));
        if (f.cause.empty())
            add(hash, s, f.where, f.stack);
        else
            hash.add(f.cause);
        if (const int again = seen[hash.digits()]++; again > 0) hash.add(std::to_string(again));
        out.push_back(hash.digits());
    }
    return out;
}

std::string fingerprint(const Subject& s, const check::Note& note) {
    Hash hash;
    hash.add(note.code);
    hash.add(file_name(s.program));
    hash.add(note.text);
    add(hash, s, note.where, note.stack);
    return hash.digits();
}

std::vector<std::string> baseline_entries(const Subject& s) {
    const std::vector<check::Group> groups = check::groups_of(s.result);
    const std::vector<std::string> prints = fingerprints(s, groups);
    std::vector<std::string> out;
    for (std::size_t i = 0; i < groups.size(); ++i) {
        const check::Finding& f = s.result.findings[groups[i].worst];
        const Place p = place(s.sources, f.where);
        Json j{{"fingerprint", prints[i]}, {"code", f.code}, {"program", s.program}, {"file", p.file}};
        j["line"] = p.line;
        j["message"] = f.text;
        const auto amount = amount_of(f);
        j["amount"] = amount ? Json(*amount) : Json(nullptr);
        out.push_back(j.dump(-1, ' ', false, Json::error_handler_t::replace));
    }
    return out;
}

std::string to_baseline(const std::vector<std::string>& entries) {
    std::string out =
        "{\"format\": \"obrys-baseline\", \"version\": " + std::to_string(baseline_version) + ", \"findings\": [";
    const char* before = "\n";
    for (const std::string& e : entries) {
        out += before + e;
        before = ",\n";
    }
    return out + "\n]}\n";
}

std::optional<Baseline> read_baseline(std::string_view text) {
    const Json j = Json::parse(text, nullptr, false);
    if (!j.is_object() || j.value("format", "") != "obrys-baseline" || j.value("version", 0) != baseline_version)
        return std::nullopt;
    const auto findings = j.find("findings");
    if (findings == j.end() || !findings->is_array()) return std::nullopt;
    Baseline known;
    for (const Json& f : *findings) {
        if (!f.is_object() || !f.contains("fingerprint") || !f["fingerprint"].is_string()) return std::nullopt;
        const auto amount = f.find("amount");
        known[f["fingerprint"].get<std::string>()] =
            amount != f.end() && amount->is_number() ? std::optional(amount->get<double>()) : std::nullopt;
    }
    return known;
}

void mark_known(const Subject& s, const Baseline& baseline, check::Result& result) {
    const std::vector<check::Group> groups = check::groups_of(s.result);
    const std::vector<std::string> prints = fingerprints(s, groups);
    result.has_baseline = true;
    for (std::size_t i = 0; i < groups.size(); ++i) {
        const auto at = baseline.find(prints[i]);
        if (at == baseline.end()) continue;
        const check::Finding& f = s.result.findings[groups[i].worst];
        const auto amount = amount_of(f);
        if (amount && at->second && *amount > *at->second + known_slack) continue;  // it has become worse
        result.known.insert(check::cause_key(f));
    }
}

}  // namespace obrys::report
