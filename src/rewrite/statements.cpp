/// Statements in their order: structures where the language has them, else labels and jumps.

#include <algorithm>

#include "base/text.hpp"
#include "rewrite/good_name.hpp"
#include "rewrite/writing.hpp"

namespace obrys::rewrite {

namespace {

bool is_structure(StatementKind k) {
    return (k >= StatementKind::if_ && k <= StatementKind::endfor) || k == StatementKind::repeat_count ||
           k == StatementKind::end_repeat_count;
}

/// Statements that a structure's own jumps go to, where the language has none.
void structure_targets(const Unit& unit, std::uint32_t i, std::set<std::uint32_t>& wanted) {
    const StatementKind k = unit.statements[i].kind;
    if (k == StatementKind::for_ || k == StatementKind::endfor) {
        const std::uint32_t target = unit.fors[entry_of(unit, i)].target;
        if (target != program::no_target) wanted.insert(target + 1);
        return;
    }
    const std::uint32_t target = unit.branches[entry_of(unit, i)].target;
    if (target == program::no_target) return;
    wanted.insert(k == StatementKind::end_repeat_count ? target + 1 : target);
}

}  // namespace

namespace {

/// Statements that a run comes to by another way than the call of their label.
std::set<std::uint32_t> not_only_called(const Unit& unit, const Graph& graph) {
    std::set<std::uint32_t> seen;
    std::vector<std::uint32_t> open{0};
    while (!open.empty()) {
        const std::uint32_t i = open.back();
        open.pop_back();
        if (i >= unit.statements.size() || !seen.insert(i).second) continue;
        const StatementKind k = unit.statements[i].kind;
        const bool calls = k == StatementKind::label_call || k == StatementKind::label_end;
        if (calls)
            open.push_back(i + 1);
        else
            open.insert(open.end(), graph.next[i].begin(), graph.next[i].end());
    }
    return seen;
}

}  // namespace

void Writing::statements(const Unit& u) {
    const auto n = static_cast<std::uint32_t>(u.statements.size());
    inline_.clear();
    const bool parts = !language.has("flow.repeat-section");
    if (parts) inline_ = not_only_called(u, graphs.at(&u));
    jumps_refused_ = false;
    find_structure();
    range(0, n, parts);
    at = n;
    borders(n);
    if (wanted_.contains(n) && !structured_) place(label_of(n));
}

void Writing::range(std::uint32_t first, std::uint32_t end, bool only_inline) {
    const Unit& u = *unit;
    labels_.clear(), settled_.clear(), wanted_.clear(), again_.clear(), counters_.clear(), numbers_.clear(),
        end_label_.clear(), open_ifs_.clear();
    wanted_ = graphs.at(unit).jumped_to;
    for (std::uint32_t i = 0; i < u.statements.size(); ++i) {
        const StatementKind k = u.statements[i].kind;
        if (is_structure(k) && !keeps_structures()) structure_targets(u, i, wanted_);
        if (k == StatementKind::label_call && repeats_label(i)) wanted_.insert(u.label_calls[entry_of(u, i)].target);
        if (!language.has("flow.repeat-section")) continue;
        std::optional<Range> r;
        if (k == StatementKind::label_call) r = called_range(u, u.label_calls[entry_of(u, i)]);
        if (r) wanted_.insert(r->first), wanted_.insert(r->last);
        if (k == StatementKind::label_call && repeats_label(i)) wanted_.insert(i);
        if (k == StatementKind::repeat_section) r = repeated_range(u, i, u.sections[entry_of(u, i)]);
        if (r && k == StatementKind::repeat_section) wanted_.insert(r->first), wanted_.insert(r->last + 1);
    }
    for (const auto& [name, places] : u.labels)
        for (const std::uint32_t place : places)
            if (wanted_.contains(place)) labels_.try_emplace(place, input.names->text(name));
    for (std::uint32_t i = first; i < end; ++i) {
        const bool elsewhere = only_inline && !inline_.contains(i);
        if (!elsewhere) borders(i);
        if (structured_ && structured_->only_jumped_to.contains(i)) continue;
        if (elsewhere && !is_structure(u.statements[i].kind)) continue;
        at = i;
        here = u.span(u.statements[i]);
        if (wanted_.contains(i) && !structured_) place(label_of(i));
        if (held()[Mode::plane] != never_there || is_structure(u.statements[i].kind)) statement(i);
        naming.release(u);
    }
}

std::string Writing::part(const Range& r) {
    std::string& name = parts_[{unit, r.first}].name;
    if (!name.empty()) return name;
    const Graph& graph = graphs.at(unit);
    bool good = !naming.has_variables(*unit) || language.local_place != LocalPlace::name;
    for (std::uint32_t i = r.first; i < r.last; ++i)
        for (const std::uint32_t to : graph.next[i])
            good = good && ((to >= r.first && to <= r.last) || unit->statements[i].kind == StatementKind::label_call ||
                            to >= unit->statements.size());
    if (!good)
        refuse(here, source(here) + ": the called part jumps out of itself, or has variables of its own",
               "write it as a program of its own");
    const std::size_t first = std::max<std::size_t>(2000, 1001 + programs.size());
    name = language.numbered_programs ? std::to_string(first + parts_.size()) : "PART_" + std::to_string(parts_.size());
    const auto same = [&](const auto& other) { return other.second == name; };
    while (!language.numbered_programs && std::any_of(program_names_.begin(), program_names_.end(), same)) name += '_';
    if (!language.numbered_labels) all_labels_.insert(name);
    parts_[{unit, r.first}].range = r;
    waiting_.push_back(r.first);
    return name;
}

void Writing::parts_of_unit() {
    if (!waiting_.empty() && language.local_place == LocalPlace::name && naming.keeps(*unit))
        refuse(here, unit->name + ": a called part of it needs a value that this program keeps",
               "write the part as a program of its own");
    while (!waiting_.empty()) {
        const Part part = parts_[{unit, waiting_.front()}];
        waiting_.erase(waiting_.begin());
        here = unit->span(unit->statements[part.range.first]);
        static_cast<void>(say("flow.sub-begin", {{"name", part.name}, {"parameters", ""}}, "a part"));
        range(part.range.first, part.range.last, false);
        at = part.range.last;
        borders(at);
        if (wanted_.contains(at) && !structured_) place(label_of(at));
        if (!end_label_.empty()) place(end_label_);
        if (const std::string* text = language.find("flow.sub-end"); text == nullptr || lines.back().text != *text)
            static_cast<void>(say("flow.sub-end", {{"name", part.name}}, "a part"));
    }
}

std::string Writing::label_of(std::uint32_t statement) {
    std::string& settled = settled_[statement];
    if (!settled.empty()) return settled;
    const auto own = labels_.find(statement);
    if (language.numbered_labels || own == labels_.end()) return settled = fresh_label();
    std::string good = good_name(own->second, Named::label, "LBL_", language), name = good;
    if (all_labels_.contains(name)) name = with_end(good, "_" + program_name(*unit), Named::label, language);
    for (int n = 2; !all_labels_.insert(name).second; ++n)
        name = with_end(good, "_" + std::to_string(n), Named::label, language);
    if (!base::is_digit(own->second[0]) && !base::equals_ignoring_case(name, own->second))
        tell(here, "label " + own->second + " is called " + name);
    return settled = name;
}

std::string Writing::fresh_label() {
    std::string label;
    do label = language.numbered_labels ? std::to_string(++next_label_ * 10) : "NEXT_" + std::to_string(++next_label_);
    while (!all_labels_.insert(label).second);
    return label;
}

bool Writing::may_jump() {
    if (language.has("flow.jump")) return true;
    if (!jumps_refused_)
        refuse(here, source(here) + ": the control has no jumps to labels",
               "write the program with IF, WHILE and subprograms alone");
    jumps_refused_ = true;
    return false;
}

void Writing::place(const std::string& label) {
    write_length();
    if (!may_jump()) return;
    static_cast<void>(say("flow.label", {{"label", label}}, "a label"));
}

void Writing::jump(const std::string& label) {
    if (may_jump()) static_cast<void>(say("flow.jump", {{"label", label}}, "a jump"));
}

void Writing::statement(std::uint32_t i) {
    const program::Statement& s = unit->statements[i];
    remarks(i);
    if ((s.flags & program::skip_mask) != 0)
        return refuse(here, "a block that can be skipped (/) is not translated by structure",
                      "use IF with a parameter of its own");
    const std::size_t entry = entry_of(*unit, i);
    if (s.kind != StatementKind::block) write_length();
    switch (s.kind) {
        case StatementKind::block: return block(i);
        case StatementKind::jump: return jump_statement(unit->jumps[entry]);
        case StatementKind::case_: return case_of(unit->cases[entry]);
        case StatementKind::call: return call(unit->calls[entry]);
        case StatementKind::label_call: return label_call(unit->label_calls[entry], i);
        case StatementKind::label_end: return;
        case StatementKind::procedure: return procedure(unit->procedures[entry]);
        case StatementKind::define: return define(unit->defines[entry]);
        case StatementKind::repeat_section: return section(i);
        case StatementKind::frame: return frame(unit->frames[entry]);
        case StatementKind::cycle_definition: return cycle_definition(unit->cycles[entry]);
        case StatementKind::return_:
            if (entry != 0) return refuse(here, "a return to another block is not translated by structure");
            return leave();
        default: break;
    }
    if (is_structure(s.kind)) return structure(i);
    refuse(here, source(here) + " is not translated by structure",
           "translate without --keep: its moves are written then");
}

void Writing::structure(std::uint32_t i) {
    const StatementKind k = unit->statements[i].kind;
    if (k == StatementKind::for_ || k == StatementKind::endfor) return loop(i);
    if (k == StatementKind::repeat_count || k == StatementKind::end_repeat_count) return counted(i);
    branch(i);
}

std::string Writing::structure_number(std::uint32_t opener) {
    std::string& n = numbers_[opener];
    if (n.empty()) n = std::to_string(++next_number_);
    return n;
}

void Writing::section(std::uint32_t i) {
    const program::Section& s = unit->sections[entry_of(*unit, i)];
    const auto range = repeated_range(*unit, i, s);
    if (!range || !language.has("flow.repeat-section"))
        return refuse(here, source(here) + ": a repeated part of the program is not translated by structure",
                      "write it as a subprogram");
    const Text passes = s.passes == program::no_expr ? number_text(1) : value(s.passes);
    static_cast<void>(
        say("flow.repeat-section",
            {{"first", label_of(range->first)}, {"last", label_of(range->last + 1)}, {"passes", passes.text}},
            "a repeated part"));
}

namespace {
constexpr std::string_view no_condition = "this condition cannot be said in one expression";
}

void Writing::branch(std::uint32_t i) {
    const StatementKind k = unit->statements[i].kind;
    const program::Branch& b = unit->branches[entry_of(*unit, i)];
    const bool keeps = keeps_structures();
    const std::size_t before = lines.size();
    const auto condition_text = [&](bool negated) {
        const Condition c = condition(b.condition, negated);
        if (c.kind == Condition::Kind::constant)
            return number(c.holds ? 1 : 0) + *language.find("operators.equal") + number(1);
        const auto text = as_text(c);
        if (!text) refuse(here, std::string(no_condition));
        return text.value_or("");
    };
    const auto open = [&](std::string_view key, std::uint32_t opener, bool negated = false) {
        const std::string text = b.condition == program::no_expr ? "" : condition_text(negated);
        static_cast<void>(say(key, {{"condition", text}, {"n", structure_number(opener)}}, "a structure"));
    };
    switch (k) {
        case StatementKind::if_:
            if (!keeps) return jump_when(condition(b.condition, true), label_of(b.target));
            // An ELSE finds its IF by the place at which that goes on when its condition does not hold.
            numbers_[i] = std::to_string(++next_number_);
            open_ifs_.push_back(i);
            return open("flow.if", i);
        case StatementKind::while_: {
            if (!keeps) return jump_when(condition(b.condition, true), label_of(b.target));
            open("flow.while", i);
            if (lines.size() > before + 1) again_.insert(i);
            return;
        }
        case StatementKind::endwhile:
        case StatementKind::endloop:
            if (!keeps) return jump(label_of(b.target));
            if (again_.contains(b.target))  // made ready anew for the next pass, in the same places
                static_cast<void>(as_text(condition(unit->branches[entry_of(*unit, b.target)].condition)));
            return open(k == StatementKind::endloop ? "flow.end-loop" : "flow.end-while", b.target);
        case StatementKind::loop_:
            if (keeps) open("flow.loop", i);
            return;
        case StatementKind::repeat_:
            if (keeps) open(ends_by_break() ? "flow.loop" : "flow.repeat", i);
            return;
        case StatementKind::until:
            if (!keeps) return jump_when(condition(b.condition, true), label_of(b.target));
            if (ends_by_break()) return break_when(condition_text(false), structure_number(b.target));
            // Where the language says when to go on instead of when to stop.
            return language.has("flow.again") ? open("flow.again", b.target, true) : open("flow.until", b.target);
        default: break;
    }
    if (!keeps) {
        if (k == StatementKind::else_) jump(label_of(b.target));
        return;
    }
    if (open_ifs_.empty()) return;  // else_ and endif: of the innermost IF that is still open
    open(k == StatementKind::else_ ? "flow.else" : "flow.end-if", open_ifs_.back());
    if (k == StatementKind::endif) open_ifs_.pop_back();
}

void Writing::loop(std::uint32_t i) {
    const program::For& f = unit->fors[entry_of(*unit, i)];
    const bool opens = unit->statements[i].kind == StatementKind::for_;
    if (f.target == program::no_target) return refuse(here, "FOR without its end");
    const program::For& head = opens ? f : unit->fors[entry_of(*unit, f.target)];
    const auto variable = target_of(head.variable);
    if (!variable) return;
    if (opens)
        assign(*variable, of_type(head.variable, value(head.from), head.from));
    else
        assign(*variable, joined("operators.add", *variable, number_text(1), Level::sum));
    const bool plain = !language.has("flow.jump-if") && !language.has("flow.if");
    const Condition more{.kind = Condition::Kind::comparison,
                         .op = Operator::less_equal,
                         .a = *variable,
                         .b = plain ? atom(head.to) : value(head.to)};
    if (!keeps_structures()) {
        if (!opens) return jump_when(more, label_of(f.target + 1));
        Condition past = more;
        past.op = Operator::greater;
        return jump_when(past, label_of(f.target + 1));
    }
    const auto text = as_text(more);
    if (!text) return refuse(here, std::string(no_condition));
    static_cast<void>(opens ? say("flow.while", {{"condition", *text}, {"n", structure_number(i)}}, "FOR")
                            : say("flow.end-while", {{"n", structure_number(f.target)}}, "FOR"));
}

}  // namespace obrys::rewrite
