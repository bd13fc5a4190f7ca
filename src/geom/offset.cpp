#include "geom/offset.hpp"

#include "geom/band.hpp"
#include "geom/boolean.hpp"

namespace obrys::geom {

namespace {

Contour grown(const Contour& c, double d) {
    Contour out;
    for (const BandEdge& b : band_right_of(edges(c), d)) out.vertices.push_back({b.edge.a, b.edge.bulge});
    return out;
}

}  // namespace

Region offset(const Region& r, double by) {
    if (by == 0) return r;
    // Inward, what is outside grows: its contours are the region's, reversed.
    std::vector<Contour> curves;
    for (const Contour& c : r.contours) {
        if (edges(c).empty()) continue;
        curves.push_back(by > 0 ? grown(c, by) : reversed(grown(reversed(c), -by)));
    }
    return positive(curves);
}

}  // namespace obrys::geom
