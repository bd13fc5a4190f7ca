#include "sim/milling/surface/qef.hpp"

#include <algorithm>
#include <cmath>

#include "sim/milling/lattice.hpp"

namespace obrys::sim::milling {

namespace {

using geom::Vec3;
using Triple = std::array<double, 3>;

/// Directions along which the planes' normals spread by less than the root of this (radians) are hardly determined.
constexpr double weak = 1e-3;
/// Normals nearer to each other than this (radians) belong to one plane face: most of a stock's surface.
constexpr double one_plane = 1e-6;
/// Each step takes a direction's error down to weak / (weak + spread^2) of what it was.
constexpr int steps = 4;

/// Least squares A d = b in the directions that are not fixed, drawn towards 0.
struct System {
    std::array<Triple, 3> a{};
    Triple b{};
    double planes = 0;
    std::array<bool, 3> fixed{};
    Triple at{};  ///< where a direction is fixed

    [[nodiscard]] Triple solve() const;

private:
    [[nodiscard]] std::array<Triple, 3> factor() const;
};

/// Cholesky's factor of A + weak * planes * 1, with the rows of fixed directions replaced by those of the unit matrix.
std::array<Triple, 3> System::factor() const {
    std::array<Triple, 3> l{};
    for (std::size_t r = 0; r < 3; ++r)
        for (std::size_t c = 0; c <= r; ++c) {
            double sum = r == c ? 1.0 : 0.0;
            if (!fixed[r] && !fixed[c]) sum = a[r][c] + (r == c ? weak * planes : 0.0);
            for (std::size_t i = 0; i < c; ++i) sum -= l[r][i] * l[c][i];
            l[r][c] = r == c ? std::sqrt(std::max(sum, 1e-30)) : sum / l[c][c];
        }
    return l;
}

Triple System::solve() const {
    const std::array<Triple, 3> l = factor();
    Triple d{};
    for (std::size_t i = 0; i < 3; ++i)
        if (fixed[i]) d[i] = at[i];
    for (int step = 0; step < steps; ++step) {
        Triple r{};
        for (std::size_t i = 0; i < 3; ++i) {
            if (fixed[i]) continue;
            r[i] = b[i] - a[i][0] * d[0] - a[i][1] * d[1] - a[i][2] * d[2];
        }
        for (std::size_t i = 0; i < 3; ++i) {
            for (std::size_t c = 0; c < i; ++c) r[i] -= l[i][c] * r[c];
            r[i] /= l[i][i];
        }
        for (std::size_t i = 3; i-- > 0;) {
            for (std::size_t c = i + 1; c < 3; ++c) r[i] -= l[c][i] * r[c];
            r[i] /= l[i][i];
        }
        for (std::size_t i = 0; i < 3; ++i) d[i] += r[i];
    }
    return d;
}

Triple numbers_of(Vec3 v) { return {v.x, v.y, v.z}; }

bool is_between(Vec3 p, Vec3 lo, Vec3 hi) {
    return p.x >= lo.x && p.x <= hi.x && p.y >= lo.y && p.y <= hi.y && p.z >= lo.z && p.z <= hi.z;
}

}  // namespace

void PlaneFit::add(Vec3 p, Vec3 within, Vec3 unit_normal) {
    add(within);
    if (count_ < few)
        planes_[count_] = {p, unit_normal};
    else
        more_.push_back({p, unit_normal});
    ++count_;
}

void PlaneFit::add(Vec3 within) {
    sum_ = sum_ + within;
    ++crossings_;
}

bool PlaneFit::is_flat() const {
    for (std::size_t i = 1; i < count_; ++i) {
        const Vec3 apart = plane(i).normal - planes_[0].normal;
        if (dot(apart, apart) > one_plane * one_plane) return false;
    }
    return count_ == crossings_;
}

Vec3 PlaneFit::vertex(Vec3 lo, Vec3 hi) const {
    const Vec3 middle = (1.0 / static_cast<double>(crossings_)) * sum_;
    if (is_flat() && is_between(middle, lo, hi)) return middle;  // the crossings lie in that plane
    System s;
    s.planes = std::max(1.0, static_cast<double>(count_));
    for (std::size_t i = 0; i < count_; ++i) {
        const Triple n = numbers_of(plane(i).normal);
        const double offset = dot(plane(i).normal, plane(i).point - middle);
        for (std::size_t r = 0; r < 3; ++r) {
            for (std::size_t c = 0; c < 3; ++c) s.a[r][c] += n[r] * n[c];
            s.b[r] += n[r] * offset;
        }
    }
    const Triple low = numbers_of(lo - middle), high = numbers_of(hi - middle);
    Triple d = s.solve();
    // Beyond the cell: to the best point of the face it leaves by, and so on.
    for (int round = 0; round < 3; ++round) {
        std::size_t worst = 3;
        double most = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            const double beyond = std::max(low[i] - d[i], d[i] - high[i]);
            if (beyond > most) most = beyond, worst = i;
        }
        if (worst == 3) break;
        s.fixed[worst] = true;
        s.at[worst] = d[worst] < low[worst] ? low[worst] : high[worst];
        d = s.solve();
    }
    const auto held = [](double v, double l, double h) { return std::min(std::max(v, l), h); };
    return {held(middle.x + d[0], lo.x, hi.x), held(middle.y + d[1], lo.y, hi.y), held(middle.z + d[2], lo.z, hi.z)};
}

double PlaneFit::spread() const {
    if (count_ != crossings_) return HUGE_VAL;
    double most = 0;
    for (std::size_t i = 0; i < count_; ++i)
        for (std::size_t k = 0; k < count_; ++k)
            most = std::max(most, std::abs(dot(plane(i).normal, plane(k).point - plane(i).point)));
    return most;
}

double PlaneFit::sharpest() const {
    double least = 1;
    for (std::size_t i = 1; i < count_; ++i)
        for (std::size_t k = 0; k < i; ++k) least = std::min(least, dot(plane(i).normal, plane(k).normal));
    return least;
}

double PlaneFit::miss(Vec3 p) const {
    double most = 0;
    for (std::size_t i = 0; i < count_; ++i) most = std::max(most, std::abs(dot(plane(i).normal, p - plane(i).point)));
    return most;
}

}  // namespace obrys::sim::milling
