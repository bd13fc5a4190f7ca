#pragma once
/// Contours of turning cycles that are blocks of the program itself. Private to interp.

#include <optional>
#include <vector>

#include "cycles/turn/turning.hpp"
#include "interp/cycles/cycles.hpp"

namespace obrys::interp {

/// The statements of a contour, whole blocks.
struct ContourBlocks {
    std::uint32_t first = 0, last = 0;
    bool names_both_axes = false;  ///< its first block names both axes of the plane
};
/// The blocks that a cycle names; nothing after a complaint. `self`: the statement of the cycle.
[[nodiscard]] std::optional<ContourBlocks> find_contour(Reckoning&, const program::CycleDefinition&,
                                                        std::uint32_t self);

/// What they make, with chamfers and roundings.
struct TurnedContour {
    std::vector<cycles::TurningElement> elements;
    std::vector<base::Span> places;  ///< of each element
    bool compensated = false;        ///< somewhere radius compensation is in force
};
/// Nothing after a complaint.
[[nodiscard]] std::optional<TurnedContour> turned_contour(Moving&, const program::CycleDefinition&,
                                                          const ContourBlocks&);

}  // namespace obrys::interp
