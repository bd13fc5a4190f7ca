#include "driver/timing/calibrate.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "base/codes.hpp"
#include "driver/files.hpp"
#include "sim/time/machine_value.hpp"

namespace obrys::driver {

namespace times = sim::time;

namespace {

constexpr double relative_spread = 0.01, absolute_spread = 0.2;  ///< of a measured time, s: what the model leaves out
constexpr const char* all_rapids = "axis.rapid";

void apply(times::Dynamics& d, const std::string& name, double value) {
    if (name != all_rapids) {
        times::set_value(d, name, value);
        return;
    }
    for (times::AxisLimits& axis : d.axes) axis.speed *= value;  // a factor
}

double seconds_of(const Run& run, const times::Times& t, const Session& s) {
    if (!run.first && !run.last) {
        if (!run.tool) return times::sum(t.all);
        const auto found = t.tools.find(*run.tool);
        return found == t.tools.end() ? 0 : times::sum(found->second);
    }
    double sum = 0;
    for (const times::Spent& spent : t.places) {
        if (spent.place.file != s.main->file) continue;
        const std::uint32_t line = s.sources.position(spent.place.file, spent.place.begin).line;
        if (line >= run.first.value_or(0) && line <= run.last.value_or(UINT32_MAX)) sum += spent.seconds;
    }
    return sum;
}

/// How far off a value may be, by where it is from: half to twice is 0.7 of a logarithm.
double spread_of(const times::Value& v) {
    if (v.assumed) return 1.4;
    const bool said_so = v.origin == "the machine file" || v.origin.starts_with("calibrated");
    return said_so ? 0.35 : 0.1;
}

}  // namespace

bool Recorded::open(const Request& request, std::uint32_t table, std::vector<Run> runs, base::Sources& sources,
                    base::Diagnostics& diagnostics) {
    std::map<std::string, std::size_t> known;
    const fs::path folder = fs::path(sources[table].name);
    for (Run& run : runs) {
        const std::string path = beside(folder, run.program).string();
        const auto found = known.find(path);
        if (found == known.end()) {
            check_readable(*request.folders->storage(), path, diagnostics, run.where);
            if (diagnostics.has_errors()) return false;
            auto session = std::make_shared<Session>();
            Request own = request;
            own.input = path;
            if (!driver::open(own, *session)) {
                programs_.push_back(std::move(session));  // whoever asks is told why
                complain(diagnostics, base::codes::runs_file, run.where, run.program + " cannot be read");
                return false;
            }
            known.emplace(path, programs_.size());
            programs_.push_back(std::move(session));
        }
        Part part{{std::move(run), 0, 0, 0, {}, {}}, known.at(path)};
        part.fitted.measured = part.fitted.run.seconds;
        if (!part.fitted.run.trace.empty()) {
            const auto file = load(*request.folders->storage(), beside(folder, part.fitted.run.trace), sources,
                                   diagnostics, part.fitted.run.where_trace);
            if (!file) return false;
            part.fitted.trace = read_trace(*file, sources, diagnostics);
            if (!part.fitted.trace) return false;
            if (part.fitted.run.seconds == 0) part.fitted.measured = part.fitted.trace->seconds;
        }
        parts_.push_back(std::move(part));
    }
    return true;
}

std::vector<std::vector<double>> Recorded::seconds(const std::vector<std::vector<Change>>& sets,
                                                   std::optional<times::CornerMode> corner) {
    std::vector<std::vector<double>> all(sets.size(), std::vector<double>(parts_.size(), 0.0));
    for (std::size_t p = 0; p < programs_.size(); ++p) {
        Session run(programs_[p]);
        std::vector<Timing> timings;
        for (const std::vector<Change>& set : sets) {
            Timing t{dynamics_of(run), {}};
            if (corner) t.dynamics.corner = *corner;
            for (const auto& [name, value] : set) apply(t.dynamics, name, value);
            timings.push_back(std::move(t));
        }
        const std::vector<Timed> timed = time_program(run, timings);
        const int code = exit_code_of_run(run);
        for (std::size_t k = 0; k < parts_.size(); ++k) {
            if (parts_[k].program != p) continue;
            parts_[k].fitted.not_whole = not_whole(code);
            if (!timed.front().times.is_understood())
                parts_[k].fitted.not_whole = "a feed, a place or a spindle's speed is not known";
            for (std::size_t i = 0; i < sets.size(); ++i)
                all[i][k] = seconds_of(parts_[k].fitted.run, timed[i].times, run);
        }
    }
    return all;
}

std::vector<std::pair<std::string, times::Unknown>> Recorded::unknowns() const {
    const times::Dynamics d = dynamics_of(*programs_.front());
    std::vector<std::pair<std::string, times::Unknown>> out;
    double rapids = 0;
    for (const times::Value& v : d.values) {
        if (v.name.starts_with("axis.") && v.name.ends_with(".rapid") && v.name.size() == 12)
            rapids = std::max(rapids, spread_of(v));
        const bool fitted = v.name == "motion.acceleration" || v.name == "motion.jerk" || v.name == "tool_change_time" ||
                            v.name == "motion.spindle_time" || v.name == "motion.strobe_time" ||
                            v.name == "motion.block_time" || v.name == "motion.tolerance" ||
                            v.name == "motion.servo_gain";
        if (!fitted || std::isnan(v.value)) continue;
        // A machine that is assumed not to lag may all the same: from where it does not matter much.
        constexpr double hardly_lags = 60;
        const double value = v.value == 0 && v.name == "motion.servo_gain" && v.assumed ? hardly_lags : v.value;
        if (value > 0) out.emplace_back(v.name, times::Unknown{value, spread_of(v)});
    }
    if (rapids > 0) out.emplace_back(all_rapids, times::Unknown{1, rapids});
    constexpr double knob = 0.05;  // what an operator turns it by without a thought
    out.emplace_back("feed_override", times::Unknown{1, knob});
    return out;
}

Calibration Recorded::calibrate() {
    Calibration c;
    std::vector<times::Measured> measured;
    for (const Part& p : parts_)
        measured.push_back({p.fitted.measured, relative_spread * p.fitted.measured + absolute_spread});
    const auto names = unknowns();
    std::vector<times::Unknown> open;
    for (const auto& [name, unknown] : names) open.push_back(unknown);
    const times::Dynamics as_it_is = dynamics_of(*programs_.front());
    const auto said = std::find_if(as_it_is.values.begin(), as_it_is.values.end(),
                                   [](const times::Value& v) { return v.name == "motion.corner"; });
    std::vector<times::CornerMode> modes{as_it_is.corner};
    if (said->assumed)
        modes = {times::CornerMode::filter, times::CornerMode::blend, times::CornerMode::exact_stop};
    times::Fitted best;
    double second = INFINITY;
    for (std::size_t m = 0; m < modes.size(); ++m) {
        const times::Model model = [&](const std::vector<std::vector<double>>& sets) {
            std::vector<std::vector<Change>> changes;
            for (const std::vector<double>& set : sets) {
                std::vector<Change>& change = changes.emplace_back();
                for (std::size_t i = 0; i < set.size(); ++i) change.emplace_back(names[i].first, set[i]);
            }
            return seconds(changes, modes[m]);
        };
        times::Fitted fitted = times::fit(open, measured, model);
        const bool better = m == 0 || fitted.misfit < best.misfit;
        second = std::min(second, m == 0 ? INFINITY : better ? best.misfit : fitted.misfit);
        if (better) best = std::move(fitted);
        if (better && said->assumed) c.corner = times::corner_names[static_cast<std::size_t>(modes[m])];
    }
    constexpr double clearly = 4;  // two standard deviations
    c.corner_is_seen = !c.corner.empty() && second - best.misfit > clearly;
    c.singular = best.singular;
    const std::vector<double> before = seconds({{}}, {}).front();
    double squares_before = 0, squares_after = 0;
    for (std::size_t k = 0; k < parts_.size(); ++k) {
        FittedRun& run = parts_[k].fitted;
        run.before = before[k];
        run.after = best.predicted[k];
        squares_before += std::pow(run.before / run.measured - 1, 2);
        squares_after += std::pow(run.after / run.measured - 1, 2);
        c.runs.push_back(run);
    }
    c.residual_before = std::sqrt(squares_before / static_cast<double>(parts_.size()));
    c.residual_after = std::sqrt(squares_after / static_cast<double>(parts_.size()));
    for (std::size_t i = 0; i < names.size(); ++i)
        c.values.push_back(
            {names[i].first, open[i].value, best.values[i].value, best.values[i].spread, best.values[i].sight});
    for (const FittedRun& run : c.runs)
        for (std::size_t i = 0; run.trace && i < 3; ++i)
            if (const double shown = run.trace->speed[i] * 60; shown > as_it_is.axes[i].speed * 60 * 1.01)
                c.exceeded.emplace_back("axis." + std::string(1, "XYZ"[i]) + ".rapid", shown);
    return c;
}

}  // namespace obrys::driver
