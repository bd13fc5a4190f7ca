#include "read/fusion/state.hpp"

#include <utility>

#include "base/codes.hpp"
#include "base/number.hpp"
#include "base/text.hpp"

namespace obrys::read::fusion {

State::State(std::uint32_t number, const base::Sources& sources, program::Unit& unit, program::Names& names,
             base::Diagnostics& complaints)
    : file(number),
      text(sources[number].text),
      diagnostics(complaints),
      build(unit, names, complaints, sources[number].text),
      scanner(base::without_end_signs(sources[number].text)) {}

Place place_of(const Line& line) { return {line.begin, line.end}; }

Place place_of(const Line& line, std::string_view word) {
    for (std::size_t i = 0; i + 1 < line.tokens.size(); ++i)
        if (line.tokens[i].kind == TokenKind::word && line.tokens[i].chars == word)
            return {line.tokens[i].begin, line.tokens[i + 1].end};
    return place_of(line);
}

void begin_block(State& s, const Place& where) {
    s.build.begin_block();
    s.build.statement(program::StatementKind::block, where.begin);
}
void end_block(State& s, const Place& where) { s.build.end_statement(where.end); }

void refuse(State& s, const Place& where, std::string_view reason) {
    begin_block(s, where);
    s.build.problem(program::Code::unsupported, where.begin, where.end, reason);
    end_block(s, where);
}

void fail(State& s, std::string text) {
    const Place where = place_of(s.line);
    begin_block(s, where);
    s.build.fail(where.begin, where.end, std::move(text));
    end_block(s, where);
}

void assume(State& s, const Place& where, std::string_view text, std::string_view remedy) {
    if (std::exchange(s.warned[text], true)) return;
    base::Diagnostic d;
    d.severity = base::Severity::warning;
    d.code = base::codes::assumption;
    d.where = {s.file, where.begin, where.end};
    d.text = text;
    d.remedy = remedy;
    s.diagnostics.add(std::move(d));
}

std::string_view parameter(const State& s, std::string_view name) {
    const auto found = s.parameters.find(name);
    return found == s.parameters.end() ? std::string_view() : std::string_view(found->second);
}

std::optional<double> number_of(const State& s, std::string_view name) {
    return base::parse_double(parameter(s, name));
}

}  // namespace obrys::read::fusion
