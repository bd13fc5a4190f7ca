#include "geom/nurbs.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace obrys::geom {

namespace {

constexpr int deepest = 20;  ///< halvings of a knot interval

/// A point times its weight, and the weight.
struct Weighted {
    Vec3 p;
    double w = 1;
};
Weighted mixed(const Weighted& a, const Weighted& b, double t) {
    const double s = 1 - t;
    return {s * a.p + t * b.p, s * a.w + t * b.w};
}
Vec3 projected(const Weighted& a) { return {a.p.x / a.w, a.p.y / a.w, a.p.z / a.w}; }

/// Bezier points of a piece of the curve, and the range of the curve's parameter it stands for.
struct Arch {
    std::vector<Weighted> points;
    double from = 0, to = 0;
    int depth = 0;
};

/// The control points with their weights, which are divided by the largest: equal ones are exactly 1.
std::vector<Weighted> weighted(const Nurbs& c) {
    double largest = 0;
    for (const NurbsPoint& p : c.points) largest = std::max(largest, p.weight);
    std::vector<Weighted> out;
    out.reserve(c.points.size());
    for (const NurbsPoint& p : c.points) {
        const double w = p.weight / largest;
        out.push_back({w * p.p, w});
    }
    return out;
}

/// The polar form of the curve on the knot interval `span`: de Boor's steps, each with its own parameter. With all
/// arguments u it is the point at u; with i of them the interval's end and the others its start, its Bezier point i.
template <class Argument>
Weighted polar(const std::vector<Weighted>& points, const Nurbs& c, std::size_t span, Argument argument) {
    const std::size_t degree = static_cast<std::size_t>(c.order) - 1;
    std::array<Weighted, largest_order> d{};
    for (std::size_t i = 0; i <= degree; ++i) d[i] = points[span - degree + i];
    for (std::size_t r = 1; r <= degree; ++r)
        for (std::size_t i = degree; i >= r; --i) {
            const double low = c.knots[span - degree + i], high = c.knots[span + 1 + i - r];
            d[i] = mixed(d[i - 1], d[i], (argument(r) - low) / (high - low));
        }
    return d[degree];
}

std::size_t span_of(const Nurbs& c, double u) {
    const auto first = c.knots.begin() + (c.order - 1);
    const auto last = c.knots.begin() + static_cast<std::ptrdiff_t>(c.points.size());
    const auto above = std::upper_bound(first, last, u);
    auto span = static_cast<std::size_t>(above - c.knots.begin()) - 1;
    while (span > static_cast<std::size_t>(c.order) - 1 && c.knots[span] == c.knots[span + 1]) --span;
    return span;
}

std::vector<Arch> arches(const Nurbs& c) {
    const std::vector<Weighted> points = weighted(c);
    const std::size_t degree = static_cast<std::size_t>(c.order) - 1;
    std::vector<Arch> out;
    for (std::size_t span = degree; span < c.points.size(); ++span) {
        const double from = c.knots[span], to = c.knots[span + 1];
        if (from == to) continue;
        Arch a{{}, from, to, 0};
        for (std::size_t i = 0; i <= degree; ++i)
            a.points.push_back(polar(points, c, span, [&](std::size_t r) { return r <= i ? to : from; }));
        if (!out.empty()) a.points.front() = out.back().points.back();  // the same but for rounding
        out.push_back(std::move(a));
    }
    return out;
}

/// The cubic with the same ends and the same derivatives there as the arch over 0..1, as Bezier points.
std::array<Vec3, 4> hermite(const std::vector<Weighted>& b) {
    const std::size_t d = b.size() - 1;
    const Vec3 start = projected(b[0]), end = projected(b[d]);
    const double third = static_cast<double>(d) / 3;
    const Vec3 leaving = (third * b[1].w / b[0].w) * (projected(b[1]) - start);
    const Vec3 arriving = (third * b[d - 1].w / b[d].w) * (end - projected(b[d - 1]));
    return {start, start + leaving, end - arriving, end};
}

double binomial(std::size_t n, std::size_t k) {
    double out = 1;
    for (std::size_t i = 1; i <= k; ++i) out = out * static_cast<double>(n - k + i) / static_cast<double>(i);
    return out;
}

/// Upper bound of the distance between arch and cubic at the same parameter. Arch minus cubic is a polynomial over the
/// arch's weight function; the largest Bezier point of the one and the least of the other bound it.
double bound(const std::vector<Weighted>& b, const std::array<Vec3, 4>& cubic) {
    const std::size_t d = b.size() - 1;
    double least = b[0].w, largest = 0;
    for (const Weighted& p : b) least = std::min(least, p.w);
    for (std::size_t k = 0; k <= d + 3; ++k) {
        Vec3 sum;
        for (std::size_t i = k > 3 ? k - 3 : 0; i <= std::min(k, d); ++i) {
            const double share = binomial(d, i) * binomial(3, k - i) / binomial(d + 3, k);
            sum = sum + share * (b[i].p - b[i].w * cubic[k - i]);
        }
        if (!is_finite(sum)) return NAN;
        largest = std::max(largest, length(sum));
    }
    return largest / least;
}

std::pair<Arch, Arch> halves(const Arch& a) {
    const double middle = (a.from + a.to) / 2;
    Arch left{{}, a.from, middle, a.depth + 1}, right{a.points, middle, a.to, a.depth + 1};
    std::vector<Weighted>& p = right.points;
    for (std::size_t r = p.size(); r > 0; --r) {
        left.points.push_back(p[0]);
        for (std::size_t i = 0; i + 1 < r; ++i) p[i] = mixed(p[i], p[i + 1], 0.5);
    }
    return {std::move(left), std::move(right)};
}

Cubic exact(const std::vector<Weighted>& b) {
    if (b.size() == 2) return {b[0].p, b[1].p - b[0].p, {}, {}};
    if (b.size() == 3) return bezier(b[0].p, b[1].p, b[2].p);
    return bezier(b[0].p, b[1].p, b[2].p, b[3].p);
}

void approximate(std::vector<Arch> todo, double tolerance, std::size_t most, NurbsPieces& out) {
    std::reverse(todo.begin(), todo.end());
    while (!todo.empty()) {
        Arch a = std::move(todo.back());
        todo.pop_back();
        const std::array<Vec3, 4> c = hermite(a.points);
        const double distance = bound(a.points, c);
        const bool room = out.pieces.size() + todo.size() + 2 <= most;
        if (distance > tolerance && std::isfinite(distance) && a.depth < deepest && room) {
            auto [left, right] = halves(a);
            todo.push_back(std::move(right));
            todo.push_back(std::move(left));
            continue;
        }
        out.pieces.push_back({bezier(c[0], c[1], c[2], c[3]), a.from, a.to});
        if (!std::isfinite(distance)) out.deviation = NAN;
        if (distance > out.deviation) out.deviation = distance;
    }
}

bool knots_fit(const Nurbs& c) {
    const auto order = static_cast<std::size_t>(c.order);
    if (c.knots.size() != c.points.size() + order || !std::is_sorted(c.knots.begin(), c.knots.end())) return false;
    if (!std::all_of(c.knots.begin(), c.knots.end(), [](double k) { return std::isfinite(k); })) return false;
    const double first = c.knots[order - 1], last = c.knots[c.points.size()];
    if (!(first < last) || !std::isfinite(last - first)) return false;
    for (std::size_t i = 0; i + order < c.knots.size(); ++i)
        if (c.knots[i] == c.knots[i + order]) return false;
    for (std::size_t i = 0; i + order <= c.knots.size(); ++i) {
        const double k = c.knots[i];
        if (k == c.knots[i + order - 1] && k > first && k < last) return false;
    }
    return true;
}

}  // namespace

Cubic bezier(Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
    return {a, 3.0 * (b - a), 3.0 * ((c - b) - (b - a)), (d - a) - 3.0 * (c - b)};
}

Cubic bezier(Vec3 a, Vec3 b, Vec3 c) { return {a, 2.0 * (b - a), (c - b) - (b - a), {}}; }

std::vector<double> clamped_knots(std::size_t points, int order) {
    std::vector<double> out;
    if (order < 2 || points < static_cast<std::size_t>(order)) return out;
    const auto k = static_cast<std::size_t>(order);
    for (std::size_t i = 0; i < points + k; ++i)
        out.push_back(static_cast<double>(std::clamp(i, k - 1, points) - (k - 1)));
    return out;
}

bool is_valid(const Nurbs& c) {
    if (c.order < 2 || c.order > largest_order || c.points.size() < static_cast<std::size_t>(c.order)) return false;
    for (const NurbsPoint& p : c.points)
        if (!is_finite(p.p) || !std::isfinite(p.weight) || !(p.weight > 0)) return false;
    return knots_fit(c);
}

Vec3 point_at(const Nurbs& c, double u) {
    const double low = c.knots[static_cast<std::size_t>(c.order) - 1], high = c.knots[c.points.size()];
    const double at = std::clamp(u, low, high);
    return projected(polar(weighted(c), c, span_of(c, at), [&](std::size_t) { return at; }));
}

std::optional<NurbsPieces> cubic_pieces(const Nurbs& curve, double tolerance, std::size_t most) {
    if (!is_valid(curve) || !(tolerance > 0)) return std::nullopt;
    NurbsPieces out;
    const double weight = curve.points.front().weight;
    const bool equal =
        std::all_of(curve.points.begin(), curve.points.end(), [&](const NurbsPoint& p) { return p.weight == weight; });
    std::vector<Arch> parts = arches(curve);
    if (!equal || curve.order > 4) {
        approximate(std::move(parts), tolerance, most, out);
        return out;
    }
    for (const Arch& a : parts) {
        const Cubic c = exact(a.points);
        if (!is_finite(c.k0 + c.k1 + c.k2 + c.k3)) out.deviation = NAN;
        out.pieces.push_back({c, a.from, a.to});
    }
    return out;
}

}  // namespace obrys::geom
