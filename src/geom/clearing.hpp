#pragma once
/// Clearing a region with a round tool: nested equidistant rings that leave no ridge between them, and one continuous
/// path along them. Millimetres; islands are the region's holes.

#include <cstdint>
#include <string_view>
#include <vector>

#include "geom/region.hpp"

namespace obrys::geom {

struct ClearingOptions {
    double radius = 0;          ///< of the tool, > 0
    double allowance = 0;       ///< left standing at the contour; may be negative, radius + allowance >= 0
    double stepover = 0;        ///< from ring to ring, > 0; larger than the radius is allowed
    double rounding = 0;        ///< inner corners of the rings get at least this radius, >= 0
    std::size_t most = 20'000;  ///< rings
};

enum class ClearingFault : std::uint8_t {
    none,
    bad_input,  ///< a number that is not finite or out of its range
    no_room,    ///< the tool fits nowhere
    too_many,   ///< more rings than asked for
};

/// A closed run of the tool's centre with the room to be cleared on its left; one vertex: the tool goes to that point
/// only.
struct Ring {
    Contour path;
    std::uint32_t level = 0;  ///< 0 next to the contour
    bool added = false;       ///< covers what rings further apart than the tool is wide would leave standing
};
/// A straight way between two rings on which the tool is never nearer to the contour than on ring 0.
struct RingLink {
    std::size_t a = 0, b = 0;  ///< rings
    Vec2 at_a, at_b;
};

/// Level k is the region inset by radius + allowance + k * stepover. What a level and the next one leave is known
/// exactly: the points deeper than the radius in level k that are further than the radius from level k + 1, a radius
/// less a fiftieth, so that passes overlap; the boundary of that set is added as rings, and of what these leave, until
/// nothing is left (wider than 1e-6 mm). So every point that a tool inside ring 0 can reach is covered. Rings of one
/// connected part of level 0 are connected by links, without circles.
struct Clearing {
    ClearingFault fault = ClearingFault::none;
    std::vector<Ring> rings;  ///< by level
    std::vector<RingLink> links;
    /// Where the tool's centre may be: level 0 as a region.
    Region room;
};

[[nodiscard]] Clearing clearing_rings(const Region& r, const ClearingOptions& o);

/// One open chain for each connected part: from its innermost ring along all rings and links to the outermost one,
/// which is run along last; other branches on the way are run to their end and back. `reverse`: rings run the other way
/// round (the room on the right).
[[nodiscard]] std::vector<Contour> clearing_tours(const Clearing& c, bool reverse = false);

}  // namespace obrys::geom
