#include "motion/technology.hpp"

#include <algorithm>
#include <cmath>

#include "geom/vec.hpp"

namespace obrys::motion {

int turning_sense(const cl::Spindle& spindle) { return spindle.speed != 0 ? spindle.direction : 0; }

double spindle_speed(const cl::Spindle& spindle, double radius, double highest) {
    if (spindle.mode == cl::SpindleMode::rpm) return spindle.speed;
    const double cap = spindle.limit > 0 ? std::min(highest, spindle.limit) : highest;
    if (!(radius > 0)) return std::isfinite(cap) ? cap : NAN;
    return std::min(cap, spindle.speed * 1000 / (2 * geom::pi * radius));
}

double feed_seconds(const cl::Feed& feed, double way, double speed) {
    switch (feed.mode) {
        case cl::FeedMode::per_minute: return feed.value > 0 ? 60 * way / feed.value : NAN;
        case cl::FeedMode::per_rev: return feed.value * speed > 0 ? 60 * way / (feed.value * speed) : NAN;
        case cl::FeedMode::inverse_time: return feed.value > 0 ? 60 / feed.value : NAN;
    }
    return NAN;
}

double feed_seconds(const Step& step, double way, double highest) {
    const double radius = std::isnan(step.from.x) ? step.to.x : (step.from.x + step.to.x) / 2;
    cl::Feed feed = step.state.feed;
    if (const auto* thread = std::get_if<cl::Thread>(&step.record.step))
        feed = {std::abs(thread->pitch), cl::FeedMode::per_rev};
    return feed_seconds(feed, way, spindle_speed(step.state.spindle, std::abs(radius), highest));
}

double dwell_seconds(const cl::Dwell& dwell, const cl::Spindle& spindle, double radius, double highest) {
    cl::Spindle turning = spindle;
    turning.speed = spindle_speed(spindle, std::abs(radius), highest);
    turning.mode = cl::SpindleMode::rpm;
    return cl::seconds_of(dwell, turning);
}

double rapid_seconds(const shop::Machine& machine, double way) {
    double slowest = INFINITY;
    for (const shop::MachineAxis& a : machine.axes)
        if (!a.rotary) slowest = std::min(slowest, a.rapid);
    return std::isfinite(slowest) && slowest > 0 ? 60 * way / slowest : NAN;
}

}  // namespace obrys::motion
