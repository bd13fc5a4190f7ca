#include "sim/time/span.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace obrys::sim::time {
namespace {

constexpr double relative = 1e-12;  ///< of lengths and speeds: what rounding makes of them

/// The three phases of a change of speed: to an acceleration, held, to the acceleration at the end.
struct Ramp {
    std::array<Phase, 3> phases{};
    double seconds = 0, length = 0;
};

struct Rise {
    double from, to, a0, a1;  ///< from <= to, both accelerations >= 0
    [[nodiscard]] double gain() const { return to - from; }
};

/// Of the steepest rise. Below the accelerations at the ends: these ask for more speed than is gained.
double steepest(const Rise& r, const Limits& l) {
    const double peak = std::sqrt(std::max(0.0, (2 * l.jerk * r.gain() + r.a0 * r.a0 + r.a1 * r.a1) / 2));
    return std::min(peak, l.acceleration);
}

bool fits(const Rise& r, const Limits& l) {
    return r.gain() >= 0 && steepest(r, l) >= std::max(r.a0, r.a1) * (1 - relative);
}

Ramp ramp_at(const Rise& r, double level, const Limits& l) {
    const double up = std::abs(level - r.a0) / l.jerk, down = std::abs(level - r.a1) / l.jerk;
    const double gained = (r.a0 + level) / 2 * up + (level + r.a1) / 2 * down;
    Ramp ramp;
    ramp.phases[0] = {up, level >= r.a0 ? l.jerk : -l.jerk};
    ramp.phases[1] = {level > 0 ? std::max(0.0, r.gain() - gained) / level : 0, 0};
    ramp.phases[2] = {down, level >= r.a1 ? -l.jerk : l.jerk};
    Motion m{0, r.from, r.a0};
    for (const Phase& p : ramp.phases) {
        m = after(m, p.seconds, p.jerk);
        ramp.seconds += p.seconds;
    }
    ramp.length = m.at;
    return ramp;
}

/// Nothing: the accelerations at the ends ask for more speed than is gained.
std::optional<Ramp> rise(const Rise& r, const Limits& l) {
    if (!fits(r, l)) return {};
    return ramp_at(r, std::max({steepest(r, l), r.a0, r.a1}), l);
}

/// Up to a speed that is held for a while, and from there down (`last` falls) or on (it rises).
struct Pattern {
    Ramp first, last;
    bool falls = false;
    [[nodiscard]] double length() const { return first.length + last.length; }
};

std::optional<Pattern> pattern(const End& from, const End& to, double held, const Limits& l) {
    const bool falls = to.acceleration <= 0;
    const std::optional<Ramp> first = rise({from.speed, held, from.acceleration, 0}, l);
    const std::optional<Ramp> last =
        falls ? rise({to.speed, held, -to.acceleration, 0}, l) : rise({held, to.speed, 0, to.acceleration}, l);
    if (!first || !last) return {};
    return Pattern{*first, *last, falls};
}

Span joined(const End& from, const Pattern& p, double held, double length) {
    Span s;
    s.from = from;
    s.peak = held;
    for (const Phase& phase : p.first.phases) s.phases[s.count++] = phase;
    s.phases[s.count++] = {held > 0 ? std::max(0.0, length - p.length()) / held : 0, 0};
    for (std::size_t i = 0; i < 3; ++i) s.phases[s.count++] = p.last.phases[p.falls ? 2 - i : i];
    for (const Phase& phase : s.phases) s.seconds += phase.seconds;
    return s;
}

/// Where what is over changes its sign, by regula falsi (Illinois): of two values one fits (f <= 0), one leads beyond,
/// and what is over grows from the one to the other.
template <class Over>
double fitting(double length, double fits, double f_fits, double beyond, double f_beyond, Over over) {
    for (int i = 0; i < 80 && std::abs(beyond - fits) > relative * std::max(fits, beyond); ++i) {
        double v = (fits * f_beyond - beyond * f_fits) / (f_beyond - f_fits);
        if (!(v > std::min(fits, beyond) && v < std::max(fits, beyond))) v = (fits + beyond) / 2;
        const double f = over(v);
        if (std::abs(f) <= relative * length) return v;
        if (f <= 0) {
            fits = v;
            f_fits = f;
            f_beyond /= 2;
        } else {
            beyond = v;
            f_beyond = f;
            f_fits /= 2;
        }
    }
    return fits;
}

/// The speed of the pattern that takes just `length`, between one that takes less and one that takes more.
double speed_for(double length, const End& from, const End& to, double low, double high, const Limits& l) {
    const auto part = [&](const End& e, double v) {
        if (e.acceleration == 0) return ramp_length(e.speed, v, l);
        const std::optional<Ramp> r = rise({e.speed, v, std::abs(e.acceleration), 0}, l);
        return r ? r->length : 0;
    };
    const auto over = [&](double v) { return part(from, v) + part(to, v) - length; };
    const double f_low = over(low);
    return f_low >= 0 ? low : fitting(length, low, f_low, high, over(high), over);
}

/// Both ends get faster, and the way is shorter than a while at a held speed needs: less acceleration between them.
std::optional<Span> flat_rise(double length, const End& from, const End& to, const Limits& l) {
    const Rise r{from.speed, to.speed, from.acceleration, to.acceleration};
    if (!fits(r, l)) return {};
    const double high = std::max({steepest(r, l), r.a0, r.a1});
    // With less than this between them, the ends alone gain more speed than is to be gained.
    const double low = std::sqrt(std::max(0.0, (r.a0 * r.a0 + r.a1 * r.a1) / 2 - l.jerk * r.gain()));
    const auto over = [&](double level) { return ramp_at(r, level, l).length - length; };
    if (low > 0 && over(low) < 0) return {};
    const double f_high = over(high);
    if (f_high > length * relative) return {};
    // Without acceleration between them the way has no end.
    const double level = fitting(length, high, f_high, low, INFINITY, over);
    const Ramp ramp = ramp_at(r, level, l);
    Span s;
    s.from = from;
    s.peak = to.speed;
    for (const Phase& phase : ramp.phases) s.phases[s.count++] = phase;
    s.seconds = ramp.seconds;
    return s;
}

Span reversed(const Span& s, const End& from) {
    Span back;
    back.from = from;
    back.peak = s.peak;
    back.seconds = s.seconds;
    back.count = s.count;
    for (std::size_t i = 0; i < s.count; ++i) back.phases[i] = s.phases[s.count - 1 - i];
    return back;
}

/// Highest speed that the end allows to be held on its inner side.
double needed(const End& e, const Limits& l) { return e.speed + e.acceleration * e.acceleration / (2 * l.jerk); }

}  // namespace

Motion after(const Motion& m, double t, double jerk) {
    return {m.at + t * (m.speed + t * (m.acceleration / 2 + t * jerk / 6)),
            m.speed + t * (m.acceleration + t * jerk / 2), m.acceleration + t * jerk};
}

double ramp_seconds(double from, double to, const Limits& l) {
    const double change = std::abs(to - from);
    return change >= l.acceleration * l.acceleration / l.jerk ? change / l.acceleration + l.acceleration / l.jerk
                                                              : 2 * std::sqrt(change / l.jerk);
}

double ramp_length(double from, double to, const Limits& l) { return (from + to) / 2 * ramp_seconds(from, to, l); }

double reachable(double from, double length, const Limits& l) {
    // From the side of long ramps (2 a length = to^2 - from^2 + (to + from) a^2/j), where the ramp has a flat part.
    const double a = l.acceleration, flat = from + a * a / l.jerk;
    if (ramp_length(from, flat, l) <= length) {
        const double k = a * a / l.jerk;
        return -k / 2 + std::sqrt(k * k / 4 + from * from - k * from + 2 * a * length);
    }
    // length^2 j = (2 from + d)^2 d, d = to - from: a cubic that grows with d.
    double low = 0, high = flat - from;
    double d = std::min(high, std::cbrt(length * length * l.jerk));
    for (int i = 0; i < 60 && high - low > 1e-15 * high; ++i) {
        const double w = 2 * from + d, f = w * w * d - length * length * l.jerk;
        (f > 0 ? high : low) = d;
        const double slope = w * (w + 2 * d);
        double next = slope > 0 ? d - f / slope : high;
        if (!(next > low && next < high)) next = (low + high) / 2;
        if (std::abs(next - d) <= 1e-15 * d) break;
        d = next;
    }
    return from + d;
}

std::optional<double> reachable(const End& from, double acceleration, double length, double most, const Limits& l) {
    const auto within = [&](double v) {
        const std::optional<Ramp> r = rise({from.speed, v, from.acceleration, acceleration}, l);
        return r && r->length <= length;
    };
    const double change = acceleration * acceleration - from.acceleration * from.acceleration;
    double low = from.speed + std::abs(change) / (2 * l.jerk) * (1 + 1e-9), high = most;
    if (low > high || !within(low)) return {};
    if (within(high)) return high;
    for (int i = 0; i < 30; ++i) {
        const double v = (low + high) / 2;
        (within(v) ? low : high) = v;
    }
    return low;
}

std::optional<Span> plan_span(double length, const End& from, const End& to, double highest, const Limits& l) {
    if (from.acceleration < 0 || (from.acceleration == 0 && to.acceleration > 0 && to.speed < from.speed)) {
        if (to.acceleration > 0) return {};
        const std::optional<Span> s =
            plan_span(length, {to.speed, -to.acceleration}, {from.speed, -from.acceleration}, highest, l);
        return s ? std::optional(reversed(*s, from)) : std::nullopt;
    }
    if (to.acceleration > 0) {
        const double held = to.speed - to.acceleration * to.acceleration / (2 * l.jerk);
        const std::optional<Pattern> p = pattern(from, to, held, l);
        if (!p || p->length() > length) return flat_rise(length, from, to, l);
        Span s = joined(from, *p, held, length);
        s.peak = to.speed;
        return s;
    }
    const double least = std::max(needed(from, l), needed(to, l));
    if (least > highest * (1 + relative)) return {};
    const std::optional<Pattern> slowest = pattern(from, to, least, l);
    if (!slowest || slowest->length() > length * (1 + relative)) return {};
    const double most = std::max(least, highest);
    const std::optional<Pattern> fastest = pattern(from, to, most, l);
    if (fastest && fastest->length() <= length) return joined(from, *fastest, most, length);
    const double held = speed_for(length, from, to, least, most, l);
    const std::optional<Pattern> found = pattern(from, to, held, l);
    return found ? std::optional(joined(from, *found, held, length)) : std::nullopt;
}

}  // namespace obrys::sim::time
