#include "sim/time/fit.hpp"

#include <algorithm>
#include <cmath>

namespace obrys::sim::time {
namespace {

using Matrix = std::vector<std::vector<double>>;

Matrix zeros(std::size_t n) { return Matrix(n, std::vector<double>(n, 0.0)); }

/// Of a symmetric matrix whose eigenvalues are above 0 (each unknown's own spread makes them so), by Gauss-Jordan.
Matrix inverse(Matrix m) {
    const std::size_t n = m.size();
    Matrix inv = zeros(n);
    for (std::size_t i = 0; i < n; ++i) inv[i][i] = 1;
    for (std::size_t c = 0; c < n; ++c) {
        const double pivot = 1 / m[c][c];
        for (std::size_t k = 0; k < n; ++k) m[c][k] *= pivot, inv[c][k] *= pivot;
        for (std::size_t r = 0; r < n; ++r) {
            if (r == c) continue;
            const double f = m[r][c];
            for (std::size_t k = 0; k < n; ++k) m[r][k] -= f * m[c][k], inv[r][k] -= f * inv[c][k];
        }
    }
    return inv;
}

class Fitter {
public:
    Fitter(const std::vector<Unknown>& u, const std::vector<Measured>& m, const Model& model)
        : unknowns_(u), measured_(m), model_(model), now_(u.size(), 0.0) {}

    Fitted run() {
        constexpr int most_rounds = 12;
        constexpr double done = 1e-4;
        for (out_.rounds = 1; out_.rounds <= most_rounds; ++out_.rounds) {
            look();
            if (out_.rounds == 1) out_.before = predicted_;
            const std::vector<double> step = newton();
            const double most = *std::max_element(step.begin(), step.end(),
                                                  [](double a, double b) { return std::abs(a) < std::abs(b); });
            if (std::abs(most) < done || !go(step)) break;
        }
        look();
        finish();
        return std::move(out_);
    }

private:
    /// Unknowns times exp(of each its logarithm's change).
    [[nodiscard]] std::vector<double> values(const std::vector<double>& x) const {
        std::vector<double> v;
        for (std::size_t i = 0; i < x.size(); ++i) v.push_back(unknowns_[i].value * std::exp(x[i]));
        return v;
    }

    /// Predictions, and how they change with each logarithm.
    void look() {
        constexpr double little = 0.02;
        Matrix sets{values(now_)};
        for (std::size_t i = 0; i < now_.size(); ++i) {
            std::vector<double> x = now_;
            x[i] += little;
            sets.push_back(values(x));
        }
        const Matrix all = model_(sets);
        predicted_ = all.front();
        slopes_.assign(measured_.size(), std::vector<double>(now_.size(), 0.0));
        for (std::size_t k = 0; k < measured_.size(); ++k)
            for (std::size_t i = 0; i < now_.size(); ++i)
                slopes_[k][i] = (all[i + 1][k] - predicted_[k]) / little / measured_[k].spread;
    }

    [[nodiscard]] double misfit(const std::vector<double>& predicted, const std::vector<double>& x) const {
        double sum = 0;
        for (std::size_t k = 0; k < measured_.size(); ++k)
            sum += std::pow((predicted[k] - measured_[k].value) / measured_[k].spread, 2);
        for (std::size_t i = 0; i < x.size(); ++i) sum += std::pow(x[i] / unknowns_[i].spread, 2);
        return sum;
    }

    [[nodiscard]] Matrix normal() const {
        Matrix m = zeros(now_.size());
        for (std::size_t i = 0; i < now_.size(); ++i) {
            for (std::size_t k = 0; k < now_.size(); ++k)
                for (const std::vector<double>& row : slopes_) m[i][k] += row[i] * row[k];
            m[i][i] += 1 / (unknowns_[i].spread * unknowns_[i].spread);
        }
        return m;
    }

    [[nodiscard]] std::vector<double> newton() const {
        std::vector<double> right(now_.size(), 0.0), step(now_.size(), 0.0);
        for (std::size_t i = 0; i < now_.size(); ++i) {
            for (std::size_t k = 0; k < measured_.size(); ++k)
                right[i] += slopes_[k][i] * (measured_[k].value - predicted_[k]) / measured_[k].spread;
            right[i] -= now_[i] / (unknowns_[i].spread * unknowns_[i].spread);
        }
        const Matrix inv = inverse(normal());
        for (std::size_t i = 0; i < now_.size(); ++i)
            for (std::size_t k = 0; k < now_.size(); ++k) step[i] += inv[i][k] * right[k];
        return step;
    }

    /// The whole step, or as much of it as makes things better; false where none does.
    bool go(const std::vector<double>& step) {
        constexpr double farthest = 2;  // of a logarithm in one step
        double most = 0;
        for (const double s : step) most = std::max(most, std::abs(s));
        const double now = misfit(predicted_, now_), whole = std::min(1.0, farthest / most);
        Matrix tried, sets;
        for (double share = whole; share > whole / 10; share /= 2) {
            std::vector<double> x = now_;
            for (std::size_t i = 0; i < x.size(); ++i) x[i] += share * step[i];
            sets.push_back(values(x));
            tried.push_back(std::move(x));
        }
        const Matrix all = model_(sets);
        for (std::size_t i = 0; i < tried.size(); ++i) {
            if (misfit(all[i], tried[i]) >= now) continue;
            now_ = tried[i];
            return true;
        }
        return false;
    }

    void finish() {
        constexpr double well = 0.5, at_all = 0.95;  // how much of what was open before may be left
        out_.predicted = predicted_;
        out_.misfit = misfit(predicted_, now_);
        const Matrix inv = inverse(normal());
        const std::vector<double> v = values(now_);
        for (std::size_t i = 0; i < now_.size(); ++i) {
            const double spread = std::sqrt(std::max(0.0, inv[i][i])), left = spread / unknowns_[i].spread;
            out_.values.push_back({v[i], spread,
                                   left < well     ? Sight::seen
                                   : left < at_all ? Sight::with_others
                                                   : Sight::not_seen});
        }
        Matrix told = zeros(now_.size());
        for (std::size_t i = 0; i < now_.size(); ++i)
            for (std::size_t k = 0; k < now_.size(); ++k)
                for (const std::vector<double>& row : slopes_) told[i][k] += row[i] * row[k];
        for (const double e : eigenvalues(std::move(told))) out_.singular.push_back(std::sqrt(std::max(0.0, e)));
        const double largest = out_.singular.empty() ? 0 : out_.singular.front();
        for (double& s : out_.singular) s = largest > 0 ? s / largest : 0;
    }

    const std::vector<Unknown>& unknowns_;
    const std::vector<Measured>& measured_;
    const Model& model_;
    std::vector<double> now_, predicted_;
    Matrix slopes_;
    Fitted out_;
};

}  // namespace

std::vector<double> eigenvalues(std::vector<std::vector<double>> m) {
    const std::size_t n = m.size();
    for (int sweep = 0; sweep < 60; ++sweep) {  // Jacobi
        double off = 0, all = 0;
        for (std::size_t i = 0; i < n; ++i)
            for (std::size_t k = 0; k < n; ++k) (i == k ? all : off) += m[i][k] * m[i][k];
        if (off <= 1e-24 * all || off == 0) break;
        for (std::size_t p = 0; p < n; ++p)
            for (std::size_t q = p + 1; q < n; ++q) {
                if (m[p][q] == 0) continue;
                const double theta = std::atan2(2 * m[p][q], m[q][q] - m[p][p]) / 2, c = std::cos(theta),
                             s = std::sin(theta);
                for (std::size_t k = 0; k < n; ++k) {
                    const double a = m[k][p], b = m[k][q];
                    m[k][p] = c * a - s * b, m[k][q] = s * a + c * b;
                }
                for (std::size_t k = 0; k < n; ++k) {
                    const double a = m[p][k], b = m[q][k];
                    m[p][k] = c * a - s * b, m[q][k] = s * a + c * b;
                }
            }
    }
    std::vector<double> values;
    for (std::size_t i = 0; i < n; ++i) values.push_back(m[i][i]);
    std::sort(values.rbegin(), values.rend());
    return values;
}

Fitted fit(const std::vector<Unknown>& unknowns, const std::vector<Measured>& measured, const Model& model) {
    return Fitter(unknowns, measured, model).run();
}

}  // namespace obrys::sim::time
