#include <algorithm>

#include "read/rs274/state.hpp"

namespace obrys::read::rs274 {

namespace {

using program::Form;

bool is_technology(const BlockWord& w) {
    return w.order >= Order::technology && w.order < Order::m_stop &&
           (w.code == Code::m || w.code == Code::feed || w.code == Code::spindle || w.code == Code::tool);
}

/// F S T M act before a word that changes what later words mean.
bool is_change(const BlockWord& w) {
    if (w.code != Code::modal) return false;
    return w.order >= Order::state && w.order < Order::suppress && w.order != Order::dwell;
}

void emit_word(State& s, const BlockWord& w) {
    program::Builder& build = s.build();
    switch (w.form) {
        case Form::index:
            if (w.code == Code::unsupported || w.code == Code::unknown)
                return build.problem(w.code, w.begin, w.end, w.reason);
            return build.word(w.code, Form::index, w.payload, w.begin, w.end);
        case Form::expression:
            if (w.value.is_literal()) return build.literal(w.code, w.value.literal, w.value.negative, w.begin, w.end);
            return build.expression(w.code, w.value.expr, w.begin, w.end);
        default: return build.bare(w.code, w.begin, w.end);
    }
}

void statement(State& s, const std::vector<BlockWord>& words) {
    s.build().statement(StatementKind::block, s.line.begin());
    for (const BlockWord& w : words) emit_word(s, w);
    s.build().end_statement(s.line.end());
}

void put_in_order(std::vector<BlockWord>& words) {
    std::stable_sort(words.begin(), words.end(),
                     [](const BlockWord& a, const BlockWord& b) { return a.order < b.order; });
}

/// Where a block dwells before it does something else, the dwell is a block of its own with F, S, T and M.
bool split_dwell(State& s) {
    const bool more = std::any_of(s.words.begin(), s.words.end(),
                                  [](const BlockWord& w) { return w.code == Code::modal && w.order > Order::dwell; });
    const bool dwells = std::any_of(s.words.begin(), s.words.end(), [](const BlockWord& w) {
        return w.code == Code::modal && w.modal == Modal::dwell;
    });
    const bool has_axes = (s.facts.letters & ((1ULL << (static_cast<unsigned>(Code::w) + 1)) - 1)) != 0;
    if (!dwells || (!more && !has_axes)) return false;
    const bool motion_has_p = s.facts.motion == nullptr || s.facts.motion->use == Use::canned;
    std::vector<BlockWord> first, second;
    for (const BlockWord& w : s.words) {
        const bool before = w.order < Order::m_stop || w.order == Order::dwell || w.order == Order::state;
        if (before || w.code == Code::p) first.push_back(w);
        if (!before && (w.code != Code::p || motion_has_p)) second.push_back(w);
    }
    statement(s, first);
    statement(s, second);
    return true;
}

}  // namespace

bool Facts::has_g(std::uint16_t tenths) const { return std::find(g.begin(), g.end(), tenths) != g.end(); }

bool Facts::has_m(std::uint16_t first, std::uint16_t last) const {
    return std::any_of(m.begin(), m.end(), [&](std::uint16_t n) { return n >= first && n <= last; });
}

void Facts::clear() {
    letters = 0;
    g_groups = m_groups = 0;
    motion = own = cancel = nullptr;
    g.clear();
    m.clear();
    refused = false;
}

void begin_words(State& s) {
    s.words.clear();
    s.facts.clear();
    s.comment = {};
}

void add_modal(State& s, Order order, Modal m, int number, std::uint32_t begin, std::uint32_t end) {
    BlockWord w;
    w.order = order;
    w.modal = m;
    w.payload = program::modal_word(m, number);
    w.begin = begin;
    w.end = end;
    s.words.push_back(w);
}

void add_value(State& s, Order order, Code code, const Value& v, std::uint32_t begin, std::uint32_t end) {
    BlockWord w;
    w.order = order;
    w.code = code;
    w.form = Form::expression;
    w.value = v;
    w.begin = begin;
    w.end = end;
    s.words.push_back(w);
}

void add_problem(State& s, Code code, std::uint32_t begin, std::uint32_t end, std::string_view reason) {
    BlockWord w;
    w.code = code;
    w.reason = reason;
    w.begin = begin;
    w.end = end;
    s.words.push_back(w);
}

const BlockWord* find_letter(const State& s, Code code) {
    const auto found = std::find_if(s.words.begin(), s.words.end(), [&](const BlockWord& w) { return w.code == code; });
    return found == s.words.end() ? nullptr : &*found;
}

std::optional<BlockWord> take_letter(State& s, Code code) {
    const BlockWord* found = find_letter(s, code);
    if (found == nullptr) return std::nullopt;
    const BlockWord w = *found;
    s.words.erase(s.words.begin() + (found - s.words.data()));
    return w;
}

void emit_words(State& s, std::vector<BlockWord> words) {
    put_in_order(words);
    statement(s, words);
}

void emit_block(State& s) {
    if (s.failed) return;
    s.build().begin_block(s.skip);
    emit_comment(s);
    if (s.facts.refused)
        std::erase_if(s.words, [](const BlockWord& w) {
            return w.order > Order::m_stop && w.code != Code::unsupported && w.code != Code::unknown;
        });
    if (s.words.empty()) return;
    const bool acts = std::any_of(s.words.begin(), s.words.end(), is_technology) &&
                      std::any_of(s.words.begin(), s.words.end(), is_change);
    if (acts) {
        BlockWord act;
        act.order = Order::act;
        act.code = Code::act;
        act.form = Form::bare;
        act.begin = act.end = s.line.begin();
        s.words.push_back(act);
    }
    put_in_order(s.words);
    if (!split_dwell(s)) statement(s, s.words);
}

}  // namespace obrys::read::rs274
