/// The order of the ways in which a solution parts. No document found tells the control's. This one is fixed by the
/// geometry, so that moving or turning a contour does not change it, and chosen so that FSELECT means a sensible
/// contour in the TNC 370 manual's example 1 and in the three of the iTNC 530 manual, 6.6, as far as these are
/// remembered: their pages and drawings were not at hand (examples_test.cpp).
#include <algorithm>
#include <cmath>

#include "path/fk/system.hpp"

namespace obrys::path {

namespace {

std::optional<geom::Vec2> known(const FkBranch& b, const FkPoly& x, const FkPoly& y) {
    const auto px = b.known(x), py = b.known(y);
    if (!px || !py) return {};
    return geom::Vec2{*px, *py};
}

std::optional<geom::Vec2> point(const FkBranch& b, int group) {
    return known(b, FkPoly::unknown(4 * group), FkPoly::unknown(4 * group + 2));
}

/// Direction of a straight element, from its left normal.
std::optional<geom::Vec2> along(const FkBranch& b, const FkGuide* g) {
    if (g == nullptr || g->arc) return {};
    const auto n = known(b, g->normal_x, g->normal_y);
    if (!n) return {};
    return geom::Vec2{n->y, -n->x};
}

double cross_at(const std::optional<geom::Vec2>& from, const std::optional<geom::Vec2>& a,
                const std::optional<geom::Vec2>& b) {
    return from && a && b ? geom::cross(*a - *from, *b - *from) : 0;
}

/// Further along the line that begins or ends there; else left of the way from the arc before to the one behind.
double centre_key(const FkBranch& b, const FkGuide& g, const FkGuide* before, const FkGuide* next) {
    const auto centre = g.arc ? point(b, g.carrier) : std::nullopt;
    if (!centre) return 0;
    if (const auto u = along(b, before)) return geom::dot(*u, *centre);
    if (const auto u = along(b, next)) return geom::dot(*u, *centre);
    const auto last = before != nullptr && before->arc ? point(b, before->carrier) : std::nullopt;
    const auto ahead = next != nullptr && next->arc ? point(b, next->carrier) : std::nullopt;
    return cross_at(last, ahead, centre);
}

/// Further along the line that begins or ends there; else the longer arc.
double end_key(const FkBranch& b, const FkGuide& g, const FkGuide* before, const FkGuide* next) {
    const auto end = point(b, g.end);
    const auto here = along(b, &g), on = along(b, next);
    if (!end) {
        const auto u = along(b, before);
        return here && u ? geom::cross(*u, *here) : 0;
    }
    if (here) return geom::dot(*here, *end);
    if (on) return geom::dot(*on, *end);
    const auto from = known(b, g.from_x, g.from_y);
    const auto centre = g.arc ? point(b, g.carrier) : std::nullopt;
    const auto radius = g.arc ? b.known(FkPoly::unknown(4 * g.carrier + 4)) : std::nullopt;
    if (!from || !centre || !radius) return 0;
    const double turn = std::copysign(1.0, *radius) * turn_between(*from - *centre, *end - *centre);
    return turn <= 0 ? turn + 2 * geom::pi : turn;
}

/// Where the keys above are equal: length of chord, radius, and where it lies from a point that the data name.
void tie_keys(const FkBranch& b, const FkGuide& g, std::vector<double>& keys) {
    const auto from = known(b, g.from_x, g.from_y), end = point(b, g.end);
    const auto centre = g.arc ? point(b, g.carrier) : std::nullopt;
    const auto normal = known(b, g.normal_x, g.normal_y);
    const auto ahead = from && normal ? std::optional(*from - geom::left_of(*normal)) : std::nullopt;
    keys.push_back(from && end ? geom::distance(*from, *end) : 0);
    keys.push_back(from && centre ? geom::distance(*from, *centre) : 0);
    for (const auto& mark : {g.on, g.beside, g.pole, std::optional(geom::Vec2{})})
        for (const auto& p : {end, centre, ahead}) {
            keys.push_back(from && mark && p ? geom::dot(*mark - *from, *p - *from) : 0);
            keys.push_back(cross_at(from, mark, p));
        }
    keys.push_back(cross_at(from, end, centre));
}

}  // namespace

std::vector<double> FkSolver::keys(const FkBranch& b) const {
    std::vector<double> out;
    for (std::size_t i = 0; i < guides_.size(); ++i) {
        const FkGuide& g = guides_[i];
        const FkGuide* before = i > 0 ? &guides_[i - 1] : nullptr;
        const FkGuide* next = i + 1 < guides_.size() ? &guides_[i + 1] : nullptr;
        const auto ahead = along(b, &g), from = known(b, g.from_x, g.from_y);
        out.push_back(ahead && from && g.on ? geom::dot(*ahead, *g.on - *from) : 0);
        out.push_back(centre_key(b, g, before, next));
        out.push_back(end_key(b, g, before, next));
    }
    for (const FkGuide& g : guides_) tie_keys(b, g, out);
    return out;
}

/// By the alternatives taken, then the larger comes first: lines towards their auxiliary point, then centres and end
/// points, element by element.
/// By insertion, since keys that count as equal need not be so transitively.
void FkSolver::put_in_order() {
    std::vector<std::vector<double>> done;
    std::vector<FkBranch> sorted;
    const auto before = [](const std::vector<double>& a, const std::vector<double>& b) {
        for (std::size_t i = 0; i < a.size(); ++i)
            if (std::abs(a[i] - b[i]) > 1e-6 * (1 + std::abs(a[i]))) return a[i] > b[i];
        return false;
    };
    for (FkBranch& b : found) {
        const std::vector<double> k = keys(b);
        std::size_t at = done.size();
        while (at > 0 && (b.path == sorted[at - 1].path ? before(k, done[at - 1]) : b.path < sorted[at - 1].path)) --at;
        done.insert(done.begin() + static_cast<std::ptrdiff_t>(at), k);
        sorted.insert(sorted.begin() + static_cast<std::ptrdiff_t>(at), std::move(b));
    }
    found = std::move(sorted);
}

}  // namespace obrys::path
