/// Labels and calls: LBL, CALL LBL … REP, CALL PGM, GOTO LBL.

#include <algorithm>

#include "read/heidenhain/state.hpp"

namespace obrys::read::heidenhain {

using program::no_expr;

namespace {

constexpr double highest_label = 65534;

struct Label {
    ExprId text = no_expr;
    std::string name;  ///< empty where it is computed (QS)
};

/// 5, "name" or QS3.
Label read_label(State& s) {
    s.in.skip_blanks();
    const std::uint32_t begin = s.in.at();
    Label l;
    if (base::is_digit(s.in.peek())) {
        const int n = s.in.integer();
        const char next = base::upper(s.in.peek());
        if (n < 0 || n > highest_label || next == '.' || next == 'E') {
            fail(s, begin, "a label is a whole number up to 65534", "a name in quotes is a label, too");
            return l;
        }
        l.name = std::to_string(n);
        l.text = s.build.text(l.name, begin, s.in.at());
        return l;
    }
    if (!stands_parameter(s) && s.in.peek() != '"') {
        fail_here(s, "a label is due here, found " + here(s), "a number, a name in quotes or a QS parameter");
        return l;
    }
    l.text = read_text(s);
    if (l.text == no_expr) return l;
    const program::Expr& e = s.build.unit().exprs[l.text];
    if (e.kind != program::ExprKind::text) return l;
    l.name = s.build.unit().texts[e.a];
    if (l.name.empty()) fail(s, begin, "a label's name is empty");
    if (std::all_of(l.name.begin(), l.name.end(), base::is_digit)) {  // LBL "1" is another one than LBL 1
        l.name = '"' + l.name + '"';
        l.text = s.build.text(l.name, begin, s.in.at());
    }
    return l;
}

}  // namespace

void read_label_block(State& s) {
    s.in.skip_blanks();
    const std::uint32_t begin = s.in.at();
    const Label l = read_label(s);
    if (s.failed) return;
    if (l.name == "0") {
        s.build.statement(StatementKind::label_end, s.block);
        return;
    }
    s.build.statement(StatementKind::block, s.block);
    if (l.name.empty()) {
        fail(s, begin, "a label needs a fixed number or name here");
        return;
    }
    auto& at = s.build.unit().labels[s.build.name(l.name)];
    if (!at.empty())
        fail(s, begin, "the label " + l.name + " is there twice in this program", "give one of them another number");
    at.push_back(static_cast<std::uint32_t>(s.build.unit().statements.size() - 1));
}

void read_goto(State& s, ExprId condition) {
    s.in.take_word("LBL");
    const Label l = read_label(s);
    if (s.failed) return;
    program::Jump j;
    j.condition = condition;
    j.direction = program::JumpDirection::either;
    j.destination = l.text;
    s.build.unit().jumps.push_back(j);
    s.build.control(StatementKind::jump, s.build.unit().jumps.size() - 1, s.block, s.in.at());
}

void call_label(State& s, ExprId label, ExprId repeats) {
    program::LabelCall call;
    call.label = label;
    call.repeats = repeats;
    s.build.unit().label_calls.push_back(call);
    s.build.control(StatementKind::label_call, s.build.unit().label_calls.size() - 1, s.block, s.in.at());
}

ExprId read_label_name(State& s) { return read_label(s).text; }

namespace {

void read_label_call(State& s) {
    const Label l = read_label(s);
    if (s.failed) return;
    ExprId repeats = no_expr;
    if (s.in.take_prefix("REP")) {
        const std::uint32_t behind = s.in.at();
        const Value v = read_value(s);
        // Old programs write "REP 5/5": how many, and how many are left.
        if (v.found && s.in.take('/')) static_cast<void>(read_value(s));
        if (!v.found) s.in.go_to(behind);
        repeats = v.found ? as_expr(s, v) : no_expr;
    }
    call_label(s, l.text, repeats);
}

}  // namespace

void read_program_call(State& s, std::string_view behind, std::string_view suffix) {
    s.in.skip_blanks();
    const std::uint32_t begin = s.in.at();
    program::Call call;
    const bool computed = stands_parameter(s) || s.in.peek() == '"';
    if (computed) {
        call.kind = program::CallKind::indirect;
        call.target = read_text(s);
    } else {
        const std::string_view path = s.in.path();
        if (path.empty()) {
            fail_here(s, "the name of a program is due behind " + std::string(behind));
            return;
        }
        call.name = s.build.name(called_name(path, suffix));
    }
    if (s.failed) return;
    call.where = s.build.span(begin, s.in.at());
    s.build.unit().calls.push_back(std::move(call));
    s.build.control(StatementKind::call, s.build.unit().calls.size() - 1, s.block, s.in.at());
}

void read_call_block(State& s) {
    if (s.in.take_word("LBL")) return read_label_call(s);
    if (s.in.take_word("PGM")) return read_program_call(s, "CALL PGM", ".H");
    fail_here(s, "LBL or PGM is due behind CALL, found " + here(s));
}

std::string program_name(std::string_view path) {
    if (const auto slash = path.find_last_of("\\/:"); slash != std::string_view::npos) path.remove_prefix(slash + 1);
    if (const auto dot = path.rfind('.'); dot != std::string_view::npos && dot > 0) path = path.substr(0, dot);
    return base::to_upper(path);
}

std::string called_name(std::string_view path, std::string_view suffix) {
    const std::string upper = base::to_upper(path);
    if (upper.ends_with(".H")) suffix = ".H";
    if (upper.ends_with(".I")) suffix = ".I";
    return program_name(path) + (suffix == ".H" ? "" : std::string(suffix));
}

namespace {

std::uint32_t place_of(State& s, ExprId label) {
    const program::Unit& unit = s.build.unit();
    if (label == no_expr || unit.exprs[label].kind != program::ExprKind::text) return program::no_target;
    const auto found = unit.labels.find(s.build.name(unit.texts[unit.exprs[label].a]));
    return found == unit.labels.end() ? program::no_target : found->second.front();
}

}  // namespace

void resolve_labels(State& s) {
    for (program::Jump& j : s.build.unit().jumps) j.target = place_of(s, j.destination);
    for (program::LabelCall& c : s.build.unit().label_calls) c.target = place_of(s, c.label);
}

}  // namespace obrys::read::heidenhain
