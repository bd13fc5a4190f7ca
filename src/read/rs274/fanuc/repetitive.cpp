/// Multiple repetitive cycles of lathes (G70 … G76 of system A): their one or two blocks as cycle definitions. Which
/// format a block has is told by its words. Sources: dialect/rs274/fanuc_turning.cpp.

#include <cmath>

#include "read/rs274/fanuc/state.hpp"

namespace obrys::read::rs274 {

using cl::CycleRole;
using dialect::rs274::FanucTurningCycle;
using dialect::rs274::TurningNumber;
using dialect::rs274::TurningWord;
using program::CycleSetting;
using program::Operator;

namespace {

enum class Format : std::uint8_t { data, call, single };  ///< first and second of two blocks; the only one

bool has_any(FanucState& s, std::string_view letters) {
    for (const char letter : letters)
        if (find_address(s, letter) != nullptr) return true;
    return false;
}

Format format_of(FanucState& s, const FanucTurningCycle& c) {
    if (c.number == 700) return Format::call;
    if (c.number < 740) {
        if (has_any(s, "DIK")) return Format::single;
        if (has_any(s, "PQ")) return s.control.haas ? Format::single : Format::call;
        return has_any(s, "UWR") ? Format::data : Format::call;
    }
    if (c.number == 760 && has_any(s, "KD")) return Format::single;
    if (has_any(s, "XUZW")) return Format::call;
    return c.number != 760 && has_any(s, "PQIKD") ? Format::call : Format::data;
}

std::span<const TurningWord> words_of(const FanucState& s, const FanucTurningCycle& c, Format f) {
    if (f == Format::data) return c.data;
    if (f == Format::call) return c.call;
    return s.control.haas ? c.haas : c.single;
}

Value value_of(FanucState& s, const Address& a, TurningNumber number) {
    if (number == TurningNumber::depth) number = s.control.haas ? TurningNumber::length : TurningNumber::increments;
    switch (number) {
        case TurningNumber::length: return scaled(s, a.value, Quantity::length);
        case TurningNumber::lead: return scaled(s, a.value, Quantity::feed);
        case TurningNumber::increments:
            return a.value.is_literal() && a.value.literal.integer && a.value.number() != 0
                       ? in_increments(s, a.value, 3, 4)
                       : a.value;
        default: return a.value;
    }
}

/// One definition in the making.
struct DefinitionWriter {
    FanucState& s;
    program::CycleDefinition& d;

    void add(CycleRole role, ExprId value, const Address& a, bool scales, bool across = false,
             bool incremental = false) const {
        CycleSetting setting;
        setting.role = role;
        setting.value = value;
        setting.scales = scales;
        setting.across = across;
        setting.incremental = incremental;
        setting.where = s.build().span(a.begin, a.end);
        d.settings.push_back(setting);
    }
    [[nodiscard]] ExprId constant(double x, const Address& a) const {
        return s.build().number(x, false, a.begin, a.end);
    }
    [[nodiscard]] ExprId binary(Operator op, ExprId x, ExprId y, const Address& a) const {
        return s.build().binary(op, x, y, a.begin, a.end);
    }
    [[nodiscard]] ExprId whole(ExprId x, const Address& a) const {
        return s.build().function(program::Function::trunc, {x}, a.begin, a.end);
    }

    /// Operator's manual, multiple repetitive cycles: P and Q of lengths have no decimal point.
    void say_point(const Address& a) const {
        if (!a.value.is_literal() || a.value.literal.integer || s.control.haas) return;
        base::Diagnostic found;
        found.severity = base::Severity::warning;
        found.code = base::codes::value_range;
        found.where = s.build().span(a.begin, a.end);
        found.text = std::string(1, a.letter) + " of " + d.name + " counts increments and has no decimal point: the " +
                     "control may stop here (alarm 7) or take another length than the " +
                     base::shortest(a.value.number()) + " that it is read as";
        found.remedy = "write " + std::string(1, a.letter) + base::shortest(std::round(a.value.number() * 1000)) +
                       " for millimetres";
        s.diagnostics.add(std::move(found));
    }

    void word(const TurningWord& w) const {
        Address* a = find_address(s, w.letter);
        if (a == nullptr) return;
        for (const CycleSetting& x : d.settings)
            if (x.role == w.role) return;  // said by another word: this one stays, and is said
        if (w.number == TurningNumber::increments) say_point(*a);
        if (w.number == TurningNumber::angle) {
            if (const auto angle = start_angle(s, *a)) add(w.role, as_expr(s, *angle), *a, false);
            return;
        }
        const Value v = value_of(s, *a, w.number);
        if (w.number == TurningNumber::lead) {  // it is the feed from here on, too
            put_value(s, Order::technology, Code::feed, v, *a);
        }
        a->used = true;
        ExprId e = as_expr(s, v);
        if (w.number == TurningNumber::half_angle) e = binary(Operator::divide, e, constant(2, *a), *a);
        const bool length = w.number != TurningNumber::plain && w.number != TurningNumber::half_angle;
        add(w.role, e, *a, length, w.across);
    }

    /// X, Z; U and W of system A: from where the tool stands.
    void targets() const {
        const auto target = [&](char letter, CycleRole role, bool incremental) {
            if (Address* a = find_address(s, letter)) {
                a->used = true;
                add(role, as_expr(s, scaled(s, a->value, Quantity::length)), *a, true, false, incremental);
            }
        };
        target('X', CycleRole::target_v, false);
        target('Z', CycleRole::target_u, false);
        if (s.control.system != dialect::rs274::GSystem::a) return;
        target('U', CycleRole::target_v, true);
        target('W', CycleRole::target_u, true);
    }

    /// P(m)(r)(a) of G76, two digits each: finishing passes, tenths of a lead of run-out, angle between the flanks.
    void thread_digits() const {
        Address* p = find_address(s, 'P');
        if (p == nullptr) return;
        p->used = true;
        const ExprId all = as_expr(s, p->value);
        const auto digits = [&](double above) {
            const ExprId high = whole(binary(Operator::divide, all, constant(above, *p), *p), *p);
            return binary(Operator::modulo, high, constant(100, *p), *p);
        };
        add(CycleRole::finish_passes, digits(10'000), *p, false);
        add(CycleRole::runout_leads, binary(Operator::divide, digits(100), constant(10, *p), *p), *p, false);
        add(CycleRole::infeed_angle, binary(Operator::divide, digits(1), constant(2, *p), *p), *p, false);
    }

    [[nodiscard]] ExprId block_number(char letter) const {
        Address* a = find_address(s, letter);
        if (a == nullptr) return no_expr;
        a->used = true;
        if (const auto n = as_integer(a->value); n && *n >= 0)
            s.section_labels.push_back(static_cast<std::uint32_t>(*n));
        return as_expr(s, a->value);
    }
};

/// The lead that was written last.
void lead_before(FanucState& s, const DefinitionWriter& w, const Address& g) {
    for (const CycleSetting& x : w.d.settings)
        if (x.role == CycleRole::pitch) return;
    w.add(CycleRole::pitch, as_expr(s, feed_in_force(s, g.begin, g.end)), g, true);
}

/// What is no word of the cycle: F, S, T act before it, the rest is not known.
void other_words(FanucState& s, const FanucTurningCycle& c) {
    for (Address& x : s.addresses) {
        if (x.used) continue;
        if (x.letter == 'F' || x.letter == 'S' || x.letter == 'T') {
            emit_address(s, x);
            continue;
        }
        x.used = true;
        const bool passed_over = c.number < 730 && !s.control.haas && (x.letter == 'I' || x.letter == 'K');
        if (passed_over)
            s.build().ignored(std::string(1, x.letter) + " of stock removal in one block", x.begin, x.end);
        else
            add_problem(s, Code::unsupported, x.begin, x.end, "a word of this cycle");
    }
}

}  // namespace

void repetitive_cycle(FanucState& s, const FanucG& g, const Address& a) {
    const FanucTurningCycle& c = *dialect::rs274::find_turning_cycle(g.number);
    program::CycleDefinition d;
    d.kind = c.kind;
    d.name = "G" + base::shortest(a.value.number());
    d.where = s.build().span(a.begin, a.end);
    d.store = c.store;
    const Format format = format_of(s, c);
    const DefinitionWriter w{s, d};
    s.turning = 0;
    s.cleared_cycle = false;
    if (c.number < 740 && format != Format::data) {
        d.first_block = w.block_number('P');
        d.last_block = w.block_number('Q');
    }
    if (c.number >= 740 && format != Format::data) w.targets();
    if (c.number == 760 && format == Format::data) w.thread_digits();
    for (const TurningWord& word : words_of(s, c, format)) w.word(word);
    if (c.number == 760 && format != Format::data) lead_before(s, w, a);
    d.sets_only = format == Format::data;
    if (!d.sets_only) d.otherwise = s.control.haas ? c.settings : c.parameters;
    other_words(s, c);
    emit_block(s);
    s.words.clear();
    s.unit().cycles.push_back(std::move(d));
    add_control(s, StatementKind::cycle_definition, s.unit().cycles.size() - 1);
}

}  // namespace obrys::read::rs274
