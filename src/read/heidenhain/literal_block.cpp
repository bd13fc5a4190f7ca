#include "read/heidenhain/literal_block.hpp"

#include <array>

#include "base/short_number.hpp"

namespace obrys::read::heidenhain {

using program::Form;
using program::Word;

namespace {

constexpr std::array<Code, 256> codes_of_letters = [] {
    std::array<Code, 256> t{};
    t.fill(Code::control);
    const auto set = [&](char c, Code code) { t[static_cast<unsigned char>(c)] = code; };
    set('X', Code::x), set('Y', Code::y), set('Z', Code::z), set('A', Code::a), set('B', Code::b), set('C', Code::c);
    set('F', Code::feed);
    return t;
}();

using Literal = base::ShortNumber;

bool ends_word(char c) { return base::is_blank(c) || c == '\n' || c == '\r' || c == '\0'; }

Word make(Code code, std::uint32_t form, std::int32_t payload, const char* from, const char* to, const char* line) {
    return program::make_word(code, form, payload, static_cast<std::uint32_t>(from - line),
                              static_cast<std::uint32_t>(to - from));
}

/// R0 or FMAX at `p`: the end of the word, else nothing.
const char* fixed_word(const char* p, const char* text) {
    for (; *text != '\0'; ++p, ++text)
        if (*p != *text) return nullptr;
    return ends_word(*p) ? p : nullptr;
}

}  // namespace

bool read_literal_block(State& s) {
    program::Unit& unit = s.build.unit();
    const char* line = s.in.here();
    const char* p = line;
    if (!base::is_digit(*p) || s.lines_missing() != 0) return false;
    while (base::is_digit(*p)) ++p;
    while (base::is_blank(*p)) ++p;
    if (*p != 'L' || !base::is_blank(p[1])) return false;
    const std::size_t first = unit.words.size();
    unit.words.push_back(
        make(Code::modal, static_cast<std::uint32_t>(Form::index), program::modal_word(Modal::linear), p, p + 1, line));
    const char* last = ++p;
    bool rapid_said = false, feed_said = false;
    const auto give_up = [&] {
        unit.words.resize(first);
        return false;
    };
    for (;;) {
        while (base::is_blank(*p)) ++p;
        if (*p == '\n' || (*p == '\r' && p[1] == '\n') || (*p == '\0' && p == s.in.text_end())) break;
        if (p - line > 4000) return give_up();
        if (const char* rapid = fixed_word(p, "FMAX")) {
            if (rapid_said) return give_up();
            unit.words[first].payload = program::modal_word(Modal::rapid);
            rapid_said = true;
            last = p = rapid;
            continue;
        }
        if (const char* off = fixed_word(p, "R0")) {
            unit.words.push_back(make(Code::modal, static_cast<std::uint32_t>(Form::index),
                                      program::modal_word(Modal::compensation_off), p, off, line));
            last = p = off;
            continue;
        }
        const Code code = codes_of_letters[static_cast<unsigned char>(*p)];
        if (code == Code::control) return give_up();
        const Literal n = base::scan_short_number(p + 1, true);
        if (n.end == nullptr || !ends_word(*n.end)) return give_up();
        unit.words.push_back(make(code, n.decimals, n.mantissa, p, n.end, line));
        feed_said = feed_said || code == Code::feed;
        last = p = n.end;
    }
    if (rapid_said && feed_said) return give_up();  // two feeds: read_block complains
    program::Statement statement;
    statement.begin = s.in.at();
    statement.first = static_cast<std::uint32_t>(first);
    statement.length = static_cast<std::uint16_t>(last - line);
    statement.flags = program::line_start;
    unit.statements.push_back(statement);
    s.last_path = static_cast<std::uint32_t>(unit.statements.size() - 1);
    s.after_stop = false;
    s.open_cycle = program::no_target;
    s.in.step(static_cast<std::size_t>(p - line));
    return true;
}

}  // namespace obrys::read::heidenhain
