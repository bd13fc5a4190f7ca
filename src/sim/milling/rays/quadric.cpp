// Cylinder, cone or zone of a ball on a straight way against a ray in any direction. Every point p + s d - t v of the
// plane (s, t) that lies inside the piece belongs to what is removed: a convex region bounded by a conic, the two
// planes that end the piece, and t = 0 and 1. Its smallest and largest s lie where the conic turns or where two of
// these meet.

#include <algorithm>
#include <array>
#include <cmath>

#include "sim/milling/rays/rows.hpp"

namespace obrys::sim::milling::detail {
namespace {

using geom::Vec3;

constexpr double near = 1e-9;  ///< mm; points this far outside still count

/// The piece as qx^2 + qy^2 <= a z^2 + b z + c.
struct Quadric {
    double a = 0, b = 0, c = 0;
    [[nodiscard]] double product(Vec3 p, Vec3 q) const { return p.x * q.x + p.y * q.y - a * p.z * q.z; }
    [[nodiscard]] double value(Vec3 p) const { return product(p, p) - b * p.z - c; }
};

Quadric quadric_of(const Piece& p) {
    if (p.kind == PieceKind::round) return {-1, 2 * p.centre, p.arc * p.arc - p.centre * p.centre};
    const double growth = (p.r1 - p.r0) / (p.z1 - p.z0), at_zero = p.r0 - growth * p.z0;
    return {growth * growth, 2 * growth * at_zero, at_zero * at_zero};
}

struct Roots {
    std::array<double, 2> x{};
    int count = 0;
};
/// a x^2 + 2 b x + c = 0, also where a is next to nothing.
Roots solve(double a, double b, double c) {
    const double d = b * b - a * c;
    if (!(d >= 0)) return {};
    const double q = -(b + std::copysign(std::sqrt(d), b));
    Roots r;
    if (std::abs(a) > 1e-300) r.x[static_cast<std::size_t>(r.count++)] = q / a;
    if (q != 0) r.x[static_cast<std::size_t>(r.count++)] = c / q;
    return r;
}

class Region {
public:
    Region(const Piece& piece, Vec3 v, Vec3 p, Vec3 d)
        : piece_(piece), q_(quadric_of(piece)), v_(v), p_(p), d_(d), way_(length(v)) {
        slack_ = 2 * near * std::max({piece.r0, piece.r1, piece.arc, near});
    }

    bool run(double& low, double& high) {
        conic_turns();
        for (const double t : {0.0, 1.0}) conic_at(t);
        for (const double z : {piece_.z0, piece_.z1}) plane(z);
        low = low_;
        high = high_;
        return low_ < high_;
    }

private:
    void offer(double s, double t) {
        if (!(t * way_ >= -near && (t - 1) * way_ <= near)) return;
        const Vec3 q = p_ + s * d_ - t * v_;
        if (!(q.z >= piece_.z0 - near && q.z <= piece_.z1 + near) || !(q_.value(q) <= slack_)) return;
        low_ = std::min(low_, s);
        high_ = std::max(high_, s);
    }
    void conic_turns() {
        const double vv = q_.product(v_, v_);
        if (std::abs(vv) < 1e-14 * dot(v_, v_)) return;
        // t as a linear function of s from dQ/dt = 0, then Q = 0.
        const double t0 = (q_.product(p_, v_) - q_.b * v_.z / 2) / vv, t1 = q_.product(d_, v_) / vv;
        const Vec3 at = p_ - t0 * v_, direction = d_ - t1 * v_;
        const Roots r =
            solve(q_.product(direction, direction), q_.product(at, direction) - q_.b * direction.z / 2, q_.value(at));
        for (int i = 0; i < r.count; ++i)
            offer(r.x[static_cast<std::size_t>(i)], t0 + t1 * r.x[static_cast<std::size_t>(i)]);
    }
    void conic_at(double t) {
        const Vec3 at = p_ - t * v_;
        const Roots r = solve(q_.product(d_, d_), q_.product(at, d_) - q_.b * d_.z / 2, q_.value(at));
        for (int i = 0; i < r.count; ++i) offer(r.x[static_cast<std::size_t>(i)], t);
    }
    /// The line p.z + s d.z - t v.z = z.
    void plane(double z) {
        if (std::abs(d_.z) < 1e-12 && std::abs(v_.z) < 1e-12 * way_) return;
        if (std::abs(d_.z) * way_ >= std::abs(v_.z)) {
            const double s0 = (z - p_.z) / d_.z, s1 = v_.z / d_.z;
            const Vec3 at = p_ + s0 * d_, direction = s1 * d_ - v_;
            const Roots r = solve(q_.product(direction, direction), q_.product(at, direction) - q_.b * direction.z / 2,
                                  q_.value(at));
            for (int i = 0; i < r.count; ++i) {
                const double t = r.x[static_cast<std::size_t>(i)];
                offer(s0 + t * s1, t);
            }
            for (const double t : {0.0, 1.0}) offer(s0 + t * s1, t);
            return;
        }
        const double t0 = (p_.z - z) / v_.z, t1 = d_.z / v_.z;
        const Vec3 at = p_ - t0 * v_, direction = d_ - t1 * v_;
        const Roots r =
            solve(q_.product(direction, direction), q_.product(at, direction) - q_.b * direction.z / 2, q_.value(at));
        for (int i = 0; i < r.count; ++i) {
            const double s = r.x[static_cast<std::size_t>(i)];
            offer(s, t0 + t1 * s);
        }
        if (t1 != 0)
            for (const double t : {0.0, 1.0}) offer((t - t0) / t1, t);
    }

    const Piece& piece_;
    Quadric q_;
    Vec3 v_, p_, d_;
    double way_ = 0, slack_ = 0;
    double low_ = std::numeric_limits<double>::infinity(), high_ = -std::numeric_limits<double>::infinity();
};

}  // namespace

bool cut_quadric(const Piece& piece, Vec3 v, Vec3 p, Vec3 d, double& low, double& high) {
    return Region(piece, v, p, d).run(low, high);
}

}  // namespace obrys::sim::milling::detail
