#pragma once
/// Cycles: from their definition to their steps, at every place. Private to interp.

#include "cycles/cycle.hpp"
#include "interp/calls/calls.hpp"
#include "interp/moves/cycle_steps.hpp"

namespace obrys::interp {

// --- cycle.cpp
void define_cycle(Cycling&, const program::CycleDefinition&);
/// The cycle defined last, where the tool stands.
void call_cycle(Cycling&);
/// What the cycle's parameters say now; `instead` comes last and wins.
[[nodiscard]] cycles::Demand demand_of(const Cycling&, const ActiveCycle&, const CycleValues& instead = {});
/// The cycle defined last, where the tool stands.
void call_cycle(Cycling&, const CycleValues& instead, const WayOfCall& calling);
/// Opens the cycle's bracket in the stream: at the place where the tool stands, with what the call says.
void begin_cycle(Cycling&, const ActiveCycle&, const CycleValues& instead = {}, const WayOfCall& calling = {});

// --- transform.cpp
/// A cycle that acts at its definition; false where obrys does not run it.
[[nodiscard]] bool act_at_definition(Cycling&, const ActiveCycle&);

// --- pattern.cpp
void define_pattern(Cycling&, const program::Pattern&);

// --- cycle_places.cpp
/// CYCL CALL POS: goes to the position of the block and calls the cycle there.
void call_cycle_at_position(Cycling&);
/// CYCL CALL PAT: calls the cycle at every point of the pattern.
void call_cycle_at_pattern(Cycling&);
/// Cycles 220 and 221: the cycle defined last at every point of theirs (cycle_places.cpp).
void run_point_cycle(Cycling&, const ActiveCycle&);

// --- contour_formula.cpp
void contour_statement(Cycling&, const program::ContourStatement&);

// --- canned.cpp
/// False where the block's words call no cycle.
[[nodiscard]] bool canned_motion(Cycling&);

// --- circle_pocket.cpp
/// G12, G13 (circle_pocket.cpp).
[[nodiscard]] bool circle_pocket(Moving&);

// --- turning.cpp
/// G70 … G72, G76 of lathes (turning.cpp).
[[nodiscard]] bool turning_cycle(Moving&);
/// Those of a turning cycle: threads tell that they follow the spindle (turning.cpp).
void emit_turning_steps(Moving&, std::vector<cl::Step>&);

// --- turning_definition.cpp
/// A turning cycle that acts at its definition (turning_definition.cpp).
void define_turning_cycle(Cycling&, const ActiveCycle&);
/// The contour of a finishing cycle has been run: back to where the cycle began.
void end_finishing(Moving&, const ActiveSection&);

// --- cycle_reports.cpp
void report(Saying& run, const ActiveCycle& c, const cycles::Expansion& e);
void report(Saying&, const ActiveCycle&, const std::vector<cycles::Complaint>&);
/// From here on a feed of pre-positioning or retraction is rapid traverse: FMAX, and Q208=99999 of many programs.
inline constexpr double fastest_feed = 99999;

// --- cycle_values.cpp
/// `written`: the number of the setting, behind FU and FZ too.
[[nodiscard]] double value_at_definition(Reckoning&, const program::CycleSetting&, double written);
[[nodiscard]] double value_at_call(const Reckoning&, const ActiveCycle&, std::size_t setting);
/// GLOBAL DEF: later cycles refer to its values by PREDEF.
void set_globally(Reckoning&, const program::CycleDefinition&);
/// FAUTO of a tool that was called without a feed, FZ of one without teeth.
void say_unknown_words(Reckoning&, const ActiveCycle&);

}  // namespace obrys::interp
