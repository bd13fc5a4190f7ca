#include "check/limits/limits.hpp"

#include <algorithm>
#include <cmath>

#include "base/codes.hpp"
#include "base/number.hpp"
#include "check/limits/feed_mode.hpp"
#include "check/words.hpp"
#include "cl/spline.hpp"
#include "cl/totals.hpp"
#include "motion/technology.hpp"

namespace obrys::check {

using motion::part_along;

namespace {

constexpr double farthest_place = 100'000;  ///< mm: HEIDENHAIN takes no more than 99999.9999; no machine is as long
constexpr double travel_tolerance = 1e-6;   ///< mm beyond a limit that rounding may make

/// Range of dot(along, point) on an arc: its ends and, where the sweep passes them, the extremes of the circle.
std::pair<double, double> arc_range(geom::Vec3 from, const cl::Arc& arc, geom::Vec3 along) {
    double low = std::min(part_along(along, from), part_along(along, arc.to));
    double high = std::max(part_along(along, from), part_along(along, arc.to));
    const geom::Vec3 u = from - arc.centre;
    const geom::Vec3 v = geom::cross(arc.normal, u);
    const double a = part_along(along, u), b = part_along(along, v), radius = std::hypot(a, b);
    const double sense = arc.sweep < 0 ? -1 : 1;
    const double top = std::atan2(b * sense, a);  // angle in the sense of the sweep at which the coordinate is largest
    const auto passes = [&](double angle) {
        const double first = angle < 0 ? angle + 2 * geom::pi : angle;
        return first <= std::abs(arc.sweep);
    };
    if (passes(top)) high = std::max(high, part_along(along, arc.centre) + radius);
    if (passes(top > 0 ? top - geom::pi : top + geom::pi)) low = std::min(low, part_along(along, arc.centre) - radius);
    return {low, high};
}

std::pair<double, double> range(const Move& move, geom::Vec3 along, bool fresh) {
    const auto* arc = std::get_if<cl::Arc>(&move.record.step);
    if (arc != nullptr && geom::is_finite(move.from) && geom::is_finite(arc->centre))
        return arc_range(move.from, *arc, along);
    // Where tool, zero or rotary axes have changed, the last point was reached otherwise, and has been judged.
    const double a = fresh || move.turning ? NAN : part_along(along, move.from);
    if (const auto* spline = std::get_if<cl::Spline>(&move.record.step)) {
        const geom::Cubic c = cl::curve(*spline);
        const auto [low, high] = geom::range(geom::Polynomial3{part_along(along, c.k0), part_along(along, c.k1),
                                                               part_along(along, c.k2), part_along(along, c.k3)});
        return {std::fmin(low, a), std::fmax(high, a)};  // the machine comes from there, gap or not
    }
    const double b = part_along(along, move.to);
    return {std::fmin(a, b), std::fmax(a, b)};  // one unknown end leaves the other
}

/// On a lathe whose C is counted the points turn with the workpiece: X is their distance from its axis, Y stays.
std::pair<double, double> range_on_face(const Move& move, geom::Vec3 along, bool fresh) {
    if (along.z != 0) return range(move, along, fresh);
    if (along.y != 0) return {0, 0};
    double low = INFINITY, high = 0;
    const auto reach = [&](geom::Vec3 p) {
        low = std::fmin(low, std::hypot(p.x, p.y));
        high = std::fmax(high, std::hypot(p.x, p.y));
    };
    if (!geom::is_finite(move.from) || !geom::is_finite(move.to)) return {NAN, NAN};
    reach(move.from);
    reach(move.to);
    cl::points_between(move.from, move.record.step, 0.01, 3600, reach);
    return {low, high};
}

Finding error(std::string_view code, std::string text) {
    Finding f;
    f.code = code;
    f.text = std::move(text);
    return f;
}

/// Rigid tapping: the control turns the spindle with the axis, whatever it did before.
bool turns_spindle(const Move& move) {
    const auto* thread = std::get_if<cl::Thread>(&move.record.step);
    return thread != nullptr && thread->rigid_tap;
}

}  // namespace

Limits::Limits(const shop::Machine& machine, const std::vector<shop::Tool>& tools, const motion::Stand& stand,
               const motion::State& state, Collector& out)
    : machine_(machine), tools_(tools), out_(out), stand_(stand), state_(state) {}

/// What was reached before counts on only where the axis follows the points as it did.
void Limits::follow_stand() {
    changed_ = false;
    std::vector<Travel> before = std::move(travel_);
    travel_.clear();
    for (const motion::Stand::Way& way : stand_.ways()) {
        const auto axis = std::find_if(machine_.axes.begin(), machine_.axes.end(), [&](const shop::MachineAxis& a) {
            return a.name == way.name && (a.min || a.max);
        });
        if (axis == machine_.axes.end()) continue;
        Travel t{&*axis, way.along, way.known, way.from_zero};
        const auto old = std::find_if(before.begin(), before.end(), [&](const Travel& o) { return o.axis == t.axis; });
        const bool same = old != before.end() && old->along == t.along &&
                          (old->from_zero == t.from_zero || (std::isnan(old->from_zero) && std::isnan(t.from_zero)));
        if (same) {
            t.low = old->low;
            t.high = old->high;
        }
        if (same || (old != before.end() && std::isfinite(old->from_zero) && std::isfinite(t.from_zero)))
            t.worst = old->worst;
        travel_.push_back(t);
    }
}

void Limits::take(const cl::Record& record, const cl::AxisEnd& axis) {
    check_axis(record, axis.name, axis.to, axis.to);
}

void Limits::take(const cl::Record& record, const cl::Spline& spline) {
    for (const cl::SplineAxis& axis : spline.axes) {
        const auto [low, high] = geom::range(cl::curve(axis));
        check_axis(record, axis.name, low, high);
    }
}

void Limits::check_axis(const cl::Record& record, const std::array<char, 8>& name, double low, double high) {
    const std::string wanted(name.data(), std::find(name.begin(), name.end(), '\0'));
    for (const shop::MachineAxis& a : machine_.axes) {
        if (a.name != wanted || !std::isfinite(low) || !std::isfinite(high)) continue;
        const double above = a.max ? high - *a.max : 0.0, below = a.min ? *a.min - low : 0.0;
        const double over = std::max(above, below);
        double& worst = other_worst_[wanted];
        if (over > travel_tolerance && over > worst) {
            const std::string unit = a.rotary ? " degrees" : " mm";
            Finding f =
                error(base::codes::axis_limit, "axis " + wanted + " goes to " + plain(above >= below ? high : low) +
                                                   unit + ", " + base::fixed(over, 3) + unit + " outside its travel");
            f.amounts = {{a.rotary ? "excess_deg" : "excess_mm", over}};
            f.cause = wanted + (above >= below ? " +" : " -");
            out_.finding(record, std::move(f));
        }
        worst = std::max(over, 0.0);
    }
}

/// How far the range lies outside the travel: absolutely where the zero is known, else by the length of the way.
double Limits::excess(Travel& t, double low, double high) {
    const shop::MachineAxis& axis = *t.axis;
    low += t.known;
    high += t.known;
    if (std::isfinite(t.from_zero))
        return std::max(axis.max ? high + t.from_zero - *axis.max : 0.0,
                        axis.min ? *axis.min - (low + t.from_zero) : 0.0);
    t.low = std::min(t.low, low);
    t.high = std::max(t.high, high);
    return axis.min && axis.max ? (t.high - t.low) - (*axis.max - *axis.min) : 0.0;
}

namespace {

/// "axis X goes 12.000 mm outside its travel: to -512.000, which ends at -500.000" of the machine.
std::string outside(const shop::MachineAxis& axis, double over, double low, double high) {
    const bool above = axis.max && high - *axis.max >= over - travel_tolerance;
    return "axis " + axis.name + " goes " + mm(over) + " outside its travel: to " + base::fixed(above ? high : low, 3) +
           " of the machine, and it ends at " + base::fixed(above ? *axis.max : *axis.min, 3);
}

}  // namespace

void Limits::check_travel(const Move& move) {
    const bool fresh = changed_;
    if (changed_) follow_stand();
    for (Travel& t : travel_) {
        const auto [low, high] = stand_.on_face() ? range_on_face(move, t.along, fresh) : range(move, t.along, fresh);
        if (std::isnan(low)) continue;
        const double over = std::max(excess(t, low, high), 0.0);
        const bool absolute = std::isfinite(t.from_zero);
        if (!travel_noted_ && !stand_.tool_length_known())
            out_.assumption("travel is judged at the programmed point, without the tool's length");
        travel_noted_ = travel_noted_ || !stand_.tool_length_known();
        if (!absolute && t.axis->min && t.axis->max)
            out_.assumption("zero offset of axis " + t.axis->name +
                            " is not known: only the length of its way was held to its travel");
        if (over > travel_tolerance && over > t.worst) {
            const double at = t.known + t.from_zero;
            Finding f =
                error(base::codes::axis_limit, absolute ? outside(*t.axis, over, low + at, high + at)
                                                        : "axis " + t.axis->name + " needs " + mm(t.high - t.low) +
                                                              " of way, " + mm(over) + " more than its travel");
            f.amounts = {{"excess_mm", over}};
            f.cause = t.axis->name + " " + base::fixed(t.from_zero, 3);  // one zero that is wrong sends every move out
            out_.finding(move, std::move(f));
        }
        t.worst = absolute ? over : std::max(over, t.worst);
    }
}

void Limits::spindle_changed(const cl::Record& record, const cl::Spindle& before) {
    const cl::Spindle& spindle = state_.spindle;
    stopped_reported_ = stopped_reported_ && spindle.direction == 0;
    feed_limit_reported_ = feed_limit_reported_ && spindle == before;
    const bool changed = before.speed != spindle.speed || before.mode != spindle.mode ||
                         before.limit != spindle.limit || (before.direction == 0) != (spindle.direction == 0);
    if (!changed || spindle.direction == 0) return;
    const bool surface = spindle.mode == cl::SpindleMode::surface;
    const double speed = surface ? spindle.limit : spindle.speed;
    const double low = machine_.spindle.min, high = machine_.spindle.max;
    if (!(speed > 0) || (speed <= high && (speed >= low || surface))) return;
    const bool above = speed > high;
    Finding f =
        error(base::codes::spindle_limit,
              std::string(surface ? "speed limit " : "spindle speed ") + plain(speed) + " 1/min is " +
                  (above ? "above the machine's " + plain(high) : "below the machine's " + plain(low)) + " 1/min");
    f.amounts = {{"speed_rpm", speed}, {"limit_rpm", above ? high : low}};
    out_.finding(record, std::move(f));
}

void Limits::feed_changed() { feed_reported_ = feed_limit_reported_ = feed_implausible_reported_ = false; }

/// Highest spindle speed along the move, 1/min; with constant cutting speed at its smaller radius. NaN: not known, at
/// the axis without a limit.
double Limits::rpm(const Move& move) const {
    const double radius = std::fmin(std::abs(move.from.x), std::abs(move.to.x));
    return motion::spindle_speed(state_.spindle, radius, machine_.spindle.max);
}

void Limits::check_feed(const Move& move) {
    if (std::holds_alternative<cl::Thread>(move.record.step)) return;  // the pitch sets the feed
    if (state_.feed.value == 0) {
        if (!feed_reported_) {
            Finding f = error(base::codes::feed_missing, "feed move, but no feed is programmed");
            f.remedy = "program F before the first feed move";
            out_.finding(move, std::move(f));
        }
        feed_reported_ = true;
        return;
    }
    if (machine_.max_feed <= 0 || feed_limit_reported_) return;
    double per_minute = state_.feed.value;
    if (state_.feed.mode == cl::FeedMode::per_rev) per_minute *= rpm(move);
    if (state_.feed.mode == cl::FeedMode::inverse_time) per_minute *= cl::move_length(move.from, move.record.step);
    if (!(per_minute > machine_.max_feed * (1 + 1e-9))) return;
    feed_limit_reported_ = true;
    Finding f = error(base::codes::feed_limit, "feed " + plain(per_minute) + " mm/min is above the machine's " +
                                                   plain(machine_.max_feed) + " mm/min");
    f.severity = base::Severity::warning;
    f.amounts = {{"feed_mm_per_min", per_minute}, {"limit_mm_per_min", machine_.max_feed}};
    out_.finding(move, std::move(f));
}

/// A feed that makes sense in the other mode only, per minute or per revolution.
void Limits::check_feed_mode(const Move& move, bool cuts) {
    if (feed_implausible_reported_ || std::holds_alternative<cl::Thread>(move.record.step)) return;
    std::optional<Finding> f;
    if (state_.feed.mode == cl::FeedMode::per_rev)
        f = too_fast(state_.feed.value, widest_feed(state_.tool, machine_.kind));
    if (!f && state_.feed.mode == cl::FeedMode::per_rev && cuts) f = too_fine(state_.feed.value, state_.tool);
    if (state_.feed.mode == cl::FeedMode::per_minute && cuts)
        f = too_slow(state_.feed.value, state_.feed.value / rpm(move), finest_turned);
    if (!f) return;
    feed_implausible_reported_ = true;
    out_.finding(move, std::move(*f));
}

void Limits::check_spindle(const Move& move, std::optional<bool> cuts) {
    if (turns_spindle(move)) return;
    const bool stands = state_.spindle.direction == 0 || state_.spindle.speed == 0;
    const bool waits = state_.feed.mode == cl::FeedMode::per_rev && state_.feed.value > 0;
    if (!stands || stopped_reported_ || !(waits || cuts.value_or(true))) return;
    stopped_reported_ = true;
    Finding f = error(base::codes::spindle_stopped,
                      waits  ? "feed per revolution while the spindle stands: the axes would not move"
                      : cuts ? "the tool cuts while the spindle stands"
                             : "feed move while the spindle stands");
    f.remedy = "start the spindle with M3 or M4 and a speed S";
    out_.finding(move, std::move(f));
}

/// A point that was forgotten is no way of any machine, whatever the job says of the travels.
void Limits::check_far(const Move& move) {
    const double far = std::fmax(std::abs(move.to.x), std::fmax(std::abs(move.to.y), std::abs(move.to.z)));
    if (!(far > farthest_place) || far_reported_) return;
    far_reported_ = true;
    Finding f =
        error(base::codes::axis_limit, "the move goes " + plain(far) + " mm far from the zero: no machine does");
    f.remedy = "look whether a decimal point is missing";
    f.amounts = {{"excess_mm", far - farthest_place}};
    out_.finding(move, std::move(f));
}

void Limits::take(const Move& move, std::optional<bool> cuts, bool driven) {
    check_travel(move);
    check_far(move);
    check_thread_speed(move);
    check_compensation(move);
    if (move.rapid) return;
    check_surface_speed(move);
    check_speed_on_axis(move);
    check_feed(move);
    check_feed_mode(move, cuts.value_or(false));
    if (!driven) check_spindle(move, cuts);
}

}  // namespace obrys::check
