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

/// Of a measured time: what the model leaves out, s, and how much events differ from time to time.
constexpr double relative_spread = 0.01, absolute_spread = 0.2, event_spread = 0.3;
constexpr const char* all_rapids = "axis.rapid";

void apply(times::Dynamics& d, const std::string& name, double value) {
    if (name != all_rapids) {
        times::set_value(d, name, value);
        return;
    }
    for (times::AxisLimits& axis : d.axes) axis.speed *= value;  // a factor
}

times::Seconds spent_in(const Run& run, const times::Times& t, const Session& s) {
    if (!run.first && !run.last) {
        if (!run.tool) return t.all;
        const auto found = t.tools.find(*run.tool);
        return found == t.tools.end() ? times::Seconds{} : found->second;
    }
    times::Seconds sum{};
    for (const times::Spent& spent : t.places) {
        if (spent.place.file != s.main->file) continue;
        const std::uint32_t line = s.sources.position(spent.place.file, spent.place.begin).line;
        if (line >= run.first.value_or(0) && line <= run.last.value_or(UINT32_MAX))
            sum[static_cast<std::size_t>(spent.cause)] += spent.seconds;
    }
    return sum;
}

/// Of what takes more or less each time: how far the magazine turns, how fast the spindle was.
double of_events(const times::Seconds& s) {
    double sum = 0;
    for (const times::Cause c : {times::Cause::tool_change, times::Cause::spindle, times::Cause::m_function})
        sum += s[static_cast<std::size_t>(c)];
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
                                                   times::CornerMode corner) {
    std::vector<std::vector<double>> all(sets.size(), std::vector<double>(parts_.size(), 0.0));
    for (std::size_t p = 0; p < programs_.size(); ++p) {
        Session run(programs_[p]);
        std::vector<Timing> timings;
        for (const std::vector<Change>& set : sets) {
            Timing t{dynamics_of(run), {}};
            t.dynamics.corner = corner;
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
                all[i][k] = times::sum(spent_in(parts_[k].fitted.run, timed[i].times, run));
            if (parts_[k].events < 0) parts_[k].events = of_events(spent_in(parts_[k].fitted.run, timed[0].times, run));
        }
    }
    return all;
}

double Recorded::shown_rapid(const times::Dynamics& d) const {
    constexpr double clearly = 1.01;
    double most = 1;
    for (const Part& p : parts_)
        for (std::size_t i = 0; p.fitted.trace && i < 3; ++i)
            most = std::max(most, p.fitted.trace->speed[i] / d.axes[i].speed);
    return most > clearly ? most : 1;
}

Recorded::Unknowns Recorded::unknowns(bool lags) const {
    const times::Dynamics d = dynamics_of(*programs_.front());
    Unknowns out;
    double rapids = 0;
    for (const times::Value& v : d.values) {
        if (v.name.starts_with("axis.") && v.name.ends_with(".rapid") && v.name.size() == 12)
            rapids = std::max(rapids, spread_of(v));
        const bool fitted = v.name == "motion.acceleration" || v.name == "motion.jerk" ||
                            v.name == "tool_change_time" || v.name == "motion.spindle_time" ||
                            v.name == "motion.strobe_time" || v.name == "motion.block_time" ||
                            v.name == "motion.tolerance" || v.name == "motion.servo_gain";
        if (!fitted || std::isnan(v.value)) continue;
        constexpr double usual_gain = 1000.0 / 60;  // 1 m/min/mm
        const double value = v.value == 0 && v.name == "motion.servo_gain" && lags ? usual_gain : v.value;
        if (value > 0) out.emplace_back(v.name, times::Unknown{value, spread_of(v)});
    }
    // What a trace has shown is known, whatever the file says.
    constexpr double near_by = 0.05;
    const double shown = shown_rapid(d);
    if (shown > 1)
        out.emplace_back(all_rapids, times::Unknown{shown, near_by});
    else if (rapids > 0)
        out.emplace_back(all_rapids, times::Unknown{1, rapids});
    constexpr double knob = 0.05;  // what an operator turns it by without a thought
    out.emplace_back("feed_override", times::Unknown{1, knob});
    return out;
}

std::vector<times::Measured> Recorded::measured() const {
    std::vector<times::Measured> out;
    for (const Part& p : parts_)
        out.push_back({p.fitted.measured, std::hypot(relative_spread * p.fitted.measured + absolute_spread,
                                                     event_spread * std::max(0.0, p.events))});
    return out;
}

times::Fitted Recorded::fit(const Unknowns& names, times::CornerMode corner) {
    std::vector<times::Unknown> open;
    for (const auto& [name, unknown] : names) open.push_back(unknown);
    return times::fit(open, measured(), [&](const std::vector<std::vector<double>>& sets) {
        std::vector<std::vector<Change>> changes;
        for (const std::vector<double>& set : sets) {
            std::vector<Change>& change = changes.emplace_back();
            for (std::size_t i = 0; i < set.size(); ++i) change.emplace_back(names[i].first, set[i]);
        }
        return seconds(changes, corner);
    });
}

void Recorded::compare_runs(Calibration& c, const std::vector<double>& before, const std::vector<double>& fitted) {
    double squares_before = 0, squares_after = 0;
    for (std::size_t k = 0; k < parts_.size(); ++k) {
        FittedRun& run = parts_[k].fitted;
        run.before = before[k];
        run.after = fitted[k];
        squares_before += std::pow(run.before / run.measured - 1, 2);
        squares_after += std::pow(run.after / run.measured - 1, 2);
        c.runs.push_back(run);
    }
    c.residual_before = std::sqrt(squares_before / static_cast<double>(parts_.size()));
    c.residual_after = std::sqrt(squares_after / static_cast<double>(parts_.size()));
}

Calibration Recorded::calibrate() {
    Calibration c;
    const times::Dynamics as_it_is = dynamics_of(*programs_.front());
    const auto is_assumed = [&](const std::string& name) {
        return std::any_of(as_it_is.values.begin(), as_it_is.values.end(),
                           [&](const times::Value& v) { return v.name == name && v.assumed; });
    };
    const bool corner_is_open = is_assumed("motion.corner");
    c.lag_is_open = as_it_is.servo_gain == 0 && is_assumed("motion.servo_gain");
    std::vector<times::CornerMode> modes{as_it_is.corner};
    if (corner_is_open) modes = {times::CornerMode::filter, times::CornerMode::blend, times::CornerMode::exact_stop};
    const std::vector<double> before = seconds({{}}, as_it_is.corner).front();
    constexpr double clearly = 4;  // two standard deviations
    times::Fitted best;
    Unknowns names;
    double other_corner = INFINITY;
    for (const times::CornerMode mode : modes) {
        bool lags = false;
        Unknowns of = unknowns(false);
        times::Fitted fitted = fit(of, mode);
        if (c.lag_is_open) {
            Unknowns with_lag = unknowns(true);
            times::Fitted other = fit(with_lag, mode);
            if ((lags = other.misfit + clearly < fitted.misfit)) fitted = std::move(other), of = std::move(with_lag);
        }
        const bool better = mode == modes.front() || fitted.misfit < best.misfit;
        if (mode != modes.front()) other_corner = std::min(other_corner, better ? best.misfit : fitted.misfit);
        if (!better) continue;
        best = std::move(fitted), names = std::move(of), c.lags = lags;
        if (corner_is_open) c.corner = times::corner_names[static_cast<std::size_t>(mode)];
    }
    c.corner_is_seen = corner_is_open && other_corner - best.misfit > clearly;
    c.singular = best.singular;
    compare_runs(c, before, best.predicted);
    for (std::size_t i = 0; i < names.size(); ++i)
        c.values.push_back(
            {names[i].first, names[i].second.value, best.values[i].value, best.values[i].spread, best.values[i].sight});
    if (shown_rapid(as_it_is) > 1)
        for (FittedValue& v : c.values)
            if (v.name == all_rapids) v.before = 1, v.sight = times::Sight::seen;
    for (const FittedRun& run : c.runs)
        for (std::size_t i = 0; run.trace && i < 3; ++i)
            if (const double shown = run.trace->speed[i] * 60; shown > as_it_is.axes[i].speed * 60 * 1.01)
                c.exceeded.emplace_back("axis." + std::string(1, "XYZ"[i]) + ".rapid", shown);
    return c;
}

}  // namespace obrys::driver
