#include "geom/ridge.hpp"

#include <algorithm>
#include <limits>

namespace obrys::geom {

namespace {

/// A ridge is at most as high as the tool's middle: the tool has no places farther apart that still touch.
double height_of(const RidgeTool& tool) { return std::min(tool.height, tool.diameter / 2); }

}  // namespace

double half_ridge_step(const RidgeTool& tool) {
    const double h = height_of(tool);
    return std::sqrt(std::max(0.0, tool.diameter * h - h * h));
}

double ridge_step_angle(double radius, const RidgeTool& tool, bool outside) {
    const double r = tool.diameter / 2, h = height_of(tool), sign = outside ? 1 : -1;
    const double centre = radius + sign * r, tip = radius + sign * h;  // the tool's centre, the ridge's tip
    if (!(centre > 0) || !(tip > 0)) return pi / 2;
    const double cosine = (centre * centre + tip * tip - r * r) / (2 * centre * tip);
    return std::min(pi / 2, 2 * std::acos(std::clamp(cosine, -1.0, 1.0)));
}

double ridge_of_line(double step, double diameter) {
    const double r = diameter / 2, under = r * r - step * step / 4;
    return under < 0 ? std::numeric_limits<double>::infinity() : r - std::sqrt(under);
}

double ridge_of_arc(double radius, double angle, double diameter, bool outside) {
    const double r = diameter / 2, centre = outside ? radius + r : radius - r;
    const double across = centre * std::sin(angle / 2), under = r * r - across * across;
    if (under < 0) return std::numeric_limits<double>::infinity();
    const double along = centre * std::cos(angle / 2);
    return outside ? along - std::sqrt(under) - radius : radius - along - std::sqrt(under);
}

Vec2 stair_corner(Vec2 from, Vec2 to, bool left) {
    const Vec2 x_first{to.x, from.y}, y_first{from.x, to.y};
    return (cross(to - from, x_first - from) > 0) == left ? x_first : y_first;
}

}  // namespace obrys::geom
