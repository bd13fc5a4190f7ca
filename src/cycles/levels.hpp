#pragma once
/// Infeeds of a hole: where each of them ends, and the motion of deep-hole pecking.

#include <vector>

#include "cycles/course.hpp"

namespace obrys::cycles {

inline constexpr double same_depth = 1e-9;  ///< mm
/// Feed of the small retract of a chip break, mm/min: fixed by the control (from memory of the cycle manual's parameter
/// Q256; not found again in the sources at hand). It has no effect on the path.
inline constexpr double chip_break_feed = 3000;

/// Infeeds that may become smaller with every step, down to a least one.
struct Infeeds {
    double first = 0, decrement = 0, least = 0;
    [[nodiscard]] double of(int step) const;
};

/// The depths at which the infeeds end, from `top` down to `bottom`, which is the last. Empty after a complaint.
[[nodiscard]] std::vector<double> levels_of(Course& course, double top, double bottom, const Infeeds& infeeds);

/// Far too many chip breaks, one at every such depth over a hole (both positive; 0 for none), are a complaint.
void check_breaks(Course& course, double every, double hole);

/// Deep-hole pecking: full retract after every infeed, chip breaks within it, advanced stop distances.
struct Pecking {
    double top = 0;                        ///< absolute; where the first infeed begins
    double retract_to = 0;                 ///< absolute
    double first_stop = 0, last_stop = 0;  ///< above the depth reached before; between them in equal steps
    double break_every = 0;                ///< 0: no chip break
    double break_distance = 0;
    double feed = 0;
};
/// From above the hole down to the last level, where the tool stays.
void peck_down(Course& course, const std::vector<double>& levels, const Pecking& pecking);

}  // namespace obrys::cycles
