/// Calls, what they are given, the way back, and what a program says to its operator.

#include <algorithm>
#include <cmath>

#include "base/comment.hpp"
#include "base/number.hpp"
#include "base/text.hpp"
#include "base/whole.hpp"
#include "rewrite/good_name.hpp"
#include "rewrite/writing.hpp"

namespace obrys::rewrite {

namespace {

constexpr std::uint32_t first_called = 1001;  ///< number of the first called program, where they have numbers

/// A text that is nothing but a constant; nothing else.
std::optional<std::string> constant_text(const Unit& unit, ExprId id) {
    if (id == program::no_expr || unit.exprs[id].kind != ExprKind::text) return std::nullopt;
    return unit.texts[unit.exprs[id].a];
}

/// A sum of constants.
std::optional<int> constant_sum(const Unit& unit, ExprId id) {
    const Expr& e = unit.exprs[id];
    if (e.kind == ExprKind::number) return base::whole<int>(unit.numbers[e.a], 0, 1'000'000);
    if (e.kind != ExprKind::binary || static_cast<Operator>(e.op) != Operator::add) return std::nullopt;
    const auto a = constant_sum(unit, e.a), b = constant_sum(unit, e.b);
    return a && b ? std::optional(*a + *b) : std::nullopt;
}

/// The same of constants that are put together.
std::optional<std::string> joined_text(const Unit& unit, ExprId id) {
    if (id == program::no_expr) return std::nullopt;
    const Expr& e = unit.exprs[id];
    if (e.kind == ExprKind::function && static_cast<Function>(e.op) == Function::to_text && e.count > 0) {
        const auto n = constant_sum(unit, unit.children[e.b]);
        return n ? std::optional(std::to_string(*n)) : std::nullopt;
    }
    if (e.kind != ExprKind::binary || static_cast<Operator>(e.op) != Operator::concat) return constant_text(unit, id);
    const auto a = joined_text(unit, e.a), b = joined_text(unit, e.b);
    return a && b ? std::optional(*a + *b) : std::nullopt;
}

std::string one_line(std::string text) {
    for (char& c : text)
        if (c == '(' || c == ')' || c == '\n' || c == '"') c = ' ';
    return text;
}

}  // namespace

std::string Writing::program_name(const Unit& u) {
    std::string& name = program_names_[&u];
    if (!name.empty()) return name;
    if (!language.numbered_programs) {
        const std::string good = good_name(u.name, Named::program, "PGM_", language);
        const auto is_taken = [&](const std::string& wanted) {
            return std::any_of(program_names_.begin(), program_names_.end(), [&](const auto& other) {
                return other.first != &u && base::equals_ignoring_case(other.second, wanted);
            });
        };
        std::string free = good;
        for (int n = 2; is_taken(free); ++n) free = with_end(good, "_" + std::to_string(n), Named::program, language);
        return name = free;
    }
    name = std::to_string(first_called + numbered_++);
    return name;
}

const Unit* Writing::callee(const Unit& caller, const program::Call& c) const {
    std::string name = c.kind == program::CallKind::by_name ? input.names->text(c.name) : "";
    if (c.kind == program::CallKind::indirect) name = base::to_upper(constant_text(caller, c.target).value_or(""));
    if (name.ends_with(".H")) name.resize(name.size() - 2);
    return name.empty() ? nullptr : input.find(name);
}

bool Writing::collect(const Unit& u, std::vector<const Unit*>& open) {
    if (std::find(open.begin(), open.end(), &u) != open.end()) return false;
    if (std::find(programs.begin(), programs.end(), &u) != programs.end()) return true;
    programs.push_back(&u);
    open.push_back(&u);
    bool good = true;
    for (const program::Call& c : u.calls)
        if (const Unit* called = callee(u, c); called != nullptr && !collect(*called, open)) good = false;
    open.pop_back();
    return good;
}

bool Writing::is_set_first(const Unit& u, std::uint32_t n) const {
    for (std::uint32_t i = 0; i < u.statements.size() && u.statements[i].kind == StatementKind::block; ++i) {
        const base::Span span = u.span(u.statements[i]);
        const auto count = std::count_if(u.exprs.begin(), u.exprs.end(), [&](const Expr& e) {
            return e.kind == ExprKind::parameter && e.a == n && e.begin >= span.begin && e.end <= span.end;
        });
        if (count == 0) continue;
        bool sets = false;
        for (std::uint32_t w = u.statements[i].first; w < u.words_end(i); ++w) {
            if (program::code_of(u.words[w]) != program::Code::assign) continue;
            const Expr& to = u.exprs[u.assigns[static_cast<std::size_t>(u.words[w].payload)].target];
            sets = sets || (to.kind == ExprKind::parameter && to.a == n);
        }
        return sets && count == 1;
    }
    return false;
}

bool Writing::takes_numbers(const Unit& called) {
    for (const program::Parameter& p : called.parameters) {
        const bool number = p.type == program::Type::real || p.type == program::Type::integer;
        const bool constant = p.preset == program::no_expr || called.exprs[p.preset].kind == ExprKind::number;
        const bool given_back = p.by_reference && p.type == program::Type::real;
        if ((given_back || !p.by_reference) && !p.is_array && number && constant) continue;
        refuse(here, input.names->text(p.name) + " of " + called.name +
                         ": of arguments, REAL, VAR REAL and INT without index are translated by structure, with a "
                         "number alone as their preset value");
        return false;
    }
    return true;
}

/// What argument n has in the called program, where the call gives it `id`.
Text Writing::given_value(const Unit& called, std::size_t n, ExprId id) {
    const program::Parameter* p = n < called.parameters.size() ? &called.parameters[n] : nullptr;
    if (id != program::no_expr) return p == nullptr ? value(id) : as_type(p->type, value(id), id);
    const double preset = p == nullptr || p->preset == program::no_expr ? 0 : called.numbers[called.exprs[p->preset].a];
    return number_text(p != nullptr && p->type == program::Type::integer ? std::floor(preset + 0.5) : preset);
}

void Writing::call(const program::Call& c) {
    const Unit* called = callee(*unit, c);
    if (called == nullptr || c.kind == program::CallKind::modal || c.kind == program::CallKind::modal_end)
        return refuse(here, source(here) + ": this call is not translated by structure",
                      called == nullptr ? "put the program beside this one" : "");
    const auto passes = passes_of(c);
    if (!passes) return;
    if (c.shares_parameters && naming.has_locals(*called))
        return refuse(here, source(here) + ": the called program works on this one's own parameters",
                      "call it with G65 and its values");
    if (!takes_numbers(*called)) return;
    const auto back = given_back(c, *called);
    if (!back) return;
    if (!back->empty() && *passes != 1)
        return refuse(here, "a call of several passes with VAR arguments is not translated by structure",
                      "write a loop");
    std::string given;
    std::size_t letters = 0;
    std::vector<std::pair<Text, Text>> sets;
    for (const Argument& a : naming.arguments(*called)) {
        const ExprId id = a.index < c.arguments.size() ? c.arguments[a.index] : program::no_expr;
        if (id == program::no_expr && unit->traits->empty_parameters) {
            if (is_set_first(*called, static_cast<std::uint32_t>(a.index + 1))) continue;
            return refuse(here,
                          "argument " + std::to_string(a.index + 1) +
                              " is not given here: what is empty there has no counterpart",
                          "give it a value");
        }
        if (a.to.empty()) return refuse(here, "there is no parameter left for argument " + std::to_string(a.index + 1));
        const Text v = given_value(*called, a.index, id);
        const std::string* form = language.find("flow.argument");
        if (form == nullptr) {
            sets.emplace_back(Text{a.to, Level::atom, std::nullopt}, v);
            continue;
        }
        if (!language.arguments.empty() && a.letter == '\0')
            return refuse(
                here, "a call can set " + std::to_string(language.arguments.size()) + " arguments, this one has more");
        const bool bare = v.number || v.level == Level::atom;
        given += filled(*form, {{"letter", std::string(1, a.letter)},
                                {"value", v.text},
                                {"bracketed", bare ? v.text : language.open + v.text + language.close},
                                {"comma", letters++ == 0 ? "" : ","}});
    }
    for (const auto& [to, from] : sets) assign(to, from);
    // A program that shares them works on the numbers of this one's own variables, for what it holds between two steps.
    const bool clash = naming.has_locals(*called) || naming.has_variables(*unit) || !counters_.empty() || *passes > 1;
    const bool own = clash && language.local_place != LocalPlace::name;
    const bool shared = !own && given.empty() && language.has("flow.call-shared");
    const std::string_view key = shared ? "flow.call-shared" : "flow.call";
    repeated(*passes, [&] { say(key, {{"name", program_name(*called)}, {"arguments", given}}, "a call"); });
    for (const auto& [to, from] : *back) assign(to, from);
}

void Writing::procedure(const program::ProcedureCall& p) {
    const auto text = p.arguments.empty() ? std::nullopt : constant_text(*unit, p.arguments.front());
    if (p.procedure == program::Procedure::message && text) {
        last_message_ = one_line(*text);
        const bool shown = language.has("flow.message");
        if (!shown) tell(here, "the message is a comment there");
        const std::string said = shown ? one_line(*text) : base::comment_text(*text, language.comments);
        static_cast<void>(say(shown ? "flow.message" : "flow.comment", {{"text", said}}, "a message"));
        return;
    }
    if (p.procedure == program::Procedure::abort && !p.arguments.empty())
        if (const auto said = joined_text(*unit, p.arguments.front())) return alarm(one_line(*said));
    if (p.procedure != program::Procedure::alarm || p.arguments.empty())
        return refuse(here, source(here) + " is not translated by structure");
    const Expr& e = unit->exprs[p.arguments.front()];
    const auto number = e.kind == ExprKind::number ? base::whole<int>(unit->numbers[e.a], 0, 1'000'000) : std::nullopt;
    if (!number) return refuse(here, "an alarm with a computed number is not translated by structure");
    alarm(std::to_string(*number) + " " + last_message_);
}

void Writing::alarm(const std::string& said) {
    const std::size_t digits = std::min(said.find_first_not_of("0123456789"), said.size());
    const std::int64_t number = base::parse_integer(std::string_view(said).substr(0, digits)).value_or(99);
    const int shown = static_cast<int>(number % 100);
    if (shown != number) tell(here, "the alarm " + std::to_string(number) + " has another number there");
    const std::string text(base::trim(std::string_view(said).substr(digits)));
    const std::size_t before = lines.size();
    static_cast<void>(say("flow.alarm",
                          {{"number", std::to_string(shown)},
                           {"two", (shown < 10 ? "0" : "") + std::to_string(shown)},
                           {"text", text.empty() ? "ALARM " + std::to_string(number) : text}},
                          "an alarm"));
    if (before > 0 && lines.size() > before && lines[before].text == lines[before - 1].text)
        lines.erase(lines.begin() + static_cast<std::ptrdiff_t>(before));  // the message stands there already
}

void Writing::define(const program::Define& d) {
    for (const program::Variable& v : d.variables) {
        const bool number = d.type <= program::Type::real && d.type != program::Type::character;
        if (!number || v.dimensions[0] != program::no_expr || v.values.size() > 1 || d.global)
            return refuse(v.where, "DEF " + input.names->text(v.name) +
                                       ": of variables, numbers without an index are translated by structure");
        const auto name = naming.variable(*unit, v.name);
        if (!name) return refuse(v.where, "there is no parameter left for " + input.names->text(v.name));
        Text first = v.values.empty() ? number_text(0) : value(v.values.front());
        if (!v.values.empty()) first = as_type(d.type, std::move(first), v.values.front());
        const bool whole = first.number && *first.number == std::trunc(*first.number);
        if (d.type != program::Type::real && d.type != program::Type::integer && !whole)
            refuse(v.where, input.names->text(v.name) +
                                " is no REAL: what rounds its first value is not translated by structure");
        assign({*name, Level::atom, std::nullopt}, first);
    }
}

void Writing::leave() {
    write_length();
    const bool main = unit == programs.front();
    if (!main) hand_back();
    if (main && !unit->traits->repeats_program.empty()) {
        if (language.has("flow.begin-anew")) return static_cast<void>(say("flow.begin-anew", {}, "a repetition"));
        return refuse(here, source(here) + ": the program begins anew without end, for which the control has no word",
                      "write M30");
    }
    // What ends a program there says that it goes back.
    if (!main && !in_tail_ && at + 1 == unit->statements.size() && language.find("flow.sub-end") != nullptr &&
        end_label_.empty())
        return;
    if (language.has("flow.return"))
        return static_cast<void>(say("flow.return", {{"name", program_name(*unit)}}, "a return"));
    if (end_label_.empty()) end_label_ = fresh_label();
    jump(end_label_);
}

void Writing::end_all() {
    write_length();
    if (unit == programs.front()) return static_cast<void>(say("flow.end", {}, "the end"));
    if (!unit->traits->end_stops_all) return leave();
    if (language.end_stops_all) return static_cast<void>(say("flow.end", {}, "the end"));
    tell(here, "the end of all programs in a called one is an alarm there, which stops them");
    alarm("99 " + (last_message_.empty() ? "END OF ALL PROGRAMS" : last_message_));
}

void Writing::begin_program(const Unit& u, bool main) {
    std::string parameters;
    for (const Argument& a : naming.arguments(u)) {
        const bool by_reference = a.index < u.parameters.size() && u.parameters[a.index].by_reference;
        const std::string reference = by_reference ? language.text_or_none("flow.by-reference") : "";
        parameters += (parameters.empty() ? "" : ", ") + reference + ("REAL " + a.to);
    }
    static_cast<void>(say(main ? "flow.main-begin" : "flow.sub-begin",
                          {{"name", program_name(u)}, {"parameters", parameters.empty() ? "" : "(" + parameters + ")"}},
                          "the beginning of a program"));
    if (main || language.local_place != LocalPlace::name || language.has("parameters.declare")) return;
    std::size_t n = 0;  // what the call passes has numbers there
    for (const Argument& a : naming.arguments(u))
        assign({a.to, Level::atom, std::nullopt}, {"#" + std::to_string(++n), Level::atom, std::nullopt});
}

void Writing::end_program(const Unit& u, bool main) {
    write_length();
    if (!end_label_.empty()) place(end_label_);
    if (const std::string* text = language.find(main ? "flow.main-end" : "flow.sub-end");
        text != nullptr && !text->empty() && (main || lines.back().text != *text))  // its return may be that already
        static_cast<void>(say(main ? "flow.main-end" : "flow.sub-end", {{"name", program_name(u)}}, "the end"));
}

}  // namespace obrys::rewrite
