#pragma once
/// Whether a machined stock leaves a part by more than is allowed somewhere in a box: decided by distances from the
/// part and from all that tools have swept, not by rays or triangles of the machined surface. Millimetres.

#include <cstddef>
#include <cstdint>
#include <functional>

#include "mesh/distance.hpp"
#include "sim/milling/cut/air.hpp"

namespace obrys::check {

struct Claim {
    const mesh::Distance& part;
    const sim::milling::Air& air;
    bool gouge = false;  ///< air within the part; else material outside of it
    double allowed = 0;  ///< mm
    /// How much more is allowed in a ball about a point, at least (threads). Empty: nothing.
    std::function<double(geom::Vec3 p, double radius)> more = {};
    std::function<bool()> stop = {};  ///< asked now and then; what is not decided then is open
};

struct Proof {
    enum class Outcome : std::uint8_t {
        absent,   ///< nowhere in the box
        present,  ///< at `at`
        open,     ///< not decided within the effort that is allowed
    };
    Outcome outcome = Outcome::open;
    geom::Vec3 at;
    double deviation = 0;   ///< there, beyond what `more` allows; not negative
    std::uint32_t cut = 0;  ///< of a gouge: the first that took the place
};

/// `cells`: how many boxes may be looked at.
[[nodiscard]] Proof decide(const Claim& claim, const sim::milling::Box3& box, std::size_t cells);

}  // namespace obrys::check
