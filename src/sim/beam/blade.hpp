#pragma once
/// A blade while it is finished from its tip to its root: how it rings, how stiff it is where it is cut, and which
/// speeds of the spindle its tooth passing does not meet it at.

#include <cmath>
#include <optional>
#include <vector>

#include "shop/blade.hpp"

namespace obrys::sim::beam {

/// A harmonic of the tooth passing frequency so near a natural frequency that it rings.
struct Excitation {
    double tooth_passing = NAN;          ///< Hz
    int harmonic = 0;                    ///< the one nearest to the first natural frequency
    double ratio = NAN;                  ///< first natural frequency by that harmonic
    double amplification = NAN;          ///< of a static deflection, at the blade's damping
    double amplitude = NAN;              ///< mm at the cut; NaN: the force is not known
    bool rings = false;                  ///< one of the harmonics that count lies within a tenth of a natural frequency
    std::optional<double> better_speed;  ///< 1/min, the nearest that does not ring; of those that ring alone
};

struct Stage {
    double finished = 0;              ///< part of the length, from the tip
    std::vector<double> frequencies;  ///< Hz, three
    double tip_stiffness = 0;         ///< N/mm
    double cut_stiffness = 0;         ///< N/mm where the finished part ends
    double mass_g = 0;
    double root = 0, middle = 0, tip = 0;  ///< mm thick
    double stress_ratio = 0;               ///< of bending by a load at the tip, largest to mean
    std::optional<Excitation> excitation;
};

struct BladeResult {
    std::vector<Stage> stages;
    std::optional<double> common_speed;  ///< 1/min near the asked one at which no stage rings
};

/// How near a harmonic may lie to a natural frequency, as a part of it.
inline constexpr double too_near = 0.1;

[[nodiscard]] BladeResult study(const shop::Blade& blade, int elements = 80);

/// The harmonic of tooth passing that is nearest to a natural frequency, and how near.
[[nodiscard]] Excitation excitation(double speed, int teeth, double natural, double damping);

}  // namespace obrys::sim::beam
