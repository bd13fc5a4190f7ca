#pragma once
/// One element of a programmed contour in the working plane, before it becomes a tool path: corner insertion and
/// radius compensation work on these. Plane coordinates (u, v) are right-handed seen against the plane normal
/// (G17: X Y, G18: Z X, G19: Y Z), w runs along the normal; millimetres and radians.

#include <cmath>
#include <cstdint>

#include "geom/vec.hpp"
#include "path/events.hpp"

namespace obrys::path {

/// Points closer than this are one point, mm.
inline constexpr double same_point = 1e-9;

/// A line (sweep 0) or an arc about `centre`; sweep positive counter-clockwise, |sweep| may exceed a full turn.
/// The radii at both ends may differ by the control's tolerance for arcs. A change of w makes it inclined or helical.
struct Element {
    geom::Vec2 from, to;
    double w_from = 0, w_to = 0;
    geom::Vec2 centre;
    double sweep = 0;
    std::uint64_t tag = 0;  ///< the caller's: index of the block or source span; never interpreted here
    Events before{};        ///< the caller's events (feed change, M function …) due before this element, in order
    bool operator==(const Element&) const = default;
};

[[nodiscard]] inline bool is_arc(const Element& e) { return e.sweep != 0; }
/// moves_in_plane of what is not long at the first look.
[[nodiscard]] bool hardly_moves_in_plane(const Element& e);
/// False where the plane coordinates stay (a plunge along w, or nothing at all).
[[nodiscard]] inline bool moves_in_plane(const Element& e) {
    constexpr double clearly = 1e-3;  // mm, rad: together still far above same_point
    const geom::Vec2 way = is_arc(e) ? e.from - e.centre : e.to - e.from;
    const bool is_long = std::abs(way.x) > clearly || std::abs(way.y) > clearly;
    return (is_long && (!is_arc(e) || std::abs(e.sweep) > clearly)) || hardly_moves_in_plane(e);
}
/// False where nothing moves at all.
[[nodiscard]] inline bool moves(const Element& e) {
    return moves_in_plane(e) || std::abs(e.w_to - e.w_from) > same_point;
}
/// Unit tangents in the direction of motion; require moves_in_plane.
[[nodiscard]] geom::Vec2 start_direction(const Element& e);
[[nodiscard]] geom::Vec2 end_direction(const Element& e);
/// The last of these, reckoned only where it is asked for: of every element of a contour it is kept, of few it is
/// needed.
class EndDirection {
public:
    EndDirection() = default;
    /// A vector that need be no unit vector.
    explicit EndDirection(geom::Vec2 direction) : way_(direction) {}
    explicit EndDirection(const Element& e)
        : way_(is_arc(e) ? e.to - e.centre : e.to - e.from), sweep_(e.sweep), of_element_(true) {}
    [[nodiscard]] geom::Vec2 get() const;

private:
    geom::Vec2 way_;  ///< of an arc: from the centre to its end
    double sweep_ = 0;
    bool of_element_ = false;
};
/// Length in the plane, mm.
[[nodiscard]] double planar_length(const Element& e);
/// The plane point at a fraction 0 … 1 of the element; an arc whose end radii differ runs as a spiral.
[[nodiscard]] geom::Vec2 point_at(const Element& e, double fraction);
/// Change of direction from a to b at their common point, -π … π, positive to the left.
[[nodiscard]] double turn_between(geom::Vec2 a, geom::Vec2 b);

[[nodiscard]] Element line(geom::Vec2 from, geom::Vec2 to, double w = 0);
/// End point from the sweep.
[[nodiscard]] Element arc(geom::Vec2 from, geom::Vec2 centre, double sweep, double w = 0);
[[nodiscard]] geom::Vec2 rotated(geom::Vec2 v, double angle);

}  // namespace obrys::path
