#include "driver/increments.hpp"

#include <algorithm>
#include <cmath>

#include "motion/cursor.hpp"
#include "write/lesser.hpp"

namespace obrys::driver {

double spread_of(const cl::Frame& frame) {
    geom::Vec3 sum;
    for (const geom::Vec3& axis : {geom::Vec3{1, 0, 0}, geom::Vec3{0, 1, 0}, geom::Vec3{0, 0, 1}}) {
        geom::Vec3 v = axis;
        for (auto part = frame.parts.rbegin(); part != frame.parts.rend(); ++part)
            v = geom::apply_direction(part->frame, v);
        sum = sum + geom::Vec3{std::abs(v.x), std::abs(v.y), std::abs(v.z)};
    }
    const double most = std::max({sum.x, sum.y, sum.z});
    return most > 1 ? most : 1;  // one that is not known says nothing
}

compare::Tolerance as_control_counts(const write::Post& post, compare::Tolerance tolerance, double spread) {
    constexpr double slack = 1 + 1e-6;
    tolerance.increment = write::least_arc(post);
    tolerance.length = std::max(tolerance.length, 0.5 * post.increment * spread * slack);
    return tolerance;
}

namespace {

/// How far what turns a tilted plane a little further moves a place in it, and the rotary axes.
void note_tilt(LookedThrough& out, const cl::Frame& frame, const geom::Vec3& to) {
    const auto is_plane = [](const cl::FramePart& p) { return p.kind == cl::FrameKind::plane; };
    if (std::none_of(frame.parts.begin(), frame.parts.end(), is_plane)) return;
    geom::Frame whole;
    for (const cl::FramePart& p : frame.parts) whole = whole * p.frame;
    const geom::Vec3 normal = geom::apply_direction(whole, {0, 0, 1});
    if (const double far = geom::distance(to, whole.origin); std::isfinite(far)) out.lever = std::max(out.lever, far);
    constexpr double level = 1e-6;
    if (const double tilt = std::hypot(normal.x, normal.y); tilt > level) out.tilt = std::min(out.tilt, tilt);
}

}  // namespace

LookedThrough look_through(const cl::Recording& stream) {
    LookedThrough out;
    motion::Cursor cursor;
    cl::Recording::Playback playback(stream);
    const auto look = [&](const cl::Record& record) {
        if (const auto* frame = std::get_if<cl::Frame>(&record.step))
            out.spread = std::max(out.spread, spread_of(*frame));
        const std::optional<motion::Step> step = cursor.take(record);
        if (step) note_tilt(out, step->state.frame, step->to);
        if (!step || out.without_feed || step->rapid || std::holds_alternative<cl::Thread>(record.step)) return;
        if (step->state.feed.value == 0) out.without_feed = record;
    };
    while (playback.step(look)) {
    }
    return out;
}

compare::Tolerance as_words_hold(const write::Post& post, const LookedThrough& program, compare::Tolerance tolerance) {
    constexpr double words = 5;  // the start counts twice, for it shifts the centre and the radius
    const double length = write::half_step(post, "length");
    if (program.lever > 0) {
        constexpr double angles = 3;
        tolerance.turn = angles * geom::radians(write::half_step(post, "angle"));
        tolerance.length += program.lever * tolerance.turn;
        tolerance.angle = std::max(tolerance.angle, geom::degrees(tolerance.turn / program.tilt));
    }
    if (length <= tolerance.length) tolerance.on_arcs = tolerance.length + words * length;
    constexpr double slack = 1 + 1e-6;
    // Beside a smooth joint that is rounded a corner appears, whose arc no word is fine enough for.
    tolerance.increment = std::max(tolerance.increment, 2 * length);
    tolerance.feed_step = write::half_step(post, "feed") * slack;
    tolerance.speed_step = write::half_step(post, "speed") * slack;
    return tolerance;
}

}  // namespace obrys::driver
