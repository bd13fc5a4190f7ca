#pragma once
/// A body of revolution somewhere on a way, as it is searched through: the discs that it is the hull of, its halves, a
/// box around it. Millimetres.

#include <array>
#include <optional>
#include <vector>

#include "check/left/cuts.hpp"

namespace obrys::check {

/// A body whose tip is anywhere in a parallelepiped: its corner and three edges, some of which have no length.
struct LeftBody {
    geom::Vec3 corner;
    std::array<geom::Vec3, 3> edges;
    geom::Vec3 axis{0, 0, 1};         ///< unit length
    std::vector<geom::Vec2> profile;  ///< convex half section: radius and height, upwards, two points at least
    std::optional<ArcWay> arc;        ///< the way lies on it, and the parallelepiped around that piece
};

/// The body is their hull.
[[nodiscard]] std::vector<Disc> discs_of(const LeftBody& b);
[[nodiscard]] geom::Vec3 middle_of(const LeftBody& b);
[[nodiscard]] double widest(const LeftBody& b);
/// At a height between the ends of its profile.
[[nodiscard]] double radius_of(const LeftBody& b, double height);
/// Each of its lengths and its height in two, where they are no less than `thin_piece`.
[[nodiscard]] std::vector<std::array<LeftBody, 2>> halves_of(const LeftBody& b);
/// A parallelepiped around it, on a straight way, so that its discs can be cut, too.
[[nodiscard]] LeftBody boxed(const LeftBody& b);

inline constexpr double thin_piece = 1e-9;  ///< mm

}  // namespace obrys::check
