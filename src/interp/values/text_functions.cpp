/// Functions about texts, and about what exists.

#include <algorithm>
#include <optional>

#include "base/codes.hpp"
#include "base/number.hpp"
#include "base/text.hpp"
#include "base/whole.hpp"
#include "interp/values/function_arguments.hpp"

namespace obrys::interp {

using program::Expr;
using program::Function;
namespace codes = base::codes;

namespace {

/// A named parameter that nobody has assigned, in the text of a comment: the control shows it and goes on.
bool names_nothing(const Arguments& a) {
    if (!a.run.traits->variables_by_assignment || !a.given(0)) return false;
    const Expr& e = a.run.unit().exprs[a.id(0)];
    return e.kind == program::ExprKind::variable && find_variable(a.run, e.a) == nullptr;
}

Value find_text(const Arguments& a, bool from_right) {
    const std::string text = a.text(0), what = a.text(1);
    const std::size_t at = from_right ? text.rfind(what) : text.find(what);
    return Value::integer(at == std::string::npos ? -1 : static_cast<double>(at));
}

Value substring(const Arguments& a) {
    const std::string text = a.text(0);
    const double from = a[1];
    const double count = a.given(2) ? a[2] : 1e9;
    if (a.run.stopped) return {};
    if (a.unknown) return Value::unknown(Type::string);
    if (from < 0 || count < 0 || from > static_cast<double>(text.size())) {
        alarm(a.run, codes::index_range, a.whole(), "SUBSTR starts outside the text");
        return {};
    }
    return Value::string(text.substr(base::clipped<std::size_t>(from, 0, text.size()),
                                     base::clipped<std::size_t>(count, 0, text.size())));
}

/// A number as the control's language writes it: "1.5EX2" where exponents are EX.
std::optional<double> number_in(const Saying& run, std::string_view text) {
    if (!run.traits->exponent_is_ex) return base::parse_double(text);
    std::string plain = base::to_upper(base::trim(text));
    const auto e = plain.find('E');
    if (e == std::string::npos) return base::parse_double(plain);
    if (e + 1 >= plain.size() || plain[e + 1] != 'X') return std::nullopt;
    return base::parse_double(plain.erase(e + 1, 1));
}

}  // namespace

Value file_exists(const Arguments& a) {
    const std::string text = a.text(0);
    if (a.run.stopped) return {};
    if (find_file(a.run, text)) return Value::boolean(true);
    unchecked(a.run, codes::unknown_value, a.whole(),
              "whether the file \"" + text + "\" is on the control is not known: it is not among the programs here",
              "put it beside the program if it is");
    return Value::unknown();
}

namespace {

/// EXISTS of #<_ini[section]key>: known where the control's settings are at hand.
std::optional<bool> setting_exists(const Saying& run, std::string_view text) {
    constexpr std::string_view before = "#<_INI[";
    const auto close = text.find(']');
    const auto* settings = run.env.settings;
    if (!text.starts_with(before) || close == std::string_view::npos || settings == nullptr || settings->empty())
        return std::nullopt;
    const std::string section(text.substr(before.size(), close - before.size()));
    return settings->contains(section + "/" + std::string(text.substr(close + 1, text.size() - close - 2)));
}

}  // namespace

Value variable_exists(const Arguments& a) {
    auto& run = a.run;
    const std::string text = base::to_upper(base::trim(a.text(0)));
    if (run.stopped || a.unknown) return Value::unknown(Type::boolean);
    const std::string bare = text.substr(0, text.find('['));
    const bool numbered = program::find_parameter(*run.traits, bare) < run.parameters.count();
    if (numbered || find_variable(run, run.env.names.id(bare)) != nullptr || given_value(run, text) ||
        run.env.machine.machine_data.contains(bare))
        return Value::boolean(true);
    if (run.traits->variables_by_assignment && !text.starts_with('#')) return Value::boolean(false);
    if (const auto known = setting_exists(run, text)) return Value::boolean(*known);
    unchecked(run, codes::unknown_value, a.whole(),
              "whether " + text + " exists on the control is not known: nothing here defines it", given_remedy(text));
    return Value::unknown(Type::boolean);
}

namespace {

Value text_number(const Arguments& a) {
    const std::string text = a.text(0);
    const auto v = number_in(a.run, text);
    if (a.unknown) return Value::unknown();
    if (!v && !a.run.stopped) alarm(a.run, codes::type_mismatch, a.span(0), "NUMBER: \"" + text + "\" is not a number");
    return Value::real(v.value_or(0));
}

Value text_function(const Arguments& a, Function f) {
    switch (f) {
        case Function::string_length: return Value::integer(static_cast<double>(a.text(0).size()));
        case Function::to_upper: return Value::string(base::to_upper(a.text(0)));
        case Function::to_lower: {
            std::string s = a.text(0);
            std::transform(s.begin(), s.end(), s.begin(),
                           [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
            return Value::string(std::move(s));
        }
        case Function::index: return find_text(a, false);
        case Function::rindex: return find_text(a, true);
        case Function::mindex: {
            const std::string text = a.text(0), any = a.text(1);
            const std::size_t at = text.find_first_of(any);
            return Value::integer(at == std::string::npos ? -1 : static_cast<double>(at));
        }
        case Function::find_text: {
            const std::string text = a.text(0), what = a.text(1);
            const double from = a.given(2) ? a[2] : 0;
            const std::size_t at =
                from >= 0 ? text.find(what, base::clipped<std::size_t>(from, 0, text.size() + 1)) : std::string::npos;
            return Value::integer(static_cast<double>(at == std::string::npos ? text.size() : at));
        }
        case Function::compare_texts: {
            const int order = a.text(0).compare(a.text(1));
            return Value::integer(order == 0 ? 0 : order < 0 ? -1 : 1);
        }
        case Function::to_text: {
            if (names_nothing(a)) return Value::string("######");
            const double v = a[0], decimals = a.given(1) ? a[1] : 3;
            if (a.unknown) return Value::unknown(Type::string);
            return Value::string(base::fixed(v, base::clipped<int>(decimals, 0, 9)));
        }
        case Function::substring: return substring(a);
        case Function::number: return text_number(a);
        case Function::is_number: {
            const std::string text = a.text(0);
            return text == "?" ? Value::unknown() : Value::boolean(number_in(a.run, text).has_value());
        }
        case Function::axis_string: return Value::string(axis_of(a.run, a.given(0) ? a.id(0) : program::no_expr));
        case Function::axis_name: return Value::axis(base::to_upper(a.text(0)));
        default: break;
    }
    unchecked(a.run, codes::unsupported, a.whole(), "this function is not run", "its result is unknown");
    return Value::unknown();
}

}  // namespace

Value string_function(const Arguments& a, Function f) {
    const Value v = text_function(a, f);
    return a.unknown && !v.is_unknown() ? Value::unknown(v.type) : v;
}

}  // namespace obrys::interp
