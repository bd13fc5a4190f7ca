/// Several equations of second degree together: terms that cancel, and two equations in two unknowns.
#include <algorithm>
#include <cmath>
#include <set>

#include "path/fk/system.hpp"

namespace obrys::path {

namespace {

constexpr std::size_t most_rows = 64;
constexpr double vanishes = 1e-9;  // of a row of size 1 after elimination
constexpr double speaks = 1e-6;    // a linear equation won this way must be larger than that

struct Pair {
    int a, b;
    bool operator<(const Pair& o) const { return a != o.a ? a < o.a : b < o.b; }
};

double factor_of(const FkPoly& p, int a, int b) {
    for (const FkTerm& t : p.terms)
        if (t.a == a && t.b == b) return t.factor;
    return 0;
}

}  // namespace

/// Gauss elimination over the second-degree terms: rows without any are new linear equations (two circles have their
/// radical line in common; circles tangent to three others become three planes and so on).
FkSolver::Progress FkSolver::cancel(FkBranch& b) const {
    std::vector<FkEquation> rows;
    std::set<Pair> columns;
    for (const FkEquation& e : b.open) {
        if (e.poly.is_affine() || rows.size() >= most_rows) continue;
        rows.push_back(e);
        rows.back().poly = (1 / e.size) * e.poly;
        for (const FkTerm& t : e.poly.terms)
            if (t.a >= 0) columns.insert({t.a, t.b});
    }
    bool won = false;
    for (const Pair& c : columns) {
        const auto at = [&](const FkEquation& e) { return contribution({c.a, c.b, factor_of(e.poly, c.a, c.b)}); };
        const auto pivot = std::max_element(rows.begin(), rows.end(),
                                            [&](const FkEquation& x, const FkEquation& y) { return at(x) < at(y); });
        if (pivot == rows.end() || at(*pivot) <= vanishes) continue;
        const FkEquation used = *pivot;
        rows.erase(pivot);
        const double by = factor_of(used.poly, c.a, c.b);
        for (FkEquation& e : rows) {
            const double k = factor_of(e.poly, c.a, c.b);
            if (k == 0) continue;
            e.poly = e.poly - (k / by) * used.poly;
            std::erase_if(e.poly.terms, [&](const FkTerm& t) {
                return (t.a == c.a && t.b == c.b) || (t.b >= 0 && contribution(t) <= vanishes);
            });
        }
        std::erase_if(rows, [&](const FkEquation& e) {
            if (!e.poly.is_affine()) return false;
            double largest = 0;
            for (const FkTerm& t : e.poly.terms)
                if (t.b >= 0) largest = std::max(largest, contribution(t));
            if (largest > speaks) {
                b.open.push_back(e);
                b.open.back().size = 0;
                clean(b.open.back());
                won = true;
            }
            return true;
        });
    }
    return won ? Progress::some : Progress::none;
}

namespace {

/// a x² + b x y + c y² + d x + e y + f, x and y divided by their weights.
struct ConicEquation {
    double a = 0, b = 0, c = 0, d = 0, e = 0, f = 0;
    [[nodiscard]] double at(double x, double y) const { return a * x * x + b * x * y + c * y * y + d * x + e * y + f; }
    [[nodiscard]] geom::Vec2 slope(double x, double y) const { return {2 * a * x + b * y + d, b * x + 2 * c * y + e}; }
};

ConicEquation conic_of(const FkEquation& eq, int x, int y, double wx, double wy) {
    ConicEquation k;
    for (const FkTerm& t : eq.poly.terms) {
        const double f = t.factor / eq.size;
        if (t.b < 0)
            k.f = f;
        else if (t.a < 0)
            (t.b == x ? k.d : k.e) = f * (t.b == x ? wx : wy);
        else if (t.a == x && t.b == x)
            k.a = f * wx * wx;
        else if (t.a == y && t.b == y)
            k.c = f * wy * wy;
        else
            k.b = f * wx * wy;
    }
    return k;
}

std::vector<double> times(const std::vector<double>& p, const std::vector<double>& q) {
    std::vector<double> r(p.size() + q.size() - 1, 0.0);
    for (std::size_t i = 0; i < p.size(); ++i)
        for (std::size_t j = 0; j < q.size(); ++j) r[i + j] += p[i] * q[j];
    return r;
}

std::vector<double> minus(std::vector<double> p, const std::vector<double>& q) {
    p.resize(std::max(p.size(), q.size()), 0.0);
    for (std::size_t i = 0; i < q.size(); ++i) p[i] -= q[i];
    return p;
}

/// y eliminated from both: (a1 c2 - a2 c1)² = (a1 b2 - a2 b1)(b1 c2 - b2 c1), with the polynomials in x at y², y, 1.
std::vector<double> resultant(const ConicEquation& p, const ConicEquation& q) {
    const std::vector<double> a1{p.c}, a2{q.c}, b1{p.e, p.b}, b2{q.e, q.b}, c1{p.f, p.d, p.a}, c2{q.f, q.d, q.a};
    const auto ac = minus(times(a1, c2), times(a2, c1));
    const auto ab = minus(times(a1, b2), times(a2, b1));
    const auto bc = minus(times(b1, c2), times(b2, c1));
    return minus(times(ac, ac), times(ab, bc));
}

/// Newton from (x, y); false where it does not come to rest on both near by.
bool polish(const ConicEquation& p, const ConicEquation& q, double& x, double& y) {
    for (int i = 0; i < 20; ++i) {
        const double f = p.at(x, y), g = q.at(x, y);
        const geom::Vec2 s = p.slope(x, y), t = q.slope(x, y);
        const double det = geom::cross(s, t);
        if (std::abs(det) < 1e-14) break;
        const double dx = (f * t.y - g * s.y) / det, dy = (g * s.x - f * t.x) / det;
        if (!(std::hypot(dx, dy) < 0.05 * (1 + std::hypot(x, y)))) return false;
        x -= dx;
        y -= dy;
        if (std::hypot(dx, dy) < 1e-16 * (1 + std::hypot(x, y))) break;
    }
    const double scale = 1 + x * x + y * y;
    return std::abs(p.at(x, y)) <= 1e-11 * scale && std::abs(q.at(x, y)) <= 1e-11 * scale;
}

std::vector<geom::Vec2> meet(const ConicEquation& p, const ConicEquation& q, double far_x, double far_y) {
    std::vector<double> r = resultant(p, q);
    double size = 0;
    for (const double c : r) size = std::max(size, std::abs(c));
    std::vector<geom::Vec2> points;
    if (size < 1e-12) return points;
    while (!r.empty() && std::abs(r.back()) < 1e-13 * size) r.pop_back();
    for (double& c : r) c /= size;
    for (const double root : real_roots(r, far_x, 1e-12)) {
        for (const ConicEquation& k : {p, q})
            for (double y : real_roots({k.a * root * root + k.d * root + k.f, k.b * root + k.e, k.c}, far_y, 1e-9)) {
                double x = root;
                if (!polish(p, q, x, y)) continue;
                const auto same = [&](geom::Vec2 o) { return geom::distance(o, {x, y}) < 1e-9 * (1 + std::abs(x)); };
                if (std::none_of(points.begin(), points.end(), same)) points.push_back({x, y});
            }
    }
    return points;
}

}  // namespace

FkSolver::Progress FkSolver::two_unknowns(FkBranch& b) {
    const auto unknowns = [](const FkEquation& e) {
        std::set<int> ids;
        for (const FkTerm& t : e.poly.terms)
            for (const int id : {t.a, t.b})
                if (id >= 0) ids.insert(id);
        return ids;
    };
    for (std::size_t i = 0; i < b.open.size(); ++i) {
        const std::set<int> ids = unknowns(b.open[i]);
        if (b.open[i].poly.is_affine() || ids.size() != 2) continue;
        for (std::size_t j = i + 1; j < b.open.size(); ++j) {
            if (b.open[j].poly.is_affine() || unknowns(b.open[j]) != ids) continue;
            const int x = *ids.begin(), y = *ids.rbegin();
            const double wx = weight(x), wy = weight(y);
            const ConicEquation p = conic_of(b.open[i], x, y, wx, wy), q = conic_of(b.open[j], x, y, wx, wy);
            const double size = [r = resultant(p, q)] {
                double s = 0;
                for (const double c : r) s = std::max(s, std::abs(c));
                return s;
            }();
            if (size < 1e-12) continue;
            std::vector<std::vector<std::pair<int, double>>> ways;
            for (const geom::Vec2 at : meet(p, q, is_direction(x) ? 1.001 : 1e3, is_direction(y) ? 1.001 : 1e3))
                ways.push_back({{x, at.x * wx}, {y, at.y * wy}});
            if (ways.empty()) {
                die(b.open[j].tag, b.open[j].datum, NAN);
                return Progress::dead;
            }
            part(b, j, ways);
            return Progress::parted;
        }
    }
    return Progress::none;
}

}  // namespace obrys::path
