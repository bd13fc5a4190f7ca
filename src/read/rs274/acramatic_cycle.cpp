/// Hole cycles: what the letters of the block and the table of cycle parameters come to. Source: thesis 2021, chapter 3
/// (docs/dialects/acramatic.md).

#include <algorithm>

#include "read/rs274/acramatic_state.hpp"

namespace obrys::read::rs274 {

namespace {

using enum AcramaticParameter;

/// The words of one cycle block at work.
struct Call {
    AcramaticState& s;
    std::string name;                  ///< "G84.1"
    std::uint32_t begin = 0, end = 0;  ///< of its G code, or of the block's first word
    bool own = false;                  ///< the block has the G code
};

std::string name_of(int tenths) {
    return "G" + std::to_string(tenths / 10) + (tenths % 10 != 0 ? "." + std::to_string(tenths % 10) : "");
}

void refuse(const Call& c, std::string_view reason) {
    add_problem(c.s, Code::unsupported, c.begin, c.end, reason);
    c.s.facts.refused = true;
    c.s.moving = Moving::lost;
}

void put(const Call& c, Code code, const Value& v) { add_value(c.s, Order::value, code, v, c.begin, c.end); }
void put(const Call& c, Code code, double number) {
    Value v;
    v.found = true;
    v.literal.value = number;
    put(c, code, v);
}

std::string_view name_of(AcramaticParameter p) {
    return dialect::rs274::acramatic_parameters()[static_cast<std::size_t>(p)].name;
}

/// A value of the table that the path needs; false where the program has not said it.
bool put_needed(const Call& c, Code code, AcramaticParameter p) {
    const auto& value = c.s.entry(p).value;
    if (!value) return refuse(c, dialect::rs274::acramatic_parameters()[static_cast<std::size_t>(p)].missing), false;
    put(c, code, *value);
    return true;
}

void tell_once(const Call& c, AcramaticParameter p, std::string text) {
    if (std::exchange(c.s.entry(p).told, true)) return;
    note_assumption(c.s, c.begin, c.end, c.name + ": " + std::move(text),
                    "write [$CYCLE_PARAMS(2)" + std::string(name_of(p)) + "]=... before it");
}

/// A dwell has no effect on the path: one that the program has not said in front of this cycle is left out, and said.
void put_dwell(const Call& c, Code code, AcramaticParameter p) {
    const TableValue& entry = c.s.entry(p);
    if (entry.fresh && entry.value->number() == 0) return;
    if (entry.fresh) return put(c, code, *entry.value);
    tell_once(c, p,
              entry.value ? "how long it dwells was said for an earlier cycle; whether that holds here is not "
                            "documented: it is run without a dwell"
                          : "how long it dwells stands in the control's table alone: it is run without a dwell");
}

/// The end of the way at another feed.
void put_finish(const Call& c) {
    const auto &depth = c.s.entry(finish_depth_82).value, &factor = c.s.entry(feed_factor_82).value;
    if ((depth && depth->number() == 0) || (factor && factor->number() == 100)) return;
    if (depth && factor) {
        put(c, Code::i, *depth);
        return put(c, Code::j, *factor);
    }
    tell_once(c, depth ? feed_factor_82 : finish_depth_82,
              "how the end of the way is fed stands in the control's table alone: it is run at the feed F");
}

/// J1 to J3: the first infeed is 3 K, the second 2 K.
void put_infeeds(const Call& c, int j) {
    constexpr double first = 3, second = 2;
    const BlockWord* k = find_letter(c.s, Code::k);
    if (j > 3 || k == nullptr) return;
    const double infeed = k->value.number();
    put(c, Code::i, first * infeed);
    put(c, Code::j, second * infeed);
}

/// J times speed and feed on the way out; J1 says nothing.
void take_factor(const Call& c) {
    const auto j = take_letter(c.s, Code::j);
    if (!j || j->value.number() == 1) return;
    put(c, Code::j, j->value);
}

/// K and P of a rigid tap: without K there are no breaks, and P means nothing.
void take_breaks(const Call& c) {
    const auto k = take_letter(c.s, Code::k), p = take_letter(c.s, Code::p);
    if (k || c.own) c.s.breaks = k && k->value.number() != 0;
    if (!c.s.breaks) return;
    if (k) put(c, Code::k, k->value);
    if (p && p->value.number() != 0) return put(c, Code::p, p->value);
    if (c.own || p) static_cast<void>(put_needed(c, Code::p, chip_break_84));
}

/// Letters that the cycle has besides X, Y, Z, R and W.
std::uint64_t letters_of(AcramaticCycle cycle) {
    switch (cycle) {
        case AcramaticCycle::drill:
        case AcramaticCycle::counterbore: return 0;
        case AcramaticCycle::tap_floating: return bit(Code::j);
        case AcramaticCycle::tap_rigid: return bit(Code::j) | bit(Code::k) | bit(Code::p);
        default: return bit(Code::j) | bit(Code::k);
    }
}

/// The ways of a cycle that depend on it alone.
void put_parameters(const Call& c, int j) {
    switch (c.s.cycle) {
        case AcramaticCycle::drill: return;
        case AcramaticCycle::counterbore: put_dwell(c, Code::p, dwell_82); return put_finish(c);
        case AcramaticCycle::chip_break:
            put_infeeds(c, j);
            return static_cast<void>(put_needed(c, Code::offset_d, retract_83));
        case AcramaticCycle::short_peck:
        case AcramaticCycle::peck:
            put_infeeds(c, j);
            return static_cast<void>(put_needed(c, Code::offset_d, relief_83));
        case AcramaticCycle::tap_floating: take_factor(c); return put_dwell(c, Code::p, dwell_84);
        case AcramaticCycle::tap_rigid:
            take_factor(c);
            take_breaks(c);
            return put_dwell(c, Code::i, dwell_84);
    }
}

/// J of G83 says which way of pecking; nothing, with a complaint, where it is none. 0: not G83.
std::optional<int> way_of_pecking(const Call& c) {
    if (c.s.tenths != 830) return 0;
    const auto j = take_letter(c.s, Code::j);
    if (!j && c.own)
        return fail(c.s, c.begin, c.end, "G83 without J: how it pecks is not known", "write J11 or J13"), std::nullopt;
    if (!j) return 11;  // the way stays
    const auto way = as_integer(j->value);
    const auto cycle = dialect::rs274::acramatic_cycle(c.s.tenths, way.value_or(0));
    if (!cycle) return fail(c.s, j->begin, j->end, "J of G83 is 1, 2, 3, 11, 12 or 13"), std::nullopt;
    if (!c.own && *cycle != c.s.cycle)
        return fail(c.s, j->begin, j->end, "J changes the way of pecking without G83", "write G83 beside it"),
               std::nullopt;
    c.s.cycle = *cycle;
    return way;
}

/// W is the plane of return; the tree has it under another letter than the axis W.
void take_return(const Call& c) {
    if (const auto w = take_letter(c.s, Code::w)) add_value(c.s, Order::value, Code::e, w->value, w->begin, w->end);
}

/// The cycle in the tree, and the one of the series before it ended: its words begin anew.
void set_cycle(const Call& c, bool series) {
    if (!c.own) return;
    for (BlockWord& w : c.s.words)
        if (w.code == Code::modal && w.modal == Modal::canned)
            w.payload = program::modal_word(Modal::canned, static_cast<int>(c.s.cycle));
    if (!series) return;
    BlockWord off;
    off.order = Order::motion;
    off.modal = Modal::canned_off;
    off.payload = program::modal_word(Modal::canned_off, 0);
    off.begin = c.begin;
    off.end = c.end;
    c.s.build().begin_block(0);
    emit_words(c.s, {off});
}

/// Which modes the cycles are known in.
bool refuse_modes(const Call& c) {
    if (c.s.incremental) return refuse(c, "a hole cycle in G91, where R and W may count from elsewhere"), true;
    if (c.s.inch) return refuse(c, "a hole cycle in G70, which takes the control's cycle parameters in inches"), true;
    if (c.s.other_plane) return refuse(c, "a hole cycle in another plane than G17"), true;
    return false;
}

/// R and Z of the first hole.
bool lacks_heights(const Call& c) {
    if (!c.own) return false;
    for (const auto& [code, text] : {std::pair{Code::radius, " needs R, the top of the hole"},
                                     std::pair{Code::z, " needs Z, the depth of the hole below R"}})
        if (!c.s.facts.has(code)) return fail(c.s, c.begin, c.end, c.name + text), true;
    return false;
}

}  // namespace

void cycle_block(AcramaticState& s) {
    Call c{s, {}, s.words.front().begin, s.words.front().end, false};
    c.own = s.facts.motion != nullptr && s.facts.motion->use == Use::canned;
    const bool series = s.tenths != 0;
    if (c.own) {
        s.tenths = s.facts.motion->number;
        s.cycle = dialect::rs274::acramatic_cycle(s.tenths, 11).value_or(AcramaticCycle::drill);
        for (const BlockWord& w : s.words)
            if (w.code == Code::modal && w.modal == Modal::canned) c.begin = w.begin, c.end = w.end;
    }
    c.name = name_of(s.tenths);
    if (refuse_modes(c) || lacks_heights(c)) return;
    const auto way = way_of_pecking(c);
    if (!way) return;
    constexpr std::uint64_t common = bit(Code::x) | bit(Code::y) | bit(Code::z) | bit(Code::w) | bit(Code::radius) |
                                     bit(Code::feed) | bit(Code::spindle) | bit(Code::tool);
    refuse_other_letters(s, common | letters_of(s.cycle), c.name);
    if (s.failed || !put_needed(c, Code::q, gage_height)) return;
    put_parameters(c, *way);
    take_return(c);
    if (!s.failed && !s.facts.refused) set_cycle(c, series);
}

}  // namespace obrys::read::rs274
