#pragma once
/// WayOfCall a cycle: what its definition, the call and the place of the call put together. Private to interp.

#include <vector>

#include "cycles/cycle.hpp"
#include "interp/motion.hpp"

namespace obrys::interp {

using CycleValues = std::vector<cl::CycleValue>;

/// How a cycle is called, as the stream tells it.
struct WayOfCall {
    cl::CycleCall call = cl::CycleCall::single;
    std::uint64_t pass = 1, passes = 1;  ///< of a pattern's points, of the holes of one block
};

/// What the cycle's parameters say now; `instead` comes last and wins.
[[nodiscard]] cycles::Demand demand_of(const Cycling&, const ActiveCycle&, const CycleValues& instead = {});
/// The cycle defined last, where the tool stands.
void call_cycle(Cycling&, const CycleValues& instead, const WayOfCall& calling);
void report(Saying&, const ActiveCycle&, const std::vector<cycles::Complaint>&);
/// Opens the cycle's bracket in the stream: at the place where the tool stands, with what the call says.
void begin_cycle(Cycling&, const ActiveCycle&, const CycleValues& instead = {}, const WayOfCall& calling = {});
/// As above, of a cycle that is no definition; `name` as the control writes it.
void begin_bracket(Telling&, const cycles::Demand&, std::string_view name, const WayOfCall& calling = {},
                   std::vector<cl::CycleParameter> written = {});
/// Closes the bracket that was opened last.
void end_bracket(Telling&);
/// What holds when a cycle is called.
[[nodiscard]] cycles::Situation situation_of(const Reckoning&);
/// Says what is wrong with a cycle's call; false where that ends the run.
[[nodiscard]] bool report_expansion(Reckoning&, std::string_view name, const cycles::Expansion&);
/// A step of a cycle, from the working plane's coordinates into the stream.
void emit_step(Telling&, cl::Step step);
/// As above, but through radius compensation where it is on: cycles whose moves are the contour itself.
void path_step(Moving&, cl::Step step);
void emit_steps(Telling&, std::vector<cl::Step>&);
/// Those of a turning cycle: threads tell that they follow the spindle (turning.cpp).
void emit_turning_steps(Moving&, std::vector<cl::Step>&);
/// (u, v, w) of the working plane, as cycles have it.
[[nodiscard]] geom::Vec3 into_plane(const geom::Vec3& p, const PlaneAxes& a);
[[nodiscard]] geom::Vec3 out_of_plane(const geom::Vec3& p, const PlaneAxes& a);

// Values of a cycle's parameters (cycle_values.cpp).
/// From here on a feed of pre-positioning or retraction is rapid traverse: FMAX, and Q208=99999 of many programs.
inline constexpr double fastest_feed = 99999;
/// `written`: the number of the setting, behind FU and FZ too.
[[nodiscard]] double value_at_definition(Reckoning&, const program::CycleSetting&, double written);
[[nodiscard]] double value_at_call(const Reckoning&, const ActiveCycle&, std::size_t setting);
/// GLOBAL DEF: later cycles refer to its values by PREDEF.
void set_globally(Reckoning&, const program::CycleDefinition&);
/// FAUTO of a tool that was called without a feed, FZ of one without teeth.
void say_unknown_words(Reckoning&, const ActiveCycle&);

/// Cycles 220 and 221: the cycle defined last at every point of theirs (cycle_places.cpp).
void run_point_cycle(Cycling&, const ActiveCycle&);
/// While a cycle is called at a place of its own, the frame's origin lies there: moves it (transform.cpp).
void shift_for_call(Telling&, const geom::Vec3& by);

}  // namespace obrys::interp
