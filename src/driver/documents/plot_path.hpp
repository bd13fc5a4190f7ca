#pragma once
/// Collects a stream for the picture of its path and, where a basic length unit is given, for the table of an
/// interpolator's deviations. Memory is bounded by `keep_moves`.

#include "base/function_ref.hpp"
#include "cl/record.hpp"
#include "motion/cursor.hpp"
#include "report/path_plot.hpp"

namespace obrys::driver {

struct PlotOptions {
    report::PlotPlane plane = report::PlotPlane::zx;
    double unit = 0;                         ///< basic length unit, mm; 0: the path only
    std::size_t keep_moves = 20'000;         ///< in the picture
    std::uint64_t most_steps = 200'000'000;  ///< of the whole run; moves behind it are not computed
};

class PathPlotter {
public:
    using Rows = base::FunctionRef<void(const report::InterpolatedMove&)>;
    /// `rows` is told every feed move's figures as they come.
    PathPlotter(const PlotOptions& options, Rows rows);

    void operator()(const cl::Record& record);
    /// Whether the moves that follow are in the picture; they are, until somebody says otherwise.
    void show(bool shown) { shown_ = shown; }
    /// Program, control and machine are left for the caller to name.
    [[nodiscard]] report::PathPlot finish();

private:
    void programmed(const cl::Programmed& element);
    bool draw(const motion::Step& step);
    void interpolate(const motion::Step& step, report::PlotMove* drawn);
    void look_closer();

    PlotOptions options_;
    Rows rows_;
    bool shown_ = true;
    motion::Cursor cursor_;
    report::PathPlot plot_;
    report::Interpolation sums_;
    std::uint64_t steps_run_ = 0;  ///< also of moves that were not run to their end
    geom::PathElement worst_;
    geom::Vec3 worst_shift_;
};

}  // namespace obrys::driver
