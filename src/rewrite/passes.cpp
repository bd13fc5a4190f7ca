/// What is done again: calls with a number of passes, called labels and the parts that they repeat.

#include <algorithm>
#include <cmath>

#include "base/whole.hpp"
#include "rewrite/writing.hpp"

namespace obrys::rewrite {

std::optional<int> Writing::passes_of(const program::Call& c) {
    constexpr int most = 65535;
    const Expr* e = c.passes == program::no_expr ? nullptr : &unit->exprs[c.passes];
    const bool number = e == nullptr || e->kind == ExprKind::number;
    const auto passes = !number        ? std::nullopt
                        : e == nullptr ? std::optional(1)
                                       : base::whole<int>(unit->numbers[e->a], 1, most);
    const auto given = [](ExprId id) { return id != program::no_expr; };
    const bool again = passes > 1 && std::any_of(c.arguments.begin(), c.arguments.end(), given);
    if (passes && !again && c.first_block == program::no_expr) return passes;
    refuse(here,
           source(here) +
               ": a call with a first block, a computed number of passes, or with passes and arguments is not "
               "translated by structure",
           "write it as a loop");
    return std::nullopt;
}

void Writing::repeated(int passes, const std::function<void()>& what) {
    if (passes == 1) return what();
    std::string& name = counters_[at];
    name = naming.keeper(*unit, "COUNT_").value_or("");
    if (name.empty()) return refuse(here, "there is no parameter left to count the passes of this call");
    const Text counter{name, Level::atom, std::nullopt};
    const Condition more{
        .kind = Condition::Kind::comparison, .op = Operator::greater, .a = counter, .b = number_text(0)};
    assign(counter, number_text(passes));
    const auto text = keeps_structures() ? as_text(more) : std::nullopt;
    const std::string n = text ? std::to_string(++next_number_) : fresh_label();
    if (text)
        say("flow.while", {{"condition", *text}, {"n", n}}, "a loop");
    else
        place(n);
    what();
    assign(counter, joined("operators.subtract", counter, number_text(1), Level::sum));
    if (text)
        say("flow.end-while", {{"n", n}}, "a loop");
    else
        jump_when(more, n);
}

bool Writing::repeats_label(std::uint32_t statement) const {
    const program::LabelCall& c = unit->label_calls[entry_of(*unit, statement)];
    if (c.repeats == program::no_expr || c.target == program::no_target || c.target >= statement) return false;
    if (language.has("flow.repeat-section")) return true;
    const Graph& graph = graphs.at(unit);
    for (std::uint32_t i = c.target; i < statement; ++i)
        for (const std::uint32_t to : graph.next[i])
            if ((to < c.target || to > statement) && unit->statements[i].kind != StatementKind::label_call &&
                unit->statements[i].kind != StatementKind::label_end)  // which nothing has called here
                return false;
    return language.has("flow.jump");
}

/// Back to the label while passes are left; how many there are is asked once for all of them.
void Writing::repeat_label(const program::LabelCall& c) {
    const auto active = naming.keeper(*unit, "AGAIN_"), left = naming.keeper(*unit, "PASSES_");
    if (!active || !left) return refuse(here, "there is no parameter left to count the passes of this loop");
    rep_keepers_.push_back(*active);
    const Text on{*active, Level::atom, std::nullopt}, rest{*left, Level::atom, std::nullopt};
    const auto comparison = [](const Text& a, Operator op, Text b) {
        return Condition{.kind = Condition::Kind::comparison, .op = op, .a = a, .b = std::move(b)};
    };
    const std::string going = fresh_label(), past = fresh_label();
    jump_when(comparison(on, Operator::not_equal, number_text(0)), going);
    assign(rest, value(c.repeats));
    assign(on, number_text(1));
    place(going);
    assign(rest, joined("operators.subtract", rest, number_text(1), Level::sum));
    jump_when(comparison(rest, Operator::less, number_text(0)), past);
    jump(label_of(c.target));
    place(past);
    assign(on, number_text(0));
}

/// The program says first that no part of it is being repeated.
void Writing::begin_repeats(std::size_t top) {
    std::vector<Line> behind(lines.begin() + static_cast<std::ptrdiff_t>(top), lines.end());
    lines.resize(top);
    here = {unit->file, unit->begin, unit->begin};
    for (const std::string& name : rep_keepers_) assign({name, Level::atom, std::nullopt}, number_text(0));
    const std::size_t more = lines.size() - top;
    for (Note& note : notes)
        if (note.line > top) note.line += more;
    lines.insert(lines.end(), behind.begin(), behind.end());
    rep_keepers_.clear();
}

void Writing::label_call(const program::LabelCall& c, std::uint32_t statement) {
    if (structured_ && structured_->jumps.contains(statement)) return end_counting(c);
    if (repeats_label(statement)) {
        if (!language.has("flow.repeat-section")) return repeat_label(c);
        const Text passes = value(c.repeats);
        if (passes.number && *passes.number >= 1)
            return static_cast<void>(say("flow.repeat-section",
                                         {{"first", label_of(c.target)},
                                          {"last", label_of(statement)},
                                          {"passes", number(std::floor(*passes.number))}},
                                         "a repeated part"));
        return refuse(here,
                      source(here) + ": REP with a computed number is not translated by structure to this control",
                      "write it as a loop");
    }
    const auto range = called_range(*unit, c);
    if (range && !language.has("flow.repeat-section"))
        return static_cast<void>(say(language.has("flow.call-shared") ? "flow.call-shared" : "flow.call",
                                     {{"name", part(*range)}, {"arguments", ""}}, "a called label"));
    if (!range || !language.has("flow.repeat-section"))
        return refuse(here, source(here) + ": a called label is not translated by structure to this control",
                      "write it as a program of its own");
    static_cast<void>(say("flow.repeat-section",
                          {{"first", label_of(range->first)}, {"last", label_of(range->last)}, {"passes", number(1)}},
                          "a called label"));
}

}  // namespace obrys::rewrite
