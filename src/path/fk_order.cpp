/// The order of the ways in which a solution parts. The control's order is documented nowhere. This one is fixed by the
/// geometry, so that moving or turning a contour does not change it, and chosen so that the FSELECT numbers in the
/// manual's three FK examples and in the TNC 370 manual's give the contours drawn there (fk_examples_test.cpp).
#include <algorithm>
#include <cmath>

#include "path/fk_system.hpp"

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

}  // namespace

/// The larger comes first. Lines: towards the auxiliary point, else the left turn. End points and centres: further along
/// the line that ends or begins there. End points of arcs: the longer arc. Other centres: left of the way ahead.
double FkSolver::key(const FkBranch& b, const FkGuide& g, const FkGuide* before, const FkGuide* next, int group) const {
    const auto from = known(b, g.from_x, g.from_y);
    if (group < 0) {
        const auto ahead = along(b, &g);
        return ahead && g.on && from ? geom::dot(*ahead, *g.on - *from) : 0;
    }
    if (group == g.end) {
        const auto normal = known(b, g.normal_x, g.normal_y);
        const auto p = point(b, g.end);
        if (!p && normal) {
            const geom::Vec2 ahead{normal->y, -normal->x};
            if (const auto u = along(b, before)) return geom::cross(*u, ahead);
            return ahead.x;
        }
        if (!p) return 0;
        if (const auto u = along(b, &g)) return geom::dot(*u, *p);
        if (const auto u = along(b, next)) return geom::dot(*u, *p);
        const auto centre = g.arc ? point(b, g.carrier) : std::nullopt;
        const auto radius = g.arc ? b.known(FkPoly::unknown(4 * g.carrier + 4)) : std::nullopt;
        if (centre && from && radius) {
            const double turn = std::copysign(1.0, *radius) * turn_between(*from - *centre, *p - *centre);
            return turn <= 0 ? turn + 2 * geom::pi : turn;
        }
        return from ? geom::cross(*from, *p - *from) : p->x;
    }
    const auto centre = g.arc ? point(b, g.carrier) : std::nullopt;
    if (!centre) return 0;
    if (const auto u = along(b, before)) return geom::dot(*u, *centre);
    if (const auto u = along(b, next)) return geom::dot(*u, *centre);
    const auto last = before != nullptr && before->arc ? point(b, before->carrier) : std::nullopt;
    const auto ahead = next != nullptr && next->arc ? point(b, next->carrier) : std::nullopt;
    if (last && ahead) return geom::cross(*ahead - *last, *centre - *last);
    return from ? geom::cross(*from, *centre - *from) : centre->x;
}

void FkSolver::order(std::vector<FkBranch>& ways) const {
    if (ways.size() < 2) return;
    for (std::size_t i = 0; i < guides_.size(); ++i) {
        const FkGuide* before = i > 0 ? &guides_[i - 1] : nullptr;
        const FkGuide* next = i + 1 < guides_.size() ? &guides_[i + 1] : nullptr;
        for (const int group : {-1, guides_[i].carrier, guides_[i].end}) {
            std::vector<std::pair<double, std::size_t>> keys;
            for (std::size_t w = 0; w < ways.size(); ++w)
                keys.emplace_back(key(ways[w], guides_[i], before, next, group), w);
            const auto [low, high] = std::minmax_element(keys.begin(), keys.end());
            if (!(high->first - low->first > 1e-6)) continue;
            std::stable_sort(keys.begin(), keys.end(), [](const auto& s, const auto& t) { return s.first > t.first; });
            std::vector<FkBranch> sorted;
            for (const auto& k : keys) sorted.push_back(std::move(ways[k.second]));
            ways = std::move(sorted);
            return;
        }
    }
}

}  // namespace obrys::path
