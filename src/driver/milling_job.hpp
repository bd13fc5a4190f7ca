#pragma once
/// What a milling job is held to, from its files: stock, part and clamps as bodies of the simulation.

#include <optional>

#include "check/result.hpp"
#include "check/setup.hpp"
#include "driver/session.hpp"

namespace obrys::driver {

/// What the command line says of milling.
struct MillingRequest {
    std::optional<double> tolerance;     ///< mm; not said: as the job says, else 0.01
    bool surface = false;                ///< the surface is wanted for a file or picture
    std::optional<std::uint64_t> at;     ///< the move after which it is wanted; not said: the last
    std::size_t keep_moves = 0;          ///< whose way is kept for the page
    std::optional<double> memory_bytes;  ///< that the stock may take; not said: half of what the machine has
};

/// Nothing where the job has no milling stock, or none that can be used (a complaint says so).
[[nodiscard]] std::optional<check::MillingSetup> milling_setup(Session& session, const MillingRequest& request);

}  // namespace obrys::driver
