/// What is wrong with the call of a defined cycle.

#include <algorithm>

#include "base/codes.hpp"
#include "interp/complaints.hpp"
#include "interp/cycles/cycles.hpp"

namespace obrys::interp {

namespace codes = base::codes;
using program::CycleSetting;

void report(Saying& run, const ActiveCycle& c, const std::vector<cycles::Complaint>& complaints) {
    for (const cycles::Complaint& k : complaints) {
        base::Span where = run.here();
        for (const CycleSetting& s : c.definition->settings)
            if (k.role && s.role == *k.role) where = s.where;
        base::Diagnostic d{k.fatal ? base::Severity::error : base::Severity::warning,
                           k.fatal || k.doubtful ? codes::value_range : codes::assumption,
                           where,
                           c.definition->name + ": " + k.text,
                           k.remedy,
                           run.stacks->sites(run.top().stack),
                           {}};
        if (!(where == run.here())) d.related.push_back({run.here(), "called here"});
        raise(run, std::move(d));
    }
}

namespace {

/// The cause is something that is not known; the complaints that name it.
bool not_run_for_unknown(Saying& run, const ActiveCycle& c, const cycles::Expansion& e) {
    if (e.simulated || !e.assumption.empty() || e.complaints.empty()) return false;
    const bool all = std::all_of(e.complaints.begin(), e.complaints.end(), [](const cycles::Complaint& k) {
        return !k.fatal && !k.role && k.text.find("not known") != std::string::npos;
    });
    if (!all) return false;
    for (const cycles::Complaint& k : e.complaints)
        unchecked(run, codes::unknown_value, run.here(), c.definition->name + " is not run: " + k.text,
                  k.remedy.empty() ? "give it in the job; what a tool has, in its [[tool]]" : k.remedy);
    return true;
}

}  // namespace

void report(Saying& run, const ActiveCycle& c, const cycles::Expansion& e) {
    if (not_run_for_unknown(run, c, e)) return;
    report(run, c, e.complaints);
    if (!e.assumption.empty()) assume(run, run.here(), c.definition->name + ": " + std::string(e.assumption));
    if (!e.simulated)
        unchecked(run, codes::unsupported, run.here(), c.definition->name + " is not run: its path is not known here");
}

}  // namespace obrys::interp
