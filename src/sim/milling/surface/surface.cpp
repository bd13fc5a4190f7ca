#include "sim/milling/surface/surface.hpp"

#include <bit>
#include <cmath>

#include "base/parallel.hpp"
#include "sim/milling/exact/coarse.hpp"
#include "sim/milling/surface/cell_vertices.hpp"
#include "sim/milling/surface/fine.hpp"
#include "sim/milling/surface/shown.hpp"

namespace obrys::sim::milling {

namespace {

using geom::Vec2;
using geom::Vec3;
/// The four vertices around a crossed edge, seen along it: the edge at the origin, one vertex in each quadrant,
/// counter- clockwise; heights along the edge, counted from the crossing.
struct Quad {
    std::array<Vec2, 4> at;
    std::array<double, 4> height{};

    /// How far the surface passes from the crossing if the quad is cut from vertex `a` to the opposite one; infinity
    /// where a triangle would be turned over.
    [[nodiscard]] double miss(std::size_t a) const {
        const std::size_t b = a + 1, c = (a + 2) % 4, d = (a + 3) % 4;
        if (cross(at[b] - at[a], at[c] - at[a]) < 0 || cross(at[c] - at[a], at[d] - at[a]) < 0) return HUGE_VAL;
        // The triangle that the edge passes through.
        const std::size_t third = cross(at[c] - at[a], -at[a]) > 0 ? d : b;
        const double wa = cross(at[c], at[third]), wc = cross(at[third], at[a]), wt = cross(at[a], at[c]);
        const double sum = wa + wc + wt;
        if (sum == 0) return std::abs(0.5 * (height[a] + height[c]));
        return std::abs((wa * height[a] + wc * height[c] + wt * height[third]) / sum);
    }

    [[nodiscard]] double diagonal(std::size_t a) const {
        const double rise = height[a + 2] - height[a];
        return length(Vec2{length(at[a + 2] - at[a]), rise});
    }

    /// True where it is to be cut from vertex 0 to 2: where that lies nearer to the crossing; else the shorter way.
    [[nodiscard]] bool cut_from_first(double rounding) const {
        const double first = miss(0), second = miss(1);
        if (std::isinf(first) != std::isinf(second)) return std::isinf(second);
        if (std::isfinite(first) && std::abs(first - second) > rounding) return first < second;
        return diagonal(0) <= diagonal(1) + rounding;
    }
};

class Builder {
public:
    Builder(const Lattice& lattice, const NodeBits& nodes, const Crossings& crossings, double tolerance)
        : lattice_(lattice), nodes_(nodes), crossings_(crossings), cells_(lattice, nodes, crossings, tolerance) {
        rough_.resize(nodes.rows());
        const auto total = crossings_.along(0).size() + crossings_.along(1).size() + crossings_.along(2).size();
        mesh_.vertices = cells_.take();
        mesh_.triangles.resize(2 * total);
        mesh_.tags.resize(2 * total);
        base::in_pieces(nodes_.rows(), 16, [&](const base::Piece& some) {
            for (std::size_t row = some.begin(); row < some.end(); ++row) quads_of(row);
        });
    }

    [[nodiscard]] const CellVertices& cells() const { return cells_; }
    [[nodiscard]] mesh::Mesh& mesh() { return mesh_; }
    /// Edges beside rough cells.
    [[nodiscard]] std::vector<CoarseQuad> rough() const {
        std::vector<CoarseQuad> all;
        for (const std::vector<CoarseQuad>& row : rough_) all.insert(all.end(), row.begin(), row.end());
        return all;
    }
    /// The mesh without what belongs to edges that touch a fine cell, with what `fine` has of these.
    [[nodiscard]] mesh::Mesh with(const Fine& fine) const {
        mesh::Mesh all = fine.mesh();
        mesh::Mesh mesh;
        mesh.vertices = mesh_.vertices;
        mesh.vertices.insert(mesh.vertices.end(), all.vertices.begin(), all.vertices.end());
        for (std::size_t row = 0; row < nodes_.rows(); ++row)
            each_quad(row, [&](int axis, std::array<int, 3> node, std::size_t, std::size_t triangle) {
                for (const auto& q : Leaves::quadrants) {
                    std::array<int, 3> cell = node;
                    cell[static_cast<std::size_t>(first_across(axis))] -= q[0];
                    cell[static_cast<std::size_t>(second_across(axis))] -= q[1];
                    if (fine.is_fine(cell[0], cell[1], cell[2])) return;
                }
                for (const std::size_t t : {triangle, triangle + 1}) {
                    mesh.triangles.push_back(mesh_.triangles[t]);
                    mesh.tags.push_back(mesh_.tags[t]);
                }
            });
        mesh.triangles.insert(mesh.triangles.end(), all.triangles.begin(), all.triangles.end());
        mesh.tags.insert(mesh.tags.end(), all.tags.begin(), all.tags.end());
        return mesh;
    }

private:
    /// Triangles come row by row, in each along x, then y, then z.
    template <class Take>
    void each_quad(std::size_t row, Take&& take) const {
        std::size_t triangle = 0;
        for (int axis = 0; axis < 3; ++axis) triangle += 2 * std::size_t{crossings_.first(axis, row)};
        for (int axis = 0; axis < 3; ++axis) {
            std::size_t number = crossings_.first(axis, row);
            if (number == crossings_.first(axis, row + 1)) continue;
            for (std::size_t w = 0; w < nodes_.words(); ++w)
                for (std::uint64_t mask = nodes_.crossed(axis, row, w); mask != 0; mask &= mask - 1) {
                    const int i = static_cast<int>(64 * w) + std::countr_zero(mask);
                    take(axis, std::array<int, 3>{i, nodes_.j(row), nodes_.k(row)}, number++, triangle);
                    triangle += 2;
                }
        }
    }

    void quads_of(std::size_t row) {
        each_quad(row, [&](int axis, std::array<int, 3> node, std::size_t number, std::size_t triangle) {
            if (quad(axis, node, number, triangle)) rough_[row].push_back({node, axis, triangle});
        });
    }

    /// True where one of its cells is rough.
    bool quad(int axis, std::array<int, 3> node, std::size_t number, std::size_t triangle) {
        const Crossing& c = crossings_.along(axis)[number];
        // Cells before and behind the edge, counter-clockwise in the plane (first across, second across).
        constexpr auto round = Leaves::quadrants;
        bool rough = false;
        const auto u = static_cast<std::size_t>(first_across(axis)), v = static_cast<std::size_t>(second_across(axis));
        const Vec3 foot = lattice_.node(node[0], node[1], node[2]);
        std::array<std::uint32_t, 4> vertex{};
        Quad q;
        for (std::size_t n = 0; n < 4; ++n) {
            std::array<int, 3> cell = node;
            cell[u] -= round[n][0];
            cell[v] -= round[n][1];
            vertex[n] = cells_.vertex(cell[0], cell[1], cell[2], cell_edge(axis, round[n][0], round[n][1]));
            rough = rough || cells_.is_rough(vertex[n]);
            const Vec3 p = mesh_.vertices[vertex[n]];
            q.at[n] = {component(p, first_across(axis)) - component(foot, first_across(axis)),
                       component(p, second_across(axis)) - component(foot, second_across(axis))};
            q.height[n] = component(p, axis) - c.at;
        }
        const std::size_t a = q.cut_from_first(1e-9 * component(lattice_.step, axis)) ? 0 : 1;
        mesh::Triangle one{vertex[a], vertex[a + 1], vertex[(a + 2) % 4]},
            two{vertex[a], vertex[(a + 2) % 4], vertex[(a + 3) % 4]};
        // Seen against the axis, counter-clockwise is so for x and z; y has its neighbours the other way round.
        const bool leaves = nodes_.material(node[0], node[1], node[2]);
        if (leaves == (axis == 1)) std::swap(one[1], one[2]), std::swap(two[1], two[2]);
        mesh_.triangles[triangle] = one;
        mesh_.triangles[triangle + 1] = two;
        mesh_.tags[triangle] = mesh_.tags[triangle + 1] = c.cut;
        return rough;
    }

    const Lattice& lattice_;
    const NodeBits& nodes_;
    const Crossings& crossings_;
    CellVertices cells_;
    mesh::Mesh mesh_;
    std::vector<std::vector<CoarseQuad>> rough_;  ///< by row
};

/// Without the vertices that no triangle has.
void drop_unused(mesh::Mesh& mesh) {
    constexpr std::uint32_t unused = 0xFFFFFFFF;
    std::vector<std::uint32_t> number(mesh.vertices.size(), unused);
    for (const mesh::Triangle& t : mesh.triangles)
        for (const std::uint32_t v : t) number[v] = 0;
    std::uint32_t next = 0;
    for (std::size_t v = 0; v < number.size(); ++v) {
        if (number[v] == unused) continue;
        mesh.vertices[next] = mesh.vertices[v];
        number[v] = next++;
    }
    mesh.vertices.resize(next);
    for (mesh::Triangle& t : mesh.triangles)
        for (std::uint32_t& v : t) v = number[v];
}

}  // namespace

Surface extract_surface(const Lattice& lattice, Rays rays, Normal normal, const Line& line) {
    Surface s;
    const NodeBits nodes(lattice, rays);
    if (nodes.rows() == 0) return s;
    const Crossings crossings(lattice, nodes, rays, normal, line);
    s.mesh = std::move(Builder(lattice, nodes, crossings, 0).mesh());
    s.thin = count_thin(lattice, rays);
    s.unmatched = crossings.unmatched();
    return s;
}

Surface extract_surface(const Dexels& dexels, Normal normal) {
    return extract_surface(
        dexels.lattice(), [&](int axis, int a, int b) { return dexels.ray(axis, a, b); }, normal);
}

Surface extract_surface(const Simulation& simulation, const Stop& stop) {
    Surface s;
    const Lattice& lattice = simulation.dexels().lattice();
    const auto rays = [&](int axis, int a, int b) { return simulation.dexels().ray(axis, a, b); };
    const auto normal = [&](std::uint32_t cut, Vec3 p, int, double) { return simulation.normal_at(cut, p); };
    const Line line = [&](int axis, Vec3 through, double low, double high) {
        return simulation.line(axis, through, low, high);
    };
    const NodeBits nodes(lattice, rays);
    if (nodes.rows() == 0) return s;
    const Crossings crossings(lattice, nodes, rays, normal, line);
    Builder builder(lattice, nodes, crossings, simulation.tolerance());
    s.thin = count_thin(lattice, rays);
    s.unmatched = crossings.unmatched();
    Exact exact(simulation, lattice);
    std::vector<Place> coarse = cells_with_narrow_edges(simulation);
    for (const Place& cell : cells_with_points(simulation, exact)) coarse.push_back(cell);
    for (const Place& cell : cells_off(builder.mesh(), builder.rough(), exact, simulation.tolerance()))
        coarse.push_back(cell);
    Fine fine(exact, simulation.tolerance(), lattice, nodes, crossings, builder.cells(), builder.mesh().vertices, stop);
    fine.refine(coarse);
    show_all(
        simulation, nodes, exact, fine, [&] { return builder.with(fine); }, stop);
    fine.settle();
    s.refined = fine.figures();
    if (s.refined.cells > 0) {
        s.mesh = builder.with(fine);
        drop_unused(s.mesh);
        return s;
    }
    s.mesh = std::move(builder.mesh());
    return s;
}

}  // namespace obrys::sim::milling
