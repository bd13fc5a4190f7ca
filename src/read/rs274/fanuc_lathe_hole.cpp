/// Hole cycles of lathes in the face (G83 drilling, G84 tapping, G85 boring) as their ways, at the turning centre.
/// Source: FANUC series 16i/18i-T and 0i-T operator's manuals, canned cycle for drilling: to the position and R at
/// rapid, to Z at feed, back to the initial level; R counts from the initial level in system A [-]. On Haas R is a
/// coordinate [-].

#include "read/rs274/fanuc_state.hpp"

namespace obrys::read::rs274 {

using program::Operator;

namespace {

constexpr std::string_view level = "_HOLE_LEVEL", stop = "_HOLE_R", bottom = "_HOLE_BOTTOM", dwell = "_HOLE_DWELL";

struct Writer {
    FanucState& s;
    std::uint32_t begin = 0, end = 0;

    [[nodiscard]] ExprId variable(std::string_view name) const {
        program::Expr e;
        e.kind = program::ExprKind::variable;
        e.a = s.build().name(name);
        return s.build().add(e, begin, end);
    }
    [[nodiscard]] ExprId height() const {
        program::Expr e;
        e.kind = program::ExprKind::system;
        e.op = static_cast<std::uint8_t>(program::SystemVariable::coordinate);
        e.a = s.build().name("#5003");
        s.build().adopt(e, {s.build().number(3, true, begin, end)});
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
        s.build().expression(Code::z, variable(to), begin, end);
        if (lead) s.build().expression(Code::k, as_expr(s, *lead), begin, end);
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

void keep_words(const Writer& w, bool fresh) {
    FanucState& s = w.s;
    if (fresh) w.assign(level, w.height());
    if (Address* r = find_address(s, 'R')) {
        const ExprId v = w.value(*r, Quantity::length);
        counts_from_level(s) ? w.assign_from(stop, level, v) : w.assign(stop, v);
    } else if (fresh) {
        w.assign(stop, w.variable(level));
    }
    if (Address* z = find_address(s, 'Z')) {
        const ExprId v = w.value(*z, Quantity::length);
        s.incremental ? w.assign_from(bottom, stop, v) : w.assign(bottom, v);
    } else if (Address* by = find_address(s, 'W')) {
        w.assign_from(bottom, stop, w.value(*by, Quantity::length));
    } else if (fresh) {
        w.assign(bottom, w.variable(stop));
    }
    Address* p = find_address(s, 'P');
    if (p != nullptr)
        w.assign(dwell, w.value(*p, Quantity::milliseconds));
    else if (fresh)
        w.assign(dwell, s.build().number(0, true, w.begin, w.end));
}

/// Infeed, repeats: what a hole at the centre does not need.
void pass_over(FanucState& s) {
    for (const char letter : {'Q', 'K', 'L'})
        if (Address* a = find_address(s, letter)) {
            a->used = true;
            s.build().ignored(letter == 'Q' ? "Q, the pecks of a hole cycle that is run as one cut,"
                                            : std::string(1, letter) + ", repeats of a hole at the same place,",
                              a->begin, a->end);
        }
}

void dwell_at_bottom(const Writer& w) {
    w.open();
    w.s.build().expression(Code::p, w.variable(dwell), w.begin, w.end);
    w.s.build().modal(Modal::dwell, w.begin, w.end);
    w.close();
}

void make_hole(const Writer& w, int code) {
    FanucState& s = w.s;
    w.way(Modal::rapid, stop);
    const std::optional<Value> lead = code == 840 && s.per_rev ? s.lead : std::nullopt;
    w.way(lead ? Modal::thread : Modal::linear, bottom, lead);
    dwell_at_bottom(w);
    if (code != 830) w.way(lead ? Modal::thread : Modal::linear, stop, lead);
    w.way(Modal::rapid, level);
}

/// X and C go where the block says, at rapid.
void to_position(FanucState& s, const Writer& w) {
    for (Address& a : s.addresses) {
        if (a.used || (a.letter != 'X' && a.letter != 'U' && a.letter != 'C' && a.letter != 'H')) continue;
        if (a.letter == 'X' || a.letter == 'U')
            s.at_centre = a.letter == 'X' && a.value.is_literal() && a.value.number() == 0;
        emit_address(s, a);
    }
    if (!s.words.empty()) add_modal(s, Order::motion, Modal::rapid, 0, w.begin, w.end);
}

}  // namespace

bool lathe_hole(FanucState& s) {
    bool axes = false;
    for (const char letter : {'X', 'U', 'Z', 'W', 'C', 'H'}) axes = axes || find_address(s, letter) != nullptr;
    if (!axes) return false;
    const Writer w{s, s.line.begin(), s.line.end()};
    const bool fresh = s.new_cycle;
    s.new_cycle = false;
    for (Address& a : s.addresses)
        if (!a.used && (a.letter == 'S' || a.letter == 'T' || a.letter == 'F')) emit_address(s, a);
    to_position(s, w);
    emit_block(s);
    s.words.clear();
    w.open();
    keep_words(w, fresh);
    w.close();
    pass_over(s);
    if (s.at_centre) {
        make_hole(w, s.turning);
    } else {
        w.open();
        s.build().problem(Code::unsupported, w.begin, w.end,
                          "a hole beside the turning centre, or at a place that is not written");
        w.close();
    }
    w.open();  // what held before holds behind the hole
    s.build().modal(s.motion, w.begin, w.end);
    w.close();
    return true;
}

}  // namespace obrys::read::rs274
