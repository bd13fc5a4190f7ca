#pragma once
/// What the parameters and variables of all programs are called in the other language.

#include <map>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "program/names.hpp"
#include "program/unit.hpp"
#include "rewrite/language.hpp"
#include "rewrite/rewrite.hpp"

namespace obrys::rewrite {

/// Of a called program.
struct Argument {
    std::size_t index = 0;  ///< among those of the call
    char letter = 0;        ///< that sets it; 0: its place does
    std::string to;         ///< what the program calls it; empty: there is no room for it
};

class Naming {
public:
    Naming(const Language& language, const program::Names& names) : language_(language), names_(names) {}

    /// Gives every parameter and variable that the programs name its place, those that can keep their number first.
    void collect(const std::vector<const program::Unit*>& programs);

    /// Of a parameter or variable; nothing where the language has no room for it.
    [[nodiscard]] std::optional<std::string> parameter(const program::Unit& unit, std::uint32_t number) const;
    [[nodiscard]] std::optional<std::string> variable(const program::Unit& unit, program::NameId name) const;
    /// A place of the program's own that nothing else uses, until `release`; nothing where there is none left.
    std::optional<std::string> scratch(const program::Unit& unit);
    /// The same for good; `wanted` where it may have a name.
    std::optional<std::string> keeper(const program::Unit& unit, const std::string& wanted);
    /// A parameter that all programs have in common, for good.
    std::optional<std::string> in_common() { return take(language_.global, taken_, std::nullopt); }
    void release(const program::Unit& unit) { used_[&unit] = 0; }

    /// What the program takes, in order.
    [[nodiscard]] std::vector<Argument> arguments(const program::Unit& unit) const;
    /// Names of its own that a program has to declare, in the order in which it met them.
    [[nodiscard]] const std::vector<std::string>& declared(const program::Unit& unit) { return declared_[&unit]; }
    /// The program itself names variables of its own.
    [[nodiscard]] bool has_variables(const program::Unit& unit) const { return variables_.contains(&unit); }
    /// Something is kept in a place that `keeper` gave.
    [[nodiscard]] bool keeps(const program::Unit& unit) const { return keeps_.contains(&unit); }
    /// It has variables of its own.
    [[nodiscard]] bool has_locals(const program::Unit& unit) const { return locals_.contains(&unit); }
    [[nodiscard]] std::vector<Renamed> all() const;

private:
    /// Whose (null: all programs'), whether it is numbered, and number or name.
    using Key = std::tuple<const program::Unit*, bool, std::uint32_t>;
    [[nodiscard]] Key key_of(const program::Unit& unit, std::uint32_t number) const;
    [[nodiscard]] Key key_of_name(const program::Unit& unit, program::NameId name) const;
    void met(const program::Unit& unit, const program::Expr& e);
    void met_in_cycle(const program::Unit& unit, const program::CycleDefinition& c);
    struct Formal {
        std::size_t index;
        Key key;
    };
    [[nodiscard]] std::vector<Formal> formals(const program::Unit& unit) const;
    void give(const Key& key);
    void give_arguments(const program::Unit& unit);
    std::optional<std::string> take(const std::vector<Pool>& pools, std::set<std::string>& taken,
                                    std::optional<std::uint32_t> wanted);
    [[nodiscard]] std::set<std::string>& taken_by(const program::Unit& unit);
    std::optional<std::string> local(const program::Unit& unit, const std::string& wanted);

    const Language& language_;
    const program::Names& names_;
    const program::Traits* traits_ = nullptr;
    std::set<Key> met_;
    std::set<std::uint32_t> passed_;  ///< numbers of parameters that calls set
    std::map<Key, std::string> given_;
    std::set<std::string> taken_, taken_of_file_;
    std::map<const program::Unit*, std::set<std::string>> taken_of_;
    std::map<const program::Unit*, std::vector<std::string>> scratch_, declared_;
    std::map<const program::Unit*, std::size_t> used_;
    std::set<const program::Unit*> locals_, variables_, keeps_;
};

/// Whether every program has this parameter for itself.
[[nodiscard]] bool is_local(const program::Traits& traits, std::uint32_t number);

}  // namespace obrys::rewrite
