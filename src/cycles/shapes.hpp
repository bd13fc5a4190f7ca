#pragma once
/// Outlines of pockets, slots and studs, counter-clockwise; and what a contour's run and side make of it.

#include <cstdint>
#include <optional>
#include <vector>

#include "geom/contour.hpp"

namespace obrys::cycles {

/// About the origin; `corner` is at most half the shorter side.
[[nodiscard]] geom::Contour rectangle(double length, double width, double corner);
[[nodiscard]] geom::Contour disc(double radius);
/// Along u about the origin, ends round; length >= width.
[[nodiscard]] geom::Contour long_slot(double length, double width);
/// About the origin: all points within width / 2 of an arc of `radius` from the angle `from` over `sweep` radians
/// (either way round; a full turn and more gives the ring).
[[nodiscard]] geom::Region round_slot(double radius, double width, double from, double sweep);
/// Where a figure stands: turned about its origin, then shifted. Paths are computed about the origin and placed last,
/// so that the same figure is milled alike everywhere.
struct Placement {
    double angle = 0;  ///< radians
    geom::Vec2 at;
};
[[nodiscard]] geom::Vec2 placed(geom::Vec2 p, const Placement& where);
[[nodiscard]] geom::Contour placed(const geom::Contour& c, const Placement& where);
[[nodiscard]] geom::Region placed(const geom::Region& r, const Placement& where);
[[nodiscard]] inline geom::Contour placed(const geom::Contour& c, double angle, geom::Vec2 at) {
    return placed(c, Placement{angle, at});
}

enum class Subcontour : std::uint8_t { pocket, island };

/// A programmed closed contour is a pocket if the tool runs inside it, an island if it runs outside: inside is right of
/// a clockwise run and left of a counter-clockwise one. `side`: +1 tool on the left (RL, G41), -1 on the right (RR,
/// G42). None without compensation, for an open contour, and for one that encloses nothing. Source: iTNC 530 DIN/ISO
/// programming, overview of contour cycles, "radius compensation of the contour subprograms".
[[nodiscard]] std::optional<Subcontour> classify(const geom::Contour& c, int side);

struct ProgrammedContour {
    geom::Contour contour;
    Subcontour is = Subcontour::pocket;
};
/// All pockets together less all islands, as SL cycles without a formula superimpose them.
[[nodiscard]] geom::Region area_of(const std::vector<ProgrammedContour>& contours);

}  // namespace obrys::cycles
