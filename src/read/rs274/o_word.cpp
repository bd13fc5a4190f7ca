#include <array>

#include "base/whole.hpp"

#include "read/rs274/state.hpp"

namespace obrys::read::rs274 {

namespace {

constexpr std::size_t most_arguments = 30;

enum class Keyword : std::uint8_t {
    none,
    program,  ///< `O1234` alone
    sub,
    endsub,
    call,
    do_,
    while_,
    repeat,
    if_,
    elseif,
    else_,
    endif,
    break_,
    continue_,
    endwhile,
    endrepeat,
    return_,
};
struct KeywordName {
    std::string_view text;
    Keyword keyword;
};
/// Longer ones before their beginnings.
constexpr std::array keywords{
    KeywordName{"SUB", Keyword::sub},
    KeywordName{"ENDSUB", Keyword::endsub},
    KeywordName{"CALL", Keyword::call},
    KeywordName{"DO", Keyword::do_},
    KeywordName{"WHILE", Keyword::while_},
    KeywordName{"REPEAT", Keyword::repeat},
    KeywordName{"IF", Keyword::if_},
    KeywordName{"ELSEIF", Keyword::elseif},
    KeywordName{"ELSE", Keyword::else_},
    KeywordName{"ENDIF", Keyword::endif},
    KeywordName{"BREAK", Keyword::break_},
    KeywordName{"CONTINUE", Keyword::continue_},
    KeywordName{"ENDWHILE", Keyword::endwhile},
    KeywordName{"ENDREPEAT", Keyword::endrepeat},
    KeywordName{"RETURN", Keyword::return_},
};

/// The label of an o-word: a name in `<>`, a number, or an expression.
struct Label {
    std::string text;  ///< "100", "<FOO>"; empty where it is computed
    ExprId expr = no_expr;
};

bool read_label(State& s, Label& label, std::uint32_t begin) {
    s.line.step();
    if (s.line.peek() == '<') {
        const auto name = read_name(s);
        if (name) label.text = "<" + *name + ">";
        return name.has_value();
    }
    const Value v = read_due_value(s, "O", begin);
    if (s.failed) return false;
    if (v.is_literal()) {
        const auto n = as_integer(v);
        if (!n) fail(s, begin, v.end, "the number of an o-word is a whole one");
        if (n) label.text = std::to_string(*n);
        return n.has_value();
    }
    label.expr = v.expr;
    const auto x = constant(s.unit(), v.expr);
    if (const auto n = x ? base::whole<int>(*x) : std::nullopt) label.text = std::to_string(*n);
    return true;
}

bool at_comment_or_end(const State& s) { return s.line.at_end() || s.line.peek() == '(' || s.line.peek() == ';'; }

Keyword read_keyword(State& s) {
    for (const KeywordName& k : keywords)
        if (s.line.take(k.text)) return k.keyword;
    return at_comment_or_end(s) ? Keyword::program : Keyword::none;
}

/// `[…]` that a keyword needs.
ExprId read_condition(State& s, std::string_view word) {
    if (s.line.peek() != '[') {
        fail_here(s, "expected [ behind " + std::string(word) + ", found " + here(s));
        return no_expr;
    }
    s.operators = 0;
    return read_bracket(s);
}

/// Nothing but comments may follow.
bool check_rest(State& s) {
    while (!s.failed && !s.line.at_end()) {
        if (s.line.peek() != '(' && s.line.peek() != ';')
            fail_here(s, "only a comment may stand behind an o-word, found " + here(s));
        else
            read_comment(s);
    }
    return !s.failed;
}

void read_call(State& s, const Label& label, std::uint32_t begin) {
    program::Call call;
    while (!s.failed && (s.line.peek() == '[' || s.line.peek() == '(')) {
        if (s.line.peek() == '(') {
            read_comment(s);
            continue;
        }
        if (call.arguments.size() == most_arguments) return fail_here(s, "a call has 30 arguments at most");
        s.operators = 0;
        call.arguments.push_back(read_bracket(s));
    }
    call.has_arguments = !call.arguments.empty();
    if (!check_rest(s)) return;
    if (label.text.empty()) {
        call.kind = program::CallKind::indirect;
        call.target = label.expr;
    } else {
        call.name = s.build().name("O" + label.text);
    }
    call_program(s, std::move(call), begin);
}

void read_end(State& s, const Label& label, Keyword keyword, std::uint32_t begin) {
    if (!check_rest(s)) return;
    switch (keyword) {
        case Keyword::else_: return read_else(s, label.text, begin);
        case Keyword::endif: return close_structure(s, StatementKind::if_, label.text, no_expr, "endif", begin);
        case Keyword::endwhile:
            return close_structure(s, StatementKind::while_, label.text, no_expr, "endwhile", begin);
        case Keyword::endrepeat:
            return close_structure(s, StatementKind::repeat_count, label.text, no_expr, "endrepeat", begin);
        default: return leave_structure(s, label.text, keyword == Keyword::continue_, begin);
    }
}

void read_while(State& s, const Label& label, std::uint32_t begin) {
    const ExprId condition = read_condition(s, "while");
    (void)check_rest(s);
    if (!has_opened(s, StatementKind::repeat_, label.text))
        return open_structure(s, StatementKind::while_, label.text, condition, begin);
    const ExprId asked = s.failed ? s.build().number(0, true, begin, s.line.behind()) : condition;
    const ExprId done = s.build().unary(program::Operator::logical_not, asked, begin, s.line.behind());
    close_structure(s, StatementKind::repeat_, label.text, done, "while", begin);
}

void read_return_line(State& s, const Label& label, bool ends, std::uint32_t begin) {
    s.operators = 0;
    const ExprId value = s.line.peek() == '[' ? read_bracket(s) : no_expr;
    if (check_rest(s) || ends) read_return(s, label.text, value, ends, begin);
}

void read_structure(State& s, const Label& label, Keyword keyword, std::uint32_t begin) {
    s.build().begin_block(s.skip);
    if (keyword == Keyword::call) return read_call(s, label, begin);
    if (label.text.empty()) return fail(s, begin, s.line.behind(), "a computed label of an o-word is not run");
    switch (keyword) {
        case Keyword::do_:
            (void)check_rest(s);
            return open_structure(s, StatementKind::repeat_, label.text, no_expr, begin);
        case Keyword::while_: return read_while(s, label, begin);
        case Keyword::repeat:
        case Keyword::if_: {
            const bool is_if = keyword == Keyword::if_;
            const ExprId condition = read_condition(s, is_if ? "if" : "repeat");
            (void)check_rest(s);
            return open_structure(s, is_if ? StatementKind::if_ : StatementKind::repeat_count, label.text, condition,
                                  begin);
        }
        case Keyword::elseif: {
            const ExprId condition = read_condition(s, "elseif");
            (void)check_rest(s);
            return read_elseif(s, label.text, s.failed ? no_expr : condition, begin);
        }
        case Keyword::endsub:
        case Keyword::return_: return read_return_line(s, label, keyword == Keyword::endsub, begin);
        default: return read_end(s, label, keyword, begin);
    }
}

}  // namespace

void read_o_line(State& s) {
    const std::uint32_t begin = s.line.here();
    Label label;
    if (!read_label(s, label, begin)) return;
    const Keyword keyword = read_keyword(s);
    const bool definition = keyword == Keyword::sub || keyword == Keyword::program;
    if (s.part->ended && !definition) return;
    if (keyword == Keyword::none)
        return fail_here(s, "no o-word begins here: " + here(s), "write o100 sub, call, if, while, do or repeat");
    if (!definition) return read_structure(s, label, keyword, begin);
    if (label.text.empty()) return fail(s, begin, s.line.behind(), "the label of a subprogram is a number or a name");
    if (!check_rest(s)) return;
    if (keyword == Keyword::sub) return begin_sub(s, label.text, begin);
    read_program_number(s, label.text, begin);
}

}  // namespace obrys::read::rs274
