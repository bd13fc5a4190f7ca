#include "sim/beam/beam.hpp"

#include <algorithm>

#include "base/whole.hpp"
#include "geom/vec.hpp"

namespace obrys::sim::beam {

namespace {

using Matrix = std::array<std::array<double, 4>, 4>;

/// Gauss, Legendre: exact for polynomials of degree 7.
constexpr std::array<double, 4> gauss_at{-0.8611363115940526, -0.3399810435848563, 0.3399810435848563,
                                         0.8611363115940526};
constexpr std::array<double, 4> gauss_weight{0.3478548451374538, 0.6521451548625461, 0.6521451548625461,
                                             0.3478548451374538};

/// Deflections and curvatures along an element of length l at t = 0 … 1 by deflection and slope of its ends.
std::array<double, 4> shape(double t, double l) {
    return {1 - 3 * t * t + 2 * t * t * t, l * (t - 2 * t * t + t * t * t), 3 * t * t - 2 * t * t * t,
            l * (t * t * t - t * t)};
}
std::array<double, 4> curvature(double t, double l) {
    return {(12 * t - 6) / (l * l), (6 * t - 4) / l, (6 - 12 * t) / (l * l), (6 * t - 2) / l};
}

struct Element {
    Matrix stiffness{}, inertia{};
    double mass = 0;
};

Element element_of(const Beam& beam, double x0, double x1) {
    Element e;
    const double l = x1 - x0;
    for (std::size_t g = 0; g < gauss_at.size(); ++g) {
        const double t = (1 + gauss_at[g]) / 2, weight = gauss_weight[g] * l / 2;
        const Section s = beam.section(x0 + t * l);
        const auto n = shape(t, l), b = curvature(t, l);
        e.mass += weight * s.mass;
        for (std::size_t i = 0; i < 4; ++i)
            for (std::size_t k = 0; k < 4; ++k) {
                e.stiffness[i][k] += weight * s.stiffness * b[i] * b[k];
                e.inertia[i][k] += weight * s.mass * n[i] * n[k];
            }
    }
    return e;
}

double dot(const std::vector<double>& a, const std::vector<double>& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
    return sum;
}

std::vector<double> nodes_of(const Beam& beam, int elements) {
    std::vector<double> ends{0};
    constexpr double same = 1e-9;
    for (const double b : beam.breaks)
        if (b > ends.back() + same * beam.length && b < beam.length * (1 - same)) ends.push_back(b);
    ends.push_back(beam.length);
    std::vector<double> nodes{0};
    constexpr int most_parts = 10'000;
    for (std::size_t i = 1; i < ends.size(); ++i) {
        const double span = ends[i] - ends[i - 1];
        const int parts = base::clipped<int>(std::round(elements * span / beam.length), 1, most_parts);
        for (int k = 1; k <= parts; ++k) nodes.push_back(ends[i - 1] + span * k / parts);
    }
    return nodes;
}

}  // namespace

// Unknowns are deflection and slope of every node; those of the root that do not move stay in, and are held at 0.
Model::Model(const Beam& beam, int elements)
    : nodes_(nodes_of(beam, elements)), stiffness_(2 * nodes_.size()), inertia_(2 * nodes_.size()) {
    for (std::size_t n = 0; n + 1 < nodes_.size(); ++n) {
        const Element e = element_of(beam, nodes_[n], nodes_[n + 1]);
        mass_ += e.mass;
        for (std::size_t i = 0; i < 4; ++i)
            for (std::size_t k = 0; k <= i; ++k) {
                stiffness_[2 * n + i][i - k] += e.stiffness[i][k];
                inertia_[2 * n + i][i - k] += e.inertia[i][k];
            }
    }
    clamped_ = std::isinf(beam.root_stiffness);
    if (!clamped_) stiffness_[1][0] += beam.root_stiffness;
    factorise();
}

void Model::factorise() {
    factor_ = stiffness_;
    const std::size_t held = clamped_ ? 2 : 1;  // rows of the root that do not move
    for (std::size_t i = 0; i < factor_.size(); ++i) {
        if (i < held) {
            factor_[i] = {1, 0, 0, 0};
            continue;
        }
        for (std::size_t d = band; d-- > 0;) {
            if (d > i) continue;
            const std::size_t k = i - d;
            double sum = k < held ? 0 : factor_[i][d];
            for (std::size_t j = i < band ? 0 : i - band + 1; j < k; ++j)
                if (i - j < band && k - j < band) sum -= factor_[i][i - j] * factor_[k][k - j];
            factor_[i][d] = d == 0 ? std::sqrt(sum) : sum / factor_[k][0];
        }
    }
}

Model::Vector Model::solved(Vector v) const {
    const std::size_t size = v.size(), held = clamped_ ? 2 : 1;
    for (std::size_t i = 0; i < held; ++i) v[i] = 0;
    for (std::size_t i = 0; i < size; ++i) {
        for (std::size_t d = 1; d < band && d <= i; ++d) v[i] -= factor_[i][d] * v[i - d];
        v[i] /= factor_[i][0];
    }
    for (std::size_t i = size; i-- > 0;) {
        for (std::size_t d = 1; d < band && i + d < size; ++d) v[i] -= factor_[i + d][d] * v[i + d];
        v[i] /= factor_[i][0];
    }
    return v;
}

Model::Vector Model::times_mass(const Vector& v) const {
    Vector out(v.size(), 0);
    for (std::size_t i = 0; i < v.size(); ++i)
        for (std::size_t d = 0; d < band && d <= i; ++d) {
            out[i] += inertia_[i][d] * v[i - d];
            if (d > 0) out[i - d] += inertia_[i][d] * v[i];
        }
    return out;
}

std::vector<double> Model::frequencies(int count) const {
    constexpr int most_rounds = 2000;
    constexpr double settled = 1e-14;
    std::vector<Vector> forms;
    std::vector<double> found;
    for (int mode = 0; mode < count; ++mode) {
        Vector v(stiffness_.size(), 0);
        for (std::size_t n = 0; n < nodes_.size(); ++n)  // with as many nodes as the form is to have
            v[2 * n] = std::sin((mode + 0.5) * geom::pi * nodes_[n] / nodes_.back());
        double before = 0, value = 0;
        for (int round = 0; round < most_rounds; ++round) {
            Vector next = solved(times_mass(v));
            const Vector weighted = times_mass(next);
            for (const Vector& lower : forms) {
                const double share = dot(lower, weighted);
                for (std::size_t i = 0; i < next.size(); ++i) next[i] -= share * lower[i];
            }
            const double size = std::sqrt(dot(next, times_mass(next)));
            for (double& x : next) x /= size;
            value = 1 / size;  // of K v = value M v, once v stays itself
            v = std::move(next);
            if (std::abs(value - before) <= settled * value) break;
            before = value;
        }
        found.push_back(std::sqrt(value) / (2 * geom::pi));
        forms.push_back(std::move(v));
    }
    std::sort(found.begin(), found.end());
    return found;
}

double Model::stiffness_at(double x) const {
    const auto after = std::upper_bound(nodes_.begin(), nodes_.end() - 1, x);
    const std::size_t n = after == nodes_.begin() ? 0 : static_cast<std::size_t>(after - nodes_.begin()) - 1;
    const double l = nodes_[n + 1] - nodes_[n];
    const auto part = shape((x - nodes_[n]) / l, l);
    Vector load(stiffness_.size(), 0);
    for (std::size_t i = 0; i < 4; ++i) load[2 * n + i] = part[i];
    const Vector moved = solved(load);
    double there = 0;
    for (std::size_t i = 0; i < 4; ++i) there += part[i] * moved[2 * n + i];
    return 1 / there;
}

}  // namespace obrys::sim::beam
