#pragma once
/// The look of a mesh: lit by two lights, its creases and outlines drawn dark, cut faces hatched. Pixels.

#include <cstdint>
#include <functional>
#include <vector>

#include "mesh/colour.hpp"
#include "mesh/shading.hpp"
#include "report/picture/raster.hpp"

namespace obrys::report::picture {

/// Pixels 0xAARRGGBB row by row from the top, colours multiplied by the opacity (cairo's ARGB32).
struct Image {
    int width = 0, height = 0;
    std::vector<std::uint32_t> pixels;
};

/// One place of the surface that is seen.
struct Spot {
    std::uint32_t triangle = 0;
    double depth = 0;  ///< as of Camera::project
};

struct ReliefStyle {
    std::function<mesh::Colour(const Spot&)> colour;  ///< of the surface before it is lit
    double ambient = 0.45;                            ///< share of the colour without light, 0 … 1; 1: not lit at all
    bool hatch_cuts = false;  ///< back faces are the inside of material that Camera::nearest cuts open
    int finer = 2;            ///< pixels of the relief per pixel of the image, in both directions
};

/// Smooth normals of a mesh, to be shared by its pictures; indices that point nowhere must have been removed.
[[nodiscard]] mesh::Shading relief_normals(const mesh::Mesh& m);

struct Relief {
    Image image;
    Visible visible;  ///< `finer` times as fine as the image
};

/// `camera` in pixels of the image. Transparent where nothing is seen.
[[nodiscard]] Relief relief(const mesh::Mesh& m, const mesh::Shading& normals, const Camera& camera,
                            const ReliefStyle& style);

}  // namespace obrys::report::picture
