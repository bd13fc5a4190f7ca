#include "path/fk/system.hpp"

#include <algorithm>
#include <cmath>

namespace obrys::path {

namespace {

constexpr double noise = 1e-11;  // of an equation's size: a term below it is what rounding left
constexpr double weak = 1e-7;    // an unknown is not eliminated by a term below it: nearly parallel, nearly concentric
constexpr double one_root = 2e-13;  // of an equation's size: the two roots are one
constexpr double lenient = 50;      // times the tolerance, where only the check of the original equation is exact
constexpr double plain_contradiction = 1e-2;  // of a direction, where the element's length is not known yet
constexpr double farthest_root = 1e4;         // of the scale: no root beyond
constexpr std::size_t most_work = 400'000;    // terms touched in one call

}  // namespace

FkPoly FkBranch::at(const FkPoly& p) const {
    FkSum s;
    const auto value = [this](int id) -> FkPoly {
        return id < 0 ? FkPoly(1.0) : values[static_cast<std::size_t>(id - base)];
    };
    for (const FkTerm& t : p.terms) s.add_product(value(t.a), value(t.b), t.factor);
    return s.take();
}

std::optional<double> FkBranch::known(const FkPoly& p) const {
    double sum = 0;
    for (const FkTerm& t : p.terms) {
        double product = t.factor;
        for (const int id : {t.a, t.b}) {
            if (id < 0) continue;
            const FkPoly& v = values[static_cast<std::size_t>(id - base)];
            if (!v.is_constant()) return {};
            product *= v.constant();
        }
        sum += product;
    }
    return sum;
}

double fk_miss(const FkEquation& e, const FkBranch& b) {
    const double value = std::abs(b.known(e.poly).value_or(NAN));
    if (e.unit == FkUnit::direction) return value;
    std::vector<std::array<double, 3>> gradient;  // group, and the slopes of its two coordinates
    const auto add = [&gradient](int id, double slope) {
        if (id < 0 || is_direction(id)) return;
        auto g = std::find_if(gradient.begin(), gradient.end(), [id](const auto& x) { return x[0] == id / 4; });
        if (g == gradient.end()) g = gradient.insert(g, {static_cast<double>(id / 4), 0, 0});
        (*g)[id % 4 == 0 ? 1 : 2] += slope;
    };
    const auto at = [&b](int id) { return id < 0 ? 1.0 : b.values[static_cast<std::size_t>(id - b.base)].constant(); };
    for (const FkTerm& t : e.poly.terms) {
        add(t.a, t.factor * at(t.b));
        add(t.b, t.factor * at(t.a));
    }
    double steepest = 0;
    for (const auto& g : gradient) steepest = std::max(steepest, std::hypot(g[1], g[2]));
    return steepest > 0 ? value / steepest : value;
}

double FkSolver::contribution(const FkTerm& t) const {
    double c = std::abs(t.factor);
    for (const int id : {t.a, t.b})
        if (id >= 0) c *= weight(id);
    return c;
}

double FkSolver::in_mm(const FkEquation& e, double value) const {
    if (e.unit == FkUnit::square) return std::abs(value) / (2 * scale_);
    return std::abs(value) * (e.unit == FkUnit::direction ? scale_ : 1);
}

double FkSolver::reach(const FkBranch& b, std::uint64_t tag) const {
    const auto c = std::find_if(chords_.begin(), chords_.end(), [tag](const FkChord& x) { return x.tag == tag; });
    if (c == chords_.end()) return scale_;
    const auto x = b.known(c->x), y = b.known(c->y);
    return x && y ? std::hypot(*x, *y) : -1;
}

void FkSolver::clean(FkEquation& e) const {
    for (const FkTerm& t : e.poly.terms) e.size = std::max(e.size, contribution(t));
    std::erase_if(e.poly.terms, [&](const FkTerm& t) { return t.b >= 0 && contribution(t) <= noise * e.size; });
}

void FkSolver::die(std::uint64_t tag, FkDatum datum, double miss) {
    if (!nearest || !(miss >= nearest->miss)) nearest = FkDeath{tag, datum, miss};
}

void FkSolver::add(FkBranch& b, const FkEquations& equations) const {
    for (const FkEquation& e : equations.equal) {
        b.checks.push_back(e);
        b.stated.push_back(e);
        b.open.push_back(e);
        for (const FkTerm& t : e.poly.terms) b.open.back().size = std::max(b.open.back().size, contribution(t));
        b.open.back().poly = b.at(e.poly);
        clean(b.open.back());
    }
    b.limits.insert(b.limits.end(), equations.least.begin(), equations.least.end());
    b.polar.insert(b.polar.end(), equations.polar.begin(), equations.polar.end());
}

void FkSolver::put(FkBranch& b, int id, const FkPoly& by) {
    for (std::size_t i = 0; i < b.values.size(); ++i) {
        FkPoly& v = b.values[i];
        if (!v.contains(id)) continue;
        v = substituted(v, id, by);
        const double size = weight(b.base + static_cast<int>(i));
        std::erase_if(v.terms, [&](const FkTerm& t) { return t.b >= 0 && contribution(t) <= noise * size; });
        work_ += v.terms.size();
    }
    for (FkEquation& e : b.open) {
        if (!e.poly.contains(id)) continue;
        e.poly = substituted(e.poly, id, by);
        clean(e);
        work_ += e.poly.terms.size();
    }
}

FkSolver::Progress FkSolver::drop_constant(FkBranch& b) {
    for (const FkEquation& e : b.open)
        if (e.poly.is_constant() && !(in_mm(e, e.poly.constant()) <= lenient * fk_tolerance)) {
            // The check of the original equation tells the miss exactly where all is known.
            const bool stated = std::any_of(b.checks.begin(), b.checks.end(), [&](const FkEquation& c) {
                return c.tag == e.tag && c.datum == e.datum && b.known(c.poly);
            });
            if (!stated) return die(e.tag, e.datum, in_mm(e, e.poly.constant())), Progress::dead;
        }
    std::erase_if(b.open, [](const FkEquation& e) { return e.poly.is_constant(); });
    return Progress::none;
}

FkSolver::Progress FkSolver::linear(FkBranch& b) {
    for (std::size_t i = 0; i < b.open.size(); ++i) {
        const FkEquation& e = b.open[i];
        if (!e.poly.is_affine() || e.poly.is_constant()) continue;
        const auto pivot =
            std::max_element(e.poly.terms.begin(), e.poly.terms.end(), [this](const FkTerm& s, const FkTerm& t) {
                return (s.b < 0 ? 0 : contribution(s)) < (t.b < 0 ? 0 : contribution(t));
            });
        if (contribution(*pivot) <= weak * e.size) continue;
        const int id = pivot->b;
        FkPoly by = (-1 / pivot->factor) * e.poly;
        std::erase_if(by.terms, [id](const FkTerm& t) { return t.b == id; });
        b.open.erase(b.open.begin() + static_cast<std::ptrdiff_t>(i));
        put(b, id, by);
        return Progress::some;
    }
    return Progress::none;
}

bool FkSolver::whole(const FkBranch& b, const FkGuide& g) const {
    const auto known = [&b](int id) { return b.values[static_cast<std::size_t>(id - b.base)].is_constant(); };
    for (int i = 0; i < 4; ++i)
        if (!known(4 * g.end + i)) return false;
    if (!known(4 * g.carrier) || !b.known(g.from_x) || !b.known(g.from_y)) return false;
    if (!g.arc) return true;
    for (int i = 1; i < 5; ++i)
        if (!known(4 * g.carrier + i)) return false;
    return true;
}

/// True where nothing that p speaks of will change any more.
bool FkSolver::settled(const FkBranch& b, const FkPoly& p) const {
    return std::all_of(guides_.begin(), guides_.end(), [&](const FkGuide& g) {
        const int last = g.carrier + (g.arc ? 1 : 0);
        const bool spoken_of = std::any_of(p.terms.begin(), p.terms.end(), [&](const FkTerm& t) {
            return (t.a >= 4 * g.end && t.a < 4 * last + 4) || (t.b >= 4 * g.end && t.b < 4 * last + 4);
        });
        return !spoken_of || whole(b, g);
    });
}

/// Redundant data that disagree leave normals that are no unit vectors and radii that are none. Where an element has
/// all its values its points and its centre count and the rest follows from them, so that a miss shows at a datum.
void FkSolver::shape(FkBranch& b) const {
    for (const FkGuide& g : guides_) {
        if (!whole(b, g)) continue;
        const auto value = [&b](int id) -> FkPoly& { return b.values[static_cast<std::size_t>(id - b.base)]; };
        const auto pair = [&](int id) { return geom::Vec2{value(id).constant(), value(id + 2).constant()}; };
        const auto put_normal = [&](int id, geom::Vec2 n) {
            const double length = geom::length(n);
            if (!(length > fk_tolerance) || !(geom::dot(n, pair(id)) > 0)) return;
            value(id) = FkPoly(n.x / length);
            value(id + 2) = FkPoly(n.y / length);
        };
        const geom::Vec2 from{*b.known(g.from_x), *b.known(g.from_y)}, end = pair(4 * g.end);
        if (!g.arc) {
            put_normal(4 * g.end + 1, geom::left_of(end - from));
            value(4 * g.carrier) = FkPoly(geom::dot(pair(4 * g.end + 1), from));
            continue;
        }
        const geom::Vec2 centre = pair(4 * g.carrier);
        FkPoly& radius = value(4 * g.carrier + 4);
        const double sense = std::copysign(1.0, radius.constant());
        if (geom::distance(from, centre) > fk_tolerance) radius = FkPoly(sense * geom::distance(from, centre));
        put_normal(4 * g.carrier + 1, sense * (centre - from));
        put_normal(4 * g.end + 1, sense * (centre - end));
    }
}

FkSolver::Progress FkSolver::check(FkBranch& b) {
    shape(b);
    std::optional<FkDeath> worst;
    const auto wrong = [&worst](std::uint64_t tag, FkDatum datum, double miss) {
        // A datum rather than the shape as such is named.
        const bool better = worst && (worst->datum == FkDatum::element) != (datum == FkDatum::element)
                                ? worst->datum == FkDatum::element
                                : !worst || miss > worst->miss;
        if (better) worst = FkDeath{tag, datum, miss};
    };
    std::erase_if(b.checks, [&](const FkEquation& e) {
        if (!b.known(e.poly)) return false;
        double miss = fk_miss(e, b);
        const bool final = settled(b, e.poly);
        if (e.unit == FkUnit::direction) {
            const double length = reach(b, e.tag);
            if (length < 0 && miss <= plain_contradiction) return false;
            miss *= length < 0 ? scale_ : length;
        }
        if (!(miss <= (final ? 1 : lenient) * fk_tolerance)) wrong(e.tag, e.datum, miss);
        return final;
    });
    std::erase_if(b.limits, [&](const FkLimit& l) {
        const auto value = b.known(l.poly);
        if (value && !(*value >= l.least)) wrong(l.tag, l.datum, l.least - *value);
        return value.has_value();
    });
    if (!worst) return Progress::none;
    die(worst->tag, worst->datum, worst->miss);
    return Progress::dead;
}

FkSolver::Progress FkSolver::expand_polar(FkBranch& b) const {
    for (std::size_t i = 0; i < b.polar.size(); ++i) {
        const FkPolar p = b.polar[i];
        const auto rx = b.known(p.radius_from[0]), ry = b.known(p.radius_from[1]);
        const auto ax = b.known(p.angle_from[0]), ay = b.known(p.angle_from[1]);
        if (!rx || !ry || !ax || !ay) continue;
        const double radius = p.radius_is_relative ? std::hypot(*rx - p.pole.x, *ry - p.pole.y) : 0;
        const double angle = p.angle_is_relative ? std::atan2(*ay - p.pole.y, *ax - p.pole.x) : 0;
        b.polar.erase(b.polar.begin() + static_cast<std::ptrdiff_t>(i));
        add(b, polar_equations(p, radius, angle));
        return Progress::some;
    }
    return Progress::none;
}

/// Roots of an equation in one unknown; none where there are none, but one where it misses by little.
std::optional<std::vector<double>> FkSolver::roots(const FkEquation& e, int id) const {
    double a = 0, b = 0, c = 0;
    for (const FkTerm& t : e.poly.terms) (t.b < 0 ? c : t.a < 0 ? b : a) = t.factor;
    const double w = weight(id), far = is_direction(id) ? 1 + 1e-6 : farthest_root;
    a *= w * w;
    b *= w;
    const double vertex = -b / (2 * a), lowest = c - b * b / (4 * a);
    std::vector<double> found_here;
    const auto keep = [&](double x) {
        if (std::abs(x) <= far) found_here.push_back(x * w);
    };
    if (std::abs(lowest) <= one_root * e.size || (lowest * a > 0 && in_mm(e, lowest) <= fk_tolerance)) {
        keep(vertex);
    } else if (lowest * a < 0) {
        const double q = -0.5 * (b + std::copysign(std::sqrt(b * b - 4 * a * c), b));
        keep(q / a);
        keep(c / q);
        std::sort(found_here.begin(), found_here.end());
    } else {
        return {};
    }
    return found_here;
}

FkSolver::Progress FkSolver::one_unknown(FkBranch& b) {
    for (std::size_t i = 0; i < b.open.size(); ++i) {
        const FkEquation& e = b.open[i];
        if (e.poly.is_affine()) continue;
        const int id = e.poly.terms.back().b;
        const bool alone = std::all_of(e.poly.terms.begin(), e.poly.terms.end(), [id](const FkTerm& t) {
            return (t.a < 0 || t.a == id) && (t.b < 0 || t.b == id);
        });
        if (!alone) continue;
        const auto values = roots(e, id);
        if (!values || values->empty()) {
            double a = 0, half = 0, c = 0;
            for (const FkTerm& t : e.poly.terms) (t.b < 0 ? c : t.a < 0 ? half : a) = t.factor;
            die(e.tag, e.datum, in_mm(e, c - half * half / (4 * a)));
            return Progress::dead;
        }
        std::vector<std::vector<std::pair<int, double>>> ways;
        for (const double v : *values) ways.push_back({{id, v}});
        part(b, i, ways);
        return Progress::parted;
    }
    return Progress::none;
}

void FkSolver::part(const FkBranch& b, std::size_t used, const std::vector<std::vector<std::pair<int, double>>>& ways) {
    std::vector<FkBranch> children;
    for (const auto& way : ways) {
        FkBranch child = b;
        child.open.erase(child.open.begin() + static_cast<std::ptrdiff_t>(used));
        for (const auto& [id, value] : way) put(child, id, FkPoly(value));
        children.push_back(std::move(child));
    }
    for (FkBranch& child : children) solve(std::move(child));
}

void FkSolver::solve(FkBranch b) {
    for (;;) {
        if (work_ > most_work || found.size() > fk_most_solutions) exhausted = true;
        if (exhausted) return;
        // Checks come when the linear equations are used up: shape() wants whole elements.
        if (linear(b) == Progress::some) continue;
        if (drop_constant(b) == Progress::dead || check(b) == Progress::dead) return;
        if (expand_polar(b) == Progress::some) continue;
        const Progress p = one_unknown(b);
        if (p != Progress::none) return;
        if (cancel(b) == Progress::some) continue;
        if (two_unknowns(b) != Progress::none) return;
        found.push_back(std::move(b));
        return;
    }
}

}  // namespace obrys::path
