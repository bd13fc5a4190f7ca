#include "sim/time/speed_curve.hpp"

#include <algorithm>

#include "base/whole.hpp"

namespace obrys::sim::time {

void SpeedCurve::halve() {
    const std::size_t n = (samples_.size() + 1) / 2;
    for (std::size_t i = 0; i < n; ++i) {
        Sample s = samples_[2 * i];
        if (2 * i + 1 < samples_.size()) {
            const Sample& next = samples_[2 * i + 1];
            s.low = std::min(s.low, next.low);
            s.high = std::max(s.high, next.high);
            s.way = next.way;
        }
        samples_[i] = s;
    }
    samples_.resize(n);
    step_ *= 2;
}

void SpeedCurve::take(double seconds, double from, double to, const Place& place) {
    if (!(seconds > 0)) return;
    const double end = seconds_ + seconds, slope = (to - from) / seconds;
    while (end > step_ * static_cast<double>(most_)) halve();
    double now = seconds_, speed = from;
    while (now < end) {
        auto i = base::clipped<std::size_t>(now / step_, 0, most_);
        if (i < samples_.size() && step_ * static_cast<double>(i + 1) <= now) ++i;  // rounding
        const double until = std::min(end, std::max(step_ * static_cast<double>(i + 1), now * (1 + 1e-15)));
        const double then = until >= end ? to : from + slope * (until - seconds_);
        while (samples_.size() <= i) samples_.push_back({std::min(speed, then), std::max(speed, then), way_, place});
        way_ += (speed + then) / 2 * (until - now);
        Sample& s = samples_[i];
        s.low = std::min({s.low, speed, then});
        s.high = std::max({s.high, speed, then});
        s.way = way_;
        speed = then;
        now = until > now ? until : end;
    }
    seconds_ = end;
}

}  // namespace obrys::sim::time
