#pragma once
/// Both contours of a groove: what roughing leaves and what is finished, each as a left and a right side that run down
/// to one flat bottom.

#include <variant>
#include <vector>

#include "cycles/groove/groove.hpp"

namespace obrys::cycles::groove {

/// A line, or an arc about `centre`; `sweep` in radians, counter-clockwise positive, 0 for a line.
struct Piece {
    Vec2 from, to, centre;
    double sweep = 0;
    [[nodiscard]] double u_at(double v) const;  ///< of a piece on which v is reached once
};

/// One side, from the surface to the bottom's flat. `edge` and `corner` are those of the sharp lines.
struct Wall {
    Vec2 edge, corner;
    std::vector<Piece> pieces;
    [[nodiscard]] Vec2 top() const { return pieces.front().from; }
    [[nodiscard]] Vec2 foot() const { return pieces.back().to; }
};

struct Contour {
    std::array<Wall, 2> walls;  ///< by Side
    double bottom = 0;
    double slope = 0;  ///< of the surface

    [[nodiscard]] const Wall& wall(Side s) const { return walls[index(s)]; }
    [[nodiscard]] double flat() const { return wall(Side::right).foot().x - wall(Side::left).foot().x; }
    [[nodiscard]] double surface(double u) const;
    /// u where the side has height v; above its edge it goes on along the surface, or straight up where that is level.
    [[nodiscard]] double u_of(Side side, double v) const;
    /// Height of the side's contour; of its lowest point where it is a straight wall there.
    [[nodiscard]] double v_of(Side side, double u) const;
    /// How deep a sharp blade may go with its left edge at u.
    [[nodiscard]] double reach(double u, double blade) const;
    [[nodiscard]] double crest() const;  ///< height of the higher edge, corner elements with it
    [[nodiscard]] double area() const;   ///< between surface and contour, mm2
};

struct Contours {
    Contour rough;  ///< with allowances, edges sharp
    Contour finished;
};

[[nodiscard]] std::variant<Contours, Refusal> contours_of(const Shape& shape, double blade);
/// The rest of the guards that no contour decides.
[[nodiscard]] std::optional<Refusal> refused(const Request& request, const Contours& contours);

/// The two corner pieces' places: how far an element of this size reaches along its sides, by the angle between the
/// directions before and behind it.
[[nodiscard]] double leg_of(const Corner& corner, double turn);

}  // namespace obrys::cycles::groove
