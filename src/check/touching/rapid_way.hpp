#pragma once
/// What is said about rapids that may bend, as their axes go each at its own speed (motion/rapid_way.hpp).

#include <string>

#include "check/setup.hpp"
#include "motion/rapid_way.hpp"

namespace obrys::check {

/// As the machine file says, else as the control does it.
[[nodiscard]] inline shop::RapidPath rapid_path(const Setup& setup) {
    return motion::rapid_path(setup.machine, setup.rapids.path);
}

/// That rapids are run bent, as the control is delivered.
[[nodiscard]] std::string bent_as_delivered(const Setup& setup);
/// That only the bent way of a rapid meets something: "the tool runs into the stock: …".
[[nodiscard]] std::string met_if_bent(const Setup& setup, const std::string& what);
inline constexpr const char* say_rapid_way =
    "say which in the machine file (rapid = \"straight\" or \"dog-leg\"), or move one axis after the other";

}  // namespace obrys::check
