#pragma once
/// The rings of a tool's edges that a move engages, and over which angles.

#include <vector>

#include "check/result.hpp"
#include "shop/tool.hpp"
#include "sim/force/milling.hpp"
#include "sim/milling/shape.hpp"

namespace obrys::check::force {

/// A tool's cutting shape and what it is turned by; to be made once a tool.
struct Edges {
    sim::milling::Shape shape;
    double helix = 0;  ///< radians
};
[[nodiscard]] Edges edges_of(const shop::Tool& tool, double helix);

/// Where beside the way the tool was in material: from the right to the left of it, mm, and how much of each mm of way
/// was removed.
struct Met {
    double low = 0, high = 0;    ///< heights above the tip
    double right = 0, left = 0;  ///< of the largest radius up to there at most
    double section = NAN;        ///< mm2 across the way; NaN: not known
    bool all_round = false;      ///< straight along the axis
    sim::force::Feed way;        ///< unit vector
};

struct Engaged {
    std::vector<sim::force::Ring> rings;
    /// Part of what the rings would remove that really was there: the extents of a move are the widest on its way.
    double share = 1;
};

/// A cut that reaches one side of the tool is as wide at each height as makes the section; another one is as wide as it
/// was met, and is there for a part of the time.
[[nodiscard]] Engaged engaged(const Edges& edges, const Met& met);

}  // namespace obrys::check::force
