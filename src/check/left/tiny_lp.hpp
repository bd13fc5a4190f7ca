#pragma once
/// Linear programs of a few variables: constraint by constraint, each that cuts the best point off puts the next one on
/// itself (Seidel 1991). Those that did so are looked at first from then on, which makes the next programs like it
/// quick.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace obrys::check {

/// dot(a, x) <= c; a of about unit length.
template <std::size_t N>
struct Halfspace {
    std::array<double, N> a{};
    double c = 0;
};

namespace tiny_lp {

constexpr double slack = 1e-10;
constexpr double nothing = 1e-11;  ///< length of a row that says nothing of the variables

inline std::optional<std::array<double, 1>> solve(std::span<Halfspace<1>> rows, std::array<double, 1> aim,
                                                  std::array<double, 1> most) {
    double low = -most[0], high = most[0];
    for (const Halfspace<1>& r : rows) {
        if (r.a[0] > nothing)
            high = std::min(high, r.c / r.a[0]);
        else if (r.a[0] < -nothing)
            low = std::max(low, r.c / r.a[0]);
        else if (r.c < -slack)
            return std::nullopt;
    }
    if (low > high + slack) return std::nullopt;
    return std::array{aim[0] >= 0 ? high : low};
}

/// Changes the order of the rows. The point of all halfspaces, and of |x[k]| <= most[k], that lies farthest towards
/// `aim`; none: they have none.
template <std::size_t N>
std::optional<std::array<double, N>> solve(std::span<Halfspace<N>> rows, std::array<double, N> aim,
                                           std::array<double, N> most) {
    std::array<double, N> x{};
    for (std::size_t k = 0; k < N; ++k) x[k] = aim[k] > 0 ? most[k] : aim[k] < 0 ? -most[k] : 0;
    std::vector<Halfspace<N - 1>> lower;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const Halfspace<N> on = rows[i];
        double value = -on.c;
        std::size_t gone = 0;
        for (std::size_t k = 0; k < N; ++k) {
            value += on.a[k] * x[k];
            if (std::abs(on.a[k]) > std::abs(on.a[gone])) gone = k;
        }
        if (value <= slack) continue;
        if (std::abs(on.a[gone]) <= nothing) return std::nullopt;
        // On its plane: x[gone] = (c - the others) / a[gone].
        const auto reduced = [&](const std::array<double, N>& a, double c) {
            const double share = a[gone] / on.a[gone];
            Halfspace<N - 1> h;
            double square = 0;
            for (std::size_t k = 0, j = 0; k < N; ++k)
                if (k != gone) h.a[j] = a[k] - share * on.a[k], square += h.a[j] * h.a[j], ++j;
            h.c = c - share * on.c;
            const double size = std::sqrt(square);
            if (size > nothing) {
                for (double& v : h.a) v /= size;
                h.c /= size;
            }
            return h;
        };
        lower.clear();
        std::array<double, N> bound{};
        bound[gone] = 1;
        lower.push_back(reduced(bound, most[gone]));
        bound[gone] = -1;
        lower.push_back(reduced(bound, most[gone]));
        for (std::size_t j = 0; j < i; ++j) lower.push_back(reduced(rows[j].a, rows[j].c));
        std::array<double, N - 1> lower_aim{}, lower_most{};
        for (std::size_t k = 0, j = 0; k < N; ++k)
            if (k != gone) lower_aim[j] = aim[k] - aim[gone] / on.a[gone] * on.a[k], lower_most[j] = most[k], ++j;
        const auto best = solve(std::span<Halfspace<N - 1>>(lower), lower_aim, lower_most);
        if (!best) return std::nullopt;
        double rest = on.c;
        for (std::size_t k = 0, j = 0; k < N; ++k)
            if (k != gone) x[k] = (*best)[j++], rest -= on.a[k] * x[k];
        x[gone] = rest / on.a[gone];
        std::rotate(rows.begin(), rows.begin() + static_cast<std::ptrdiff_t>(i),
                    rows.begin() + static_cast<std::ptrdiff_t>(i) + 1);
    }
    return x;
}

}  // namespace tiny_lp

}  // namespace obrys::check
