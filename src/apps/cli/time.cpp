/// obrys time.

#include <algorithm>
#include <array>
#include <cstdio>
#include <optional>

#include "base/number.hpp"
#include "commands.hpp"
#include "driver/timing/time_program.hpp"
#include "milled.hpp"
#include "report/time/time.hpp"
#include "session.hpp"
#include "sim/time/machine_value.hpp"

namespace obrys::cli {

namespace {

namespace times = sim::time;

struct Variant {
    std::string name;
    times::Dynamics dynamics;
};

/// False: there is no such value of a machine, or not this.
bool set(times::Dynamics& d, const std::string& name, const std::string& value) {
    if (name == "corner") {
        const auto found = std::find(times::corner_names.begin(), times::corner_names.end(), value);
        if (found == times::corner_names.end()) return false;
        d.corner = static_cast<times::CornerMode>(found - times::corner_names.begin());
        return true;
    }
    const std::optional<double> number = base::parse_double(value);
    return number && times::set_value(d, name == "tool_change_time" ? name : "motion." + name, *number);
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
                             "acceleration, jerk, window (above 0), block_time, look_ahead, servo_gain, spindle_time, "
                             "strobe_time, tool_change_time, corner\n",
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

/// Other tolerances in the place of the program's, mm.
constexpr std::array advised{0.002, 0.005, 0.01, 0.02, 0.05, 0.1};

}  // namespace

int time(const Arguments& a) {
    driver::Session s;
    if (!open(a, s)) return 2;
    const times::Dynamics as_it_is = driver::dynamics_of(s);
    std::vector<Variant> variants{{"", as_it_is}};
    if (!read_variants(a.variants, as_it_is, variants)) return 2;
    // A page of text names the slowest lines alone: what the others took need not be kept.
    constexpr std::size_t kept_places = 20'000, samples = 2'000;
    std::vector<driver::Timing> timings;
    for (const Variant& v : variants) timings.push_back({v.dynamics, {std::max(a.lines, kept_places), 0, {}}});
    if (a.format == "json") timings.front().options.places = 0;
    if (!a.svg.empty()) timings.front().options.samples = samples;
    if (a.advise)
        for (const double mm : advised) timings.push_back({as_it_is, {1, 0, mm}});
    std::vector<driver::Timed> timed = driver::time_program(s, timings);
    int code = driver::exit_code_of_run(s);
    report::time::Subject subject{
        s.program, s.control, s.job.machine.name, driver::not_whole(code), {}, as_it_is.values, {}, {}};
    for (std::size_t i = 0; i < variants.size(); ++i)
        subject.variants.push_back({variants[i].name, std::move(timed[i].times)});
    subject.tolerances = timed.front().tolerances;
    for (std::size_t i = variants.size(); i < timed.size(); ++i)
        subject.advised.push_back({advised[i - variants.size()], times::sum(timed[i].times.all)});
    print_diagnostics(s, base::Severity::warning);
    if (code == 2 || !may_write(a, s) || s.files->failed()) return 2;
    const times::Times& first = subject.variants.front().times;
    if (code == 0 && !first.is_understood()) code = 3;
    if (!a.svg.empty() && !deliver(a.svg, report::time::as_svg(subject, timed.front().curve, s.sources))) return 2;
    const std::string text = a.format == "json" ? report::time::as_json(subject, s.sources)
                                                : report::time::as_text(subject, s.sources, {a.lines});
    return deliver(a.output, text) ? code : 2;
}

}  // namespace obrys::cli
