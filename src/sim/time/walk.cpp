#include "sim/time/walk.hpp"

#include <algorithm>
#include <cmath>

namespace obrys::sim::time {

Motion Walk::to(double at) {
    while (phase_ < span_.count) {
        const Phase& p = span_.phases[phase_];
        const Motion end = after(now_, p.seconds, p.jerk);
        if (end.at >= at && p.seconds > 0) return within(p, at);
        seconds_ += p.seconds;
        now_ = end;
        in_phase_ = 0;
        ++phase_;
    }
    in_phase_ = 0;
    return now_;
}

/// Newton from the last place, or from where the phase begins; the way grows with time, so that a bracket stays.
Motion Walk::within(const Phase& p, double at) {
    const Motion near = after(now_, in_phase_, p.jerk);
    if (p.jerk == 0 && now_.acceleration == 0 && now_.speed > 0) {
        in_phase_ = (at - now_.at) / now_.speed;
        return after(now_, in_phase_, 0);
    }
    double low = in_phase_, high = p.seconds;
    double t = near.speed > 0 ? std::min(high, in_phase_ + (at - near.at) / near.speed) : (low + high) / 2;
    Motion m = after(now_, t, p.jerk);
    for (int i = 0; i < 60; ++i) {
        const double over = m.at - at;
        (over > 0 ? high : low) = t;
        if (std::abs(over) <= 1e-12 * (std::abs(at) + 1) || high - low <= 1e-16) break;
        const double next = m.speed > 0 ? t - over / m.speed : low;
        t = next > low && next < high ? next : (low + high) / 2;
        m = after(now_, t, p.jerk);
    }
    in_phase_ = t;
    return m;
}

}  // namespace obrys::sim::time
