/// Word by word into the block.

#include <cmath>

#include "base/codes.hpp"
#include "base/whole.hpp"
#include "interp/calls/calls.hpp"

namespace obrys::interp {

using program::Form;
using program::Word;
namespace codes = base::codes;

namespace {

/// Value of a word that needs a number.
double word_value(Reckoning& run, const Word& w) {
    if (program::is_literal(w)) return run.unit().literal(w);
    if (program::form_of(w) == Form::expression) return number(run, static_cast<ExprId>(w.payload));
    return 0;
}

/// Number of an M or H function; nothing after a complaint. M functions have whole numbers without a sign. H functions
/// may have any value (SINUMERIK: REAL), of which the stream has the whole part.
std::optional<int> function_number(Saying& run, Code letter, const base::Span& where, double v) {
    constexpr double whole_enough = 1e-4;
    constexpr int most = 99'999'999;
    if (std::isnan(v)) {
        unchecked(run, codes::unknown_value, where, "which function this is depends on a value that is not known");
        return std::nullopt;
    }
    const bool is_whole = std::abs(v - std::round(v)) < whole_enough;
    if (letter == Code::h) {
        const auto n = base::cut<int>(is_whole ? std::round(v) : v);
        if (!n) alarm(run, codes::value_range, where, "no function has this number: it is too large");
        if (n && !is_whole)
            assume(run, where,
                   "H" + printed(Value::real(v)) + " is told as H" + std::to_string(*n) +
                       ": what the machine does with it is not followed");
        return n;
    }
    const auto n = is_whole ? base::whole<int>(std::round(v), 0, most) : std::nullopt;
    if (!n) alarm(run, codes::value_range, where, "no function has this number: a whole number without a sign is due");
    return n;
}

void add_function(Moving& run, Code letter, const base::Span& where, double v) {
    const auto n = function_number(run, letter, where, v);
    if (n && letter == Code::h) run.block.h.push_back({'H', *n});
    if (n && letter != Code::h) run.block.m.push_back(*n);
}

void tool_word(Moving& run, const Word& w) {
    BlockWords& b = run.block;
    if (program::form_of(w) == Form::expression) {
        const Value v = evaluate(run, static_cast<ExprId>(w.payload));
        if (run.stopped) return;
        b.tool_named = v.is_text() && !v.is_unknown();
        if (b.tool_named) b.tool_name = v.as_text();
        b.put(Code::tool, v.number);
        return;
    }
    b.put(Code::tool, word_value(run, w));
}

bool complained(const Saying& run, const base::Span& where) {
    for (const base::Diagnostic& d : run.diagnostics->all())
        if (d.code == codes::syntax && d.where.file == where.file && d.where.begin == where.begin) return true;
    return false;
}

void problem_word(Saying& run, const Word& w) {
    const program::Problem& p = run.unit().problems[static_cast<std::size_t>(w.payload)];
    if (!p.reason.empty() && complained(run, p.where)) {  // the reader has said it already
        if (!run.traits->bad_block_stops || run.stopped) return;
        run.stopped = true;
        run.ending = Ending::alarm;
        return;
    }
    if (program::code_of(w) == Code::unknown)
        unchecked(run, codes::unknown_word, p.where,
                  "\"" + p.text + "\" is not a word of this control" + (p.reason.empty() ? "" : ": " + p.reason),
                  "check the spelling; if a machine builder defined it, its effect is not known here");
    else
        unchecked(run, codes::unsupported, p.where, p.text + " is not run" + (p.reason.empty() ? "" : ": " + p.reason));
}

/// Evaluates an assignment that takes effect behind the block's last expression.
void assign_later(Moving& run, const program::Assign& a) {
    const program::Expr& target = run.unit().exprs[a.target];
    PendingAssign p{&a, 0, 0};
    if (target.kind == program::ExprKind::parameter) p.index = target.a;
    if (target.kind == program::ExprKind::parameter_at) p.index = number(run, target.a);
    if (!run.stopped) p.value = number(run, a.value);
    if (!run.stopped) run.block.pending.push_back(p);
}

}  // namespace

void take_effect(Moving& run) {
    for (const PendingAssign& p : run.block.pending)
        if (!run.stopped) assign_value(run, *p.assign, p.index, p.value);
    run.block.pending.clear();
}

namespace {

/// F, S, T and M act, before what follows in the block.
void act(Moving& run) {
    take_effect(run);
    if (run.stopped) return;
    technology(run);
    run.block.acted = true;
}

}  // namespace

void put_expression(Calling& run, const program::Statement& s, const Word& w) {
    const auto id = static_cast<ExprId>(w.payload);
    const double v = number(run, id);
    if (std::isnan(v) && run.clock_asked && run.capture == nullptr)
        unchecked_once(run, codes::unknown_value, run.unit().span(s, w),
                       "this word depends on a value that is not known: the program asks for the date or the time");
    run.block.put(program::code_of(w), as_taken(run, program::code_of(w), v), reference_of(run.unit().exprs[id]));
}

void gather(Calling& run, const program::Statement& s, const Word& w) {
    const Code code = program::code_of(w);
    if (program::form_of(w) == Form::expression && is_empty(run, static_cast<ExprId>(w.payload))) return;
    switch (code) {
        case Code::modal: modal_word(run, w); return;
        case Code::assign: {
            const program::Assign& a = run.unit().assigns[static_cast<std::size_t>(w.payload)];
            return run.traits->assigns_together ? assign_later(run, a) : assign(run, a);
        }
        case Code::act: return act(run);
        case Code::comment:
            return emit(run, cl::Comment{run.unit().texts[static_cast<std::size_t>(w.payload)], false, false});
        case Code::unsupported:
        case Code::unknown: problem_word(run, w); return;
        case Code::m:
        case Code::h: return add_function(run, code, run.unit().span(s, w), word_value(run, w));
        case Code::tool: tool_word(run, w); return;
        case Code::named_axis:
            named_axis(run, run.unit().named[static_cast<std::size_t>(w.payload)], run.unit().span(s, w));
            return;
        case Code::named_value: named_value(run, s, w); return;
        case Code::control: return;
        default: break;
    }
    if (program::is_literal(w)) {
        run.block.put(code, as_taken(run, code, run.unit().literal(w)));
        return;
    }
    if (program::form_of(w) == Form::expression) return put_expression(run, s, w);
    run.block.put(code, 0);
}

}  // namespace obrys::interp
