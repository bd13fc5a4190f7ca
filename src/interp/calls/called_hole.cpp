/// Cycles at one hole that are called like programs (Traits::called_holes): from their arguments to the cycle by
/// meaning. Source: docs/dialects/sinumerik.md, "Cycles of one hole".

#include <algorithm>
#include <cmath>

#include "base/codes.hpp"
#include "cycles/expand/expand.hpp"
#include "interp/calls/calls.hpp"
#include "interp/moves/cycle_steps.hpp"
#include "interp/moves/small_infeed.hpp"

namespace obrys::interp {

namespace codes = base::codes;
using cl::CycleRole;
using program::CalledHole;
using program::HoleArgument;

namespace {

bool is_length(HoleArgument a) {
    switch (a) {
        case HoleArgument::return_plane:
        case HoleArgument::reference_plane:
        case HoleArgument::clearance:
        case HoleArgument::bottom:
        case HoleArgument::depth:
        case HoleArgument::first_bottom:
        case HoleArgument::first_depth:
        case HoleArgument::least_infeed:
        case HoleArgument::way_back:
        case HoleArgument::stop_distance:
        case HoleArgument::infeed:
        case HoleArgument::shift_u:
        case HoleArgument::shift_v:
        case HoleArgument::shift_w: return true;
        default: return false;
    }
}

bool is_known_mode(const CalledHole& c, double written) {
    return std::any_of(c.known_modes.begin(), c.known_modes.end(), [&](int m) { return m == written; });
}

/// Why an argument makes the call one that is not run; empty: it does not.
std::string why_not(const Reckoning& run, const CalledHole& c, HoleArgument a, double v) {
    constexpr double tool_axis = 3, first_plane = 17;
    if (std::isnan(v)) return {};
    switch (a) {
        case HoleArgument::unknown: return "what its _GMODE says is not known";
        case HoleArgument::axis: return v == tool_axis ? "" : "it drills along another axis than the tool's (_AXN)";
        case HoleArgument::plane:
            return first_plane + v - 1 == run.modal.plane ? ""
                                                          : "it works in another plane than the one in force (_DMODE)";
        case HoleArgument::modes: return is_known_mode(c, v) ? "" : "how it counts by this _AMODE is not known";
        default: return {};
    }
}

/// The arguments that a cycle has besides those that are known must say nothing.
bool says_more(Reckoning& run, const program::Call& call, std::size_t known) {
    for (std::size_t i = known; i < call.arguments.size(); ++i) {
        if (call.arguments[i] == program::no_expr) continue;
        const Value v = evaluate(run, call.arguments[i]);
        if (!v.is_number() || v.number != 0) return true;
    }
    return false;
}

double in_own_unit(HoleArgument a, double v, double unit) {
    // A degression below 0 is a factor.
    return is_length(a) || (a == HoleArgument::degression && v > 0) ? v * unit : v;
}

}  // namespace

std::optional<HoleCall> read_hole_call(Calling& run, const program::Call& call) {
    const CalledHole& c = run.traits->called_holes[call.form];
    HoleCall out{&c, {}, call.where};
    const double unit = length_unit(run.modal);
    for (std::size_t i = 0; i < c.arguments.size(); ++i) {
        const HoleArgument a = c.arguments[i];
        std::optional<double>& value = out.arguments.emplace_back();
        if (i >= call.arguments.size() || call.arguments[i] == program::no_expr || a == HoleArgument::ignored) continue;
        const Value v = evaluate(run, call.arguments[i]);
        if (run.stopped) return std::nullopt;
        value = v.is_number() ? in_own_unit(a, v.number, unit) : NAN;
        if (*value == 0 && (a == HoleArgument::unknown || a == HoleArgument::axis || a == HoleArgument::plane ||
                            a == HoleArgument::modes))
            continue;
        if (const std::string why = why_not(run, c, a, *value); !why.empty()) {
            say_not_run(run, call, why);
            return std::nullopt;
        }
    }
    if (says_more(run, call, c.arguments.size())) {
        say_not_run(run, call,
                    "what its arguments behind number " + std::to_string(c.arguments.size()) + " say is not known");
        return std::nullopt;
    }
    if (run.modal.diameter != DiameterMode::off && out.find(HoleArgument::shift_u).value_or(0) != 0) {
        say_not_run(run, call, "it moves across the hole in a plane with diameters");
        return std::nullopt;
    }
    return out;
}

namespace {

bool needs_feed(const cycles::Demand& d) {
    return d.kind != cl::CycleKind::canned_tap_rigid && !d.find(CycleRole::pitch) && !d.find(CycleRole::feed_plunge);
}

}  // namespace

void call_hole(Calling& run, const HoleCall& call, const WayOfCall& calling) {
    if (run.look != Look::no) return;  // it makes no element of a contour
    const auto demand = demand_of(run, call);
    if (!demand || run.stopped) return;
    const cycles::Demand& d = *demand;
    if (run.modal.compensation != Modal::compensation_off)
        unchecked(run, codes::unsupported, call.where,
                  std::string(call.cycle->name) +
                      " is called with radius compensation in force: where the control goes then is not known, it is "
                      "run at the programmed point",
                  "end the compensation before the call");
    flush_path(run);
    begin_motion(run);
    if (needs_feed(d)) require_feed(run);
    if (run.stopped) return;
    cycles::Expansion e = cycles::expand(d, situation_of(run));
    if (!doubt_infeeds(run, call.cycle->name, d, e, [&](CycleRole) { return call.where; })) return lose_position(run);
    if (!report_expansion(run, call.cycle->name, e)) return;
    const bool feeds = std::any_of(e.steps.begin(), e.steps.end(),
                                   [](const cl::Step& s) { return std::holds_alternative<cl::Feed>(s); });
    emit_hole(run, call.cycle->name, d, e, calling);
    if (!run.stopped && feeds && run.feed_valid) emit(run, cl::Feed{run.feed, run.modal.feed_mode});
}

}  // namespace obrys::interp
