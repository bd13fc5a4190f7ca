#include "driver/timing/calibration_text.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "base/number.hpp"
#include "base/whole.hpp"

namespace obrys::driver {

using sim::time::Sight;

namespace {

/// Three digits are more than such a fit knows.
std::string rounded(double v) {
    if (v == 0) return "0";
    const int digits = 2 - base::clipped(std::floor(std::log10(std::abs(v))), -300, 300);
    const double power = std::pow(10.0, digits);
    return base::shortest(digits > 0 ? std::round(v * power) / power
                                     : std::round(v / std::pow(10.0, -digits)) * std::pow(10.0, -digits));
}

std::string seconds(double s) { return base::fixed(s, s < 100 ? 2 : 1) + " s"; }
std::string percent(double share) { return base::fixed(100 * share, 1) + " %"; }

std::string padded(std::string text, std::size_t width) {
    return text.size() < width ? text + std::string(width - text.size(), ' ') : text;
}

std::string part_of(const Run& r) {
    std::string out = r.program;
    if (r.tool) out += ", tool " + std::to_string(*r.tool);
    if (r.first || r.last)
        out += ", lines " + (r.first ? std::to_string(*r.first) : "1") + " to " +
               (r.last ? std::to_string(*r.last) : "the last");
    return out;
}

const char* word(Sight s) {
    switch (s) {
        case Sight::seen: return "seen";
        case Sight::with_others: return "with-others";
        case Sight::not_seen: break;
    }
    return "not-seen";
}

void put_values(std::string& out, const Calibration& c, Sight sight, const std::string& head) {
    bool any = false;
    for (const FittedValue& v : c.values) {
        if (v.sight != sight) continue;
        if (!std::exchange(any, true)) out += "\n" + head + ":\n";
        const bool factor = v.name == "axis.rapid" || v.name == "feed_override";
        out += "  " + padded(v.name, 24) + (factor ? "times " : "");
        if (sight == Sight::not_seen)
            out += "left at " + rounded(v.before) + "\n";
        else
            out += rounded(v.after) + " (between " + rounded(v.after * std::exp(-v.spread)) + " and " +
                   rounded(v.after * std::exp(v.spread)) + "; was " + rounded(v.before) + ")\n";
    }
}

}  // namespace

std::string as_text(const Calibration& c, const std::string& machine) {
    std::string out = machine + ", " + std::to_string(c.runs.size()) + (c.runs.size() == 1 ? " run\n\n" : " runs\n\n");
    out += padded("measured", 12) + padded("as it is", 22) + padded("calibrated", 22) + "run\n";
    for (const FittedRun& r : c.runs) {
        const auto model = [&](double s) {
            return seconds(s) + " (" + (s >= r.measured ? "+" : "") + percent(s / r.measured - 1) + ")";
        };
        out += padded(seconds(r.measured), 12) + padded(model(r.before), 22) + padded(model(r.after), 22) +
               part_of(r.run) + "\n";
        if (!r.not_whole.empty()) out += "            not fully timed: " + r.not_whole + "\n";
    }
    out += "residuals (root of the mean square): " + percent(c.residual_before) + " as it is, " +
           percent(c.residual_after) + " calibrated\n";
    put_values(out, c, Sight::seen, "seen in these runs");
    put_values(out, c, Sight::with_others, "seen together with others only, so that each alone is open");
    put_values(out, c, Sight::not_seen, "cannot be seen from these runs");
    if (!c.corner.empty())
        out += "\ncorners: " + c.corner +
               (c.corner_is_seen ? ", the others fit clearly worse\n"
                                 : " fits best, the others not clearly worse: it cannot be seen from these runs\n");
    if (c.lag_is_open)
        out += c.lags ? "\nstops: that axes lag behind (motion.servo_gain) fits clearly better\n"
                      : "\nstops: that axes lag behind (motion.servo_gain) cannot be seen from these runs\n";
    for (const auto& [name, shown] : c.exceeded)
        out += "\na trace shows " + rounded(shown) + " mm/min, which is above " + name + " of the machine file\n";
    if (!c.singular.empty()) {
        out += "\nwhat the runs tell, by direction (singular values, relative):";
        for (const double s : c.singular) out += " " + (s < 1e-4 ? std::string("0") : base::fixed(s, 4));
        const auto unseen = std::count_if(c.singular.begin(), c.singular.end(), [](double s) { return s < 1e-2; });
        out += "; " + std::to_string(unseen) + " of " + std::to_string(c.singular.size()) + " not seen (below 0.01)\n";
    }
    return out;
}

std::string as_json(const Calibration& c, const std::string& machine) {
    nlohmann::ordered_json out{{"format", "obrys-calibration"}, {"version", 1}, {"machine", machine}};
    out["residual_before"] = c.residual_before;
    out["residual_after"] = c.residual_after;
    out["runs"] = nlohmann::ordered_json::array();
    for (const FittedRun& r : c.runs) {
        const auto number = [](const std::optional<std::uint32_t>& v) {
            return v ? nlohmann::ordered_json(*v) : nlohmann::ordered_json(nullptr);
        };
        out["runs"].push_back({{"program", r.run.program},
                               {"tool", number(r.run.tool)},
                               {"first", number(r.run.first)},
                               {"last", number(r.run.last)},
                               {"measured_s", r.measured},
                               {"before_s", r.before},
                               {"after_s", r.after},
                               {"not_whole", r.not_whole.empty() ? nlohmann::ordered_json(nullptr)
                                                                 : nlohmann::ordered_json(r.not_whole)}});
    }
    out["values"] = nlohmann::ordered_json::array();
    for (const FittedValue& v : c.values)
        out["values"].push_back({{"name", v.name},
                                 {"before", v.before},
                                 {"after", v.after},
                                 {"log_spread", v.spread},
                                 {"sight", word(v.sight)}});
    out["corner"] = c.corner.empty() ? nlohmann::ordered_json(nullptr) : nlohmann::ordered_json(c.corner);
    out["corner_is_seen"] = c.corner_is_seen;
    out["lags"] = c.lag_is_open ? nlohmann::ordered_json(c.lags) : nlohmann::ordered_json(nullptr);
    out["singular_values"] = c.singular;
    return out.dump(2) + "\n";
}

std::vector<shop::NewValue> new_values(const Calibration& c, const shop::Machine& machine, const std::string& table) {
    const std::string from = "calibrated from " + table + " (" + std::to_string(c.runs.size()) +
                             (c.runs.size() == 1 ? " run" : " runs") + ", residual " + percent(c.residual_after) + ")";
    std::vector<shop::NewValue> out;
    for (const FittedValue& v : c.values) {
        if (v.sight == Sight::not_seen || v.name == "feed_override") continue;
        const std::string origin = from + (v.sight == Sight::with_others ? ", together with others" : "");
        if (v.name != "axis.rapid") {
            out.push_back({v.name, rounded(v.after), origin});
            continue;
        }
        for (const shop::MachineAxis& a : machine.axes)
            if (a.name == "X" || a.name == "Y" || a.name == "Z")
                out.push_back({"axis." + a.name + ".rapid", rounded(a.rapid * v.after), origin});
    }
    if (c.corner_is_seen) out.push_back({"motion.corner", "\"" + c.corner + "\"", from});
    return out;
}

}  // namespace obrys::driver
