#include "cycles/groove/contour.hpp"

#include <algorithm>
#include <cmath>

#include "base/number.hpp"
#include "base/whole.hpp"

namespace obrys::cycles::groove {

namespace {

Vec2 crossing(Vec2 p, Vec2 along, Vec2 q, Vec2 other_way) {
    return p + (geom::cross(q - p, other_way) / geom::cross(along, other_way)) * along;
}

struct Lines {
    std::array<Vec2, 2> edge, corner;  ///< by Side, before their elements
};

/// Down a flank.
Vec2 down(const Shape& s, Side side) {
    const double f = s.flank[index(side)];
    return {-outward(side) * std::sin(f), -std::cos(f)};
}

Vec2 along_surface(const Shape& s) { return {std::cos(s.slope), std::sin(s.slope)}; }

/// The groove's sharp lines, moved into the material's side of the finished ones by the allowances.
Lines lines_of(const Shape& s, double leave_bottom, double leave_flank) {
    const double low = s.p.y - s.depth;
    const Vec2 right{s.p.x - s.depth * std::tan(s.flank[index(Side::right)]), low};
    const std::array<Vec2, 2> foot{Vec2{right.x - s.width, low}, right};
    Lines l;
    for (const Side side : {Side::left, Side::right}) {
        const Vec2 way = down(s, side);
        // normal to the flank, into the groove
        const Vec2 in{-outward(side) * std::cos(s.flank[index(side)]), std::sin(s.flank[index(side)])};
        const Vec2 start = foot[index(side)] + leave_flank * in;
        l.corner[index(side)] = crossing(start, way, {0, low + leave_bottom}, {1, 0});
        l.edge[index(side)] = crossing(start, way, s.p, along_surface(s));
    }
    return l;
}

double turn_between(Vec2 before, Vec2 behind) { return std::acos(std::clamp(geom::dot(before, behind), -1.0, 1.0)); }

/// The element about `at`, where the contour turns from `before` to `behind` (unit vectors). Nothing for sharp ones.
void add_corner(std::vector<Piece>& pieces, const Corner& corner, Vec2 at, Vec2 before, Vec2 behind) {
    if (corner.size == 0) return;
    const double turn = turn_between(before, behind), leg = leg_of(corner, turn);
    Piece p{at - leg * before, at + leg * behind, {}, 0};
    if (corner.form == Corner::Form::radius) {
        const double sign = geom::cross(before, behind) < 0 ? -1 : 1;
        p.centre = p.from + sign * corner.size * geom::left_of(before);
        p.sweep = sign * turn;
    }
    pieces.push_back(p);
}

/// Joins the elements with the flank between them.
Wall wall_of(const Shape& s, const Lines& l, Side side, bool with_outer) {
    Wall w{l.edge[index(side)], l.corner[index(side)], {}};
    const Vec2 flank = down(s, side);
    const Vec2 surface = -outward(side) * along_surface(s), bottom{-outward(side), 0};
    if (with_outer) add_corner(w.pieces, s.outer[index(side)], w.edge, surface, flank);
    const Vec2 from = w.pieces.empty() ? w.edge : w.pieces.back().to;
    std::vector<Piece> inner;
    add_corner(inner, s.inner[index(side)], w.corner, flank, bottom);
    const Vec2 to = inner.empty() ? w.corner : inner.front().from;
    if (geom::distance(from, to) > nothing || (w.pieces.empty() && inner.empty()))
        w.pieces.push_back({from, to, {}, 0});
    w.pieces.insert(w.pieces.end(), inner.begin(), inner.end());
    return w;
}

Contour contour_of(const Shape& s, const Lines& l, bool with_outer) {
    return {{wall_of(s, l, Side::left, with_outer), wall_of(s, l, Side::right, with_outer)}, l.corner[0].y, s.slope};
}

std::string mm(double value) { return base::shortest(std::round(value * 1e4) / 1e4) + " mm"; }

/// Corner elements must fit on the sides between them.
std::optional<Refusal> overlapping(const Shape& s, const Lines& l, bool with_outer, std::string_view contour) {
    double on_bottom = 0;
    for (const Side side : {Side::left, Side::right}) {
        const Vec2 flank = down(s, side), surface = -outward(side) * along_surface(s), bottom{-outward(side), 0};
        const double inner = leg_of(s.inner[index(side)], turn_between(flank, bottom));
        const double outer = with_outer ? leg_of(s.outer[index(side)], turn_between(surface, flank)) : 0;
        const double length = geom::distance(l.edge[index(side)], l.corner[index(side)]);
        on_bottom += inner;
        if (inner + outer > length + nothing)
            return Refusal{Guard::no_groove_left,
                           "corner elements overlap on the " + std::string(side == Side::left ? "left" : "right") +
                               " flank of the " + std::string(contour) + " contour: they take " + mm(inner + outer) +
                               " of " + mm(length),
                           "make the radii or chamfers of this side smaller, or the groove deeper"};
    }
    if (on_bottom > l.corner[1].x - l.corner[0].x + nothing)
        return Refusal{Guard::no_groove_left,
                       "corner elements overlap on the bottom of the " + std::string(contour) + " contour: they take " +
                           mm(on_bottom) + " of " + mm(l.corner[1].x - l.corner[0].x),
                       "make the inner radii or chamfers smaller, or the bottom wider"};
    return std::nullopt;
}

std::optional<Refusal> nothing_left(const Shape& s, const Lines& l) {
    if (!(l.corner[1].x - l.corner[0].x > nothing))
        return Refusal{Guard::no_groove_left, "no groove is left: the allowances on the flanks take the whole bottom",
                       "make the allowance on the flanks smaller, or the bottom wider"};
    for (const Side side : {Side::left, Side::right})
        if (!(l.edge[index(side)].y - l.corner[index(side)].y > nothing))
            return Refusal{Guard::no_groove_left,
                           "no groove is left: on the " + std::string(side == Side::left ? "left" : "right") +
                               " the surface lies no higher than the bottom" +
                               (s.leave_bottom > 0 ? " with its allowance" : ""),
                           "make the groove deeper or narrower, or the slope of the surface or the allowance smaller"};
    return std::nullopt;
}

}  // namespace

double leg_of(const Corner& corner, double turn) {
    switch (corner.form) {
        case Corner::Form::radius: return corner.size * std::tan(turn / 2);
        case Corner::Form::leg: return corner.size;
        case Corner::Form::base: return corner.size / (2 * std::cos(turn / 2));
    }
    return 0;
}

double Piece::u_at(double v) const {
    if (sweep == 0) {
        if (from.y == to.y) return to.x;
        return from.x + (v - from.y) / (to.y - from.y) * (to.x - from.x);
    }
    const double r = geom::distance(from, centre), h = v - centre.y;
    const double half = std::sqrt(std::max(0.0, r * r - h * h));
    // the half that the piece lies on
    return centre.x + ((from.x + to.x) / 2 < centre.x ? -half : half);
}

double Contour::surface(double u) const {
    const Vec2 e = wall(Side::right).edge;
    return e.y + (u - e.x) * std::tan(slope);
}

double Contour::u_of(Side side, double v) const {
    const Wall& w = wall(side);
    if (v >= w.edge.y) {
        const double rise = std::tan(slope);
        return v == w.edge.y || rise * outward(side) >= 0 ? w.edge.x : w.edge.x + (v - w.edge.y) / rise;
    }
    for (const Piece& p : w.pieces)
        if (v >= p.to.y && v <= p.from.y) return p.u_at(v);
    return v <= bottom ? w.foot().x : w.top().x;
}

double Contour::v_of(Side side, double u) const {
    const Wall& w = wall(side);
    const double inward = -outward(side);
    if ((u - w.foot().x) * inward >= 0) return bottom;
    for (std::size_t i = w.pieces.size(); i-- > 0;) {
        const Piece& p = w.pieces[i];
        if ((u - p.from.x) * inward < 0) continue;
        if (p.sweep == 0)
            return p.from.x == p.to.x ? p.to.y : p.from.y + (u - p.from.x) / (p.to.x - p.from.x) * (p.to.y - p.from.y);
        const double r = geom::distance(p.from, p.centre), d = u - p.centre.x;
        const double half = std::sqrt(std::max(0.0, r * r - d * d));
        return p.centre.y + ((p.from.y + p.to.y) / 2 < p.centre.y ? -half : half);
    }
    return w.pieces.front().from.x == w.pieces.front().to.x ? w.pieces.front().to.y : w.top().y;
}

double Contour::reach(double u, double blade) const {
    return std::max({bottom, v_of(Side::left, u), v_of(Side::right, u + blade)});
}

double Contour::crest() const {
    const Wall &l = wall(Side::left), &r = wall(Side::right);
    return std::max({l.edge.y, l.top().y, r.edge.y, r.top().y});
}

double Contour::area() const {
    // Under a boundary that goes round counter-clockwise: left side down, bottom, right side up, surface back.
    double twice = 0;
    const auto line = [&](Vec2 a, Vec2 b) { twice += geom::cross(a, b); };
    const auto side = [&](const Wall& w, double sign) {
        for (const Piece& p : w.pieces) {
            twice += sign * geom::cross(p.from, p.to);
            if (p.sweep == 0) continue;
            const double r = geom::distance(p.from, p.centre);
            twice += sign * r * r * (p.sweep - std::sin(p.sweep));
        }
    };
    side(wall(Side::left), 1);
    line(wall(Side::left).foot(), wall(Side::right).foot());
    side(wall(Side::right), -1);
    line(wall(Side::right).top(), wall(Side::left).top());
    return twice / 2;
}

std::variant<Contours, Refusal> contours_of(const Shape& s, double blade) {
    const double rise = std::tan(s.slope);
    if (!(1 - rise * std::tan(s.flank[index(Side::right)]) > 0) ||
        !(1 + rise * std::tan(s.flank[index(Side::left)]) > 0))
        return Refusal{Guard::no_groove_left, "a flank leans so far that it never meets the surface",
                       "make the angle of the flank or the slope of the surface smaller"};
    const Lines rough = lines_of(s, s.leave_bottom, s.leave_flank), finished = lines_of(s, 0, 0);
    if (std::optional<Refusal> r = nothing_left(s, finished)) return *r;
    if (std::optional<Refusal> r = nothing_left(s, rough)) return *r;
    if (std::optional<Refusal> r = overlapping(s, finished, true, "finished")) return *r;
    if (std::optional<Refusal> r = overlapping(s, rough, false, "rough")) return *r;
    Contours c{contour_of(s, rough, false), contour_of(s, finished, true)};
    if (blade > c.rough.flat() + nothing)
        return Refusal{Guard::insert_wider,
                       "the insert of " + mm(blade) + " is wider than the flat bottom of " + mm(c.rough.flat()) +
                           " that roughing leaves",
                       "take a narrower insert, or make the allowance on the flanks or the inner corners smaller"};
    return c;
}

std::optional<Refusal> refused(const Request& request, const Contours& c) {
    const auto& [shape, insert, manner] = request;
    if (!(manner.infeed > 0))
        return Refusal{Guard::infeed, "the infeed is " + mm(manner.infeed), "give `infeed` a length above 0"};
    if (!(2 * insert.corner_radius < insert.width))
        return Refusal{
            Guard::insert_corner,
            "two corners of " + mm(insert.corner_radius) + " leave nothing of an insert of " + mm(insert.width),
            "give `corner_radius` less than half of `insert_width`"};
    if (!(manner.stepover > 0) || manner.stepover > insert.width)
        return Refusal{Guard::stepover,
                       "the step sideways of " + mm(manner.stepover) + " is not between 0 and the insert's width of " +
                           mm(insert.width),
                       "give `stepover` at most the insert's width, usually 0.8 of it"};
    const double deep = c.finished.crest() - c.finished.bottom + manner.clearance;
    double least = manner.infeed;
    for (const double step : {manner.peck, manner.layer}) least = step > 0 ? std::min(least, step) : least;
    const double across = c.finished.wall(Side::right).edge.x - c.finished.wall(Side::left).edge.x;
    if ((1 + deep / least) * (1 + across / manner.stepover) > most_cuts)
        return Refusal{Guard::infeed,
                       "steps of " + mm(least) + " down and " + mm(manner.stepover) + " sideways make more than " +
                           base::shortest(most_cuts) + " cuts",
                       "give `infeed`, `stepover`, `peck` or `layer` a larger length"};
    if (deep > insert.reach)
        return Refusal{Guard::overhang,
                       "the groove with its clearance is " + mm(deep) + " deep, the insert reaches " + mm(insert.reach),
                       "take a longer blade (`reach`), or make the groove less deep"};
    return std::nullopt;
}

int steps_of(double length, double step) {
    return base::clipped<int>(std::ceil(length / step - nothing), 0, 1'000'000);
}

std::string_view name_of(Guard guard) {
    switch (guard) {
        case Guard::insert_wider: return "insert-wider";
        case Guard::no_groove_left: return "no-groove-left";
        case Guard::infeed: return "infeed";
        case Guard::insert_corner: return "insert-corner";
        case Guard::overhang: return "overhang";
        case Guard::holder: return "holder";
        case Guard::stepover: return "stepover";
        case Guard::rib: return "rib";
        case Guard::layer: return "layer";
        case Guard::ramp: return "ramp";
    }
    return "";
}

}  // namespace obrys::cycles::groove
