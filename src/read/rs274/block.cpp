#include "read/rs274/state.hpp"

namespace obrys::read::rs274 {

namespace {

std::string bad_character(const State& s) {
    const auto byte = static_cast<unsigned char>(s.line.peek());
    if (byte < 0x20) return "a control character stands in the block";
    return here(s) + " cannot stand here";
}

void read_number_of_spindle(State& s, std::uint32_t begin) {
    s.line.step();
    const Value v = read_due_value(s, "$", begin);
    if (s.failed) return;
    const auto n = as_integer(v);
    if (n && *n <= 0) return;  // the only spindle, or all of them
    add_problem(s, Code::unsupported, begin, v.end, "a second spindle");
}

/// Values that the control refuses at once.
bool check_sign(State& s, Code code, const Value& v, std::uint32_t begin) {
    if (!v.is_literal() || v.number() >= 0) return true;
    const bool counts = code == Code::feed || code == Code::spindle || code == Code::tool || code == Code::l;
    if (!counts && !(code == Code::offset_h && v.number() < -1)) return true;
    fail(s, begin, v.end, std::string(1, base::upper(s.text[begin])) + " cannot be negative");
    return false;
}

void read_letter(State& s, Code code, std::uint32_t begin) {
    const char letter = s.line.peek();
    s.line.step();
    const std::uint64_t bit = 1ULL << static_cast<unsigned>(code);
    if ((s.facts.letters & bit) != 0)
        return fail(s, begin, begin + 1, std::string("two ") + letter + " words in one block");
    const Value v = read_due_value(s, {&letter, 1}, begin);
    if (s.failed || !check_sign(s, code, v, begin)) return;
    s.facts.letters |= bit;
    const bool technology = code == Code::feed || code == Code::spindle || code == Code::tool;
    add_value(s, technology ? Order::technology : Order::value, code, v, begin, v.end);
}

void read_assignment(State& s, std::uint32_t begin) {
    s.operators = 0;
    const ExprId target = read_parameter(s, true);
    if (s.failed) return;
    if (!s.line.take('=')) return fail_here(s, "expected = behind the parameter, found " + here(s), "write #1=5");
    const Value v = read_due_value(s, "the assignment", begin);
    if (s.failed) return;
    program::Unit& unit = s.unit();
    unit.assigns.push_back({target, as_expr(s, v)});
    BlockWord w;
    w.order = Order::assign;
    w.code = Code::assign;
    w.payload = static_cast<std::int32_t>(unit.assigns.size() - 1);
    w.begin = begin;
    w.end = v.end;
    s.words.push_back(w);
}

}  // namespace

void read_block_head(State& s) {
    s.skip = 0;
    if (s.line.take('/')) {
        s.skip = 1;
        if (s.variant.skip_levels && base::is_digit(s.line.peek())) {
            s.skip = static_cast<std::uint8_t>(s.line.peek() - '0' + 1);
            s.line.step();
        }
    }
    if (s.line.peek() != 'N') return;
    const std::uint32_t begin = s.line.here();
    s.line.step();
    const std::size_t digits = s.line.place();
    while (base::is_digit(s.line.peek())) s.line.step();
    if (s.line.place() == digits) return fail(s, begin, begin + 1, "N without a block number", "write N10");
    if (s.line.peek() != '.' || !base::is_digit(s.line.peek(1))) return;
    s.line.step();
    while (base::is_digit(s.line.peek())) s.line.step();
}

void read_comment(State& s) {
    const std::uint32_t begin = s.line.here();
    if (s.line.peek() == ';') {
        const bool script = s.variant.active_comments && begin == s.line.begin() && s.line.rest().starts_with(";py,");
        if (script) add_problem(s, Code::unsupported, begin, s.line.end(), "a script in Python");
        return s.line.step(s.line.rest().size());
    }
    int depth = 0;
    do {
        depth += s.line.peek() == '(' ? 1 : s.line.peek() == ')' ? -1 : 0;
        s.line.step();
    } while (depth > 0 && !s.line.at_end());
    s.comment = {true, begin, s.line.behind()};
}

void read_word(State& s) {
    const std::uint32_t begin = s.line.here();
    const char c = s.line.peek();
    switch (c) {
        case '(':
        case ';': return read_comment(s);
        case '#': return read_assignment(s, begin);
        case 'G': s.line.step(); return read_g(s, begin);
        case 'M': s.line.step(); return read_m(s, begin);
        case '$': return read_number_of_spindle(s, begin);
        default: break;
    }
    const Code code = dialect::rs274::letter_code(c);
    if (code != Code::control) return read_letter(s, code, begin);
    fail_here(s, bad_character(s), c == 'N' ? "a block number stands at the begin of the block" : "");
}

void read_words(State& s) {
    while (!s.failed && !s.line.at_end()) read_word(s);
    if (!s.failed) take_cancel(s);
}

}  // namespace obrys::read::rs274
