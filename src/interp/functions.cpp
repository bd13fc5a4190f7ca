/// Built-in functions. Angles in degrees. Domains as the SINUMERIK programming manual "Job planning" states them.

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/codes.hpp"
#include "base/number.hpp"
#include "base/text.hpp"
#include "base/whole.hpp"
#include "interp/run.hpp"

namespace obrys::interp {

using program::Expr;
using program::Function;
namespace codes = base::codes;

namespace {

/// The arguments of a call, evaluated when asked for.
struct Arguments {
    Reckoning& run;
    const Expr& e;
    mutable bool unknown = false;  ///< one of those asked for so far is not known

    [[nodiscard]] bool given(std::size_t i) const {
        return i < e.count && run.unit().children[e.b + i] != program::no_expr;
    }
    [[nodiscard]] ExprId id(std::size_t i) const { return run.unit().children[e.b + i]; }
    [[nodiscard]] base::Span span(std::size_t i) const { return given(i) ? run.unit().span(id(i)) : whole(); }
    [[nodiscard]] base::Span whole() const { return {run.unit().file, e.begin, e.end}; }

    double operator[](std::size_t i) const {
        if (!need(i)) return 0;
        const double v = number(run, id(i));
        unknown = unknown || std::isnan(v);
        return v;
    }
    [[nodiscard]] std::string text(std::size_t i) const {
        if (!need(i)) return {};
        const Value v = evaluate(run, id(i));
        unknown = unknown || v.is_unknown();
        if (!run.stopped && !v.is_text() && v.type != Type::character && !v.is_unknown())
            alarm(run, codes::type_mismatch, span(i),
                  "a STRING is needed here, this is a " + std::string(name(v.type)));
        return printed(v);
    }
    [[nodiscard]] bool need(std::size_t i) const {
        if (!given(i) && !run.stopped)
            alarm(run, codes::bad_argument, whole(), "argument " + std::to_string(i + 1) + " is missing");
        return !run.stopped;
    }
};

/// A named parameter that nobody has assigned, in the text of a comment: the control shows it and goes on.
bool names_nothing(const Arguments& a) {
    if (!a.run.traits->variables_by_assignment || !a.given(0)) return false;
    const Expr& e = a.run.unit().exprs[a.id(0)];
    return e.kind == program::ExprKind::variable && find_variable(a.run, e.a) == nullptr;
}

double domain(const Arguments& a, const std::string& text) {
    alarm(a.run, codes::arithmetic, a.span(0), text);
    return 0;
}

double tangent(const Arguments& a) {
    const double angle = a[0];
    if (std::fmod(std::abs(angle), 180.0) == 90.0)
        return domain(a, "TAN(" + base::shortest(angle) + ") does not exist");
    return std::tan(geom::radians(angle));
}

double arc_function(const Arguments& a, double (*f)(double), const char* name) {
    const double x = a[0];
    if (std::abs(x) > 1 + 1e-9)
        return domain(a, std::string(name) + " needs a value from -1 to 1, this is " + base::shortest(x));
    return geom::degrees(f(std::clamp(x, -1.0, 1.0)));
}

double square_root(const Arguments& a) {
    const double x = a[0];
    if (x < 0) return domain(a, "SQRT of the negative number " + base::shortest(x));
    return std::sqrt(x);
}

double logarithm(const Arguments& a, const std::string& name) {
    const double x = a[0];
    if (x <= 0) return domain(a, name + " needs a positive number, this is " + base::shortest(x));
    return std::log(x);
}

double extreme(const Arguments& a, bool least) {
    const double x = a[0], y = a[1];
    if (std::isnan(x) || std::isnan(y)) return x + y;
    return least ? std::min(x, y) : std::max(x, y);
}

double bounded(const Arguments& a) {
    const double low = a[0], high = a[1], x = a[2];
    if (std::isnan(low) || std::isnan(high)) return low + high;
    if (low > high) return domain(a, "BOUND: the lower limit lies above the upper limit");
    return std::clamp(x, low, high);
}

/// Functions that calculators have and few controls; false where `f` is none of them.
bool further_numeric(const Arguments& a, Function f, double& result) {
    switch (f) {
        case Function::atan: result = geom::degrees(std::atan(a[0])); return true;
        case Function::log10:
            result = logarithm(a, "LOG");
            if (a[0] > 0) result = std::log10(a[0]);
            return true;
        case Function::fraction: {
            const double x = a[0];
            result = x - std::trunc(x);
            return true;
        }
        case Function::sign: {
            const double x = a[0];
            result = std::isnan(x) ? x : x < 0 ? -1 : 1;  // 0 gives 1: iTNC 530 manual, entering formulas directly
            return true;
        }
        case Function::root_of_squares: {
            const double x = a[0], y = a[1];
            result = std::hypot(x, y);
            return true;
        }
        case Function::angle_of: {
            const double y = a[0], x = a[1];
            const double angle = geom::degrees(std::atan2(y, x));
            result = angle < 0 ? angle + 360 : angle;
            return true;
        }
        default: return false;
    }
}

/// Traits::angles_from_zero, or as the machine file says.
double from_zero(const Arguments& a, double degrees, std::string_view function) {
    const std::string_view setting = a.run.traits->angles_from_zero;
    if (setting.empty() || !(degrees < 0)) return degrees;
    const std::optional<bool>& said = a.run.env.machine.control.angles_from_zero;
    if (said) return *said ? degrees + 360 : degrees;
    if (a.run.capture == nullptr)
        assume(a.run, a.whole(),
               std::string(function) + " of a negative angle is " + (function == "ATAN" ? "180 … 360" : "270 … 360") +
                   " degrees, as with " + std::string(setting) + "; with 1 it is a full turn less",
               "say which in [control] of the machine file: angles = \"0-360\" or \"180\"");
    return degrees + 360;
}

/// Numeric functions; nothing where `f` is not one.
bool numeric(const Arguments& a, Function f, double& result) {
    switch (f) {
        case Function::sin: result = std::sin(geom::radians(a[0])); return true;
        case Function::cos: result = std::cos(geom::radians(a[0])); return true;
        case Function::tan: result = tangent(a); return true;
        case Function::asin:
            result = from_zero(a,
                               arc_function(
                                   a, [](double x) { return std::asin(x); }, "ASIN"),
                               "ASIN");
            return true;
        case Function::acos:
            result = arc_function(
                a, [](double x) { return std::acos(x); }, "ACOS");
            return true;
        case Function::atan2: {
            const double y = a[0], x = a[1];
            result = from_zero(a, geom::degrees(std::atan2(y, x)), "ATAN");
            return true;
        }
        case Function::sqrt: result = square_root(a); return true;
        case Function::abs: result = std::abs(a[0]); return true;
        case Function::square: {
            const double x = a[0];
            result = x * x;
            return true;
        }
        case Function::trunc: result = std::trunc(a[0]); return true;
        case Function::round: result = std::floor(a[0] + 0.5); return true;
        case Function::round_up: result = std::ceil(a[0]); return true;
        case Function::round_down: result = std::floor(a[0]); return true;
        case Function::round_away: result = std::round(a[0]); return true;
        case Function::ln: result = logarithm(a, "LN"); return true;
        case Function::exp: result = std::exp(a[0]); return true;
        case Function::min:
        case Function::max: result = extreme(a, f == Function::min); return true;
        case Function::bound: result = bounded(a); return true;
        default: return further_numeric(a, f, result);
    }
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

/// A program found where called ones are looked for exists; of others nothing is known here.
Value file_exists(const Arguments& a) {
    const std::string text = a.text(0);
    if (a.run.stopped) return {};
    if (find_file(a.run, text)) return Value::boolean(true);
    unchecked(a.run, codes::unknown_value, a.whole(),
              "whether the file \"" + text + "\" is on the control is not known: it is not among the programs here",
              "put it beside the program if it is");
    return Value::unknown();
}

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

/// TRUE for what program, job or files here define. What else the control has is not known, but for names that programs
/// make themselves (Traits::variables_by_assignment).
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

/// Of arguments that are not known the result is not known either.
Value string_function(const Arguments& a, Function f) {
    const Value v = text_function(a, f);
    return a.unknown && !v.is_unknown() ? Value::unknown(v.type) : v;
}

int axis_index(const std::string& axis) { return axis == "X" ? 0 : axis == "Y" ? 1 : axis == "Z" ? 2 : -1; }

/// CTRANS(X,v,Y,v…), CROT, CSCALE, CMIRROR(X,Y…): pairs of axis and value.
Value frame_function(const Arguments& a, Function f) {
    geom::Frame frame;
    const std::size_t step = f == Function::frame_mirror ? 1 : 2;
    for (std::size_t i = 0; i < a.e.count && !a.run.stopped; i += step) {
        const std::string axis = axis_of(a.run, a.given(i) ? a.id(i) : program::no_expr);
        if (axis == "?") return Value::unknown(Type::frame);
        const int k = axis_index(axis);
        const bool shift = f == Function::frame_shift || f == Function::frame_fine;
        const double v = step == 2 ? a[i + 1] * (shift ? length_unit(a.run.modal) : 1) : -1;
        if (k < 0) {
            unchecked(a.run, codes::unsupported, a.span(i), "frames act on X, Y and Z only");
            continue;
        }
        if (std::isnan(v)) return Value::unknown(Type::frame);
        geom::Vec3 part = f == Function::frame_shift || f == Function::frame_fine ? geom::Vec3{} : geom::Vec3{1, 1, 1};
        coordinate(part, k) = v;
        if (f == Function::frame_rotation)
            frame = frame * geom::Frame::rotation(k, geom::radians(v));
        else if (f == Function::frame_shift || f == Function::frame_fine)
            frame = frame * geom::Frame::shift(part);
        else
            frame = frame * geom::Frame::scaling(part);
    }
    return Value::of_frame(frame);
}

}  // namespace

Value call_function(Reckoning& run, const Expr& e) {
    const Arguments a{run, e};
    const auto f = static_cast<Function>(e.op);
    double result = 0;
    if (numeric(a, f, result)) {
        const bool whole = f == Function::trunc || f == Function::round || f == Function::round_up;
        if (std::isinf(result) && !run.stopped)
            alarm(run, codes::arithmetic, a.whole(), "the result is too large for the control");
        return whole && !std::isnan(result) ? Value::integer(result) : Value::real(result);
    }
    switch (f) {
        case Function::frame_shift:
        case Function::frame_rotation:
        case Function::frame_scale:
        case Function::frame_mirror:
        case Function::frame_fine: return frame_function(a, f);
        case Function::format_text: return format_text(run, e);
        case Function::file_exists: return file_exists(a);
        case Function::frame_plane_rotation: {
            const int axis = run.modal.plane == 17 ? 2 : run.modal.plane == 18 ? 1 : 0;
            if (std::isnan(a[0])) return Value::unknown(Type::frame);
            return Value::of_frame(geom::Frame::rotation(axis, geom::radians(a[0])));
        }
        case Function::frame_inverse: {
            const Value v = evaluate(run, a.given(0) ? a.id(0) : program::no_expr);
            if (v.is_unknown()) return Value::unknown(Type::frame);
            return Value::of_frame(geom::is_invertible(v.as_frame()) ? geom::inverse(v.as_frame()) : geom::Frame{});
        }
        case Function::is_variable: return variable_exists(a);
        case Function::is_axis: {
            const double n = a[0];
            if (a.unknown) return Value::unknown(Type::boolean);
            return Value::boolean(n >= 1 && n <= static_cast<double>(run.env.machine.axes.size()));
        }
        case Function::modulo_axis: {
            const double angle = a[1];
            return Value::real(angle - 360 * std::floor(angle / 360));
        }
        default: return string_function(a, f);
    }
}

}  // namespace obrys::interp
