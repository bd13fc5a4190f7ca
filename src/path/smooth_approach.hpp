#pragma once
/// Moves onto a compensated contour and off it that the control builds itself: straight or circular, tangential or
/// normal to the contour. Pure functions; input is programmed geometry, output is the path of the tool's centre, to be
/// pushed with Approach::ready (setting.hpp), which leaves it as it is. Plane coordinates as in element.hpp.
///
/// HEIDENHAIN words and where their meaning is taken from (iTNC 530, TNC 410, TNC 426/430 and TNC 407 User's Manual,
/// "Contour approach and departure"; TNC7 User's Manual, "Approach functions"):
///   APPR LT, DEP LT    line on the tangent; P_H (P_N) is LEN away from the contour point
///   APPR LN, DEP LN    line on the normal, on the tool's side; P_H (P_N) is LEN + tool radius from the contour point:
///                      the centre travels LEN
///   APPR CT, DEP CT    arc of R and CCA (up to a full turn), tangential. R > 0 curves to the side of the compensation:
///                      RL counter-clockwise, RR clockwise; R < 0 the other way, from the side of the workpiece
///   APPR LCT, DEP LCT  arc of R tangential to the contour, then the line that is tangential to it and runs to P_S (to
///                      P_N), like a rounded corner; R > 0. The manual names only LN and CT where R0 fixes a
///                      direction: hence the arc lies on the side of the tangent where P_S (P_N) lies
///   R0 in the block    as RR with tool radius 0, on the way to the contour and off it
///   compensated        P_S and P_N are positions of the centre (R0); P_A, P_E and, in the manual's pictures, P_H carry
///                      the compensation: from P_S a straight line runs to the compensated P_H
///   polar forms        PLT PLN PCT PLCT only give P_A (P_N) in polar coordinates
///   motion along w     see WMove
///   not modelled       a DEP block with RL or RR, an APPR block without change of compensation (TNC 410), helices
/// R is the radius of the path that the tool's centre runs (iTNC 530 User's Manual, "Radius R of the circular arc"), so
/// that any tool fits: ArcOf::centre. ArcOf::contour makes it the radius that the edge cuts. Not found in words: LEN +
/// tool radius of LN in the text at hand (the TNC7 manual: LEN is the distance of P_H to the contour; the sum is how we
/// know the iTNC 530 manual).

#include <cstdint>
#include <vector>

#include "path/element.hpp"
#include "path/setting.hpp"

namespace obrys::path {

enum class SmoothKind : std::uint8_t {
    tangent_line,  ///< LT
    normal_line,   ///< LN
    tangent_arc,   ///< CT
    arc_and_line,  ///< LCT
};
/// What R measures: the arc that the tool's edge would cut, or the arc of the tool's centre.
enum class ArcOf : std::uint8_t { contour, centre };
/// Where the motion along w takes place, if there is one. iTNC 530: in an approach after the move to P_H in the plane
/// (LCT with all three axes in the block: together with it); in a departure after the moves in the plane, older
/// editions of the manual: at P_H.
enum class WMove : std::uint8_t { at_auxiliary, together, outside };

struct SmoothShape {
    SmoothKind kind = SmoothKind::tangent_line;
    double length = 0;  ///< LEN, mm, lines
    double radius = 0;  ///< R, mm; negative (CT): the arc lies on the other side
    double angle = 0;   ///< CCA, radians, CT
    ArcOf arc_of = ArcOf::contour;
    WMove w_move = WMove::at_auxiliary;
    bool operator==(const SmoothShape&) const = default;
};

/// The end that lies on the contour.
struct ContourEnd {
    geom::Vec2 at;         ///< P_A or P_E as programmed
    geom::Vec2 direction;  ///< of the contour there, in the sense of motion, any length
    Side side = Side::right;
    double tool_radius = 0;  ///< mm; with Side::off it is taken as 0 on the right
    double w = 0;
};
/// The other end, a position of the centre. For a departure by LT, LN, CT only w is used.
struct OuterEnd {
    geom::Vec2 at;
    double w = 0;
};

enum class SmoothFailure : std::uint8_t {
    none,
    bad_length,        ///< LEN is not above 0
    bad_radius,        ///< R is 0; or negative in LCT
    bad_angle,         ///< CCA is not above 0 and up to a full turn
    bad_direction,     ///< the contour has no direction there
    not_a_number,      ///< some input is not known (NaN) or not finite
    tool_too_large,    ///< the tool's radius exceeds R where the tool runs inside the arc
    inside_of_circle,  ///< P_S (P_N) lies inside the circle of LCT: there is no tangent
};

/// `path` leads from P_S to the compensated P_A, or from the compensated P_E to P_N: connected elements that move, none
/// where there is nothing to move. Empty with a failure.
struct SmoothPath {
    SmoothFailure failure = SmoothFailure::none;
    geom::Vec2 auxiliary;  ///< P_H of the centre (LT, LN, CT departures: P_N)
    geom::Vec2 contour;    ///< P_A or P_E of the centre
    std::vector<Element> path{};
    [[nodiscard]] bool ok() const { return failure == SmoothFailure::none; }
};

[[nodiscard]] SmoothPath smooth_approach(const OuterEnd& start, const ContourEnd& contour, const SmoothShape& shape);
[[nodiscard]] SmoothPath smooth_departure(const ContourEnd& contour, const OuterEnd& end, const SmoothShape& shape);

}  // namespace obrys::path
