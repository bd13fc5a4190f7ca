#include "cl/path_element.hpp"

#include "cl/spline.hpp"
#include "cl/totals.hpp"

namespace obrys::cl {

namespace {

/// Both values become 0 where neither is known.
void settle(double& a, double& b) {
    if (std::isnan(a) && std::isnan(b)) a = b = 0;
}
void settle(geom::Vec3& a, geom::Vec3& b) {
    settle(a.x, b.x);
    settle(a.y, b.y);
    settle(a.z, b.z);
}

/// Whether the coordinate, if it is not known, does not move.
bool stands_still(const geom::Cubic& c, std::size_t axis) {
    const geom::Polynomial3 p = geom::component(c, axis);
    return !std::isnan(p.k0) || (p.k1 == 0 && p.k2 == 0 && p.k3 == 0);
}

/// Along the normal, and along a coordinate that was never given, any centre will do.
double centre_of(double centre, double from, double normal) {
    return std::isnan(centre) && std::abs(normal) == 1 ? from : centre;
}

}  // namespace

std::optional<geom::PathElement> element_of(geom::Vec3 from, const Step& move) {
    if (!is_move(move)) return std::nullopt;
    if (const auto* spline = std::get_if<Spline>(&move)) {
        geom::Cubic c = curve(*spline);
        const bool stands = stands_still(c, 0) && stands_still(c, 1) && stands_still(c, 2);
        geom::Vec3 also_unknown = c.k0;
        settle(c.k0, also_unknown);
        if (!stands || !geom::is_finite(geom::point_at(c, 1))) return std::nullopt;
        return geom::reversed(c);
    }
    geom::Vec3 to = position_after(from, move);
    settle(from, to);
    if (!geom::is_finite(from) || !geom::is_finite(to)) return std::nullopt;
    const auto* arc = std::get_if<Arc>(&move);
    if (arc == nullptr) return geom::Straight{from, to};
    const geom::Vec3 centre{centre_of(arc->centre.x, from.x, arc->normal.x),
                            centre_of(arc->centre.y, from.y, arc->normal.y),
                            centre_of(arc->centre.z, from.z, arc->normal.z)};
    if (!geom::is_finite(centre) || !std::isfinite(arc->sweep)) return std::nullopt;
    return geom::Circular{from, to, centre, arc->normal, arc->sweep};
}

}  // namespace obrys::cl
