#pragma once
/// What of a triangle mesh is seen from a direction, pixel by pixel: parallel projection, z-buffer. Millimetres to
/// pixels.

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "base/whole.hpp"

#include "mesh/mesh.hpp"

namespace obrys::report::picture {

constexpr int most_pixels = 1 << 16;  ///< of a picture's width or height

/// Parallel projection onto a canvas of width x height pixels, whose y runs downwards. `right`, `up` and `toward` (to
/// the eye) are unit vectors at right angles, in the frame of the mesh.
struct Camera {
    geom::Vec3 right{1, 0, 0}, up{0, 1, 0}, toward{0, 0, 1};
    geom::Vec3 centre;    ///< mm; shown at (x, y)
    double x = 0, y = 0;  ///< px
    double px_per_mm = 1;
    int width = 0, height = 0;
    /// What lies nearer to the eye than this plane through the scene is cut away, mm from `centre` along `toward`.
    double nearest = std::numeric_limits<double>::infinity();

    /// x, y in pixels (pixel (i, j) covers i … i + 1), z: mm from `centre` towards the eye.
    [[nodiscard]] geom::Vec3 project(geom::Vec3 p) const;
};

/// Of each pixel, row by row from the top, the triangle seen at its middle and how near to the eye it is.
struct Visible {
    static constexpr std::uint32_t none = 0xffffffff;
    int width = 0, height = 0;
    std::vector<std::uint32_t> triangle;
    std::vector<float> depth;  ///< mm as of Camera::project; -infinity where nothing is seen
    bool complete = true;      ///< false: so much overlapping area that the drawing was ended early

    [[nodiscard]] std::size_t at(int i, int j) const {
        return static_cast<std::size_t>(j) * static_cast<std::size_t>(width) + static_cast<std::size_t>(i);
    }
};

/// Both sides of a triangle are seen; of equally near ones the first. Triangles with a corner that is not finite are
/// left out. Time: linear in triangles and covered pixels, with an end (`complete`).
[[nodiscard]] Visible rasterise(const mesh::Mesh& m, const Camera& camera);

}  // namespace obrys::report::picture
