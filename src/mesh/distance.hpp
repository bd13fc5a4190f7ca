#pragma once
/// Distances from a mesh, found through a tree of boxes. Millimetres.

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "mesh/mesh.hpp"

namespace obrys::mesh {

/// The place of a mesh nearest to a point.
struct Nearest {
    geom::Vec3 at;
    double distance = std::numeric_limits<double>::infinity();
    std::uint32_t triangle = 0;
    std::uint8_t feature = 0;  ///< within the triangle: 0 inside, 1 … 3 on the side from that corner on, 4 … 6 a corner
};

/// Keeps a copy of the mesh; can be asked from several threads at once. The sign is that of the angle-weighted normal
/// of the place found (Baerentzen, Aanaes: "Signed Distance Computation Using the Angle Weighted Pseudonormal", 2005),
/// which is right where the mesh is closed and not elsewhere: see `topology`.
class Distance {
public:
    explicit Distance(Mesh mesh);

    [[nodiscard]] const Mesh& mesh() const { return mesh_; }
    /// Nothing farther than `reach` is looked for: then the distance is infinite. So it is for an empty mesh and for a
    /// point that is not finite.
    [[nodiscard]] Nearest nearest(geom::Vec3 p, double reach = std::numeric_limits<double>::infinity()) const;
    /// Positive outside, negative within; infinite where nothing was found.
    [[nodiscard]] double signed_distance(geom::Vec3 p, double reach = std::numeric_limits<double>::infinity()) const;
    /// Calls `triangle(number)` for all triangles in boxes that `box(box)` lets pass, until one says false.
    template <class Passes, class Visit>
    void visit(Passes&& box, Visit&& triangle) const;
    /// Unit normal out of the material; zero where a triangle has no area.
    [[nodiscard]] geom::Vec3 normal(std::size_t triangle) const { return face_[triangle]; }
    /// The sign that `signed_distance` gives a place found for `p`.
    [[nodiscard]] bool is_inside(geom::Vec3 p, const Nearest& place) const;

private:
    struct Node {
        Box box;
        std::uint32_t first = 0;  ///< inner: the second child (the first follows this node); leaf: of its triangles
        std::uint32_t count = 0;  ///< of a leaf's triangles; 0 for inner nodes
    };
    void build();
    void weigh_normals();
    void visit_leaf(const Node& node, geom::Vec3 p, Nearest& best) const;

    Mesh mesh_;
    std::vector<Node> nodes_;
    std::vector<std::uint32_t> order_;       ///< triangles as the leaves hold them
    std::vector<geom::Vec3> face_, corner_;  ///< unit normals of triangles; weighted ones of vertices
    std::vector<std::uint32_t> beside_;      ///< at 3 t + c: the triangle across the side from corner c on
};

template <class Passes, class Visit>
void Distance::visit(Passes&& box, Visit&& triangle) const {
    if (nodes_.empty()) return;
    std::array<std::uint32_t, 64> stack;  // halved at each level, and 2^32 triangles at most
    std::size_t waiting = 0;
    stack[waiting++] = 0;
    while (waiting > 0) {
        const std::uint32_t here = stack[--waiting];
        const Node& node = nodes_[here];
        if (!box(node.box)) continue;
        for (std::uint32_t i = node.first; i < node.first + node.count; ++i)
            if (!triangle(order_[i])) return;
        if (node.count > 0) continue;
        stack[waiting++] = node.first;
        stack[waiting++] = here + 1;
    }
}

/// The place of a triangle nearest to a point. Source: C. Ericson, "Real-Time Collision Detection" (2005),
/// chapter 5.1.5.
[[nodiscard]] Nearest nearest_on_triangle(geom::Vec3 p, const std::array<geom::Vec3, 3>& corners);

}  // namespace obrys::mesh
