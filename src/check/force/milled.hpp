#pragma once
/// Force, power, torque and deflection of every milled move that cuts, and of which it is not known, and why.

#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "check/result.hpp"
#include "check/setup.hpp"
#include "shop/cutting.hpp"
#include "shop/material.hpp"

namespace obrys::check::force {

/// Why a move's force is not known.
enum class Gap : std::uint8_t { none, material, tool, teeth, spindle, feed, engagement };
[[nodiscard]] std::string_view text_of(Gap gap);

struct MoveForce {
    std::size_t move = 0;                ///< index in Milled::moves
    Gap gap = Gap::none;                 ///< else all figures are NaN
    double mean = NAN, peak = NAN;       ///< N: mean over a revolution of the resultant's size, and the largest
    double power = NAN;                  ///< W, at the spindle
    double torque = NAN;                 ///< Nm, mean over a revolution
    double deflection = NAN;             ///< mm at the tip by the largest side force; NaN: the tool is not known so far
    double feed_per_tooth = NAN;         ///< mm as planned
    double programmed_per_tooth = NAN;   ///< mm
    double cutting_speed = NAN;          ///< m/min at the highest engaged place
    double chip = NAN, mean_chip = NAN;  ///< mm: largest, mean
    double edge_part = NAN;              ///< of the torque, what the edge takes whatever the chip
    bool by_kienzle = false;             ///< else by the linear law
    bool extrapolated = false;           ///< chips that the material's law was not found for
};

/// What of a tool is not known that its deflection needs; empty: all is.
[[nodiscard]] std::string deflection_gap(const shop::Tool& tool, const shop::CuttingJob& job);

struct ForceResult {
    std::vector<MoveForce> moves;   ///< those that cut, in the order of the program
    std::vector<std::string> laws;  ///< name and source of those that were used
    bool ratios_assumed = false;    ///< of one of them
};

/// `planned`: part of its programmed feed that each of `result.milled->moves` goes at in the mean, 1 where nobody
/// knows.
/// `material` null: not known.
[[nodiscard]] ForceResult forces_of(const Result& result, const Setup& setup, const shop::CuttingJob& job,
                                    const shop::WorkMaterial* material, const std::vector<double>& planned);

}  // namespace obrys::check::force
