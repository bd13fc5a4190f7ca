#include <algorithm>

#include "base/codes.hpp"
#include "check/result.hpp"

namespace obrys::check {

namespace {

/// Adds a note, or counts it where the same was said about the same place or, for notes that are only listed, at all.
void add(std::vector<Note>& notes, const base::Diagnostic& d, bool by_place) {
    const auto same = std::find_if(notes.begin(), notes.end(), [&](const Note& n) {
        return n.code == d.code && n.text == d.text && (!by_place || n.where == d.where);
    });
    if (same != notes.end())
        ++same->times;
    else
        notes.push_back({d.code, d.text, d.remedy, d.where, d.stack, 1});
}

}  // namespace

void merge(Result& result, const base::Diagnostics& diagnostics) {
    std::vector<Finding> findings;
    for (const base::Diagnostic& d : diagnostics.all()) {
        switch (base::kind_of(d.code)) {
            case base::CodeKind::finding:
                findings.push_back(
                    {d.code, d.severity, d.text, d.remedy, d.where, d.stack, d.related, {}, {}, {}, {}, {}, {}, {}});
                break;
            case base::CodeKind::unchecked:
            case base::CodeKind::input: add(result.unchecked, d, true); break;
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

}  // namespace obrys::check
