#pragma once
/// Joins equal (or nearly equal) points to one vertex, in the order in which they come.

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "geom/vec.hpp"

namespace obrys::mesh {

class Welder {
public:
    /// Points nearer than `tolerance` mm to a vertex become that vertex; 0: only equal ones (-0 equals 0).
    explicit Welder(double tolerance = 0);

    /// The vertex of a point, which must be finite. The nearest one where several are near enough.
    std::uint32_t add(geom::Vec3 p);
    [[nodiscard]] const std::vector<geom::Vec3>& vertices() const { return vertices_; }
    [[nodiscard]] std::vector<geom::Vec3> take() { return std::move(vertices_); }

private:
    static constexpr std::uint32_t none = 0xffffffff;
    [[nodiscard]] std::size_t bucket(geom::Vec3 key) const;
    [[nodiscard]] geom::Vec3 key_of(geom::Vec3 p) const;
    [[nodiscard]] std::uint32_t find(geom::Vec3 p) const;
    [[nodiscard]] std::uint32_t find_near(geom::Vec3 p) const;
    void grow();

    double tolerance_;
    std::vector<geom::Vec3> vertices_;
    std::vector<std::uint32_t> head_, next_;  // chains of vertices in one bucket
};

}  // namespace obrys::mesh
