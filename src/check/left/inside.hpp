#pragma once
/// How deep anything that is left of a stock stands in a body that goes straight, however thin it is: a fin between
/// two slots as high as it stands in the tool, not half as deep as it is thick. Millimetres.
///
/// Depth in a convex body is concave, so the deepest place of a convex cell comes out of a linear program that gets
/// planes of the body until they hold there. Where that place is taken by a cut, a box within the cut is taken out of
/// the cell: what lies beyond its faces are cells, too. Contact takes no small cells: what touches has no depth.

#include "check/left/search.hpp"
#include "check/left/stock_planes.hpp"

namespace obrys::check {

struct InsideSearch {
    const sim::milling::Stock& stock;
    const StockPlanes& planes;
    const sim::milling::Air& air;
    const std::vector<LeftCut>& cuts;
    double allowed = 0;          ///< no deeper is clear
    double enough = 0;           ///< deeper is not asked for
    double thin = 0;             ///< mm: what is thinner than twice that is not looked for
    std::size_t most_cells = 0;  ///< looked at
};

/// Of a body that goes along `edges[0]`.
[[nodiscard]] LeftDepth deepest_inside(const LeftBody& body, const InsideSearch& search);

}  // namespace obrys::check
