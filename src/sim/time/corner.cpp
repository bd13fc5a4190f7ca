#include "sim/time/corner.hpp"

#include <algorithm>
#include <cmath>

namespace obrys::sim::time {
namespace {

CornerSpeed least(double highest, double by_acceleration, double by_jerk) {
    if (highest <= by_acceleration && highest <= by_jerk) return {highest, CornerLimit::none};
    return by_acceleration < by_jerk ? CornerSpeed{by_acceleration, CornerLimit::acceleration}
                                     : CornerSpeed{by_jerk, CornerLimit::jerk};
}

}  // namespace

CornerSpeed filtered_corner(double turn, double tolerance, double highest, const Limits& l) {
    const double s = std::sin(turn / 2);
    if (!(s > 0)) return {highest, CornerLimit::none};
    return least(highest, std::sqrt(1.5 * l.acceleration * tolerance) / s,
                 std::cbrt(4.5 * l.jerk * tolerance * tolerance) / s);
}

CornerSpeed blended_corner(double turn, double tolerance, double shorter, double highest, const Limits& l) {
    if (!(turn > 0)) return {highest, CornerLimit::none};
    const double c = std::cos(turn / 2), t = std::tan(turn / 2);
    if (!(c > 1e-9)) return {0, CornerLimit::acceleration};
    const double radius = std::min(tolerance * c / (1 - c), shorter / 2 / t);
    return curve_speed(1 / radius, highest, l);
}

CornerSpeed curve_speed(double curvature, double highest, const Limits& l) {
    if (!(curvature > 0)) return {highest, CornerLimit::none};
    return least(highest, std::sqrt(l.acceleration / curvature), std::cbrt(l.jerk / (curvature * curvature)));
}

}  // namespace obrys::sim::time
