#pragma once
/// What the canned cycles of one hole (RS-274, Fanuc, Haas: G73, G74, G76, G81 … G89) have in common.
///
/// They begin where the tool stands (Situation::at, which may be unknown) and make the moves to the hole themselves:
///   rise_first 1 (LinuxCNC): a tool below the retract plane rises to it first; 2: not so, further holes of a series;
///   with either the move in the plane ends at the height where the cycle ends, if that is higher;
///   in the plane to (target_u, target_v), at the height where the tool is; written also where it is there already;
///   along the tool axis to the retract plane, unless it stands there.
/// Then what the kind says, at the feed in force: no Feed is written. They end over the hole at
/// return_level, which may lie below the retract plane; not written (G99): at the retract plane.
///
/// Roles of all kinds: target_u, target_v (neither is written: where the tool stands, without a move), retract_plane
/// and bottom (needed; the first not below the second), return_level, rise_first. A dwell role that is written gives a
/// Dwell, also of 0 s. Sources: LinuxCNC 2.9, G code chapter, and what its stand-alone interpreter prints. Fanuc
/// 15i/150i-MA operator's manual (shift of G76), Rockwell 9/Series mill manual, milling fixed cycles (G87 of the Fanuc
/// kind), Haas VF manual (G77); the other sequences of Fanuc and Haas are from memory of their operator's manuals, not
/// found again in the sources at hand.

#include "cycles/hole/between_planes.hpp"

namespace obrys::cycles {

struct Hole {
    geom::Vec2 target;
    bool called_here = false;                 ///< the tool stands over it
    double retract = 0, bottom = 0, end = 0;  ///< w
    bool rise_first = false, risen = false;
};
[[nodiscard]] Hole hole_of(Course& course, const HolePlanes& cycle, const Situation& situation);
/// Where the hole is, of a cycle that says its place itself.
[[nodiscard]] geom::Vec2 target_of(Course& course, const Said& u, const Said& v, const Situation& situation);

/// Where infeeds count from: the surface, not written: the retract plane.
[[nodiscard]] double top_of(Course& course, const HolePlanes& cycle);

/// From where the tool stands to the retract plane above the hole.
void approach(Course& course, const Hole& hole);
void feed_w(Course& course, double w);
void rapid_to_w(Course& course, double w);
/// A dwell that is said, also of 0 s.
void dwell_if(Course& course, const Said& seconds);

/// The way out at feed: to the retract plane and on at rapid, or to the end where feed_out is 1.
void feed_out(Course& course, const Hole& hole, bool whole_way);

/// How the spindle turns when the cycle begins and after it.
struct Turning {
    double speed = 0;
    int direction = 0;  ///< +1 M3, -1 M4
};
/// As said, else as in force; a standing spindle is then a complaint.
[[nodiscard]] Turning turning_of(Course& course, const Said& speed, const Said& direction, const Situation& situation);
void stop_spindle(Course& course, const Turning& turning);
void start_spindle(Course& course, const Turning& turning);
/// Before the tool goes in: where the cycle starts the spindle, and it does not turn so.
void begin_turning(Course& course, const Said& starts_spindle, const Situation& situation, const Turning& turning);
/// As said; not said: as before.
void end_turning(Course& course, const Said& spindle_after, const Turning& turning);
/// A feed that is said, mm/min, from here on.
void feed_of(Course& course, const Said& feed);

}  // namespace obrys::cycles
