/// Tilted working planes: FANUC G68.2 and G53.1, Haas G268, G253 and G254. Sources: FANUC series 30i descriptions
/// B-63942EN/02, 5.44 (origin X Y Z, Euler's angles I J K, G53.1, G69); Haas G268 as posts of CAM systems write it:
/// docs/dialects/fanuc.md.

#include <algorithm>
#include <string>

#include "read/rs274/fanuc/state.hpp"

namespace obrys::read::rs274 {

using program::Datum;
using program::SpecialKind;

namespace {

constexpr double stays = 0, turns = 2, waits = 3;  // Datum::positioning

struct Letter {
    char letter;
    Datum datum;
    Quantity quantity;
};
constexpr std::array plane_letters{
    Letter{'X', Datum::origin_x, Quantity::length}, Letter{'Y', Datum::origin_y, Quantity::length},
    Letter{'Z', Datum::origin_z, Quantity::length}, Letter{'I', Datum::angle_a, Quantity::angle},
    Letter{'J', Datum::angle_b, Quantity::angle},   Letter{'K', Datum::angle_c, Quantity::angle},
};

/// A plane being read, where its G code stands.
struct Tilter {
    FanucState& s;
    program::Special plane;
    std::uint32_t begin = 0, end = 0;

    Tilter(FanucState& state, SpecialKind kind, const Address& a) : s(state), begin(a.begin), end(a.end) {
        plane.kind = kind;
        plane.where = s.build().span(a.begin, a.end);
    }
    void add(Datum datum, ExprId value, std::uint32_t from, std::uint32_t to) {
        plane.data.push_back({datum, value, false, 0, s.build().span(from, to)});
    }
    void add(Datum datum, double value) { add(datum, s.build().number(value, false, begin, end), begin, end); }
    /// It is not run, and what holds instead is not known.
    void refuse(std::string_view why) {
        plane.kind = SpecialKind::plane_not_said;
        plane.data.clear();
        add_problem(s, Code::unsupported, begin, end, why);
    }
    void close() {
        s.unit().specials.push_back(std::move(plane));
        add_control(s, StatementKind::special, s.unit().specials.size() - 1);
    }
};

/// Takes origin and angles; false where one of them is missing.
bool take_letters(Tilter& t) {
    bool all = true;
    for (const Letter& l : plane_letters) {
        Address* a = find_address(t.s, l.letter);
        all = all && a != nullptr;
        if (a == nullptr) continue;
        a->used = true;
        t.add(l.datum, as_expr(t.s, scaled(t.s, a->value, l.quantity)), a->begin, a->end);
    }
    return all;
}

std::optional<int> take_number(FanucState& s, char letter) {
    Address* a = find_address(s, letter);
    if (a == nullptr) return std::nullopt;
    a->used = true;
    return as_integer(a->value).value_or(-1);
}

constexpr std::string_view all_letters =
    "a tilted plane without one of X, Y, Z, I, J and K: which one it is then, is not known";

/// G68.2: P says how the angles count; without it they are Euler's.
void tilt(FanucState& s, const Address& a) {
    Tilter t(s, SpecialKind::plane_euler, a);
    t.add(Datum::positioning, waits);
    const auto form = take_number(s, 'P'), order = take_number(s, 'Q');
    const bool all = take_letters(t), about_normal = take_number(s, 'R').has_value();
    constexpr int x_y_z = 123;
    if (form == 1) t.plane.kind = SpecialKind::plane_roll_pitch_yaw;
    if (form == 2)
        t.refuse("a tilted plane by three points (P2)");
    else if (form == 3)
        t.refuse("a tilted plane by two vectors (P3)");
    else if (form == 4)
        t.refuse("a tilted plane by projection angles (P4)");
    else if (form && form != 1)
        t.refuse("a tilted plane of a form (P) that is not known");
    else if (about_normal || (order && (form != 1 || *order != x_y_z)))
        t.refuse("what Q or R says of a tilted plane");
    else if (!all)
        t.refuse(all_letters);
    t.close();
}

/// Each of the three axes once.
bool is_order(int q) {
    std::string digits = std::to_string(q);
    std::sort(digits.begin(), digits.end());
    return digits == "123";
}

/// Haas G268: I, J, K about the fixed axes X, Y, Z, in the order that Q says.
void tilt_spatial(FanucState& s, const Address& a) {
    Tilter t(s, SpecialKind::plane_spatial, a);
    t.add(Datum::positioning, waits);
    const auto order = take_number(s, 'Q');
    const bool all = take_letters(t);
    if (!all || !order)
        t.refuse("a tilted plane without one of X, Y, Z, I, J, K and Q: which one it is then, is not known");
    else if (!is_order(*order))
        t.refuse("a tilted plane with this order of its turns (Q)");
    else
        t.add(Datum::order, *order);
    t.close();
}

void plain(FanucState& s, SpecialKind kind, double positioning, const Address& a) {
    Tilter t(s, kind, a);
    t.add(Datum::positioning, positioning);
    t.close();
}

/// G53.1: which of the two positions of the rotary axes P takes, no manual at hand says.
void take_up(FanucState& s, const Address& a) {
    Tilter t(s, SpecialKind::plane_taken_up, a);
    t.add(Datum::positioning, turns);
    if (const auto which = take_number(s, 'P'); which && *which != 0) {
        s.facts.refused = true;
        add_problem(s, Code::unsupported, a.begin, a.end, "which position of the rotary axes is taken (P)");
    }
    t.close();
    refuse_axes(s, "the rotary axes turn to the tilted plane: no other word belongs into this block");
}

}  // namespace

bool tilt_special(FanucState& s, const FanucG& g, const Address& a) {
    const bool in_force = (s.transformed & tilted) != 0;
    switch (g.special) {
        case FanucSpecial::tilt:
        case FanucSpecial::tilt_spatial:
        case FanucSpecial::tilt_by_axes:
            if (in_force)
                add_problem(s, Code::unsupported, a.begin, a.end,
                            "a tilted plane while another one is in force: end that one before");
            s.transformed = s.transformed | tilted;
            if (g.special == FanucSpecial::tilt) tilt(s, a);
            if (g.special == FanucSpecial::tilt_spatial) tilt_spatial(s, a);
            if (g.special == FanucSpecial::tilt_by_axes) plain(s, SpecialKind::plane_of_axes, stays, a);
            return true;
        case FanucSpecial::take_up_tilt: take_up(s, a); return true;
        case FanucSpecial::tilt_off:
            if (!in_force) s.build().ignored("G" + std::to_string(g.number / 10), a.begin, a.end);
            end_tilt(s, a);
            return true;
        default: return false;
    }
}

void end_tilt(FanucState& s, const Address& a) {
    if ((s.transformed & tilted) == 0) return;
    s.transformed = s.transformed & ~tilted;
    plain(s, SpecialKind::plane_reset, waits, a);
}

void refuse_in_tilt(FanucState& s) {
    if (s.control.is_lathe()) return;
    // The state is asked where it matters alone: who asks is read anew where a run comes in another one.
    for (const Address& a : s.addresses) {
        const auto g = a.letter == 'G' ? g_tenths(a) : std::nullopt;
        const bool zero = g && (*g == 520 || (*g >= 540 && *g <= 599) || *g == 920);
        const bool home = g && *g >= 270 && *g <= 300;
        const bool frame = g && (*g == 680 || *g == 510 || *g == 511);
        const bool axis = !a.used && !a.comma && a.letter >= 'A' && a.letter <= 'C';
        if ((zero || home || frame) && (s.transformed & tilted) != 0)
            add_problem(s, Code::unsupported, a.begin, a.end,
                        "a tilted plane is in force: what this does within it is not known");
        if (axis && (s.transformed & tilted) != 0)
            add_problem(s, Code::unsupported, a.begin, a.end,
                        "a rotary axis within a tilted plane: whether the plane turns with it is not known");
    }
}

}  // namespace obrys::read::rs274
