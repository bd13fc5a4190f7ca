/// A backup of the control's variables: assignments of constants, of which each gives a value before the run.

#include <cmath>

#include "base/codes.hpp"
#include "base/whole.hpp"
#include "interp/values/values.hpp"

namespace obrys::interp {

namespace codes = base::codes;
using program::Expr;
using program::ExprKind;
using shop::GivenKind;
using shop::GivenValue;

namespace {

void give(Reckoning& run, const std::string& key, const Value& v, const base::Span& where) {
    if (v.is_unknown() || v.type == Type::frame) return;
    GivenValue g{GivenKind::number, v.number, {}, where};
    if (v.type == Type::boolean) g.kind = GivenKind::truth;
    if (v.is_text()) g = {GivenKind::text, 0, v.as_text(), where};
    run.given.insert_or_assign(key, std::move(g));
}

/// MY_I[2]=SET(4,5,6): the elements from the addressed one on, of arrays with one index.
void give_list(Reckoning& run, const Expr& target, const Expr& list) {
    const Unit& unit = run.unit();
    if (target.count > 1) return;
    double first = target.count == 1 ? number(run, unit.children[target.b]) : 0;
    for (std::size_t k = 0; k < list.count && !run.stopped; ++k, ++first) {
        const ExprId id = unit.children[list.b + k];
        if (id == program::no_expr || std::isnan(first)) continue;
        give(run, run.env.names.text(target.a) + "[" + printed(Value::integer(first)) + "]", evaluate(run, id),
             unit.span(id));
    }
}

/// "R7", "#517"; empty where the number is none of a parameter.
std::string parameter_key(Reckoning& run, double n) {
    if (!(n >= 0) || n >= run.parameters.count()) return {};
    return program::parameter_name(*run.traits, base::clipped<std::uint32_t>(n, 0, run.parameters.count() - 1));
}

void take(Reckoning& run, const program::Assign& a) {
    const Unit& unit = run.unit();
    const Expr& target = unit.exprs[a.target];
    const Expr& value = unit.exprs[a.value];
    const base::Span where = unit.span(a.value);
    const bool list =
        value.kind == ExprKind::function && static_cast<program::Function>(value.op) == program::Function::set_list;
    if (list) return give_list(run, target, value);
    std::string key;
    if (target.kind == ExprKind::parameter)
        key = parameter_key(run, target.a);
    else if (target.kind == ExprKind::parameter_at)
        key = parameter_key(run, number(run, target.a));
    else if (static_cast<program::SystemVariable>(target.op) == program::SystemVariable::numbered_parameter &&
             target.kind == ExprKind::system && target.count == 1)
        key = parameter_key(run, number(run, unit.children[target.b]));
    else
        key = shop::given_key(variable_key(run, target));
    if (run.stopped || key.empty()) return;
    if (is_empty(run, a.value))
        run.given.insert_or_assign(key, GivenValue{GivenKind::text, 0, "empty", where});
    else
        give(run, key, evaluate(run, a.value), where);
}

}  // namespace

void take_backup(Reckoning& run, const Unit& unit) {
    run.calls.push_back({});
    run.calls.back().unit = &unit;
    std::size_t taken = 0, left = 0;
    for (std::size_t i = 0; i < unit.statements.size() && !run.stopped; ++i) {
        const program::Statement& s = unit.statements[i];
        run.statement = &s;
        const std::uint32_t end = i + 1 < unit.statements.size() ? unit.statements[i + 1].first
                                                                 : static_cast<std::uint32_t>(unit.words.size());
        bool other = s.kind != program::StatementKind::block;
        for (std::uint32_t w = s.first; w < end && !other && !run.stopped; ++w) {
            const program::Word& word = unit.words[w];
            const Code code = program::code_of(word);
            if (code == Code::assign) {
                take(run, unit.assigns[static_cast<std::size_t>(word.payload)]);
                ++taken;
            } else if (code != Code::m) {
                other = true;
            }
        }
        left += other ? 1 : 0;
    }
    run.calls.pop_back();
    const base::Span file{unit.file, 0, 0};
    if (taken == 0)
        run.diagnostics->add(
            {base::Severity::error, codes::job_value, file, "this file assigns no variables", {}, {}, {}});
    else if (left > 0)
        assume(run, file,
               std::to_string(left) + (left == 1 ? " block of this file assigns no variable and is not taken"
                                                 : " blocks of this file assign no variables and are not taken"));
    run.stopped = run.stopped || taken == 0;
}

}  // namespace obrys::interp
