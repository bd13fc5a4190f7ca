#pragma once
/// Goes through the places of a span in order: when one is there, and how fast.

#include "sim/time/span.hpp"

namespace obrys::sim::time {

class Walk {
public:
    /// The span outlives it.
    explicit Walk(const Span& span) : span_(span), now_{0, span.from.speed, span.from.acceleration} {}

    /// Motion where `at` mm are gone, not before the last place.
    Motion to(double at);
    /// Until there.
    [[nodiscard]] double seconds() const { return seconds_ + in_phase_; }

private:
    Motion within(const Phase& p, double at);

    const Span& span_;
    Motion now_;  ///< as the phase begins
    std::size_t phase_ = 0;
    double seconds_ = 0, in_phase_ = 0;
};

}  // namespace obrys::sim::time
