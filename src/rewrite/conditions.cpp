/// Conditions: as one expression where the language has such, else as jumps that compare two values each.

#include <utility>

#include "rewrite/writing.hpp"

namespace obrys::rewrite {

namespace {

std::string_view key_of_comparison(Operator op) {
    switch (op) {
        case Operator::equal: return "operators.equal";
        case Operator::not_equal: return "operators.not-equal";
        case Operator::less: return "operators.less";
        case Operator::less_equal: return "operators.less-equal";
        case Operator::greater: return "operators.greater";
        default: return "operators.greater-equal";
    }
}

/// Jumps that stand for one comparison.
std::vector<std::string_view> jumps_for(Operator op) {
    switch (op) {
        case Operator::equal: return {"flow.jump-equal"};
        case Operator::not_equal: return {"flow.jump-not-equal"};
        case Operator::less: return {"flow.jump-less"};
        case Operator::less_equal: return {"flow.jump-less", "flow.jump-equal"};
        case Operator::greater: return {"flow.jump-greater"};
        default: return {"flow.jump-greater", "flow.jump-equal"};
    }
}

Condition turned(Condition c) {
    using Kind = Condition::Kind;
    c.holds = !c.holds;
    c.op = opposite(c.op);
    if (c.kind == Kind::all || c.kind == Kind::any) c.kind = c.kind == Kind::all ? Kind::any : Kind::all;
    for (Condition& part : c.parts) part = turned(std::move(part));
    return c;
}

}  // namespace

Operator opposite(Operator op) {
    switch (op) {
        case Operator::equal: return Operator::not_equal;
        case Operator::not_equal: return Operator::equal;
        case Operator::less: return Operator::greater_equal;
        case Operator::less_equal: return Operator::greater;
        case Operator::greater: return Operator::less_equal;
        default: return Operator::less;
    }
}

Condition Writing::condition(ExprId id, bool negated) {
    const Expr& e = unit->exprs[id];
    const auto op = static_cast<Operator>(e.op);
    Condition c;
    if (e.kind == ExprKind::unary && op == Operator::logical_not) return condition(e.a, !negated);
    if (e.kind == ExprKind::boolean) {
        c.holds = (e.a != 0) != negated;
        return c;
    }
    if (e.kind == ExprKind::binary && (op == Operator::logical_and || op == Operator::logical_or)) {
        c.kind = (op == Operator::logical_and) != negated ? Condition::Kind::all : Condition::Kind::any;
        c.parts.push_back(condition(e.a, negated));
        c.parts.push_back(condition(e.b, negated));
        return c;
    }
    c.kind = Condition::Kind::comparison;
    if (e.kind == ExprKind::binary && op == Operator::logical_xor) {  // 1 and 0, of which both are alike or not
        c.a = truth(e.a), c.b = truth(e.b);
        c.op = negated ? Operator::equal : Operator::not_equal;
        if (!c.a.number || !c.b.number) return c;
        c.kind = Condition::Kind::constant;
        c.holds = (*c.a.number != *c.b.number) != negated;
        return c;
    }
    // The language may have no operands but numbers and parameters.
    const bool plain = !language.has("flow.jump-if") && !language.has("flow.if");
    const auto operand = [&](ExprId x) { return plain ? atom(x) : value(x); };
    if (e.kind == ExprKind::binary && op >= Operator::equal && op <= Operator::greater_equal) {
        c.a = operand(e.a), c.b = operand(e.b);
        c.op = negated ? opposite(op) : op;
        if (c.a.number && c.a.number == c.b.number && (op == Operator::equal || op == Operator::not_equal)) {
            c.kind = Condition::Kind::constant;  // FN 9: IF +0 EQU +0: always
            c.holds = (op == Operator::equal) != negated;
        }
    } else {
        c.a = operand(id), c.b = number_text(0);
        c.op = negated ? Operator::equal : Operator::not_equal;
    }
    return c;
}

std::optional<std::string> Writing::as_text(const Condition& c) const {
    if (c.kind == Condition::Kind::constant) return std::nullopt;
    if (c.kind == Condition::Kind::comparison) {
        const std::string* op = language.find(key_of_comparison(c.op));
        if (op == nullptr) return std::nullopt;
        return within(c.a, Level::sum) + *op + within(c.b, Level::sum);
    }
    const std::string* op = language.find(c.kind == Condition::Kind::all ? "operators.and" : "operators.or");
    if (op == nullptr) return std::nullopt;
    std::string out;
    for (const Condition& part : c.parts) {
        const auto text = as_text(part);
        if (!text) return std::nullopt;
        out += (out.empty() ? "" : *op) + language.open + *text + language.close;
    }
    return out;
}

void Writing::jump_when(const Condition& c, const std::string& label) {
    if (!may_jump()) return;
    if (c.kind == Condition::Kind::constant) {
        if (c.holds) jump(label);
        return;
    }
    if (language.has("flow.jump-if"))
        if (const auto text = as_text(c)) {
            static_cast<void>(say("flow.jump-if", {{"condition", *text}, {"label", label}}, "a conditional jump"));
            return;
        }
    if (c.kind == Condition::Kind::any) {
        for (const Condition& part : c.parts) jump_when(part, label);
    } else if (c.kind == Condition::Kind::all) {
        const std::string past = fresh_label();
        for (std::size_t i = 0; i + 1 < c.parts.size(); ++i) jump_when(turned(c.parts[i]), past);
        jump_when(c.parts.back(), label);
        place(past);
    } else {
        const auto operand = [&](const Text& t) { return language.sign && t.text[0] != '-' ? "+" + t.text : t.text; };
        for (const std::string_view key : jumps_for(c.op))
            if (!say(key, {{"a", operand(c.a)}, {"b", operand(c.b)}, {"label", label}}, "a conditional jump")) return;
    }
}

namespace {

/// Within an expression both ways meet again: words that wait for the next move go on waiting behind them, and do not
/// come to stand on one of the ways.
class Kept {
public:
    explicit Kept(std::string& waits) : waits_(waits), kept_(std::exchange(waits, {})) {}
    ~Kept() { waits_ = std::move(kept_); }
    Kept(const Kept&) = delete;
    Kept& operator=(const Kept&) = delete;

private:
    std::string& waits_;
    std::string kept_;
};

}  // namespace

void Writing::when(const Text& a, Operator op, const Text& b, const std::function<void()>& then) {
    const Kept length(length_waits);
    Condition c{.kind = Condition::Kind::comparison, .op = op, .a = a, .b = b};
    const auto text = language.has("flow.if") ? as_text(c) : std::nullopt;
    if (text) {
        const std::string n = std::to_string(++next_number_);
        static_cast<void>(say("flow.if", {{"condition", *text}, {"n", n}}, "IF"));
        then();
        static_cast<void>(say("flow.end-if", {{"n", n}}, "IF"));
        return;
    }
    const std::string past = fresh_label();
    jump_when(turned(std::move(c)), past);
    then();
    place(past);
}

Text Writing::truth(ExprId id) {
    const Condition c = condition(id);
    if (c.kind == Condition::Kind::constant) return number_text(c.holds ? 1 : 0);
    const Text to = place_for(id);
    const Kept length(length_waits);
    assign(to, number_text(0));
    if (const auto text = language.has("flow.if") ? as_text(c) : std::nullopt) {
        const std::string n = std::to_string(++next_number_);
        static_cast<void>(say("flow.if", {{"condition", *text}, {"n", n}}, "IF"));
        assign(to, number_text(1));
        static_cast<void>(say("flow.end-if", {{"n", n}}, "IF"));
        return to;
    }
    const std::string past = fresh_label();
    jump_when(turned(c), past);
    assign(to, number_text(1));
    place(past);
    return to;
}

}  // namespace obrys::rewrite
