#pragma once
/// How fast a place where the path turns may be gone through, so that the control stays within a tolerance. mm, s.
/// Source: shared spec physics.md (a) 2: a triangular time filter rounds the corner (deviation v tau s/6, acceleration
/// 4 v s/tau, jerk 8 v s/tau^2, s the sine of half the turn), or an arc is laid into it.

#include <array>
#include <cstdint>
#include <string_view>

#include "sim/time/span.hpp"

namespace obrys::sim::time {

enum class CornerMode : std::uint8_t {
    exact_stop,  ///< standing still at each
    filter,      ///< the positions are filtered over a time (HEIDENHAIN, high-speed settings of others)
    blend,       ///< a tangent arc is laid into it (G64 P, G642, M90)
};

/// As machine files and --compare spell them.
inline constexpr std::array<std::string_view, 3> corner_names{"exact-stop", "filter", "blend"};

enum class CornerLimit : std::uint8_t { none, acceleration, jerk, stop };

struct CornerSpeed {
    double speed = 0;
    CornerLimit by = CornerLimit::none;  ///< none: the feed
};

/// `turn`: radians, 0 straight on; `highest`: mm/s with which it is come to at the most.
[[nodiscard]] CornerSpeed filtered_corner(double turn, double tolerance, double highest, const Limits& limits);
/// `shorter`: mm of the shorter of both neighbours, half of which the arc may take.
[[nodiscard]] CornerSpeed blended_corner(double turn, double tolerance, double shorter, double highest,
                                         const Limits& limits);
/// Along a curve of this curvature, 1/mm.
[[nodiscard]] CornerSpeed curve_speed(double curvature, double highest, const Limits& limits);

}  // namespace obrys::sim::time
