#pragma once
/// Triangles of a mesh that lie in the material: proved for every place of them, by distances from what was swept and
/// from the stock's outside, which are convex. Frame of the stock, millimetres.

#include <span>
#include <vector>

#include "mesh/mesh.hpp"
#include "sim/milling/exact/corners.hpp"
#include "sim/milling/exact/exact.hpp"
#include "sim/milling/exact/key_map.hpp"

namespace obrys::sim::milling {

/// Remembers what it has proved: triangles that stay as they are are looked at once.
class WithinMaterial {
public:
    explicit WithinMaterial(Exact& exact);

    struct Deep {
        geom::Vec3 at;
        Corners triangle;  ///< that it lies on
    };
    /// Places of triangles deeper in the material than `allowed`; nothing else of the mesh lies deeper than 1.03 times
    /// that. In the order of the triangles, which have tags. One that is not shown to be right with so many parts
    /// counts as deeper.
    [[nodiscard]] std::vector<Deep> places(const mesh::Mesh& mesh, double allowed, std::size_t parts);

    /// A convex body of air.
    struct Body {
        Air::Sweep sweep;
        bool stock = false;  ///< what lies outside of the stock, instead
    };

private:
    void add(const Air::Sweep& sweep, std::vector<Body>& bodies) const;
    [[nodiscard]] std::vector<Body> bodies_near(const Exact::Near& near) const;
    [[nodiscard]] std::vector<std::uint32_t> not_held_by_own(const mesh::Mesh& mesh,
                                                             std::span<const std::uint32_t> asked, double allowed,
                                                             std::size_t parts) const;

    Exact& exact_;
    KeyMap proved_;  ///< triangles by their corners
};

}  // namespace obrys::sim::milling
