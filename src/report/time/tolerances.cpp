#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/number.hpp"
#include "report/time/parts.hpp"

namespace obrys::report::time {

using sim::time::ToleranceUse;

namespace {

constexpr double most_errors = 0.95;       ///< of the chord errors: what lies above are single places
constexpr std::uint64_t few_places = 100;  ///< say nothing of how a program was made

bool is_below_chords(const ToleranceUse& t) { return t.places >= few_places && t.coarse * 20 > t.places; }

std::string mm(double v) { return base::shortest(std::round(v * 1e5) / 1e5) + " mm"; }

std::string place_of(const ToleranceUse& t, const base::Sources& sources) {
    return sources[t.first.file].name + ":" + std::to_string(sources.position(t.first).line);
}

void put_use(std::string& out, const ToleranceUse& t, const base::Sources& sources) {
    if (t.places < few_places) return;
    out += "  " + mm(t.tolerance) + (t.by_program ? " (in force from " : " (the machine's, from ") +
           place_of(t, sources) + "): chord errors of the program's lines up to " + mm(t.error_of(most_errors)) +
           " at " + std::to_string(t.places) + " places";
    if (is_below_chords(t))
        out += "; " + std::to_string(t.coarse) + " of them are above it and are braked for as corners. " +
               mm(1.1 * t.error_of(most_errors)) + " to " + mm(2 * t.error_of(most_errors)) +
               " let them pass as a curve";
    out += "\n";
}

}  // namespace

void put_tolerances(std::string& out, const Subject& s, const base::Sources& sources) {
    const bool any_below = std::any_of(s.tolerances.begin(), s.tolerances.end(), is_below_chords);
    if (!any_below && s.advised.empty()) return;
    out += any_below ? "\ntolerance below the chord error:\n" : "\ntolerance:\n";
    for (const ToleranceUse& t : s.tolerances)
        if (!s.advised.empty() || is_below_chords(t)) put_use(out, t, sources);
    const double as_it_is = sim::time::sum(s.variants.front().times.all);
    for (const Advised& a : s.advised) {
        const double less = as_it_is - a.seconds;
        out += "  with " + mm(a.tolerance) + " throughout: " + seconds(a.seconds) + ", " + seconds(std::abs(less)) +
               (less >= 0 ? " less" : " more") + "; corners and curves up to " + mm(a.tolerance) +
               " beside the contour\n";
    }
}

nlohmann::ordered_json tolerances_json(const Subject& s, const base::Sources& sources) {
    nlohmann::ordered_json out{{"in_force", nlohmann::ordered_json::array()},
                               {"advised", nlohmann::ordered_json::array()}};
    for (const ToleranceUse& t : s.tolerances)
        out["in_force"].push_back({{"tolerance_mm", t.tolerance},
                                   {"by_program", t.by_program},
                                   {"file", sources[t.first.file].name},
                                   {"line", sources.position(t.first).line},
                                   {"places", t.places},
                                   {"above_tolerance", t.coarse},
                                   {"corners", t.corners},
                                   {"chord_error_mm", t.error_of(most_errors)},
                                   {"below_chord_error", is_below_chords(t)}});
    for (const Advised& a : s.advised)
        out["advised"].push_back({{"tolerance_mm", a.tolerance}, {"total_s", a.seconds}});
    return out;
}

}  // namespace obrys::report::time
