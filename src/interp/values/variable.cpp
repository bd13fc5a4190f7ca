/// Variables: found, addressed, read and stored.

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/codes.hpp"
#include "base/whole.hpp"
#include "interp/values/values.hpp"

namespace obrys::interp {

using program::Expr;
using program::ExprKind;
namespace codes = base::codes;

const Binding* find_variable(const Saying& run, program::NameId name) {
    if (const Binding* b = run.calls.back().locals.find(name)) return b;
    return run.globals.find(name);
}

bool element_of(Reckoning& run, const Expr& e, const Array& a, std::size_t& index) {
    if (e.count == 0 && a.rank == 0) {
        index = 0;
        return true;
    }
    const base::Span where{run.unit().file, e.begin, e.end};
    double indices[3] = {0, 0, 0};
    for (std::size_t k = 0; k < e.count && k < 3; ++k) indices[k] = number(run, run.unit().children[e.b + k]);
    if (run.stopped) return false;
    if (element_index(a, indices, e.count, index)) return true;
    if (std::isnan(indices[0]) || std::isnan(indices[1]) || std::isnan(indices[2])) {
        unchecked(run, codes::unknown_value, where, "which element this is depends on a value that is not known");
        return false;
    }
    std::string text;
    for (std::size_t k = 0; k < e.count && k < 3; ++k) text += (k > 0 ? "," : "") + printed(Value::real(indices[k]));
    std::string range;
    for (int k = 0; k < std::max(a.rank, 1); ++k)
        range +=
            (k > 0 ? ", " : "") + std::string("0 to ") + std::to_string(a.dimensions[static_cast<std::size_t>(k)] - 1);
    alarm(run, codes::index_range, where, "index [" + text + "] lies outside the array (" + range + ")");
    return false;
}

bool is_character_access(const Binding& b, const Expr& e) {
    return b.array->type == Type::string && e.count == (b.element ? 0 : b.array->rank) + 1;
}

namespace {

struct CharacterPlace {
    std::size_t element = 0, character = 0;
};

/// Nothing where the text is shorter (alarm) or an index is unknown.
std::optional<CharacterPlace> character_place(Reckoning& run, const Binding& b, const Expr& e) {
    Expr element = e;
    --element.count;
    CharacterPlace place{b.offset, 0};
    if (!b.element && !element_of(run, element, *b.array, place.element)) return std::nullopt;
    const double at = number(run, run.unit().children[e.b + element.count]);
    if (run.stopped || std::isnan(at)) return std::nullopt;
    note_held(run, *b.array, place.element, {run.unit().file, e.begin, e.end});
    const Value held = b.array->get(place.element);
    if (held.is_unknown()) return std::nullopt;
    const std::string& text = held.as_text();
    if (const auto n = base::cut<std::size_t>(at); n && at >= 0 && *n < text.size()) {
        place.character = *n;
        return place;
    }
    alarm(run, codes::index_range, {run.unit().file, e.begin, e.end},
          "character " + printed(Value::real(at)) + " lies outside the text \"" + text + "\"");
    return std::nullopt;
}

}  // namespace

Value read_character(Reckoning& run, const Binding& b, const Expr& e) {
    const auto place = character_place(run, b, e);
    if (!place) return Value::unknown();
    const char c = b.array->get(place->element).as_text()[place->character];
    return {Type::character, static_cast<double>(static_cast<unsigned char>(c)), nullptr, nullptr};
}

std::size_t undefined_part(double index) {
    return std::isnan(index) ? 65535 : base::clipped<std::size_t>(index, 0, 65535);
}

std::size_t undefined_key(Reckoning& run, const Expr& e) {
    std::size_t key = 0;
    for (std::size_t k = 0; k < e.count; ++k) {
        const Value v = evaluate(run, run.unit().children[e.b + k]);
        key = key * 65536 + (v.is_text() ? std::hash<std::string>{}(v.as_text()) % 65521 : undefined_part(v.number));
    }
    return key;
}

bool is_constant(const Unit& unit, ExprId id) {
    const Expr& e = unit.exprs[id];
    if (e.kind == ExprKind::number || e.kind == ExprKind::boolean) return true;
    return e.kind == ExprKind::unary && is_constant(unit, e.a);
}

namespace {

void complain(Saying& run, Conversion c, const Value& v, Type to, const base::Span& where) {
    const std::string target(name(to));
    if (c == Conversion::wrong_type)
        alarm(run, codes::type_mismatch, where,
              "a " + std::string(name(v.type)) + " cannot be assigned to a " + target);
    if (c == Conversion::out_of_range) alarm(run, codes::value_range, where, "the value does not fit into " + target);
    if (c == Conversion::too_long) alarm(run, codes::value_range, where, "the text is longer than the variable");
}

}  // namespace

void assign_number(Reckoning& run, std::uint32_t n, ExprId value, double v, const base::Span& where) {
    if (run.parameter_overridden[n] == 0 || !is_constant(run.unit(), value)) {
        run.parameters.set(n, v);
        return;
    }
    assume(run, where,
           program::parameter_name(*run.unit().traits, n) + "=" + printed(Value::real(run.parameter_override[n])) +
               " is set from outside and replaces the program's constant");
    run.overrides_met.insert(program::parameter_name(*run.unit().traits, n));
    run.parameters.set(n, run.parameter_override[n]);
}

void store(Saying& run, Array& array, std::size_t index, Value v, const base::Span& where) {
    const Type given = v.type;
    const Conversion c = convert(v, array.type, array.string_length);
    if (c != Conversion::ok) {
        v.type = given;
        complain(run, c, v, array.type, where);
        return;
    }
    array.set(index, v);
}

const Binding* text_parameter(Saying& run, program::NameId name) {
    const std::string_view letters = run.unit().traits->text_letters;
    const std::string& text = run.env.names.text(name);
    if (letters.empty() || !text.starts_with(letters) || text.size() == letters.size()) return nullptr;
    auto array = std::make_shared<Array>();
    array->type = Type::string;
    array->string_length = 256;
    array->allocate();
    run.globals.bind({name, std::move(array), 0, false, nullptr});
    return run.globals.find(name);
}

void create_variable(Saying& run, program::NameId name, double value) {
    const Binding* b = run.calls.empty() ? run.globals.find(name) : find_variable(run, name);
    if (b != nullptr) return b->array->set(b->offset, Value::real(value));
    auto array = std::make_shared<Array>();
    array->allocate();
    array->set(0, Value::real(value));
    const bool global = run.env.names.text(name).starts_with('_');
    (global ? run.globals : run.top().locals).bind({name, std::move(array), 0, false, nullptr});
}

void write_character(Reckoning& run, const Binding& b, const Expr& e, ExprId value) {
    const std::shared_ptr<Array> array = b.array;
    const auto place = character_place(run, b, e);
    Value v = evaluate(run, value);
    if (!place || run.stopped) return;
    const Type given = v.type;
    if (const Conversion c = convert(v, Type::character); c != Conversion::ok) {
        v.type = given;
        complain(run, c, v, Type::character, run.unit().span(value));
    } else {
        std::string text = array->get(place->element).as_text();
        text[place->character] = character(v.number);
        array->set(place->element, v.is_unknown() ? Value::unknown(Type::string) : Value::string(std::move(text)));
    }
}

void assign_text(Saying& run, ExprId target, const std::string& text) {
    const Expr& e = run.unit().exprs[target];
    const Binding* b = find_variable(run, e.a);
    if (b == nullptr) b = text_parameter(run, e.a);
    if (b != nullptr) store(run, *b->array, b->offset, Value::string(text), run.unit().span(target));
}

}  // namespace obrys::interp
