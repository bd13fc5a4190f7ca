#include <algorithm>
#include <array>
#include <map>

#include "base/codes.hpp"
#include "check/result.hpp"

namespace obrys::check {

namespace {

/// Adds a note, or counts it where the same was said: about the same place, or at all.
void add(std::vector<Note>& notes, const base::Diagnostic& d, bool by_place) {
    const auto same = std::find_if(notes.begin(), notes.end(), [&](const Note& n) {
        return n.code == d.code && n.text == d.text && (!by_place || n.where == d.where);
    });
    if (same != notes.end())
        ++same->times;
    else
        notes.push_back({d.code, d.text, d.remedy, d.where, d.stack, 1});
}

Finding finding_of(const base::Diagnostic& d) {
    Finding f;
    f.code = d.code;
    f.severity = d.severity;
    f.text = d.text;
    f.remedy = d.remedy;
    f.where = d.where;
    f.stack = d.stack;
    f.related = d.related;
    return f;
}

}  // namespace

void merge(Result& result, const base::Diagnostics& diagnostics) {
    std::vector<Finding> findings;
    for (const base::Diagnostic& d : diagnostics.all()) {
        switch (base::kind_of(d.code)) {
            case base::CodeKind::finding: findings.push_back(finding_of(d)); break;
            // A word that is not run is one thing, wherever it stands (TRAORI before every operation).
            case base::CodeKind::unchecked:
            case base::CodeKind::input: add(result.unchecked, d, d.code != base::codes::unsupported); break;
            case base::CodeKind::info:
                add(d.code == base::codes::assumption ? result.assumptions : result.listed, d, false);
                break;
        }
    }
    if (diagnostics.dropped() > 0)
        result.unchecked.push_back(
            {base::codes::budget,
             std::to_string(diagnostics.dropped()) + " further complaints of the kinds listed are not shown one by one",
             "",
             nowhere,
             {},
             1});
    result.findings.insert(result.findings.begin(), findings.begin(), findings.end());
    result.verdict = verdict_of(result);
}

void require_cuts(Result& result, const std::string& program) {
    const Stats& s = result.stats;
    if (s.cuts > 0) return;
    const std::string moves = std::to_string(s.moves) + (s.moves == 1 ? " move" : " moves");
    const std::string text = s.moves == 0 ? program + " makes no move: nothing of it was checked"
                             : s.moves == s.rapid_moves
                                 ? program + " makes " + moves + ", all at rapid: no cut was checked"
                                 : program + " makes " + moves + ", those at feed on the spot: no cut was checked";
    result.unchecked.push_back({base::codes::not_run,
                                text,
                                "check the program that calls it, or give the values on which its moves depend",
                                nowhere,
                                {},
                                1});
    result.verdict = verdict_of(result);
}

void restrict_to(Result& result, shop::Scope scope) {
    namespace codes = base::codes;
    constexpr std::array beside_the_part{codes::rapid_in_stock,  codes::holder_in_stock, codes::edges_too_short,
                                         codes::clamp_collision, codes::plunging_cut,    codes::axis_limit,
                                         codes::spindle_limit,   codes::surface_speed,   codes::feed_limit};
    result.scope = scope;
    if (scope == shop::Scope::part) {
        std::map<std::string_view, std::uint64_t> left_out;
        std::erase_if(result.findings, [&](const Finding& f) {
            const bool out = std::find(beside_the_part.begin(), beside_the_part.end(), f.code) != beside_the_part.end();
            if (out) left_out[f.code] += 1 + f.more;
            return out;
        });
        for (const auto& [code, times] : left_out)
            result.assumptions.push_back({codes::assumption,
                                          "outside the scope \"part\" and not judged: " + std::string(code),
                                          "check with scope \"all\"",
                                          nowhere,
                                          {},
                                          times});
    }
    result.verdict = verdict_of(result);
}

}  // namespace obrys::check
