#pragma once
/// How deep a moving tool goes into a part, by geometry: no rays, no samples, so nothing is too narrow to be seen.
/// Millimetres.
///
/// A tool is a union of convex bodies, and what such a body sweeps on a straight way is convex. Made smaller by an
/// amount so that a ball of that radius covers the difference, it either meets no triangle of the part and lies outside
/// of it: then no point of the tool is deeper in the part than that, and no point of the part's surface deeper in the
/// tool. Or it does: then the depth is looked for. Curved ways are cut into chords until what lies between is a
/// twentieth of what is allowed; that counts as depth.

#include <cstdint>
#include <functional>
#include <limits>
#include <vector>

#include "geom/interpolation.hpp"
#include "mesh/distance.hpp"
#include "sim/certify/body.hpp"

namespace obrys::sim::certify {

/// A tool that moves with its axis held.
struct Move {
    geom::PathElement path;    ///< of the programmed point
    geom::Vec3 axis{0, 0, 1};  ///< from the tip to the holder, any length
    const Shape* shape = nullptr;
};

/// How deep, and where.
struct Depth {
    /// How far the tool went past the surface along its normal, to `accuracy`; 0: nothing is deeper than allowed.
    double depth = 0;
    double upper = std::numeric_limits<double>::infinity();  ///< certainly nothing is deeper
    geom::Vec3 at;                                           ///< the deepest place of the tool
    geom::Vec3 surface;                                      ///< the part's surface nearest to it
    geom::Vec3 normal;                                       ///< out of the part there
    std::uint32_t triangle = 0;
    double width = 0;   ///< of the tool in the surface there, across the way where it moves along the surface
    double along = 0;   ///< of the way, 0 … 1: where the tool stands
    bool edge = false;  ///< an edge of the part is taken off; `depth` is that of the edge in the tool
    mesh::Box extent;   ///< around what of the part's surface the tool was found in
};

class Judge {
public:
    /// The part must be closed and outlives the judge. `within` says of a place how deep it lies in the material there
    /// was before anything was cut, negative beside it; empty: everywhere.
    Judge(const mesh::Distance& part, double allowed, std::function<double(geom::Vec3)> within = {});

    /// Whether certainly nothing is deeper than allowed; in a microsecond or so. Of moves that are not finite: false.
    [[nodiscard]] bool is_clear(const Move& move) const;
    /// Of moves that are not clear. From several threads at once, like `is_clear`.
    [[nodiscard]] Depth deepest(const Move& move) const;
    /// A depth that is reached, found in a tenth of the time; 0 where none was found.
    [[nodiscard]] double rough(const Move& move) const;
    [[nodiscard]] double allowed() const { return allowed_; }

private:
    /// A chord of the way and one of the tool's bodies, which are not clear.
    struct Piece {
        Swept whole;
        double u0 = 0, u1 = 1;
        double off = 0;  ///< how far the way may lie from the chord
    };
    struct Spot {
        double depth = -std::numeric_limits<double>::infinity();
        geom::Vec3 at;
        mesh::Nearest place;
        std::size_t piece = 0;
    };
    [[nodiscard]] bool clear_between(const Move& move, double u0, double u1, double depth,
                                     std::vector<Piece>* failing) const;
    [[nodiscard]] bool clear_piece(const Swept& whole, double depth) const;
    [[nodiscard]] bool meets(const Swept& inner) const;
    [[nodiscard]] std::vector<std::uint32_t> met_by(const Swept& inner) const;
    [[nodiscard]] double upper_bound(const Move& move, double from) const;
    [[nodiscard]] Spot spot_at(geom::Vec3 p) const;
    [[nodiscard]] geom::Vec3 inwards_at(const Spot& spot) const;
    [[nodiscard]] Spot climb(const Swept& whole, Spot from, int steps) const;
    [[nodiscard]] std::vector<Spot> starts_in(const Swept& whole, std::size_t most, mesh::Box& extent) const;
    [[nodiscard]] Spot polished(const Swept& whole, Spot best) const;
    [[nodiscard]] std::vector<Spot> around(const Swept& whole, const std::vector<Spot>& starts) const;
    [[nodiscard]] Spot deepest_of(const Swept& whole, mesh::Box& extent) const;
    [[nodiscard]] double edge_depth(const Swept& whole, double depth, double most) const;
    [[nodiscard]] double reach_along(const Swept& whole, geom::Vec3 from, geom::Vec3 direction) const;

    const mesh::Distance& part_;
    mesh::Box box_;
    double allowed_ = 0.01;
    std::function<double(geom::Vec3)> within_;
};

}  // namespace obrys::sim::certify
