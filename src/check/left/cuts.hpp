#pragma once
/// What cuts have taken of a stock, as far as a body is to be held to it: how far discs and points lie outside of each
/// cut, and what of the stock as it was lies around them. Exact or on the safe side: no rays, no samples. Millimetres.

#include <array>
#include <cstdint>
#include <deque>
#include <span>
#include <vector>

#include "check/left/turns.hpp"
#include "geom/interpolation.hpp"
#include "mesh/mesh.hpp"
#include "sim/milling/cut/air.hpp"
#include "sim/milling/cut/simulation.hpp"
#include "sim/milling/stock.hpp"

namespace obrys::check {

/// A disc about the axis of a moving body; radius 0: a point.
struct Disc {
    geom::Vec3 centre;
    double radius = 0;
};

/// A way of the tip on a circle about the tool's axis.
struct ArcWay {
    geom::Vec3 centre;
    double radius = 0;
    geom::Vec3 from, to;  ///< less than half a turn apart
};

/// A convex part of a tool with what it took on its way: convex, but for quarter circles.
class LeftCut {
public:
    LeftCut(const sim::milling::Air::Sweep& sweep, std::size_t first, std::size_t end);
    /// How far any point of a disc normal to `axis` lies outside, at most; at least the largest distance, and that
    /// itself where the axes are one.
    [[nodiscard]] double farthest(const Disc& disc, geom::Vec3 axis) const;
    /// The same of all that lies between discs (their convex hull); ends where it is `enough` or more.
    [[nodiscard]] double farthest(std::span<const Disc> discs, geom::Vec3 axis, double enough) const;
    /// The same for a disc on a circle of its own: one number all the way, where this is a circle about the same place.
    [[nodiscard]] double farthest(const Disc& disc, const ArcWay& way, geom::Vec3 axis) const;
    /// Towards the point of the disc that lies farthest outside.
    [[nodiscard]] geom::Vec3 outwards(const Disc& disc) const;
    /// Whether it took all of a box but for what lies no more than `off` outside.
    [[nodiscard]] bool holds(const std::array<geom::Vec3, 8>& corners, double off) const;
    [[nodiscard]] geom::Vec3 axis() const { return sweep_->frame.z; }
    [[nodiscard]] const mesh::Box& box() const { return box_; }

private:
    [[nodiscard]] double beside(double radial, double height) const;
    [[nodiscard]] double on_way(geom::Vec3 p, double radius) const;
    [[nodiscard]] double from_arc(geom::Vec2 p) const;
    [[nodiscard]] bool in_wedge(geom::Vec2 from_centre) const;

    const sim::milling::Air::Sweep* sweep_;
    std::span<const sim::milling::Piece> pieces_;
    double widest_ = 0;
    mesh::Box box_;
};

/// Those of a simulation's that were made before a pass; ways that go on as the one before are one, and full turns are
/// bodies, too.
class LeftCuts {
public:
    LeftCuts(const sim::milling::Air& air, const sim::milling::Simulation& simulation, std::uint32_t before);
    LeftCuts(const LeftCuts&) = delete;
    LeftCuts& operator=(const LeftCuts&) = delete;
    [[nodiscard]] const std::vector<LeftCut>& all() const { return all_; }
    /// Whether one straight cut of a tool has taken all that the same tool comes through on a straight way: on the
    /// cut's own or over it, as far as the stock goes up along the axis.
    [[nodiscard]] bool hold_way(const sim::milling::Shape& own, const geom::Straight& way, geom::Vec3 axis,
                                double stock_top) const;
    /// Whether a tool has been at a place, cutting: then all that it holds there is taken.
    [[nodiscard]] bool was_at(const sim::milling::Shape& own, geom::Vec3 tip, geom::Vec3 axis) const;

private:
    std::deque<sim::milling::Air::Sweep> sweeps_;
    LeftTurns turns_;
    std::vector<LeftCut> all_;
};

/// How deep any point of the hull of some discs lies in a stock, at most; `middle` is any point among them.
[[nodiscard]] double deepest_in(const sim::milling::Stock& stock, const sim::milling::Air& air,
                                std::span<const Disc> discs, geom::Vec3 axis, geom::Vec3 middle);

}  // namespace obrys::check
