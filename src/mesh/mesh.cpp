#include "mesh/mesh.hpp"

#include <algorithm>
#include <utility>

namespace obrys::mesh {

using geom::Vec3;

void Box::add(Vec3 p) {
    lo = {std::min(lo.x, p.x), std::min(lo.y, p.y), std::min(lo.z, p.z)};
    hi = {std::max(hi.x, p.x), std::max(hi.y, p.y), std::max(hi.z, p.z)};
}

void Box::add(const Box& b) {
    if (b.empty()) return;
    add(b.lo);
    add(b.hi);
}

std::array<Vec3, 3> corners(const Mesh& m, std::size_t triangle) {
    const Triangle& t = m.triangles[triangle];
    return {m.vertices[t[0]], m.vertices[t[1]], m.vertices[t[2]]};
}

Vec3 centre(const Mesh& m, std::size_t triangle) {
    const auto [a, b, c] = corners(m, triangle);
    return (1.0 / 3) * (a + b + c);
}

Vec3 area_vector(const Mesh& m, std::size_t triangle) {
    const auto [a, b, c] = corners(m, triangle);
    return cross(b - a, c - a);
}

Box bounds(const Mesh& m) {
    Box box;
    for (const Vec3& v : m.vertices) box.add(v);
    return box;
}

double area(const Mesh& m) {
    double sum = 0;
    for (std::size_t i = 0; i < m.triangles.size(); ++i) sum += 0.5 * length(area_vector(m, i));
    return sum;
}

double volume(const Mesh& m) {
    if (m.vertices.empty()) return 0;
    // Measured from the middle of the body, so that a body far from the origin loses no digits.
    const Vec3 middle = bounds(m).centre();
    double sum = 0;
    for (std::size_t i = 0; i < m.triangles.size(); ++i) {
        const auto [a, b, c] = corners(m, i);
        sum += dot(a - middle, cross(b - middle, c - middle));
    }
    return sum / 6;
}

void turn_over(Mesh& m) {
    for (Triangle& t : m.triangles) std::swap(t[1], t[2]);
}

Mesh transformed(const Mesh& m, const geom::Frame& f) {
    Mesh out = m;
    for (Vec3& v : out.vertices) v = apply(f, v);
    if (determinant(f) < 0) turn_over(out);
    return out;
}

void append(Mesh& m, const Mesh& other) {
    const auto shift = static_cast<std::uint32_t>(m.vertices.size());
    if (!m.tags.empty() || !other.tags.empty()) {
        m.tags.resize(m.triangles.size(), 0);
        m.tags.insert(m.tags.end(), other.tags.begin(), other.tags.end());
        m.tags.resize(m.triangles.size() + other.triangles.size(), 0);
    }
    m.vertices.insert(m.vertices.end(), other.vertices.begin(), other.vertices.end());
    m.triangles.reserve(m.triangles.size() + other.triangles.size());
    for (const Triangle& t : other.triangles) m.triangles.push_back({t[0] + shift, t[1] + shift, t[2] + shift});
}

}  // namespace obrys::mesh
