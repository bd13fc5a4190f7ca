#pragma once
/// What the machine's spindle and the tool's list say against forces and feeds.

#include <string>
#include <vector>

#include "check/force/milled.hpp"

namespace obrys::check::force {

/// The worst of a line.
struct ForceFinding {
    std::string_view code;
    std::string text;
    double value = 0, limit = 0;
    std::size_t move = 0;     ///< index in Milled::moves
    std::uint64_t moves = 1;  ///< of the line that have it
};

[[nodiscard]] std::vector<ForceFinding> findings_of(const ForceResult& forces, const Result& result, const Setup& setup,
                                                    const shop::CuttingJob& job);

}  // namespace obrys::check::force
