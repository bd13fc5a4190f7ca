#include "path/compensation/clearance.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace obrys::path {

using geom::Vec2;
using Role = Item::Role;

namespace {

/// Places on the path nearer than this are one, mm.
constexpr double same_place = 1e-7;
constexpr std::size_t largest_window = 1000;

bool carries_zone(Role r) { return r == Role::contour || r == Role::transition || r == Role::absent; }

/// Positive to the left.
double curvature(const Element& e) {
    return is_arc(e) ? std::copysign(1 / geom::distance(e.from, e.centre), e.sweep) : 0;
}

/// A reversal is no outer corner where the tool stands in the cusp between the two elements.
bool inside_cusp(const Item& a, const Item& b, double turn) {
    return std::abs(turn) > geom::pi - 1e-6 && a.d1 * (curvature(a.e) + curvature(b.e)) < 0;
}

void prolong(Item& a, Item& b, const Crossing& c) {
    if (is_arc(a.e)) a.curve.sweep = std::copysign(c.on_a, a.curve.sweep);
    a.curve.to = c.point;
    if (is_arc(b.e)) b.curve.sweep = std::copysign(extent(b.curve) - c.on_b, b.curve.sweep);
    b.curve.from = c.point;
    a.box = box_of(a.curve);
    b.box = box_of(b.curve);
}

Item transition(const Item& a, Item& b, Vec2 from, Vec2 to, double turn) {
    Item t;
    t.role = Role::transition;
    t.s = b.s;
    t.d0 = t.d1 = a.d1;
    t.e = line(from, to, a.after.empty() ? a.e.w_to : a.after.back().w_to);
    t.e.centre = a.e.to;
    t.e.sweep = turn;
    t.e.tag = b.e.tag;
    t.e.before = std::exchange(b.e.before, {});
    t.curve = Curve{from, to, t.e.centre, turn, std::abs(a.d1), std::abs(a.d1)};
    t.start = from;
    t.zone = zone_of(t);
    t.box = box_of(t.curve);
    return t;
}

}  // namespace

double zone_of(const Item& item) {
    if (!carries_zone(item.role) || item.s.clearance == Clearance::neighbours) return 0;
    if (std::abs(item.d1) <= same_point || std::abs(item.d1 - item.d0) > same_point) return 0;
    return item.d1;
}

geom::Box box_of(const Curve& c) {
    const double r = c.sweep == 0 ? 0 : std::max(std::abs(c.radius_from), std::abs(c.radius_to));
    const bool flat = std::abs(c.sweep) <= geom::pi;  // then no point is farther than the sagitta from the chord
    const double rise = flat ? r * (1 - std::cos(0.5 * c.sweep)) + std::abs(c.radius_from - c.radius_to) : r;
    geom::Box box;
    for (const Vec2 p : {flat ? c.from : c.centre, flat ? c.to : c.centre}) {
        box.add(p - Vec2{rise, rise});
        box.add(p + Vec2{rise, rise});
    }
    return box;
}

std::optional<Item> make_corner(Item& a, Item& b) {
    if (!same_zone(a, b) || geom::distance(a.e.to, b.e.from) > gap) return std::nullopt;
    const Vec2 from = a.e.to + a.d1 * geom::left_of(end_direction(a.e));
    const Vec2 to = b.e.from + b.d0 * geom::left_of(start_direction(b.e));
    if (geom::distance(from, to) <= same_point) return std::nullopt;
    const auto turn = outer_turn(a, b);
    if (!turn || *turn == 0 || inside_cusp(a, b, *turn)) return std::nullopt;
    if (a.role == Role::contour && b.role == Role::contour)
        if (const auto c = outer_crossing(a, b, *turn)) {
            prolong(a, b, *c);
            return std::nullopt;
        }
    return transition(a, b, from, to, *turn);
}

std::optional<Crossing> entry(const Item& a, const Item& zone) {
    if (zone.role == Role::absent || !geom::overlap(a.box, zone.box, same_point)) return std::nullopt;
    return first_entry(a.curve, a.begin, zone.curve, std::copysign(1.0, a.d1));
}

std::optional<Exit> exit_to_next(const Item& a, const Item& b) {
    if (b.role == Role::absent) return std::nullopt;
    const Exit straight{1, {a.curve.to, extent(a.curve), 0}, true};
    const double apart = geom::distance(a.curve.to, b.curve.from);
    const bool both = a.role == Role::contour && b.role == Role::contour;
    if (apart <= same_point || (both && a.s.at_end == CornerEnd::open)) return straight;
    if (const auto c = entry(a, b)) return Exit{1, *c, false};
    if (apart <= blend || a.loose || (both && geom::distance(a.e.to, b.e.from) > gap)) return straight;
    return std::nullopt;
}

Reach reach(const std::deque<Item>& window) {
    const std::size_t most = std::clamp<std::size_t>(window.front().s.window, 1, largest_window);
    Reach r;
    std::size_t elements = 0;
    for (; r.count < window.size() && elements < most; ++r.count) {
        const Item& item = window[r.count];
        if (!same_zone(window.front(), item)) {
            r.complete = true;
            return r;
        }
        if (item.role != Role::transition) ++elements;
    }
    // A corner still to be closed by prolonging changes the last parallel.
    const bool open_end = r.count == window.size() && window.back().s.at_end == CornerEnd::crossing;
    r.complete = elements == most && !open_end;
    return r;
}

Chain chain_to(const std::deque<Item>& window, std::size_t m) {
    Chain chain;
    for (std::size_t i = 0; i <= m; ++i) chain.push_back(&window[i]);
    return chain;
}

std::optional<Exit> first_exit(const std::deque<Item>& window, std::size_t reach) {
    const Item& a = window.front();
    std::optional<Exit> best = exit_to_next(a, window[1]);
    if (best && a.s.at_end == CornerEnd::open && best->straight) return best;
    const double tolerance = same_place / scale(a.curve);
    for (std::size_t m = 2; m < reach; ++m) {
        const auto c = entry(a, window[m]);
        if (!c || (best && c->on_a >= best->at.on_a - tolerance)) continue;
        if (is_pocket(chain_to(window, m), c->point)) best = Exit{m, *c, false};
    }
    return best;
}

bool leads_to(const std::deque<Item>& window, std::size_t m) {
    Item a = window.front();
    for (std::size_t i = 1; i <= m; ++i) {
        const auto exit = exit_to_next(a, window[i]);
        if (!exit) return false;
        a = window[i];
        a.begin = exit->straight ? 0 : exit->at.on_b;
    }
    return true;
}

bool cuts_into(const Item& zone, const Item& a, double from, double to) {
    constexpr int samples = 16;
    for (int i = 1; i <= samples; ++i) {
        const Vec2 p = point_on(a.curve, from + (to - from) * i / samples);
        const double d = zone.role == Role::transition ? geom::distance(p, zone.e.centre)
                                                       : geom::distance(p, nearest_point(zone.e, p));
        if (d < std::abs(zone.d1) - blend) return true;
    }
    return false;
}

}  // namespace obrys::path
