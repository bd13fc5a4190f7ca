#include "make/proof.hpp"

#include <algorithm>
#include <cmath>

#include "geom/boolean.hpp"
#include "geom/region.hpp"
#include "sim/turning/turning.hpp"

namespace obrys::make {

namespace {

using geom::Contour;
using geom::Region;
using geom::Vertex;

/// The plane (u, v), moved so that all of it lies above the axis, which has no part in it.
struct Plane {
    double begin = 0, end = 0;  ///< u of the stock's ends
    double floor = 0;           ///< v of its lower side
    double high = 0;            ///< above everything
    double shift = 0;
    [[nodiscard]] Vec2 at(double u, double v) const { return {u, v + shift}; }
    [[nodiscard]] Vec2 at(Vec2 p) const { return at(p.x, p.y); }
};

Plane plane_of(const groove::Request& r, const groove::Contours& c, const std::vector<groove::Move>& moves) {
    const double beside = 4 * r.insert.width + 4 * r.manner.clearance;
    Plane p;
    p.begin = c.finished.wall(groove::Side::left).top().x;
    p.end = c.finished.wall(groove::Side::right).top().x;
    for (const groove::Move& m : moves) p.begin = std::min(p.begin, m.to.x), p.end = std::max(p.end, m.to.x);
    p.begin -= beside;
    p.end += beside + r.insert.width;
    const double low = std::min({c.finished.bottom, c.finished.surface(p.begin), c.finished.surface(p.end)});
    p.high = std::max(c.finished.surface(p.begin), c.finished.surface(p.end)) + 2 * beside;
    p.floor = low - 1;
    p.shift = 1 - p.floor;
    return p;
}

/// A wall's pieces as vertices, downward.
void add_down(std::vector<Vertex>& to, const groove::Wall& wall, const Plane& p) {
    for (const groove::Piece& piece : wall.pieces) to.push_back({p.at(piece.from), std::tan(piece.sweep / 4)});
    to.push_back({p.at(wall.foot()), 0});
}
void add_up(std::vector<Vertex>& to, const groove::Wall& wall, const Plane& p) {
    to.push_back({p.at(wall.foot()), 0});
    for (std::size_t i = wall.pieces.size(); i-- > 0;) {
        to.back().bulge = -std::tan(wall.pieces[i].sweep / 4);
        to.push_back({p.at(wall.pieces[i].from), 0});
    }
}

/// Surface and contour from left to right.
std::vector<Vertex> line_of(const groove::Contour& c, const Plane& p) {
    std::vector<Vertex> v{{p.at(p.begin, c.surface(p.begin)), 0}};
    add_down(v, c.wall(groove::Side::left), p);
    add_up(v, c.wall(groove::Side::right), p);
    v.push_back({p.at(p.end, c.surface(p.end)), 0});
    return v;
}

/// What lies above the line: counter-clockwise with the line as its lower side.
Region above(std::vector<Vertex> line, const Plane& p) {
    line.push_back({p.at(p.end, p.high), 0});
    line.push_back({p.at(p.begin, p.high), 0});
    return geom::unite({{{std::move(line), true}}}, {});
}
Region below(std::vector<Vertex> line, const Plane& p) {
    const double bottom = 1;
    Contour c{std::move(line), true};
    c.vertices.push_back({{p.end, bottom}, 0});
    c.vertices.push_back({{p.begin, bottom}, 0});
    return geom::unite({{geom::reversed(c)}}, {});
}

/// Seen from its left corner.
Contour blade_of(const groove::Insert& insert, double height) {
    const double w = insert.width, r = insert.corner_radius, quarter = std::tan(geom::pi / 8);
    if (r == 0) return {{{{0, 0}, 0}, {{w, 0}, 0}, {{w, height}, 0}, {{0, height}, 0}}, true};
    return {{{{r, 0}, 0}, {{w - r, 0}, quarter}, {{w, r}, 0}, {{w, height}, 0}, {{0, height}, 0}, {{0, r}, quarter}},
            true};
}

double extent_along_v(const Region& region) {
    double low = HUGE_VAL, high = -HUGE_VAL;
    for (const Contour& c : region.contours)
        for (const Vertex& v : c.vertices) low = std::min(low, v.p.y), high = std::max(high, v.p.y);
    return std::max(0.0, high - low);
}

}  // namespace

Proof prove(const groove::Request& request, const groove::Contours& contours, groove::Strategy strategy,
            const std::vector<groove::Move>& moves) {
    const bool finish = strategy == groove::Strategy::finishing;
    const groove::Contour& wanted = finish ? contours.finished : contours.rough;
    const Plane p = plane_of(request, contours, moves);
    const std::vector<Vertex> surface{{p.at(p.begin, wanted.surface(p.begin)), 0},
                                      {p.at(p.end, wanted.surface(p.end)), 0}};
    const Region stock = below(finish ? line_of(contours.rough, p) : surface, p);
    sim::turning::Workpiece workpiece(stock);
    const Region asked_region = above(line_of(wanted, p), p);
    sim::turning::Kept kept(below(line_of(wanted, p), p)), asked(asked_region);
    const Contour blade = blade_of(request.insert, p.high - wanted.bottom);
    Proof proof;
    const double before = workpiece.area();
    bool placed = false;
    Vec2 at;
    for (const groove::Move& m : moves) {
        if (m.kind == groove::Move::Kind::dwell) continue;
        const Vec2 to = p.at(m.to);
        if (!placed) at = to;
        placed = true;
        const sim::turning::Cut cut = workpiece.cut(blade, {at, to, p.at(m.centre), m.sweep});
        at = to;
        if (cut.removed.empty()) continue;
        if (m.kind == groove::Move::Kind::rapid)
            proof.rapid_in_stock = std::max(proof.rapid_in_stock, extent_along_v(cut.removed));
        if (const auto depth = kept.depth_inside(cut.removed, no_depth))
            proof.gouge = std::max(proof.gouge, depth->normal);
    }
    proof.removed_area = before - workpiece.area();
    proof.asked_area = finish ? contours.finished.area() - contours.rough.area() : contours.rough.area();
    if (const auto rest = asked.depth_inside(workpiece.region(), no_depth)) {
        proof.rest = rest->normal;
        proof.rest_area = rest->area;
    }
    proof.rest_bound = groove::rest_bound(request, strategy);
    return proof;
}

}  // namespace obrys::make
