/// What the job gives for variables that no program at hand sets.

#include <algorithm>
#include <set>

#include "base/codes.hpp"
#include "base/number.hpp"
#include "base/text.hpp"
#include "interp/values/values.hpp"

namespace obrys::interp {

namespace codes = base::codes;
using shop::GivenKind;
using shop::GivenValue;

namespace {

Value value_of(const GivenValue& g) {
    switch (g.kind) {
        case GivenKind::number: return Value::real(g.number);
        case GivenKind::truth: return Value::boolean(g.number != 0);
        case GivenKind::text: break;
    }
    return Value::string(g.text);
}

/// A value that cannot be used: the run does not begin.
void refuse_given(Saying& run, const GivenValue& g, std::string text, std::string remedy = {}) {
    run.stopped = true;
    run.diagnostics->add({base::Severity::error,
                          codes::job_value,
                          g.where,
                          "[variables] " + std::move(text),
                          std::move(remedy),
                          {},
                          {}});
}

void give_parameter(Reckoning& run, std::uint32_t n, const std::string& key, const GivenValue& g) {
    const bool empties = run.traits->empty_parameters && base::equals_ignoring_case(g.text, "empty");
    if (g.kind == GivenKind::text && empties)
        run.parameters.set_empty_by_control(n);
    else if (g.kind == GivenKind::text)
        refuse_given(run, g, key + " holds a number, not a text",
                     run.traits->empty_parameters ? "write \"empty\" for one that holds nothing" : "");
    else
        run.parameters.set_by_control(n, g.number);
}

/// The numbers between brackets; nothing where one is none.
std::optional<std::vector<double>> indices_of(std::string_view text) {
    std::vector<double> indices;
    while (!text.empty()) {
        const auto comma = std::min(text.find_first_of(",]"), text.size());
        const auto n = base::parse_integer(text.substr(0, comma));
        if (!n || indices.size() == 3) return std::nullopt;
        indices.push_back(static_cast<double>(*n));
        text.remove_prefix(std::min(comma + 1, text.size()));
        if (text.starts_with('[')) text.remove_prefix(1);  // [1][2]
    }
    return indices;
}

void give_element(Saying& run, Array& array, const std::string& key, const GivenValue& g) {
    const auto bracket = std::min(key.find('['), key.size());
    const auto indices = indices_of(std::string_view(key).substr(std::min(bracket + 1, key.size())));
    std::size_t index = 0;
    const int written = indices ? static_cast<int>(indices->size()) : -1;
    if (written != array.rank || !element_index(array, indices->data(), indices->size(), index)) {
        std::string sizes;
        for (int k = 0; k < array.rank; ++k)
            sizes += (k > 0 ? "," : "") + std::to_string(array.dimensions[static_cast<std::size_t>(k)]);
        const std::string name = key.substr(0, bracket);
        return refuse_given(
            run, g,
            key + (array.rank == 0 ? ": " + name + " is no array" : ": " + name + " is defined with [" + sizes + "]"),
            array.rank == 0 ? "give " + name + " without an index"
                            : "indices begin with 0; all elements at once: " + name + " = [ … ]");
    }
    Value v = value_of(g);
    if (convert(v, array.type, array.string_length) == Conversion::ok)
        array.set(index, v);
    else
        refuse_given(run, g, key + " does not fit its definition as " + std::string(name(array.type)));
}

/// A name that no definition file holds: the value gives the type.
void give_name(Saying& run, program::NameId id, const GivenValue& g) {
    auto array = std::make_shared<Array>();
    const Value v = value_of(g);
    array->type = v.type;
    array->allocate();
    array->set(0, v);
    run.globals.bind({id, std::move(array), 0, false, nullptr});
}

/// An element of a name that no definition file holds.
void give_undefined(Reckoning& run, program::NameId id, const std::string& key, const GivenValue& g) {
    const auto indices = indices_of(std::string_view(key).substr(key.find('[') + 1));
    if (!indices) return;  // $AC_DRF[X]: asked by its spelling
    std::size_t place = 0;
    for (const double index : *indices) place = place * 65536 + undefined_part(index);
    run.undefined.set(id, place, value_of(g));
}

/// Name of a variable without what belongs to its control's spelling: "MY_I" of MY_I[2], "_GAP" of #<_GAP>.
std::string_view bare_name(std::string_view key) {
    if (key.starts_with("#<") && key.ends_with('>')) return key.substr(2, key.size() - 3);
    return key.substr(0, key.find('['));
}

/// Whether the control has a variable that is written so, by the form of its name.
bool is_name_of_control(const program::Traits& t, std::string_view key) {
    const bool in_angles = key.starts_with("#<") && key.ends_with('>');
    switch (t.named_variables) {
        case program::NamedVariables::plain: return !key.starts_with('#');
        case program::NamedVariables::in_angles: return in_angles;
        case program::NamedVariables::none: break;
    }
    const bool text = !t.text_letters.empty() && key.starts_with(t.text_letters);
    return text && base::parse_integer(key.substr(t.text_letters.size()));
}

/// Number of the parameter that a key names, also R[1] for R1 where names have elements; past the last: none.
std::uint32_t parameter_of_key(const program::Traits& t, std::string_view key) {
    const auto bracket = key.find('[');
    if (bracket == std::string_view::npos || !key.ends_with(']') || t.named_variables != program::NamedVariables::plain)
        return program::find_parameter(t, key);
    const std::string_view index = key.substr(bracket + 1, key.size() - bracket - 2);
    return program::find_parameter(t, std::string(key.substr(0, bracket)) + std::string(index));
}

/// "#7" for R7: the number as this control writes it; else its names by an example.
std::string nearest_variable(const program::Traits& t, std::string_view key) {
    const std::size_t digits = std::min(key.find_first_of("0123456789"), key.size());
    const auto number = base::parse_integer(key.substr(digits));
    const std::string letters(t.banks[0].letters);
    if (number && *number >= 0 && *number < t.banks[0].count) return letters + std::to_string(*number);
    return letters + "1, " + letters + "2 …" +
           (t.named_variables == program::NamedVariables::in_angles ? " or #<name>" : "");
}

/// What the job says of a variable that the control cannot have is a slip of the pen.
void refuse_foreign_keys(Reckoning& run) {
    std::set<std::string_view> said;  // of an array one element
    for (const auto& [key, g] : run.env.variables) {
        if (parameter_of_key(*run.traits, key) < run.parameters.count()) continue;
        const std::string_view bare = std::string_view(key).substr(0, key.ends_with(']') ? key.find('[') : key.size());
        const bool bank = bare != key && program::find_parameter(*run.traits, std::string(bare) + "0") == 0;
        const bool numbered = bank || program::find_parameter(*run.traits, bare) < run.parameters.count();
        const bool foreign = !numbered && !is_name_of_control(*run.traits, bare);
        if ((!foreign && (!numbered || bare == key)) || !said.insert(bare).second) continue;
        if (foreign)
            refuse_given(run, g, std::string(bare) + " is no variable of this control",
                         "write " + nearest_variable(*run.traits, bare) + ", as the program writes it");
        else
            refuse_given(run, g,
                         bank ? key + " is none of the parameters " + std::string(bare)
                              : std::string(bare) + " is one number: it has no elements");
    }
}

}  // namespace

void take_given(Reckoning& run) {
    refuse_foreign_keys(run);
    if (run.stopped) return;
    if (run.env.stored != nullptr)
        for (const auto& [n, v] : *run.env.stored)
            if (n < run.parameters.count()) run.parameters.set_by_control(n, v);
    if (run.env.backups != nullptr)
        for (const Unit* unit : *run.env.backups) take_backup(run, *unit);
    for (const auto& [key, g] : run.env.variables) run.given.insert_or_assign(key, g);
    for (const auto& [key, g] : run.given) {
        const std::uint32_t n = parameter_of_key(*run.traits, key);
        if (n < run.parameters.count()) {
            give_parameter(run, n, key, g);
            continue;
        }
        const std::string_view bare = bare_name(key);
        const program::NameId id = run.env.names.id(std::string(bare));
        if (const Binding* known = run.globals.find(id))
            give_element(run, *known->array, key, g);
        else if (bare.starts_with('$') || bare.starts_with('#'))
            continue;  // asked by its spelling where it is read
        else if (key.ends_with(']'))
            give_undefined(run, id, key, g);
        else
            give_name(run, id, g);
    }
}

std::optional<Value> given_value(const Reckoning& run, std::string_view key) {
    if (run.given.empty()) return std::nullopt;
    const auto found = run.given.find(shop::given_key(key));
    if (found == run.given.end()) return std::nullopt;
    return value_of(found->second);
}

std::string job_key(const std::string& name) {
    const bool bare =
        name.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_-") == std::string::npos;
    return bare && !name.empty() ? name : "\"" + name + "\"";
}

bool give_argument(Reckoning& run, Array& array, const std::string& name) {
    bool found = false;
    for (const auto& [key, g] : run.given) {
        if (bare_name(key) != name) continue;
        give_element(run, array, key, g);
        found = true;
    }
    return found;
}

std::string given_remedy(const std::string& key) {
    return "[variables] of the job can give it: " + job_key(key) + " = …";
}

namespace {

/// "MY_I[2]": an element by the name of its definition.
std::string element_key(const Saying& run, const Array& a, std::size_t index) {
    std::string indices;
    for (int k = a.rank - 1; k >= 0; --k) {
        const std::uint32_t n = a.dimensions[static_cast<std::size_t>(k)];
        indices = std::to_string(index % n) + (indices.empty() ? "" : ",") + indices;
        index /= n;
    }
    return run.env.names.text(a.name) + (a.rank > 0 ? "[" + indices + "]" : "");
}

}  // namespace

void note_held(Saying& run, const Array& a, std::size_t index, const base::Span& where) {
    const Held held = a.held_by(index);
    if (held == Held::own) return;
    const std::string key = element_key(run, a, index);
    if (held == Held::definition)
        return assume(run, where,
                      key + " is read before a program sets it: " + printed(a.get(index)) + " as its definition says",
                      "the control may hold another value; " + given_remedy(key));
    unchecked(run, codes::unknown_value, where,
              held == Held::argument
                  ? "the argument " + key + " is not known: this program is run without its call"
                  : key + " is not known: no program sets it before, and the control keeps what it held",
              given_remedy(key));
}

std::string variable_key(Reckoning& run, const program::Expr& e) {
    std::string key = run.env.names.text(e.a);
    const std::size_t component = is_component(run, e) ? e.count - std::size_t{1} : e.count;  // TR of $P_UIFR[1,X,TR]
    for (std::size_t k = 0; k < e.count && !run.stopped; ++k) {
        const ExprId index = run.unit().children[e.b + k];
        key += (k == 0 ? "[" : ",") +
               (k == component ? run.env.names.text(run.unit().exprs[index].a) : printed(evaluate(run, index)));
    }
    return e.count > 0 ? key + "]" : key;
}

}  // namespace obrys::interp
