#pragma once
/// How two consecutive compensated elements meet. Inside of compensation.hpp; not for callers.

#include <optional>
#include <vector>

#include "path/curve.hpp"
#include "path/setting.hpp"

namespace obrys::path {

/// A programmed element held back by the compensation.
struct Item {
    enum class Role : std::uint8_t { approach, contour, retract };
    Element e;
    Setting s;
    double d0 = 0, d1 = 0;  ///< offset at start and end, mm, positive left
    Role role = Role::contour;
    Curve curve;                 ///< its parallel; meaningless for approach and retract
    geom::Vec2 start;            ///< where the compensated element begins …
    double begin = 0;            ///< … and that point's place on the curve
    std::vector<Element> after;  ///< elements without motion in the plane, due at its end
};

struct Join {
    geom::Vec2 a_end, b_start;
    double a_place = 0, b_place = 0;  ///< the same points on the curves
    std::optional<Element> inserted;  ///< between them
    bool link = false;                ///< inserted is a makeshift, not a transition round a corner
    bool trims = false;               ///< cuts into b: holds only if b's other end leaves something of b
    std::optional<Reason> fault;
};

/// a: approach or contour; b: contour or retract; not approach and retract.
[[nodiscard]] Join join(const Item& a, const Item& b);
/// Ends at the normals, with a straight piece between where they are apart.
[[nodiscard]] Join join_straight(const Item& a, const Item& b);
/// Approach and retract, approach.cpp.
[[nodiscard]] Join join_approach(const Item& a, const Item& b);
[[nodiscard]] Join join_retract(const Item& a, const Item& b);
/// Puts the arc about `corner` from a's end to b's start into `j`; `sweep` as the direction turns.
void insert_arc(Join& j, geom::Vec2 corner, double sweep, const Item& a, const Item& b);

}  // namespace obrys::path
