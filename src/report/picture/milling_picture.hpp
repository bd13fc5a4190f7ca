#pragma once
/// The control's three pictures of a machined part: plan view shaded by depth, three projections, 3D. PNG and SVG, no
/// display needed. Millimetres, frame of the stock; pictures in pixels.

#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "geom/vec.hpp"
#include "mesh/colour.hpp"
#include "mesh/mesh.hpp"

namespace obrys::report::picture {

enum class MillingView : std::uint8_t {
    plan,         ///< from above: the deeper the darker, with a scale of heights
    projections,  ///< front and left side cut open, plan below; first angle projection (ISO 5456-2), one scale
    solid,        ///< parallel projection from front, right and above
};

/// A place to point at: a finding's number.
struct PictureMark {
    std::string label;
    geom::Vec3 at;
};

/// A piece of the path of the tool's tip.
struct PicturePath {
    std::vector<geom::Vec3> points;
    bool rapid = false;
};

struct PictureLegend {
    mesh::Colour colour;
    std::string text;  ///< UTF-8
};

/// What the pictures show. Refers to the caller's values.
struct MillingScene {
    const mesh::Mesh& surface;  ///< closed where cut faces are to be right; outside to the outside
    mesh::Box stock = {};       ///< before machining; empty: the surface's own extent
    /// Of each triangle an index in `palette`; empty: the surface's tags are that. As Palette says beyond its end.
    std::span<const std::uint32_t> colours = {};
    mesh::Palette palette = {};
    std::span<const PictureLegend> legend = {};  ///< of the palette; the plan view has its heights instead
    std::span<const PictureMark> marks = {};
    std::span<const PicturePath> path = {};
    std::string title = {};       ///< the program; UTF-8
    mesh::Mesh clamps = {};       ///< drawn so that the part is seen through them
    std::string clamp_name = {};  ///< of their entry in the legend; UTF-8
    /// The projections' cuts are at this y (front) and x (side); NaN: through the middle of the stock.
    geom::Vec2 cut{std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN()};
};

struct PictureSize {
    int width = 1200, height = 900;  ///< px; held between 200 and 4000
};

/// Bytes of a PNG file (24 bit). Without a surface, or where no coordinate can be used, a picture that says so. The
/// same scene gives the same bytes on one machine (fonts differ between machines). Throws std::bad_alloc only.
[[nodiscard]] std::string milling_png(MillingView view, const MillingScene& scene, PictureSize size = {});
/// An SVG document with the surface as an image and everything else as lines; as milling_png.
[[nodiscard]] std::string milling_svg(MillingView view, const MillingScene& scene, PictureSize size = {});

}  // namespace obrys::report::picture
