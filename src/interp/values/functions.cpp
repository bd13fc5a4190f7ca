/// Built-in functions. Angles in degrees. Domains as the SINUMERIK programming manual "Job planning" states them.

#include <algorithm>
#include <cmath>
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
        case Function::round_outwards: result = std::copysign(std::ceil(std::abs(a[0])), a[0]); return true;
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
        const bool whole = f == Function::trunc || f == Function::round || f == Function::round_up ||
                           f == Function::round_outwards;
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
