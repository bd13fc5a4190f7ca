#pragma once
/// Speed along a piece of path between two places, as fast as acceleration and jerk allow: the S-curve of seven phases,
/// with ends that may already (or still) accelerate. mm, mm/s, mm/s2, mm/s3, s.
/// Source: shared spec physics.md (a) 4; the shortest move that reaches v takes 2 v sqrt(v/j) there.

#include <array>
#include <optional>

namespace obrys::sim::time {

struct Limits {
    double acceleration = 0, jerk = 0;  ///< along the path, both above 0
};

struct End {
    double speed = 0, acceleration = 0;  ///< acceleration < 0: it gets slower there
};

/// Constant jerk.
struct Phase {
    double seconds = 0, jerk = 0;
};

struct Span {
    End from;
    std::array<Phase, 7> phases{};
    std::size_t count = 0;
    double seconds = 0, peak = 0;  ///< peak: the highest speed
};

/// Where one is, after some time of constant jerk.
struct Motion {
    double at = 0, speed = 0, acceleration = 0;
};
[[nodiscard]] Motion after(const Motion& m, double seconds, double jerk);

/// Seconds and mm that a change of speed takes, without acceleration at both ends.
[[nodiscard]] double ramp_seconds(double from, double to, const Limits& limits);
[[nodiscard]] double ramp_length(double from, double to, const Limits& limits);
/// The highest speed that `length` is enough for, from a speed held to one held.
[[nodiscard]] double reachable(double from, double length, const Limits& limits);

/// The same where acceleration stands at both ends, 0 or above; not above `most`. Nothing: not even the least such
/// speed.
[[nodiscard]] std::optional<double> reachable(const End& from, double acceleration, double length, double most,
                                              const Limits& limits);

/// Nothing where `length` is too short for the change of speed, or `highest` is less than the ends need.
/// Acceleration at the ends: of the sign that leads to the other end's speed, not both towards a valley between them.
[[nodiscard]] std::optional<Span> plan_span(double length, const End& from, const End& to, double highest,
                                            const Limits& limits);

}  // namespace obrys::sim::time
