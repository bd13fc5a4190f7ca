/// Arguments that a called program gives back (VAR). Where the control has none, they go in by value, and the program
/// leaves them where the caller fetches them when it is back.

#include <algorithm>

#include "rewrite/writing.hpp"

namespace obrys::rewrite {

std::optional<std::string> Writing::place_of_reference(const Unit& called, const Argument& a) {
    if (language.local_place == LocalPlace::file) return a.to;  // which the caller can read itself
    const auto [place, is_new] = references_.try_emplace({&called, a.index});
    if (is_new) place->second = naming.in_common();
    return place->second;
}

std::optional<std::vector<std::pair<Text, Text>>> Writing::given_back(const program::Call& c, const Unit& called) {
    std::vector<std::pair<Text, Text>> out;
    std::vector<std::string> seen;
    const auto no = [&](const std::string& what, const std::string& remedy = "") {
        refuse(here, what, remedy);
        return std::nullopt;
    };
    for (const Argument& a : naming.arguments(called)) {
        if (a.index >= called.parameters.size() || !called.parameters[a.index].by_reference) continue;
        const ExprId id = a.index < c.arguments.size() ? c.arguments[a.index] : program::no_expr;
        if (id == program::no_expr) continue;
        const Expr& e = unit->exprs[id];
        if (e.kind != ExprKind::variable || e.count != 0)
            return no(source(span(id)) + ": what VAR gives back goes into a variable made by DEF, of a single number");
        const auto to = target_of(id);
        if (!to) return std::nullopt;
        if (std::find(seen.begin(), seen.end(), to->text) != seen.end())
            return no(source(span(id)) + " is given by VAR twice: that is not translated by structure",
                      "give a variable of its own");
        seen.push_back(to->text);
        if (language.has("flow.by-reference")) continue;
        const auto from = place_of_reference(called, a);
        if (!from) return no("there is no parameter left for what VAR gives back");
        out.emplace_back(*to, Text{*from, Level::atom, std::nullopt});
    }
    return out;
}

void Writing::hand_back() {
    if (language.has("flow.by-reference") || language.local_place == LocalPlace::file) return;
    for (const Argument& a : naming.arguments(*unit)) {
        if (a.index >= unit->parameters.size() || !unit->parameters[a.index].by_reference) continue;
        const auto place = place_of_reference(*unit, a);
        if (!place) return refuse(here, "there is no parameter left for what VAR gives back");
        assign({*place, Level::atom, std::nullopt}, {a.to, Level::atom, std::nullopt});
    }
}

}  // namespace obrys::rewrite
