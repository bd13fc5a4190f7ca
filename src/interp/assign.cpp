/// Assignments; those to system variables: assign_system.cpp.

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/codes.hpp"
#include "base/whole.hpp"
#include "interp/assign_system.hpp"

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

namespace {

/// A text parameter (QS5) exists from its first use on, for all programs.
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

/// SET(a,b,…) and REP(v) on an array, from the addressed element on.
void store_list(Reckoning& run, Array& array, std::size_t first, const Expr& list) {
    const Unit& unit = run.unit();
    const bool repeat = static_cast<program::Function>(list.op) == program::Function::repeat_list;
    const std::size_t n = repeat ? array.size() - first : std::min<std::size_t>(list.count, array.size() - first);
    for (std::size_t k = 0; k < n && list.count > 0 && !run.stopped; ++k) {
        const ExprId id = unit.children[list.b + (repeat ? 0 : k)];
        if (id != program::no_expr) store(run, array, first + k, evaluate(run, id), unit.span(id));
    }
}

bool is_list(const Expr& e) {
    const auto f = static_cast<program::Function>(e.op);
    return e.kind == ExprKind::function && (f == program::Function::set_list || f == program::Function::repeat_list);
}

/// Number of a parameter that can be written; nothing after a complaint.
std::optional<std::uint32_t> writable(Reckoning& run, double index, const program::Assign& a) {
    if (std::isnan(index)) {
        unchecked(run, codes::unknown_value, run.unit().span(a.target),
                  "which parameter this is depends on a value that is not known");
        return std::nullopt;
    }
    const double least = run.traits->parameters_begin_at_one ? 1 : 0;
    if (!(index >= least) || index >= run.parameters.count()) {
        alarm(run, codes::index_range, run.unit().span(a.target),
              "there is no parameter " + printed(Value::real(index)) + " that could be assigned");
        return std::nullopt;
    }
    const auto n = base::cut<std::uint32_t>(index);
    if (n && refuse_absent(run, *n, run.unit().span(a.target))) return std::nullopt;
    return n;
}

void assign_parameter(Telling& run, const Expr& target, const program::Assign& a) {
    const double index = target.kind == ExprKind::parameter ? target.a : number(run, target.a);
    if (run.stopped) return;
    const auto n = writable(run, index, a);
    if (n && is_empty(run, a.value)) {
        if (is_of_control(run, *n, run.unit().span(a.target))) return;
        run.parameters.set_empty_by_control(*n);
        return note_written(run, *n, run.unit().span(a.target));
    }
    const double v = n ? number(run, a.value) : 0;
    if (!n || run.stopped || is_of_control(run, *n, run.unit().span(a.target))) return;
    assign_number(run, *n, a.value, v, run.unit().span(a.target));
    note_written(run, *n, run.unit().span(a.target));
}

/// A variable that begins to exist by being assigned: `_NAME` for all programs, another name for this one.
void create(Saying& run, program::NameId name, double value) {
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

/// F_1[X,TR]=, or of an array F_1[3,X,TR]=.
void write_frame_variable(Reckoning& run, const Binding& b, const Expr& target, ExprId value) {
    Expr whole = target;
    whole.count = static_cast<std::uint16_t>(target.count - 2);
    const std::shared_ptr<Array> array = b.array;
    std::size_t index = b.offset;
    if (!b.element && !element_of(run, whole, *array, index)) return;
    note_held(run, *array, index, run.unit().span(value));
    geom::Frame frame = array->get(index).as_frame();
    write_component(run, target, frame, value);
    if (!run.stopped && !array->get(index).is_unknown()) array->set(index, Value::of_frame(frame));
}

void assign_variable(Reckoning& run, const Expr& target, const program::Assign& a) {
    const Unit& unit = run.unit();
    const Expr& value = unit.exprs[a.value];
    const Binding* b = find_variable(run, target.a);
    if (b == nullptr) b = text_parameter(run, target.a);
    if (b == nullptr && run.traits->variables_by_assignment) {
        const double v = number(run, a.value);
        if (!run.stopped) create(run, target.a, v);
        return;
    }
    if (b == nullptr) {
        const std::string& name = run.env.names.text(target.a);
        unchecked(run, codes::undefined_name, unit.span(a.target), name + " is not defined in this program",
                  "if it is global user data (GUD), put its definition file beside the program or give its value in "
                  "[variables] of the job");
        run.undefined.set(target.a, undefined_key(run, target), evaluate(run, a.value));
        return;
    }
    if (is_character_access(*b, target)) {
        write_character(run, *b, target, a.value);
        return;
    }
    std::size_t index = b->offset;
    if (b->array->type == Type::frame && is_component(run, target))
        return write_frame_variable(run, *b, target, a.value);
    if (!b->element && !element_of(run, target, *b->array, index)) return;
    const std::shared_ptr<Array> array = b->array;
    if (is_list(value)) {
        store_list(run, *array, index, value);
        return;
    }
    const auto replaced = run.overrides_by_name.find(target.a);
    if (replaced != run.overrides_by_name.end() && is_constant(unit, a.value)) {
        assume(run, unit.span(a.target),
               run.env.names.text(target.a) + "=" + printed(Value::real(replaced->second)) +
                   " is set from outside and replaces the program's constant");
        run.overrides_met.insert(run.env.names.text(target.a));
        store(run, *array, index, Value::real(replaced->second), unit.span(a.value));
        return;
    }
    Value v = evaluate(run, a.value);
    if (!run.stopped) store(run, *array, index, std::move(v), unit.span(a.value));
}

}  // namespace

void create_variable(Saying& run, program::NameId name, double value) { create(run, name, value); }

void assign_value(Reckoning& run, const program::Assign& a, double index, double value) {
    const Expr& target = run.unit().exprs[a.target];
    if (target.kind == ExprKind::variable) return create(run, target.a, value);
    if (target.kind != ExprKind::parameter && target.kind != ExprKind::parameter_at)
        return alarm(run, codes::syntax, run.unit().span(a.target), "this can only be read");
    const auto n = writable(run, index, a);
    if (!n) return;
    if (is_live(run, *n) && !may_be_written(run, *n))
        return alarm(run, codes::value_range, run.unit().span(a.target),
                     program::parameter_name(*run.traits, *n) + " can only be read");
    assign_number(run, *n, a.value, value, run.unit().span(a.target));
}

void assign_text(Saying& run, ExprId target, const std::string& text) {
    const Expr& e = run.unit().exprs[target];
    const Binding* b = find_variable(run, e.a);
    if (b == nullptr) b = text_parameter(run, e.a);
    if (b != nullptr) store(run, *b->array, b->offset, Value::string(text), run.unit().span(target));
}

void assign(Telling& run, const program::Assign& a) {
    const Expr& target = run.unit().exprs[a.target];
    switch (target.kind) {
        case ExprKind::parameter:
        case ExprKind::parameter_at: assign_parameter(run, target, a); return;
        case ExprKind::variable: assign_variable(run, target, a); return;
        case ExprKind::system: assign_system(run, target, a); return;
        default: alarm(run, codes::syntax, run.unit().span(a.target), "nothing can be assigned to this");
    }
}

}  // namespace obrys::interp
