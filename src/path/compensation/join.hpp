#pragma once
/// How two consecutive compensated elements meet. Inside of compensation.hpp; not for callers.

#include <optional>
#include <vector>

#include "geom/box.hpp"
#include "path/curve.hpp"
#include "path/setting.hpp"

namespace obrys::path {

/// A programmed element held back by the compensation.
struct Item {
    enum class Role : std::uint8_t {
        approach,
        contour,
        retract,
        transition,  ///< arc round an outer corner as an item of its own (clearance.hpp); e: that arc
        absent,      ///< an arc tighter than the tool, kept for its zone's neighbours (clearance.hpp)
    };
    Element e;
    Setting s;
    double d0 = 0, d1 = 0;  ///< offset at start and end, mm, positive left
    Role role = Role::contour;
    Curve curve;                 ///< its parallel; meaningless for approach, retract and absent
    geom::Vec2 start;            ///< where the compensated element begins …
    double begin = 0;            ///< … and that point's place on the curve
    std::vector<Element> after;  ///< elements without motion in the plane, due at its end
    double zone = 0;             ///< the offset where clearance is asked for and it is the same at both ends; 0: none
    geom::Box box;               ///< round the parallel
    std::uint64_t serial = 0;    ///< counts items in contour order
    bool loose = false;          ///< what followed was left out with a fault: a straight link is no second one
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
/// Contour points of consecutive elements farther apart than this are a gap, mm.
inline constexpr double gap = 1e-6;
/// Parallels of nearly tangent elements closer than this are linked without complaint, mm: programs are written to
/// 1e-3 mm, so that their tangents are never exact.
inline constexpr double blend = 1e-3;
/// Change of direction at an outer corner as the tool turns round it, half a turn back included; nothing at an inner
/// corner.
[[nodiscard]] std::optional<double> outer_turn(const Item& a, const Item& b);
/// The crossing that closes an outer corner, where the settings ask for one and it exists.
[[nodiscard]] std::optional<Crossing> outer_crossing(const Item& a, const Item& b, double turn);
/// Shorter of the two elements at a corner: the one that vanishes.
[[nodiscard]] const Item& shorter(const Item& a, const Item& b);
/// What remains of an element that is left out: its events and its motion along w.
[[nodiscard]] Element without_plane(const Element& e);
/// Approach and retract, approach.cpp.
[[nodiscard]] Join join_approach(const Item& a, const Item& b);
[[nodiscard]] Join join_retract(const Item& a, const Item& b);
/// Puts the arc about `corner` from a's end to b's start into `j`; `sweep` as the direction turns.
void insert_arc(Join& j, geom::Vec2 corner, double sweep, const Item& a, const Item& b);

}  // namespace obrys::path
