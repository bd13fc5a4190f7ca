/// What radius compensation and corners complain about.

#include <utility>

#include "base/codes.hpp"
#include "base/number.hpp"
#include "interp/complaints.hpp"
#include "interp/stream/path_stage.hpp"
#include "interp/stream/stream.hpp"
#include "path/compensation/refusal.hpp"

namespace obrys::interp {

namespace codes = base::codes;

void PathStage::report(Reckoning& run, const path::PathFaults& faults) {
    if (faults.corner) report(run, *faults.corner);
    for (const path::Fault& f : faults.compensation) report(run, f);
}

void PathStage::report(Reckoning& run, const path::Fault& f) {
    if (f.reason == path::Reason::refused)
        return alarm(run, codes::compensation, run.here(), path::message(f, length_unit(run.modal)));
    const Origin& at = origins_[f.tag];
    const std::string radius = base::fixed(at.radius, 3) + " mm";
    std::string text;
    switch (f.reason) {
        case path::Reason::tool_radius_too_large:
            text = "the tool radius " + radius + " is larger than this arc: the arc is left out";
            break;
        case path::Reason::arc_needs_line_at_start:
            text = "compensation must be switched on and off by a straight move, this is an arc";
            break;
        case path::Reason::no_intersection:
            text = "with tool radius " + radius +
                   " this inner corner has no point where both contour elements can be reached";
            break;
        case path::Reason::interference:
            text = "tool radius too large: with " + radius +
                   " the path cuts into another contour element, which the control does not see: it runs on";
            break;
        case path::Reason::refused: break;
        case path::Reason::element_vanishes:
            text = f.bridged ? "with tool radius " + radius +
                                   " the tool does not fit into this contour element: it is left out and material stays"
                             : "with tool radius " + radius + " this contour element cannot be reached";
            break;
    }
    const bool runs_on = f.reason == path::Reason::interference || at.avoids;  // as the control does
    base::Diagnostic d{runs_on ? base::Severity::warning : base::Severity::error,
                       codes::compensation,
                       at.from,
                       std::move(text),
                       "use a smaller tool or widen the contour",
                       run.stacks->sites(at.stack),
                       {}};
    if (origins_[f.other].from != at.from) d.related.push_back({origins_[f.other].from, "the neighbouring element"});
    raise(run, std::move(d));
}

void PathStage::report(Reckoning& run, const path::CornerFault& f) {
    const Origin& at = origins_[f.tag];
    std::string text;
    switch (f.failure) {
        case path::CornerFailure::none: return;
        case path::CornerFailure::bad_size: text = "a chamfer or rounding needs a size above 0"; break;
        case path::CornerFailure::not_joined: text = "no corner follows: the next element does not start here"; break;
        case path::CornerFailure::tangential:
            text = "there is no corner to chamfer or round: the next element goes straight on";
            break;
        case path::CornerFailure::reversal:
            text = "the next element runs back along this one: there is no corner to chamfer or round";
            break;
        case path::CornerFailure::wrong_way:
            text = "the next element goes the other way than the sign of this chamfer or rounding says";
            break;
        case path::CornerFailure::too_short:
            text = "a chamfer or rounding of " + base::fixed(f.size, 3) + " mm is too large for the elements beside it";
            break;
    }
    raise(run,
          {base::Severity::error, codes::value_range, at.from, std::move(text), {}, run.stacks->sites(at.stack), {}});
}

}  // namespace obrys::interp
