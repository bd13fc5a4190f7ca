#pragma once
/// A system variable that is read, and what it shows of the machine. Private to interp.

#include "interp/values/values.hpp"

namespace obrys::interp {

struct Access {
    Reckoning& run;
    const program::Expr& e;
    [[nodiscard]] base::Span where() const { return {run.unit().file, e.begin, e.end}; }
    [[nodiscard]] const std::string& name() const { return run.env.names.text(e.a); }
    [[nodiscard]] ExprId id(std::size_t i) const {
        return i < e.count ? run.unit().children[e.b + i] : program::no_expr;
    }
    /// An index in brackets; one that is unknown is -1, which names nothing.
    [[nodiscard]] double index(std::size_t i) const {
        const double v = i < e.count ? number(run, id(i)) : 0;
        return std::isnan(v) ? -1 : std::clamp(v, -1e6, 1e6);
    }
};

// --- system_read.cpp
/// `also`: what tells it besides its own key.
[[nodiscard]] Value unknown_value(const Access& a, const std::string& why, const std::string& also = {});
/// Without its wear; nothing where the list does not say it.
[[nodiscard]] std::optional<double> tool_radius(const shop::Tool& t);
[[nodiscard]] Value tool_radius(const Access& a);

// --- system_machine.cpp
[[nodiscard]] Value machine_position(const Access& a);
[[nodiscard]] Value work_position(const Access& a);
[[nodiscard]] Value active_g(const Access& a);
[[nodiscard]] Value machine_data(const Access& a);
[[nodiscard]] Value datum_frame_value(const Access& a);
/// A number of the control's configuration.
[[nodiscard]] Value setting_value(const Access& a);
[[nodiscard]] Value run_state(const Access& a, program::SystemVariable v);
/// One component of a frame: [axis, TR], behind the number of a settable one.
[[nodiscard]] Value frame_component(const Access& a, program::SystemVariable v);
/// #4001 …: the code itself, or one of two by what it says.
[[nodiscard]] Value shown_code(const Access& a);
/// Date and time of the run: the job may give them.
[[nodiscard]] Value clock_value(const Access& a);

}  // namespace obrys::interp
