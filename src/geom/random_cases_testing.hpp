#pragma once
/// For tests: random contours, each case from its own number, so that a failure is found again by that number alone.

#include <random>

#include "geom/boolean.hpp"

namespace obrys::geom::testing {

class Random {
public:
    explicit Random(unsigned number) : engine_(number) {}
    int below(int n) { return std::uniform_int_distribution<int>(0, n - 1)(engine_); }
    double between(double lo, double hi) { return std::uniform_real_distribution<double>(lo, hi)(engine_); }
    Vec2 point(double lo, double hi) {
        const double x = between(lo, hi);
        return {x, between(lo, hi)};
    }
    template <class T, std::size_t n>
    T one_of(const T (&values)[n]) {
        return values[static_cast<std::size_t>(below(static_cast<int>(n)))];
    }

private:
    std::mt19937 engine_;
};

/// Closed, may cross itself; its corners on a lattice, so that edges coincide, touch and meet in corners all the time.
inline Contour lattice_loop(Random& random, int size) {
    constexpr double bulges[] = {0, 0, 0, 1, -1, 0.41421356237309503, -0.41421356237309503, 0.3};
    Contour out;
    for (int n = 3 + random.below(6); n > 0; --n) {
        const int x = random.below(size), y = random.below(size);
        out.vertices.push_back({{static_cast<double>(x), static_cast<double>(y)}, random.one_of(bulges)});
    }
    return out;
}
inline Region lattice_region(Random& random, int size) { return tidied({lattice_loop(random, size)}); }

inline Region turned(Region r, double angle, Vec2 by) {
    const double c = std::cos(angle), s = std::sin(angle);
    for (Contour& k : r.contours)
        for (Vertex& v : k.vertices) v.p = Vec2{c * v.p.x - s * v.p.y, s * v.p.x + c * v.p.y} + by;
    return r;
}

inline Contour rectangle(double x0, double y0, double x1, double y1) {
    return {{{{x0, y0}}, {{x1, y0}}, {{x1, y1}}, {{x0, y1}}}, true};
}
inline Contour disc(double x, double y, double r) { return {{{{x - r, y}, 1}, {{x + r, y}, 1}}, true}; }

inline double distance_to(const std::vector<Edge>& edges, Vec2 p) {
    double d = std::numeric_limits<double>::infinity();
    for (const Edge& e : edges) d = std::min(d, distance(e, p));
    return d;
}

}  // namespace obrys::geom::testing
