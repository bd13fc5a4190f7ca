#pragma once
/// How the short lines of a program lie beside the tolerance that is in force: from the program's own points.

#include <array>
#include <cstdint>
#include <vector>

#include "base/source.hpp"

namespace obrys::sim::time {

/// Places between lines that follow a curve (they turn little), as far as one tolerance was in force.
struct ToleranceUse {
    double tolerance = 0;
    bool by_program = false;    ///< else the machine's
    base::Span first{};         ///< the first move under it
    std::uint64_t places = 0;   ///< between short lines
    std::uint64_t coarse = 0;   ///< of them, those whose chord error is above the tolerance: braked for as corners
    std::uint64_t corners = 0;  ///< sharper turns
    /// Chord errors: how many lie in each half of a doubling, from 2^-20 mm on.
    std::array<std::uint32_t, 64> errors{};

    void take(double chord_error);
    /// mm that so much of the chord errors stay below (share 0 … 1), by the end of its class.
    [[nodiscard]] double error_of(double share) const;
};

}  // namespace obrys::sim::time
