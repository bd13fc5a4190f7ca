/// The couplets of a hole cycle: a word and the number that goes with it.

#include <algorithm>
#include <cmath>

#include "read/apt/state.hpp"

namespace obrys::read::apt {

using dialect::apt::Couplet;
using dialect::apt::HoleValue;
using program::Modal;

namespace {

double unit_of(const State& s, bool inches) { return (inches ? 25.4 : 1) / (s.inch > 0 ? s.inch : 1); }

/// Units that feeds of the cycle name, before a length of it is looked at.
void take_unit_of_feed(State& s, const Arguments& a) {
    for (const Token& t : a) {
        const Couplet* known = t.kind == TokenKind::word ? dialect::apt::find_couplet(upper_of(t)) : nullptr;
        if (known == nullptr || s.unit_told) continue;
        if (known->value == HoleValue::feed_minute || known->value == HoleValue::feed_turn) set_unit(s, 1);
        if (known->value == HoleValue::inch_minute || known->value == HoleValue::inch_turn) set_unit(s, 25.4);
    }
    need_unit(s);
}

Feed feed_of(const State& s, HoleValue what, const Token& t) {
    Feed f;
    const bool minute = what == HoleValue::feed_minute || what == HoleValue::inch_minute;
    const bool plain = what == HoleValue::plain_minute || what == HoleValue::plain_turn;
    f.mode = minute || what == HoleValue::plain_minute ? Modal::feed_per_minute : Modal::feed_per_rev;
    f.factor = plain ? 1 : unit_of(s, what == HoleValue::inch_minute || what == HoleValue::inch_turn);
    f.value = t.number.value * f.factor;
    f.begin = t.begin;
    f.end = t.end;
    return f;
}

/// Where the sizes of one statement go: none may be said twice with two values.
class Taking {
public:
    Taking(State& s, HoleSizes& sizes) : s_(s), sizes_(sizes) {}

    /// A complaint; empty: taken.
    [[nodiscard]] std::string take(const Couplet& couplet, const Token& t) {
        const double v = t.number.value;
        switch (couplet.value) {
            case HoleValue::depth: return put(sizes_.depth, std::abs(v), couplet);
            case HoleValue::rapid_to: return put(sizes_.rapid_to, v, couplet);
            case HoleValue::clearance: return put(sizes_.clearance, v, couplet);
            case HoleValue::retract: return put_retract(v, couplet);
            case HoleValue::dwell: return v < 0 ? negative(couplet) : put(sizes_.dwell, v, couplet);
            case HoleValue::first_step: return v > 0 ? put(sizes_.first_step, v, couplet) : negative(couplet);
            case HoleValue::step: return v > 0 ? put(sizes_.step, v, couplet) : negative(couplet);
            case HoleValue::back: return v > 0 ? put(sizes_.back, v, couplet) : negative(couplet);
            case HoleValue::threads_inch:
                return v > 0 ? put(sizes_.pitch, unit_of(s_, true) / v, couplet) : negative(couplet);
            case HoleValue::pitch: return v > 0 ? put(sizes_.pitch, v, couplet) : negative(couplet);
            case HoleValue::none: return {};
            case HoleValue::feed_minute:
            case HoleValue::feed_turn:
            case HoleValue::inch_minute:
            case HoleValue::inch_turn:
            case HoleValue::plain_minute:
            case HoleValue::plain_turn:
                return v > 0 ? put(sizes_.feed, feed_of(s_, couplet.value, t), couplet) : negative(couplet);
        }
        return {};
    }

    /// RTRCTO,AUTO.
    [[nodiscard]] std::string take_start(const Couplet& couplet) {
        if (filled(&sizes_.retract)) return contradiction(couplet);
        filled_.push_back(&sizes_.retract_to_start);
        sizes_.retract_to_start = true;
        sizes_.retract.reset();
        return {};
    }

private:
    static std::string negative(const Couplet& couplet) {
        return std::string(couplet.name) + " wants a number greater than 0";
    }
    static std::string contradiction(const Couplet& couplet) {
        return std::string(couplet.name) + " contradicts what was said of the same before";
    }
    [[nodiscard]] bool filled(const void* slot) const {
        return std::find(filled_.begin(), filled_.end(), slot) != filled_.end();
    }
    std::string put_retract(double v, const Couplet& couplet) {
        if (filled(&sizes_.retract_to_start)) return contradiction(couplet);
        sizes_.retract_to_start = false;
        return put(sizes_.retract, v, couplet);
    }
    template <class Value>
    std::string put(std::optional<Value>& slot, const Value& v, const Couplet& couplet) {
        // PITCH and TPI, MMPM and MMPR, DEPTH and FEDTO fill the same slot.
        if (filled(&slot) && !same(*slot, v)) return contradiction(couplet);
        filled_.push_back(&slot);
        slot = v;
        return {};
    }
    static bool same(double a, double b) { return std::abs(a - b) <= 1e-9 * std::abs(a); }
    static bool same(const Feed& a, const Feed& b) { return a.mode == b.mode && same(a.value, b.value); }

    State& s_;
    HoleSizes& sizes_;
    std::vector<const void*> filled_;
};

}  // namespace

std::string read_couplets(State& s, HoleSizes& sizes, const Arguments& a, std::size_t known) {
    take_unit_of_feed(s, a);
    Taking taking(s, sizes);
    const std::ptrdiff_t first = std::min<std::ptrdiff_t>(static_cast<std::ptrdiff_t>(2 * known), a.end() - a.begin());
    for (const Token* t = a.begin() + first; t < a.end(); t += 2) {
        if (t->kind == TokenKind::number)
            return "the order of numbers without words is each shop's own: nothing says whether " +
                   std::string(t->chars) + " is a depth, a feed or a clearance";
        const Couplet* couplet = t->kind == TokenKind::word ? dialect::apt::find_couplet(upper_of(*t)) : nullptr;
        if (couplet == nullptr) return "what " + std::string(t->chars) + " says of it is not known";
        t += 2;
        if (couplet->value == HoleValue::retract && t < a.end() && upper_of(*t) == "AUTO") {
            if (std::string fault = taking.take_start(*couplet); !fault.empty()) return fault;
            continue;
        }
        if (t >= a.end() || t->kind != TokenKind::number) return std::string(couplet->name) + " wants a number";
        if (std::string fault = taking.take(*couplet, *t); !fault.empty()) return fault;
    }
    return {};
}

}  // namespace obrys::read::apt
