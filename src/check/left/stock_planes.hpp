#pragma once
/// A stock as planes, where it is convex: what linear programs know of it. Millimetres.

#include <vector>

#include "geom/vec.hpp"
#include "sim/milling/stock.hpp"

namespace obrys::check {

/// Flat faces of a stock, as far as all of it lies behind them.
struct StockPlane {
    geom::Vec3 out;  ///< unit length
    double at = 0;   ///< dot(out, p) <= at
};
struct StockPlanes {
    std::vector<StockPlane> planes;
    bool whole = false;  ///< there is nothing else to it, but for a cylinder's side
};
[[nodiscard]] StockPlanes planes_of(const sim::milling::Stock& stock);

}  // namespace obrys::check
