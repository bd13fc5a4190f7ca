#include "driver/overrides.hpp"

#include <algorithm>
#include <set>

#include "base/codes.hpp"
#include "shop/nearest.hpp"

namespace obrys::driver {

namespace {

struct Used {
    std::set<std::string> names;
    bool computed = false;  ///< parameters by a computed number: it may be any
};

void add(Used& used, const program::Unit& unit, const program::Names& names) {
    for (const program::Expr& e : unit.exprs) {
        if (e.kind == program::ExprKind::parameter) used.names.insert(program::parameter_name(*unit.traits, e.a));
        if (e.kind == program::ExprKind::variable) used.names.insert(names.text(e.a));
        used.computed = used.computed || e.kind == program::ExprKind::parameter_at;
    }
    for (const program::Define& d : unit.defines)
        for (const program::Variable& v : d.variables) used.names.insert(names.text(v.name));
    for (const program::CycleDefinition& c : unit.cycles)
        for (const program::CycleSetting& s : c.settings)
            if (s.parameter != program::no_target)
                used.names.insert(program::parameter_name(*unit.traits, s.parameter));
}

/// The parameter as the control names it: R03 is R3.
std::string plain(const program::Traits& t, const std::string& name) {
    const std::uint32_t n = program::find_parameter(t, name);
    return n < program::parameter_count(t) ? program::parameter_name(t, n) : name;
}

}  // namespace

void check_overrides(Session& s, const interp::Outcome& outcome) {
    if (s.job.overrides.empty()) return;
    Used used;
    for (const auto& unit : s.programs->units()) add(used, *unit, s.programs->names());
    const program::Traits& traits = *s.main->traits;
    for (const shop::Override& o : s.job.overrides) {
        const std::string name = plain(traits, o.name);
        if (outcome.replaced.contains(name)) continue;
        const bool numbered = program::find_parameter(traits, o.name) < program::parameter_count(traits);
        const std::string what = (o.where.file == nowhere.file ? "--set " : "[set] ") + o.name;
        if (used.names.contains(name) || (numbered && used.computed)) {
            s.diagnostics.add({base::Severity::note,
                               base::codes::assumption,
                               o.where,
                               what + " replaces nothing: no constant is assigned to it in this run",
                               "what " + name + " holds before the program is given in [variables] of the job",
                               {},
                               {}});
            continue;
        }
        const std::string near = shop::nearest(name, {used.names.begin(), used.names.end()});
        s.diagnostics.add({base::Severity::error,
                           base::codes::job_value,
                           o.where,
                           what + ": no program of this run uses " + name,
                           near.empty() ? std::string{} : "did you mean " + near + "?",
                           {},
                           {}});
    }
}

}  // namespace obrys::driver
