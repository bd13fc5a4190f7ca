#pragma once
/// Positive values fitted to what was measured, by Gauss-Newton steps on their logarithms. What was known of them
/// before counts, so that what the measurements do not show stays as it was. Source: shared spec physics.md (b).

#include <functional>
#include <vector>

namespace obrys::sim::time {

struct Unknown {
    double value = 1;   ///< known before
    double spread = 1;  ///< of its logarithm: 0.7 is half to twice
};
struct Measured {
    double value = 0, spread = 0;  ///< standard deviation
};

/// What the measurements would be with each of these sets of values.
using Model = std::function<std::vector<std::vector<double>>(const std::vector<std::vector<double>>& sets)>;

enum class Sight { seen, with_others, not_seen };

struct Fitted {
    struct One {
        double value = 0;
        double spread = 0;  ///< of its logarithm that is left
        Sight sight = Sight::not_seen;
    };
    std::vector<One> values;
    std::vector<double> predicted;  ///< by the fitted values
    std::vector<double> before;     ///< by those known before
    std::vector<double> singular;   ///< of what the measurements tell, the largest first, relative to it
    int rounds = 0;
    double misfit = 0;  ///< sum of squares, in spreads; of known values too
};

[[nodiscard]] Fitted fit(const std::vector<Unknown>& unknowns, const std::vector<Measured>& measured,
                         const Model& model);

/// Eigenvalues of a symmetric matrix (rows), the largest first.
[[nodiscard]] std::vector<double> eigenvalues(std::vector<std::vector<double>> m);

}  // namespace obrys::sim::time
