/// M functions: those that change the path become words of the tree, the others stay numbers.

#include <algorithm>
#include <cmath>

#include "base/whole.hpp"
#include "dialect/heidenhain/m_functions.hpp"
#include "read/heidenhain/state.hpp"

namespace obrys::read::heidenhain {

namespace {

/// Values that belong to an M function: M120 LA10, M140 MB MAX, M103 F20; the last one where there is one.
Value read_values(State& s, std::string_view letters) {
    Value last;
    while (!letters.empty()) {
        const std::size_t blank = std::min(letters.find(' '), letters.size());
        const std::string_view word = letters.substr(0, blank);
        letters.remove_prefix(std::min(blank + 1, letters.size()));
        if (!s.in.take_prefix(word)) continue;
        if (!s.in.take_word("MAX")) last = read_value(s);
    }
    return last;
}

/// M120 LA10: how many blocks are looked ahead.
void look_ahead(State& s, std::uint32_t begin, const dialect::heidenhain::MFunction& known) {
    const Value v = read_values(s, known.parameters);
    const auto n = base::whole<int>(v.found && v.is_literal() ? v.number() : 0, 0, 99);
    s.build.modal(Modal::look_ahead, begin, s.in.at(), n.value_or(0));
    if (v.found && !v.is_literal()) s.build.problem(Code::unsupported, begin, s.in.at(), "LA must be a number here");
    if (!n) s.build.problem(Code::unsupported, begin, s.in.at(), "LA is a whole number from 0 to 99");
}

/// M103 F20: percent of F that is left along the tool axis; without F all of it again.
void plunge_feed(State& s, std::uint32_t begin, const dialect::heidenhain::MFunction& known) {
    const Value v = read_values(s, known.parameters);
    const bool good = !v.found || (v.is_literal() && v.number() > 0 && v.number() <= 100);
    const double percent = v.found && good ? v.number() : 0;
    if (!good) s.build.problem(Code::unsupported, begin, s.in.at(), "F of M103 must be a number from 0 to 100 here");
    if (good) s.build.modal(Modal::plunge_feed, begin, s.in.at(), base::clipped<int>(percent * 100 + 0.5, 0, 10'000));
}

/// M140 MB 50 F750, M140 MB MAX.
void retract(State& s, std::uint32_t begin) {
    if (!s.in.take_prefix("MB"))
        return fail_here(s, "MB is due behind M140, found " + here(s), "M140 MB50, M140 MB MAX");
    const bool limit = s.in.take_word("MAX");
    s.build.modal(Modal::retract_tool, begin, s.in.at(), limit ? 1 : 0);
    if (!limit) value_word(s, Code::q, begin);
    s.in.skip_blanks();
    const std::uint32_t feed = s.in.at();
    if (s.failed || base::upper(s.in.peek()) != 'F') return;
    s.in.step();
    if (!s.in.take_word("MAX")) value_word(s, Code::e, feed);
}

/// M functions that say how the path is made; false where `m` is none of them.
bool path_function(State& s, int m, std::uint32_t begin, const dialect::heidenhain::MFunction& known) {
    const auto word = [&](Modal modal) {
        s.build.modal(modal, begin, s.in.at());
        return true;
    };
    switch (m) {
        case 97: return word(Modal::corner_crossing);
        case 98: return word(Modal::corner_open);
        case 136: return word(Modal::feed_per_rev);
        case 137: return word(Modal::feed_per_minute);
        case 109: return word(Modal::feed_at_contour);
        case 110: return word(Modal::feed_at_inside);
        case 111: return word(Modal::feed_at_tool);
        case 120: return look_ahead(s, begin, known), true;
        case 103: return plunge_feed(s, begin, known), true;
        case 140: return retract(s, begin), true;
        default: return false;
    }
}

}  // namespace

void read_m(State& s, std::uint32_t begin) {
    if (base::is_blank(s.in.peek()) || s.in.at_end())
        return s.build.ignored("M without a value", begin, s.in.at());  // the key alone was pressed
    const Value v = read_value(s);
    if (!v.found || (v.is_literal() && !v.literal.integer)) {
        fail(s, begin, "M needs the whole number of a function");
        return;
    }
    if (!v.is_literal()) return s.build.expression(Code::m, v.expr, begin, v.end);
    const double m = v.number();
    if (m == 91 && !s.machine_counts)
        return s.build.problem(Code::unsupported, begin, v.end, "only straight blocks refer to the machine datum");
    if (m == 91) return s.build.modal(Modal::suppress_all, begin, v.end);
    if (m == 99) return s.build.bare(Code::cycle_call, begin, v.end);
    if (m == 89) return s.build.bare(Code::cycle_call_modal, begin, v.end);
    if (m == 13 || m == 14) {  // spindle and coolant at once
        s.build.literal(Code::m, m == 13 ? 3 : 4, begin, v.end);
        s.build.literal(Code::m, 8, begin, v.end);
        return;
    }
    const auto number = base::cut<int>(m, 0, 999);
    const auto* known = number ? dialect::heidenhain::find_m(*number) : nullptr;
    using dialect::heidenhain::Use;
    if (known != nullptr && known->use == Use::run && path_function(s, *number, begin, *known)) return;
    if (known == nullptr || known->use == Use::run)
        return s.build.literal(Code::m, v.literal, v.negative, begin, v.end);
    static_cast<void>(read_values(s, known->parameters));
    if (known->use == Use::accepted)
        return s.build.ignored("M" + std::to_string(*number) + " (" + std::string(known->text) + ")", begin, s.in.at());
    s.build.problem(Code::unsupported, begin, s.in.at(), known->text);
}

}  // namespace obrys::read::heidenhain
