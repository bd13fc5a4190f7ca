#include "check/turning/beside.hpp"

#include <algorithm>
#include <cmath>

namespace obrys::check {

namespace {

/// How far a place lies beyond the stock's ends.
double beyond_in_z(double z, const Box& stock) { return std::max({z - stock.max_z, stock.min_z - z, 0.0}); }

}  // namespace

bool beside_in_x(double a, double b, const Box& tool, const Box& stock) {
    if (!std::isfinite(a) || !std::isfinite(b)) return false;
    const double low = std::min(a, b) + tool.min_x, high = std::max(a, b) + tool.max_x;
    const double nearest = low >= 0 ? low : high <= 0 ? -high : 0;
    return nearest >= stock.max_x || std::max(-low, high) <= stock.min_x;
}

bool leads_away(const Move& move, const Box& stock) {
    constexpr double same = 1e-6, clear = 10;  // mm
    const geom::Vec3 from = move.from, to = move.to;
    const bool home_x = std::isnan(to.x), home_z = std::isnan(to.z);
    if (!move.rapid || (std::isnan(from.x) && !home_x) || (std::isnan(from.z) && !home_z)) return false;
    const double before = beyond_in_z(from.z, stock), behind = beyond_in_z(to.z, stock);
    if ((!home_x && std::abs(to.x) < std::abs(from.x) - same) || (!home_z && behind < before - same)) return false;
    if (home_x || home_z || std::abs(to.z - from.z) <= same) return true;
    const bool passes =
        (from.z >= stock.max_z && to.z <= stock.min_z) || (from.z <= stock.min_z && to.z >= stock.max_z);
    if (behind > 0 && !passes) return true;
    return std::abs(to.x) >= stock.max_x + clear && (!passes || std::abs(from.x) >= stock.max_x + clear);
}

bool beside_in_z(double a, double b, const Box& tool, const Box& stock) {
    return (a + tool.min_z >= stock.max_z && b + tool.min_z >= stock.max_z) ||
           (a + tool.max_z <= stock.min_z && b + tool.max_z <= stock.min_z);
}

}  // namespace obrys::check
