#include "report/subject.hpp"

#include <algorithm>
#include <array>
#include <numeric>

#include "base/codes.hpp"
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

std::string verdict_line(const check::Result& r) {
    const std::string found = count_of(r.findings.size() + r.findings_dropped, "finding");
    switch (r.verdict) {
        case check::Verdict::clean: return "clean: nothing found in " + count_of(r.stats.moves, "move");
        case check::Verdict::findings: return found;
        case check::Verdict::not_fully_checked: break;
    }
    const std::size_t n = r.unchecked.size();
    return "not fully checked: " + count_of(n, "thing") + (n == 1 ? " was" : " were") + " not checked; " + found;
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
        Entry{"height_mm", "height", "mm"},
        Entry{"z_from_mm", "from Z", "mm"},
        Entry{"z_to_mm", "to Z", "mm"},
        Entry{"excess_mm", "outside its travel by", "mm"},
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

std::vector<std::size_t> by_danger(const std::vector<check::Finding>& findings) {
    namespace codes = base::codes;
    // What breaks the machine or the tool first, then what spoils the part, then what only has to be done again.
    constexpr std::array order{codes::rapid_in_stock,  codes::gouge,        codes::axis_limit,
                               codes::spindle_stopped, codes::tool_missing, codes::spindle_limit,
                               codes::feed_missing,    codes::feed_limit,   codes::allowance_cut};
    const auto rank = [&](const check::Finding& f) {
        if (f.code == codes::rest_material) return order.size() + 1;  // after everything else
        return static_cast<std::size_t>(std::find(order.begin(), order.end(), f.code) - order.begin());
    };
    const auto depth = [](const check::Finding& f) {
        double d = 0;
        for (const check::Amount& a : f.amounts)
            if (a.key == "depth_x_mm" || a.key == "depth_mm" || a.key == "excess_mm") d = std::max(d, a.value);
        return d;
    };
    std::vector<std::size_t> indices(findings.size());
    std::iota(indices.begin(), indices.end(), std::size_t{0});
    std::stable_sort(indices.begin(), indices.end(), [&](std::size_t a, std::size_t b) {
        const std::size_t ra = rank(findings[a]), rb = rank(findings[b]);
        return ra != rb ? ra < rb : depth(findings[a]) > depth(findings[b]);
    });
    return indices;
}

}  // namespace obrys::report
