#include "report/subject.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <set>

#include "base/codes.hpp"
#include "base/number.hpp"
#include "base/text.hpp"

namespace obrys::report {

Place place(const base::Sources& sources, const base::Span& span) {
    Place p;
    if (span.file >= sources.size()) return p;
    p.file = base::as_utf8(sources[span.file].name);
    const base::Position begin = sources.position(span);
    // A span that ends with its line's end still ends on that line.
    std::string_view text = sources.text(span);
    while (text.ends_with('\n') || text.ends_with('\r')) text.remove_suffix(1);
    const base::Position end = sources.position(span.file, span.begin + static_cast<std::uint32_t>(text.size()));
    p.line = begin.line;
    p.column = begin.column;
    p.end_line = end.line;
    p.end_column = end.column;
    p.block = sources.block_number(span.file, span.begin);
    p.text = std::string(base::trim(sources.line_utf8(span)));
    return p;
}

std::string count_of(std::uint64_t n, const std::string& one) {
    return std::to_string(n) + " " + one + (n == 1 ? "" : "s");
}

namespace {

std::string scope_words(shop::Scope scope) {
    switch (scope) {
        case shop::Scope::all: return "";
        case shop::Scope::part: return " within the scope \"part\" (collisions and limits not judged)";
        case shop::Scope::collisions: return " within the scope \"collisions\" (the part's shape not judged)";
        case shop::Scope::motion:
            return " within the scope \"motion\" (no material: neither collisions nor part judged)";
    }
    return "";
}

/// Of a clean result: what is finer than that was not looked for.
std::string simulated_words(const check::Result& r) {
    return r.milled ? ", simulated to " + base::shortest(r.milled->figures.tolerance_mm) + " mm" : "";
}

}  // namespace

std::string verdict_line(const check::Result& r) {
    const std::vector<check::Group> groups = check::groups_of(r);
    std::string found = count_of(groups.size() + r.findings_dropped, "finding");
    const auto known = std::count_if(groups.begin(), groups.end(), [](const check::Group& g) { return g.known; });
    if (r.has_baseline && !groups.empty())
        found += known == 0                                     ? ", all new"
                 : known == std::ssize(groups) && !finds_new(r) ? ", all known"
                                                                : ", " + std::to_string(known) + " of them known";
    const std::string scope = scope_words(r.scope);
    switch (r.verdict) {
        case check::Verdict::clean:
            return "clean" + scope + simulated_words(r) + ": nothing found in " + count_of(r.stats.moves, "move");
        case check::Verdict::findings: return found + scope;
        case check::Verdict::not_fully_checked: break;
    }
    const std::size_t n = r.unchecked.size();
    return "not fully checked" + scope + ": " + count_of(n, "thing") + (n == 1 ? " was" : " were") + " not checked; " +
           found;
}

AmountWords amount_words(std::string_view key) {
    struct Entry {
        std::string_view key, label, unit;
    };
    constexpr std::array entries{
        Entry{"depth_mm", "depth normal to the contour", "mm"},
        Entry{"depth_x_mm", "depth along X", "mm"},
        Entry{"area_mm2", "area", "mm2"},
        Entry{"volume_mm3", "volume", "mm3"},
        Entry{"contact_length_mm", "contact length", "mm"},
        Entry{"z_mm", "at Z", "mm"},
        Entry{"x_mm", "at X (radius)", "mm"},
        Entry{"y_mm", "at Y", "mm"},
        Entry{"width_mm", "width", "mm"},
        Entry{"height_mm", "height", "mm"},
        Entry{"z_from_mm", "from Z", "mm"},
        Entry{"z_to_mm", "to Z", "mm"},
        Entry{"excess_mm", "outside its travel by", "mm"},
        Entry{"way_mm", "way a revolution", "mm"},
        Entry{"pitch_mm", "pitch", "mm"},
        Entry{"excess_deg", "outside its travel by", "degrees"},
        Entry{"speed_rpm", "speed", "1/min"},
        Entry{"limit_rpm", "limit", "1/min"},
        Entry{"feed_mm_per_min", "feed", "mm/min"},
        Entry{"limit_mm_per_min", "limit", "mm/min"},
    };
    for (const Entry& e : entries)
        if (e.key == key) return {std::string(e.label), std::string(e.unit)};
    return {std::string(key), ""};
}

namespace {

constexpr std::size_t most_ranges = 8;  ///< of lines that are named

/// "12-890, 901 and 40 more"
std::string ranges(const std::vector<std::uint32_t>& lines) {
    std::string out;
    std::size_t made = 0;
    for (std::size_t i = 0; i < lines.size();) {
        std::size_t last = i;
        while (last + 1 < lines.size() && lines[last + 1] == lines[last] + 1) ++last;
        if (made++ == most_ranges) return out + " and " + std::to_string(lines.size() - i) + " more";
        out += (out.empty() ? "" : ", ") + std::to_string(lines[i]);
        if (last > i) out += "-" + std::to_string(lines[last]);
        i = last + 1;
    }
    return out;
}

/// What breaks the machine or the tool first, then what spoils the part, then what only has to be done again.
std::size_t rank_of(std::string_view code) {
    namespace codes = base::codes;
    constexpr std::array order{codes::clamp_collision, codes::rapid_in_stock, codes::holder_in_stock,
                               codes::gouge,           codes::axis_limit,     codes::spindle_stopped,
                               codes::tool_missing,    codes::spindle_limit,  codes::surface_speed,
                               codes::feed_missing,    codes::feed_limit,     codes::allowance_cut};
    if (code == codes::rest_material) return order.size() + 1;  // after everything else
    return static_cast<std::size_t>(std::find(order.begin(), order.end(), code) - order.begin());
}

double depth_of(const check::Finding& f) {
    double d = 0;
    for (const check::Amount& a : f.amounts)
        if (a.key == "depth_x_mm" || a.key == "depth_mm" || a.key == "excess_mm") d = std::max(d, a.value);
    return d;
}

}  // namespace

std::vector<std::pair<std::string, std::vector<std::uint32_t>>> lines_of(const Subject& s, const check::Group& group) {
    std::map<std::uint32_t, std::set<std::uint32_t>> found;
    for (const std::size_t i : group.members) {
        const base::Span& where = s.result.findings[i].where;
        if (where.file < s.sources.size()) found[where.file].insert(s.sources.position(where).line);
    }
    std::vector<std::pair<std::string, std::vector<std::uint32_t>>> out;
    for (const auto& [file, lines] : found)
        out.emplace_back(base::as_utf8(s.sources[file].name), std::vector<std::uint32_t>(lines.begin(), lines.end()));
    return out;
}

std::string passes_line(const Subject& s, const check::Group& group) {
    if (group.times < 2) return {};
    const check::Finding& worst = s.result.findings[group.worst];
    std::string out = std::to_string(group.times) + (group.first_move ? " passes" : " times");
    if (const check::Amount* amount = check::chief_amount(worst)) {
        const AmountWords words = amount_words(amount->key);
        out += ", worst " + base::fixed(amount->value, 3) + (words.unit.empty() ? "" : " " + words.unit);
    }
    if (group.first_move) out += ", first move " + std::to_string(*group.first_move);
    const auto lines = lines_of(s, group);
    if (lines.size() > 1 || (lines.size() == 1 && lines.front().second.size() > 1))
        for (const auto& [file, numbers] : lines)
            out += "; " + file + (numbers.size() > 1 ? " lines " : " line ") + ranges(numbers);
    return out;
}

std::vector<std::size_t> by_danger(const check::Result& result, const std::vector<check::Group>& groups) {
    std::vector<std::size_t> indices(groups.size());
    std::iota(indices.begin(), indices.end(), std::size_t{0});
    const auto worst = [&](std::size_t i) -> const check::Finding& { return result.findings[groups[i].worst]; };
    std::stable_sort(indices.begin(), indices.end(), [&](std::size_t a, std::size_t b) {
        const std::size_t ra = rank_of(worst(a).code), rb = rank_of(worst(b).code);
        return ra != rb ? ra < rb : depth_of(worst(a)) > depth_of(worst(b));
    });
    return indices;
}

}  // namespace obrys::report
