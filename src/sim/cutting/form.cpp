#include "sim/cutting/form.hpp"

#include <algorithm>
#include <cmath>

#include "geom/vec.hpp"

namespace obrys::sim::cutting {

namespace {

/// Angle of the corner's round from the axis up to which it cuts.
double highest_angle(const MillForm& f, double depth) {
    return f.tilt + std::acos(std::clamp(1 - depth / f.corner_radius, -1.0, 1.0));
}

}  // namespace

double effective_diameter(const MillForm& f, double depth) {
    if (!(f.corner_radius > 0)) return f.diameter;
    const double angle = highest_angle(f, depth);
    if (angle >= geom::pi / 2) return f.diameter;
    return f.diameter - 2 * f.corner_radius + 2 * f.corner_radius * std::sin(angle);
}

double edge_length(const MillForm& f, double depth) {
    if (!(f.corner_radius > 0)) return depth;
    const double round = std::min(depth, f.corner_radius);
    return f.corner_radius * std::acos(1 - round / f.corner_radius) + (depth - round);
}

double mean_lean(const MillForm& f, double depth) {
    const double length = edge_length(f, depth);
    return length > 0 ? depth / length : 1;
}

double ridge(double radius, double distance) {
    return distance > 2 * radius ? NAN : radius - std::sqrt(radius * radius - distance * distance / 4);
}

double mean_deviation(double ridge) { return 4 / (9 * std::sqrt(3.0)) * ridge; }

}  // namespace obrys::sim::cutting
