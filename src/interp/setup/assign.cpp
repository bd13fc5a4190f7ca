/// Assignments; those to system variables: assign_system.cpp.

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/codes.hpp"
#include "base/whole.hpp"
#include "interp/setup/setup.hpp"

namespace obrys::interp {

using program::Expr;
using program::ExprKind;
namespace codes = base::codes;

namespace {

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
        if (!run.stopped) create_variable(run, target.a, v);
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

void assign_value(Reckoning& run, const program::Assign& a, double index, double value) {
    const Expr& target = run.unit().exprs[a.target];
    if (target.kind == ExprKind::parameter && is_programs_own(run, target.a))
        return assign_number(run, target.a, a.value, value, run.unit().span(a.target));
    if (target.kind == ExprKind::variable) return create_variable(run, target.a, value);
    if (target.kind != ExprKind::parameter && target.kind != ExprKind::parameter_at)
        return alarm(run, codes::syntax, run.unit().span(a.target), "this can only be read");
    const auto n = writable(run, index, a);
    if (!n) return;
    if (is_live(run, *n) && !may_be_written(run, *n))
        return alarm(run, codes::value_range, run.unit().span(a.target),
                     program::parameter_name(*run.traits, *n) + " can only be read");
    assign_number(run, *n, a.value, value, run.unit().span(a.target));
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
