#include "check/gouge/unshown.hpp"

#include <algorithm>
#include <cmath>

namespace obrys::check {

namespace milling = sim::milling;

using geom::Vec3;

namespace {

constexpr double share = 0.5;  ///< of the height: no material nearer than so to its highest point

bool is_near(const milling::Box3& box, Vec3 p, Vec3 by) {
    return p.x >= box.min.x - by.x && p.x <= box.max.x + by.x && p.y >= box.min.y - by.y && p.y <= box.max.y + by.y &&
           p.z >= box.min.z - by.z && p.z <= box.max.z + by.z;
}

/// How far all about a place nothing is, at least.
double empty_around(const milling::Simulation& simulation, Vec3 p, double reach) {
    const Vec3 more{reach, reach, reach};
    const milling::Air air = simulation.whole_air_in({p - more, p + more});
    double empty = 0;
    for (std::size_t b = 0; b < air.bodies(); ++b) empty = std::max(empty, -air.outside(b, p));
    return empty;
}

}  // namespace

void drop_unfollowed(std::vector<mesh::Place>& excesses, std::span<const milling::Box3> open,
                     const Machined& machined) {
    const Vec3 step = machined.simulation.dexels().lattice().step;
    std::erase_if(excesses, [&](const mesh::Place& p) {
        if (std::none_of(open.begin(), open.end(), [&](const milling::Box3& b) { return is_near(b, p.at, step); }))
            return false;
        const double off = std::max(machined.simulation.tolerance(), share * std::abs(p.deviation));
        return empty_around(machined.simulation, p.at, off) > off;
    });
}

}  // namespace obrys::check
