#include "sim/time/timer.hpp"

#include <algorithm>
#include <utility>

#include "cl/spline.hpp"
#include "cl/totals.hpp"
#include "motion/rapid_way.hpp"
#include "motion/technology.hpp"

namespace obrys::sim::time {
namespace {

constexpr double minute = 60;

/// Rest to rest along one axis.
double axis_seconds(double way, const AxisLimits& axis) {
    const auto span = plan_span(way, {}, {}, axis.speed, {axis.acceleration, axis.jerk});
    return span ? span->seconds : 0;
}

}  // namespace

Timer::Timer(std::span<const shop::Tool> tools, Dynamics dynamics, const TimerOptions& options)
    : dynamics_(std::move(dynamics)),
      cursor_(tools),
      ledger_(options.places),
      curve_(options.samples),
      options_(options) {}

void Timer::spend(const Piece& piece, Cause cause, double seconds) {
    if (seconds == 0) return;
    const auto i = static_cast<std::size_t>(cause);
    times_.all[i] += seconds;
    if (tool_ == nullptr || piece.tool != tool_number_) {
        tool_number_ = piece.tool;
        tool_ = &times_.tools[tool_number_];
    }
    (*tool_)[i] += seconds;
    ledger_.spend(piece.place, cause, seconds);
}

void Timer::spend(const base::Span& from, Cause cause, double seconds) {
    Piece piece;
    piece.place = {from.file, from.begin};
    piece.tool = cursor_.state().change.number;
    spend(piece, cause, seconds);
    if (options_.samples > 0) curve_.take(seconds, 0, 0, piece.place);
}

void Timer::untimed(const motion::Step& step) {
    if (times_.untimed++ == 0) times_.first_untimed = step.record.from;
    stop(Cause::exact_stop);
}

/// On the way to the first place that is known.
void Timer::from_nowhere() {
    ++times_.from_nowhere;
    stop(Cause::exact_stop);
}

void Timer::take_spindle(const cl::Record& record, const cl::Spindle& spindle) {
    stop(Cause::exact_stop);
    const double x = cursor_.position().here().x;
    const bool held = spindle.mode == cl::SpindleMode::surface;
    const double most =
        std::min(motion::spindle_speed(spindle, std::abs(x), dynamics_.highest_speed), dynamics_.highest_speed);
    const double speed = spindle.direction == 0 ? 0 : held && std::isnan(x) ? NAN : most * spindle.direction;
    const double change = std::abs(speed - std::exchange(spindle_, speed));
    if (std::isnan(change)) ++times_.untimed_speeds;
    if (change > 0) spend(record.from, Cause::spindle, change / 1000 * dynamics_.spindle_time);
}

/// A control lets the spindle follow while it goes at rapid, and waits for it before it cuts.
void Timer::await_spindle(const motion::Step& step) {
    const double since = std::exchange(rapid_seconds_, 0);
    const cl::Spindle& spindle = step.state.spindle;
    if (spindle.mode != cl::SpindleMode::surface || spindle.direction == 0) return;
    const auto speed_at = [&](double x) {
        return std::min(motion::spindle_speed(spindle, std::abs(x), dynamics_.highest_speed), dynamics_.highest_speed);
    };
    const double wanted = speed_at(step.from.x) * spindle.direction;
    const double change = std::abs(wanted - spindle_) / 1000 * dynamics_.spindle_time;
    if (change > since) {
        stop(Cause::exact_stop);
        spend(step.record.from, Cause::spindle, change - since);
    }
    if (const double then = speed_at(step.to.x); std::isfinite(then)) spindle_ = then * spindle.direction;
}

/// Those of one block are done together.
void Timer::take_m_function(const base::Span& from) {
    stop(Cause::exact_stop);
    const Place place{from.file, from.begin};
    if (std::exchange(strobed_, place) != place) spend(from, Cause::m_function, dynamics_.strobe_time);
}

void Timer::take(const cl::Record& record) {
    if (const std::optional<motion::Step> step = cursor_.take(record)) return take_move(*step);
    if (const auto* dwell = std::get_if<cl::Dwell>(&record.step)) {
        stop(Cause::exact_stop);
        const double seconds = motion::dwell_seconds(*dwell, cursor_.state().spindle, cursor_.position().here().x,
                                                     dynamics_.highest_speed);
        if (std::isfinite(seconds)) return spend(record.from, Cause::dwell, seconds);
        ++times_.untimed_dwells;
    } else if (const auto* spindle = std::get_if<cl::Spindle>(&record.step)) {
        take_spindle(record, *spindle);
    } else if (const auto* change = std::get_if<cl::ToolChange>(&record.step)) {
        if (change->standing) return;
        stop(Cause::exact_stop);
        spend(record.from, Cause::tool_change, dynamics_.tool_change);
    } else if (const auto* halt = std::get_if<cl::Stop>(&record.step)) {
        stop(Cause::exact_stop);
        if (halt->kind == cl::StopKind::program) ++times_.stops;
    } else if (std::holds_alternative<cl::Coolant>(record.step) || std::holds_alternative<cl::Auxiliary>(record.step)) {
        take_m_function(record.from);
    }
}

/// How far additional axes go along with a move.
Timer::Turns Timer::turns_of(const motion::Step& step) const {
    Turns turns;
    for (const cl::AxisEnd& end : *cl::ends_of(step.record.step)) {
        const cl::AxisEnd* stood = motion::find_axis(step.axes_from, end.name);
        const auto limits = dynamics_.others.find(std::string(cl::name_of(end.name)));
        const double way = stood == nullptr ? NAN : std::abs(end.to - stood->to);
        if (stood == nullptr || std::isnan(stood->to)) turns.begins_nowhere = true;
        if (way > 0 && limits != dynamics_.others.end()) turns.ways.emplace_back(&limits->second, way);
        if (std::isnan(end.to) || (way > 0 && limits == dynamics_.others.end())) turns.unknown = true;
    }
    return turns;
}

void Timer::take_move(const motion::Step& step) {
    ++times_.moves;
    const double length = cl::move_length(step.from, step.record.step);
    const Turns turns = turns_of(step);
    const bool known = std::isfinite(length);
    if (turns.unknown || (!known && begun_)) return untimed(step);
    if (!known || turns.begins_nowhere) {
        if (known) begun_ = true;
        return step.rapid ? from_nowhere() : untimed(step);
    }
    begun_ = true;
    const auto* line = std::get_if<cl::Linear>(&step.record.step);
    const auto* thread = std::get_if<cl::Thread>(&step.record.step);
    const bool probes = line != nullptr && line->seek != cl::Seek::nothing;
    const bool taps = thread != nullptr && thread->rigid_tap;
    const cl::PathMode* path = step.state.path ? &*step.state.path : nullptr;
    // Rapid moves are ended before anything else begins: so all controls do unless a parameter says otherwise.
    if (step.rapid || last_rapid_ || probes || (path != nullptr && path->kind == cl::PathKind::exact_stop))
        stop(Cause::exact_stop);
    if (taps) stop(Cause::spindle);
    if (!step.rapid) await_spindle(step);
    last_rapid_ = step.rapid;
    if (probes) ++times_.probings;
    if (length == 0) return take_turn(step, turns);
    times_.way += length;
    if (take_dog_leg(step, turns)) return;
    if (const auto* spline = std::get_if<cl::Spline>(&step.record.step)) {
        const geom::Cubic curve = cl::forward(*spline);
        constexpr int parts = 16;
        geom::Vec3 from = point_at(curve, 0);
        for (int i = 1; i <= parts; ++i) {
            const geom::Vec3 to = point_at(curve, static_cast<double>(i) / parts);
            if (const double part = geom::distance(from, to); part > 0) add(step, part, from, to, 0, turns);
            from = to;
        }
        return;
    }
    add(step, length, step.from, step.to, curvature_of(step.record.step, length), turns);
    if (taps) stop(Cause::spindle);
    if (probes) stop(Cause::exact_stop);
}

/// Additional axes alone. Degrees per minute is what a feed says of a rotary one.
void Timer::take_turn(const motion::Step& step, const Turns& turns) {
    if (turns.ways.empty()) return;
    const cl::Feed& feed = step.state.feed;
    const bool by_time = !step.rapid && feed.mode == cl::FeedMode::inverse_time;
    if (!step.rapid && (!(feed.value > 0) || feed.mode == cl::FeedMode::per_rev)) return untimed(step);
    double seconds = by_time ? minute / feed.value : 0;
    for (const auto& [limits, way] : turns.ways) {
        const double asked = step.rapid || by_time ? limits->speed : std::min(limits->speed, feed.value / minute);
        seconds = std::max(seconds, axis_seconds(way, {asked, limits->acceleration, limits->jerk}));
    }
    stop(Cause::exact_stop);
    spend(step.record.from, step.rapid ? Cause::rapid : Cause::feed, seconds);
}

bool Timer::take_dog_leg(const motion::Step& step, const Turns& turns) {
    if (!dynamics_.dog_leg || !step.rapid || !std::holds_alternative<cl::Linear>(step.record.step)) return false;
    std::vector<std::pair<const AxisLimits*, double>> ways = turns.ways;
    const std::array<double, 3> way = motion::ways_of_axes(motion::upright_axes, step.from, step.to);
    for (std::size_t i = 0; i < 3; ++i)
        if (std::abs(way[i]) > 0) ways.emplace_back(&dynamics_.axes[i], std::abs(way[i]));
    double seconds = 0, at_rapid = 0, longest = 0;
    for (const auto& [axis, part] : ways) {
        const double takes = axis_seconds(part, *axis);
        if (takes > seconds) seconds = takes, at_rapid = part / axis->speed;
        longest = std::max(longest, part);
    }
    rapid_seconds_ += seconds;
    Piece piece;
    piece.place = {step.record.from.file, step.record.from.begin};
    piece.tool = step.state.change.number;
    spend(piece, Cause::rapid, at_rapid);
    spend(piece, Cause::exact_stop, seconds - at_rapid);
    double fastest = 0;
    for (const auto& [axis, part] : ways) fastest = std::max(fastest, std::min(axis->speed, part / seconds));
    settle(piece, fastest);
    if (options_.samples > 0) curve_.take(seconds, longest / seconds, longest / seconds, piece.place);
    return true;
}

Times Timer::finish() {
    stop(Cause::exact_stop);
    times_.places = ledger_.finish();
    times_.places_short = ledger_.is_short();
    tool_ = nullptr;
    return std::move(times_);
}

}  // namespace obrys::sim::time
