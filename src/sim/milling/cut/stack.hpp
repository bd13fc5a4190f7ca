#pragma once
/// How high, along a tool's axis, material stands above its lower side. Millimetres.

#include "geom/vec.hpp"

namespace obrys::sim::milling {

/// On one ray.
struct Stack {
    double height = 0, off = 0;  ///< off: of the ray from the way
    geom::Vec3 foot;             ///< its lower end
    /// Of equal ones the one nearest to the way.
    void take(const Stack& other) {
        constexpr double same = 1e-9;  // mm
        if (other.height > height + same || (other.height > height - same && other.off < off)) *this = other;
    }
};

/// The highest on rays that pass within nine tenths of the tool's radius (not at its rim, which rubs along walls).
struct Stacks {
    Stack seen;
    /// With what a point of the tool that lies between the rays reaches lower than these: on a level face that is as
    /// high as it is, of one that slants it may be too much.
    Stack to_tip;
};

}  // namespace obrys::sim::milling
