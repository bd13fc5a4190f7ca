#include "cycles/groove/path.hpp"

#include <algorithm>
#include <cmath>

namespace obrys::cycles::groove {

namespace {

double length_of(const BladeMove& m) {
    return m.sweep == 0 ? geom::distance(m.from, m.to) : std::abs(m.sweep) * geom::distance(m.from, m.centre);
}

}  // namespace

Blade::Blade(const Request& request, const Contour& contour, Skyline stock)
    : request_(request), contour_(contour), stock_(stock), surface_(std::move(stock)), width_(request.insert.width) {}

double Blade::flush(Side side, double v) const {
    const double u = contour_.u_of(side, v) - (side == Side::right ? width_ : 0);
    // Above the lower edge the other side is the surface: the blade may stand over it.
    if (v <= contour_.wall(side).edge.y) return u;
    const double far = contour_.u_of(other(side), v) - (side == Side::left ? width_ : 0);
    return side == Side::left ? std::min(u, far) : std::max(u, far);
}

bool Blade::has_stock(double u, double v) const { return highest(u) > v + nothing; }

void Blade::rapid(Vec2 to) {
    if (placed_ && geom::distance(at_, to) == 0) return;
    if (placed_) doings_.rapid += geom::distance(at_, to);
    moves_.push_back({Move::Kind::rapid, to, {}, 0, 1, 0, right_});
    at_ = to;
    placed_ = true;
}

void Blade::link(double u) {
    // Round corners leave up to their radius of what a sharp blade would have cut.
    const double clearance = manner().clearance + corner_radius(), begin = placed_ ? std::min(at_.x, u) : u;
    const double end = (placed_ ? std::max(at_.x, u) : u) + width_;
    const double over = stock_.highest(begin, end) + clearance;
    if (!placed_) {
        rapid({u, std::max(contour_.crest(), highest(u)) + clearance});
    } else if (at_.x != u) {
        if (at_.y < over) rapid({at_.x, over});
        rapid({u, at_.y});
    }
    const double above = highest(u) + clearance;
    if (at_.y > above || at_.y < above) rapid({u, above});
}

void Blade::feed(const BladeMove& move) {
    const double length = length_of(move);
    if (length == 0) return;
    doings_.feed += length;
    const bool down = move.from.x == move.to.x && move.sweep == 0;
    const Removed removed = stock_.cut(move, width_);
    doings_.area += removed.area;
    if (!down && removed.depth <= nothing) doings_.air += length;
    if (move.from.y == move.to.y) doings_.thickest_side = std::max(doings_.thickest_side, removed.depth);
    moves_.push_back(
        {move.sweep == 0 ? Move::Kind::feed : Move::Kind::arc, move.to, move.centre, move.sweep, factor_, 0, right_});
    at_ = move.to;
}

/// Of the two walls within a tenth of its width beside the blade.
double Blade::lower_wall() const {
    const double beside = 0.1 * width_, u = at_.x;
    return std::min(stock_.highest(u - beside, u), stock_.highest(u + width_, u + width_ + beside)) - at_.y;
}

/// The blade stands at v after a plunge from `top`.
void Blade::look_at_plunge(double top, double v) {
    const double u = at_.x, deep = top - v, wall = lower_wall();
    doings_.slot = std::max(doings_.slot, wall);
    doings_.confined += std::clamp(wall - width_, 0.0, deep);
    doings_.longest = std::max(doings_.longest, deep);
    doings_.widest_plunge = std::max(doings_.widest_plunge, width_);
    const double depth = surface_.highest(u, u + width_) - v;
    if (depth <= 2 * width_) return;
    const double open = stock_.open_area(stock_.stretches().front().begin, u, v, surface_) +
                        stock_.open_area(u + width_, stock_.stretches().back().end, v, surface_);
    const double part = open / (width_ * depth);
    doings_.open = std::isnan(doings_.open) ? part : std::min(doings_.open, part);
}

bool Blade::plunge(double u, double v, bool even_without_stock) {
    if (!even_without_stock && !has_stock(u, v)) return false;
    link(u);
    const double top = std::max(v, highest(u));
    doings_.air += std::max(0.0, at_.y - top);
    ++doings_.plunges;
    feed({at_, {u, v}});
    look_at_plunge(top, v);
    return true;
}

void Blade::peck(double u, double v, double depth) {
    if (!(depth > 0)) {
        plunge(u, v);
        return;
    }
    double level = highest(u);
    while (has_stock(u, v)) {
        level = std::max(level - depth, v);
        if (level - v < nothing) level = v;
        const double top = highest(u);
        if (level == highest(u)) break;
        if (at_.x != u || at_.y < top) link(u);
        doings_.air += std::max(0.0, at_.y - top);
        ++doings_.plunges;
        feed({at_, {u, level}});
        look_at_plunge(top, level);
        if (level > v) rapid({u, level + manner().retract});
    }
}

void Blade::straight(Vec2 to) { feed({at_, to}); }

void Blade::along(const Piece& piece, double shift, bool right) {
    const bool was = right_;
    right_ = right;
    const Vec2 by{shift, 0};
    feed({at_, piece.to + by, piece.centre + by, piece.sweep});
    right_ = was;
}

/// Of the side's contour, from height `high` down to `low`.
std::vector<Piece> Blade::between(Side side, double high, double low) const {
    std::vector<Piece> parts;
    for (const Piece& p : contour_.wall(side).pieces) {
        if (p.to.y >= high || p.from.y <= low || p.to.y >= p.from.y) continue;
        Piece part = p;
        if (p.from.y > high) part.from = {p.u_at(high), high};
        if (p.to.y < low) part.to = {p.u_at(low), low};
        if (p.sweep != 0) {
            const Vec2 a = part.from - p.centre, b = part.to - p.centre;
            part.sweep = std::atan2(geom::cross(a, b), geom::dot(a, b));
        }
        if (geom::distance(part.from, part.to) > 0) parts.push_back(part);
    }
    return parts;
}

void Blade::follow(Side side, double v) {
    for (const Piece& p : between(side, at_.y, v)) along(p, shift_of(side), side == Side::right);
}

void Blade::descend(Side side, double above, double v) {
    const bool plunges = flush(side, above) == flush(side, v);
    if (!plunges) {
        follow(side, v);
        doings_.slot = std::max(doings_.slot, lower_wall());
        return;
    }
    const double top = highest(at_.x);
    if (top <= v + nothing) return;
    ++doings_.plunges;
    straight({at_.x, v});
    look_at_plunge(top, v);
}

void Blade::lift(double height) {
    if (height > at_.y) rapid({at_.x, height});
}

void Blade::dwell() {
    if (manner().dwell > 0) moves_.push_back({Move::Kind::dwell, at_, {}, 0, 1, manner().dwell, right_});
}

void Blade::out() {
    if (placed_) lift(std::max(contour_.crest(), surface_.highest(at_.x, at_.x + width_)) + manner().clearance);
}

void Blade::wedge(Side side, double level, double clean) {
    clean = std::min(clean, contour_.wall(side).edge.y);
    if (!(clean > level)) return;
    const double from = contour_.u_of(side, level), to = contour_.u_of(side, clean);
    const double width = std::abs(to - from);
    if (width < nothing) return;
    const int n = std::max(1, steps_of(width, manner().stepover));
    double reached = level;
    for (int i = 1; i <= n; ++i) {
        const double u = from + (to - from) * i / n;
        const double contact = i == n ? clean : std::min(clean, contour_.v_of(side, u));
        const double left = u - (side == Side::right ? width_ : 0);
        if (contact <= reached) continue;
        Skyline after = stock_;
        double depth = after.cut({{left, contact + 1}, {left, contact}}, width_).depth;
        const Vec2 shift{shift_of(side), 0};
        for (const Piece& p : between(side, contact, reached))
            depth = std::max(depth, after.met({p.from + shift, p.to + shift, p.centre + shift, p.sweep}, width_).depth);
        if (depth > nothing) {
            plunge(left, contact, true);
            follow(side, level);
        }
        reached = contact;
    }
}

}  // namespace obrys::cycles::groove
