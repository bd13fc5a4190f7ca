#include <algorithm>

#include "read/rs274/state.hpp"

namespace obrys::read::rs274 {

using program::Expr;
using program::ExprKind;
using program::SystemVariable;

namespace {

ExprId refuse(State& s, std::uint32_t begin, std::string text, std::string remedy = {}) {
    fail(s, begin, s.line.behind(), std::move(text), std::move(remedy));
    return no_expr;
}

ExprId add_system(State& s, SystemVariable what, std::string_view name, const std::vector<ExprId>& children,
                  std::uint32_t begin) {
    Expr e;
    e.kind = ExprKind::system;
    e.op = static_cast<std::uint8_t>(what);
    e.a = s.build().name(name);
    s.build().adopt(e, children);
    return s.build().add(e, begin, s.line.behind());
}

/// `_INI[SECTION]KEY`.
ExprId read_ini(State& s, const std::string& name, std::uint32_t begin) {
    const std::size_t close = name.find(']');
    if (close == std::string::npos || close + 1 == name.size())
        return refuse(s, begin, "a value of the settings needs a section and a key", "write #<_ini[section]key>");
    const std::uint32_t end = s.line.behind();
    const ExprId section = s.build().text(name.substr(5, close - 5), begin, end);
    const ExprId key = s.build().text(name.substr(close + 1), begin, end);
    return add_system(s, SystemVariable::ini_value, "#<" + name + ">", {section, key}, begin);
}

ExprId read_named(State& s, bool target, std::uint32_t begin) {
    const auto name = read_name(s);
    if (!name) return no_expr;
    const auto known = std::find_if(s.variant.predefined.begin(), s.variant.predefined.end(),
                                    [&](const auto& p) { return p.text == *name; });
    const bool returned = *name == "_VALUE" || *name == "_VALUE_RETURNED";
    const bool control_owned = name->starts_with("_INI[") || name->starts_with("_HAL[");
    if (target && (known != s.variant.predefined.end() || returned || control_owned))
        return refuse(s, begin,
                      "a program cannot assign to the control's parameter " +
                          base::as_utf8(s.text.substr(begin, s.line.behind() - begin)));
    if (known != s.variant.predefined.end()) {
        const ExprId query = s.build().number(static_cast<double>(known->query), true, begin, s.line.behind());
        return add_system(s, SystemVariable::state, "#<" + *name + ">", {query}, begin);
    }
    if (name->starts_with("_INI[")) return read_ini(s, *name, begin);
    if (name->starts_with("_HAL[")) return add_system(s, SystemVariable::unknown, "#<" + *name + ">", {}, begin);
    Expr e;
    e.kind = ExprKind::variable;
    e.a = s.build().name(*name);
    return s.build().add(e, begin, s.line.behind());
}

ExprId read_numbered(State& s, const Value& number, bool target, std::uint32_t begin) {
    const auto n = as_integer(number);
    if (!n) return refuse(s, begin, "the number of a parameter is a whole one");
    const auto count = static_cast<std::int64_t>(program::parameter_count(*s.variant.traits));
    const bool readable_null = *n == 0 && s.variant.null_parameter && !target;
    if ((*n < 1 && !readable_null) || *n >= count)
        return refuse(s, begin, "there is no parameter #" + std::to_string(*n));
    const auto at = static_cast<std::uint32_t>(*n);
    if (target)
        for (const auto& range : s.variant.read_only)
            if (at >= range.first && at <= range.last)
                return refuse(s, begin, "the parameter #" + std::to_string(at) + " can only be read");
    if (!target && s.system != nullptr)
        if (const ExprId known = s.system(s, at, begin); known != no_expr) return known;
    Expr e;
    e.kind = ExprKind::parameter;
    e.a = at;
    return s.build().add(e, begin, s.line.behind());
}

}  // namespace

std::optional<std::string> read_name(State& s) {
    const std::uint32_t begin = s.line.here();
    s.line.step();
    const std::string_view rest = s.line.rest();
    const std::size_t close = rest.find('>');
    if (close == std::string_view::npos || close == 0) {
        fail(s, begin, s.line.to(s.line.place()), close == 0 ? "the name is empty" : "the name is not closed",
             "write <name>");
        return std::nullopt;
    }
    std::string name(rest.substr(0, close));
    s.line.step(close + 1);
    return name;
}

ExprId read_parameter(State& s, bool target, int depth) {
    const std::uint32_t begin = s.line.here();
    s.line.step();
    if (depth > deepest) return refuse(s, begin, "the expression is nested too deep");
    if (s.line.peek() == '<' && s.variant.named_parameters) return read_named(s, target, begin);
    const Value number = read_value(s, depth + 1);
    if (s.failed) return no_expr;
    if (!number.found) return refuse(s, begin, "# without the number of a parameter");
    if (number.is_literal()) return read_numbered(s, number, target, begin);
    Expr e;
    e.kind = ExprKind::parameter_at;
    e.a = number.expr;
    return s.build().add(e, begin, s.line.behind());
}

}  // namespace obrys::read::rs274
