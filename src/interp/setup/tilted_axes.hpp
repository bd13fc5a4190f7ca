#pragma once
/// Rotary axes of a machine that a tilted plane aims. Private to interp.

#include <vector>

#include "interp/stream/stream.hpp"

namespace obrys::interp {

/// Where the rotary axes stand and whether the control counts that in its coordinates.
struct Rotary {
    std::vector<double> values;  ///< radians, by joint of the machine's chain; linear joints 0
    bool counted = false;
};

/// Which of the two positions of the rotary axes a plane takes, and what turns where the coordinates alone could.
struct TiltChoice {
    double side = 0;           ///< SEQ: sign of the master axis; 0: the nearer one in the limits
    bool table_turns = false;  ///< TABLE ROT
    bool later = false;        ///< a word of its own will turn the axes, and chooses then
    bool by_control = false;   ///< the tool stands on the plane, whoever turns the axes
};

// --- tilted_axes.cpp
/// As a control shows it: without the last digits of the computation.
[[nodiscard]] double in_degrees(double angle);
/// A position in the coordinates that `to` counts in, the linear axes standing.
[[nodiscard]] geom::Vec3 counted_as(const Reckoning& run, const geom::Vec3& position, const Rotary& from,
                                    const Rotary& to);
void stand_at(Reckoning& run, const geom::Vec3& position);
[[nodiscard]] Rotary rotary(const Reckoning&);
/// A tilted plane is in force.
[[nodiscard]] bool tilted(const Reckoning&);
/// The control has turned the rotary axes to the plane in force; where they stand is not known (shift.cpp).
void mark_turned_by_control(Reckoning&);
/// Where the rotary axes go for the plane in force; sets the control's own parameters for it.
void aim(Reckoning&, const TiltChoice& choice, const base::Span& where);
/// The rotary axes, or what counts of them, are as they are now and were as in `before`; the linear axes stood: where
/// the tip is in the workpiece frame; NaN where zero, tool length or chain do not say it.
void recount(Reckoning&, const Rotary& before);

}  // namespace obrys::interp
