#pragma once
/// Vectors in the plane and in space; plain values, millimetres unless said otherwise.

#include <cmath>

namespace obrys::geom {

inline constexpr double pi = 3.14159265358979323846;
inline constexpr double full_turn = 2 * pi;
[[nodiscard]] constexpr double radians(double degrees) { return degrees * (pi / 180.0); }
[[nodiscard]] constexpr double degrees(double radians) { return radians * (180.0 / pi); }

struct Vec2 {
    double x = 0, y = 0;
    bool operator==(const Vec2&) const = default;
};
[[nodiscard]] constexpr Vec2 operator+(Vec2 a, Vec2 b) { return {a.x + b.x, a.y + b.y}; }
[[nodiscard]] constexpr Vec2 operator-(Vec2 a, Vec2 b) { return {a.x - b.x, a.y - b.y}; }
[[nodiscard]] constexpr Vec2 operator*(double k, Vec2 a) { return {k * a.x, k * a.y}; }
[[nodiscard]] constexpr Vec2 operator-(Vec2 a) { return {-a.x, -a.y}; }
[[nodiscard]] constexpr double dot(Vec2 a, Vec2 b) { return a.x * b.x + a.y * b.y; }
/// z component of the cross product: positive where b lies left of a.
[[nodiscard]] constexpr double cross(Vec2 a, Vec2 b) { return a.x * b.y - a.y * b.x; }
/// The root of the sum, not hypot: lengths of a machine neither overflow nor vanish when squared, and hypot costs ten
/// times as much (docs/performance.md). A NaN stays one.
[[nodiscard]] inline double length(Vec2 a) { return std::sqrt(dot(a, a)); }
[[nodiscard]] inline double distance(Vec2 a, Vec2 b) { return length(b - a); }
/// A quarter turn counter-clockwise.
[[nodiscard]] constexpr Vec2 left_of(Vec2 a) { return {-a.y, a.x}; }

struct Vec3 {
    double x = 0, y = 0, z = 0;
    bool operator==(const Vec3&) const = default;
};
[[nodiscard]] constexpr Vec3 operator+(Vec3 a, Vec3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
[[nodiscard]] constexpr Vec3 operator-(Vec3 a, Vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
[[nodiscard]] constexpr Vec3 operator*(double k, Vec3 a) { return {k * a.x, k * a.y, k * a.z}; }
[[nodiscard]] constexpr double dot(Vec3 a, Vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
[[nodiscard]] constexpr Vec3 cross(Vec3 a, Vec3 b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
[[nodiscard]] inline double length(Vec3 a) { return std::sqrt(dot(a, a)); }
[[nodiscard]] inline double distance(Vec3 a, Vec3 b) { return length(b - a); }
[[nodiscard]] inline bool is_finite(Vec3 a) { return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z); }

}  // namespace obrys::geom
