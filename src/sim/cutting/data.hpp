#pragma once
/// Cutting data: what follows from what is given of speed, feed, depth and tool, and what a machine makes of it.
/// mm, mm/min, m/min, 1/min, W, Nm, degrees only in texts. NaN: not known.

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "shop/material.hpp"

namespace obrys::sim::cutting {

enum class Process : std::uint8_t { milling, drilling, turning };

/// What cutting data are made of. Of turning the feed per tooth is that per revolution, `teeth` 1, the diameter that
/// of the workpiece.
enum class Value : std::uint8_t {
    diameter,
    effective_diameter,
    teeth,
    cutting_speed,  ///< m/min at the effective diameter
    speed,          ///< 1/min
    feed_per_tooth,
    feed,  ///< mm/min
    depth,
    width,    ///< of milling, square to depth and feed
    chip,     ///< mean thickness
    removal,  ///< cm3/min
};
inline constexpr std::size_t values = 11;
/// As the option and the key in JSON say it.
inline constexpr std::array<std::string_view, values> value_names{"diameter", "d-eff", "teeth", "vc", "rpm",    "fz",
                                                                  "vf",       "ap",    "ae",    "hm", "removal"};

using Values = std::array<double, values>;

struct Asked {
    Process process = Process::milling;
    Values given;  ///< NaN: not given
    double corner_radius = 0;
    bool ball = false;            ///< the corner radius is half the diameter
    double tilt = 0;              ///< radians
    double entering_angle = NAN;  ///< radians: turning; NaN: 90 degrees
    double point_angle = NAN;     ///< radians: drilling; NaN: 118 degrees
    double nose_radius = NAN;     ///< turning
    const shop::WorkMaterial* material = nullptr;

    Asked() { given.fill(NAN); }
    double& operator[](Value v) { return given[static_cast<std::size_t>(v)]; }
    double operator[](Value v) const { return given[static_cast<std::size_t>(v)]; }
};

/// What a machine can do; infinite or 0: not limited.
struct MachineLimits {
    double least_speed = 0, most_speed = std::numeric_limits<double>::infinity();  ///< 1/min
    double most_feed = std::numeric_limits<double>::infinity();                    ///< mm/min
    double most_power = std::numeric_limits<double>::infinity();                   ///< W
};

/// Two ways to a value that do not agree.
struct Difference {
    Value value = Value::feed;
    double given = 0, computed = 0;
};

struct Data {
    Values values;
    double power = NAN;                   ///< W, at the spindle
    double torque = NAN;                  ///< Nm
    double specific_force = NAN;          ///< N/mm2
    double thickest_chip = NAN;           ///< mm
    double rz = NAN, ra = NAN;            ///< micrometres, of the tool's form and feed alone
    double length_per_min = NAN;          ///< of turning: path along the workpiece, mm/min
    std::string law;                      ///< by which law of the material; empty: none
    bool extrapolated = false;            ///< chips that the law was not found for
    std::vector<std::string> clamped_by;  ///< keys of the machine file
    std::vector<Difference> differences;  ///< given values that contradict each other
    bool feed_implausible = false;        ///< no tool of this size cuts with so much per tooth
    bool impossible = false;              ///< the spindle does not turn so slowly
    Data() { values.fill(NAN); }
    double& operator[](Value v) { return values[static_cast<std::size_t>(v)]; }
    double operator[](Value v) const { return values[static_cast<std::size_t>(v)]; }
};

/// What follows, with the machine's limits: a speed that it does not have is its nearest, at the same feed per tooth;
/// a feed that it does not have is its highest, at the same speed; a power that it does not have is met by less speed.
[[nodiscard]] Data solve(const Asked& asked, const MachineLimits& limits);

}  // namespace obrys::sim::cutting
