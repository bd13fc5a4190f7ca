/// Words of a path block: axes, feed, corners, functions.

#include <algorithm>
#include <array>

#include "read/heidenhain/state.hpp"

namespace obrys::read::heidenhain {

std::optional<Code> axis_of(char c) {
    const auto k = std::string_view("XYZABCUVW").find(base::upper(c));
    if (k == std::string_view::npos) return std::nullopt;
    return static_cast<Code>(static_cast<int>(Code::x) + static_cast<int>(k));
}

void read_feed(State& s) {
    const std::uint32_t begin = s.in.at();
    s.in.step();
    if (s.in.take_word("MAX")) {  // the block's motion has it
        if (s.rapid_said) return fail(s, begin, "FMAX stands twice in the block", "leave one of them");
        s.rapid_said = true;
        if (s.feed_said) return fail(s, begin, "two feeds stand in the block", "leave FMAX or the feed in numbers");
        if (s.rapid_is_word)
            s.build.modal(Modal::rapid_block, begin, s.in.at());
        else if (!s.rapid_counts)
            s.build.problem(Code::unsupported, begin, s.in.at(), "FMAX belongs to blocks that move");
        return;
    }
    s.feed_said = true;
    if (s.rapid_said) return fail(s, begin, "two feeds stand in the block", "leave FMAX or the feed in numbers");
    if (s.in.take_word("AUTO")) return s.build.bare(Code::feed_auto, begin, s.in.at());
    const char kind = base::upper(s.in.peek());
    if (kind == 'U' || kind == 'Z') {
        s.in.step();
        return value_word(s, kind == 'U' ? Code::feed_per_rev : Code::feed_per_tooth, begin);
    }
    if (kind == 'T') {
        s.in.step();
        const Value v = read_value(s);
        s.build.problem(Code::unsupported, begin, v.end, "a time instead of a feed");
        return;
    }
    if (base::is_blank(s.in.peek()) || s.in.at_end()) {
        const Value v = read_value(s);
        if (!v.found) return s.build.ignored("F without a value", begin, begin + 1);  // the key alone was pressed
        s.in.go_to(begin + 1);
    }
    value_word(s, Code::feed, begin);
}

bool has_rapid(State& s) {
    const std::uint32_t from = s.in.at();
    bool found = false;
    while (!s.in.at_end() && !found) {
        if (base::upper(s.in.peek()) == 'F') {
            s.in.step();
            found = s.in.take_word("MAX");
        } else {
            s.in.step();
        }
    }
    s.in.go_to(from);
    return found;
}

namespace {

/// `RND 10`, `CHF R3`: the control's editor knows neither. False where no value stands behind the word.
bool misplaced_radius(State& s, bool has_r, std::uint32_t begin) {
    const std::string word = base::to_upper(base::trim(s.in.between(begin, s.in.at())));
    s.in.skip_blanks();
    const std::uint32_t from = s.in.at();
    if (!has_r) s.in.take('R');
    const std::uint32_t number = s.in.at();
    const Value v = read_value(s);
    const std::string value(s.in.between(number, v.end));
    s.in.go_to(from);
    if (!v.found) return false;
    fail(s, begin, has_r ? word + " has no R before its radius" : word + " has no R: its length stands behind it",
         "write " + word + (has_r ? " R" : " ") + value);
    return true;
}

}  // namespace

bool skipped_with_last(State& s) {
    return (s.build.unit().statements.back().flags & program::skip_mask) == s.build.skip();
}

void read_corner(State& s, bool chamfer, bool has_r, std::uint32_t begin) {
    const bool joined = s.last_path != program::no_target && s.last_path + 1 == s.build.unit().statements.size();
    if (!joined) {
        s.build.statement(StatementKind::block, s.block);
        fail(s, begin, "a chamfer or rounding needs a contour element directly before it");
        return;
    }
    if (!skipped_with_last(s)) {
        s.build.statement(StatementKind::block, s.block);
        return fail(s, begin, "a chamfer or rounding and its contour element are not skipped together",
                    "write / before both");
    }
    s.in.skip_blanks();
    if (has_r != (base::upper(s.in.peek()) == 'R') && misplaced_radius(s, has_r, begin)) return;
    if (has_r) s.in.take('R');
    value_word(s, chamfer ? Code::chamfer_leg : Code::round, begin);
    s.in.skip_blanks();
    const std::uint32_t word = s.in.at();
    if (!s.failed && base::upper(s.in.peek()) == 'F') {
        s.in.step();
        value_word(s, Code::corner_feed, word);
    }
    if (!s.in.at_end()) fail_here(s, "only a feed may follow here, found " + here(s));
    if (!s.failed) s.build.statement(StatementKind::block, s.block);  // the block itself, which counts as one
}

namespace {

/// 1E1, 5E-3: formulas and splines have exponents, words have none.
bool has_exponent(std::string_view word) {
    for (std::size_t i = 1; i + 1 < word.size(); ++i)
        if (base::upper(word[i]) == 'E' && (base::is_digit(word[i - 1]) || word[i - 1] == '.' || word[i - 1] == ','))
            return true;
    return false;
}

}  // namespace

void no_exponent(State& s, std::uint32_t begin) {
    if (s.failed || s.exponents || !has_exponent(s.in.between(begin, s.in.at()))) return;
    fail(s, begin, "a number in a word has no exponent", "write it out: X10 for X1E1");
}

void read_functions(State& s) {
    while (!s.failed && !s.in.at_end()) {
        const char c = base::upper(s.in.peek());
        if (c != 'M' && c != 'F')
            return fail_here(s, "only M and F stand in this block, found " + here(s), "coordinates need L before them");
        read_word(s, false);
    }
}

}  // namespace obrys::read::heidenhain
