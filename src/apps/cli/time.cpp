/// obrys time.

#include <algorithm>
#include <cstdio>
#include <optional>

#include "base/number.hpp"
#include "base/whole.hpp"
#include "commands.hpp"
#include "driver/program_tools.hpp"
#include "milled.hpp"
#include "report/time/time.hpp"
#include "session.hpp"
#include "sim/time/timer.hpp"

namespace obrys::cli {

namespace {

namespace times = sim::time;

struct Variant {
    std::string name;
    times::Dynamics dynamics;
};

/// Axes that say nothing of their own follow the path.
bool set_path(times::Dynamics& d, double value, double times::Limits::*path, double times::AxisLimits::*own) {
    const auto follow = [&](times::AxisLimits& l) { l.*own = l.*own == d.path.*path ? value : l.*own; };
    for (times::AxisLimits& l : d.axes) follow(l);
    for (auto& [axis, l] : d.others) follow(l);
    d.path.*path = value;
    return true;
}

/// False: there is no such value of a machine, or not this.
bool set(times::Dynamics& d, const std::string& name, const std::string& value) {
    if (name == "corner") {
        for (const auto& [word, mode] :
             {std::pair{"exact-stop", times::CornerMode::exact_stop}, std::pair{"filter", times::CornerMode::filter},
              std::pair{"blend", times::CornerMode::blend}})
            if (value == word) return d.corner = mode, true;
        return false;
    }
    const std::optional<double> number = base::parse_double(value);
    if (!number || !std::isfinite(*number) || *number < 0) return false;
    if (name == "block_time") return d.block_time = *number, true;
    if (name == "look_ahead") return d.look_ahead = base::clipped<std::size_t>(*number, 0, 1'000'000'000), true;
    if (*number == 0) return false;
    if (name == "tolerance") return d.tolerance = *number, true;
    if (name == "acceleration")
        return set_path(d, *number, &times::Limits::acceleration, &times::AxisLimits::acceleration);
    if (name == "jerk") return set_path(d, *number, &times::Limits::jerk, &times::AxisLimits::jerk);
    return false;
}

bool read_variants(const std::vector<std::string>& texts, const times::Dynamics& as_it_is,
                   std::vector<Variant>& variants) {
    for (const std::string& text : texts) {
        const std::size_t equals = text.find('=');
        const std::string name = text.substr(0, equals);
        std::string values = equals == std::string::npos ? "" : text.substr(equals + 1);
        while (true) {
            const std::size_t comma = values.find(',');
            const std::string value = values.substr(0, comma);
            Variant v{name + " = " + value, as_it_is};
            if (!set(v.dynamics, name, value)) {
                std::fprintf(stderr,
                             "obrys: --compare %s: must be of the form tolerance=0.01,0.05; names: tolerance, "
                             "acceleration, jerk (above 0), block_time, look_ahead, corner\n",
                             text.c_str());
                return false;
            }
            variants.push_back(std::move(v));
            if (comma == std::string::npos) break;
            values.erase(0, comma + 1);
        }
    }
    return true;
}

std::string not_whole(int code) {
    if (code == 1) return "the control would stop with an alarm";
    if (code == 3) return "something was not understood or not run";
    return {};
}

}  // namespace

int time(const Arguments& a) {
    driver::Session s;
    if (!open(a, s)) return 2;
    for (shop::Tool& tool : driver::program_tools(*s.main, s.job.tools, s.diagnostics))
        s.job.tools.push_back(std::move(tool));
    const times::Dynamics as_it_is = times::dynamics_of(s.job.machine);
    std::vector<Variant> variants{{"", as_it_is}};
    if (!read_variants(a.variants, as_it_is, variants)) return 2;
    std::vector<times::Timer> timers;
    for (const Variant& v : variants) timers.emplace_back(s.job.tools, v.dynamics);
    static_cast<void>(driver::interpret(s, [&](const cl::Record& record) {
        for (times::Timer& t : timers) t.take(record);
    }));
    int code = driver::exit_code_of_run(s);
    report::time::Subject subject{s.program,        s.control, s.job.machine.name, not_whole(code), {},
                                  as_it_is.assumed, false};
    for (std::size_t i = 0; i < timers.size(); ++i) subject.variants.push_back({variants[i].name, timers[i].finish()});
    subject.any_assumed_dynamics =
        std::any_of(as_it_is.assumed.begin(), as_it_is.assumed.end(),
                    [](const times::Assumed& v) { return v.name == "motion.acceleration" || v.name == "motion.jerk"; });
    print_diagnostics(s, base::Severity::warning);
    if (code == 2 || !may_write(a, s) || s.files->failed()) return 2;
    const times::Times& first = subject.variants.front().times;
    if (code == 0 && !first.is_understood()) code = 3;
    const std::string text = a.format == "json" ? report::time::as_json(subject, s.sources)
                                                : report::time::as_text(subject, s.sources, {a.lines});
    return deliver(a.output, text) ? code : 2;
}

}  // namespace obrys::cli
