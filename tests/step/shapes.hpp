#pragma once
/// Bodies that step_samples.cpp makes and writes as STEP: what they measure is known by formula. Millimetres.

#include <array>
#include <cstddef>
#include <map>
#include <string>

namespace obrys::step_test {

struct Shape {
    double volume = 0;       ///< mm3
    double low[3], high[3];  ///< extent
    std::size_t bodies = 1;
};

/// By name: block, ball, cone, ring, hollow, soft (all edges rounded), plate, apart, touching, turned (an assembly
/// whose two parts are one box in two places), shell (faces only), mixed (a block and a face beside it).
[[nodiscard]] const std::map<std::string, Shape>& shapes();

/// The STEP file of a shape, its numbers in "MM", "INCH" or "M". It is made by a program of its own: what is tested
/// here runs without Open CASCADE beside it, as obrys does.
[[nodiscard]] std::string step_text(const std::string& shape, const std::string& unit);

}  // namespace obrys::step_test
