#include <algorithm>

#include "read/rs274/state.hpp"

namespace obrys::read::rs274 {

namespace {

std::uint32_t next_statement(const State& s) { return static_cast<std::uint32_t>(s.unit().statements.size()); }

program::Branch& branch_of(const State& s, std::uint32_t statement) {
    program::Unit& unit = s.unit();
    return unit.branches[static_cast<std::size_t>(unit.words[unit.statements[statement].first].payload)];
}

/// A statement with its entry among the branches; its number.
std::uint32_t add_branch(State& s, StatementKind kind, ExprId condition, std::uint32_t target, std::uint32_t begin,
                         std::uint32_t end) {
    s.unit().branches.push_back({condition, target});
    s.build().control(kind, s.unit().branches.size() - 1, begin, end);
    return next_statement(s) - 1;
}

std::string_view word_of(StatementKind opener) {
    switch (opener) {
        case StatementKind::if_: return "if";
        case StatementKind::while_: return "while";
        case StatementKind::repeat_: return "do";
        default: return "repeat";
    }
}
std::string_view end_word_of(StatementKind opener) {
    switch (opener) {
        case StatementKind::if_: return "endif";
        case StatementKind::while_: return "endwhile";
        case StatementKind::repeat_: return "while";
        default: return "endrepeat";
    }
}
StatementKind closer_of(StatementKind opener) {
    switch (opener) {
        case StatementKind::if_: return StatementKind::endif;
        case StatementKind::while_: return StatementKind::endwhile;
        case StatementKind::repeat_: return StatementKind::until;
        default: return StatementKind::end_repeat_count;
    }
}

std::string shown(const std::string& label) { return "o" + base::as_utf8(label); }

Opened* find_opened(const State& s, const std::string& label) {
    const auto found = s.part->opened_by_label.find(label);
    const bool is_open = found != s.part->opened_by_label.end() && !found->second.empty();
    return is_open ? &s.part->opened[found->second.back()] : nullptr;
}

void push_opened(State& s, Opened o) {
    s.part->opened_by_label[o.label].push_back(s.part->opened.size());
    s.part->opened.push_back(std::move(o));
}

Opened pop_opened(State& s) {
    Opened o = std::move(s.part->opened.back());
    s.part->opened.pop_back();
    s.part->opened_by_label[o.label].pop_back();
    return o;
}

void tie_if(State& s, const Opened& o, std::uint32_t begin, std::uint32_t end) {
    for (std::size_t i = o.openers.size(); i-- > 0;) {
        const std::uint32_t self = add_branch(s, StatementKind::endif, no_expr, program::no_target, begin, end);
        const bool has_else = i < o.elses.size();
        branch_of(s, o.openers[i]).target = has_else ? o.elses[i] + 1 : self + 1;
        if (has_else) branch_of(s, o.elses[i]).target = self;
    }
}

/// The closing statement of a loop, its jumps included. `once`: the body is not repeated.
void tie_loop(State& s, const Opened& o, ExprId condition, bool once, std::uint32_t begin, std::uint32_t end) {
    const std::uint32_t self = next_statement(s);
    add_branch(s, closer_of(o.kind), condition, once ? self + 1 : o.openers.front(), begin, end);
    if (o.kind != StatementKind::repeat_) branch_of(s, o.openers.front()).target = self + 1;
    std::vector<program::Jump>& jumps = s.unit().jumps;
    const bool is_while = o.kind == StatementKind::while_;
    for (const std::size_t j : o.breaks) {
        jumps[j].target = self + 1;
        jumps[j].leaves = is_while ? program::Leaves::while_ : program::Leaves::do_;
    }
    for (const std::size_t j : o.continues) {
        jumps[j].target = self;
        jumps[j].leaves = is_while ? program::Leaves::while_pass : program::Leaves::do_pass;
        jumps[j].has_break = !o.breaks.empty() && o.breaks.back() > j;
    }
    if (is_while) branch_of(s, o.openers.front()).has_break = !o.breaks.empty();
}

void tie(State& s, const Opened& o, ExprId condition, bool once, std::uint32_t begin, std::uint32_t end) {
    if (o.kind == StatementKind::if_) return tie_if(s, o, begin, end);
    tie_loop(s, o, condition, once, begin, end);
}

/// Closes the innermost structure, which has no end of its own, and says so; its body is run once.
void close_missing(State& s) {
    const Opened o = pop_opened(s);
    const bool runs_on = o.kind == StatementKind::repeat_;  // LinuxCNC looks for no end of a do
    base::Diagnostic d;
    d.severity = runs_on ? base::Severity::note : base::Severity::error;
    d.code = runs_on ? base::codes::assumption : base::codes::unclosed;
    d.where = o.word;
    d.text = shown(o.label) + " " + std::string(word_of(o.kind)) + " without " + shown(o.label) + " " +
             std::string(end_word_of(o.kind)) + (runs_on ? ": its blocks are run once" : "");
    d.remedy = "add it where the structure ends";
    s.part->diagnostics.add(std::move(d));
    const std::uint32_t at = s.line.begin();
    const ExprId done = o.kind == StatementKind::repeat_ ? s.build().number(1, true, at, at) : no_expr;
    tie(s, o, done, true, at, at);
}

/// The structure of that label, with what was opened inside it closed; null after a complaint.
Opened* find_for(State& s, const std::string& label, StatementKind kind, std::string_view word, std::uint32_t begin) {
    Opened* o = find_opened(s, label);
    if (o == nullptr) {
        fail(s, begin, s.line.behind(),
             shown(label) + " " + std::string(word) + " without " + shown(label) + " " + std::string(word_of(kind)));
        return nullptr;
    }
    if (o->kind != kind) {
        fail(s, begin, s.line.behind(),
             shown(label) + " " + std::string(word) + " belongs to no " + std::string(word_of(kind)) + ": " +
                 shown(label) + " is the label of a " + std::string(word_of(o->kind)));
        return nullptr;
    }
    while (&s.part->opened.back() != o) close_missing(s);
    return o;
}

/// The branch that a structure is in: its first statement and which of its branches. No other one has that number, and
/// the branches around it go without saying.
std::uint64_t branch_at(const Opened& o) { return std::uint64_t{o.openers.front()} << 32 | o.elses.size(); }

/// A label belongs to one structure, where the run has come by that before: it stands in the same branch, or in one
/// around it. Elsewhere the run knows (Branch::same_label, which is given back; 0: nobody has had the label).
std::uint32_t claim(State& s, const std::string& label, std::uint32_t begin) {
    const std::vector<Opened>& around = s.part->opened;
    const LabelUse here{begin, next_statement(s), around.size(), around.empty() ? 0 : branch_at(around.back())};
    const auto [at, is_new] = s.part->labels.try_emplace(label, here);
    if (is_new) return 0;
    const LabelUse& first = at->second;
    if (first.depth > around.size() || (first.depth > 0 && first.branch != branch_at(around[first.depth - 1])))
        return branch_of(s, first.statement).same_label = first.statement + 1;
    const std::uint32_t line = s.sources.position(s.file, first.begin).line;
    fail(s, begin, s.line.behind(),
         "the label " + shown(label) + " belongs to the structure of line " + std::to_string(line) + " already",
         "give this one a label of its own");
    return 0;
}

}  // namespace

bool has_opened(const State& s, StatementKind kind, const std::string& label) {
    const Opened* o = find_opened(s, label);
    return o != nullptr && o->kind == kind;
}

void open_structure(State& s, StatementKind kind, const std::string& label, ExprId condition, std::uint32_t begin) {
    const std::uint32_t end = s.line.behind();
    const std::uint32_t same_label = s.failed ? 0 : claim(s, label, begin);
    if (s.failed && kind != StatementKind::repeat_) condition = s.build().number(0, true, begin, end);
    Opened o;
    o.kind = kind;
    o.label = label;
    o.word = s.build().span(begin, end);
    o.openers.push_back(add_branch(s, kind, condition, program::no_target, begin, end));
    branch_of(s, o.openers.front()).same_label = same_label;
    push_opened(s, std::move(o));
}

void read_else(State& s, const std::string& label, std::uint32_t begin) {
    Opened* o = find_for(s, label, StatementKind::if_, "else", begin);
    if (o == nullptr) return;
    if (o->has_else) return fail(s, begin, s.line.behind(), "a second else for " + shown(label) + " if");
    o->has_else = true;
    o->elses.push_back(add_branch(s, StatementKind::else_, no_expr, program::no_target, begin, s.line.behind()));
}

void read_elseif(State& s, const std::string& label, ExprId condition, std::uint32_t begin) {
    Opened* o = find_for(s, label, StatementKind::if_, "elseif", begin);
    if (o == nullptr) return;
    if (o->has_else) return fail(s, begin, s.line.behind(), "elseif behind the else of " + shown(label));
    const std::uint32_t end = s.line.behind();
    if (condition == no_expr) condition = s.build().number(0, true, begin, end);
    o->elses.push_back(add_branch(s, StatementKind::else_, no_expr, program::no_target, begin, end));
    o->openers.push_back(add_branch(s, StatementKind::if_, condition, program::no_target, begin, end));
}

void close_structure(State& s, StatementKind kind, const std::string& label, ExprId condition, std::string_view word,
                     std::uint32_t begin) {
    if (find_for(s, label, kind, word, begin) == nullptr) return;
    const Opened o = pop_opened(s);
    tie(s, o, condition, false, begin, s.line.behind());
}

void leave_structure(State& s, const std::string& label, bool goes_on, std::uint32_t begin) {
    Opened* o = find_opened(s, label);
    const std::string word = shown(label) + (goes_on ? " continue" : " break");
    if (o == nullptr || (o->kind != StatementKind::while_ && o->kind != StatementKind::repeat_))
        return fail(
            s, begin, s.line.behind(),
            word + " belongs to no while or do" + (o == nullptr ? "" : " but to " + std::string(word_of(o->kind))));
    program::Jump jump;
    jump.direction = program::JumpDirection::either;
    s.unit().jumps.push_back(jump);
    const std::size_t at = s.unit().jumps.size() - 1;
    (goes_on ? o->continues : o->breaks).push_back(at);
    s.build().control(StatementKind::jump, at, begin, s.line.behind());
}

void close_all(State& s) {
    s.build().begin_block();
    while (!s.part->opened.empty()) close_missing(s);
}

}  // namespace obrys::read::rs274
