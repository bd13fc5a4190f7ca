#include "read/apt/state.hpp"

#include <algorithm>

#include "base/codes.hpp"
#include "base/text.hpp"

namespace obrys::read::apt {

using program::Code;
using program::Modal;

State::State(std::uint32_t number, const base::Sources& sources, program::Unit& unit, program::Names& names,
             base::Diagnostics& complaints)
    : file(number),
      text(sources[number].text),
      diagnostics(complaints),
      build(unit, names, complaints, sources[number].text),
      scanner(base::without_end_signs(sources[number].text)),
      system(dialect::apt::system_of(sources[number].text)) {}

Arguments arguments(const Line& line) {
    const Token* const end = line.tokens.data() + line.tokens.size();
    const Token* const slash =
        std::find_if(line.tokens.data(), end, [](const Token& t) { return t.kind == TokenKind::slash; });
    return {slash == end ? end : slash + 1, end};
}

std::optional<std::vector<double>> numbers(const Arguments& a) {
    std::vector<double> found;
    bool due = true;
    for (const Token& t : a) {
        if (due != (t.kind == TokenKind::number) || (!due && t.kind != TokenKind::comma)) return std::nullopt;
        if (due) found.push_back(t.number.value);
        due = !due;
    }
    if (due) return std::nullopt;
    return found;
}

std::string upper_of(const Token& t) { return base::to_upper(t.chars); }

void begin_block(State& s) {
    s.build.begin_block();
    s.build.statement(program::StatementKind::block, s.line.begin);
}
void end_block(State& s) { s.build.end_statement(s.line.end); }

void refuse(State& s, std::string_view reason) {
    begin_block(s);
    s.build.problem(Code::unsupported, s.line.begin, s.line.end, reason);
    end_block(s);
}

void refuse_rest(State& s, const Arguments& a, std::size_t known) {
    const Token* rest =
        a.begin() + std::min<std::ptrdiff_t>(static_cast<std::ptrdiff_t>(2 * known), a.end() - a.begin());
    if (rest == a.end()) return;
    begin_block(s);
    s.build.problem(Code::unsupported, rest->begin, (a.end() - 1)->end, "what it says here is not known");
    end_block(s);
}

void fail(State& s, const Token* at, std::string text, std::string remedy) {
    begin_block(s);
    const bool known = at != nullptr && at < s.line.tokens.data() + s.line.tokens.size();
    s.build.fail(known ? at->begin : s.line.begin, known ? at->end : s.line.end, std::move(text), std::move(remedy));
    end_block(s);
}

void assume(State& s, std::uint32_t begin, std::uint32_t end, std::string_view text, std::string_view remedy) {
    if (std::exchange(s.warned[text], true)) return;
    base::Diagnostic d;
    d.severity = base::Severity::warning;
    d.code = base::codes::assumption;
    d.where = {s.file, begin, end};
    d.text = text;
    d.remedy = remedy;
    s.diagnostics.add(std::move(d));
}

void tell_feed(State& s, const Feed& feed) {
    s.build.modal(feed.mode, feed.begin, feed.end);
    s.build.literal(Code::feed, feed.value, feed.begin, feed.end);
}

void set_unit(State& s, double mm) {
    if (s.inch == mm && s.unit_told) return;
    s.inch = mm;
    s.unit_told = true;
    begin_block(s);
    s.build.modal(mm == 1 ? Modal::metric_all : Modal::inch_all, s.line.begin, s.line.end);
    end_block(s);
}

namespace {

/// The unit of the text's feeds, which its lengths have, too: mm of it, 0 where none says so or several do.
double unit_of_feeds(std::string_view text) {
    const std::string upper = base::to_upper(text.substr(0, base::telling_bytes));
    const auto has = [&](std::string_view w) { return upper.find(w) != std::string::npos; };
    const bool metric = has("MMPM") || has("MMPR"), inches = has(",IPM") || has(",IPR") || has("/IPM") || has("/IPR");
    return metric == inches ? 0 : metric ? 1 : 25.4;
}

}  // namespace

void need_unit(State& s) {
    if (s.unit_told) return;
    if (const double mm = unit_of_feeds(s.text); mm > 0) return set_unit(s, mm);
    assume(s, s.line.begin, s.line.end, "no UNITS stands before the first length: lengths are taken as millimetres",
           "write UNITS/MM or UNITS/INCHES");
    set_unit(s, 1);
}

}  // namespace obrys::read::apt
