/// Cycles: a definition sets its parameters, a call becomes that of a program that does what the cycle does.

#include <algorithm>

#include "base/text.hpp"
#include "cl/cycle.hpp"
#include "rewrite/contour_text.hpp"

namespace obrys::rewrite {

using program::CycleDefinition;
using program::CycleSetting;

namespace {

bool takes_contour(cl::CycleKind kind) { return kind == cl::CycleKind::contour_train; }

bool is_frame(cl::CycleKind kind) {
    using cl::CycleKind;
    return kind == CycleKind::datum_shift || kind == CycleKind::rotation || kind == CycleKind::mirror ||
           kind == CycleKind::scaling;
}

/// The first place of the text that has no value; empty where all have.
std::string missing_place(std::string_view text, const Places& places) {
    for (std::size_t open = text.find('{'); open != std::string_view::npos; open = text.find('{', open + 1)) {
        const std::string_view name = text.substr(open + 1, text.find('}', open) - open - 1);
        const auto same = [&](const auto& place) { return place.first == name; };
        if (std::none_of(places.begin(), places.end(), same)) return std::string(name);
    }
    return {};
}

/// A number with or without signs.
std::optional<double> constant_of(const Unit& unit, ExprId id) {
    if (id == program::no_expr) return std::nullopt;
    const Expr& e = unit.exprs[id];
    if (e.kind == ExprKind::number) return unit.numbers[e.a];
    const auto v = e.kind == ExprKind::unary ? constant_of(unit, e.a) : std::nullopt;
    if (v && static_cast<Operator>(e.op) == Operator::negate) return -*v;
    return v && static_cast<Operator>(e.op) == Operator::plus ? v : std::nullopt;
}

/// The text has a place of this name.
bool names_place(std::string_view text, std::string_view name) {
    return text.find("{" + std::string(name) + "}") != std::string_view::npos;
}

}  // namespace

struct Writing::NamedContour {
    int place;
    std::string name;
    ContourText text;
};

bool Writing::is_assigned(std::uint32_t parameter) {
    if (!assigned_) {
        assigned_.emplace();
        for (const Unit* u : programs)
            for (const program::Assign& a : u->assigns)
                if (u->exprs[a.target].kind == ExprKind::parameter) assigned_->insert(u->exprs[a.target].a);
    }
    return assigned_->contains(parameter);
}

/// What the definition gives is the cycle's own: where the program gives the parameter values elsewhere, it goes there
/// by another one, so that who sets the program's value from outside does not set the cycle's.
void Writing::set_of_cycle(const CycleDefinition& d, const CycleSetting& s) {
    if (s.incremental || s.as_modal || s.given != program::SettingGiven::number)
        return refuse(s.where, d.name + ": " + source(s.where) + " is not translated by structure",
                      "give the value as a number or a parameter");
    Text v = value(s.value);
    const auto to = naming.parameter(*unit, s.parameter);
    if (!to) return refuse(s.where, "there is no parameter left for " + source(s.where));
    if (v.text == *to) return;
    if (v.number && is_assigned(s.parameter)) {
        const Text held = place_for(s.value);
        assign(held, v);
        v = held;
    }
    assign({*to, Level::atom, std::nullopt}, v);
}

void Writing::cycle_definition(const CycleDefinition& d) {
    if (d.kind == cl::CycleKind::contour_definition) return;
    if (is_frame(d.kind)) return frame_cycle(d);
    const CycleProgram* program = language.cycle(d.kind);
    if (program == nullptr || !d.call_active)
        return refuse(here, source(here) + " is not translated by structure",
                      "translate without --keep: its moves are written then");
    for (const CycleSetting& s : d.settings) {
        const bool said = names_place(program->call, cl::spelling(s.role));
        const auto literal = constant_of(*unit, s.value);
        if (!said && literal != 0.0)
            return refuse(s.where, d.name + ": " + source(s.where) + " is not translated by structure");
        if (said && !(literal && !naming.parameter(*unit, s.parameter))) set_of_cycle(d, s);
    }
}

/// The contour of a cycle that is called here; nothing after a complaint.
std::optional<Writing::NamedContour> Writing::contour_here() {
    const int said = held()[Mode::contour];
    if (said < 0) {
        refuse(here, said == nowhere ? "no contour is defined for this cycle"
                                     : "which contour is meant here depends on the way that the run has come");
        return std::nullopt;
    }
    const StatementPlace place = place_of(said);
    const Unit& of = *programs[place.program];
    const CycleDefinition& d = of.cycles[entry_of(of, place.statement)];
    const Expr* label = d.texts.size() == 1 ? &of.exprs[d.texts.front()] : nullptr;
    if (label == nullptr || label->kind != ExprKind::text) {
        refuse(d.where, d.name + ": a contour of one label is translated by structure");
        return std::nullopt;
    }
    const std::string name = base::to_upper(of.texts[label->a]);
    const auto id = input.names->find(name);
    const auto first = id ? labelled(of, 0, *id, program::JumpDirection::either) : std::nullopt;
    if (!first) {
        refuse(d.where, d.name + ": there is no label " + name);
        return std::nullopt;
    }
    Range range{*first, *first};
    while (range.last < of.statements.size() && of.statements[range.last].kind != StatementKind::label_end)
        ++range.last;
    auto contour = contour_text(of, range);
    if (!contour) return std::nullopt;
    return NamedContour{said, of.name + " LBL " + name, std::move(*contour)};
}

/// A name for what stands for a cycle; empty where it has none yet.
std::string& Writing::name_of_cycle(const CycleDefinition& d, int contour) {
    std::string& name = cycle_programs_[{d.kind, contour}];
    return name;
}

std::string Writing::fresh_cycle_name(const CycleDefinition& d) const {
    const std::string n = std::to_string(cycle_programs_.size());
    if (language.numbered_programs) return std::to_string(3000 + cycle_programs_.size());
    std::string name = base::to_upper(cl::spelling(d.kind));
    std::replace(name.begin(), name.end(), '-', '_');
    return name + "_" + n;
}

const std::string* Writing::cycle_program(const CycleDefinition& d, const CycleProgram& p) {
    if (!takes_contour(d.kind)) {
        std::string& name = name_of_cycle(d, nowhere);
        if (!name.empty()) return &name;
        name = fresh_cycle_name(d);
        said_behind_.push_back({filled(p.text, {{"name", name}, {"cycle", d.name}}), here});
        tell(here, d.name + " is the program " + name + " there");
        return &name;
    }
    const auto contour = contour_here();
    if (!contour) return nullptr;
    std::string& name = name_of_cycle(d, contour->place);
    if (!name.empty()) return &name;
    name = fresh_cycle_name(d);
    const Text away{p.away, Level::atom, std::nullopt};
    const ContourText &there = contour->text, back = there.reversed();
    const Place begin = beside(*this, there, false, away), end = beside(*this, there, true, away);
    const auto side = [&](const ContourText& c) {
        const std::string_view key = c.side > 0 ? "words.comp-left" : c.side < 0 ? "words.comp-right" : "";
        return c.side == 0 ? std::string() : *language.find(key);
    };
    const std::string& feed = p.feed;
    said_behind_.push_back({filled(p.text, {{"name", name},
                                            {"cycle", d.name},
                                            {"contour", contour->name},
                                            {"side", std::to_string(there.side)},
                                            {"begin-x", begin.u.text},
                                            {"begin-y", begin.v.text},
                                            {"end-x", end.u.text},
                                            {"end-y", end.v.text},
                                            {"first-x", there.from.u.text},
                                            {"first-y", there.from.v.text},
                                            {"last-x", back.from.u.text},
                                            {"last-y", back.from.v.text},
                                            {"side-there", side(there)},
                                            {"side-back", side(back)},
                                            {"there", contour_blocks(there, feed)},
                                            {"back", contour_blocks(back, feed)}}),
                            here});
    tell(here, d.name + " is the program " + name + " there, along " + contour->name);
    return &name;
}

void Writing::cycle_call() {
    const int said = held()[Mode::cycle];
    if (said < 0)
        return refuse(here, said == nowhere ? "no cycle is defined that could be called here"
                                            : "which cycle is called here depends on the way that the run has come");
    const StatementPlace place = place_of(said);
    const Unit& of = *programs[place.program];
    const CycleDefinition& d = of.cycles[entry_of(of, place.statement)];
    const CycleProgram* program = language.cycle(d.kind);
    if (program == nullptr)
        return refuse(here, d.name + " is not translated by structure to this control",
                      "translate without --keep: its moves are written then");
    if (held()[Mode::plane] != 17)
        return refuse(here, d.name + " outside the plane of X and Y is not translated by structure");
    const std::string* name = cycle_program(d, *program);
    if (name == nullptr) return;
    Places values{{"name", *name}};
    for (const CycleSetting& s : d.settings) {
        const auto literal = constant_of(of, s.value);
        const auto parameter = naming.parameter(of, s.parameter);
        if (parameter || literal) values.emplace_back(cl::spelling(s.role), parameter ? *parameter : number(*literal));
    }
    if (const std::string role = missing_place(program->call, values); !role.empty())
        return refuse(here, d.name + " does not say its " + role, "write it in the definition");
    say(filled(program->call, values));
}

}  // namespace obrys::rewrite
