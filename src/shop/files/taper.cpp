#include "shop/files/taper.hpp"

#include <algorithm>
#include <cmath>

namespace obrys::shop {

namespace {
constexpr double no_height = 1e-9;  ///< mm

bool positive(double v) { return std::isfinite(v) && v > 0; }
}  // namespace

std::vector<geom::Vertex> tapered_profile(double radius, double corner, double angle, double height) {
    if (!positive(radius) || !positive(height) || !(std::abs(angle) < 90) || !(corner >= 0)) return {};
    const double a = geom::radians(angle), top = radius + height * std::tan(a);
    if (!(top >= 0)) return {};
    std::vector<geom::Vertex> out{{{0, 0}, 0}};
    if (corner > 0) {
        const double turn = geom::pi / 2 - a;  // from the bottom's direction into the flank's
        const double tangent = corner * std::tan(turn / 2);
        if (tangent > radius + no_height || tangent * std::cos(a) > height) return {};
        const double flat = std::max(0.0, radius - tangent);
        if (flat < no_height) out.clear();
        out.push_back({{flat < no_height ? 0 : flat, 0}, std::tan(turn / 4)});
        out.push_back({{radius + tangent * std::sin(a), tangent * std::cos(a)}, 0});
    } else {
        out.push_back({{radius, 0}, 0});
    }
    if (height > out.back().p.y + no_height) out.push_back({{top, height}, 0});
    return out;
}

std::vector<geom::Vertex> lollipop_profile(double radius, double neck) {
    if (!positive(radius) || !positive(neck) || neck >= radius) return {};
    const double above = std::sqrt(radius * radius - neck * neck);
    const double sweep = std::atan2(above, neck);  // from the equator up to the neck
    return {{{0, 0}, std::tan(geom::pi / 8)}, {{radius, radius}, std::tan(sweep / 4)}, {{neck, radius + above}, 0}};
}

std::vector<geom::Vertex> hollow_profile(double tip, double corner, double height) {
    if (!(tip >= 0) || !positive(corner) || !(height >= corner)) return {};
    std::vector<geom::Vertex> out;
    if (tip > 0) out.push_back({{0, 0}, 0});
    out.push_back({{tip, 0}, -std::tan(geom::pi / 8)});
    out.push_back({{tip + corner, corner}, 0});
    if (height > corner + no_height) out.push_back({{tip + corner, height}, 0});
    return out;
}

}  // namespace obrys::shop
