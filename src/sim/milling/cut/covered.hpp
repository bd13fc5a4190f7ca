#pragma once
/// Levels: the same tool on the same way, deeper. What the deeper one takes holds all that the one above took.

#include <cstdint>
#include <span>
#include <vector>

#include "sim/milling/cut/simulation.hpp"

namespace obrys::sim::milling {

/// Of each body 1 where another one of them holds it: a tool that does not become narrower upwards and reaches out of
/// the stock, moved down along its axis. Pockets by levels, helices of many turns. Of the others 0.
[[nodiscard]] std::vector<std::uint8_t> covered(const Simulation& simulation,
                                                std::span<const Simulation::Whole> wholes);

}  // namespace obrys::sim::milling
