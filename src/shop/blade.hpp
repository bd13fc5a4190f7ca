#pragma once
/// A fan blade while it is milled from its blank. File format: docs/blade.md.

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "base/source.hpp"

namespace obrys::shop {

/// How thick a blade is from its root to its tip, mm.
struct BladeForm {
    enum class Kind : std::uint8_t {
        linear,    ///< from root to tip
        strength,  ///< with the root of the distance from the tip, never below `tip`: a load at the tip bends it evenly
        arc,       ///< each side an arc through root and tip: `radius` above 0 bulges, below 0 is hollow
        stations,  ///< straight between `stations`
    };
    Kind kind = Kind::linear;
    double root = 0, tip = 0;
    double radius = 0;
    struct Station {
        double at = 0, value = 0;  ///< mm from the root
    };
    std::vector<Station> stations;
};
[[nodiscard]] double value_at(const BladeForm& form, double x, double length);

struct Blade {
    std::string material;  ///< name of it as written; empty: the next two are given
    base::Span material_where{};
    double elasticity = 0;                              ///< N/mm2
    double density = 0;                                 ///< kg/m3
    double length = 0;                                  ///< mm
    BladeForm width, blank, finished;                   ///< mm
    double bending_factor = 1;                          ///< a curved section is stiffer than a flat one
    std::optional<double> root_stiffness;               ///< N m/rad of the clamping; nothing: it does not give way
    double damping = 0.005;                             ///< part of the critical one
    std::vector<double> stages{0, 0.25, 0.5, 0.75, 1};  ///< parts of the length that are finished, from the tip
    // The cut; nothing: not said.
    std::optional<double> speed, most_speed;  ///< 1/min
    std::optional<int> teeth;
    std::optional<double> force;  ///< N, amplitude at the tooth passing frequency
    int harmonics = 4;            ///< of tooth passing that count
};

}  // namespace obrys::shop
