#pragma once
/// The arguments of a function of the control, and functions about texts. Private to interp.

#include <cmath>

#include "base/codes.hpp"
#include "interp/values/values.hpp"

namespace obrys::interp {

namespace codes = base::codes;

/// The arguments of a call, evaluated when asked for.
struct Arguments {
    Reckoning& run;
    const program::Expr& e;
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
        if (!run.stopped && !v.is_text() && v.type != program::Type::character && !v.is_unknown())
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

// --- text_functions.cpp
/// A program found where called ones are looked for exists; of others nothing is known here.
[[nodiscard]] Value file_exists(const Arguments& a);
/// TRUE for what program, job or files here define. What else the control has is not known, but for names that programs
/// make themselves (Traits::variables_by_assignment).
[[nodiscard]] Value variable_exists(const Arguments& a);
/// Of arguments that are not known the result is not known either.
[[nodiscard]] Value string_function(const Arguments& a, program::Function f);

}  // namespace obrys::interp
