/// Polar and cylindrical interpolation of lathes (G12.1, G13.1; G7.1): C is a length there, or a way on the cylinder.
/// Source: FANUC B-62764EN/01 page 51, B-63324EN/03 pages 60 and 66 (G codes that may stand within, units of the axes).

#include <algorithm>

#include "read/rs274/fanuc/state.hpp"

namespace obrys::read::rs274 {

using program::Operator;
using program::Reference;

namespace {

constexpr double pi = 3.14159265358979323846;

bool may_stand_within(const FanucG& g) {
    switch (g.special) {
        case FanucSpecial::dwell:
        case FanucSpecial::macro_call:
        case FanucSpecial::macro_modal:
        case FanucSpecial::macro_end:
        case FanucSpecial::polar_face:
        case FanucSpecial::cylinder_face:
        case FanucSpecial::interpolation_off: return true;
        case FanucSpecial::none: break;
        default: return false;
    }
    switch (g.modal) {
        case Modal::linear:
        case Modal::arc_cw:
        case Modal::arc_ccw:
        case Modal::exact_stop_block:
        case Modal::compensation_off:
        case Modal::compensation_left:
        case Modal::compensation_right:
        case Modal::absolute:
        case Modal::incremental:
        case Modal::feed_per_minute:
        case Modal::feed_per_rev: return g.use == dialect::rs274::FanucUse::modal;
        default: return false;
    }
}

/// Texts of problems: they stand as long as the program is read.
struct Refusals {
    std::string_view code, rapid, axis;
};
const Refusals& refusals(const FanucState& s) {
    static constexpr Refusals polar{
        "this G code cannot stand within polar coordinate interpolation (alarm 146)",
        "rapid traverse is in force and cannot be within polar coordinate interpolation (alarm 146)",
        "this axis cannot move within polar coordinate interpolation"};
    static constexpr Refusals cylinder{
        "this G code cannot stand within cylindrical interpolation (alarm 176)",
        "rapid traverse is in force and cannot be within cylindrical interpolation (alarm 176)",
        "this axis cannot move within cylindrical interpolation"};
    return s.surface == Surface::polar ? polar : cylinder;
}

/// Y of the unrolled cylinder: the way that its circumference makes.
Value unrolled(FanucState& s, const Value& degrees) {
    Value v = degrees;
    const ExprId factor = s.build().number(pi / 180 * s.cylinder.get(), false, v.begin, v.end);
    v.expr = s.build().binary(Operator::multiply, as_expr(s, degrees), factor, v.begin, v.end);
    return v;
}

}  // namespace

bool refused_on_surface(FanucState& s, const FanucG& g, const Address& a) {
    if (may_stand_within(g) || s.surface == Surface::none) return false;
    s.facts.refused = true;
    add_problem(s, Code::unsupported, a.begin, a.end, refusals(s).code);
    return true;
}

FanucG as_seen_on_surface(const FanucState& s, FanucG g) {
    if (g.special != FanucSpecial::none || s.surface != Surface::cylinder || s.surface_plane == 19) return g;
    switch (g.modal) {
        case Modal::arc_cw: g.modal = Modal::arc_ccw; break;
        case Modal::arc_ccw: g.modal = Modal::arc_cw; break;
        case Modal::compensation_left: g.modal = Modal::compensation_right; break;
        case Modal::compensation_right: g.modal = Modal::compensation_left; break;
        default: break;
    }
    return g;
}

void surface_special(FanucState& s, const FanucG& g, const Address& a) {
    if (g.special == FanucSpecial::polar_face) {
        s.surface = Surface::polar;
    } else if (g.special == FanucSpecial::interpolation_off) {
        s.surface = Surface::none;
    } else {
        Address* c = find_address(s, 'C');
        const Value r = c != nullptr ? scaled(s, c->value, Quantity::length) : Value{};
        if (c == nullptr || !c->value.is_literal() || r.expr != no_expr) {
            s.inch.rely();
            use_letters(s, "C");
            s.lost = true;
            s.facts.refused = true;
            return add_problem(s, Code::unsupported, a.begin, a.end,
                               "cylindrical interpolation whose radius is not written as C with a number, in inch or "
                               "mm that this text says");
        }
        c->used = true;
        s.cylinder.set(r.number());
        if (r.number() == 0) {
            s.surface = Surface::none;
            s.lost = false;
            return add_modal(s, g.order, Modal::interpolation_off, 0, a.begin, a.end);
        }
        s.surface = Surface::cylinder;
        s.surface_plane = static_cast<int>(s.plane);
        put_value(s, Order::value, Code::p, r, *c);
    }
    add_modal(s, g.order, g.modal, 0, a.begin, a.end);
}

bool surface_word(FanucState& s, const Address& a) {
    constexpr std::string_view letters = "XYZUVWCHIJK";
    if (a.comma || letters.find(a.letter) == std::string_view::npos || s.surface == Surface::none) return false;
    const bool axis = std::string_view("XYZUVWCH").find(a.letter) != std::string_view::npos;
    if (axis && s.motion == Modal::rapid && !s.facts.refused) {
        s.facts.refused = true;
        add_problem(s, Code::unsupported, a.begin, a.end, refusals(s).rapid);
    }
    if (a.letter == 'C' || a.letter == 'H') {
        Value v = s.surface == Surface::polar ? scaled(s, a.value, Quantity::length)
                                              : unrolled(s, scaled(s, a.value, Quantity::angle));
        if (a.letter == 'H') v.expr = s.build().with_reference(Reference::incremental, as_expr(s, v), a.begin, a.end);
        put_value(s, Order::value, Code::y, v, a);
        return true;
    }
    const bool centre = a.letter == 'I' || a.letter == 'J' || a.letter == 'K';
    if (a.letter == 'Y' || a.letter == 'V' || (centre && s.surface == Surface::cylinder)) {
        s.facts.refused = true;
        add_problem(s, Code::unsupported, a.begin, a.end,
                    centre ? "arcs on the cylinder are given by R" : refusals(s).axis);
        return true;
    }
    return false;
}

}  // namespace obrys::read::rs274
