#include "sim/certify/joined.hpp"

#include <algorithm>
#include <cmath>

namespace obrys::sim::certify {

namespace {

constexpr double same = 1e-9;

bool is_upright(const Body& b) { return b.rounding == 0 && b.z1 > b.z0 + same; }

double growth(const Body& b) { return (b.r1 - b.r0) / (b.z1 - b.z0); }

bool stands_on(const Body& upper, const Body& lower) {
    return is_upright(lower) && std::abs(upper.z0 - lower.z1) <= same && std::abs(upper.r0 - lower.r1) <= same &&
           growth(upper) <= growth(lower) + same;
}

/// The widest of a ball or a round rim carries the body.
bool is_carried(const Body& body, const Shape& shape) {
    return std::any_of(shape.begin(), shape.end(), [&](const Body& b) {
        return b.rounding > 0 && b.r0 == b.r1 && std::abs(b.z1 - body.z0) <= same &&
               std::abs(b.r1 + b.rounding - body.r0) <= same;
    });
}

/// The flank moved inwards: its radius at height 0 and how it grows.
struct Line {
    double at = 0, rises = 0;
    [[nodiscard]] double radius(double z) const { return at + rises * z; }
};

Line flank_of(const Body& b, double depth) {
    const double k = growth(b);
    return {b.r0 - k * b.z0 - depth * std::hypot(1.0, k), k};
}

double meeting(const Line& a, const Line& b) { return (b.at - a.at) / (a.rises - b.rises); }

}  // namespace

bool Joined::holds(const Body& body) const {
    return std::any_of(bodies.begin(), bodies.end(), [&](const Body& b) {
        return b.rounding == body.rounding && b.z0 == body.z0 && b.z1 == body.z1 && b.r0 == body.r0 && b.r1 == body.r1;
    });
}

std::vector<Joined> joined_in(const Shape& shape) {
    std::vector<Joined> out;
    for (std::size_t first = 0, end = 0; first < shape.size(); first = end) {
        end = first + 1;
        if (!is_upright(shape[first])) continue;
        while (end < shape.size() && is_upright(shape[end]) && stands_on(shape[end], shape[end - 1])) ++end;
        const bool carried = is_carried(shape[first], shape);
        if (end - first > 1 || carried) out.push_back({std::span(shape).subspan(first, end - first), carried});
    }
    return out;
}

Shape core_of(const Joined& joined, double depth) {
    const Body &lowest = joined.bodies.front(), &highest = joined.bodies.back();
    double low = lowest.z0 + (joined.open_below ? 0 : depth), high = highest.z1 - depth;
    // Of the flanks those that are nearest to the axis somewhere: upwards they grow less and less.
    std::vector<Line> lines;
    for (const Body& b : joined.bodies) {
        const Line line = flank_of(b, depth);
        if (!lines.empty() && lines.back().rises - line.rises <= same) {
            lines.back().at = std::min(lines.back().at, line.at);
            continue;
        }
        while (lines.size() > 1 && meeting(lines.back(), line) <= meeting(lines[lines.size() - 2], lines.back()))
            lines.pop_back();
        lines.push_back(line);
    }
    Shape out;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const Line& l = lines[i];
        double from = i == 0 ? low : std::max(low, meeting(lines[i - 1], l));
        double to = i + 1 == lines.size() ? high : std::min(high, meeting(l, lines[i + 1]));
        if (l.rises > 0) from = std::max(from, -l.at / l.rises);
        if (l.rises < 0) to = std::min(to, -l.at / l.rises);
        if (!(from < to) || (l.rises == 0 && l.at < 0)) continue;
        out.push_back({std::max(0.0, l.radius(from)), from, std::max(0.0, l.radius(to)), to, 0});
    }
    return out;
}

}  // namespace obrys::sim::certify
