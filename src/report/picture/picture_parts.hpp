#pragma once
/// What the views of a machined part have in common: the shot of the surface, rulers, dimensions, marks, legends.

#include <functional>
#include <string>
#include <vector>

#include "report/picture/milling_picture.hpp"
#include "report/picture/relief.hpp"
#include "report/picture/sheet.hpp"

namespace obrys::report::picture::picture {

/// On the sheet, px.
struct Rect {
    double left = 0, top = 0, width = 0, height = 0;
    [[nodiscard]] double right() const { return left + width; }
    [[nodiscard]] double bottom() const { return top + height; }
    [[nodiscard]] geom::Vec2 centre() const { return {left + width / 2, top + height / 2}; }
};

/// A picture that is being drawn.
struct Work {
    const MillingScene& scene;
    Sheet& sheet;
    const mesh::Shading& normals;
    mesh::Box box;     ///< what is shown, finite
    mesh::Box around;  ///< the same with the clamps, as far as there is room for them
    double width = 0, height = 0;
    double em = 13;        ///< size of ordinary words, px
    bool complete = true;  ///< as Visible says
};

/// Unit vectors to the right, upwards and to the eye.
struct Look {
    geom::Vec3 right, up, toward;
};
inline constexpr Look from_above{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
inline constexpr Look from_front{{1, 0, 0}, {0, 0, 1}, {0, -1, 0}};
inline constexpr Look from_left{{0, -1, 0}, {0, 0, 1}, {-1, 0, 0}};

/// The surface on its place of the sheet.
struct Shot {
    Camera camera;      ///< its x, y within the image
    geom::Vec2 corner;  ///< of the image on the sheet
    Visible visible;
    int finer = 1;

    [[nodiscard]] geom::Vec2 place(geom::Vec3 p) const;
    [[nodiscard]] Rect frame() const;
};

using ColourOf = std::function<mesh::Colour(const Spot&)>;
[[nodiscard]] mesh::Colour palette_colour(const MillingScene& scene, std::uint32_t triangle);

/// Draws the surface with the middle of the box in the middle of `area`, and the clamps over it, which may reach beyond
/// it. `cut`: a plane through this point, facing the eye, opens it.
[[nodiscard]] Shot shoot(Work& work, const Look& look, const Rect& area, double px_per_mm, const ColourOf& colour,
                         double ambient, const geom::Vec3* cut = nullptr);

/// Heights that flat areas lie at, seen from above, the larger areas first; at most eight. mm, to 0.01.
[[nodiscard]] std::vector<double> flat_heights(const Visible& seen, double base);

enum class Side : std::uint8_t { left, bottom };
/// Ticks with coordinates from `from` to `to` mm, which lie at the sheet's coordinates `first` and `last`.
struct Ruler {
    Side side;
    double at;  ///< the other coordinate on the sheet
    double from, to, first, last;
};
void draw(Work& work, const Ruler& ruler);

/// A dimension line between two places of the sheet, moved off them by `offset`.
void dimension(Work& work, geom::Vec2 a, geom::Vec2 b, geom::Vec2 offset, double mm);

void arrow(Work& work, geom::Vec2 from, geom::Vec2 to, const Pen& pen);
void outline(Work& work, const Rect& r, const Pen& pen);
void hatch(Work& work, const Rect& r, const Pen& pen);
/// The axes as the look shows them; each arrow two em long where it lies in the picture's plane.
void axes(Work& work, const Look& look, geom::Vec2 at);
void scale_bar(Work& work, double px_per_mm, geom::Vec2 at);
/// The workpiece's zero, where it is within the picture.
void datum(Work& work, const Shot& shot);
void path(Work& work, const Shot& shot);
void marks(Work& work, const Shot& shot);
void legend(Work& work, geom::Vec2 at);
/// The entry of the clamps alone; nothing where there are none.
void clamp_legend(Work& work, geom::Vec2 at);
void heading(Work& work, const std::string& what);

/// At most three decimals.
[[nodiscard]] std::string millimetres(double value);

void plan(Work& work);
void projections(Work& work);
void solid(Work& work);

inline constexpr mesh::Colour ink{30, 34, 40}, faint{150, 156, 164}, blue{20, 80, 170}, red{200, 30, 40},
    clamp{207, 138, 153};

}  // namespace obrys::report::picture::picture
