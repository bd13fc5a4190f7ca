#pragma once
/// The loop between two places of a contour that the tool touches at once: from the first along the contour to the
/// second and back through the tool's centre. Inside of compensation.hpp; not for callers.

#include <vector>

#include "path/compensation/join.hpp"

namespace obrys::path {

/// Items in contour order, transitions among them or not; touched: the first and the last.
using Chain = std::vector<const Item*>;

/// True where the loop runs round ground on the tool's side of the contour: a corner, slot or chamber that the tool
/// does not get into, which a path may pass over. Otherwise it runs round what the contour goes about, as at both ends
/// of a ring with a gap, or where a contour runs on past its own start.
[[nodiscard]] bool is_pocket(const Chain& chain, geom::Vec2 centre);
/// True where contour elements of the chain that are not neighbours have a point in common.
[[nodiscard]] bool meets_itself(const Chain& chain);
/// Nearest point of an element.
[[nodiscard]] geom::Vec2 nearest_point(const Element& e, geom::Vec2 p);

}  // namespace obrys::path
