#include "path/fk/equations.hpp"

#include <cmath>

namespace obrys::path {

using geom::Vec2;

namespace {

constexpr double shortest_line = 1e-5;  // mm; what is shorter is a line that runs backwards or not at all

/// Collects equations of one element.
class Builder {
public:
    Builder(const FkElement& e, const FkSurroundings& around) : e_(e), around_(around) {}

    void zero(FkDatum datum, FkUnit unit, const FkPoly& p) { current().equal.push_back({p, e_.tag, datum, unit, 0}); }
    void same(FkDatum datum, FkUnit unit, const FkPoly& x, const FkPoly& y, const FkPoly& tx, const FkPoly& ty) {
        zero(datum, unit, x - tx);
        zero(datum, unit, y - ty);
    }
    void least(FkDatum datum, const FkPoly& p, double value) { current().least.push_back({p, value, e_.tag, datum}); }
    void polar(const FkPolar& p) { current().polar.push_back(p); }
    /// Begins a choice, or its next alternative.
    void choice() { choices.emplace_back(); }
    void alternative() { choices.back().emplace_back(); }

    std::vector<FkChoice> choices;

    void line();
    void arc();
    void arc_with(double sense);
    void end_point();
    void centre();
    void entry_direction();
    void beside_line();
    void beside_arc();
    void parallel();

private:
    FkEquations& current() { return choices.back().back(); }
    [[nodiscard]] const FkHandle& self() const { return around_.self; }
    [[nodiscard]] const FkHandle& before() const { return around_.before; }
    [[nodiscard]] FkPoly coordinate(const FkValue& v, bool second) const;
    void polar_pair(const std::optional<FkValue>& radius, const std::optional<FkValue>& angle, const FkPoly& x,
                    const FkPoly& y, FkDatum radius_datum, FkDatum angle_datum);
    void direction_is(FkDatum datum, const FkPoly& nx, const FkPoly& ny, double turned, const FkPoly& fx,
                      const FkPoly& fy);
    [[nodiscard]] FkPoly squared(const FkPoly& x, const FkPoly& y) const { return x * x + y * y; }
    /// Left of the line through the start along the entry tangent; of a line: n·x - p.
    [[nodiscard]] FkPoly beyond(double x, double y) const { return x * self().nb_x + y * self().nb_y - self().offset; }

    const FkElement& e_;
    const FkSurroundings& around_;
};

FkPoly Builder::coordinate(const FkValue& v, bool second) const {
    if (v.base == FkBase::absolute) return v.value - (second ? around_.origin.y : around_.origin.x);
    const bool own = v.base == FkBase::incremental;
    const FkHandle& h = own ? self() : *around_.find(v.block);
    const FkPoly& from = own ? (second ? h.start_y : h.start_x) : (second ? h.end_y : h.end_x);
    return from + FkPoly(v.value);
}

void Builder::polar_pair(const std::optional<FkValue>& radius, const std::optional<FkValue>& angle, const FkPoly& x,
                         const FkPoly& y, FkDatum radius_datum, FkDatum angle_datum) {
    if (!radius && !angle) return;
    FkPolar p;
    p.x = x;
    p.y = y;
    p.pole = *e_.pole - around_.origin;
    p.tag = e_.tag;
    p.radius_datum = radius_datum;
    p.angle_datum = angle_datum;
    const auto take = [&](const FkValue& v, std::optional<double>& value, std::array<FkPoly, 2>& from, bool& relative) {
        value = v.value;
        relative = v.base != FkBase::absolute;
        if (v.base == FkBase::incremental) from = {self().start_x, self().start_y};
        if (v.base == FkBase::block) from = {around_.find(v.block)->end_x, around_.find(v.block)->end_y};
    };
    if (radius) take(*radius, p.radius, p.radius_from, p.radius_is_relative);
    if (angle) take(*angle, p.angle, p.angle_from, p.angle_is_relative);
    polar(p);
}

void Builder::direction_is(FkDatum datum, const FkPoly& nx, const FkPoly& ny, double turned, const FkPoly& fx,
                           const FkPoly& fy) {
    const double c = std::cos(turned), s = std::sin(turned);
    same(datum, FkUnit::direction, nx, ny, c * fx - s * fy, s * fx + c * fy);
}

void Builder::end_point() {
    const FkHandle& h = self();
    if (e_.x) zero(FkDatum::x, FkUnit::length, h.end_x - coordinate(*e_.x, false));
    if (e_.y) zero(FkDatum::y, FkUnit::length, h.end_y - coordinate(*e_.y, true));
    polar_pair(e_.pr, e_.pa, h.end_x, h.end_y, FkDatum::pr, FkDatum::pa);
    if (e_.closed == FkClosed::ends)
        same(FkDatum::clsd, FkUnit::length, h.end_x, h.end_y, around_.closing[0], around_.closing[1]);
}

void Builder::centre() {
    const FkHandle& h = self();
    if (e_.ccx) zero(FkDatum::ccx, FkUnit::length, h.centre_x - coordinate(*e_.ccx, false));
    if (e_.ccy) zero(FkDatum::ccy, FkUnit::length, h.centre_y - coordinate(*e_.ccy, true));
    polar_pair(e_.ccpr, e_.ccpa, h.centre_x, h.centre_y, FkDatum::ccpr, FkDatum::ccpa);
}

void Builder::entry_direction() {
    const FkHandle& h = self();
    const FkHandle& b = before();
    if (e_.tangential) {
        direction_is(FkDatum::tangent, h.nb_x, h.nb_y, 0, b.na_x, b.na_y);
        // What follows from the transition, for neighbours whose common point is not yet known.
        if (h.arc && b.arc)
            zero(FkDatum::tangent, FkUnit::square,
                 squared(h.centre_x - b.centre_x, h.centre_y - b.centre_y) -
                     (h.radius - b.radius) * (h.radius - b.radius));
        else if (h.arc)
            zero(FkDatum::tangent, FkUnit::length, b.na_x * h.centre_x + b.na_y * h.centre_y - b.offset - h.radius);
        else if (b.arc)
            zero(FkDatum::tangent, FkUnit::length, h.nb_x * b.centre_x + h.nb_y * b.centre_y - h.offset - b.radius);
        else
            zero(FkDatum::tangent, FkUnit::length, h.offset - b.offset);
    }
    if (!e_.an) return;
    if (e_.an->base == FkBase::absolute)
        direction_is(FkDatum::an, h.nb_x, h.nb_y, e_.an->value, 0.0, 1.0);
    else {
        const FkHandle& from = e_.an->base == FkBase::incremental ? b : *around_.find(e_.an->block);
        direction_is(FkDatum::an, h.nb_x, h.nb_y, e_.an->value, from.na_x, from.na_y);
    }
}

void Builder::line() {
    const FkHandle& h = self();
    choice();
    alternative();
    zero(FkDatum::element, FkUnit::direction, squared(h.nb_x, h.nb_y) - FkPoly(1.0));
    zero(FkDatum::element, FkUnit::length, h.nb_x * h.start_x + h.nb_y * h.start_y - h.offset);
    zero(FkDatum::element, FkUnit::length, h.nb_x * h.end_x + h.nb_y * h.end_y - h.offset);
    least(FkDatum::element, (h.end_x - h.start_x) * h.nb_y - (h.end_y - h.start_y) * h.nb_x, shortest_line);
    entry_direction();
    end_point();
    if (e_.length)
        same(FkDatum::len, FkUnit::length, h.end_x, h.end_y, h.start_x + *e_.length * h.nb_y,
             h.start_y - *e_.length * h.nb_x);
    for (std::size_t i = 0; i < 2; ++i)
        if (e_.on[i].x)
            zero(i == 0 ? FkDatum::p1 : FkDatum::p2, FkUnit::length,
                 beyond(*e_.on[i].x - around_.origin.x, *e_.on[i].y - around_.origin.y));
    if (e_.distance) beside_line();
    if (e_.parallel) parallel();
}

void Builder::beside_line() {
    choice();
    for (const double side : {1.0, -1.0}) {
        alternative();
        zero(FkDatum::pd, FkUnit::length,
             beyond(*e_.beside.x - around_.origin.x, *e_.beside.y - around_.origin.y) - FkPoly(side * *e_.distance));
        if (*e_.distance == 0) break;
    }
}

void Builder::parallel() {
    const FkHandle& h = self();
    const FkHandle& of = *around_.find(*e_.parallel);
    choice();
    for (const double sense : {1.0, -1.0}) {
        alternative();
        same(FkDatum::par, FkUnit::direction, h.nb_x, h.nb_y, sense * of.nb_x, sense * of.nb_y);
    }
    if (!e_.parallel_distance) return;
    const std::vector<FkEquations> senses = choices.back();
    choices.back().clear();
    const FkPoly offset = of.arc ? of.nb_x * of.start_x + of.nb_y * of.start_y : of.offset;
    for (std::size_t i = 0; i < 2; ++i)
        for (const double side : {1.0, -1.0}) {
            choices.back().push_back(senses[i]);
            zero(FkDatum::dp, FkUnit::length,
                 h.offset - (i == 0 ? 1.0 : -1.0) * offset - FkPoly(side * *e_.parallel_distance));
            if (*e_.parallel_distance == 0) break;
        }
}

void Builder::arc() {
    const FkHandle& h = self();
    choice();
    alternative();
    zero(FkDatum::element, FkUnit::direction, squared(h.nb_x, h.nb_y) - FkPoly(1.0));
    zero(FkDatum::element, FkUnit::direction, squared(h.na_x, h.na_y) - FkPoly(1.0));
    same(FkDatum::element, FkUnit::length, h.centre_x, h.centre_y, h.start_x + h.radius * h.nb_x,
         h.start_y + h.radius * h.nb_y);
    same(FkDatum::element, FkUnit::length, h.centre_x, h.centre_y, h.end_x + h.radius * h.na_x,
         h.end_y + h.radius * h.na_y);
    zero(FkDatum::element, FkUnit::square,
         squared(h.start_x - h.centre_x, h.start_y - h.centre_y) - h.radius * h.radius);
    zero(FkDatum::element, FkUnit::square, squared(h.end_x - h.centre_x, h.end_y - h.centre_y) - h.radius * h.radius);
    entry_direction();
    end_point();
    centre();
    if (e_.length)
        zero(FkDatum::len, FkUnit::square,
             squared(h.end_x - h.start_x, h.end_y - h.start_y) - FkPoly(*e_.length * *e_.length));
    constexpr std::array<FkDatum, 3> names{FkDatum::p1, FkDatum::p2, FkDatum::p3};
    for (std::size_t i = 0; i < 3; ++i)
        if (e_.on[i].x)
            zero(names[i], FkUnit::square,
                 squared(h.centre_x - FkPoly(*e_.on[i].x - around_.origin.x),
                         h.centre_y - FkPoly(*e_.on[i].y - around_.origin.y)) -
                     h.radius * h.radius);
    if (e_.distance) beside_arc();
    choice();
    for (const double sense : {-1.0, 1.0}) {
        if (e_.sense && (*e_.sense == Sense::counter_clockwise) != (sense > 0)) continue;
        alternative();
        arc_with(sense);
    }
}

/// What depends on the sense of rotation.
void Builder::arc_with(double sense) {
    const FkHandle& h = self();
    least(FkDatum::dr, sense * h.radius, shortest_line);
    if (e_.radius) zero(FkDatum::r, FkUnit::length, h.radius - FkPoly(sense * *e_.radius));
    if (!e_.cca) return;
    if (e_.cca->base == FkBase::incremental) {
        direction_is(FkDatum::cca, h.na_x, h.na_y, sense * e_.cca->value, h.nb_x, h.nb_y);
    } else {
        // The end lies at centre + |r| (cos, sin), and end = centre - r nA.
        same(FkDatum::cca, FkUnit::direction, h.na_x, h.na_y, -sense * std::cos(e_.cca->value),
             -sense * std::sin(e_.cca->value));
    }
}

/// |q - c| = |r| ± D. With either sign of r both signs of D come up, so the sense need not be known here, except that
/// the point inside lies between centre and circle.
void Builder::beside_arc() {
    const FkHandle& h = self();
    const double d = *e_.distance;
    choice();
    for (const double side : {1.0, -1.0}) {
        alternative();
        const FkPoly apart = h.radius + FkPoly(side * d);
        zero(FkDatum::pd, FkUnit::square,
             squared(h.centre_x - FkPoly(*e_.beside.x - around_.origin.x),
                     h.centre_y - FkPoly(*e_.beside.y - around_.origin.y)) -
                 apart * apart);
        // |r + side d| = |q - c| stands for |r| - d only if |r| >= d: with r(r + side d) >= 0 in either sense.
        least(FkDatum::pd, h.radius * apart, -1e-9);
        if (d == 0) break;
    }
}

}  // namespace

FkEquations polar_equations(const FkPolar& p, double radius_base, double angle_base) {
    FkEquations out;
    const auto zero = [&](FkDatum d, FkUnit u, const FkPoly& q) { out.equal.push_back({q, p.tag, d, u, 0}); };
    const FkPoly dx = p.x - FkPoly(p.pole.x), dy = p.y - FkPoly(p.pole.y);
    const double c = std::cos(p.angle.value_or(0) + angle_base), s = std::sin(p.angle.value_or(0) + angle_base);
    const double radius = p.radius.value_or(0) + radius_base;
    if (p.radius && p.angle) {
        zero(p.radius_datum, FkUnit::length, dx - FkPoly(radius * c));
        zero(p.radius_datum, FkUnit::length, dy - FkPoly(radius * s));
    } else if (p.angle) {
        zero(p.angle_datum, FkUnit::length, s * dx - c * dy);
        out.least.push_back({c * dx + s * dy, 0, p.tag, p.angle_datum});
    } else {
        zero(p.radius_datum, FkUnit::square, dx * dx + dy * dy - FkPoly(radius * radius));
    }
    return out;
}

FkHandle unknown_handle(const FkElement& e, int first_id, const FkHandle& before) {
    const auto u = [first_id](int offset) { return FkPoly::unknown(first_id + offset); };
    FkHandle h;
    h.tag = e.tag;
    h.arc = e.arc;
    h.start_x = before.end_x;
    h.start_y = before.end_y;
    h.end_x = u(0);
    h.end_y = u(2);
    h.na_x = u(1);
    h.na_y = u(3);
    if (e.arc) {
        h.centre_x = u(4);
        h.centre_y = u(6);
        h.nb_x = u(5);
        h.nb_y = u(7);
        h.radius = u(8);
    } else {
        h.nb_x = h.na_x;
        h.nb_y = h.na_y;
        h.offset = u(4);
    }
    return h;
}

FkHandle constant_handle(const Element& e, Vec2 origin) {
    FkHandle h;
    h.tag = e.tag;
    h.arc = is_arc(e);
    const Vec2 from = e.from - origin, to = e.to - origin;
    const Vec2 nb = geom::left_of(start_direction(e)), na = geom::left_of(end_direction(e));
    h.start_x = from.x;
    h.start_y = from.y;
    h.end_x = to.x;
    h.end_y = to.y;
    h.nb_x = nb.x;
    h.nb_y = nb.y;
    h.na_x = na.x;
    h.na_y = na.y;
    h.offset = geom::dot(na, to);
    if (h.arc) {
        h.centre_x = e.centre.x - origin.x;
        h.centre_y = e.centre.y - origin.y;
        h.radius = std::copysign(geom::distance(e.from, e.centre), e.sweep);
    }
    return h;
}

std::vector<FkChoice> equations_of(const FkElement& e, const FkSurroundings& around) {
    Builder b(e, around);
    if (e.arc)
        b.arc();
    else
        b.line();
    return std::move(b.choices);
}

}  // namespace obrys::path
