#include "read/sinumerik/control.hpp"

namespace obrys::read::sinumerik {

using program::ExprId;
using program::no_expr;
using program::StatementKind;

namespace {

struct Pair {
    StatementKind opener, closer;
    std::string_view open_word, close_word;
};

constexpr Pair pairs[]{
    {StatementKind::if_, StatementKind::endif, "IF", "ENDIF"},
    {StatementKind::while_, StatementKind::endwhile, "WHILE", "ENDWHILE"},
    {StatementKind::for_, StatementKind::endfor, "FOR", "ENDFOR"},
    {StatementKind::loop_, StatementKind::endloop, "LOOP", "ENDLOOP"},
    {StatementKind::repeat_, StatementKind::until, "REPEAT", "UNTIL"},
};

const Pair& pair_of(StatementKind kind) {
    for (const Pair& p : pairs)
        if (p.opener == kind || p.closer == kind) return p;
    return pairs[0];
}

std::uint32_t next_statement(const State& s) { return static_cast<std::uint32_t>(s.unit.statements.size()); }

/// Entry of a control statement in its table.
std::uint32_t entry_of(const State& s, std::uint32_t statement) {
    return static_cast<std::uint32_t>(s.unit.words[s.unit.statements[statement].first].payload);
}

void set_target(State& s, std::uint32_t statement, std::uint32_t target) {
    const std::uint32_t entry = entry_of(s, statement);
    if (s.unit.statements[statement].kind == StatementKind::for_)
        s.unit.fors[entry].target = target;
    else
        s.unit.branches[entry].target = target;
}

void add_branch(State& s, StatementKind kind, ExprId condition, std::uint32_t target, const char* from) {
    s.unit.branches.push_back({condition, target});
    add_control(s, kind, s.unit.branches.size() - 1, from);
}

/// Adds the closing statement of `o` and ties both together. `once`: the body is not repeated.
void tie(State& s, const Opened& o, ExprId condition, bool once, const char* from) {
    const StatementKind closer = o.broken ? StatementKind::endif : pair_of(o.kind).closer;
    close_block(s);
    const std::uint32_t self = next_statement(s);
    if (closer == StatementKind::endfor) {
        s.unit.fors.push_back({no_expr, no_expr, no_expr, o.statement});
        add_control(s, closer, s.unit.fors.size() - 1, from);
        return set_target(s, o.statement, self);
    }
    add_branch(s, closer, condition,
               closer == StatementKind::endif ? program::no_target
               : once                         ? self + 1
                                              : o.statement,
               from);
    if (closer == StatementKind::endif && o.else_statement != program::no_target) {
        set_target(s, o.statement, o.else_statement + 1);
        set_target(s, o.else_statement, self);
    } else if (closer == StatementKind::endif || closer == StatementKind::endwhile) {
        set_target(s, o.statement, self + 1);
    }
}

/// Complains about an opener without end and closes it here; its body is run once.
void close_missing(State& s, const Opened& o, const char* from) {
    const Pair& p = pair_of(o.kind);
    base::Diagnostic d;
    d.code = base::codes::unclosed;
    d.where = o.word;
    d.text = std::string(p.open_word) + " without " + std::string(p.close_word);
    d.remedy = "add " + std::string(p.close_word) + " where it ends";
    s.diagnostics.add(std::move(d));
    const char* back = s.cursor.p;
    const bool had_statement = s.line_has_statement;
    s.cursor.p = from;
    tie(s, o, o.kind == StatementKind::repeat_ ? add_boolean(s, true, from) : no_expr, true, from);
    s.unit.statements.back().flags = 0;  // not in the text: it begins no block
    s.line_has_statement = had_statement;
    s.cursor.p = back;
}

/// True where an opener of this kind is open; what was opened inside it and not closed is closed now.
bool unwind_to(State& s, StatementKind opener, const char* from) {
    std::size_t i = s.opened.size();
    while (i > 0 && s.opened[i - 1].kind != opener) --i;
    if (i == 0) return false;
    while (s.opened.size() > i) {
        close_missing(s, s.opened.back(), from);
        s.opened.pop_back();
    }
    return true;
}

}  // namespace

ExprId add_boolean(State& s, bool value, const char* from) {
    program::Expr e;
    e.kind = program::ExprKind::boolean;
    e.a = value ? 1 : 0;
    return s.build.add(e, s.cursor.from(from), s.cursor.from(from));
}

void open_branch(State& s, StatementKind kind, ExprId condition, const char* from) {
    const std::string_view word = pair_of(kind).open_word;
    close_block(s);
    s.opened.push_back({kind, next_statement(s), program::no_target, s.span(from, from + word.size())});
    add_branch(s, kind, condition, program::no_target, from);
}

void open_for(State& s, program::For loop, const char* from) {
    close_block(s);
    s.opened.push_back({StatementKind::for_, next_statement(s), program::no_target, s.span(from, from + 3)});
    s.unit.fors.push_back(loop);
    add_control(s, StatementKind::for_, s.unit.fors.size() - 1, from);
}

void open_broken(State& s, StatementKind kind, const char* from) {
    const ExprId never = add_boolean(s, kind == StatementKind::repeat_, from);
    open_branch(s, kind == StatementKind::for_ ? StatementKind::if_ : kind, never, from);
    s.opened.back().kind = kind;
    s.opened.back().broken = kind == StatementKind::for_;
    s.opened.back().word = s.span(from, from + pair_of(kind).open_word.size());
}

void read_else(State& s, const char* from) {
    if (!unwind_to(s, StatementKind::if_, from)) return fail(s, from, s.cursor.p, "ELSE without IF");
    if (s.opened.back().else_statement != program::no_target)
        return fail(s, from, s.cursor.p, "a second ELSE for one IF");
    close_block(s);
    s.opened.back().else_statement = next_statement(s);
    add_branch(s, StatementKind::else_, no_expr, program::no_target, from);
}

void close_structure(State& s, StatementKind kind, ExprId condition, const char* from) {
    const Pair& p = pair_of(kind);
    if (!unwind_to(s, p.opener, from)) {
        const std::string open(p.open_word), close(p.close_word);
        return fail(s, from, from + p.close_word.size(), close + " without " + open,
                    "remove it, or add the " + open + " it belongs to");
    }
    const Opened o = s.opened.back();
    s.opened.pop_back();
    tie(s, o, condition, false, from);
}

void close_all(State& s) {
    close_block(s);
    s.line_begin = s.cursor.from(s.cursor.p);
    s.skip = 0;
    while (!s.opened.empty()) {
        close_missing(s, s.opened.back(), s.cursor.p);
        s.opened.pop_back();
    }
}

}  // namespace obrys::read::sinumerik
