#include "rewrite/names.hpp"

#include <algorithm>

#include "base/text.hpp"
#include "rewrite/good_name.hpp"

namespace obrys::rewrite {

using program::Expr;
using program::ExprKind;
using program::NameId;
using program::Unit;

bool is_local(const program::Traits& traits, std::uint32_t number) {
    if (traits.argument_parameters != 0) return number >= 1 && number <= traits.argument_parameters;
    for (const program::ParameterBank& bank : traits.banks) {
        if (number < bank.count) return bank.local;
        number -= bank.count;
    }
    return false;
}

namespace {

/// A variable that the program itself makes, or has as an argument.
bool is_own(const Unit& unit, NameId name, const std::string& text) {
    if (unit.traits->variables_by_assignment) return !text.starts_with('_');
    const auto same = [&](const auto& v) { return v.name == name; };
    if (std::any_of(unit.parameters.begin(), unit.parameters.end(), same)) return true;
    return std::any_of(unit.defines.begin(), unit.defines.end(), [&](const program::Define& d) {
        return !d.global && std::any_of(d.variables.begin(), d.variables.end(), same);
    });
}

}  // namespace

Naming::Key Naming::key_of(const Unit& unit, std::uint32_t number) const {
    return {is_local(*unit.traits, number) ? &unit : nullptr, true, number};
}

Naming::Key Naming::key_of_name(const Unit& unit, NameId name) const {
    return {is_own(unit, name, names_.text(name)) ? &unit : nullptr, false, name};
}

void Naming::met(const Unit& unit, const Expr& e) {
    if (e.kind != ExprKind::parameter && e.kind != ExprKind::variable) return;
    if (e.kind == ExprKind::parameter && e.a == 0 && unit.traits->parameters_begin_at_one) return;
    met_.insert(e.kind == ExprKind::parameter ? key_of(unit, e.a) : key_of_name(unit, e.a));
}

/// A value that a definition computes stays in its parameter until the call.
void Naming::met_in_cycle(const Unit& unit, const program::CycleDefinition& c) {
    if (language_.cycle(c.kind) == nullptr) return;
    for (const program::CycleSetting& s : c.settings) {
        if (s.parameter == program::no_target || s.value == program::no_expr) continue;
        std::uint32_t at = s.value;
        while (unit.exprs[at].kind == ExprKind::unary) at = unit.exprs[at].a;
        if (unit.exprs[at].kind != ExprKind::number) met_.insert(key_of(unit, s.parameter));
    }
}

std::optional<std::string> Naming::take(const std::vector<Pool>& pools, std::set<std::string>& taken,
                                        std::optional<std::uint32_t> wanted) {
    for (const Pool& pool : pools) {
        if (!wanted || *wanted < pool.first || *wanted > pool.last) continue;
        if (const std::string text = pool.letters + std::to_string(*wanted); taken.insert(text).second) return text;
    }
    if (wanted) return std::nullopt;
    if (&pools == &language_.local) {
        for (const Pool& pool : pools)
            for (std::uint32_t n = pool.first; n <= pool.last; ++n)
                if (const std::string text = pool.letters + std::to_string(n); taken.insert(text).second) return text;
        return std::nullopt;
    }
    // From the end of the last pool: what keeps its number stands at the begin of the first.
    for (auto pool = pools.rbegin(); pool != pools.rend(); ++pool)
        for (std::uint32_t n = pool->last + 1; n-- > pool->first;)
            if (const std::string text = pool->letters + std::to_string(n); taken.insert(text).second) return text;
    return std::nullopt;
}

std::set<std::string>& Naming::taken_by(const Unit& unit) {
    return language_.local_place == LocalPlace::file ? taken_of_file_ : taken_of_[&unit];
}

std::optional<std::string> Naming::local(const Unit& unit, const std::string& wanted) {
    locals_.insert(&unit);
    std::set<std::string>& taken = taken_by(unit);
    if (language_.local_place != LocalPlace::name) return take(language_.local, taken, std::nullopt);
    const std::string good = good_name(wanted, Named::variable, "V_", language_);
    std::string name = good;
    for (std::string end = "_"; !taken.insert(name).second; end += '_')
        name = with_end(good, end, Named::variable, language_);
    declared_[&unit].push_back(name);
    const std::string* spelling = language_.find("parameters.own");
    return spelling == nullptr ? name : filled(*spelling, {{"name", name}});
}

std::vector<Naming::Formal> Naming::formals(const Unit& unit) const {
    std::vector<Formal> out;
    for (std::size_t i = 0; i < unit.parameters.size(); ++i)
        out.push_back({i, key_of_name(unit, unit.parameters[i].name)});
    for (const std::uint32_t n : passed_)
        if (const Key key = key_of(unit, n); met_.contains(key)) out.push_back({n - 1, key});
    return out;
}

/// Arguments that are numbered there have the numbers that their letters or places set.
void Naming::give_arguments(const Unit& unit) {
    const std::vector<Formal> formal = formals(unit);
    for (std::size_t i = 0; i < formal.size() && i < language_.argument_numbers.size(); ++i) {
        const std::string text = language_.local.front().letters + std::to_string(language_.argument_numbers[i]);
        taken_by(unit).insert(text);
        given_[formal[i].key] = text;
        locals_.insert(&unit);
    }
}

std::vector<Argument> Naming::arguments(const Unit& unit) const {
    std::vector<Argument> out;
    const std::vector<Formal> formal = formals(unit);
    for (std::size_t i = 0; i < formal.size(); ++i) {
        const auto found = given_.find(formal[i].key);
        out.push_back({formal[i].index, i < language_.arguments.size() ? language_.arguments[i] : '\0',
                       found == given_.end() ? "" : found->second});
    }
    return out;
}

void Naming::give(const Key& key) {
    const auto& [unit, numbered, id] = key;
    if (given_.contains(key)) return;
    std::optional<std::string> to;
    if (unit == nullptr)
        to = take(language_.global, taken_, std::nullopt);
    else
        to = local(*unit, numbered ? "P" + std::to_string(id) : names_.text(id));
    if (to) given_[key] = *to;
}

void Naming::collect(const std::vector<const Unit*>& programs) {
    traits_ = programs.front()->traits;
    for (const Unit* unit : programs) {
        for (const program::Parameter& p : unit->parameters) met_.insert(key_of_name(*unit, p.name));
        for (const Expr& e : unit->exprs) met(*unit, e);
        for (const program::Define& d : unit->defines)
            for (const program::Variable& v : d.variables) met_.insert(key_of_name(*unit, v.name));
        for (const program::CycleDefinition& c : unit->cycles) met_in_cycle(*unit, c);
        for (const program::Call& call : unit->calls)
            for (std::uint32_t n = 1; n <= call.arguments.size() && unit->traits->argument_parameters != 0; ++n)
                if (call.arguments[n - 1] != program::no_expr) passed_.insert(n);
    }
    const bool fixed = !language_.argument_numbers.empty() && !language_.local.empty();
    for (std::size_t i = 1; i < programs.size() && fixed; ++i) give_arguments(*programs[i]);
    // Where a language counts its local ones first, those that all have in common begin behind them.
    const std::uint32_t own = traits_->argument_parameters != 0 ? 100 : 0;
    for (const Key& key : met_) {
        const auto& [unit, numbered, id] = key;
        if (unit != nullptr || !numbered || id < own) continue;
        if (const auto to = take(language_.global, taken_, id - own + language_.shift)) given_[key] = *to;
    }
    const auto give_all_of = [&](const Unit* unit) {
        for (auto at = met_.lower_bound(Key{unit, false, 0}); at != met_.end() && std::get<0>(*at) == unit; ++at)
            give(*at);
    };
    for (const Unit* unit : programs) give_all_of(unit);
    give_all_of(nullptr);
    variables_ = locals_;
}

std::optional<std::string> Naming::parameter(const Unit& unit, std::uint32_t number) const {
    const auto found = given_.find(key_of(unit, number));
    return found == given_.end() ? std::nullopt : std::optional(found->second);
}

std::optional<std::string> Naming::variable(const Unit& unit, NameId name) const {
    const auto found = given_.find(key_of_name(unit, name));
    return found == given_.end() ? std::nullopt : std::optional(found->second);
}

std::optional<std::string> Naming::scratch(const Unit& unit) {
    std::vector<std::string>& all = scratch_[&unit];
    std::size_t& used = used_[&unit];
    if (used == all.size()) {
        auto place = local(unit, "TEMP_" + std::to_string(used + 1));
        if (!place) return std::nullopt;
        all.push_back(std::move(*place));
    }
    return all[used++];
}

std::optional<std::string> Naming::keeper(const Unit& unit, const std::string& wanted) {
    keeps_.insert(&unit);
    return local(unit, wanted);
}

std::vector<Renamed> Naming::all() const {
    std::vector<Renamed> out;
    for (const auto& [key, to] : given_) {
        const auto& [unit, numbered, id] = key;
        out.push_back({numbered ? program::parameter_name(*traits_, id) : names_.text(id), to,
                       unit != nullptr ? unit->name : ""});
    }
    // By program, not as their units happen to lie in memory.
    std::stable_sort(out.begin(), out.end(), [](const Renamed& a, const Renamed& b) { return a.program < b.program; });
    return out;
}

}  // namespace obrys::rewrite
