#include "read/heidenhain/state.hpp"

#include "base/slip.hpp"

namespace obrys::read::heidenhain {

void fail(State& s, std::uint32_t begin, std::string text, std::string remedy) {
    if (s.failed) return;
    s.failed = true;
    if (s.build.unit().statements.size() == s.statements) s.build.statement(StatementKind::block, s.block);
    const std::string_view read = s.in.between(0, begin + (s.in.between(begin, begin + 1)[0] == '\0' ? 1 : 2));
    if (const auto slip = base::slip_in_number(read, begin); !slip.empty()) remedy = slip;
    s.build.fail(begin, s.in.at(), std::move(text), std::move(remedy));
}

std::string here(State& s) {
    if (s.in.at_end()) return "end of block";
    const std::uint32_t from = s.in.at();
    const std::string token = base::as_utf8(s.in.token());
    s.in.go_to(from);
    return "'" + token + "'";
}

void fail_here(State& s, std::string text, std::string remedy) {
    const bool end = s.in.at_end();
    const std::uint32_t from = s.in.at();
    if (!end) static_cast<void>(s.in.token());
    if (!end && s.in.at() == from) s.in.step();  // a sign that ends every token
    fail(s, from, std::move(text), std::move(remedy));
}

bool expect(State& s, std::string_view word) {
    if (s.in.take_prefix(word)) return true;
    fail_here(s, "'" + std::string(word) + "' is due here, found " + here(s));
    return false;
}

}  // namespace obrys::read::heidenhain
