/// Letters and numbers of a block.

#include <algorithm>
#include <cmath>

#include "program/modal_group.hpp"
#include "read/rs274/fanuc/state.hpp"

namespace obrys::read::rs274 {

void read_head(FanucState& s) {
    s.number.reset();
    s.skip = 0;
    for (int i = 0; i < 3 && !s.failed; ++i) {
        if (s.line.peek() == '/' && s.skip == 0) {
            s.line.step();
            s.skip = 1;
            if (!base::is_digit(s.line.peek())) continue;
            const int level = s.line.peek() - '0';  // /1 is the same as /
            s.skip = static_cast<std::uint8_t>(level > 1 ? level + 1 : 1);
            s.line.step();
        } else if (s.line.peek() == 'N' && base::is_digit(s.line.peek(1)) && !s.number) {
            std::uint32_t n = 0;
            const std::uint32_t begin = s.line.here();
            constexpr std::uint32_t most = 99'999'999;
            bool fits = true;
            for (s.line.step(); base::is_digit(s.line.peek()); s.line.step()) {
                n = std::min(n * 10 + static_cast<std::uint32_t>(s.line.peek() - '0'), most + 1);
                fits = fits && n <= most;
            }
            if (!fits) return fail(s, begin, s.line.behind(), "a block number has eight digits at most");
            s.number = n;
        } else {
            return;
        }
    }
}

namespace {

void read_address(FanucState& s, bool comma) {
    Address a;
    a.comma = comma;
    a.begin = s.line.here();
    a.letter = s.line.peek();
    s.line.step();
    if (comma) a.begin -= 1;
    const auto is_sign = [&](std::size_t k) { return s.line.peek(k) == '-' || s.line.peek(k) == '+'; };
    const bool signs =
        (is_sign(0) && is_sign(1)) ||
        (s.line.peek() == '-' &&
         std::string_view(s.control.is_lathe() ? "GMSTO" : "GMSTOHD").find(a.letter) != std::string_view::npos);
    a.value = read_due_value(s, {&a.letter, 1}, a.begin);
    if (s.failed) return;
    if (signs)
        return fail(s, a.begin, s.line.behind(),
                    s.control.haas ? "a sign cannot stand here" : "a sign cannot stand here (alarm 6)");
    round_to_increments(s, a);
    a.end = s.line.behind();
    s.addresses.push_back(a);
}

}  // namespace

void note_number(FanucState& s) {
    if (!s.number) return;
    s.block_numbers.push_back({*s.number, static_cast<std::uint32_t>(s.unit().statements.size())});
}

Address* find_address(FanucState& s, char letter) {
    for (Address& a : s.addresses)
        if (a.letter == letter && !a.comma && !a.used) return &a;
    return nullptr;
}

std::string take_comment(FanucState& s) {
    if (s.line.peek() != '(') return {};
    const std::string_view rest = s.line.rest();
    // Whether they match is asked once: of each comment anew, a block of many would take as many times as long.
    if (!s.brackets_match)
        s.brackets_match = std::count(rest.begin(), rest.end(), '(') <= std::count(rest.begin(), rest.end(), ')');
    const bool pairs = *s.brackets_match;
    std::size_t end = 0;
    for (int depth = 0; end < rest.size(); ++end) {
        if (rest[end] == '(' && (pairs || depth == 0)) ++depth;
        if (rest[end] == ')' && --depth == 0) break;
    }
    const std::string text(base::trim(rest.substr(1, end - 1)));
    s.line.step(std::min(end + 1, rest.size()));
    return base::as_utf8(text);
}

namespace {

/// `<NAME>`: a program by its name (series 30i and 0i-F).
void read_program_name(FanucState& s) {
    const std::size_t length = s.line.rest().find('>');
    if (length == std::string_view::npos || length < 2 || !s.called.empty())
        return fail_here(s, here(s) + " cannot stand here");
    s.called = std::string(s.line.rest().substr(1, length - 1));
    s.called_begin = s.line.here();
    s.line.step(length + 1);
    s.called_end = s.line.behind();
}

}  // namespace

void read_addresses(FanucState& s) {
    s.addresses.clear();
    s.called.clear();
    s.slash.reset();
    while (!s.failed && !s.line.at_end()) {
        const char c = s.line.peek();
        if (c == '/' && !s.slash && !s.addresses.empty()) {
            s.line.step();
            const bool level = base::is_digit(s.line.peek()) && s.line.peek() > '1';
            s.slash = {s.addresses.size(), static_cast<std::uint8_t>(level ? s.line.peek() - '0' + 1 : 1)};
            if (base::is_digit(s.line.peek())) s.line.step();
            continue;
        }
        if (c == '(') {
            static_cast<void>(take_comment(s));
        } else if (c == '<' && !s.addresses.empty() && !s.control.haas) {
            read_program_name(s);
        } else if (c == ',' && base::is_letter(s.line.peek(1))) {
            s.line.step();
            read_address(s, true);
        } else if (base::is_letter(c) && c != 'O' && c != 'N') {
            read_address(s, false);
        } else if (c == 'N' && base::is_digit(s.line.peek(1)) && !s.addresses.empty()) {
            fail_here(s, "a block number stands at the begin of its block",
                      "begin a new line, or end the block with ;");
        } else {
            fail_here(s, here(s) + " cannot stand here");
        }
    }
}

}  // namespace obrys::read::rs274
