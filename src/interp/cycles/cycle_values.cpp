/// Values of cycles that are no numbers where they are written: FMAX, FAUTO, FU, FZ, PREDEF; GLOBAL DEF.

#include <cmath>

#include "base/codes.hpp"
#include "interp/cycles/cycles.hpp"

namespace obrys::interp {

namespace codes = base::codes;
using program::CycleDefinition;
using program::CycleSetting;
using program::SettingGiven;

namespace {

/// What the words FMAX, FAUTO, FU and FZ stand for now, in the program's unit of feed; `value`: what follows them.
double feed_of_word(const Reckoning& run, SettingGiven given, double value) {
    const double feed_unit = run.modal.inch_feed ? run.unit().traits->inch_feed : 1;
    const double per_rev = value * length_unit(run.modal) * run.spindle.speed / feed_unit;
    switch (given) {
        case SettingGiven::rapid: return fastest_feed;
        case SettingGiven::tool_feed: return run.tool.feed > 0 ? run.tool.feed / feed_unit : NAN;
        case SettingGiven::per_rev: return per_rev;
        case SettingGiven::per_tooth:
            return run.tool.data != nullptr && run.tool.data->teeth > 0 ? per_rev * run.tool.data->teeth : NAN;
        default: return value;
    }
}

double global_value(Reckoning& run, const CycleSetting& s) {
    if (const auto found = run.global_values.find(s.parameter); found != run.global_values.end()) return found->second;
    unchecked(run, codes::unknown_value, s.where, "PREDEF: no GLOBAL DEF before this cycle gives this parameter",
              "program GLOBAL DEF with it at the beginning, or write the value here");
    return NAN;
}

}  // namespace

double value_at_definition(Reckoning& run, const CycleSetting& s, double written) {
    return s.given == SettingGiven::set_globally ? global_value(run, s) : feed_of_word(run, s.given, written);
}

double value_at_call(const Reckoning& run, const ActiveCycle& c, std::size_t i) {
    const CycleSetting& s = c.definition->settings[i];
    if (s.parameter == program::no_target) return c.values[i];
    const double now = run.parameters.get(s.parameter), then = c.values[i];
    const bool untouched = now == then || (std::isnan(now) && std::isnan(then));
    const bool by_word = s.given != SettingGiven::number && s.given != SettingGiven::set_globally;
    return by_word && untouched ? feed_of_word(run, s.given, c.written[i]) : now;
}

void set_globally(Reckoning& run, const CycleDefinition& d) {
    for (const CycleSetting& s : d.settings) run.global_values[s.parameter] = number(run, s.value);
}

void say_unknown_words(Reckoning& run, const ActiveCycle& c) {
    for (std::size_t i = 0; i < c.values.size(); ++i) {
        const CycleSetting& s = c.definition->settings[i];
        if (s.given == SettingGiven::tool_feed && !(run.tool.feed > 0))
            unchecked(run, codes::unknown_value, s.where, "FAUTO: TOOL CALL gives no feed", "write F in TOOL CALL");
        if (s.given == SettingGiven::per_tooth && (run.tool.data == nullptr || run.tool.data->teeth <= 0))
            unchecked(run, codes::unknown_value, s.where,
                      "FZ needs the number of teeth of the tool, which is not known",
                      "give the tool in a tool table with its column CUT.");
    }
}

}  // namespace obrys::interp
