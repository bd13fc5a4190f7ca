#pragma once
/// Exact removal in turning. Everything lies in the (z, x) plane: Vec2.x is z, Vec2.y is x as a radius; mm.
/// Regions are bounded by lines and arcs; nothing is sampled.

#include <cstdint>
#include <memory>
#include <optional>

#include "geom/contour.hpp"

namespace obrys::sim::turning {

/// One move of the programmed point: straight, or an arc about `centre` with `sweep` radians (counter-clockwise
/// positive in the (z, x) plane as drawn, z to the right, x up).
struct Move {
    geom::Vec2 from, to;
    geom::Vec2 centre;
    double sweep = 0;  ///< 0: straight
};

/// What one move took away.
struct Cut {
    geom::Region removed;
    geom::Region across;        ///< the part of it that the tool took from beyond the axis
    double area = 0;            ///< mm2
    double volume = 0;          ///< mm3, as a body of revolution
    double depth_x = 0;         ///< mm, largest extent of the removed material along x
    double contact_length = 0;  ///< mm, length of the tool's outline that touched material, at most along the move
};

/// The workpiece while it is being turned: a value. A copy costs what its contour has of edges, and is cut by itself.
class Workpiece {
public:
    explicit Workpiece(const geom::Region& stock);
    ~Workpiece();
    Workpiece(const Workpiece&);
    Workpiece& operator=(const Workpiece&);
    Workpiece(Workpiece&&) noexcept;
    Workpiece& operator=(Workpiece&&) noexcept;

    /// Sweeps `outline` (relative to the programmed point, counter-clockwise) along the move and removes it.
    /// The cost depends on what lies near the move, not on the number of moves made before.
    /// What passes below the axis removes the material that turns there: `across` does from a programmed point above
    /// the axis, all of `outline` from one below it.
    Cut cut(const geom::Contour& outline, const Move& move, const geom::Contour& across);
    Cut cut(const geom::Contour& outline, const Move& move) { return cut(outline, move, outline); }
    /// The material in which `body` would be somewhere along the move, on either side of the axis, `across` as above;
    /// nothing is removed.
    [[nodiscard]] geom::Region met(const geom::Contour& body, const Move& move, const geom::Contour& across) const;
    [[nodiscard]] geom::Region met(const geom::Contour& body, const Move& move) const { return met(body, move, body); }

    [[nodiscard]] geom::Region region() const;
    [[nodiscard]] double area() const;    ///< mm2
    [[nodiscard]] double volume() const;  ///< mm3

private:
    struct State;
    std::unique_ptr<State> state_;
};

/// How far a piece of material lies inside (or outside) a contour.
struct Depth {
    double area = 0;    ///< mm2
    double volume = 0;  ///< mm3
    double normal = 0;  ///< mm, largest distance of a point of the piece from the contour
    double along_x =
        0;  ///< mm, largest distance from the contour along x (the shorter way out); the axis is no contour
    geom::Vec2 deepest;  ///< the point with the largest normal depth
    geom::Region region;
};

/// The part of `removed` that lies inside `kept` and how deep; nothing where they do not overlap by more than
/// `tolerance`.
[[nodiscard]] std::optional<Depth> depth_inside(const geom::Region& removed, const geom::Region& kept,
                                                double tolerance);
/// A clean region (geom/contour.hpp) that many cuts are held against. Finding the overlap costs what lies near the cut;
/// measuring the depth of an overlap that was found looks at the box of every edge. Not for several threads at once.
class Kept {
public:
    explicit Kept(geom::Region region);
    ~Kept();
    Kept(Kept&&) noexcept;
    Kept& operator=(Kept&&) noexcept;

    /// As the function of this name.
    [[nodiscard]] std::optional<Depth> depth_inside(const geom::Region& removed, double tolerance) const;
    [[nodiscard]] const geom::Region& region() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

/// Connected pieces of `left` outside `wanted`, each with its depth above it; pieces nowhere deeper than `tolerance`
/// are dropped, and skins: pieces in which no circle of a tenth of `tolerance` has room.
[[nodiscard]] std::vector<Depth> pieces_outside(const geom::Region& left, const geom::Region& wanted, double tolerance);

}  // namespace obrys::sim::turning
