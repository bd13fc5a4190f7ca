#include <algorithm>
#include <array>

#include "read/rs274/state.hpp"

namespace obrys::read::rs274 {

using program::ExprKind;

namespace {

constexpr std::array<std::string_view, 2> returned{"_VALUE", "_VALUE_RETURNED"};

/// Sets what #<_value> and #<_value_returned> tell the caller.
void assign_returned(State& s, ExprId value, std::uint32_t begin) {
    const std::uint32_t end = s.line.behind();
    program::Builder& build = s.build();
    build.statement(StatementKind::block, begin);
    const bool given = value != no_expr;
    const std::array<ExprId, 2> values{given ? value : build.number(0, true, begin, end),
                                       build.number(given ? 1 : 0, true, begin, end)};
    for (std::size_t i = 0; i < returned.size(); ++i) {
        program::Expr e;
        e.kind = ExprKind::variable;
        e.a = build.name(returned[i]);
        build.assign(build.add(e, begin, end), values[i], begin, end);
    }
    build.end_statement(end);
}

void complain_about_end(const Part& part) {
    base::Diagnostic d;
    d.code = base::codes::unclosed;
    d.where = part.word;
    d.text = "o" + base::as_utf8(part.label) + " sub without its endsub";
    part.diagnostics.add(std::move(d));
}

}  // namespace

void begin_sub(State& s, const std::string& label, std::uint32_t begin) {
    const std::uint32_t end = s.line.behind();
    if (s.part->kind == Part::Kind::o_sub) {
        s.part->refused = label;
        return fail(s, begin, end,
                    "a subprogram is defined within another: o" + base::as_utf8(label) + " sub in o" +
                        base::as_utf8(s.part->label));
    }
    const bool known = !s.subs.insert(label).second;
    const bool repeated = s.part->kind == Part::Kind::program_number;
    if (known && !s.part->ended && !repeated)
        fail(s, begin, end, "o" + base::as_utf8(label) + " sub is defined already");
    Part& part = s.add_part(repeated ? s.repeated : s.diagnostics);
    part.outer = s.part;
    part.kind = Part::Kind::o_sub;
    part.label = label;
    part.dropped = known;
    part.unit.name = "O" + label;
    part.unit.begin = s.line.begin();
    part.word = part.build.span(begin, end);
    s.part = &part;
}

void read_return(State& s, const std::string& label, ExprId value, bool ends, std::uint32_t begin) {
    Part& part = *s.part;
    if (part.kind != Part::Kind::o_sub) {
        const std::string what = "o" + base::as_utf8(label) + (ends ? " endsub" : " return");
        return fail(s, begin, s.line.behind(), what + " stands in no subprogram");
    }
    if (ends && part.label != label) {
        if (part.refused == label) return part.refused.clear();
        return fail(s, begin, s.line.behind(),
                    "o" + base::as_utf8(label) + " endsub does not end o" + base::as_utf8(part.label) + " sub");
    }
    if (ends) close_all(s);
    s.build().begin_block(s.skip);
    assign_returned(s, value, begin);
    s.build().control(StatementKind::return_, 0, begin, s.line.behind());
    if (!ends) return;
    part.unit.end = s.line.end();
    part.ended = true;
    s.part = part.outer;
}

void read_program_number(State& s, const std::string& label, std::uint32_t begin) {
    if (s.part->kind == Part::Kind::o_sub)
        return fail(s, begin, s.line.behind(), "a program begins within o" + base::as_utf8(s.part->label) + " sub");
    if (s.part->kind == Part::Kind::main) {
        s.numbers.push_back({label, s.line.begin(), s.line.end(), s.part->ended});
        return;
    }
    // One program runs on into the next.
    close_all(s);
    s.called_numbers.insert(label);
    program::Call call;
    call.shares_parameters = true;
    call.name = s.build().name("O" + label);
    s.build().begin_block();
    call_program(s, std::move(call), begin);
    s.build().control(StatementKind::return_, 0, begin, s.line.behind());
    s.part->ended = true;
}

void call_program(State& s, program::Call call, std::uint32_t begin) {
    call.where = s.build().span(begin, s.line.behind());
    if (call.kind == program::CallKind::by_name)
        s.number_calls.push_back({s.names.text(call.name).substr(1), call.shares_parameters, call.where});
    s.unit().calls.push_back(std::move(call));
    s.build().control(StatementKind::call, s.unit().calls.size() - 1, begin, s.line.behind());
}

int call_number(const State& s) {
    if (s.line.peek() != 'M') return 0;
    std::size_t k = 1;
    int n = 0;
    for (; base::is_digit(s.line.peek(k)) && n < 1000; ++k) n = n * 10 + (s.line.peek(k) - '0');
    return n == 98 || n == 99 ? n : 0;
}

namespace {

/// The program number of M98 P.
void take_target(State& s, const BlockWord& p, program::Call& call) {
    if (!p.value.is_literal()) {
        call.kind = program::CallKind::indirect;
        call.target = p.value.expr;
        s.calls_any_number = true;
        return;
    }
    const auto n = as_integer(p.value);
    if (!n || *n < 0) return fail(s, p.begin, p.end, "the number of a program is a whole one");
    call.name = s.build().name("O" + std::to_string(*n));
    s.called_numbers.insert(std::to_string(*n));
}

void skip_number(State& s) {
    s.line.step();
    while (base::is_digit(s.line.peek())) s.line.step();
}

}  // namespace

void read_m98(State& s) {
    const std::uint32_t begin = s.line.here();
    skip_number(s);
    const std::uint32_t end = s.line.behind();
    read_words(s);
    if (s.failed) return;
    const auto p = take_letter(s, Code::p), l = take_letter(s, Code::l);
    if (!p) return fail(s, begin, end, "M98 does not say which program", "write M98 P1000");
    if (!s.words.empty())
        return fail(s, s.words.front().begin, s.words.front().end, "only P and L may stand beside M98");
    program::Call call;
    call.shares_parameters = true;
    if (l) call.passes = as_expr(s, l->value);
    take_target(s, *p, call);
    if (s.failed) return;
    s.build().begin_block(s.skip);
    call_program(s, std::move(call), begin);
}

void read_m99(State& s) {
    const std::uint32_t begin = s.line.here();
    skip_number(s);
    read_words(s);
    if (s.failed) return;
    if (!s.words.empty()) return fail(s, s.words.front().begin, s.words.front().end, "M99 stands alone in its block");
    if (s.part->kind == Part::Kind::o_sub)
        return fail(s, begin, begin + 3, "o" + base::as_utf8(s.part->label) + " sub ends with endsub, not with M99");
    s.build().begin_block(s.skip);
    if (s.part->kind == Part::Kind::program_number) {
        assign_returned(s, no_expr, begin);
        s.build().control(StatementKind::return_, 0, begin, s.line.behind());
    } else {
        emit_comment(s);  // it acts before the program begins anew
        if (!s.words.empty()) {
            s.build().statement(StatementKind::block, begin);
            s.build().word(Code::comment, program::Form::index, s.words.front().payload, s.words.front().begin,
                           s.words.front().end);
            s.build().end_statement(s.line.behind());
            s.words.clear();
        }
        program::Jump jump;
        jump.direction = program::JumpDirection::start;
        s.unit().jumps.push_back(jump);
        s.build().control(StatementKind::jump, s.unit().jumps.size() - 1, begin, s.line.behind());
    }
    note_end(s, 99);
}

void check_styles(State& s) {
    std::map<std::string, base::Span> numbers, subs;
    for (const ProgramNumber& n : s.numbers) numbers.emplace(n.label, base::Span{s.file, n.begin, n.behind});
    for (const Part& p : s.parts)
        if (p.kind == Part::Kind::o_sub) subs.emplace(p.label, p.word);
    for (const NumberCall& call : s.number_calls) {
        const auto sub = subs.find(call.label), number = numbers.find(call.label);
        const bool is_sub = sub != subs.end(), is_number = number != numbers.end();
        if (is_sub == is_number || is_sub != call.by_m98) continue;
        const std::string label = base::as_utf8(call.label), line = std::to_string(s.sources.position(call.where).line);
        base::Diagnostic d;
        d.code = base::codes::syntax;
        d.where = is_sub ? sub->second : number->second;
        d.text = is_sub ? "M98 of line " + line + " calls o" + label + " sub, which only o" + label + " call can call"
                        : "o" + label + " call of line " + line + " calls the program O" + label +
                              ", which only M98 can call";
        s.diagnostics.add(std::move(d));
    }
}

void note_end(State& s, std::uint16_t m) {
    if ((m != 2 && m != 30 && m != 99) || s.skip != 0 || s.failed) return;
    if (!s.part->opened.empty() || s.part->kind == Part::Kind::o_sub) return;
    s.part->ended = true;
}

void end_text(State& s) {
    if (s.part->kind == Part::Kind::o_sub) {
        close_all(s);
        complain_about_end(*s.part);
        s.part->unit.end = static_cast<std::uint32_t>(s.text.size());
        s.part = s.part->outer;
    }
    close_all(s);
}

}  // namespace obrys::read::rs274
