/// Onto a contour and off it: APPR and DEP, G147 … G341.

#include <algorithm>

#include "base/codes.hpp"
#include "cl/spline.hpp"
#include "interp/capture.hpp"
#include "interp/moves/moves.hpp"
#include "interp/stream/path_stage.hpp"
#include "path/smooth_approach.hpp"

namespace obrys::interp {

namespace codes = base::codes;
using geom::Vec2;
using geom::Vec3;
using program::Datum;
using program::Special;
using program::SpecialKind;

namespace {

path::SmoothKind shape_of(SpecialKind k) {
    switch (k) {
        case SpecialKind::approach_tangent:
        case SpecialKind::departure_tangent: return path::SmoothKind::tangent_line;
        case SpecialKind::approach_normal:
        case SpecialKind::departure_normal: return path::SmoothKind::normal_line;
        case SpecialKind::approach_arc:
        case SpecialKind::departure_arc: return path::SmoothKind::tangent_arc;
        default: return path::SmoothKind::arc_and_line;
    }
}

std::string failure_text(path::SmoothFailure f) {
    switch (f) {
        case path::SmoothFailure::bad_length: return "LEN must be greater than 0";
        case path::SmoothFailure::bad_radius: return "R must not be 0, and with LCT be greater than 0";
        case path::SmoothFailure::bad_angle:
            return "the centre angle CCA must be greater than 0 and at most 360 degrees";
        case path::SmoothFailure::bad_direction:
            return "the contour has no direction here: no element follows or precedes";
        case path::SmoothFailure::tool_too_large: return "tool radius too large: it exceeds R inside the arc";
        case path::SmoothFailure::inside_of_circle:
            return "the point off the contour lies inside the circle of radius R";
        default: return "a position or value is not known";
    }
}

void complain(Saying& run, path::SmoothFailure f) {
    if (f == path::SmoothFailure::not_a_number)
        unchecked(run, codes::unknown_value, run.here(),
                  "this approach or departure depends on a position or value that is not known: it is left out");
    else
        alarm(run, codes::value_range, run.here(), failure_text(f));
}

path::SmoothShape shape(Reckoning& run, const Special& s) {
    const double unit = length_unit(run.modal);
    path::SmoothShape shape;
    shape.kind = shape_of(s.kind);
    shape.arc_of = path::ArcOf::centre;
    shape.length = datum_of(run, s, Datum::length) * unit;
    shape.radius = datum_of(run, s, Datum::radius) * unit;
    shape.angle = geom::radians(datum_of(run, s, Datum::centre_angle));
    return shape;
}

/// F of G26 and G27 is that of the approach or departure alone.
void own_feed(Moving& run, bool begins) {
    if (!run.block.has(Code::corner_feed) || !(run.block.get(Code::corner_feed) > 0)) return;
    if (begins)
        emit(run, cl::Feed{run.block.get(Code::corner_feed) * feed_factor(run), run.modal.feed_mode});
    else if (run.feed_valid)
        emit(run, cl::Feed{run.feed, run.modal.feed_mode});
}

/// What the stream says of it; `at` in the programmed frame.
cl::LeadBegin lead_of(Moving& run, const Special& s, const Vec3& at, bool onto) {
    const path::SmoothShape form = shape(run, s);
    cl::LeadBegin lead;
    lead.kind = static_cast<cl::LeadKind>(form.kind);
    lead.onto = onto;
    lead.at = run.frame_is_identity ? at : geom::apply(run.frame, at);
    lead.length = radius_in_stream(run, form.length);
    lead.radius = radius_in_stream(run, form.radius);
    lead.angle = form.angle;
    lead.rapid = run.block.rapid;
    const double feed = run.block.has(Code::corner_feed) ? run.block.peek(Code::corner_feed) : 0;
    if (feed > 0) lead.feed = feed * feed_factor(run);
    return lead;
}

/// The elements go through the path stage as they are; the one beside the contour carries the compensation.
void push_approach(Moving& run, const path::SmoothPath& p, const path::Setting& compensation) {
    for (std::size_t i = 0; i < p.path.size(); ++i) {
        path::Setting s;
        if (i + 1 == p.path.size()) s = compensation;
        s.approach = path::Approach::ready;
        run.path->push(run, path::Element(p.path[i]), s);
    }
}

/// The manuals show the arc of LCT on the side of the compensation alone, and say nothing of a point on the other one.
void say_side_of_arc(Moving& run, const Special& s, path::Side side, const path::SmoothPath& p) {
    const bool line_and_arc = s.kind == SpecialKind::approach_arc_line || s.kind == SpecialKind::departure_arc_line;
    if (!line_and_arc || side == path::Side::off || run.capture != nullptr) return;
    const auto arc = std::find_if(p.path.begin(), p.path.end(), [](const path::Element& e) { return path::is_arc(e); });
    if (arc == p.path.end() || (arc->sweep > 0) == (side == path::Side::left)) return;
    assume(run, run.here(),
           "the way comes from the other side of the contour than that of the radius compensation, or leads there: the "
           "arc is taken to lie on the side of the point",
           "begin and end on the side of the tool");
}

/// The manuals know an approach from a point without compensation alone (P_S: "approached without radius compensation",
/// iTNC 530 and TNC 640 User's Manual, "Important positions for approach and departure").
void leave_contour_before(Telling& run) {
    if (run.capture != nullptr) return;
    flush_path(run);
    if (!run.path->active()) return;
    unchecked(run, codes::unsupported, run.here(),
              "an approach while radius compensation is still in force is not described: the compensation is taken to "
              "end where the tool's centre stands, and the approach to begin there",
              "move to the starting point of the approach without radius compensation (R0; DIN/ISO: G40)");
    run.path->end_compensation(run);
}

}  // namespace

void approach(Moving& run, const Special& s) {
    const PlaneAxes a = plane_axes(run.modal.plane);
    leave_contour_before(run);
    const Vec3 start = run.programmed_position;
    const Vec3 target = programmed_target(run);
    // Who looks ahead wants an element of the contour. An approach has none for him, and must not look ahead in its
    // turn: of a row of them each would look through all that follow.
    if (run.look == Look::next_element) return arrive(run, target);
    const std::optional<Captured> next = run.onward->next_element(target);
    const path::Setting compensation = compensation_setting(run);
    path::ContourEnd contour;
    contour.at = in_plane(target, a);
    contour.direction = next ? path::start_direction(next->element) : Vec2{};
    contour.side = compensation.side;
    contour.tool_radius = compensation.radius;
    contour.w = coordinate(target, a.w);
    const path::SmoothPath p =
        path::smooth_approach({in_plane(start, a), coordinate(start, a.w)}, contour, shape(run, s));
    if (!p.ok()) complain(run, p.failure);
    if (run.stopped) return;
    if (!run.block.rapid) require_feed(run);
    if (p.ok()) say_side_of_arc(run, s, contour.side, p);
    if (p.ok() && run.capture == nullptr) {
        run.path->tell_lead(run, lead_of(run, s, target, true));
        own_feed(run, true);
        push_approach(run, p, compensation);
        own_feed(run, false);
        run.path->tell_lead_end(run);
    }
    arrive(run, target);
}

namespace {

/// DEP and G27 end the compensation themselves: RL and RR have no place there, R0 says what they do.
bool ends_compensation(Moving& run, Modal before) {
    const Modal said = run.modal.compensation;
    run.modal.compensation = before;
    if (said == before && (run.block.groups >> static_cast<unsigned>(program::ModalGroup::compensation) & 1U) == 0)
        return true;
    if (said == Modal::compensation_off) return true;
    alarm(run, codes::compensation, run.here(),
          "a departure from the contour ends radius compensation: no side of it can stand in its block",
          "write it in the block that leads to the next contour");
    return false;
}

}  // namespace

void departure(Moving& run, const Special& s, Modal compensation_before) {
    if (!ends_compensation(run, compensation_before)) return;
    const PlaneAxes a = plane_axes(run.modal.plane);
    const Vec3 at = run.programmed_position;
    // Only LCT leads to a point; of the others the words of one stay unused and are said.
    const Vec3 target = s.kind == SpecialKind::departure_arc_line ? programmed_target(run) : at;
    path::Setting compensation = compensation_setting(run);
    if (!run.path->active())
        compensation = {};  // selected, but it never came into force: the tool stands on the contour
    path::ContourEnd contour;
    contour.at = in_plane(at, a);
    contour.direction = run.last_direction.get();
    contour.side = compensation.side;
    contour.tool_radius = compensation.radius;
    contour.w = coordinate(at, a.w);
    const path::SmoothPath p =
        path::smooth_departure(contour, {in_plane(target, a), coordinate(target, a.w)}, shape(run, s));
    switch_compensation_off(run);
    run.modal.look_ahead = 0;
    if (!p.ok()) complain(run, p.failure);
    if (run.stopped || !p.ok() || p.path.empty()) return;
    if (!run.block.rapid) require_feed(run);
    say_side_of_arc(run, s, contour.side, p);
    if (run.capture == nullptr) {
        run.path->tell_lead(run, lead_of(run, s, target, false));
        own_feed(run, true);
        path::Setting ready;
        ready.approach = path::Approach::ready;
        for (const path::Element& e : p.path) run.path->push(run, path::Element(e), ready);
        flush_path(run);
        own_feed(run, false);
        run.path->tell_lead_end(run);
    }
    Vec3 end = at;
    coordinate(end, a.u) = p.path.back().to.x;
    coordinate(end, a.v) = p.path.back().to.y;
    coordinate(end, a.w) = p.path.back().w_to;
    for (const path::Element& e : p.path)  // the tangent of what may follow is that of the way off the contour
        if (path::moves_in_plane(e)) run.last_direction = path::EndDirection(e);
    arrive(run, end);
}

}  // namespace obrys::interp
