/// G and M codes of a block. What those do that are more than one word: fanuc_special.cpp.

#include <algorithm>
#include <cmath>

#include "base/whole.hpp"

#include "read/rs274/fanuc/state.hpp"

namespace obrys::read::rs274 {

namespace {

/// Number * 10 of a G code; nothing where it is computed or has more than one decimal.
std::optional<int> tenths_of(const Value& v) {
    if (!v.is_literal() || v.number() < 0 || v.number() > 999) return std::nullopt;
    const double tenths = v.number() * 10;
    if (std::abs(tenths - std::round(tenths)) > 1e-6) return std::nullopt;
    return base::cut<int>(std::round(tenths), 0, 9990);
}

Value whole_value(int n, const Address& a) {
    Value v;
    v.found = true;
    v.literal = base::scan_decimal(std::to_string(n));
    v.begin = a.begin;
    v.end = a.end;
    return v;
}

bool is_motion(Modal m) {
    return m == Modal::rapid || m == Modal::linear || m == Modal::arc_cw || m == Modal::arc_ccw || m == Modal::thread ||
           m == Modal::turning_cycle;
}

/// What the reader itself must know of what holds from here on.
void follow(FanucState& s, const FanucG& g) {
    switch (g.modal) {
        case Modal::inch_all: s.inch.say(true); return;
        case Modal::metric_all: s.inch.say(false); return;
        case Modal::feed_per_rev: s.per_rev = true; return;
        case Modal::feed_per_minute:
        case Modal::feed_inverse_time: s.per_rev = false; return;
        case Modal::absolute: s.incremental = false; return;
        case Modal::incremental: s.incremental = true; return;
        case Modal::plane_xy: s.plane = 17; return;
        case Modal::plane_zx: s.plane = 18; return;
        case Modal::plane_yz: s.plane = 19; return;
        case Modal::canned_off:
            if (s.hole != 0 || s.turning != 0) s.motion = Modal::rapid;
            s.hole = 0;
            s.rigid = false;
            s.lost_motion = false;
            if (s.turning < 900) s.turning = 0;  // hole cycles of lathes
            return;
        case Modal::retract_initial:
        case Modal::retract_clearance: s.to_clearance = g.modal == Modal::retract_clearance; return;
        case Modal::canned:
            s.hole = g.number;
            s.lost_motion = false;
            return;
        default: break;
    }
    if (!is_motion(g.modal) || g.special == FanucSpecial::repetitive) return;
    const bool moves = g.special == FanucSpecial::none || g.special == FanucSpecial::thread ||
                       g.special == FanucSpecial::turning_cycle;
    if (!moves) return;
    if (s.hole != 0) s.rigid = false;
    s.hole = 0;
    s.turning = 0;
    s.cleared_cycle = false;
    s.lost_motion = false;
    s.own_motion = true;
    if (g.modal != Modal::turning_cycle) s.motion = g.modal;
}

void accept(FanucState& s, const Address& a) {
    const std::string shown = a.letter + base::shortest(a.value.number());
    s.build().ignored(shown, a.begin, a.end);
}

/// Polar (G12.1, G112) and cylindrical (G7.1, G107) interpolation: within them coordinates are those of another plane.
bool is_interpolation(int code) { return code == 121 || code == 1120 || code == 71 || code == 1070; }

/// G107 with any of its words maps onto a cylinder, alone it ends the mapping (Haas, Mill Operator's Manual 96-8000,
/// June 1999, pages 203 and 204): A0 there is where the rotary axis goes first, not a radius.
bool mapping_ends(FanucState& s) {
    for (const char letter : std::string_view("XYZABCQR"))
        if (find_address(s, letter) != nullptr) return false;
    return true;
}

/// G13.1, G113; G7.1 C0: the axis of the cylinder with the radius 0.
bool interpolation_ends(FanucState& s, int code) {
    bool ends = code == 131 || code == 1130;
    if (s.control.haas && code == 1070)
        ends = mapping_ends(s);
    else if (code == 71 || code == 1070)
        for (const char axis : {'A', 'B', 'C'})
            if (Address* a = find_address(s, axis); a != nullptr && a->value.is_literal() && a->value.number() == 0)
                a->used = ends = true;
    if (ends) s.lost = false;
    return ends;
}

}  // namespace

void use_letters(FanucState& s, std::string_view letters) {
    for (Address& a : s.addresses)
        if (!a.comma && letters.find(a.letter) != std::string_view::npos) a.used = true;
}

void refuse_axes(FanucState& s, std::string_view why) {
    for (Address& a : s.addresses) {
        if (a.used || a.comma || std::string_view("XYZABCUVW").find(a.letter) == std::string_view::npos) continue;
        a.used = true;
        s.facts.refused = true;
        add_problem(s, Code::unsupported, a.begin, a.end, why);
    }
}

std::optional<int> g_tenths(const Address& a) {
    return a.letter == 'G' && !a.comma ? tenths_of(a.value) : std::nullopt;
}

void read_g_code(FanucState& s, Address& a) {
    a.used = true;
    if (!a.value.is_literal()) {
        s.facts.refused = true;
        return add_problem(s, Code::unsupported, a.begin, a.end, "a G code that is computed");
    }
    const auto code = tenths_of(a.value);
    const FanucG* g = code ? dialect::rs274::find_fanuc_g(*code, s.control) : nullptr;
    if (g == nullptr) {
        s.facts.refused = true;
        return add_problem(s, Code::unknown, a.begin, a.end, {});
    }
    if (g->use != FanucUse::special && interpolation_ends(s, *code)) return accept(s, a);
    if (g->use == FanucUse::accepted) {
        if (!g->letters.empty()) s.own_words.push_back({g->letters, a.begin, a.end});
        return accept(s, a);
    }
    if (g->use == FanucUse::refused) {
        if (is_interpolation(*code)) s.lost = true;
        // Codes that change how a way is made, not where it ends, keep their block's coordinates.
        s.facts.refused = s.facts.refused || g->order == Order::motion;
        if (g->modal == Modal::canned) s.lost_motion = true;
        return add_problem(s, Code::unsupported, a.begin, a.end, g->says);
    }
    if (refused_on_surface(s, *g, a)) return;
    if (g->modal == Modal::exact_stop_block) accept(s, a);  // the stream has no stop of one block
    const FanucG seen = as_seen_on_surface(s, *g);
    follow(s, seen);
    if (g->use == FanucUse::modal)
        add_modal(s, g->order, seen.modal, g->number, a.begin, a.end);
    else
        s.special.push_back({g, a});
}

void read_m_code(FanucState& s, Address& a) {
    a.used = true;
    const auto n = as_integer(a.value);
    if (!n) return put_value(s, Order::m_user, Code::m, a.value, a);
    constexpr int most = 9999;  // M98 2001 without P reads M982001
    if (*n > most) {
        s.facts.refused = true;
        return add_problem(s, Code::unknown, a.begin, a.end, "functions have four digits at most");
    }
    const dialect::rs274::FanucM m = dialect::rs274::find_fanuc_m(*n, s.control);
    switch (m.use) {
        case FanucMUse::accepted:
            if (*n == 29) s.rigid = true;
            if (*n == 29 && !s.control.haas) return;  // the cycle tells it
            accept(s, a);
            return put_value(s, Order::m_user, Code::m, a.value, a);
        case FanucMUse::refused: return add_problem(s, Code::unsupported, a.begin, a.end, m.says);
        default: break;
    }
    if (*n == 19) s.own_words.push_back({"SPR", a.begin, a.end, true});  // the angle, and how fast it is taken
    const Order order = *n == 6               ? Order::m_tool
                        : *n >= 3 && *n <= 5  ? Order::m_spindle
                        : *n >= 7 && *n <= 9  ? Order::m_coolant
                        : *n <= 2 || *n == 30 ? Order::m_stop
                                              : Order::m_user;
    put_value(s, order, Code::m, *n == 16 && s.control.haas ? whole_value(6, a) : a.value, a);
}

}  // namespace obrys::read::rs274
