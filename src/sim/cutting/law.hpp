#pragma once
/// How hard a piece of cutting edge is pushed by its chip. N, mm.

#include <string>

#include "shop/material.hpp"

namespace obrys::sim::cutting {

/// Per mm of edge: along the cut against it, square to it away from the material, along the edge.
struct EdgeForce {
    double tangential = 0, radial = 0, axial = 0;
};

/// Below this thickness no chip forms, and the edge's force falls with the thickness to 0. mm.
inline constexpr double usual_least_chip = 0.001;

/// A material's law as numbers: cut * h^(1 - exponent) + edge, per mm of edge. With exponent 0 the linear law.
struct Law {
    EdgeForce cut, edge;
    double exponent = 0;
    double least_chip = 0;                     ///< mm; 0: the edge's force is there with any chip
    double thinnest = 0, thickest = INFINITY;  ///< mm: of the chips that it was found for
    bool ratios_assumed = false;               ///< of the radial and axial parts to the tangential one
    std::string name;                          ///< "Kienzle", "linear"
    std::string source;
};

/// What is usual for Kienzle's law, which says the tangential force alone: those of a tool with a usual rake.
inline constexpr double radial_ratio = 0.6, axial_ratio = 0.2;

[[nodiscard]] Law kienzle_law(const shop::KienzleLaw& law);
[[nodiscard]] Law linear_law(const shop::LinearLaw& law);
/// The one of a material that was found for chips like these, mm: Kienzle's, for thinner ones the linear one where
/// there is one.
[[nodiscard]] Law law_for(const shop::WorkMaterial& material, double chip);

/// Part of the edge's force that a chip of this thickness, above 0, has.
[[nodiscard]] double edge_share(const Law& law, double chip);
/// For a chip of this thickness; 0 where it is 0.
[[nodiscard]] EdgeForce force(const Law& law, double chip);

}  // namespace obrys::sim::cutting
