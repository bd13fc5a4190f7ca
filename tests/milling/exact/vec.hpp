#pragma once
/// The reference's own vectors; it shares nothing with what it measures.

#include <algorithm>
#include <array>
#include <cmath>

namespace exact {

struct V {
    double x = 0, y = 0, z = 0;
    double operator[](int i) const { return i == 0 ? x : i == 1 ? y : z; }
};
inline V operator+(V a, V b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline V operator-(V a, V b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline V operator*(double k, V a) { return {k * a.x, k * a.y, k * a.z}; }
inline double dot(V a, V b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline V cross(V a, V b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
inline double norm(V a) { return std::sqrt(dot(a, a)); }
inline V unit(V a) {
    const double n = norm(a);
    return n > 0 ? (1 / n) * a : V{1, 0, 0};
}
/// Any direction across `a`.
inline V across(V a) { return unit(cross(a, std::abs(a.x) < 0.6 ? V{1, 0, 0} : V{0, 1, 0})); }

struct Box {
    V lo{1e300, 1e300, 1e300}, hi{-1e300, -1e300, -1e300};
    void add(V p) {
        lo = {std::min(lo.x, p.x), std::min(lo.y, p.y), std::min(lo.z, p.z)};
        hi = {std::max(hi.x, p.x), std::max(hi.y, p.y), std::max(hi.z, p.z)};
    }
    [[nodiscard]] double distance(V p) const {
        const V d{std::max({lo.x - p.x, 0.0, p.x - hi.x}), std::max({lo.y - p.y, 0.0, p.y - hi.y}),
                  std::max({lo.z - p.z, 0.0, p.z - hi.z})};
        return norm(d);
    }
};

/// Distances and coordinates with the direction in which they grow the fastest.
struct Signed {
    double d = 0;  ///< negative inside
    V out;         ///< unit length
};

}  // namespace exact
