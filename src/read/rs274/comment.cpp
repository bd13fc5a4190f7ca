#include <algorithm>
#include <array>

#include "read/rs274/state.hpp"

namespace obrys::read::rs274 {

using program::Procedure;

namespace {

constexpr int decimals_at_first = 6, decimals_of_f = 4;

/// Comments that do something: LinuxCNC manual "G-code overview", messages, logging and debug messages.
struct Active {
    std::string_view begin;  ///< lower case; the text follows
    Procedure procedure;
    bool expands;   ///< parameters in the text are shown by their values
    bool has_text;  ///< else `begin` is the whole comment
    bool is_shown;  ///< goes into the stream as a comment too
};
constexpr std::array actives{
    Active{"msg,", Procedure::message, false, true, false},
    Active{"debug,", Procedure::message, true, true, false},
    Active{"print,", Procedure::print, true, true, false},
    Active{"log,", Procedure::log, true, true, false},
    Active{"logopen,", Procedure::log_open, false, true, false},
    Active{"logappend,", Procedure::log_append, false, true, false},
    Active{"logclose", Procedure::log_close, false, false, false},
    Active{"abort,", Procedure::abort, true, true, false},
    Active{"probeopen ", Procedure::probe_log_open, false, true, true},
    Active{"probeclose", Procedure::probe_log_close, false, false, true},
};
constexpr std::array<std::string_view, 3> scripts{"py,", "pyrun,", "pyreload"};

std::string lower(std::string_view s) {
    std::string out(s);
    std::transform(out.begin(), out.end(), out.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    return out;
}

/// The text of `(debug, …)` as an expression: pieces and values chained.
class Expansion {
public:
    Expansion(State& s, std::string_view text, std::uint32_t begin, std::uint32_t end)
        : s_(s), text_(text), begin_(begin), end_(end) {}

    ExprId run() {
        while (at_ < text_.size()) {
            if (text_[at_] == '%' && take_format()) continue;
            if (text_[at_] == '#' && take_parameter()) continue;
            plain_ += text_[at_++];
        }
        flush();
        return all_ == no_expr ? s_.build().text({}, begin_, end_) : all_;
    }

private:
    /// %.3f, %d and %f set how the values behind them are shown; of others only the sign is dropped where a point
    /// follows.
    bool take_format() {
        const std::string_view rest = text_.substr(at_ + 1);
        if (rest.starts_with('.')) {
            const bool good = rest.size() > 2 && base::is_digit(rest[1]) && rest[2] == 'f';
            if (good) decimals_ = rest[1] - '0';
            at_ += good ? 4 : 1;
            return true;
        }
        if (!rest.starts_with('d') && !rest.starts_with('f')) return false;
        decimals_ = rest[0] == 'd' ? 0 : decimals_of_f;
        at_ += 2;
        return true;
    }

    bool take_parameter() {
        const std::string_view rest = text_.substr(at_ + 1);
        if (!rest.empty() && base::is_digit(rest[0])) return take_numbered(rest);
        if (!rest.starts_with('<')) return false;
        const std::size_t close = rest.find('>');
        if (close == std::string_view::npos) return false;
        std::string name;
        for (const char c : rest.substr(1, close - 1))
            if (!base::is_blank(c)) name += base::upper(c);
        at_ += close + 2;
        chain_value(named(name));
        return true;
    }

    bool take_numbered(std::string_view rest) {
        std::size_t n = 0;
        while (n < rest.size() && base::is_digit(rest[n])) ++n;
        at_ += n + 1;
        const auto number = base::parse_integer(rest.substr(0, n));
        const auto count = static_cast<std::int64_t>(program::parameter_count(*s_.variant.traits));
        if (!number || *number >= count) {
            plain_ += "######";
            return true;
        }
        program::Expr e;
        e.kind = program::ExprKind::parameter;
        e.a = static_cast<std::uint32_t>(*number);
        chain_value(s_.build().add(e, begin_, end_));
        return true;
    }

    ExprId named(const std::string& name) {
        const auto known = std::find_if(s_.variant.predefined.begin(), s_.variant.predefined.end(),
                                        [&](const auto& p) { return p.text == name; });
        program::Expr e;
        e.kind = program::ExprKind::variable;
        e.a = s_.build().name(name);
        if (known != s_.variant.predefined.end()) {
            const ExprId query = s_.build().number(static_cast<double>(known->query), true, begin_, end_);
            e.kind = program::ExprKind::system;
            e.op = static_cast<std::uint8_t>(program::SystemVariable::state);
            e.a = s_.build().name("#<" + name + ">");
            s_.build().adopt(e, {query});
        }
        return s_.build().add(e, begin_, end_);
    }

    void chain(ExprId e) {
        all_ = all_ == no_expr ? e : s_.build().binary(program::Operator::concat, all_, e, begin_, end_);
    }
    void chain_value(ExprId value) {
        flush();
        const ExprId decimals = s_.build().number(decimals_, true, begin_, end_);
        chain(s_.build().function(program::Function::to_text, {value, decimals}, begin_, end_));
    }
    void flush() {
        if (plain_.empty()) return;
        chain(s_.build().text(base::as_utf8(plain_), begin_, end_));
        plain_.clear();
    }

    State& s_;
    std::string_view text_;
    std::uint32_t begin_ = 0, end_ = 0;
    std::size_t at_ = 0;
    int decimals_ = decimals_at_first;
    std::string plain_;
    ExprId all_ = no_expr;
};

void emit_procedure(State& s, const Active& active, std::string_view text) {
    const Comment c = s.comment;
    program::ProcedureCall call;
    call.procedure = active.procedure;
    call.where = s.build().span(c.begin, c.end);
    if (active.expands)
        call.arguments.push_back(Expansion(s, text, c.begin, c.end).run());
    else if (active.has_text)
        call.arguments.push_back(s.build().text(base::as_utf8(text), c.begin, c.end));
    s.unit().procedures.push_back(std::move(call));
    s.build().control(StatementKind::procedure, s.unit().procedures.size() - 1, c.begin, c.end);
}

void add_plain(State& s, std::string_view text) {
    s.unit().texts.push_back(base::as_utf8(text));
    BlockWord w;
    w.order = Order::comment;
    w.code = Code::comment;
    w.payload = static_cast<std::int32_t>(s.unit().texts.size() - 1);
    w.begin = s.comment.begin;
    w.end = s.comment.end;
    s.words.push_back(w);
}

}  // namespace

void emit_comment(State& s) {
    if (!s.comment.found) return;
    std::string_view text = s.text.substr(s.comment.begin + 1, s.comment.end - s.comment.begin - 2);
    while (!text.empty() && base::is_blank(text.front())) text.remove_prefix(1);
    if (s.variant.active_comments) {
        const std::string key = lower(text.substr(0, 16));
        for (const std::string_view script : scripts)
            if (key.starts_with(script))
                return add_problem(s, Code::unsupported, s.comment.begin, s.comment.end, "a script in Python");
        for (const Active& a : actives) {
            if (a.has_text ? !key.starts_with(a.begin) : lower(text) != a.begin) continue;
            if (a.is_shown) add_plain(s, text);
            return emit_procedure(s, a, text.substr(a.begin.size()));
        }
    }
    add_plain(s, text);
}

}  // namespace obrys::read::rs274
