#include "mesh/shading.hpp"

#include <cmath>

namespace obrys::mesh {

using geom::Vec3;

namespace {

/// Corners by vertex: those of vertex v lie in `corner` from start[v] to start[v + 1].
struct Around {
    std::vector<std::uint32_t> start, corner;
};

Around corners_around(const Mesh& m) {
    Around a;
    a.start.assign(m.vertices.size() + 1, 0);
    for (const Triangle& t : m.triangles)
        for (const std::uint32_t v : t) ++a.start[v + 1];
    for (std::size_t v = 0; v < m.vertices.size(); ++v) a.start[v + 1] += a.start[v];
    a.corner.resize(3 * m.triangles.size());
    std::vector<std::uint32_t> next(a.start.begin(), a.start.end() - 1);
    for (std::size_t t = 0; t < m.triangles.size(); ++t)
        for (std::size_t c = 0; c < 3; ++c) a.corner[next[m.triangles[t][c]]++] = static_cast<std::uint32_t>(3 * t + c);
    return a;
}

}  // namespace

Shading shade(const Mesh& m, double crease) {
    Shading s;
    s.corners.assign(3 * m.triangles.size(), Shading::none);
    std::vector<Vec3> face(m.triangles.size());
    for (std::size_t t = 0; t < face.size(); ++t) face[t] = area_vector(m, t);
    const double smooth = std::cos(crease);
    const Around around = corners_around(m);
    std::vector<Vec3> first;  // of each shaded vertex, the face that began it
    for (std::uint32_t v = 0; v < m.vertices.size(); ++v) {
        const std::size_t begin = s.vertex.size();
        for (std::uint32_t at = around.start[v]; at < around.start[v + 1]; ++at) {
            const std::uint32_t corner = around.corner[at];
            const Vec3 n = face[corner / 3];
            const double size = length(n);
            if (!(size > 0)) continue;
            std::size_t shaded = begin;
            while (shaded < s.vertex.size() && !(dot(first[shaded], n) >= smooth * size)) ++shaded;
            if (shaded == s.vertex.size()) {
                s.vertex.push_back(v);
                s.normal.push_back({});
                first.push_back((1 / size) * n);
            }
            s.normal[shaded] = s.normal[shaded] + n;
            s.corners[corner] = static_cast<std::uint32_t>(shaded);
        }
    }
    for (std::size_t i = 0; i < s.normal.size(); ++i) {
        const double size = length(s.normal[i]);
        s.normal[i] = size > 0 ? (1 / size) * s.normal[i] : first[i];
    }
    return s;
}

}  // namespace obrys::mesh
