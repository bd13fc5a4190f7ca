#include "report/baseline.hpp"

#include <algorithm>
#include <cstdint>
#include <filesystem>

#include "base/function_ref.hpp"
#include "base/text.hpp"
#include "report/json_parts.hpp"

namespace obrys::report {

namespace {

constexpr int baseline_version = 2;

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

/// How a file is called: a log's results by its name, so that they outlive another folder; in a baseline, where two
/// programs of one name may be, as it is found from the baseline.
using Names = base::FunctionRef<std::string(const std::string&)>;

constexpr auto own_name = [](const std::string& path) { return std::string(file_name(path)); };

void add(Hash& hash, const Subject& s, Names name, const base::Span& where, const std::vector<base::Span>& stack) {
    const auto site = [&](const base::Span& span) {
        const Place p = place(s.sources, span);
        hash.add(name(p.file));
        hash.add(plain(p));
    };
    site(where);
    for (const base::Span& span : stack) site(span);
}

/// Where equal ones come up in one run, they are numbered.
class Prints {
public:
    std::string next(const Hash& made) {
        Hash hash = made;
        if (const int again = seen_[hash.digits()]++; again > 0) hash.add(std::to_string(again));
        return hash.digits();
    }

private:
    std::map<std::string, int> seen_;
};

/// What a baseline has of a group: each line that its cause comes up in.
struct Entry {
    std::string print;
    check::Site site;
};

/// Of every group; none of one that nothing can be said of.
std::vector<std::vector<Entry>> entries_of(const Subject& s, const std::vector<check::Group>& groups,
                                           const std::string& folder) {
    namespace fs = std::filesystem;
    const auto from_folder = [&](const std::string& written) {
        const fs::path whole = s.here.empty() ? fs::path(written) : fs::path(s.here) / written;
        const fs::path name = folder.empty() ? whole : whole.lexically_normal().lexically_relative(folder);
        return (name.empty() ? whole : name).generic_string();
    };
    Prints prints;
    std::vector<std::vector<Entry>> out;
    for (const check::Group& g : groups) {
        const check::Finding& f = s.result.findings[g.worst];
        std::vector<Entry>& of_group = out.emplace_back();
        for (const check::Site& site : check::sites_of(s.result, g)) {
            Hash hash;
            hash.add(f.code);
            hash.add(from_folder(s.input));
            hash.add(from_folder(s.program));
            hash.add(f.cause);
            add(hash, s, from_folder, site.where, site.stack);
            of_group.push_back({prints.next(hash), site});
        }
    }
    return out;
}

}  // namespace

std::vector<std::string> fingerprints(const Subject& s, const std::vector<check::Group>& groups) {
    std::vector<std::string> out;
    Prints prints;
    for (const check::Group& g : groups) {
        const check::Finding& f = s.result.findings[g.worst];
        Hash hash;
        hash.add(f.code);
        hash.add(file_name(s.program));
        if (f.cause.empty())
            add(hash, s, own_name, f.where, f.stack);
        else
            hash.add(f.cause);
        out.push_back(prints.next(hash));
    }
    return out;
}

std::string fingerprint(const Subject& s, const check::Note& note) {
    Hash hash;
    hash.add(note.code);
    hash.add(file_name(s.program));
    hash.add(note.text);
    add(hash, s, own_name, note.where, note.stack);
    return hash.digits();
}

std::vector<std::string> baseline_entries(const Subject& s, const std::string& folder) {
    const std::vector<check::Group> groups = check::groups_of(s.result);
    const auto entries = entries_of(s, groups, folder);
    std::vector<std::string> out;
    for (std::size_t i = 0; i < groups.size(); ++i) {
        const check::Finding& f = s.result.findings[groups[i].worst];
        for (const Entry& e : entries[i]) {
            const Place p = place(s.sources, e.site.where);
            Json j{{"fingerprint", e.print}, {"code", f.code}, {"program", s.program}, {"file", p.file}};
            j["line"] = p.line;
            j["message"] = f.text;
            j["amount"] = e.site.worst ? Json(*e.site.worst) : Json(nullptr);
            out.push_back(j.dump(-1, ' ', false, Json::error_handler_t::replace));
        }
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
    const auto is = [&](const char* key, const Json& value) { return j.value(key, Json()) == value; };
    if (!j.is_object() || !is("format", "obrys-baseline") || !is("version", baseline_version)) return std::nullopt;
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

void mark_known(const Subject& s, const Baseline& baseline, const std::string& folder, check::Result& result) {
    const std::vector<check::Group> groups = check::groups_of(s.result);
    const auto entries = entries_of(s, groups, folder);
    const auto is_known = [&](const Entry& e) {
        const auto at = baseline.find(e.print);
        if (at == baseline.end()) return false;
        return !e.site.worst || !at->second || *e.site.worst <= *at->second + known_slack;
    };
    result.has_baseline = true;
    for (std::size_t i = 0; i < groups.size(); ++i)
        if (!entries[i].empty() && std::all_of(entries[i].begin(), entries[i].end(), is_known))
            result.known.insert(check::cause_key(s.result.findings[groups[i].worst]));
}

}  // namespace obrys::report
