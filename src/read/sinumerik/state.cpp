#include "read/sinumerik/state.hpp"

#include <algorithm>

#include "base/slip.hpp"

namespace obrys::read::sinumerik {

using program::Code;
using program::Form;
using program::Statement;
using program::StatementKind;

std::uint32_t Cursor::from(const char* at) const {
    const auto i = static_cast<std::size_t>(at - base_);
    if (map_ == nullptr) return static_cast<std::uint32_t>(i);
    if (map_->from.empty()) return 0;
    return i < map_->from.size() ? map_->from[i] : map_->to.back();
}

std::uint32_t Cursor::to(const char* at) const {
    const auto i = static_cast<std::size_t>(at - base_);
    if (map_ == nullptr) return static_cast<std::uint32_t>(i);
    return i == 0 ? from(at) : map_->to[std::min(i, map_->to.size()) - 1];
}

std::string_view Cursor::name() const {
    const char* q = p;
    if (q < end && is_name_start(*q))
        while (q < end && is_name_part(*q)) ++q;
    return {p, static_cast<std::size_t>(q - p)};
}

void fail(State& s, const char* from, const char* to, std::string text, std::string remedy) {
    if (s.failed) return;
    s.failed = true;
    s.failure = s.span(from, to);
    s.failure.end = std::max(s.failure.end, s.failure.begin);
    s.failure_text = text;
    base::Diagnostic d;
    d.code = base::codes::syntax;
    d.where = s.failure;
    d.text = std::move(text);
    const auto slip = base::slip_in_number(s.text, s.failure.begin);
    d.remedy = slip.empty() ? std::move(remedy) : std::string(slip);
    s.diagnostics.add(std::move(d));
}

namespace {

/// End of the smallest thing at the cursor that a programmer would point at.
const char* thing_end(State& s) {
    Cursor& c = s.cursor;
    c.skip_blanks();
    if (c.p == c.end || *c.p == ';') return c.p;
    if (const std::string_view name = c.name(); !name.empty()) return c.p + name.size();
    const char* q = c.p + 1;
    if (base::is_digit(*c.p)) {
        while (q < c.end && (base::is_digit(*q) || *q == '.')) ++q;
    } else if (static_cast<unsigned char>(*c.p) >= 0x80) {
        while (q < c.end && static_cast<unsigned char>(*q) >= 0x80) ++q;
    }
    return q;
}

}  // namespace

std::string here(State& s) {
    const char* to = thing_end(s);
    if (to == s.cursor.p) return "end of block";
    return "'" + base::as_utf8({s.cursor.p, static_cast<std::size_t>(to - s.cursor.p)}) + "'";
}

void fail_here(State& s, std::string text, std::string remedy) {
    const char* to = thing_end(s);
    fail(s, s.cursor.p, to, std::move(text), std::move(remedy));
}

void keep_failure(State& s) {
    if (!s.failed || s.failure_kept) return;
    s.failure_kept = true;
    if (!s.block_open) {
        open_block(s, s.cursor.p);
        Statement& opened = s.unit.statements.back();
        opened.begin = std::min(opened.begin, s.failure.begin);
    }
    s.build.problem(Code::unknown, s.failure.begin, s.failure.end, s.failure_text);
}

program::NameId intern(State& s, std::string_view name) { return s.build.name(name); }

void note_variable(State& s, const std::string& upper, bool is_string) {
    s.variables.insert(upper);
    if (is_string) s.strings.insert(upper);
    if (upper.size() > 1 && base::is_digit(upper[1])) s.odd_names = true;
}

Statement& add_statement(State& s, StatementKind kind, const char* from) {
    close_block(s);
    if (!s.line_has_statement) s.build.begin_block(s.skip);
    s.build.statement(kind, s.line_has_statement ? s.cursor.from(from) : s.line_begin);
    s.line_has_statement = true;
    ++s.items;
    return s.unit.statements.back();
}

namespace {

/// Gives the last statement the text up to the cursor, blanks at its end left out.
void end_statement(State& s) {
    const char* q = s.cursor.p;
    while (s.cursor.from(q) > s.unit.statements.back().begin && base::is_blank(q[-1])) --q;
    s.build.end_statement(s.cursor.to(q));
}

}  // namespace

void add_control(State& s, StatementKind kind, std::size_t index, const char* from) {
    add_statement(s, kind, from);
    end_statement(s);
    s.block_open = true;
    add_word(s, Code::control, Form::index, static_cast<std::int32_t>(index), from);
    s.block_open = false;
    if (kind != StatementKind::frame) s.block_of_its_own = true;
}

void open_block(State& s, const char* from) {
    if (s.block_open) return;
    add_statement(s, StatementKind::block, from);
    s.block_open = true;
}

void close_block(State& s) {
    if (!s.block_open) return;
    s.block_open = false;
    end_statement(s);
}

void add_word(State& s, Code code, Form form, std::int32_t payload, const char* from) {
    open_block(s, from);
    ++s.items;
    s.build.word(code, form, payload, s.cursor.from(from), s.cursor.to(s.cursor.p));
}

void add_problem(State& s, Code code, const char* from, std::string_view reason) {
    open_block(s, from);
    program::Problem problem;
    problem.where = s.span(from, s.cursor.p);
    problem.text = base::as_utf8({from, static_cast<std::size_t>(s.cursor.p - from)});
    problem.reason = reason;
    s.unit.problems.push_back(std::move(problem));
    add_word(s, code, Form::index, static_cast<std::int32_t>(s.unit.problems.size() - 1), from);
}

void add_ignored(State& s, const char* from, const char* to) {
    ++s.items;
    const std::string upper = base::to_upper({from, static_cast<std::size_t>(to - from)});
    s.build.ignored(upper, s.cursor.from(from), s.cursor.to(to));
}

}  // namespace obrys::read::sinumerik
