#pragma once
/// Where an inner corner moves the end of the held move to. Inside of held_move.hpp; not for callers.
/// All points are of the tool's centre unless said otherwise; `offset` is positive where it runs left of the motion.

#include <cmath>

#include "path/element.hpp"
#include "path/setting.hpp"

namespace obrys::path {

/// What a corner needs to know of the move before it.
struct HeldEnd {
    bool arc = false;
    geom::Vec2 to, centre;
    double turn = 0;  ///< of an arc: +1 counter-clockwise, -1 clockwise
};

/// A corner between the move that ends at `to` and one that sets out in `direction`.
struct HeldTurn {
    geom::Vec2 point;      ///< programmed
    geom::Vec2 to;         ///< the held move's end without regard to the corner
    geom::Vec2 along;      ///< unit tangent at that end
    geom::Vec2 direction;  ///< unit tangent of the move that follows
    double offset = 0;
    double sine = 0, cosine = 1;  ///< of the change of direction, positive away from the tool

    /// A change by less than the angle of this tangent, from straight on or from half a turn, is neither.
    [[nodiscard]] bool inner(double tangent) const { return sine < -tangent * std::abs(cosine); }
    [[nodiscard]] bool outer(double tangent) const { return sine > tangent * std::abs(cosine); }
    [[nodiscard]] bool forwards() const { return cosine > 0; }
};

struct Meeting {
    geom::Vec2 at;
    Refusal refusal = Refusal::none;
};

/// Of `to` for an offset, at the programmed point, with the tangent of the move that follows.
[[nodiscard]] HeldTurn turn_at(geom::Vec2 point, geom::Vec2 to, geom::Vec2 direction, double offset);
/// Tangent of the arc about `centre` where it leaves `point`; +1 counter-clockwise.
[[nodiscard]] geom::Vec2 leaving(geom::Vec2 point, geom::Vec2 centre, double turn);
/// True where a tool with this offset runs on the arc's inner side.
[[nodiscard]] constexpr bool runs_inside(double offset, double turn) { return offset * turn > 0; }
/// Length; half the time of hypot, which keeps very long and very short ones: on every move.
[[nodiscard]] inline double quick_length(geom::Vec2 v) { return std::sqrt(geom::dot(v, v)); }
/// Unit vector; along the first axis for a vector without length.
[[nodiscard]] inline geom::Vec2 unit(geom::Vec2 v) {
    const double l = quick_length(v);
    return l == 0 ? geom::Vec2{1, 0} : (1 / l) * v;
}

/// Line to line: both parallels cross.
[[nodiscard]] Meeting line_meets_line(const HeldTurn& t);
/// Arc to line. The arc is the held one, already the centre's.
[[nodiscard]] Meeting arc_meets_line(const HeldTurn& t, const HeldEnd& held);
/// Line to arc about `centre`; `radius`: from the centre to its programmed end.
[[nodiscard]] Meeting line_meets_arc(const HeldTurn& t, geom::Vec2 centre, double radius, double turn);
[[nodiscard]] Meeting arc_meets_arc(double offset, const HeldEnd& held, geom::Vec2 centre, double radius, double turn);

}  // namespace obrys::path
