#pragma once
/// Polynomials of second degree in numbered unknowns. Inside of fk.hpp; not for callers.

#include <optional>
#include <vector>

namespace obrys::path {

/// factor · x_a · x_b; -1 stands for 1, a <= b.
struct FkTerm {
    int a = -1, b = -1;
    double factor = 0;
};

/// Sorted by (a, b), each pair once. Products are formed of affine factors only.
struct FkPoly {
    std::vector<FkTerm> terms;

    FkPoly() = default;
    FkPoly(double constant);  // NOLINT(google-explicit-constructor): a number is a polynomial
    [[nodiscard]] static FkPoly unknown(int id);

    [[nodiscard]] bool is_constant() const { return terms.empty() || terms.back().b < 0; }
    [[nodiscard]] bool is_affine() const { return terms.empty() || terms.back().a < 0; }
    [[nodiscard]] double constant() const;
    [[nodiscard]] bool contains(int id) const;
};

[[nodiscard]] FkPoly operator+(const FkPoly& p, const FkPoly& q);
[[nodiscard]] FkPoly operator-(const FkPoly& p, const FkPoly& q);
/// Both must be affine.
[[nodiscard]] FkPoly operator*(const FkPoly& p, const FkPoly& q);
[[nodiscard]] FkPoly operator*(double k, const FkPoly& p);
/// x_id replaced by an affine polynomial.
[[nodiscard]] FkPoly substituted(const FkPoly& p, int id, const FkPoly& by);

/// Sum under construction.
class FkSum {
public:
    void add(int a, int b, double factor);
    void add(const FkPoly& p, double factor = 1);
    void add_product(const FkPoly& p, const FkPoly& q, double factor = 1);
    [[nodiscard]] FkPoly take();

private:
    std::vector<FkTerm> terms_;
};

/// Real roots in ascending order of c[0] + c[1] x + … + c[4] x⁴ within |x| <= bound; touching roots count once.
/// `noise`: values of the polynomial below it are zero.
[[nodiscard]] std::vector<double> real_roots(const std::vector<double>& c, double bound, double noise);

}  // namespace obrys::path
