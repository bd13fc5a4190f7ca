#pragma once
/// What a program's time was spent on. Seconds; what nobody knows is counted apart, never as 0.

#include <string>
#include <vector>

#include "base/source.hpp"
#include "sim/time/dynamics.hpp"
#include "sim/time/times.hpp"

namespace obrys::report::time {

/// A program, and what another value of a machine would make of it.
struct Variant {
    std::string name;  ///< "tolerance = 0.05"; empty: the program as it is
    sim::time::Times times;
};

struct Subject {
    std::string name, control, machine;
    std::string not_whole;          ///< why it is not all of the program; empty: it is
    std::vector<Variant> variants;  ///< the first as the program is
    std::vector<sim::time::Assumed> assumed;
    bool any_assumed_dynamics = true;
};

/// Seconds between which the time lies if what was assumed of the axes is between half and twice of it.
struct Range {
    double low = 0, high = 0;
};
[[nodiscard]] Range range_of(const Subject& subject);

struct Options {
    std::size_t lines = 10;  ///< of the slowest ones
};
[[nodiscard]] std::string as_text(const Subject& subject, const base::Sources& sources, const Options& options);
[[nodiscard]] std::string as_json(const Subject& subject, const base::Sources& sources);

}  // namespace obrys::report::time
