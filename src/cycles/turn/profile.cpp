#include "cycles/turn/profile.hpp"

#include <algorithm>
#include <cmath>

#include "base/number.hpp"

namespace obrys::cycles {

using geom::Vec2;

namespace {

template <class Change>
void change_all(Profile& p, Change change) {
    for (Piece& piece : p.pieces)
        for (Vec2* point : {&piece.from, &piece.to, &piece.centre}) *point = change(*point);
}

void turn_round(Profile& p) {
    for (Piece& piece : p.pieces) piece.turn = -piece.turn;
}

}  // namespace

void Profile::turn_quarter() {
    change_all(*this, [](Vec2 q) { return Vec2{q.y, -q.x}; });
    quarter_turn = !quarter_turn;
}

void Profile::lay() {
    const Vec2 run = pieces.front().to - pieces.back().to;
    if (run.y > 0) {
        change_all(*this, [](Vec2 q) { return Vec2{q.x, -q.y}; });
        turn_round(*this);
        mirrored_v = !mirrored_v;
    }
    if (run.x < 0) {
        change_all(*this, [](Vec2 q) { return Vec2{-q.x, q.y}; });
        turn_round(*this);
        mirrored_u = !mirrored_u;
    }
}

Vec2 Profile::as_programmed(Vec2 p) const {
    if (mirrored_u) p.x = -p.x;
    if (mirrored_v) p.y = -p.y;
    return quarter_turn ? Vec2{-p.y, p.x} : p;
}

Vec2 Profile::laid(Vec2 p) const {
    if (quarter_turn) p = {p.y, -p.x};
    return {mirrored_u ? -p.x : p.x, mirrored_v ? -p.y : p.y};
}

Profile profile_of(const std::vector<TurningElement>& contour, Vec2 start, double unit) {
    Profile p;
    Vec2 at = (1 / unit) * start;
    for (std::size_t i = 0; i < contour.size(); ++i) {
        const TurningElement& e = contour[i];
        const Vec2 to = (1 / unit) * e.to;
        if (to == at) continue;
        p.pieces.push_back({at, to, (1 / unit) * e.centre, e.turn, Corner::none, 0, i});
        at = to;
        if (e.fillet != 0) p.pieces.push_back({at, at, at, -1, Corner::fillet, e.fillet / unit, i});
        if (e.chamfer != 0) p.pieces.push_back({at, at, {}, 0, Corner::chamfer, e.chamfer / unit, i});
    }
    return p;
}

double extent(const Piece& p) {
    const double chord = geom::distance(p.from, p.to);
    return p.turn == 0 ? chord : std::min(chord, geom::distance(p.from, p.centre));
}

bool falls(const Piece& p) {
    if (p.turn == 0) return p.to.x - p.from.x <= profile::slack;
    if (p.corner == Corner::fillet) return true;
    const double side = p.turn > 0 ? 1 : -1;  // above the centre counter-clockwise, below it clockwise
    return side * (p.from.y - p.centre.y) >= -profile::slack && side * (p.to.y - p.centre.y) >= -profile::slack &&
           p.to.x - p.from.x <= -profile::slack;
}

void shift_sideways(Piece& p, double distance) {
    if (p.turn == 0) {
        const Vec2 back = p.from - p.to;
        const Vec2 by = (distance / geom::length(back)) * geom::left_of(back);
        p.from = p.from + by;
        p.to = p.to + by;
        return;
    }
    const double radius = geom::distance(p.from, p.centre);
    const double factor = (radius + (p.turn > 0 ? distance : -distance)) / radius;
    p.from = p.centre + factor * (p.from - p.centre);
    p.to = p.centre + factor * (p.to - p.centre);
}

namespace {

Fault join_lines(Piece& a, Piece& b) {
    const Vec2 back = b.from - b.to;
    const Vec2 unit = (1 / geom::length(back)) * back;
    const double start = geom::cross(unit, a.from - b.to), end = geom::cross(unit, a.to - b.to);
    if (start - end == 0) return "parallel lines of the contour cannot be joined";
    const double part = start / (start - end);
    b.from = a.to = a.from + part * (a.to - a.from);
    return std::nullopt;
}

/// Where the line from `origin` along `unit` meets the circle, on the side of `near`. No meeting: its nearest point.
Vec2 line_and_circle(Vec2 origin, Vec2 unit, Vec2 centre, double radius, Vec2 near) {
    const Vec2 c = centre - origin;
    const double along = geom::dot(unit, c), across = geom::cross(unit, c);
    const double half = std::sqrt(std::max(0.0, radius * radius - across * across));
    const Vec2 p = origin + (along + half) * unit, q = origin + (along - half) * unit;
    return geom::distance(near, p) < geom::distance(near, q) ? p : q;
}

void join_arcs(Piece& a, Piece& b) {
    const double rb = geom::distance(b.from, b.centre), ra = geom::distance(a.from, a.centre);
    const Vec2 between = a.centre - b.centre;
    const double c = geom::length(between);
    const double cosine = (c * c + rb * rb - ra * ra) / 2 / rb / c;
    const double sine = std::sqrt(1 - std::min(1.0, cosine * cosine));
    const Vec2 turned = cosine * between + sine * geom::left_of(between);
    a.to = b.from = b.centre + (rb / c) * turned;
}

}  // namespace

Fault join(Piece& a, Piece& b) {
    if (a.turn == 0 && b.turn == 0) return join_lines(a, b);
    if (a.turn != 0 && b.turn != 0) {
        join_arcs(a, b);
        return std::nullopt;
    }
    if (geom::distance(b.from, a.to) < profile::touch) return std::nullopt;
    const bool arc_first = a.turn != 0;
    const Piece& line = arc_first ? b : a;
    const Piece& arc = arc_first ? a : b;
    const Vec2 back = line.from - line.to;
    // The radius is that of the arc's far end as the control measures it.
    const double radius = geom::distance(arc.centre, arc.to);
    b.from = a.to = line_and_circle(line.to, (1 / geom::length(back)) * back, arc.centre, radius, b.from);
    return std::nullopt;
}

namespace {

/// The corner's two neighbours at its size, on the side where they do not overlap; otherwise a fault.
Fault finish_corner(Piece& before, Piece& corner, Piece& after) {
    Piece a, b;
    for (const double size : {corner.corner_size, -corner.corner_size}) {
        a = before;
        b = after;
        shift_sideways(a, size);
        shift_sideways(b, size);
        corner.corner_size = size;
        if (a.to.x - b.from.x <= profile::gap) break;
    }
    if (a.to.x - b.from.x > profile::gap)
        return "the corner at Z " + base::fixed(before.to.x, 4) + " X " + base::fixed(before.to.y, 4) +
               " cannot be finished";
    if (const Fault f = join(a, b)) return f;
    const Vec2 centre = 0.5 * (a.to + b.from);
    shift_sideways(a, -corner.corner_size);
    shift_sideways(b, -corner.corner_size);
    corner.from = before.to = a.to;
    corner.to = after.from = b.from;
    if (corner.corner == Corner::chamfer) return std::nullopt;
    corner.centre = centre;
    corner.turn = corner.from.y > centre.y || corner.to.y > centre.y ? 1 : -1;
    corner.corner = Corner::none;
    return std::nullopt;
}

}  // namespace

Fault finish_corners(Profile& p) {
    std::vector<Piece>& v = p.pieces;
    for (std::size_t i = 1; i + 1 < v.size(); ++i)
        if (v[i].corner != Corner::none)
            if (const Fault f = finish_corner(v[i - 1], v[i], v[i + 1])) return f;
    v.erase(std::remove_if(v.begin(), v.end(), [](const Piece& q) { return extent(q) < profile::slack; }), v.end());
    return std::nullopt;
}

Fault check_falling(Profile& p) {
    if (p.pieces.empty()) return "the contour has no length";
    Piece& first = p.pieces.front();
    if (first.to.x > first.from.x) first.from.x = first.to.x;
    for (const Piece& piece : p.pieces)
        if (!falls(piece)) return "the contour does not run in one direction";
    return std::nullopt;
}

}  // namespace obrys::cycles
