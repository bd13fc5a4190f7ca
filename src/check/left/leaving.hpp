#pragma once
/// A convex body that leaves a place which it has taken before, straight: it touches its own cut all over, and no cell
/// of the body as a whole is far enough from that. What it reaches anew is what its faces that look ahead come through,
/// and only that is searched here. Millimetres.

#include <span>
#include <vector>

#include "check/left/search.hpp"
#include "check/left/stock_planes.hpp"

namespace obrys::check {

/// Of a body along `edges[0]` that has taken all it holds at `corner`: whether nothing it comes through from there is
/// deeper than allowed in what is left. False: it is, or was not shown.
[[nodiscard]] bool leaves_clear(const LeftBody& body, const LeftSearch& search);

}  // namespace obrys::check
