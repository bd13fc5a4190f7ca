#pragma once
/// From a cycle's expansion to the stream. Private to interp.

#include "cycles/cycle.hpp"
#include "interp/moves/moves.hpp"

namespace obrys::interp {

/// What holds when a cycle is called.
[[nodiscard]] cycles::Situation situation_of(const Reckoning&);
/// Says what is wrong with a cycle's call; false where that ends the run.
[[nodiscard]] bool report_expansion(Reckoning&, std::string_view name, const cycles::Expansion&);
/// A step of a cycle, from the working plane's coordinates into the stream.
void emit_step(Telling&, cl::Step step);
/// As above, but through radius compensation where it is on: cycles whose moves are the contour itself.
void path_step(Moving&, cl::Step step);
void emit_steps(Telling&, std::vector<cl::Step>&);
/// The steps of one hole in their bracket; `told`: what the stream says of it.
void emit_hole(Telling&, std::string_view name, const cycles::Demand& told, cycles::Expansion&, const WayOfCall&);
/// (u, v, w) of the working plane, as cycles have it.
[[nodiscard]] geom::Vec3 into_plane(const geom::Vec3& p, const PlaneAxes& a);
[[nodiscard]] geom::Vec3 out_of_plane(const geom::Vec3& p, const PlaneAxes& a);

}  // namespace obrys::interp
