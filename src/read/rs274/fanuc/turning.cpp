/// Single turning cycles (G90, G92, G94 of system A) become their four ways; the position at which a cycle begins is
/// kept in global variables. Source: FANUC series 16i/18i-T operator's manual, canned cycles.

#include <algorithm>

#include "program/modal_group.hpp"
#include "read/rs274/fanuc/state.hpp"

namespace obrys::read::rs274 {

using program::Operator;

namespace {

constexpr std::string_view start_x = "_CYCLE_START_X", start_z = "_CYCLE_START_Z", end_x = "_CYCLE_END_X",
                           end_z = "_CYCLE_END_Z", taper = "_CYCLE_TAPER";

/// Expressions about the line at hand.
struct LineWriter {
    FanucState& s;
    std::uint32_t begin = 0, end = 0;

    [[nodiscard]] ExprId variable(std::string_view name) const {
        program::Expr e;
        e.kind = program::ExprKind::variable;
        e.a = s.build().name(name);
        return s.build().add(e, begin, end);
    }
    [[nodiscard]] ExprId number(double x) const { return s.build().number(x, false, begin, end); }
    [[nodiscard]] ExprId coordinate(int axis) const {
        program::Expr e;
        e.kind = program::ExprKind::system;
        e.op = static_cast<std::uint8_t>(program::SystemVariable::coordinate);
        e.a = s.build().name("#500" + std::to_string(axis));
        s.build().adopt(e, {number(axis)});
        return s.build().add(e, begin, end);
    }
    [[nodiscard]] ExprId sum(ExprId a, ExprId b) const { return s.build().binary(Operator::add, a, b, begin, end); }
    void assign(std::string_view name, ExprId value) const {
        const ExprId target = variable(name);
        s.build().assign(target, value, begin, end);
    }
    void open() const { s.build().statement(StatementKind::block, s.line.begin()); }
    void close() const { s.build().end_statement(s.line.end()); }
    void word(Code code, ExprId value) const { s.build().expression(code, value, begin, end); }
    void modal(Modal m) const { s.build().modal(m, begin, end); }
};

void keep_start(const LineWriter& w) {
    w.assign(start_x, w.coordinate(1));
    w.assign(start_z, w.coordinate(3));
}

/// The end point: X or U and Z or W as written; what a repeated block leaves out stays.
void keep_end(const LineWriter& w, char absolute, char incremental, std::string_view start, std::string_view name) {
    for (const char letter : {absolute, incremental})
        if (Address* a = find_address(w.s, letter)) {
            a->used = true;
            const ExprId v = as_expr(w.s, scaled(w.s, a->value, Quantity::length));
            w.assign(name, letter == absolute ? v : w.sum(w.variable(start), v));
        }
}

/// FANUC writes R; Haas I along X and K along Z (lathe operator's manual, G90, G92, G94).
void keep_taper(const LineWriter& w, bool fresh) {
    const char letter = !w.s.control.haas ? 'R' : w.s.turning == 940 ? 'K' : 'I';
    if (Address* a = find_address(w.s, letter)) {
        a->used = true;
        w.assign(taper, as_expr(w.s, scaled(w.s, a->value, Quantity::length)));
    } else if (fresh) {
        w.assign(taper, w.number(0));
    }
}

/// Of a cycle with a thread.
struct ThreadWords {
    std::optional<Value> lead, start;
};

void way(const LineWriter& w, Modal m, ExprId x, ExprId z, const ThreadWords& thread = {}) {
    w.open();
    if (x != no_expr) w.word(Code::x, x);
    if (z != no_expr) w.word(Code::z, z);
    if (thread.lead) w.word(Code::k, as_expr(w.s, *thread.lead));
    if (thread.start) w.word(Code::q, as_expr(w.s, *thread.start));
    w.modal(m);
    w.close();
}

/// The cycle's four ways. G90: in along X, cut along Z, out, back. G92: the same with a thread. G94: in along Z, cut
/// along X, out, back. A taper makes the cut begin elsewhere: in radius along X, in length along Z.
void ways(const LineWriter& w, int code, const ThreadWords& thread) {
    const ExprId x = w.variable(end_x), z = w.variable(end_z);
    program::Builder& b = w.s.build();
    if (code == 940) {
        way(w, Modal::rapid, no_expr, w.sum(w.variable(end_z), w.variable(taper)));
        way(w, Modal::linear, x, z);
        way(w, Modal::linear, no_expr, w.variable(start_z));
        return way(w, Modal::rapid, w.variable(start_x), no_expr);
    }
    const ExprId twice = b.binary(Operator::multiply, w.number(2), w.variable(taper), w.begin, w.end);
    way(w, Modal::rapid, w.sum(w.variable(end_x), twice), no_expr);
    way(w, code == 920 ? Modal::thread : Modal::linear, x, z, code == 920 ? thread : ThreadWords{});
    way(w, code == 920 ? Modal::rapid : Modal::linear, w.variable(start_x), no_expr);
    way(w, Modal::rapid, no_expr, w.variable(start_z));
}

/// What no handler took is said.
void other_words(FanucState& s) {
    begin_words(s);
    for (Address& a : s.addresses) {
        if (a.used) continue;
        a.used = true;
        add_problem(s, Code::unsupported, a.begin, a.end, "a word of this cycle");
    }
    if (!s.words.empty()) emit_block(s);
    s.words.clear();
}

void single_cycle(FanucState& s, bool fresh) {
    const LineWriter w{s, s.line.begin(), s.line.end()};
    ThreadWords thread;
    if (Address* f = find_address(s, 'F')) {
        const Value v = scaled(s, f->value, Quantity::feed);
        thread.lead = v;
        f->used = true;
        put_value(s, Order::technology, Code::feed, v, *f);
    }
    if (s.turning == 920 && !thread.lead) thread.lead = feed_in_force(s, w.begin, w.end);
    if (Address* q = s.turning == 920 ? find_address(s, 'Q') : nullptr) thread.start = start_angle(s, *q);
    if (s.failed) return;
    // The words that are no part of the cycle act first.
    for (Address& a : s.addresses)
        if (!a.used && (a.letter == 'S' || a.letter == 'T')) emit_address(s, a);
    emit_block(s);
    s.words.clear();
    w.open();
    keep_start(w);
    keep_end(w, 'X', 'U', start_x, end_x);
    keep_end(w, 'Z', 'W', start_z, end_z);
    keep_taper(w, fresh);
    w.close();
    other_words(s);
    ways(w, s.turning, thread);
}

}  // namespace

void turning_special(FanucState& s, const FanucG& g, const Address& a) {
    if (g.special == FanucSpecial::repetitive) return repetitive_cycle(s, g, a);
    if (g.special != FanucSpecial::turning_cycle) return;
    s.turning = g.number;
    s.cleared_cycle = false;
    s.new_cycle = true;
    s.own_motion = false;  // a block with coordinates runs it, this one or a later one
}

namespace {

/// A G code that acts once and takes the block's coordinates for itself: the cycle is not run beside it.
bool acts_once(const FanucState& s) {
    return std::any_of(s.words.begin(), s.words.end(), [](const BlockWord& w) {
        if (w.code != Code::modal) return false;
        const program::ModalGroup group = program::group_of(w.modal);
        return group == program::ModalGroup::once || group == program::ModalGroup::suppression;
    });
}

const Address* first_axis(FanucState& s) {
    for (const char letter : {'X', 'U', 'Z', 'W'})
        if (const Address* a = find_address(s, letter)) return a;
    return nullptr;
}

/// The cycle is still in force, but of its data only those of this block are known.
void refuse_cleared(FanucState& s) {
    const Address* a = first_axis(s);
    if (a == nullptr || acts_once(s)) return;
    s.facts.refused = true;
    add_problem(
        s, Code::unsupported, a->begin, a->end,
        "G90, G92 or G94 is still in force, but the block before has cleared its data: write the motion, or the "
        "cycle anew");
}

}  // namespace

bool turning_block(FanucState& s) {
    if (s.own_motion) return false;
    if (s.cleared_cycle) refuse_cleared(s);
    if (s.turning == 0) return false;
    if (acts_once(s)) {
        // "G90, G92 and G94 are cleared when a one-shot G code other than G04 is specified" (operator's manual).
        const bool dwells = std::any_of(s.words.begin(), s.words.end(), [](const BlockWord& w) {
            return w.code == Code::modal && w.modal == Modal::dwell;
        });
        if (s.turning < 900 || dwells) return false;
        s.turning = 0;
        s.cleared_cycle = true;
        return false;
    }
    if (s.turning < 900) return lathe_hole(s);
    if (first_axis(s) == nullptr) return false;
    single_cycle(s, s.new_cycle);
    s.new_cycle = false;
    return true;
}

}  // namespace obrys::read::rs274
