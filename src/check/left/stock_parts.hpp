#pragma once
/// Parts of tools as bodies that may meet material, and their passes. Frame of the stock, millimetres.

#include <cstdint>
#include <vector>

#include "geom/interpolation.hpp"
#include "sim/certify/certify.hpp"
#include "sim/milling/shape.hpp"

namespace obrys::check {

/// What cuts of a tool, its shank or its holder.
struct StockPart {
    sim::certify::Shape shape;
    /// Convex half sections around it: radius and height, upwards.
    std::vector<std::vector<geom::Vec2>> profiles;
    double radius = 0, bottom = 0, top = 0;
};

/// A pass that takes nothing.
struct StockPass {
    std::uint32_t number = 0;  ///< in the simulation
    geom::PathElement path;    ///< of the tip
    geom::Vec3 axis;           ///< unit length
    const StockPart* part = nullptr;
    std::uint32_t tool = 0;
    bool body = false;  ///< a shank or holder
};

struct StockHit {
    double depth = 0;  ///< 0: none
    geom::Vec3 at;
};

/// Round pieces by chords that stand off by no more than `off`; `certified`: the same of the shape.
[[nodiscard]] StockPart stock_part_of(const sim::milling::Shape& shape, double off, double certified);
/// The part of a profile between two heights; less than two points: nothing.
[[nodiscard]] std::vector<geom::Vec2> clipped(const std::vector<geom::Vec2>& profile, double low, double high);
/// Into how many chords a way is cut.
[[nodiscard]] std::size_t chords_of(const geom::PathElement& path, double off);

}  // namespace obrys::check
