#include "check/group.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <string_view>

namespace obrys::check {

namespace {

void append_place(std::string& key, const base::Span& span) {
    key += '\n';
    key += std::to_string(span.file);
    key += ':';
    key += std::to_string(span.begin);
}

const Amount* amount(const Finding& f, std::string_view key) {
    const auto at = std::find_if(f.amounts.begin(), f.amounts.end(), [&](const Amount& a) { return a.key == key; });
    return at == f.amounts.end() ? nullptr : &*at;
}

double value(const Amount* a) { return a == nullptr || std::isnan(a->value) ? 0 : a->value; }

}  // namespace

std::string cause_key(const Finding& f) {
    std::string key(f.code);
    if (!f.cause.empty()) return key + '\n' + f.cause;
    append_place(key, f.where);
    for (const base::Span& site : f.stack) append_place(key, site);
    return key;
}

const Amount* chief_amount(const Finding& f) {
    constexpr std::array<std::string_view, 7> by_weight{"depth_mm", "height_mm", "excess_mm",      "excess_deg",
                                                        "area_mm2", "speed_rpm", "feed_mm_per_min"};
    for (const std::string_view key : by_weight)
        if (const Amount* found = amount(f, key)) return found;
    return nullptr;
}

bool is_worse(const Finding& a, const Finding& b) {
    const double x = value(chief_amount(a)), y = value(chief_amount(b));
    // Passes along one flank are equally deep normal to it.
    constexpr double same = 1e-6;
    if (std::abs(x - y) > same) return x > y;
    return value(amount(a, "depth_x_mm")) > value(amount(b, "depth_x_mm")) + same;
}

bool finds_new(const Result& result) {
    if (result.findings_dropped > 0) return true;
    return std::any_of(result.findings.begin(), result.findings.end(),
                       [&](const Finding& f) { return !result.known.contains(cause_key(f)); });
}

std::vector<Site> sites_of(const Result& result, const Group& group) {
    const Finding& f = result.findings[group.worst];
    const Amount* chief = chief_amount(f);
    if (f.cause.empty()) return {{f.where, f.stack, chief == nullptr ? std::nullopt : std::optional(chief->value)}};
    const auto known = result.sites.find(cause_key(f));
    if (known == result.sites.end() || known->second.more) return {};
    std::vector<Site> out;
    for (const auto& [place, site] : known->second.all) out.push_back(site);
    return out;
}

std::vector<base::Related> related_of(const Result& result, const Group& group) {
    if (group.first_move) return result.findings[group.worst].related;
    constexpr std::size_t most = 8;
    std::vector<base::Related> out;
    for (const std::size_t i : group.members)
        for (const base::Related& r : result.findings[i].related) {
            const bool known = std::any_of(
                out.begin(), out.end(), [&](const base::Related& o) { return o.where == r.where && o.text == r.text; });
            if (!known && out.size() < most) out.push_back(r);
        }
    return out;
}

std::vector<Group> groups_of(const Result& result) {
    std::vector<Group> groups;
    std::map<std::string, std::size_t> known;
    for (std::size_t i = 0; i < result.findings.size(); ++i) {
        const Finding& f = result.findings[i];
        const auto [at, added] = known.try_emplace(cause_key(f), groups.size());
        if (added) groups.push_back({{}, i, 0, result.known.contains(at->first), {}});
        Group& g = groups[at->second];
        g.members.push_back(i);
        g.times += 1 + f.more;
        if (f.move && (!g.first_move || *f.move < *g.first_move)) g.first_move = f.move;
        if (is_worse(f, result.findings[g.worst])) g.worst = i;
    }
    return groups;
}

}  // namespace obrys::check
