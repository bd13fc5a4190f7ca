#pragma once
/// For tests: random contours on a lattice, so that edges coincide, touch and meet in corners all the time.

#include <rapidcheck.h>

#include <ostream>

#include "geom/boolean.hpp"

namespace obrys::geom {

/// How rapidcheck prints a counterexample.
inline void showValue(const Contour& c, std::ostream& os) {
    os.precision(17);
    for (const Vertex& v : c.vertices) os << '(' << v.p.x << ", " << v.p.y << "; " << v.bulge << ") ";
    os << '\n';
}
inline void showValue(const Region& r, std::ostream& os) {
    for (const Contour& c : r.contours) showValue(c, os);
}

}  // namespace obrys::geom

namespace obrys::geom::testing {

inline rc::Gen<Vertex> lattice_vertex(int size) {
    return rc::gen::map(
        rc::gen::tuple(rc::gen::inRange(0, size), rc::gen::inRange(0, size),
                       rc::gen::element(0.0, 0.0, 0.0, 1.0, -1.0, 0.41421356237309503, -0.41421356237309503, 0.3)),
        [](const std::tuple<int, int, double>& t) {
            return Vertex{{static_cast<double>(std::get<0>(t)), static_cast<double>(std::get<1>(t))}, std::get<2>(t)};
        });
}

/// Closed, may cross itself.
inline rc::Gen<Contour> lattice_loop(int size, int most = 8) {
    return rc::gen::mapcat(rc::gen::inRange(3, most + 1), [size](int n) {
        return rc::gen::map(rc::gen::container<std::vector<Vertex>>(static_cast<std::size_t>(n), lattice_vertex(size)),
                            [](std::vector<Vertex> v) {
                                return Contour{std::move(v), true};
                            });
    });
}

inline rc::Gen<Region> lattice_region(int size, int most = 8) {
    return rc::gen::map(lattice_loop(size, most), [](const Contour& c) { return tidied({c}); });
}

/// Off the lattice and off its circles, within the square -1 .. size + 1 (arcs reach beyond it).
inline rc::Gen<Vec2> free_point(int size) {
    const auto coordinate = rc::gen::map(rc::gen::inRange(0, 1'000'000),
                                         [size](int k) { return -1.0 + (size + 2) * (k + 0.3819660113) / 1e6; });
    return rc::gen::map(rc::gen::pair(coordinate, coordinate), [](const std::pair<double, double>& p) {
        return Vec2{p.first, p.second};
    });
}

}  // namespace obrys::geom::testing
