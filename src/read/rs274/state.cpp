#include "read/rs274/state.hpp"

#include <algorithm>

#include "base/slip.hpp"

namespace obrys::read::rs274 {

void fail(State& s, std::uint32_t begin, std::uint32_t end, std::string text, std::string remedy) {
    if (s.failed) return;
    s.failed = true;
    s.words.clear();
    if (s.part->ended) return;
    if (const auto slip = base::slip_in_number(s.text, begin); !slip.empty()) remedy = slip;
    program::Builder& build = s.build();
    build.begin_block(s.skip);
    build.statement(StatementKind::block, std::min(s.line.begin(), begin));
    build.fail(begin, std::max(begin, end), std::move(text), std::move(remedy));
    build.end_statement(std::max(s.line.end(), end));
}

namespace {

/// Length of the thing that stands here: a name, a number or one sign.
std::size_t thing_length(const State& s) {
    const std::string_view rest = s.line.rest();
    if (rest.empty()) return 0;
    std::size_t n = 1;
    if (base::is_letter(rest[0])) {
        while (n < rest.size() && base::is_letter(rest[n])) ++n;
    } else if (base::is_digit(rest[0])) {
        while (n < rest.size() && (base::is_digit(rest[n]) || rest[n] == '.')) ++n;
    } else if (static_cast<unsigned char>(rest[0]) >= 0x80) {
        while (n < rest.size() && static_cast<unsigned char>(rest[n]) >= 0x80) ++n;
    }
    return n;
}

}  // namespace

std::string here(const State& s) {
    const std::size_t n = thing_length(s);
    if (n == 0 || s.line.peek() == ';') return "end of block";
    const std::uint32_t begin = s.line.here(), end = s.line.to(s.line.place() + n);
    return "'" + base::as_utf8(s.text.substr(begin, end - begin)) + "'";
}

void fail_here(State& s, std::string text, std::string remedy) {
    const std::size_t n = thing_length(s);
    const std::uint32_t begin = s.line.here();
    fail(s, begin, n == 0 ? begin : s.line.to(s.line.place() + n), std::move(text), std::move(remedy));
}

}  // namespace obrys::read::rs274
