#include "sim/force/deflection.hpp"

#include "geom/vec.hpp"

namespace obrys::sim::force {

namespace {

double inertia(double diameter) { return geom::pi * diameter * diameter * diameter * diameter / 64; }
double cube(double v) { return v * v * v; }

}  // namespace

double stiffness(const ToolBeam& t) {
    const double length = t.flutes + t.shank;
    const double flutes = cube(t.flutes) / (3 * inertia(t.core * t.diameter));
    const double shank = (cube(length) - cube(t.flutes)) / (3 * inertia(t.diameter));
    return 1 / ((flutes + shank) / t.elasticity + 1 / t.holder);
}

}  // namespace obrys::sim::force
