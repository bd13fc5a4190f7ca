#pragma once
/// A tool as a union of convex solids of revolution. Frame of the tool: the axis is z, the tip (the programmed point)
/// lies at 0, the holder above. Millimetres.

#include <cstdint>
#include <optional>
#include <vector>

#include "geom/vec.hpp"

namespace obrys::sim::milling {

/// A height, or a place on a ray, that is not met.
inline constexpr double never = std::numeric_limits<double>::infinity();

enum class PieceKind : std::uint8_t {
    cone,   ///< radius r0 at z0 to r1 at z1, straight: cylinder, frustum, cone
    round,  ///< radius ring + sqrt(arc^2 - (z - centre)^2): zone of a ball (ring 0) or the outer half of a torus
};

/// One convex solid between the planes z0 and z1, with whatever its ends leave open closed by discs.
struct Piece {
    PieceKind kind = PieceKind::cone;
    double z0 = 0, z1 = 0;
    double r0 = 0, r1 = 0;  ///< radii at z0 and z1, of both kinds
    double ring = 0, centre = 0, arc = 0;
    /// The rest of the ball, or of the disc with a round rim, lies inside other pieces, so that it may be taken whole.
    bool whole = false;
    /// The piece below is at least as wide where they meet: no ray from below enters through the lower disc.
    bool covered = false;
};
[[nodiscard]] Piece cylinder(double z0, double z1, double r);
[[nodiscard]] Piece cone(double z0, double z1, double r0, double r1);
[[nodiscard]] Piece round(double z0, double z1, double ring, double centre, double arc);

/// Radius at a height between z0 and z1.
[[nodiscard]] double radius_at(const Piece& piece, double z);
/// The end of the pieces from `first` on that are convex together: no neck, no step.
[[nodiscard]] std::size_t convex_end(const std::vector<Piece>& pieces, std::size_t first);
/// Largest radius between two heights; negative where the piece does not reach there.
[[nodiscard]] double widest_between(const Piece& piece, double low, double high);
struct Heights {
    double low = 0, high = 0;
};
/// Where a line parallel to the axis at this distance runs inside.
[[nodiscard]] std::optional<Heights> heights_at(const Piece& piece, double distance);
/// Convex, 0 on the surface, the distance from the nearest face with its sign (negative inside) wherever that face is
/// the nearest part of the solid; `normal`: its gradient, of unit length.
[[nodiscard]] double outside(const Piece& piece, geom::Vec3 p, geom::Vec3& normal);

/// What two pieces, one upon the other, hold of both their sides gone on with: convex, within the two. The disc between
/// them is no surface of the tool; each piece alone ends there, this goes through it.
struct Bridge {
    Piece lower, upper;
};
[[nodiscard]] double outside(const Bridge& bridge, geom::Vec3 p, geom::Vec3& normal);

/// Pieces from the tip upwards, without gaps or overlaps.
struct Shape {
    std::vector<Piece> pieces;
    std::vector<Bridge> bridges;  ///< between a piece and the next
    double bottom = 0, top = 0, radius = 0;
    bool rising =
        false;  ///< the radius never decreases upwards: what lies above the tool's lower side is cut up to its top
};
/// How far a point inside lies from the surface, at least: 0 outside. Where two pieces meet there is no surface.
[[nodiscard]] double depth_in(const Shape& shape, geom::Vec3 p);
/// Fills in what follows from the pieces.
[[nodiscard]] Shape make_shape(std::vector<Piece> pieces);
[[nodiscard]] double widest_between(const Shape& shape, double low, double high);
/// Lower side at this distance from the axis; infinite beyond the radius.
[[nodiscard]] double lower_side(const Shape& shape, double distance);

}  // namespace obrys::sim::milling
