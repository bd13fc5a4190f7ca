#include "read/sinumerik/expression.hpp"
#include "read/sinumerik/statement.hpp"

namespace obrys::read::sinumerik {

using dialect::sinumerik::Keyword;
using program::ExprId;
using program::Jump;
using program::JumpDirection;
using program::no_expr;
using program::StatementKind;

namespace {

JumpDirection direction_of(Keyword keyword) {
    switch (keyword) {
        case Keyword::gotof: return JumpDirection::forward;
        case Keyword::gotob: return JumpDirection::backward;
        case Keyword::gotoc: return JumpDirection::either_quiet;
        case Keyword::gotos: return JumpDirection::start;
        default: return JumpDirection::either;
    }
}

bool is_block_number(std::string_view name) {
    return name.size() > 1 && base::upper(name[0]) == 'N' &&
           name.find_first_not_of("0123456789", 1) == std::string_view::npos;
}

/// A label, an N number, a string variable or a text expression.
ExprId read_destination(State& s) {
    Cursor& c = s.cursor;
    c.skip_blanks();
    const char* from = c.p;
    const std::string_view name = c.name();
    if (name.empty() && c.peek() != '"' && c.peek() != '(' && c.peek() != '$' && c.peek() != '<') {
        fail_here(s, "the destination of the jump is missing", "name a label or a block number");
        return no_expr;
    }
    if (!name.empty()) {
        const std::string upper = base::to_upper(name);
        c.p += name.size();
        c.skip_blanks();
        const bool computed =
            s.strings.contains(upper) || c.peek() == '[' || c.peek() == '(' || (c.peek() == '<' && c.peek(1) == '<');
        c.p = from + name.size();
        if (!computed) {
            s.jumps_to_numbers = s.jumps_to_numbers || is_block_number(name);
            return read_text_literal(s, upper, from, c.p);
        }
        c.p = from;
    }
    s.jumps_to_numbers = true;
    return read_expression(s, Level::concat);
}

}  // namespace

JumpWord jump_word(State& s) {
    s.cursor.skip_blanks();
    const std::string_view name = s.cursor.name();
    if (name.size() < 4 || name.size() > 5) return {Keyword::goto_, 0};
    const auto* entry = dialect::sinumerik::find_word(base::to_upper(name));
    if (entry == nullptr || entry->use != dialect::sinumerik::Use::statement || !entry->name.starts_with("GOTO"))
        return {Keyword::goto_, 0};
    return {static_cast<Keyword>(entry->value), name.size()};
}

void read_jump(State& s, Keyword keyword, ExprId condition, const char* from) {
    Jump jump;
    jump.condition = condition;
    jump.direction = direction_of(keyword);
    if (jump.direction != JumpDirection::start) {
        jump.destination = read_destination(s);
        if (jump.destination == no_expr) return;
    }
    s.unit.jumps.push_back(jump);
    add_control(s, StatementKind::jump, s.unit.jumps.size() - 1, from);
}

void read_case(State& s, const char* from) {
    Cursor& c = s.cursor;
    program::Case branch;
    branch.selector = read_expression(s);
    if (branch.selector == no_expr) return;
    c.skip_blanks();
    if (!base::equals_ignoring_case(c.name(), "OF")) return fail_here(s, "expected OF in CASE, found " + here(s));
    c.p += 2;
    const char* end = c.p;
    while (!c.at_end()) {
        program::CaseArm arm;
        const bool is_default = base::equals_ignoring_case(c.name(), "DEFAULT");
        if (is_default)
            c.p += 7;
        else if ((arm.value = read_expression(s)) == no_expr)
            return;
        const JumpWord jump = jump_word(s);
        if (jump.length == 0) return fail_here(s, "expected GOTOF, GOTOB or GOTO in CASE, found " + here(s));
        c.p += jump.length;
        arm.jump.direction = direction_of(jump.keyword);
        if (arm.jump.direction != JumpDirection::start && (arm.jump.destination = read_destination(s)) == no_expr)
            return;
        branch.arms.push_back(arm);
        end = c.p;
        if (is_default) break;
    }
    if (branch.arms.empty()) return fail_here(s, "CASE has no branches", "write CASE R1 OF 1 GOTOF LABEL");
    c.p = end;
    s.unit.cases.push_back(std::move(branch));
    add_control(s, StatementKind::case_, s.unit.cases.size() - 1, from);
}

bool read_section(State& s, bool one_block, const char* from) {
    Cursor& c = s.cursor;
    const char* word_end = c.p;
    program::Section section;
    section.one_block = one_block;
    int labels = 0;
    const char* end = c.p;
    while (!c.at_end() && labels < 2) {
        const std::string_view name = c.name();
        const char* label = c.p;
        if (name.empty()) break;
        c.p += name.size();
        const bool is_word = c.at_assignment() || c.peek() == '[' || c.peek() == '(';
        if (is_word) {
            c.p = label;
            break;
        }
        (labels == 0 ? section.first : section.last) = intern(s, name);
        ++labels;
        end = label + name.size();
        if (one_block) break;
    }
    if (labels == 0) {
        c.p = word_end;
        return false;
    }
    section.to_here = labels == 1 && !one_block;
    c.p = end;
    c.skip_blanks();
    if (base::equals_ignoring_case(c.name(), "P")) {
        ++c.p;
        if (!c.take('=')) {
            fail_here(s, "expected '=' behind P, found " + here(s));
            return true;
        }
        section.passes = read_expression(s);
        if (section.passes == no_expr) return true;
        end = c.p;
    }
    c.p = end;
    s.unit.sections.push_back(section);
    add_control(s, StatementKind::repeat_section, s.unit.sections.size() - 1, from);
    return true;
}

}  // namespace obrys::read::sinumerik
