#pragma once
/// What of a part stands out of the stock: no cut can make it. Millimetres.

#include <optional>

#include "mesh/distance.hpp"
#include "sim/certify/certify.hpp"

namespace obrys::check {

struct StockLack {
    double depth;   ///< how far the part stands out of the stock
    geom::Vec3 at;  ///< there
};

/// The farthest place of the part's surface outside of the stock, if it is more than allowed. Exact for a convex stock;
/// of another one within a tenth, as far as some ten thousand places tell.
[[nodiscard]] std::optional<StockLack> lack_of(const mesh::Distance& part, const sim::certify::Before& stock,
                                               double allowed);

}  // namespace obrys::check
