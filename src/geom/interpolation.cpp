#include "geom/interpolation.hpp"

#include <algorithm>
#include <limits>

namespace obrys::geom {

namespace {

constexpr double never = std::numeric_limits<double>::infinity();
constexpr double solved = 1e-6;                       ///< units by which the place of a step may be off
constexpr double largest_sweep = 1e6;                 ///< radians: more turns would cost time even where no axis steps
constexpr double largest_count = 1125899906842624.0;  ///< 2^50: doubles still tell quarters of a unit apart

double& coordinate(Vec3& v, std::size_t axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }
double coordinate(const Vec3& v, std::size_t axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }

/// One coordinate of an element: polynomial + radius * cos(sweep * u - phase), with exact ends.
struct Coordinate {
    Polynomial3 poly;
    double radius = 0, sweep = 0, phase = 0;
    double first = 0, last = 0;

    [[nodiscard]] double value(double u) const {
        if (u <= 0) return first;
        if (u >= 1) return last;
        return value_at(poly, u) + (radius == 0 ? 0 : radius * std::cos(sweep * u - phase));
    }
    [[nodiscard]] double slope(double u) const {
        return slope_at(poly, u) - (radius == 0 ? 0 : radius * sweep * std::sin(sweep * u - phase));
    }
    [[nodiscard]] double bend(double u) const {
        return 2 * poly.k2 + 6 * poly.k3 * u - (radius == 0 ? 0 : radius * sweep * sweep * std::cos(sweep * u - phase));
    }
    /// The first parameter after `u` at which the slope changes its sign; 1 where there is none.
    [[nodiscard]] double next_turn(double u) const;
};

double Coordinate::next_turn(double u) const {
    double next = 1;
    if (radius == 0) {
        const Turns at = turns(poly);
        for (int i = at.count; i-- > 0;)
            if (at.t[static_cast<std::size_t>(i)] > u) next = at.t[static_cast<std::size_t>(i)];
        return next;
    }
    // radius sweep sin(a) = k1 with a = sweep u - phase; a turn of the circle takes 2 pi / |sweep| of the parameter.
    const double sine = poly.k1 / (radius * sweep);
    if (!(std::abs(sine) < 1)) return 1;
    const double a = std::asin(sine), turn = 2 * pi / std::abs(sweep);
    for (const double angle : {a, pi - a}) {
        const double at = (angle + phase) / sweep;
        double later = at + (std::floor((u - at) / turn) + 1) * turn;
        if (later <= u + 1e-9 * turn) later += turn;
        next = std::min(next, later);
    }
    return next;
}

Vec3 turned(Vec3 v, Vec3 normal, double angle) {
    return std::cos(angle) * v + std::sin(angle) * cross(normal, v) + ((1 - std::cos(angle)) * dot(normal, v)) * normal;
}

std::array<Coordinate, 3> coordinates_of(const Straight& s) {
    std::array<Coordinate, 3> out;
    for (std::size_t i = 0; i < 3; ++i) {
        const double a = coordinate(s.from, i), b = coordinate(s.to, i);
        out[i] = {{a, b - a, 0, 0}, 0, 0, 0, a, b};
    }
    return out;
}

std::array<Coordinate, 3> coordinates_of(const Circular& c) {
    if (c.sweep == 0) return coordinates_of(Straight{c.from, c.to});
    const Vec3 spoke = c.from - c.centre, radius = spoke - dot(spoke, c.normal) * c.normal;
    const Vec3 across = cross(c.normal, radius), foot = c.from - radius;
    const Vec3 missing = c.to - foot - turned(radius, c.normal, c.sweep);
    std::array<Coordinate, 3> out;
    for (std::size_t i = 0; i < 3; ++i) {
        const double r = coordinate(radius, i), m = coordinate(across, i);
        out[i] = {{coordinate(foot, i), coordinate(missing, i), 0, 0},
                  std::hypot(r, m),
                  c.sweep,
                  std::atan2(m, r),
                  coordinate(c.from, i),
                  coordinate(c.to, i)};
    }
    return out;
}

std::array<Coordinate, 3> coordinates_of(const Cubic& c) {
    std::array<Coordinate, 3> out;
    for (std::size_t i = 0; i < 3; ++i) {
        const Polynomial3 p = component(c, i);
        out[i] = {p, 0, 0, 0, p.k0, value_at(p, 1)};
    }
    return out;
}

std::array<Coordinate, 3> coordinates_of(const PathElement& e) {
    return std::visit([](const auto& kind) { return coordinates_of(kind); }, e);
}

/// The parameter between `low` and `high`, where the coordinate is monotone, at which it is `wanted`: Newton's method
/// kept inside a shrinking bracket.
double solve(const Coordinate& c, double wanted, double low, double high, double tolerance) {
    if (c.radius == 0 && c.poly.k2 == 0 && c.poly.k3 == 0)
        return std::clamp((wanted - c.poly.k0) / c.poly.k1, low, high);
    const double sense = c.value(high) < c.value(low) ? -1 : 1;
    double u = low;
    for (int i = 0; i < 80; ++i) {
        const double off = c.value(u) - wanted;
        if (std::abs(off) <= tolerance && u > low) return u;
        (sense * off < 0 ? low : high) = u;
        const double newton = u - off / c.slope(u);
        u = newton > low && newton < high ? newton : (low + high) / 2;
    }
    return u;
}

/// The pulses of one axis, one after the other.
class AxisRun {
public:
    AxisRun(const Coordinate& c, double unit) : c_(c), unit_(unit), count_(grid(c.first)), turn_count_(count_) {
        find();
    }
    [[nodiscard]] double next() const { return next_; }
    [[nodiscard]] int direction() const { return direction_; }
    [[nodiscard]] double position() const { return count_ * unit_; }
    void step() {
        count_ += direction_;
        find();
    }

private:
    [[nodiscard]] double grid(double value) const { return std::floor(value / unit_ + 0.5); }

    void find() {
        while (count_ == turn_count_) {
            if (turn_ >= 1) {
                next_ = never;
                return;
            }
            now_ = turn_;
            turn_ = c_.next_turn(turn_);
            turn_count_ = grid(c_.value(turn_));
        }
        direction_ = turn_count_ > count_ ? 1 : -1;
        next_ = now_ = solve(c_, (count_ + 0.5 * direction_) * unit_, now_, turn_, solved * unit_);
    }

    const Coordinate& c_;
    double unit_;
    double count_, turn_count_;  ///< whole numbers of units: where the axis stands, and where it is to turn next
    double now_ = 0, turn_ = 0, next_ = never;
    int direction_ = 0;
};

/// Of differences within the grid, where the squares cannot overflow; std::hypot would be half of the time.
double norm(Vec3 v) { return std::sqrt(dot(v, v)); }

/// Nearest points of one element.
class Nearest {
public:
    Nearest(const PathElement& e, const std::array<Coordinate, 3>& c, double unit)
        : c_(c), line_(std::get_if<Straight>(&e)), close_(1e-7 * unit) {}

    /// Sets the step's ideal point and deviation by its grid point and parameter.
    void judge(GridStep& s) const {
        if (line_ != nullptr)
            on_line(s);
        else
            on_curve(s);
    }

private:
    void on_line(GridStep& s) const {
        const Vec3 d = line_->to - line_->from;
        const double square = dot(d, d);
        const double t = square > 0 ? std::clamp(dot(s.at - line_->from, d) / square, 0.0, 1.0) : 0;
        s.ideal = line_->from + t * d;
        s.deviation = norm(s.at - s.ideal);
    }

    void on_curve(GridStep& s) const {
        double u = s.u;
        s.ideal = point(u);
        s.deviation = norm(s.at - s.ideal);
        for (int i = 0; i < 8; ++i) {
            const Vec3 way = s.ideal - s.at, d{c_[0].slope(u), c_[1].slope(u), c_[2].slope(u)};
            const double speed = dot(d, d);
            if (!(speed > 0)) return;
            const double curved = speed + dot(way, {c_[0].bend(u), c_[1].bend(u), c_[2].bend(u)});
            const double to = std::clamp(u - dot(way, d) / std::max(curved, 0.1 * speed), 0.0, 1.0);
            const Vec3 ideal = point(to);
            const double off = norm(s.at - ideal), moved = std::abs(to - u) * std::sqrt(speed);
            if (!(off < s.deviation)) return;
            s.ideal = ideal;
            s.deviation = off;
            u = to;
            if (moved < close_) return;
        }
    }

    [[nodiscard]] Vec3 point(double u) const { return {c_[0].value(u), c_[1].value(u), c_[2].value(u)}; }

    const std::array<Coordinate, 3>& c_;
    const Straight* line_;
    double close_;
};

/// Largest magnitude a coordinate can take, or NaN.
double reach(const Coordinate& c) {
    const double span = std::abs(c.poly.k0) + std::abs(c.poly.k1) + std::abs(c.poly.k2) + std::abs(c.poly.k3);
    return span + c.radius + 0 * (c.sweep + c.phase + c.first + c.last);
}

/// No coordinate changes faster by the parameter.
double fastest(const std::array<Coordinate, 3>& coordinates) {
    double most = 0;
    for (const Coordinate& c : coordinates)
        most = std::max(most, std::abs(c.poly.k1) + 2 * std::abs(c.poly.k2) + 3 * std::abs(c.poly.k3) +
                                  c.radius * std::abs(c.sweep));
    return most;
}

/// Largest and mean of the deviations. The place of the largest is the first of those that rounding makes differ.
struct Figures {
    Staircase& result;
    double rounding;  ///< mm
    double sum = 0;
    void add(const GridStep& s) {
        sum += s.deviation;
        result.largest = std::max(result.largest, s.deviation);
        if (s.axis < 0 || s.deviation > result.worst.deviation + rounding) result.worst = s;
    }
};

}  // namespace

Vec3 point_at(const PathElement& e, double u) {
    const auto c = coordinates_of(e);
    return {c[0].value(u), c[1].value(u), c[2].value(u)};
}

Vec3 derivative_at(const PathElement& e, double u) {
    const auto c = coordinates_of(e);
    return {c[0].slope(u), c[1].slope(u), c[2].slope(u)};
}

Staircase staircase(const PathElement& e, double unit, base::FunctionRef<void(const GridStep&)> step,
                    std::uint64_t most_steps) {
    Staircase r;
    const std::array<Coordinate, 3> c = coordinates_of(e);
    if (!(unit > 0) || !std::isfinite(unit)) return r;
    for (const Coordinate& axis : c)
        if (!(reach(axis) / unit < largest_count) || !(std::abs(axis.sweep) <= largest_sweep)) return r;
    std::array<AxisRun, 3> axes{AxisRun(c[0], unit), AxisRun(c[1], unit), AxisRun(c[2], unit)};
    const Nearest nearest(e, c, unit);
    Figures figures{r, solved * unit};
    GridStep s{-1, 0, 0, {axes[0].position(), axes[1].position(), axes[2].position()}, {}, 0};
    r.start = s.at;
    nearest.judge(s);
    figures.add(s);
    const double together = 2 * solved * unit / fastest(c);
    for (;;) {
        std::size_t first = 0;
        for (std::size_t i = 1; i < 3; ++i)
            if (axes[i].next() < axes[first].next() - together) first = i;
        if (axes[first].next() == never) break;
        if (r.steps == most_steps) {
            r.end_reason = StaircaseEnd::too_long;
            break;
        }
        s.axis = static_cast<int>(first);
        s.direction = axes[first].direction();
        s.u = std::max(s.u, axes[first].next());
        axes[first].step();
        coordinate(s.at, first) = axes[first].position();
        nearest.judge(s);
        ++r.steps;
        ++r.steps_of_axis[first];
        figures.add(s);
        step(s);
    }
    if (r.end_reason != StaircaseEnd::too_long) r.end_reason = StaircaseEnd::reached;
    r.end = s.at;
    r.mean = figures.sum / static_cast<double>(r.steps + 1);
    return r;
}

Staircase staircase(const PathElement& e, double unit) {
    return staircase(e, unit, [](const GridStep&) {});
}

}  // namespace obrys::geom
