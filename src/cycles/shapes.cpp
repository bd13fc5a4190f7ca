#include "cycles/shapes.hpp"

#include <algorithm>
#include <cmath>

#include "geom/boolean.hpp"

namespace obrys::cycles {

using geom::Contour;
using geom::Region;
using geom::Vec2;

Contour rectangle(double length, double width, double corner) {
    const double u = length / 2, v = width / 2, bulge = std::tan(geom::pi / 8);
    if (corner <= 0) return {{{{-u, -v}}, {{u, -v}}, {{u, v}}, {{-u, v}}}, true};
    const double a = u - corner, b = v - corner;
    return {{{{-a, -v}},
             {{a, -v}, bulge},
             {{u, -b}},
             {{u, b}, bulge},
             {{a, v}},
             {{-a, v}, bulge},
             {{-u, b}},
             {{-u, -b}, bulge}},
            true};
}

Contour disc(double radius) { return {{{{-radius, 0}, 1}, {{radius, 0}, 1}}, true}; }

Contour long_slot(double length, double width) {
    const double a = (length - width) / 2, v = width / 2;
    if (a <= 0) return disc(v);
    return {{{{-a, -v}}, {{a, -v}, 1}, {{a, v}}, {{-a, v}, 1}}, true};
}

Region round_slot(double radius, double width, double from, double sweep) {
    const double outer = radius + width / 2, inner = radius - width / 2;
    if (std::abs(sweep) >= 2 * geom::pi - 1e-12) {
        if (inner <= 0) return {{disc(outer)}};
        return {{disc(outer), geom::reversed(disc(inner))}};
    }
    const double start = sweep < 0 ? from + sweep : from, turn = std::abs(sweep), half = start + turn / 2;
    const auto at = [](double r, double w) { return Vec2{r * std::cos(w), r * std::sin(w)}; };
    const double bulge = std::tan(turn / 8);  // two arcs, as one may not be nearly a full turn
    const Contour c{{{at(outer, start), bulge},
                     {at(outer, half), bulge},
                     {at(outer, start + turn), 1},
                     {at(inner, start + turn), -bulge},
                     {at(inner, half), -bulge},
                     {at(inner, start), 1}},
                    true};
    return geom::positive({c});  // its ends may overlap
}

Vec2 placed(Vec2 p, const Placement& where) {
    const double c = std::cos(where.angle), s = std::sin(where.angle);
    return where.at + Vec2{c * p.x - s * p.y, s * p.x + c * p.y};
}

Contour placed(const Contour& c, const Placement& where) {
    Contour out = c;
    for (geom::Vertex& v : out.vertices) v.p = placed(v.p, where);
    return out;
}

Region placed(const Region& r, const Placement& where) {
    Region out;
    for (const Contour& c : r.contours) out.contours.push_back(placed(c, where));
    return out;
}

std::optional<Subcontour> classify(const Contour& c, int side) {
    const double enclosed = c.closed ? geom::area(c) : 0;
    if (side == 0 || enclosed == 0 || !std::isfinite(enclosed)) return std::nullopt;
    return (enclosed > 0) == (side > 0) ? Subcontour::pocket : Subcontour::island;
}

Region area_of(const std::vector<ProgrammedContour>& contours) {
    std::vector<Contour> pockets, islands;
    for (const ProgrammedContour& p : contours) {
        const Contour outer = geom::area(p.contour) < 0 ? geom::reversed(p.contour) : p.contour;
        (p.is == Subcontour::pocket ? pockets : islands).push_back(outer);
    }
    const Region all = geom::positive(pockets);
    return islands.empty() ? all : geom::subtract(all, geom::positive(islands));
}

}  // namespace obrys::cycles
