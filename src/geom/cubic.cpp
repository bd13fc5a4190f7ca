#include "geom/cubic.hpp"

#include <algorithm>
#include <vector>

#include "base/whole.hpp"

namespace obrys::geom {

namespace {

bool is_finite(const Polynomial3& p) {
    return std::isfinite(p.k0) && std::isfinite(p.k1) && std::isfinite(p.k2) && std::isfinite(p.k3);
}

/// Nodes and weights of the Gauss-Legendre rule with ten points, for -1..1 (Abramowitz and Stegun, table 25.4).
constexpr std::array<double, 5> nodes{0.14887433898163121089, 0.43339539412924719080, 0.67940956829902440623,
                                      0.86506336668898451073, 0.97390652851717172008};
constexpr std::array<double, 5> weights{0.29552422471475287017, 0.26926671930999635509, 0.21908636251598204400,
                                        0.14945134915058059315, 0.06667134430868813759};

double speed(const Cubic& c, double t) { return length(derivative_at(c, t)); }

double gauss(const Cubic& c, double t0, double t1) {
    const double middle = (t0 + t1) / 2, half = (t1 - t0) / 2;
    double sum = 0;
    for (std::size_t i = 0; i < nodes.size(); ++i)
        sum += weights[i] * (speed(c, middle - half * nodes[i]) + speed(c, middle + half * nodes[i]));
    return half * sum;
}

bool is_zero(Vec3 v) { return v.x == 0 && v.y == 0 && v.z == 0; }

/// The vector divided by its largest coordinate, then by its length: does not overflow.
Vec3 unit(Vec3 v) {
    const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
    const Vec3 scaled{v.x / largest, v.y / largest, v.z / largest};
    return (1 / length(scaled)) * scaled;
}

}  // namespace

Turns turns(const Polynomial3& p) {
    Turns out;
    const auto add = [&out](double t) {
        if (t > 0 && t < 1) out.t[static_cast<std::size_t>(out.count++)] = t;
    };
    // a t^2 + 2 b t + c = 0, without cancellation and overflow.
    const double scale = std::max({std::abs(p.k3), std::abs(p.k2), std::abs(p.k1)});
    const double a = 3 * (p.k3 / scale), b = p.k2 / scale, c = p.k1 / scale;
    const double root = b * b - a * c;
    if (scale == 0 || (a == 0 && b == 0)) return out;
    if (a == 0) {
        add(-c / (2 * b));
    } else if (root > 0) {
        const double q = -(b + std::copysign(std::sqrt(root), b));
        add(q / a);
        if (q != 0) add(c / q);
        if (out.count == 2 && out.t[0] > out.t[1]) std::swap(out.t[0], out.t[1]);
    }
    return out;
}

std::pair<double, double> range(const Polynomial3& p) {
    if (!is_finite(p)) return {NAN, NAN};
    auto [low, high] = std::minmax({p.k0, value_at(p, 1)});
    const Turns at = turns(p);
    for (int i = 0; i < at.count; ++i) {
        const double v = value_at(p, at.t[static_cast<std::size_t>(i)]);
        low = std::min(low, v);
        high = std::max(high, v);
    }
    return {low, high};
}

Cubic reversed(const Cubic& c) {
    return {point_at(c, 1), -1 * (c.k1 + 2 * c.k2 + 3 * c.k3), c.k2 + 3 * c.k3, -1 * c.k3};
}

Vec3 leaving(const Cubic& c) {
    for (const Vec3& v : {c.k1, c.k2, c.k3})
        if (!is_zero(v)) return unit(v);
    return {};
}

double curve_length(const Cubic& c, double t0, double t1) {
    if (!is_finite(c.k1) || !is_finite(c.k2) || !is_finite(c.k3)) return NAN;
    struct Piece {
        double t0, t1, estimate;
    };
    const double whole = gauss(c, t0, t1);
    if (!std::isfinite(whole)) return NAN;
    const double allowed = std::max(1e-12, 1e-15 * whole);  // mm a piece; the halves are far better than this says
    std::vector<Piece> open{{t0, t1, whole}};
    double sum = 0;
    for (int budget = 4000; !open.empty(); --budget) {
        const Piece p = open.back();
        open.pop_back();
        const double middle = (p.t0 + p.t1) / 2;
        const double left = gauss(c, p.t0, middle), right = gauss(c, middle, p.t1);
        if (budget <= 0 || std::abs(left + right - p.estimate) <= allowed) {
            sum += left + right;
            continue;
        }
        open.push_back({p.t0, middle, left});
        open.push_back({middle, p.t1, right});
    }
    return sum;
}

Box3 box(const Cubic& c) {
    const auto [x0, x1] = range(component(c, 0));
    const auto [y0, y1] = range(component(c, 1));
    const auto [z0, z1] = range(component(c, 2));
    return {{x0, y0, z0}, {x1, y1, z1}};
}

int chord_count(const Cubic& c, double tolerance) {
    // A chord over the parameter h leaves the curve by h^2/8 of the largest second derivative at most, and that is
    // linear.
    const double bend = std::max(length(2 * c.k2), length(2 * c.k2 + 6 * c.k3));
    const double count = std::ceil(std::sqrt(bend / (8 * tolerance)));
    return std::isfinite(count) ? base::clipped<int>(count, 1, 10'000) : 1;
}

Cubic parabola(Vec3 a, Vec3 b, Vec3 c) { return {a, 4 * b - 3 * a - c, 2 * (a + c) - 4 * b, {}}; }

double angle_between(Vec3 a, Vec3 b) {
    if (is_zero(a) || is_zero(b)) return NAN;
    return std::atan2(length(cross(a, b)), dot(a, b));
}

}  // namespace obrys::geom
