/// IF, WHILE, DO, END, GOTO. Source: FANUC series 16i operator's manual B-63684EN, 16.5 branch and repetition. IF …
/// THEN over several lines with ELSE and ENDIF is of newer controls.

#include <algorithm>

#include "read/rs274/fanuc/state.hpp"

namespace obrys::read::rs274 {

namespace {

std::uint32_t next_statement(const FanucState& s) { return static_cast<std::uint32_t>(s.unit().statements.size()); }

/// Entry of the branch at a statement.
program::Branch& branch_at(FanucState& s, std::uint32_t statement) {
    program::Unit& u = s.unit();
    return u.branches[static_cast<std::size_t>(u.words[u.statements[statement].first].payload)];
}

void add_branch(FanucState& s, StatementKind kind, ExprId condition, std::uint32_t target) {
    s.unit().branches.push_back({condition, target});
    add_control(s, kind, s.unit().branches.size() - 1);
}

base::Span line_span(const FanucState& s) { return s.build().span(s.line.begin(), s.line.end()); }

/// `[ … ]` behind IF or WHILE; no_expr after a complaint.
ExprId condition(FanucState& s, std::string_view word) {
    s.operators = 0;
    if (s.line.peek() == '[') return read_bracket(s);
    fail_here(s, "expected [ behind " + std::string(word) + ", found " + here(s));
    return no_expr;
}

/// The number behind DO or END.
std::optional<int> loop_number(FanucState& s, std::string_view word) {
    const std::uint32_t begin = s.line.here();
    int n = 0;
    while (base::is_digit(s.line.peek()) && n < 1000) {
        n = n * 10 + (s.line.peek() - '0');
        s.line.step();
    }
    if (n >= 1 && n <= 3) return n;
    fail(s, begin, std::max(begin, s.line.behind()), std::string(word) + " needs a number from 1 to 3");
    return std::nullopt;
}

void expect_end(FanucState& s) {
    while (s.line.peek() == '(') static_cast<void>(take_comment(s));
    if (!s.line.at_end()) fail_here(s, "expected the end of the block, found " + here(s));
}

void complain(FanucState& s, const base::Span& where, std::string text, std::string remedy) {
    base::Diagnostic d;
    d.code = base::codes::unclosed;
    d.where = where;
    d.text = std::move(text);
    d.remedy = std::move(remedy);
    s.diagnostics.add(std::move(d));
}

void open_loop(FanucState& s, int number, ExprId condition_of, const base::Span& word) {
    for (const FanucLoop& l : s.loops)
        if (l.number == number)
            return fail(s, s.line.begin(), s.line.end(),
                        "DO " + std::to_string(number) + " stands inside another DO " + std::to_string(number),
                        "nested loops need different numbers");
    s.loops.push_back({number, next_statement(s), condition_of != no_expr, word});
    add_branch(s, condition_of != no_expr ? StatementKind::while_ : StatementKind::loop_, condition_of,
               program::no_target);
}

void close_loop(FanucState& s, const FanucLoop& l, bool once) {
    const std::uint32_t self = next_statement(s);
    add_branch(s, l.has_condition ? StatementKind::endwhile : StatementKind::endloop, no_expr,
               once ? self + 1 : l.statement);
    branch_at(s, l.statement).target = self + 1;
}

void close_if(FanucState& s, const FanucIf& f) {
    const std::uint32_t self = next_statement(s);
    add_branch(s, StatementKind::endif, no_expr, program::no_target);
    if (f.else_statement == program::no_target) {
        branch_at(s, f.statement).target = self + 1;
    } else {
        branch_at(s, f.statement).target = f.else_statement + 1;
        branch_at(s, f.else_statement).target = self;
    }
}

}  // namespace

void read_goto(FanucState& s, ExprId condition_of) {
    const std::uint32_t begin = s.line.here();
    s.operators = 0;
    const Value v = read_due_value(s, "GOTO", begin);
    if (s.failed) return;
    expect_end(s);
    const auto n = as_integer(v);
    if (v.is_literal() && (!n || *n < 0)) fail(s, begin, v.end, "GOTO needs the number of a block");
    if (s.failed) return;
    program::Jump jump;
    jump.condition = condition_of;
    jump.direction = program::JumpDirection::either;
    jump.destination = as_expr(s, v);
    s.unit().jumps.push_back(jump);
    if (n) s.jumps.push_back({s.unit().jumps.size() - 1, static_cast<std::uint32_t>(*n)});
    add_control(s, StatementKind::jump, s.unit().jumps.size() - 1);
}

void read_if(FanucState& s) {
    const ExprId is = condition(s, "IF");
    if (is == no_expr) return;
    if (s.line.take("GOTO")) return read_goto(s, is);
    if (!s.line.take("THEN")) return fail_here(s, "expected GOTO or THEN behind the condition, found " + here(s));
    const FanucIf opened{next_statement(s), program::no_target, line_span(s)};
    add_branch(s, StatementKind::if_, is, program::no_target);
    while (s.line.peek() == '(') static_cast<void>(take_comment(s));
    if (s.line.at_end()) {
        s.ifs.push_back(opened);
        return;
    }
    read_rest(s);
    close_if(s, opened);
}

void read_else(FanucState& s) {
    expect_end(s);
    if (s.failed) return;
    if (s.ifs.empty() || s.ifs.back().else_statement != program::no_target)
        return fail(s, s.line.begin(), s.line.end(), "ELSE without IF");
    s.ifs.back().else_statement = next_statement(s);
    add_branch(s, StatementKind::else_, no_expr, program::no_target);
}

void read_endif(FanucState& s) {
    expect_end(s);
    if (s.failed) return;
    if (s.ifs.empty()) return fail(s, s.line.begin(), s.line.end(), "ENDIF without IF");
    const FanucIf f = s.ifs.back();
    s.ifs.pop_back();
    close_if(s, f);
}

void read_while(FanucState& s) {
    const base::Span word = line_span(s);
    const ExprId is = condition(s, "WHILE");
    if (is == no_expr) return;
    if (!s.line.take("DO")) return fail_here(s, "expected DO behind the condition, found " + here(s));
    const auto n = loop_number(s, "DO");
    if (!n) return;
    expect_end(s);
    if (!s.failed) open_loop(s, *n, is, word);
}

void read_do(FanucState& s) {
    const base::Span word = line_span(s);
    const auto n = loop_number(s, "DO");
    if (!n) return;
    expect_end(s);
    if (!s.failed) open_loop(s, *n, no_expr, word);
}

void read_end(FanucState& s) {
    const auto n = loop_number(s, "END");
    if (!n) return;
    expect_end(s);
    if (s.failed) return;
    const auto found = std::find_if(s.loops.rbegin(), s.loops.rend(), [&](const auto& l) { return l.number == *n; });
    const std::string number = std::to_string(*n);
    if (found == s.loops.rend())
        return fail(s, s.line.begin(), s.line.end(), "END " + number + " without DO " + number);
    while (s.loops.back().number != *n) {
        const std::string open = std::to_string(s.loops.back().number);
        complain(s, s.loops.back().word, "DO " + open + " crosses END " + number, "put END " + open + " before it");
        close_loop(s, s.loops.back(), true);
        s.loops.pop_back();
    }
    const FanucLoop l = s.loops.back();
    s.loops.pop_back();
    close_loop(s, l, false);
}

void close_program(FanucState& s) {
    s.build().begin_block();
    program::Unit& unit = s.unit();
    unit.unended = s.control.haas ? "the program ends without M30, M2 or M99"
                                  : "the program ends without M30, M2 or M99 (alarm 5010)";
    while (!s.loops.empty() || !s.ifs.empty()) {
        const bool loop = s.ifs.empty() || (!s.loops.empty() && s.loops.back().statement > s.ifs.back().statement);
        const std::string n = loop ? std::to_string(s.loops.back().number) : "";
        if (loop) {
            complain(s, s.loops.back().word, "DO " + n + " without END " + n, "add END " + n + " where it ends");
            close_loop(s, s.loops.back(), true);
            s.loops.pop_back();
        } else {
            complain(s, s.ifs.back().word, "IF … THEN without ENDIF", "add ENDIF where it ends");
            close_if(s, s.ifs.back());
            s.ifs.pop_back();
        }
        unit.statements.back().flags = 0;  // not in the text: it begins no block
    }
    std::vector<NumberedBlock>& numbered = s.block_numbers;
    const auto before = [](const NumberedBlock& x, const NumberedBlock& y) { return x.number < y.number; };
    if (!s.jumps.empty() || !s.labels.empty() || !s.section_labels.empty())
        std::stable_sort(numbered.begin(), numbered.end(), before);
    const auto places = [&](std::uint32_t n) {
        std::vector<std::uint32_t> statements;
        const auto [first, last] = std::equal_range(numbered.begin(), numbered.end(), NumberedBlock{n, 0}, before);
        for (auto at = first; at != last; ++at) statements.push_back(at->statement);
        return statements;
    };
    for (const PendingJump& j : s.jumps)
        if (const auto at = places(j.number); at.size() == 1) unit.jumps[j.jump].target = at.front();
    for (const PendingLabel& l : s.labels)
        if (const auto at = places(l.number); !at.empty()) unit.label_calls[l.entry].target = at.front();
    for (const std::uint32_t n : s.section_labels)
        if (auto at = places(n); !at.empty()) unit.labels[s.build().name("N" + std::to_string(n))] = std::move(at);
    s.jumps.clear(), s.labels.clear(), s.section_labels.clear(), s.block_numbers.clear();
}

}  // namespace obrys::read::rs274
