#include <cmath>
#include <nlohmann/json.hpp>

#include "cl/unknown_tool.hpp"
#include "report/time/parts.hpp"

namespace obrys::report::time {

using sim::time::Seconds;
using sim::time::sum;
using sim::time::Times;
using OrderedJson = nlohmann::ordered_json;

namespace {

OrderedJson causes_json(const Seconds& s) {
    OrderedJson out = OrderedJson::object();
    for (std::size_t i = 0; i < s.size(); ++i)
        if (s[i] != 0) out[std::string(sim::time::cause_names[i])] = s[i];
    return out;
}

/// One line of text each: a million of them as a tree would take a gigabyte.
std::string lines_json(const Times& t, const base::Sources& sources) {
    std::string out = "  \"by_line\": [";
    const char* before = "\n    ";
    for (const Line& l : slow_lines(t, sources, t.places.size())) {
        out += before + OrderedJson{{"file", sources[l.file].name},
                                    {"line", l.line},
                                    {"seconds", l.all},
                                    {"cause", name_of(largest(l.seconds))},
                                    {"causes", causes_json(l.seconds)}}
                            .dump();
        before = ",\n    ";
    }
    return out + "\n  ],\n";
}

/// Two objects as one, with what stands between them.
std::string joined(const std::string& first, const std::string& between, const std::string& last) {
    return first.substr(0, first.size() - 2) + ",\n" + between + last.substr(2) + "\n";
}

}  // namespace

std::string as_json(const Subject& s, const base::Sources& sources) {
    const Times& t = s.variants.front().times;
    const Range range = range_of(t, s.values);
    OrderedJson out{
        {"format", "obrys-time"}, {"version", 1}, {"program", s.name}, {"control", s.control}, {"machine", s.machine}};
    out["total_s"] = sum(t.all);
    out["range_s"] = {range.low, range.high};
    out["complete"] = s.not_whole.empty() && t.is_whole();
    out["not_whole"] = s.not_whole.empty() ? OrderedJson(nullptr) : OrderedJson(s.not_whole);
    out["moves"] = t.moves;
    out["path_mm"] = t.way;
    out["unplaced_moves"] = t.from_nowhere;
    out["untimed_moves"] = t.untimed;
    out["untimed_dwells"] = t.untimed_dwells;
    out["untimed_speeds"] = t.untimed_speeds;
    out["stops"] = t.stops;
    out["causes"] = causes_json(t.all);
    out["tools"] = OrderedJson::array();
    for (const auto& [number, spent] : t.tools)
        out["tools"].push_back({{"number", number == cl::unknown_tool ? OrderedJson(nullptr) : OrderedJson(number)},
                                {"seconds", sum(spent)},
                                {"causes", causes_json(spent)}});
    out["probing_moves"] = t.probings;
    OrderedJson behind = OrderedJson::object();  // the lines, which may be a million
    behind["assumed"] = OrderedJson::array();
    behind["values"] = OrderedJson::array();
    for (const sim::time::Value& v : s.values) {
        OrderedJson value{{"name", v.name},
                          {"value", std::isnan(v.value) ? OrderedJson(v.unit) : OrderedJson(v.value)},
                          {"unit", std::isnan(v.value) ? OrderedJson(nullptr) : OrderedJson(v.unit)}};
        if (v.assumed) behind["assumed"].push_back(value);
        value["origin"] = v.origin;
        behind["values"].push_back(std::move(value));
    }
    behind["tolerances"] = tolerances_json(s, sources);
    behind["variants"] = OrderedJson::array();
    for (std::size_t i = 1; i < s.variants.size(); ++i)
        behind["variants"].push_back({{"name", s.variants[i].name},
                                      {"total_s", sum(s.variants[i].times.all)},
                                      {"causes", causes_json(s.variants[i].times.all)}});
    return joined(out.dump(2), lines_json(t, sources), behind.dump(2));
}

}  // namespace obrys::report::time
