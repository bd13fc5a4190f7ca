/// Hole cycles of lathes as their ways: in the face along Z (G83 drilling, G84 tapping, G85 boring), in the side along
/// X (G87, G88, G89). Source: FANUC series 16i/18i-T and 0i-T operator's manuals, canned cycle for drilling: to the
/// position and R at rapid, to the bottom at feed, back to the initial level; R counts from the initial level in system
/// A, along X as a radius [-]. On Haas (G81 … G85, G89) R is a coordinate [-].

#include "read/rs274/fanuc/state.hpp"

namespace obrys::read::rs274 {

using program::Operator;

namespace {

constexpr std::string_view hole_level = "_HOLE_LEVEL", hole_stop = "_HOLE_R", hole_bottom = "_HOLE_BOTTOM",
                           hole_dwell = "_HOLE_DWELL";

struct HoleWriter {
    FanucState& s;
    std::uint32_t begin = 0, end = 0;

    [[nodiscard]] ExprId variable(std::string_view name) const {
        program::Expr e;
        e.kind = program::ExprKind::variable;
        e.a = s.build().name(name);
        return s.build().add(e, begin, end);
    }
    [[nodiscard]] bool in_side() const { return s.turning >= 870 && !s.control.haas; }
    /// Coordinate of the axis along which the hole goes.
    [[nodiscard]] ExprId height() const {
        program::Expr e;
        e.kind = program::ExprKind::system;
        e.op = static_cast<std::uint8_t>(program::SystemVariable::coordinate);
        e.a = s.build().name(in_side() ? "#5001" : "#5003");
        s.build().adopt(e, {s.build().number(in_side() ? 1 : 3, true, begin, end)});
        return s.build().add(e, begin, end);
    }
    void assign(std::string_view name, ExprId value) const { s.build().assign(variable(name), value, begin, end); }
    /// `by` from the place that `from` holds.
    void assign_from(std::string_view name, std::string_view from, ExprId by) const {
        assign(name, s.build().binary(Operator::add, variable(from), by, begin, end));
    }
    void open() const { s.build().statement(StatementKind::block, s.line.begin()); }
    void close() const { s.build().end_statement(s.line.end()); }
    void way(Modal m, std::string_view to, std::optional<Value> lead = std::nullopt) const {
        open();
        s.build().expression(in_side() ? Code::x : Code::z, variable(to), begin, end);
        if (lead) s.build().expression(in_side() ? Code::i : Code::k, as_expr(s, *lead), begin, end);
        s.build().modal(m, begin, end);
        close();
    }
    [[nodiscard]] ExprId value(Address& a, Quantity q) const {
        a.used = true;
        return as_expr(s, scaled(s, a.value, q));
    }
};

bool counts_from_level(const FanucState& s) {
    return !s.control.haas && (s.control.system == dialect::rs274::GSystem::a || s.incremental);
}

/// R, a radius where the hole goes along X.
ExprId clearance(const HoleWriter& w, Address& r) {
    const ExprId v = w.value(r, Quantity::length);
    if (!w.in_side() || !counts_from_level(w.s)) return v;
    return w.s.build().binary(Operator::multiply, w.s.build().number(2, false, w.begin, w.end), v, w.begin, w.end);
}

void keep_words(const HoleWriter& w, bool fresh) {
    FanucState& s = w.s;
    if (fresh) w.assign(hole_level, w.height());
    if (Address* r = find_address(s, 'R')) {
        const ExprId v = clearance(w, *r);
        counts_from_level(s) ? w.assign_from(hole_stop, hole_level, v) : w.assign(hole_stop, v);
    } else if (fresh) {
        w.assign(hole_stop, w.variable(hole_level));
    }
    if (Address* to = find_address(s, w.in_side() ? 'X' : 'Z')) {
        const ExprId v = w.value(*to, Quantity::length);
        s.incremental ? w.assign_from(hole_bottom, hole_stop, v) : w.assign(hole_bottom, v);
    } else if (Address* by = find_address(s, w.in_side() ? 'U' : 'W')) {
        w.assign_from(hole_bottom, hole_stop, w.value(*by, Quantity::length));
    } else if (fresh) {
        w.assign(hole_bottom, w.variable(hole_stop));
    }
    Address* p = find_address(s, 'P');
    if (p != nullptr)
        w.assign(hole_dwell, w.value(*p, Quantity::milliseconds));
    else if (fresh)
        w.assign(hole_dwell, s.build().number(0, true, w.begin, w.end));
}

/// K (L on Haas): how often the position and its hole are made; nothing where that is not written.
std::optional<int> repeats(FanucState& s) {
    constexpr int most = 1000;
    int count = 1;
    for (const char letter : {'K', 'L'})
        if (Address* a = find_address(s, letter)) {
            a->used = true;
            count = as_integer(a->value).value_or(-1);
            if (count >= 0 && count <= most) continue;
            add_problem(s, Code::unsupported, a->begin, a->end, "a number of holes that is not written, or over 1000");
            return std::nullopt;
        }
    return count;
}

/// Words that a hole has no use for.
void pass_over(FanucState& s) {
    for (Address& a : s.addresses) {
        if (a.used) continue;
        a.used = true;
        if (a.letter == 'Q')
            s.build().ignored("Q, the pecks of a hole cycle that is run as one cut,", a.begin, a.end);
        else
            add_problem(s, Code::unsupported, a.begin, a.end, "a word of a hole cycle");
    }
}

void dwell_at_bottom(const HoleWriter& w) {
    w.open();
    w.s.build().expression(Code::p, w.variable(hole_dwell), w.begin, w.end);
    w.s.build().modal(Modal::dwell, w.begin, w.end);
    w.close();
}

void make_hole(const HoleWriter& w, int code) {
    FanucState& s = w.s;
    w.way(Modal::rapid, hole_stop);
    const bool taps = code == 840 || (code == 880 && !s.control.haas);
    const bool rapid_back = code == 830 || code == 870 || code == 810 || code == 820;
    const std::optional<Value> lead =
        taps && s.per_rev ? std::optional(feed_in_force(s, w.begin, w.end)) : std::nullopt;
    w.way(lead ? Modal::thread : Modal::linear, hole_bottom, lead);
    dwell_at_bottom(w);
    if (!rapid_back) w.way(lead ? Modal::thread : Modal::linear, hole_stop, lead);
    w.way(Modal::rapid, s.to_clearance ? hole_stop : hole_level);
}

bool is_position(const HoleWriter& w, char letter) {
    return std::string_view(w.in_side() ? "ZWCH" : "XUCH").find(letter) != std::string_view::npos;
}

/// To where the block says, at rapid.
void to_position(const HoleWriter& w, const std::vector<Address>& position) {
    FanucState& s = w.s;
    if (position.empty()) return;
    begin_words(s);
    for (Address a : position) emit_address(s, a);
    add_modal(s, Order::motion, Modal::rapid, 0, w.begin, w.end);
    emit_block(s);
    s.words.clear();
}

std::vector<Address> take_position(const HoleWriter& w) {
    std::vector<Address> position;
    for (Address& a : w.s.addresses) {
        if (a.used || a.comma || !is_position(w, a.letter)) continue;
        a.used = true;
        position.push_back(a);
    }
    return position;
}

}  // namespace

bool lathe_hole(FanucState& s) {
    bool axes = false;
    for (const char letter : {'X', 'U', 'Z', 'W', 'C', 'H'}) axes = axes || find_address(s, letter) != nullptr;
    if (!axes) return false;
    const HoleWriter w{s, s.line.begin(), s.line.end()};
    const bool fresh = s.new_cycle;
    s.new_cycle = false;
    for (Address& a : s.addresses)
        if (!a.used && (a.letter == 'S' || a.letter == 'T' || a.letter == 'F')) emit_address(s, a);
    const std::vector<Address> position = take_position(w);
    const auto count = repeats(s);
    emit_block(s);
    s.words.clear();
    w.open();
    keep_words(w, fresh);
    w.close();
    begin_words(s);
    pass_over(s);
    if (!s.words.empty()) emit_block(s);
    s.words.clear();
    for (int i = 0; i < count.value_or(1); ++i) {
        to_position(w, position);
        make_hole(w, s.turning);
    }
    w.open();  // what held before holds behind the hole
    s.build().modal(s.motion, w.begin, w.end);
    w.close();
    return true;
}

}  // namespace obrys::read::rs274
