#pragma once
/// A slender beam (Euler, Bernoulli) of variable section, held at its root, free at its tip: natural frequencies and
/// stiffness, by elements with cubic deflections (Hermite). mm, N, s, so masses in t.

#include <array>
#include <cmath>
#include <functional>
#include <vector>

namespace obrys::sim::beam {

struct Section {
    double stiffness = 0;  ///< E I, N mm2
    double mass = 0;       ///< t/mm
};

struct Beam {
    double length = 0;
    std::function<Section(double x)> section;  ///< x from the root; may jump at `breaks` alone
    std::vector<double> breaks;                ///< places, upwards, that are ends of elements
    double root_stiffness = INFINITY;          ///< N mm/rad, against turning of the root
};

/// The beam as elements; to be made once.
class Model {
public:
    explicit Model(const Beam& beam, int elements = 80);

    /// The lowest natural frequencies, Hz, upwards.
    [[nodiscard]] std::vector<double> frequencies(int count) const;
    /// A force at this place by the deflection there, N/mm.
    [[nodiscard]] double stiffness_at(double x) const;
    [[nodiscard]] double mass() const { return mass_; }  ///< t

private:
    using Vector = std::vector<double>;
    [[nodiscard]] Vector solved(Vector load) const;
    [[nodiscard]] Vector times_mass(const Vector& v) const;
    void factorise();

    static constexpr std::size_t band = 4;  ///< of the lower half of a row, the diagonal included
    std::vector<double> nodes_;
    std::vector<std::array<double, band>> stiffness_, inertia_;  ///< by rows, [i][d]: column i - d
    std::vector<std::array<double, band>> factor_;               ///< Cholesky's
    bool clamped_ = true;
    double mass_ = 0;
};

}  // namespace obrys::sim::beam
