#include "path/fk/algebra.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace obrys::path {

FkPoly::FkPoly(double constant) {
    if (constant != 0) terms.push_back({-1, -1, constant});
}

FkPoly FkPoly::unknown(int id) {
    FkPoly p;
    p.terms.push_back({-1, id, 1});
    return p;
}

double FkPoly::constant() const { return !terms.empty() && terms.front().b < 0 ? terms.front().factor : 0; }

bool FkPoly::contains(int id) const {
    return std::any_of(terms.begin(), terms.end(), [id](const FkTerm& t) { return t.a == id || t.b == id; });
}

void FkSum::add(int a, int b, double factor) { terms_.push_back({std::min(a, b), std::max(a, b), factor}); }

void FkSum::add(const FkPoly& p, double factor) {
    for (const FkTerm& t : p.terms) terms_.push_back({t.a, t.b, factor * t.factor});
}

void FkSum::add_product(const FkPoly& p, const FkPoly& q, double factor) {
    for (const FkTerm& s : p.terms)
        for (const FkTerm& t : q.terms) add(s.b, t.b, factor * s.factor * t.factor);
}

FkPoly FkSum::take() {
    std::sort(terms_.begin(), terms_.end(),
              [](const FkTerm& s, const FkTerm& t) { return std::tie(s.a, s.b) < std::tie(t.a, t.b); });
    FkPoly p;
    for (const FkTerm& t : terms_) {
        if (!p.terms.empty() && p.terms.back().a == t.a && p.terms.back().b == t.b)
            p.terms.back().factor += t.factor;
        else
            p.terms.push_back(t);
    }
    std::erase_if(p.terms, [](const FkTerm& t) { return t.factor == 0; });
    terms_.clear();
    return p;
}

FkPoly operator+(const FkPoly& p, const FkPoly& q) {
    FkSum s;
    s.add(p);
    s.add(q);
    return s.take();
}

FkPoly operator-(const FkPoly& p, const FkPoly& q) {
    FkSum s;
    s.add(p);
    s.add(q, -1);
    return s.take();
}

FkPoly operator*(const FkPoly& p, const FkPoly& q) {
    FkSum s;
    s.add_product(p, q);
    return s.take();
}

FkPoly operator*(double k, const FkPoly& p) {
    FkSum s;
    s.add(p, k);
    return s.take();
}

FkPoly substituted(const FkPoly& p, int id, const FkPoly& by) {
    FkSum s;
    for (const FkTerm& t : p.terms) {
        if (t.a == id && t.b == id)
            s.add_product(by, by, t.factor);
        else if (t.a == id || t.b == id)
            s.add_product(t.a == id ? FkPoly::unknown(t.b)
                          : t.a < 0 ? FkPoly(1.0)
                                    : FkPoly::unknown(t.a),
                          by, t.factor);
        else
            s.add(t.a, t.b, t.factor);
    }
    return s.take();
}

namespace {

double horner(const std::vector<double>& c, double x) {
    double y = 0;
    for (std::size_t i = c.size(); i-- > 0;) y = y * x + c[i];
    return y;
}

double bisected(const std::vector<double>& c, double low, double high) {
    const bool rising = horner(c, low) < 0;
    for (int i = 0; i < 200; ++i) {
        const double middle = 0.5 * (low + high);
        if (middle <= low || middle >= high) break;
        ((horner(c, middle) < 0) == rising ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

}  // namespace

std::vector<double> real_roots(const std::vector<double>& c, double bound, double noise) {
    std::vector<double> roots;
    if (c.size() < 2) return roots;
    if (c.size() == 2) {
        if (c[1] != 0 && std::abs(c[0]) <= std::abs(c[1]) * bound) roots.push_back(-c[0] / c[1]);
        return roots;
    }
    std::vector<double> derivative;
    for (std::size_t i = 1; i < c.size(); ++i) derivative.push_back(static_cast<double>(i) * c[i]);
    std::vector<double> ends{-bound};
    for (const double turn : real_roots(derivative, bound, 0)) ends.push_back(turn);
    ends.push_back(bound);
    for (std::size_t i = 1; i < ends.size(); ++i) {
        const double low = horner(c, ends[i - 1]), high = horner(c, ends[i]);
        const bool touches = i + 1 < ends.size() && std::abs(high) <= noise;
        if ((low < 0) != (high < 0) && std::abs(low) > noise && std::abs(high) > noise)
            roots.push_back(bisected(c, ends[i - 1], ends[i]));
        if (touches && (roots.empty() || roots.back() != ends[i])) roots.push_back(ends[i]);
    }
    return roots;
}

}  // namespace obrys::path
