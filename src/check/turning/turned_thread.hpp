#pragma once
/// What of a threading pass on a lathe is thread, and what cuts into the part. Everything in the (z, x) plane.

#include <optional>
#include <string>

#include "sim/turning/turning.hpp"

namespace obrys::check {

/// The surface a thread is cut into, and what the part's contour shows of it. Heights are counted along `out`.
struct ThreadGround {
    geom::Vec2 along, out;  ///< unit: direction of the pass, and out of the material
    double lead = 0;        ///< mm
    double crest = 0;       ///< what stood before the thread
    double contour = 0;     ///< the part's contour below it
    /// The contour is the thread's core: it lies below the crest by more than a turned diameter is off.
    [[nodiscard]] bool shows_core() const;
};

/// A pass of the programmed point, and what it meets of the stock.
struct ThreadPass {
    sim::turning::Move way;
    double lead = 0;        ///< mm, along the move
    geom::Contour outline;  ///< of the insert, relative to the programmed point
    const geom::Region& band;
};

/// Unit: the way of the pass; of one that leads in or out at an angle the axis along which the thread goes.
[[nodiscard]] geom::Vec2 thread_direction(const sim::turning::Move& way);
/// Where stock and contour first run beside each other for a pitch; nothing where they do so nowhere. `before`: that of
/// the thread that this pass goes on with.
[[nodiscard]] std::optional<ThreadGround> thread_ground(const ThreadPass& pass, const geom::Region& part,
                                                        const std::optional<ThreadGround>& before);

/// What a pass takes of the part that is no thread.
struct ThreadFault {
    geom::Region region;
    std::string why;     ///< a clause for the message
    std::string remedy;  ///< may be empty
};
[[nodiscard]] std::optional<ThreadFault> thread_fault(const ThreadPass& pass, const ThreadGround& ground,
                                                      const geom::Region& part, double tolerance);

/// What stands between the turns of the thread and is no rest material.
[[nodiscard]] geom::Region thread_ridges(const ThreadPass& pass, const ThreadGround& ground);

/// How wide the insert is, along the pass, where it cuts the bottom of the thread.
[[nodiscard]] double root_width(const ThreadPass& pass, const ThreadGround& ground);

inline constexpr double deepest_thread = 0.87;  ///< pitches; the height of a sharp thread of 60 degrees is 0.866
/// A clause for messages.
[[nodiscard]] std::string too_deep(double lead);

}  // namespace obrys::check
