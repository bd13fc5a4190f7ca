/// DEF: variables with their types, sizes and first values.

#include <algorithm>
#include <cmath>

#include "base/codes.hpp"
#include "base/whole.hpp"
#include "interp/values/values.hpp"

namespace obrys::interp {

namespace codes = base::codes;

namespace {

constexpr std::size_t largest_array = 10'000'000;

double known_or(double v, double instead) { return std::isnan(v) ? instead : v; }

/// A value that [set] or --set puts in the place of the constant a definition begins with.
void replace_initial(Reckoning& run, Array& array, const program::Variable& v) {
    const auto replaced = run.overrides_by_name.find(v.name);
    if (replaced == run.overrides_by_name.end() || array.size() != 1 || array.type > Type::real) return;
    if (v.values.empty() || v.values[0] == program::no_expr || !is_constant(run.unit(), v.values[0])) return;
    assume(run, v.where,
           run.env.names.text(v.name) + "=" + printed(Value::real(replaced->second)) +
               " is set from outside and replaces the program's constant");
    store(run, array, 0, Value::real(replaced->second), v.where);
    run.overrides_met.insert(run.env.names.text(v.name));
}

void initialise(Reckoning& run, Array& array, const program::Variable& v) {
    const Unit& unit = run.unit();
    const bool repeat = v.initialiser == program::Initialiser::repeat;
    const std::size_t n = repeat ? array.size() : std::min(array.size(), v.values.size());
    for (std::size_t k = 0; k < n && !v.values.empty() && !run.stopped; ++k) {
        const ExprId id = v.values[repeat ? 0 : k];
        if (id != program::no_expr) store(run, array, k, evaluate(run, id), unit.span(id));
    }
    replace_initial(run, array, v);
}

/// Global user data keep what they held: not known where the definition gives no value, else perhaps overwritten.
void allocate(Reckoning& run, Array& array, const program::Variable& v, bool global) {
    if (!global) {
        array.allocate();
        return initialise(run, array, v);
    }
    array.name = v.name;
    array.allocate_unknown(Held::machine);
    initialise(run, array, v);
    const bool replaced = run.overrides_by_name.contains(v.name);
    for (Held& h : array.held)
        if (h == Held::own && !replaced) h = Held::definition;
}

}  // namespace

namespace {

constexpr double usual_text = 200, longest_text = 10'000;

/// n of STRING[n]; nothing behind an alarm.
std::optional<std::size_t> text_length(Reckoning& run, const program::Define& d, const Unit& unit) {
    const double n = known_or(number(run, d.string_length), usual_text);
    if (run.stopped) return std::nullopt;
    if (const auto whole = base::whole<std::size_t>(n, 1, static_cast<std::size_t>(longest_text))) return whole;
    alarm(run, codes::value_range, unit.span(d.string_length),
          "a text cannot have " + printed(Value::real(n)) + " characters here",
          "STRING[n] takes whole numbers from 1 to " + printed(Value::real(longest_text)));
    return std::nullopt;
}

/// Unit, statement: it does something, so that a definition may not follow it.
bool is_run(const Unit& unit, std::uint32_t index) {
    const program::Statement& s = unit.statements[index];
    if (s.kind != program::StatementKind::block) return s.kind != program::StatementKind::define;
    for (std::uint32_t w = s.first; w < unit.words_end(index); ++w)
        if (program::code_of(unit.words[w]) != program::Code::comment) return true;
    return false;
}

}  // namespace

void judge_place_of_definition(Saying& run, const Unit& unit, std::uint32_t index) {
    std::uint32_t first = 0;
    while (first < index && !is_run(unit, first)) ++first;
    if (first == index) return;
    unchecked(run, codes::unsupported, run.here(),
              "a definition stands behind a block that is run: the control stops here" +
                  of_alarm(run.traits->alarms.late_definition),
              "write it at the beginning of the program");
}

namespace {

std::size_t elements_of(const Scope& scope) {
    std::size_t sum = 0;
    for (const Binding& b : scope.bindings()) sum += b.element ? 0 : b.array->size();
    return sum;
}

/// All arrays together hold no more than one may: a control has a few thousand kilobytes for them.
bool fits(Saying& run, double size, const base::Span& where) {
    constexpr double small = 1000;  // not worth counting
    if (size <= small) return true;
    std::size_t sum = elements_of(run.globals);
    for (const Activation& a : run.calls) sum += elements_of(a.locals);
    if (static_cast<double>(sum) + size <= static_cast<double>(largest_array)) return true;
    unchecked(run, codes::budget, where,
              "the arrays of this run have more than " + std::to_string(largest_array) + " elements together",
              "no control has as much memory for them: define what is needed");
    run.stopped = true;
    run.ending = Ending::budget;
    return false;
}

}  // namespace

void define(Reckoning& run, const program::Define& d, Scope& scope, const Unit& unit) {
    for (const program::Variable& v : d.variables) {
        const Binding* known = scope.find(v.name);
        if (known != nullptr && known->definition == &v) continue;  // a jump back led past its DEF again
        if (known != nullptr && &scope == &run.calls.back().locals) {
            alarm(run, codes::duplicate_name, v.where, run.env.names.text(v.name) + " is defined twice");
            return;
        }
        auto array = std::make_shared<Array>();
        array->type = d.type;
        if (d.string_length != program::no_expr) {
            const auto length = text_length(run, d, unit);
            if (!length) return;
            array->string_length = *length;
        }
        double total = 1;
        for (std::size_t k = 0; k < 3 && v.dimensions[k] != program::no_expr; ++k) {
            const double n = number(run, v.dimensions[k]);
            total *= std::max(1.0, n);
            if (run.stopped) return;
            if (std::isnan(n)) {
                unchecked(run, codes::unknown_value, unit.span(v.dimensions[k]),
                          "the size of this array depends on a value that is not known");
                return;
            }
            if (!(n >= 1) || total > static_cast<double>(largest_array)) {
                alarm(run, codes::value_range, unit.span(v.dimensions[k]),
                      "an array cannot have " + printed(Value::real(n)) + " elements here");
                return;
            }
            array->dimensions[k] = base::clipped<std::uint32_t>(n, 1, largest_array);
            array->rank = static_cast<int>(k) + 1;
        }
        if (!fits(run, total, v.where)) return;
        allocate(run, *array, v, &scope == &run.globals);
        if (run.stopped) return;
        scope.bind({v.name, std::move(array), 0, false, &v});
    }
}

}  // namespace obrys::interp
