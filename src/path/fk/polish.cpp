/// The last digits of a solution.
#include <algorithm>
#include <cmath>

#include "path/fk/system.hpp"

namespace obrys::path {

namespace {

constexpr double agree = 1e-5;    // mm; data that disagree by more keep the values that the elimination gave
constexpr double longest = 1e-4;  // mm; a step that is longer is no polishing

using Row = std::vector<double>;

/// Least squares by Householder reflections with column pivoting; columns that the rows say nothing about get 0.
Row least_squares(std::vector<Row> a, Row rhs, std::size_t columns) {
    const std::size_t rows = a.size();
    std::vector<std::size_t> at(columns);
    for (std::size_t i = 0; i < columns; ++i) at[i] = i;
    std::size_t rank = 0;
    double first = 0;
    for (; rank < std::min(rows, columns); ++rank) {
        std::size_t best = rank;
        double largest = -1;
        for (std::size_t j = rank; j < columns; ++j) {
            double norm = 0;
            for (std::size_t i = rank; i < rows; ++i) norm += a[i][at[j]] * a[i][at[j]];
            if (norm > largest) largest = norm, best = j;
        }
        largest = std::sqrt(largest);
        if (rank == 0) first = largest;
        if (!(largest > 1e-9 * first)) break;
        std::swap(at[rank], at[best]);
        const std::size_t c = at[rank];
        const double pivot = a[rank][c] > 0 ? -largest : largest;
        Row v(rows, 0.0);
        double square = 0;
        for (std::size_t i = rank; i < rows; ++i) {
            v[i] = a[i][c] - (i == rank ? pivot : 0);
            square += v[i] * v[i];
        }
        if (!(square > 0)) continue;
        const auto reflect = [&](auto&& get) {
            double k = 0;
            for (std::size_t i = rank; i < rows; ++i) k += v[i] * get(i);
            k *= 2 / square;
            for (std::size_t i = rank; i < rows; ++i) get(i) -= k * v[i];
        };
        for (std::size_t j = rank; j < columns; ++j) reflect([&](std::size_t i) -> double& { return a[i][at[j]]; });
        reflect([&](std::size_t i) -> double& { return rhs[i]; });
    }
    Row x(columns, 0.0);
    for (std::size_t k = rank; k-- > 0;) {
        double sum = rhs[k];
        for (std::size_t j = k + 1; j < rank; ++j) sum -= a[k][at[j]] * x[at[j]];
        x[at[k]] = sum / a[k][at[k]];
    }
    return x;
}

/// The stated equations whose unknowns all have values, linearised there.
class Linearised {
public:
    Linearised(const FkBranch& b, double scale) : b_(b), scale_(scale) {
        for (std::size_t i = 0; i < b.values.size(); ++i)
            if (b.values[i].is_constant()) ids.push_back(b.base + static_cast<int>(i));
        for (const FkEquation& e : b.stated) add(e);
    }
    [[nodiscard]] double weight(int id) const { return is_direction(id) ? 1 / scale_ : 1; }

    std::vector<int> ids;
    std::vector<Row> rows;
    Row rhs;
    double worst = 0;  ///< mm

private:
    void add(const FkEquation& e) {
        const auto value = b_.known(e.poly);
        if (!value) return;
        Row row(ids.size(), 0.0);
        const auto at = [&](int id) {
            return id < 0 ? 1.0 : b_.values[static_cast<std::size_t>(id - b_.base)].constant();
        };
        const auto slope = [&](int id, double by) {
            if (id >= 0)
                row[static_cast<std::size_t>(std::lower_bound(ids.begin(), ids.end(), id) - ids.begin())] +=
                    by * weight(id);
        };
        for (const FkTerm& t : e.poly.terms) {
            slope(t.a, t.factor * at(t.b));
            slope(t.b, t.factor * at(t.a));
        }
        double norm = 0;
        for (const double d : row) norm = std::hypot(norm, d);
        if (!(norm > 0)) return;
        for (double& d : row) d /= norm;
        rows.push_back(std::move(row));
        rhs.push_back(-*value / norm);
        worst = std::max(worst, std::abs(*value / norm));
    }

    const FkBranch& b_;
    double scale_;
};

}  // namespace

void polish(FkBranch& b, double scale) {
    for (int i = 0; i < 3; ++i) {
        const Linearised l(b, scale);
        if (l.rows.empty() || !(l.worst <= agree) || l.worst < 1e-13 * scale) return;
        const Row step = least_squares(l.rows, l.rhs, l.ids.size());
        double largest = 0;
        for (const double d : step) largest = std::max(largest, std::abs(d));
        if (!(largest <= longest)) return;
        const FkBranch before = b;
        for (std::size_t k = 0; k < step.size(); ++k) {
            FkPoly& v = b.values[static_cast<std::size_t>(l.ids[k] - b.base)];
            v = FkPoly(v.constant() + step[k] * l.weight(l.ids[k]));
        }
        if (Linearised(b, scale).worst > l.worst) {
            b = before;
            return;
        }
    }
}

}  // namespace obrys::path
