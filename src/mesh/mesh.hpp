#pragma once
/// Triangle meshes as plain values, and what is measured on them. Millimetres.

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "geom/frame.hpp"
#include "geom/vec.hpp"

namespace obrys::mesh {

/// Corners as indices of vertices, counter-clockwise seen from outside the material.
using Triangle = std::array<std::uint32_t, 3>;

struct Mesh {
    std::vector<geom::Vec3> vertices;
    std::vector<Triangle> triangles;
    /// What each triangle stands for: a colour, the move that cut it. As many as triangles, or none.
    std::vector<std::uint32_t> tags;

    [[nodiscard]] bool empty() const { return triangles.empty(); }
    [[nodiscard]] std::uint32_t tag(std::size_t triangle) const { return tags.empty() ? 0 : tags[triangle]; }
};

/// Parallel to the axes, closed; empty while `lo` exceeds `hi`.
struct Box {
    geom::Vec3 lo{inf, inf, inf}, hi{-inf, -inf, -inf};

    [[nodiscard]] bool empty() const { return !(lo.x <= hi.x && lo.y <= hi.y && lo.z <= hi.z); }
    [[nodiscard]] geom::Vec3 size() const { return empty() ? geom::Vec3{} : hi - lo; }
    [[nodiscard]] geom::Vec3 centre() const { return 0.5 * (lo + hi); }
    void add(geom::Vec3 p);
    void add(const Box& b);

private:
    static constexpr double inf = std::numeric_limits<double>::infinity();
};

/// They have a place in common, if only on their faces; an empty one has none.
[[nodiscard]] constexpr bool overlap(const Box& a, const Box& b) {
    return a.lo.x <= b.hi.x && b.lo.x <= a.hi.x && a.lo.y <= b.hi.y && b.lo.y <= a.hi.y && a.lo.z <= b.hi.z &&
           b.lo.z <= a.hi.z;
}

[[nodiscard]] std::array<geom::Vec3, 3> corners(const Mesh& m, std::size_t triangle);
[[nodiscard]] geom::Vec3 centre(const Mesh& m, std::size_t triangle);
/// Twice the area times the unit normal to the outside; zero for a triangle without area.
[[nodiscard]] geom::Vec3 area_vector(const Mesh& m, std::size_t triangle);

[[nodiscard]] Box bounds(const Mesh& m);  ///< of all vertices
[[nodiscard]] double area(const Mesh& m);
/// Signed volume within a closed surface, negative where it is inside out. Of an open surface it means nothing.
[[nodiscard]] double volume(const Mesh& m);

/// Turns all triangles over: inside becomes outside.
void turn_over(Mesh& m);
/// The mesh in the outer system of a frame. Where the frame mirrors, triangles are turned over, so that outside stays
/// outside.
[[nodiscard]] Mesh transformed(const Mesh& m, const geom::Frame& f);
/// Adds the triangles of another mesh; where one of the two has tags, the other's count as 0.
void append(Mesh& m, const Mesh& other);

}  // namespace obrys::mesh
