#pragma once
/// What a program's time was spent on. Seconds; what nobody knows is counted apart, never as 0.

#include <string>
#include <vector>

#include "base/source.hpp"
#include "sim/time/dynamics.hpp"
#include "sim/time/speed_curve.hpp"
#include "sim/time/times.hpp"
#include "sim/time/tolerance_use.hpp"

namespace obrys::report::time {

/// A program, and what another value of a machine would make of it.
struct Variant {
    std::string name;  ///< "tolerance = 0.05"; empty: the program as it is
    sim::time::Times times;
};

/// What another contour tolerance in the program's own place would make of its time.
struct Advised {
    double tolerance = 0, seconds = 0;
};

struct Subject {
    std::string name, control, machine;
    std::string not_whole;          ///< why it is not all of the program; empty: it is
    std::vector<Variant> variants;  ///< the first as the program is
    std::vector<sim::time::Value> values;
    std::vector<sim::time::ToleranceUse> tolerances;  ///< as the program is
    std::vector<Advised> advised;                     ///< where that was asked for
};

/// Seconds between which the time lies if each assumed value is between half and twice of it (jerk: a quarter and four
/// times), and axes that are assumed not to lag do or do not.
struct Range {
    double low = 0, high = 0;
};
[[nodiscard]] Range range_of(const sim::time::Times& times, const std::vector<sim::time::Value>& values);

struct Options {
    std::size_t lines = 10;  ///< of the slowest ones
};
[[nodiscard]] std::string as_text(const Subject& subject, const base::Sources& sources, const Options& options);
/// Speed over time, time over the way, the ten slowest lines.
[[nodiscard]] std::string as_svg(const Subject& subject, const sim::time::SpeedCurve& curve,
                                 const base::Sources& sources);
[[nodiscard]] std::string as_json(const Subject& subject, const base::Sources& sources);

}  // namespace obrys::report::time
