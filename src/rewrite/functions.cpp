/// Functions, and what stands for those that the language lacks.

#include <cmath>

#include "rewrite/writing.hpp"

namespace obrys::rewrite {

namespace {

struct Spelling {
    Function function;
    std::string_view key;
};
constexpr std::array spellings{
    Spelling{Function::sin, "sin"},
    Spelling{Function::cos, "cos"},
    Spelling{Function::tan, "tan"},
    Spelling{Function::asin, "asin"},
    Spelling{Function::acos, "acos"},
    Spelling{Function::atan, "atan"},
    Spelling{Function::atan2, "atan2"},
    Spelling{Function::angle_of, "angle-of"},
    Spelling{Function::sqrt, "sqrt"},
    Spelling{Function::abs, "abs"},
    Spelling{Function::square, "square"},
    Spelling{Function::trunc, "trunc"},
    Spelling{Function::round, "round"},
    Spelling{Function::round_away, "round-away"},
    Spelling{Function::round_up, "round-up"},
    Spelling{Function::round_outwards, "round-outwards"},
    Spelling{Function::round_down, "round-down"},
    Spelling{Function::ln, "ln"},
    Spelling{Function::log10, "log10"},
    Spelling{Function::exp, "exp"},
    Spelling{Function::min, "min"},
    Spelling{Function::max, "max"},
    Spelling{Function::bound, "bound"},
    Spelling{Function::fraction, "fraction"},
};

/// Functions made of others; each hands back where its value stands.
class Lowering {
public:
    Lowering(Writing& w, ExprId where) : w_(w), where_(where) {}

    Text call(std::string_view key, const Text& a, const Text& b = {}) {
        const std::string* spelling = w_.language.find("functions." + std::string(key));
        if (spelling == nullptr) {
            w_.refuse(w_.span(where_), "the control has no function for " + w_.source(w_.span(where_)));
            return w_.number_text(0);
        }
        return {filled(*spelling, {{"a", a.text}, {"b", b.text}}), Level::atom, std::nullopt};
    }
    [[nodiscard]] bool has(std::string_view key) const { return w_.language.has("functions." + std::string(key)); }

    Text plus(const Text& a, const Text& b) { return w_.joined("operators.add", a, b, Level::sum); }
    Text minus(const Text& a, const Text& b) { return w_.joined("operators.subtract", a, b, Level::sum); }
    Text times(const Text& a, const Text& b) { return w_.joined("operators.multiply", a, b, Level::product); }
    Text through(const Text& a, const Text& b) { return w_.joined("operators.divide", a, b, Level::product); }
    Text n(double v) const { return w_.number_text(v); }
    Text hold(const Text& v) { return w_.atom(v, where_); }
    /// In a place of its own that may be changed.
    Text copy(const Text& v) {
        const Text to = w_.place_for(where_);
        w_.assign(to, v);
        return to;
    }

    Text extreme(const Text& a, const Text& b, bool least) {
        const Text other = hold(b), to = copy(a);
        w_.when(other, least ? Operator::less : Operator::greater, to, [&] { w_.assign(to, other); });
        return to;
    }
    Text bound(const Text& low, const Text& high, const Text& v) { return extreme(extreme(v, low, false), high, true); }

    Text trunc(const Text& v) {
        if (has("trunc")) return call("trunc", v);
        const Text x = hold(v), to = copy(call("round-down", call("abs", x)));
        w_.when(x, Operator::less, n(0), [&] { w_.assign(to, minus(n(0), to)); });
        return to;
    }
    Text down(const Text& v) {
        if (has("round-down")) return call("round-down", v);
        const Text x = hold(v), to = copy(trunc(x));
        w_.when(to, Operator::greater, x, [&] { w_.assign(to, minus(to, n(1))); });
        return to;
    }
    Text up(const Text& v) {
        if (has("round-up")) return call("round-up", v);
        const Text x = hold(v), to = copy(trunc(x));
        w_.when(to, Operator::less, x, [&] { w_.assign(to, plus(to, n(1))); });
        return to;
    }
    Text outwards(const Text& v) {
        if (has("round-outwards")) return call("round-outwards", v);
        const Text x = hold(v), size = hold(call("abs", x)), to = copy(trunc(size));
        w_.when(to, Operator::less, size, [&] { w_.assign(to, plus(to, n(1))); });
        w_.when(x, Operator::less, n(0), [&] { w_.assign(to, minus(n(0), to)); });
        return to;
    }
    Text round(const Text& v) { return has("round") ? call("round", v) : down(plus(v, n(0.5))); }
    Text round_away(const Text& v) {
        if (has("round-away")) return call("round-away", v);
        const Text x = hold(v), to = copy(trunc(plus(call("abs", x), n(0.5))));
        w_.when(x, Operator::less, n(0), [&] { w_.assign(to, minus(n(0), to)); });
        return to;
    }
    Text square(const Text& v) {
        if (has("square")) return call("square", v);
        const Text x = hold(v);
        return times(x, x);
    }
    Text sign(const Text& v) {
        const Text x = hold(v), to = copy(n(1));
        w_.when(x, Operator::less, n(0), [&] { w_.assign(to, n(-1)); });
        return to;
    }
    /// -180 … 180, or -90 … 90, of an angle that may be a turn more.
    Text less_a_turn(const Text& v) {
        const Text to = copy(v);
        w_.when(to, Operator::greater, n(180), [&] { w_.assign(to, minus(to, n(360))); });
        return to;
    }
    Text more_a_turn(const Text& v) {
        const Text to = copy(v);
        w_.when(to, Operator::less, n(0), [&] { w_.assign(to, plus(to, n(360))); });
        return to;
    }
    Text any_angle(const Text& y, const Text& x) {
        if (has("atan2")) return call("atan2", y, x);
        if (has("atan2-turn")) return call("atan2-turn", y, x);
        const Text a = hold(y), b = hold(x), to = w_.place_for(where_);  // a statement of its own: FN 13
        static_cast<void>(w_.say("functions.angle-of", {{"to", to.text}, {"a", signed_atom(a)}, {"b", signed_atom(b)}},
                                 "the angle of two sides"));
        return to;
    }
    Text angle(const Text& y, const Text& x) {
        if (w_.input.angles_from_zero) return more_a_turn(any_angle(y, x));
        return has("atan2") ? call("atan2", y, x) : less_a_turn(any_angle(y, x));
    }
    Text power(const Expr& e) {
        const Text base = w_.value(e.a), exponent = w_.value(e.b);
        const double times_by = exponent.number.value_or(0);
        if (!(times_by >= 1 && times_by <= 8) || times_by != std::trunc(times_by)) {
            w_.refuse(w_.span(where_),
                      "a power is translated by structure where its exponent is a whole number up to 8");
            return n(0);
        }
        const Text x = hold(base);
        Text out = x;
        for (double k = 1; k < times_by; ++k) out = times(out, x);
        return out;
    }

private:
    [[nodiscard]] std::string signed_atom(const Text& t) const {
        return w_.language.sign && t.text[0] != '-' ? "+" + t.text : t.text;
    }

    Writing& w_;
    ExprId where_;
};

Text binary(Writing& w, const Expr& e, ExprId id) {
    Lowering l(w, id);
    const auto op = static_cast<Operator>(e.op);
    if (op == Operator::power) return l.power(e);
    const Text a = w.value(e.a), b = w.value(e.b);
    if (op == Operator::integer_divide) return l.trunc(l.through(a, b));
    const Text x = l.hold(a), y = l.hold(b);
    const Text rest = l.minus(x, l.times(l.hold(l.trunc(l.through(x, y))), y));
    if (!w.unit->traits->modulo_is_positive) return rest;
    const Text to = l.copy(rest);
    w.when(to, Operator::less, l.n(0), [&] { w.assign(to, l.plus(to, l.call("abs", y))); });
    return to;
}

}  // namespace

Text Writing::rounded(const Text& v, ExprId from) { return Lowering(*this, from).round(v); }

Text Writing::function(const Expr& e, ExprId id) {
    if (e.kind == ExprKind::binary) return binary(*this, e, id);
    Lowering l(*this, id);
    std::vector<Text> a;
    for (std::size_t k = 0; k < e.count; ++k) a.push_back(value(unit->children[e.b + k]));
    a.resize(3);
    const auto f = static_cast<Function>(e.op);
    switch (f) {
        case Function::min:
        case Function::max:
            if (!l.has(f == Function::min ? "min" : "max")) return l.extreme(a[0], a[1], f == Function::min);
            break;
        case Function::bound: return l.bound(a[0], a[1], a[2]);
        case Function::trunc: return l.trunc(a[0]);
        case Function::round: return l.round(a[0]);
        case Function::round_up: return l.up(a[0]);
        case Function::round_outwards: return l.outwards(a[0]);
        case Function::round_down: return l.down(a[0]);
        case Function::round_away: return l.round_away(a[0]);
        case Function::square: return l.square(a[0]);
        case Function::sign: return l.sign(a[0]);
        case Function::fraction: {
            const Text x = l.hold(a[0]);
            return l.minus(x, l.trunc(x));
        }
        case Function::log10: return l.through(l.call("ln", a[0]), l.n(std::log(10.0)));
        case Function::root_of_squares: return l.call("sqrt", l.plus(l.square(a[0]), l.square(a[1])));
        case Function::atan2: return l.angle(a[0], a[1]);
        case Function::angle_of: return l.more_a_turn(l.any_angle(a[0], a[1]));
        case Function::atan:
            if (!l.has("atan")) return l.angle(a[0], l.n(1));
            break;
        case Function::asin:
            if (input.angles_from_zero) return l.more_a_turn(l.call(l.has("asin") ? "asin" : "asin-turn", a[0]));
            if (!l.has("asin")) return l.less_a_turn(l.call("asin-turn", a[0]));
            break;
        default: break;
    }
    for (const Spelling& s : spellings)
        if (s.function == f) return l.call(s.key, a[0], a[1]);
    refuse(span(id), source(span(id)) + ": this function is not translated by structure");
    return number_text(0);
}

}  // namespace obrys::rewrite
