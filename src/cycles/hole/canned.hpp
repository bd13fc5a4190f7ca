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

#include "cycles/course.hpp"

namespace obrys::cycles {

struct Hole {
    geom::Vec2 target;
    bool called_here = false;                 ///< the tool stands over it
    double retract = 0, bottom = 0, end = 0;  ///< w
    bool rise_first = false, risen = false;
};
[[nodiscard]] Hole read_hole(Course& course, const Situation& situation);
/// As above without the retract plane's part: back boring, where it may be missing.
[[nodiscard]] geom::Vec2 read_target(Course& course, const Situation& situation);

/// Where infeeds count from: the surface, not written: the retract plane.
[[nodiscard]] double top_of(Course& course, const Hole& hole);

/// From where the tool stands to the retract plane above the hole.
void approach(Course& course, const Hole& hole);
void feed_w(Course& course, double w);
void rapid_to_w(Course& course, double w);
/// The dwell of a role that is written; its value was read with maybe_at_least.
void dwell_if(Course& course, const Demand& demand, cl::CycleRole role);

/// The way out at feed: to the retract plane and on at rapid, or to the end where feed_out is 1.
void feed_out(Course& course, const Hole& hole, bool whole_way);

/// How the spindle turns when the cycle begins and after it.
struct Turning {
    double speed = 0;
    int direction = 0;  ///< +1 M3, -1 M4
};
/// spindle_speed, else the one in force. spindle_direction (+1, -1), else the direction in which it turns already; a
/// standing spindle is then a complaint.
[[nodiscard]] Turning read_turning(Course& course, const Situation& situation);
void stop_spindle(Course& course, const Turning& turning);
void start_spindle(Course& course, const Turning& turning);
/// Before the tool goes in: where starts_spindle asks for it, and the spindle does not turn so.
void begin_turning(Course& course, const Demand& demand, const Situation& situation, const Turning& turning);
/// As spindle_after says; not written: as before.
void end_turning(Course& course, const Demand& demand, const Turning& turning);
/// What a role says in mm/min from here on; nothing where it is not written.
void feed_of(Course& course, const Demand& demand, cl::CycleRole role);

void canned_tap(Course& course, const Demand& demand, const Situation& situation);
void canned_deep(Course& course, const Demand& demand, const Situation& situation);
void canned_bore(Course& course, const Demand& demand, const Situation& situation);

}  // namespace obrys::cycles
