#pragma once
/// Counts of a stream: a sink that keeps numbers only.

#include <cmath>
#include <cstdint>
#include <optional>

#include "cl/record.hpp"

namespace obrys::cl {

/// Way along one coordinate, or along all; none where it was never given.
[[nodiscard]] inline double travel(double from, double to) {
    return std::isnan(from) && std::isnan(to) ? 0.0 : to - from;
}
[[nodiscard]] inline geom::Vec3 travel(geom::Vec3 from, geom::Vec3 to) {
    return {travel(from.x, to.x), travel(from.y, to.y), travel(from.z, to.z)};
}

/// Length of a move in mm, arcs with their helix. A coordinate unknown (NaN) at both ends has not moved;
/// unknown at one end only makes the length unknown: NaN. A spline's length is that of its polynomial, whatever `from`.
[[nodiscard]] double move_length(geom::Vec3 from, const Step& move);
/// Where the programmed point stands after the move; for other steps the point itself.
[[nodiscard]] geom::Vec3 position_after(geom::Vec3 from, const Step& step);

struct Totals {
    std::uint64_t records = 0;
    std::uint64_t moves = 0;  ///< Linear, Arc, Spline and Thread
    std::uint64_t rapid_moves = 0, feed_moves = 0;
    double rapid_length_mm = 0, feed_length_mm = 0;  ///< of the moves whose both ends are known
    geom::Vec3 position{NAN, NAN, NAN};              ///< after the last move, seen from the zero in force
    std::optional<Datum> zero{};                     ///< in force

    void operator()(const Record& record);
};

}  // namespace obrys::cl
