/// What words a block may not hold together, as far as the block itself shows it: LinuxCNC refuses such a block before
/// it runs anything of it. What depends on the modal state is left to the run.

#include <algorithm>

#include "read/rs274/state.hpp"

namespace obrys::read::rs274 {

namespace {

constexpr std::uint64_t straight_axes = (bit(Code::w) << 1) - 1;
constexpr std::uint64_t polar_words = bit(Code::polar_angle) | bit(Code::polar_radius);
constexpr std::uint64_t centre_words = bit(Code::i) | bit(Code::j) | bit(Code::k);
static_assert(static_cast<unsigned>(Code::x) == 0 && static_cast<unsigned>(Code::w) == 8);

bool has_axes(const State& s) { return (s.facts.letters & (straight_axes | polar_words)) != 0; }

/// Complains about the letter's word.
void fail_letter(State& s, Code code, const std::string& text) {
    const BlockWord* w = find_letter(s, code);
    fail(s, w->begin, w->end, text);
}

/// Complains about a G code, by its number times ten, or about the block where it has none such.
void fail_g(State& s, std::uint16_t tenths, const std::string& text, std::string remedy = {}) {
    const auto* g = dialect::rs274::find_g(s.variant, tenths);
    for (const BlockWord& w : s.words)
        if (w.code == Code::modal && g != nullptr && w.payload == program::modal_word(g->modal, g->modal_number))
            return fail(s, w.begin, w.end, text, std::move(remedy));
    fail(s, s.line.begin(), s.line.end(), text, std::move(remedy));
}

std::string g_name(std::uint16_t tenths) {
    return "G" + std::to_string(tenths / 10) + (tenths % 10 != 0 ? "." + std::to_string(tenths % 10) : "");
}

void check_axes(State& s) {
    const auto* motion = s.facts.motion;
    const auto* own = s.facts.own;
    const bool axes = has_axes(s);
    if (own != nullptr && own->axes == Axes::own_required && !axes)
        return fail_g(s, own->number, g_name(own->number) + " without a coordinate");
    if (motion == nullptr) return;
    if (motion->axes == Axes::forbidden) {
        if (axes && own == nullptr)
            fail_g(s, motion->number, "coordinates beside " + g_name(motion->number) + ", which uses none");
        return;
    }
    if (own != nullptr)
        return fail_g(s, own->number, g_name(own->number) + " and " + g_name(motion->number) + " both use coordinates",
                      "write them in two blocks");
    if (motion->axes == Axes::required && !axes)
        fail_g(s, motion->number, g_name(motion->number) + " without a coordinate");
}

bool uses(const State& s, const dialect::rs274::LetterUse& use) {
    const bool by_g = std::any_of(use.g.begin(), use.g.end(), [&](std::uint16_t g) { return s.facts.has_g(g); });
    const bool by_m = std::any_of(use.m.begin(), use.m.end(), [&](const auto& m) {
        return m.last != 0 && s.facts.has_m(static_cast<std::uint16_t>(m.first), static_cast<std::uint16_t>(m.last));
    });
    return by_g || by_m;
}

/// Letters that no code of the block uses. Where the motion is the modal one it may be that which uses them.
void check_letters(State& s) {
    const bool modal_motion =
        s.facts.motion == nullptr && s.facts.own == nullptr && (has_axes(s) || (s.facts.letters & centre_words) != 0);
    if (modal_motion || s.facts.refused || s.facts.has_m(100, 199)) return;
    for (const auto& use : s.variant.letters)
        if (s.facts.has(use.code) && !uses(s, use))
            return fail_letter(s, use.code, std::string("no code of the block uses ") + use.letter);
}

std::optional<double> literal(const State& s, Code code) {
    const BlockWord* w = find_letter(s, code);
    return w != nullptr && w->value.is_literal() ? std::optional(w->value.number()) : std::nullopt;
}

void check_set_data(State& s) {
    const auto l = literal(s, Code::l), p = literal(s, Code::p);
    const bool computed = find_letter(s, Code::l) != nullptr && !l;
    const bool known = l && (*l == 0 || *l == 1 || *l == 2 || *l == 10 || *l == 11 || *l == 20);
    if (!computed && !known) return fail_g(s, 100, "G10 needs L0, L1, L2, L10, L11 or L20");
    if (!p || computed) return;
    const bool is_datum = *l == 2 || *l == 20;
    if (is_datum && (*p < 0 || *p > 9)) return fail_letter(s, Code::p, "G10 L2 and L20 know P0 to P9");
    if (!is_datum && *l != 0 && *p < 1) return fail_letter(s, Code::p, "there is no tool with this number");
}

void check_required(State& s) {
    const Facts& f = s.facts;
    if (f.has_g(40) && !f.has(Code::p)) return fail_g(s, 40, "G4 does not say how long", "write G4 P1");
    if (f.has_g(40) && (f.has_g(20) || f.has_g(30))) return fail_g(s, 40, "G4 and an arc both use P");
    if (f.has_g(100)) check_set_data(s);
    if (f.has_g(530) && f.motion != nullptr && f.motion->number > 10)
        return fail_g(s, 530, "only G0 and G1 move in machine coordinates");
    if (f.has_g(530) && f.has_g(910)) return fail_g(s, 530, "machine coordinates cannot be incremental");
    if (f.has_g(960) && !f.has(Code::spindle)) return fail_g(s, 960, "G96 does not say how fast", "write G96 S100");
    const bool synchronised = f.has_g(330) || f.has_g(331);
    if (synchronised && !f.has(Code::k)) return fail_g(s, f.motion->number, "the pitch K is missing");
    if (synchronised && f.has(Code::feed)) return fail_letter(s, Code::feed, "the pitch says how fast; F cannot");
    if (!f.has_g(760)) return;
    for (const Code c : {Code::p, Code::i, Code::j, Code::k})
        if (!f.has(c)) return fail_g(s, 760, "G76 needs P, I, J and K");
}

void check_polar(State& s) {
    if ((s.facts.letters & polar_words) == 0) return;
    if (s.facts.has(Code::x)) return fail_letter(s, Code::x, "X and a polar coordinate in one block");
    if (s.facts.has(Code::y)) return fail_letter(s, Code::y, "Y and a polar coordinate in one block");
    if (s.facts.own != nullptr) fail_g(s, s.facts.own->number, "polar coordinates are for motions only");
}

void check_m(State& s) {
    for (const std::uint16_t m : s.facts.m) {
        const std::string name = "M" + std::to_string(m);
        const auto p = literal(s, Code::p);
        if (m >= 62 && m <= 65 && (!s.facts.has(Code::p) || (p && *p < 0)))
            return fail(s, s.line.begin(), s.line.end(), name + " needs P, the number of the output",
                        "write " + name + " P0");
        if ((m == 67 || m == 68) && !s.facts.has(Code::e))
            return fail(s, s.line.begin(), s.line.end(), name + " needs E, the number of the output",
                        "write " + name + " E0 Q1");
    }
    if (s.facts.has_m(66, 66) && !s.facts.has(Code::p) && !s.facts.has(Code::e))
        fail(s, s.line.begin(), s.line.end(), "M66 says neither with P nor with E which input");
}

/// D of G96 is the spindle's limit; letters of M codes without effect have none either.
void settle_letters(State& s) {
    for (BlockWord& w : s.words)
        if (w.code == Code::offset_d && s.facts.has_g(960)) w.code = Code::speed_limit;
    for (const std::uint16_t m : s.facts.m) {
        const auto* code = dialect::rs274::find_m(s.variant, m);
        if (code == nullptr || code->use != Use::ignored) continue;
        for (const char letter : code->letters) {
            const Code c = dialect::rs274::letter_code(letter);
            const auto use = std::find_if(s.variant.letters.begin(), s.variant.letters.end(),
                                          [&](const auto& u) { return u.letter == letter; });
            const bool other = use != s.variant.letters.end() &&
                               std::any_of(use->g.begin(), use->g.end(), [&](auto g) { return s.facts.has_g(g); });
            if (!other) (void)take_letter(s, c);
        }
    }
}

}  // namespace

bool is_too_long(State& s) {
    const auto length = s.line.end() - s.line.begin();
    const auto most = static_cast<std::uint32_t>(s.variant.longest_line);
    if (most == 0 || length <= most) return false;
    fail(s, s.line.begin() + most, s.line.end(),
         "this line is " + std::to_string(length) + " characters long; " + std::string(s.variant.control) + " reads " +
             std::to_string(most),
         "shorten it or its comment");
    return true;
}

void check_block(State& s) {
    if (!s.variant.letters.empty()) {
        for (auto* check : {check_axes, check_polar, check_required, check_m, check_letters}) {
            check(s);
            if (s.failed) return;
        }
    }
    settle_letters(s);
}

}  // namespace obrys::read::rs274
