#pragma once
/// What a program's seconds were spent on: each second has one cause, and the causes add up to all of them.

#include <array>
#include <cstdint>
#include <map>
#include <string_view>
#include <vector>

#include "base/source.hpp"

namespace obrys::sim::time {

enum class Cause : std::uint8_t {
    feed,          ///< the way at the programmed feed
    rapid,         ///< the way at the axes' rapid
    axis_speed,    ///< an axis is slower than the feed asks for
    acceleration,  ///< getting faster and slower between feeds
    corner,        ///< getting slower for a corner, within the tolerance
    curvature,     ///< the same for a curve
    block_rate,    ///< the control does not get new blocks fast enough
    look_ahead,    ///< it does not know far enough that it may go on
    exact_stop,    ///< standing still between moves
    dwell,
    spindle,  ///< reaching a speed
    tool_change,
    m_function,  ///< and coolant
};
inline constexpr std::size_t causes = 13;
inline constexpr std::array<std::string_view, causes> cause_names{
    "feed",       "rapid",      "axis-speed", "acceleration", "corner",      "curvature", "block-rate",
    "look-ahead", "exact-stop", "dwell",      "spindle",      "tool-change", "m-function"};

using Seconds = std::array<double, causes>;
[[nodiscard]] double sum(const Seconds& s);

/// A line of a source text: the place of the block that begins there.
struct Place {
    std::uint32_t file = 0, begin = 0;
    auto operator<=>(const Place&) const = default;
};

/// What a place has cost by one cause.
struct Spent {
    Place place;
    Cause cause = Cause::feed;
    double seconds = 0;
};
/// In the order of places and causes, each of them once.
void merge(std::vector<Spent>& spent);

struct Times {
    Seconds all{};
    std::map<std::uint32_t, Seconds> tools;  ///< by number
    std::vector<Spent> places;               ///< as `merge` leaves them; all, or the slowest (Options::places)
    std::uint64_t moves = 0;
    std::uint64_t from_nowhere = 0;  ///< rapid moves at the begin, from a place that nobody knows
    std::uint64_t untimed = 0;       ///< moves whose feed, or whose ends, nobody knows
    base::Span first_untimed{};
    std::uint64_t untimed_dwells = 0;  ///< in revolutions of a spindle whose speed is not known
    std::uint64_t untimed_speeds = 0;  ///< changes of a spindle's speed from or to one that is not known
    std::uint64_t stops = 0;           ///< of the program, for as long as its operator likes
    std::uint64_t probings = 0;        ///< moves that end where a probe touches: timed to their end at the latest
    double way = 0;                    ///< mm
    double may_settle = 0;      ///< s that exact stops would take if axes lag, of a machine that is assumed not to
    bool places_short = false;  ///< of `places`, not all passes of one may have been kept

    /// Nothing but what any program leaves open: the way to its first place, a speed by a radius that is not known yet.
    [[nodiscard]] bool is_understood() const { return untimed + untimed_dwells == 0; }
    [[nodiscard]] bool is_whole() const { return is_understood() && from_nowhere + untimed_speeds + stops == 0; }
};

}  // namespace obrys::sim::time
