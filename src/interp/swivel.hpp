#pragma once
/// Rotary axes that a tilted working plane counts. Private to interp.

#include <vector>

#include "interp/special.hpp"

namespace obrys::interp {

/// Where the rotary axes stand and whether the control counts that in its coordinates.
struct Rotary {
    std::vector<double> values;  ///< radians, by joint of the machine's chain; linear joints 0
    bool counted = false;
};
[[nodiscard]] Rotary rotary(const Reckoning&);
/// A tilted plane is in force.
[[nodiscard]] bool tilted(const Reckoning&);

/// Which of the two positions of the rotary axes a plane takes, and what turns where the coordinates alone could.
struct TiltChoice {
    double side = 0;           ///< SEQ: sign of the master axis; 0: the nearer one in the limits
    bool table_turns = false;  ///< TABLE ROT
};
/// Where the rotary axes go for the plane in force; sets the control's own parameters for it.
void aim(Reckoning&, const TiltChoice& choice, const base::Span& where);

/// The rotary axes, or what counts of them, are as they are now and were as in `before`; the linear axes stood: where
/// the tip is in the workpiece frame; NaN where zero, tool length or chain do not say it.
void recount(Reckoning&, const Rotary& before);

/// Tells the stream where the rotary axes stand that the program has moved, whether that counts, and the tool's axis
/// where it is another than before: by a rapid on the spot, since arcs do not say it.
void tell_rotary(Telling&, const geom::Vec3& axis_before);

/// MOVE, TURN: the rotary axes go where `aim` said. `on_workpiece`: where the tip stood before the plane changed.
void swivel(Moving&, bool keeps_tip, const geom::Vec3& on_workpiece, const base::Span& where);
/// The position as seen from the workpiece, whatever counts.
[[nodiscard]] geom::Vec3 on_workpiece(const Reckoning&);
/// The position in the machine's directions, as though no rotary axis counted, and back.
[[nodiscard]] geom::Vec3 along_machine(const Reckoning&);
[[nodiscard]] geom::Vec3 from_along_machine(const Reckoning&, const geom::Vec3& position);

/// A tilted plane comes into force; the identity ends it.
void tilt(Telling&, const geom::Frame& plane, const TiltChoice& choice, const base::Span& where);

}  // namespace obrys::interp
