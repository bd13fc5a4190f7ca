// Constant cutting speed (G96) where the speed that follows from it is none to cut with.
#include <algorithm>
#include <cmath>

#include "base/codes.hpp"
#include "base/number.hpp"
#include "check/limits/limits.hpp"
#include "check/words.hpp"

namespace obrys::check {

namespace {

Finding surface_finding(base::Severity severity, std::string text, std::string remedy) {
    Finding f;
    f.code = base::codes::surface_speed;
    f.severity = severity;
    f.text = std::move(text);
    f.remedy = std::move(remedy);
    return f;
}

}  // namespace

/// Where limit or machine hold the speed already at the largest radius of the way, they do so nearer to the axis, too.
void Limits::check_thread_speed(const Move& move) {
    const auto* thread = std::get_if<cl::Thread>(&move.record.step);
    if (thread_speed_reported_ || thread == nullptr || thread->rigid_tap ||
        state_.spindle.mode == cl::SpindleMode::rpm || state_.spindle.direction == 0)
        return;
    const double radius = std::fmax(std::abs(move.from.x), std::abs(move.to.x));
    double cap = machine_.spindle.max;
    if (state_.spindle.limit > 0) cap = std::min(cap, state_.spindle.limit);
    if (state_.spindle.speed * 1000 >= 2 * geom::pi * radius * cap) return;
    thread_speed_reported_ = true;
    out_.finding(move, surface_finding(base::Severity::warning,
                                       "a thread is cut under constant cutting speed: the spindle's speed goes with X "
                                       "from pass to pass, and the turns of the passes do not meet",
                                       "program a constant speed of the spindle before the thread"));
}

/// Constant cutting speed towards the axis without a limit: the machine turns as fast as it can, chuck and bar with it.
void Limits::check_surface_speed(const Move& move) {
    const cl::Spindle& s = state_.spindle;
    if (surface_noted_ || s.mode != cl::SpindleMode::surface || s.limit > 0 || s.direction == 0) return;
    constexpr double harmless = 6000;  // 1/min, above which no chuck of usual size may turn
    const double radius = std::fmin(std::abs(move.from.x), std::abs(move.to.x));
    const bool known = std::isfinite(machine_.spindle.max);
    const double wanted = s.speed * 1000 / (2 * geom::pi * radius);
    if (!(wanted > (known ? machine_.spindle.max : harmless))) return;
    surface_noted_ = true;
    const std::string text = "constant cutting speed without a limit of the speed asks for " +
                             (radius > 0 ? plain(std::round(wanted)) + " 1/min" : std::string("any speed")) + " at X " +
                             base::fixed(radius, 3) + " mm (radius)";
    const std::string remedy = "program the highest speed that chuck and workpiece bear";
    if (!known)
        return out_.unchecked(move.record, text + ": what machine and chuck bear is not known",
                              remedy + ", or give the machine file of the machine, with max of its [spindle]");
    Finding f =
        surface_finding(base::Severity::error,
                        text + ", and the machine turns at most " + plain(machine_.spindle.max) + " 1/min", remedy);
    if (radius > 0) f.amounts.push_back({"speed_rpm", wanted});
    f.amounts.push_back({"limit_rpm", machine_.spindle.max});
    out_.finding(move, std::move(f));
}

/// On the axis any cutting speed asks for a speed without end: the spindle runs at its limit, whatever S says.
void Limits::check_speed_on_axis(const Move& move) {
    constexpr double on_axis = 1e-3;  // mm
    const cl::Spindle& s = state_.spindle;
    if (on_axis_reported_ || machine_.kind != shop::MachineKind::lathe || s.mode != cl::SpindleMode::surface ||
        s.direction == 0 || !(s.limit > 0) || std::holds_alternative<cl::Thread>(move.record.step))
        return;
    if (!(std::abs(move.from.x) < on_axis && std::abs(move.to.x) < on_axis && move.to.z < move.from.z)) return;
    // A finishing pass of a turning tool begins there, too.
    if (state_.tool == nullptr || !shop::is_milling(state_.tool->kind)) return;
    on_axis_reported_ = true;
    Finding f = surface_finding(base::Severity::warning,
                                "a tool works on the axis under constant cutting speed: the spindle turns at the limit "
                                "of " +
                                    plain(s.limit) + " 1/min, whatever the cutting speed is",
                                "program a constant speed of the spindle before it");
    f.amounts = {{"limit_rpm", s.limit}};
    out_.finding(move, std::move(f));
}

}  // namespace obrys::check
