/// Macro statements: what begins with # or a word, and prints. Source: FANUC series 16i operator's manual B-63684EN,
/// 16; Haas mill operator's manual 96-8000, page 116 (DPRNT).

#include "read/rs274/fanuc/state.hpp"

namespace obrys::read::rs274 {

using program::Function;
using program::Operator;

namespace {

/// The number of `#123=`; nothing where another thing stands here.
std::optional<std::uint32_t> assigned_number(const FanucState& s) {
    std::size_t k = 1;
    std::uint32_t n = 0;
    for (; base::is_digit(s.line.peek(k)) && k < 8; ++k) n = n * 10 + static_cast<std::uint32_t>(s.line.peek(k) - '0');
    return k > 1 && s.line.peek(k) == '=' ? std::optional(n) : std::nullopt;
}

void read_assignments(FanucState& s) {
    if (const auto n = assigned_number(s); n && assign_system(s, *n)) return;
    s.build().statement(StatementKind::block, s.line.begin());
    while (!s.failed && s.line.peek() == '#') {
        const std::uint32_t begin = s.line.here();
        s.operators = 0;
        const ExprId target = read_parameter(s, true);
        if (s.failed) break;
        if (!s.line.take('=')) {
            fail_here(s, "expected = behind the parameter, found " + here(s), "write #1=5");
            break;
        }
        const ExprId value = read_expression(s);
        if (s.failed || value == no_expr) break;
        s.build().assign(target, value, begin, s.line.behind());
        while (s.line.peek() == '(') static_cast<void>(take_comment(s));
        s.line.take(',');
    }
    if (!s.failed && !s.line.at_end()) fail_here(s, here(s) + " cannot stand behind an assignment");
    if (!s.failed) s.build().end_statement(s.line.end());
}

/// Text and values of DPRNT: `*` is a blank, `#1[53]` a value with three decimals.
ExprId print_text(FanucState& s) {
    program::Builder& b = s.build();
    ExprId whole = no_expr;
    const auto add = [&](ExprId e, std::uint32_t begin) {
        whole = whole == no_expr ? e : b.binary(Operator::concat, whole, e, begin, s.line.behind());
    };
    std::string piece;
    std::uint32_t begin = s.line.here();
    const auto flush = [&] {
        if (!piece.empty()) add(b.text(base::as_utf8(piece), begin, s.line.behind()), begin);
        piece.clear();
    };
    while (!s.failed && !s.line.at_end() && s.line.peek() != ']') {
        if (piece.empty()) begin = s.line.here();
        if (s.line.peek() != '#') {
            piece += s.line.peek() == '*' ? ' ' : s.line.peek();
            s.line.step();
            continue;
        }
        flush();
        const std::uint32_t at = s.line.here();
        const ExprId value = read_parameter(s, false);
        if (s.failed) return no_expr;
        int decimals = 3;
        if (s.line.peek() == '[' && base::is_digit(s.line.peek(1)) && base::is_digit(s.line.peek(2)) &&
            s.line.peek(3) == ']') {
            decimals = s.line.peek(2) - '0';
            s.line.step(4);
        }
        const ExprId places = b.number(decimals, true, at, s.line.behind());
        add(b.function(Function::to_text, {value, places}, at, s.line.behind()), at);
    }
    flush();
    return whole == no_expr ? b.text({}, begin, begin) : whole;
}

void read_print(FanucState& s) {
    const std::uint32_t begin = s.line.begin();
    if (!s.line.take('[')) return fail_here(s, "expected [ behind DPRNT, found " + here(s));
    const ExprId text = print_text(s);
    if (s.failed) return;
    if (!s.line.take(']')) return fail(s, begin, s.line.end(), "the text of DPRNT is not closed", "add ]");
    program::ProcedureCall call;
    call.procedure = program::Procedure::print;
    call.arguments = {text};
    call.where = s.build().span(begin, s.line.end());
    s.unit().procedures.push_back(std::move(call));
    add_control(s, StatementKind::procedure, s.unit().procedures.size() - 1);
}

/// The word with what stands in its brackets.
void ignore_statement(FanucState& s, std::string_view word) {
    s.build().ignored(word, s.line.begin(), s.line.end());
    const std::size_t bracket = s.line.rest().rfind(']');
    const bool has_text = word == "BPRNT" || word == "SETVN";
    s.line.step(has_text && bracket != std::string_view::npos ? bracket + 1 : word.size());
}

bool is_loop_word(const FanucState& s, std::string_view word) {
    return s.line.rest().starts_with(word) && base::is_digit(s.line.peek(word.size()));
}

}  // namespace

bool read_macro_statement(FanucState& s) {
    while (s.line.peek() == '(') static_cast<void>(take_comment(s));
    if (s.line.at_end()) return true;
    if (s.line.peek() == '#') return read_assignments(s), true;
    if (s.line.rest().starts_with("IF[")) return s.line.step(2), read_if(s), true;
    if (s.line.take("WHILE")) return read_while(s), true;
    if (s.line.take("GOTO")) return read_goto(s, no_expr), true;
    if (is_loop_word(s, "DO")) return s.line.step(2), read_do(s), true;
    if (is_loop_word(s, "END")) return s.line.step(3), read_end(s), true;
    if (s.line.take("ENDIF")) return read_endif(s), true;
    if (s.line.take("ELSE")) return read_else(s), true;
    if (s.line.take("DPRNT")) return read_print(s), true;
    for (const std::string_view word : {"POPEN", "PCLOS", "BPRNT", "SETVN"})
        if (s.line.rest().starts_with(word)) return ignore_statement(s, word), true;
    return false;
}

}  // namespace obrys::read::rs274
