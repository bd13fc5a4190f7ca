/// Finishing: the left side with the insert's left corner, the right side and the bottom with the right one.

#include <algorithm>
#include <cmath>

#include "cycles/groove/strategy.hpp"

namespace obrys::cycles::groove {

namespace {

/// A wall's way in the order down, cut where it turns from rising to falling.
struct Way {
    std::vector<Piece> rising, falling;
};

/// A convex corner on the low side of a cone first rises to its crest.
Way way_of(const Wall& wall) {
    Way w;
    for (const Piece& p : wall.pieces) {
        const double r = geom::distance(p.from, p.centre);
        const bool over = p.sweep != 0 && p.centre.y < std::max(p.from.y, p.to.y) &&
                          (p.from.x - p.centre.x) * (p.to.x - p.centre.x) < -nothing * r;
        if (over) {
            const Vec2 crest = p.centre + Vec2{0, r};
            const auto angle = [&](Vec2 a, Vec2 b) { return std::atan2(geom::cross(a, b), geom::dot(a, b)); };
            w.rising.push_back({p.from, crest, p.centre, angle(p.from - p.centre, crest - p.centre)});
            w.falling.push_back({crest, p.to, p.centre, angle(crest - p.centre, p.to - p.centre)});
        } else {
            (p.to.y > p.from.y + nothing ? w.rising : w.falling).push_back(p);
        }
    }
    return w;
}

/// Along the pieces with this corner of the insert, from above their beginning.
void cut(Blade& blade, const std::vector<Piece>& pieces, bool right) {
    if (pieces.empty()) return;
    const double shift = right ? -blade.width() : 0;
    blade.set_right(right);
    blade.link(pieces.front().from.x + shift);
    blade.straight({pieces.front().from.x + shift, pieces.front().from.y});
    for (const Piece& p : pieces) blade.along(p, shift, right);
}

}  // namespace

void finishing(Blade& blade) {
    const Contour& c = blade.contour();
    for (const Side side : {Side::left, Side::right}) {
        const Way way = way_of(c.wall(side));
        const bool right = side == Side::right;
        // From outside, with the other corner: the blade would else stand on the crest.
        cut(blade, way.rising, !right);
        // A round corner would leave a ridge on the crest, where the other one begins.
        if (!way.rising.empty()) blade.straight(blade.at() + Vec2{-outward(side) * 2 * blade.corner_radius(), 0});
        cut(blade, way.falling, right);
        if (!right) blade.dwell();
    }
    blade.straight({c.wall(Side::left).foot().x, c.bottom});
    blade.dwell();
    blade.out();
}

}  // namespace obrys::cycles::groove
