#include "cycles/groove/skyline.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace obrys::cycles::groove {

namespace {

constexpr double shortest_stretch = 1e-12;

Stretch line(double begin, double end, double from, double to) { return {begin, end, from, to, {}, 0, 0}; }

Stretch part(const Stretch& s, double begin, double end) {
    Stretch p = s;
    p.begin = begin;
    p.end = end;
    if (s.half == 0) {
        p.from = s.at(begin);
        p.to = s.at(end);
    }
    return p;
}

double half_chord(double r, double d) { return std::sqrt(std::max(0.0, r * r - d * d)); }

/// Where a line meets the whole circle of an arc.
void crossings_of(const Stretch& l, const Stretch& arc, std::vector<double>& at) {
    const double k = (l.to - l.from) / (l.end - l.begin);
    const double c = l.from + k * (arc.centre.x - l.begin) - arc.centre.y;  // v - centre.y at u = centre.x
    // (d)^2 + (c + k d)^2 = r^2 with d = u - centre.x
    const double a = 1 + k * k, b = k * c, disc = b * b - a * (c * c - arc.radius * arc.radius);
    if (disc < 0) return;
    for (const double sign : {-1.0, 1.0}) at.push_back(arc.centre.x + (-b + sign * std::sqrt(disc)) / a);
}

void crossings_of_circles(const Stretch& a, const Stretch& b, std::vector<double>& at) {
    const geom::Vec2 d = b.centre - a.centre;
    const double far = geom::length(d);
    if (far < 1e-12) return;
    const double along = (far * far + a.radius * a.radius - b.radius * b.radius) / (2 * far);
    const double square = a.radius * a.radius - along * along;
    if (square < 0) return;
    const double h = std::sqrt(square);
    for (const double sign : {-1.0, 1.0}) at.push_back(a.centre.x + (along * d.x - sign * h * d.y) / far);
}

/// u inside (begin, end) where both have one height.
std::vector<double> crossings(const Stretch& a, const Stretch& b, double begin, double end) {
    std::vector<double> at;
    if (a.half == 0 && b.half == 0) {
        const double d0 = a.at(begin) - b.at(begin), d1 = a.at(end) - b.at(end);
        if ((d0 < 0) != (d1 < 0) && d0 != d1) at.push_back(begin + (end - begin) * d0 / (d0 - d1));
    } else if (a.half == 0) {
        crossings_of(a, b, at);
    } else if (b.half == 0) {
        crossings_of(b, a, at);
    } else {
        crossings_of_circles(a, b, at);
    }
    std::erase_if(at, [&](double u) { return !(u > begin && u < end); });
    std::sort(at.begin(), at.end());
    return at;
}

void append(std::vector<Stretch>& to, const Stretch& s) {
    if (!to.empty()) {
        Stretch& last = to.back();
        const bool level = last.half == 0 && s.half == 0 && last.from == last.to && s.from == s.to && last.to == s.from;
        const bool round = s.half != 0 && last.half == s.half && last.centre == s.centre && last.radius == s.radius;
        if (level || round) {
            last.end = s.end;
            return;
        }
    }
    to.push_back(s);
}

}  // namespace

double Stretch::at(double u) const {
    if (half != 0) return centre.y + half * half_chord(radius, u - centre.x);
    if (end - begin < shortest_stretch) return std::max(from, to);
    const double t = (u - begin) / (end - begin);
    return t <= 0.5 ? from + t * (to - from) : to - (1 - t) * (to - from);
}

double Stretch::area_below(double a, double b) const {
    if (half == 0) return (at(a) + at(b)) / 2 * (b - a);
    const auto integral = [&](double u) {
        const double d = std::clamp(u - centre.x, -radius, radius);
        return (d * half_chord(radius, d) + radius * radius * std::asin(d / radius)) / 2;
    };
    return centre.y * (b - a) + half * (integral(b) - integral(a));
}

Skyline::Skyline(geom::Vec2 p, double slope, double begin, double end) {
    const double k = std::tan(slope);
    stretches_.push_back(line(begin, end, p.y + k * (begin - p.x), p.y + k * (end - p.x)));
}

double Skyline::highest(double begin, double end) const {
    double top = -std::numeric_limits<double>::infinity();
    for (const Stretch& s : stretches_) {
        const double a = std::max(begin, s.begin), b = std::min(end, s.end);
        if (b - a < 1e-10) continue;
        top = std::max({top, s.at(a), s.at(b)});
        if (s.half == 1 && s.centre.x > a && s.centre.x < b) top = std::max(top, s.centre.y + s.radius);
    }
    return top;
}

double Skyline::at(double u) const {
    for (const Stretch& s : stretches_)
        if (u >= s.begin && u <= s.end) return s.at(u);
    return -std::numeric_limits<double>::infinity();
}

double Skyline::open_area(double begin, double end, double v, const Skyline& top) const {
    double area = 0;
    for (const Stretch& s : stretches_) {
        const double a = std::max(begin, s.begin), b = std::min(end, s.end);
        if (b <= a) continue;
        const double high = top.at((a + b) / 2);
        const Stretch floor = line(a, b, v, v);
        std::vector<double> at = crossings(s, floor, a, b);
        at.insert(at.begin(), a);
        at.push_back(b);
        for (std::size_t i = 0; i + 1 < at.size(); ++i) {
            const double middle = (at[i] + at[i + 1]) / 2, width = at[i + 1] - at[i];
            const double below = s.at(middle) > v ? s.area_below(at[i], at[i + 1]) : v * width;
            area += std::max(0.0, high * width - below);
        }
    }
    return area;
}

template <class Keep>
Removed Skyline::against(const std::vector<Stretch>& lower, Keep&& keep) const {
    Removed removed;
    for (const Stretch& s : stretches_) {
        double done = s.begin;
        for (const Stretch& low : lower) {
            const double a = std::max(s.begin, low.begin), b = std::min(s.end, low.end);
            if (b - a < shortest_stretch) continue;
            if (a > done) keep(part(s, done, a));
            std::vector<double> at = crossings(s, low, a, b);
            at.insert(at.begin(), a);
            at.push_back(b);
            for (std::size_t i = 0; i + 1 < at.size(); ++i) {
                const double p = at[i], q = at[i + 1], middle = (p + q) / 2;
                if (!(low.at(middle) < s.at(middle)) || q - p < shortest_stretch) {
                    keep(part(s, p, q));
                    continue;
                }
                keep(part(low, p, q));
                removed.area += s.area_below(p, q) - low.area_below(p, q);
                for (const double u : {p, middle, q}) removed.depth = std::max(removed.depth, s.at(u) - low.at(u));
            }
            done = b;
        }
        if (s.end > done) keep(part(s, done, s.end));
    }
    return removed;
}

Removed Skyline::cut(const BladeMove& move, double blade) {
    std::vector<Stretch> next;
    next.reserve(stretches_.size() + 4);
    const Removed removed = against(lowest(move, blade), [&](const Stretch& s) { append(next, s); });
    stretches_ = std::move(next);
    return removed;
}

Removed Skyline::met(const BladeMove& move, double blade) const {
    return against(lowest(move, blade), [](const Stretch&) {});
}

std::vector<Stretch> lowest(const BladeMove& move, double blade) {
    geom::Vec2 high = move.from, low = move.to;
    if (low.y > high.y) std::swap(high, low);
    std::vector<Stretch> s;
    const Stretch flat = line(low.x, low.x + blade, low.y, low.y);
    if (high.x == low.x && move.sweep == 0) return {flat};
    const bool to_right = low.x > high.x;
    const double shift = to_right ? 0 : blade;
    const double begin = std::min(high.x, low.x) + shift, end = std::max(high.x, low.x) + shift;
    Stretch way = to_right ? line(begin, end, high.y, low.y) : line(begin, end, low.y, high.y);
    if (move.sweep != 0) {
        way.centre = {move.centre.x + shift, move.centre.y};
        way.radius = geom::distance(move.centre, move.from);
        way.half = (high.y + low.y) / 2 < move.centre.y ? -1 : 1;
    }
    return to_right ? std::vector<Stretch>{way, flat} : std::vector<Stretch>{flat, way};
}

}  // namespace obrys::cycles::groove
