/// Jumps: to labels, or as the loops and branches that they make where the control has none; loops by a count.

#include <algorithm>

#include "rewrite/writing.hpp"

namespace obrys::rewrite {

void Writing::find_structure() {
    structured_.reset();
    region_numbers_.clear();
    if (language.has("flow.jump") || !keeps_structures()) return;
    structured_ = structured(*unit, modes.at(unit), *input.names, *input.sources);
    if (!structured_) return;
    const std::vector<Structured::Region>& regions = structured_->regions;
    region_numbers_.resize(regions.size());
    ends_at_.clear(), begins_at_.clear(), counting_.clear();
    for (std::size_t r = 0; r < regions.size(); ++r)
        if (!regions[r].own) (regions[r].loop ? begins_at_[regions[r].begin] : ends_at_[regions[r].end]).push_back(r);
}

std::string Writing::region_number(std::size_t region) {
    if (structured_->regions[region].own) return structure_number(structured_->regions[region].begin);
    std::string& n = region_numbers_[region];
    if (n.empty()) n = std::to_string(++next_number_);
    return n;
}

/// Ends of branches, then beginnings of loops, the inner ones first and last.
void Writing::borders(std::uint32_t i) {
    if (!structured_) return;
    std::vector<std::size_t> ends = ends_at_[i], begins = begins_at_[i];
    const auto& all = structured_->regions;
    std::sort(ends.begin(), ends.end(), [&](std::size_t a, std::size_t b) { return all[a].begin > all[b].begin; });
    std::sort(begins.begin(), begins.end(), [&](std::size_t a, std::size_t b) { return all[a].end > all[b].end; });
    for (const std::size_t r : ends) say("flow.end-if", {{"n", region_number(r)}}, "a branch");
    for (const std::size_t r : begins) {
        if (all[r].counted) begin_counting(r);
        say(all[r].endless || ends_by_break() ? "flow.loop" : "flow.repeat", {{"n", region_number(r)}}, "a loop");
    }
}

/// Whether a pass is one of those that are counted, before the first one: none is.
void Writing::begin_counting(std::size_t region) {
    const auto active = naming.keeper(*unit, "AGAIN_"), left = naming.keeper(*unit, "PASSES_");
    if (!active || !left) return refuse(here, "there is no parameter left to count the passes of this loop");
    const auto place = [](const std::string& name) { return Text{name, Level::atom, std::nullopt}; };
    counting_.insert_or_assign(region, std::pair(place(*active), place(*left)));
    assign(place(*active), number_text(0));
}

/// Some more times; how many is asked once for all of them.
void Writing::end_counting(const program::LabelCall& c) {
    const std::size_t region = structured_->jumps.at(at).region;
    const auto found = counting_.find(region);
    if (found == counting_.end()) return;
    const auto [on, rest] = found->second;
    when(on, Operator::equal, number_text(0), [&, on = on, rest = rest] {
        assign(rest, value(c.repeats));
        assign(on, number_text(1));
    });
    assign(rest, joined("operators.subtract", rest, number_text(1), Level::sum));
    const Condition done{.kind = Condition::Kind::comparison, .op = Operator::less, .a = rest, .b = number_text(0)};
    const auto text = as_text(done);
    if (!text) return refuse(here, "this condition cannot be said in one expression");
    break_when(*text, region_number(region));
}

void Writing::break_when(const std::string& condition, const std::string& loop) {
    const std::string n = std::to_string(++next_number_);
    say("flow.if", {{"condition", condition}, {"n", n}}, "the way out of a loop");
    say("flow.break", {{"n", loop}}, "the way out of a loop");
    say("flow.end-if", {{"n", n}}, "the way out of a loop");
    say("flow.end-loop", {{"n", loop}}, "a loop");
}

void Writing::say_again(const program::Jump& j, const std::string& loop) {
    const auto text = as_text(condition(j.condition, ends_by_break()));
    if (!text) return refuse(here, "this condition cannot be said in one expression");
    if (ends_by_break()) return break_when(*text, loop);
    say("flow.again", {{"condition", *text}, {"n", loop}}, "a loop");
}

/// What the program ends with there, here.
void Writing::tail(const program::Jump& j) {
    const std::uint32_t jump = at, first = structured_->tails_of_jumps.at(at), last = structured_->tails.at(first);
    const std::string n = std::to_string(++next_number_);
    const bool always = is_always(*unit, j);
    if (!always) {
        const auto text = as_text(condition(j.condition));
        if (!text) return refuse(here, "this condition cannot be said in one expression");
        say("flow.if", {{"condition", *text}, {"n", n}}, "a branch");
    }
    tell(here, source(here) + ": what the program ends with there is written here");
    const std::string length = length_waits;
    const int tool = tool_in_spindle;
    in_tail_ = true;
    for (at = first; at <= last; ++at) {
        here = unit->span(unit->statements[at]);
        statement(at);
        naming.release(*unit);
    }
    in_tail_ = false;
    at = jump;
    here = unit->span(unit->statements[at]);
    length_waits = length;
    tool_in_spindle = tool;
    if (!always) say("flow.end-if", {{"n", n}}, "a branch");
}

void Writing::structured_jump(const program::Jump& j) {
    const Structured::Jump& jump = structured_->jumps.at(at);
    const auto say_with = [&](std::string_view key, bool negated, const std::string& n) {
        const auto text = as_text(condition(j.condition, negated));
        if (!text) return refuse(here, "this condition cannot be said in one expression");
        say(key, {{"condition", *text}, {"n", n}}, "a structure");
    };
    switch (jump.role) {
        case JumpRole::none: return;
        case JumpRole::branch: return say_with("flow.if", true, region_number(jump.region));
        case JumpRole::again: return say_again(j, region_number(jump.region));
        case JumpRole::other:
            return static_cast<void>(say("flow.else", {{"n", region_number(jump.region)}}, "a branch"));
        case JumpRole::end_loop:
            return static_cast<void>(say("flow.end-loop", {{"n", region_number(jump.region)}}, "a loop"));
        case JumpRole::tail: return tail(j);
        case JumpRole::repeat: return;
        case JumpRole::leave: break;
    }
    const std::string n = std::to_string(++next_number_);
    const bool always = is_always(*unit, j);
    if (!always) say_with("flow.if", false, n);
    say("flow.break", {{"n", region_number(jump.region)}}, "the way out of a loop");
    if (!always) say("flow.end-if", {{"n", n}}, "a branch");
}

void Writing::jump_statement(const program::Jump& j) {
    if (structured_) return structured_jump(j);
    const auto to = destination(*unit, at, j, *input.names, *input.sources);
    if (!to)
        return refuse(here, source(here) + ": where this jump goes is computed, or there is no such label",
                      "name the label in the jump");
    if (j.condition == program::no_expr) return jump(label_of(*to));
    jump_when(condition(j.condition), label_of(*to));
}

void Writing::case_of(const program::Case& c) {
    const Text selector = atom(c.selector);
    for (const program::CaseArm& arm : c.arms) {
        const auto to = destination(*unit, at, arm.jump, *input.names, *input.sources);
        if (!to) return refuse(here, "where an arm of this CASE goes is not known from the text");
        if (arm.value == program::no_expr) return jump(label_of(*to));
        jump_when({.kind = Condition::Kind::comparison, .op = Operator::equal, .a = selector, .b = atom(arm.value)},
                  label_of(*to));
    }
}

void Writing::counted(std::uint32_t i) {
    const program::Branch& b = unit->branches[entry_of(*unit, i)];
    const bool opens = unit->statements[i].kind == StatementKind::repeat_count;
    std::string& name = counters_[opens ? i : b.target];
    if (opens) name = naming.keeper(*unit, "COUNT_").value_or("");
    if (name.empty()) return refuse(here, "there is no parameter left to count the passes of this loop");
    const Text counter{name, Level::atom, std::nullopt};
    const Condition more{
        .kind = Condition::Kind::comparison, .op = Operator::greater_equal, .a = counter, .b = number_text(0.5)};
    if (opens)
        assign(counter, value(b.condition));
    else
        assign(counter, joined("operators.subtract", counter, number_text(1), Level::sum));
    if (!keeps_structures()) {
        if (!opens) return jump_when(more, label_of(b.target + 1));
        Condition none = more;
        none.op = Operator::less;
        return jump_when(none, label_of(b.target));
    }
    static_cast<void>(
        opens ? say("flow.while", {{"condition", as_text(more).value_or("")}, {"n", structure_number(i)}}, "a loop")
              : say("flow.end-while", {{"n", structure_number(b.target)}}, "a loop"));
}

}  // namespace obrys::rewrite
