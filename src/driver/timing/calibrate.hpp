#pragma once
/// A machine's values from recorded runs of programs on it.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "driver/timing/runs_file.hpp"
#include "driver/timing/time_program.hpp"
#include "sim/time/fit.hpp"

namespace obrys::driver {

/// A line of the table beside what the machine makes of it.
struct FittedRun {
    Run run;
    double measured = 0, before = 0, after = 0;  ///< s; by the machine as it is, and as it is fitted
    std::string not_whole;                       ///< why the program is not timed fully; empty: it is
    std::optional<Trace> trace;
};

struct FittedValue {
    std::string name;  ///< as in machine files; "axis.rapid": of X, Y and Z together; "feed_override"
    double before = 0, after = 0;
    double spread = 0;  ///< of the logarithm
    sim::time::Sight sight = sim::time::Sight::not_seen;
};

struct Calibration {
    std::vector<FittedRun> runs;
    std::vector<FittedValue> values;
    std::vector<double> singular;
    std::string corner;           ///< how corners are passed, where the machine file does not say it; empty: it does
    bool corner_is_seen = false;  ///< the other ways fit clearly worse
    bool lag_is_open = false;     ///< the machine file does not say whether axes lag at stops
    bool lags = false;            ///< that they do fits clearly better
    double residual_before = 0, residual_after = 0;        ///< root of the mean square, of the measured seconds
    std::vector<std::pair<std::string, double>> exceeded;  ///< by a trace: "axis.X.rapid" and what it shows
};

/// The programs of the runs, each once.
class Recorded {
public:
    /// Opens the programs, which are named from the table's folder; `request` says machine, control and folders.
    /// False, with complaints in `diagnostics`, where one cannot be used.
    bool open(const Request& request, std::uint32_t table, std::vector<Run> runs, base::Sources& sources,
              base::Diagnostics& diagnostics);

    [[nodiscard]] Calibration calibrate();
    [[nodiscard]] const std::vector<std::shared_ptr<Session>>& programs() const { return programs_; }

private:
    struct Part {
        FittedRun fitted;
        std::size_t program = 0;
        double events = -1;  ///< s by the machine as it is, of tool changes and the like; below 0: not looked at
    };
    using Change = std::pair<std::string, double>;
    /// Seconds of each run, for each set of changes to the machine.
    [[nodiscard]] std::vector<std::vector<double>> seconds(const std::vector<std::vector<Change>>& sets,
                                                           sim::time::CornerMode corner);
    using Unknowns = std::vector<std::pair<std::string, sim::time::Unknown>>;
    [[nodiscard]] Unknowns unknowns(bool lags) const;
    /// By how much a trace goes beyond the rapids of the machine file; 1: none does.
    [[nodiscard]] double shown_rapid(const sim::time::Dynamics& d) const;
    [[nodiscard]] sim::time::Fitted fit(const Unknowns& names, sim::time::CornerMode corner);
    [[nodiscard]] std::vector<sim::time::Measured> measured() const;
    void compare_runs(Calibration& c, const std::vector<double>& before, const std::vector<double>& fitted);

    std::vector<std::shared_ptr<Session>> programs_;
    std::vector<Part> parts_;
};

}  // namespace obrys::driver
