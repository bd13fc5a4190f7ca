/// Blocks with data of their own: smooth approach and departure, splines. Free contours: free_contour.cpp, tilted
/// planes: plane.cpp.

#include "interp/special.hpp"

#include <algorithm>
#include <cmath>

#include "base/codes.hpp"
#include "base/number.hpp"
#include "cl/spline.hpp"
#include "interp/capture.hpp"
#include "interp/complaints.hpp"
#include "interp/path_stage.hpp"
#include "path/smooth_approach.hpp"

namespace obrys::interp {

namespace codes = base::codes;
using geom::Vec2;
using geom::Vec3;
using program::Datum;
using program::Special;
using program::SpecialKind;

double datum_of(Reckoning& run, const Special& s, Datum datum, double otherwise) {
    for (const program::DatumValue& d : s.data)
        if (d.datum == datum) return number(run, d.value);
    return otherwise;
}

bool has_datum(const Special& s, Datum datum) {
    for (const program::DatumValue& d : s.data)
        if (d.datum == datum) return true;
    return false;
}

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
        run.path->push(run, p.path[i], s);
    }
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
    if (p.ok() && run.capture == nullptr) {
        run.path->tell_lead(run, lead_of(run, s, target, true));
        own_feed(run, true);
        push_approach(run, p, compensation);
        own_feed(run, false);
        run.path->tell_lead_end(run);
    }
    arrive(run, target);
}

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
    contour.direction = run.last_direction;
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
    if (run.capture == nullptr) {
        run.path->tell_lead(run, lead_of(run, s, target, false));
        own_feed(run, true);
        path::Setting ready;
        ready.approach = path::Approach::ready;
        for (const path::Element& e : p.path) run.path->push(run, e, ready);
        flush_path(run);
        own_feed(run, false);
        run.path->tell_lead_end(run);
    }
    Vec3 end = at;
    coordinate(end, a.u) = p.path.back().to.x;
    coordinate(end, a.v) = p.path.back().to.y;
    coordinate(end, a.w) = p.path.back().w_to;
    for (const path::Element& e : p.path)  // the tangent of what may follow is that of the way off the contour
        if (path::moves_in_plane(e)) run.last_direction = path::end_direction(e);
    arrive(run, end);
}

/// The control refuses a spline that starts more than 1 um beside the end of the last contour element (iTNC 530 User's
/// Manual, "Contour movements - spline interpolation": "larger deviations will provoke an error message"); it is held
/// to it axis by axis.
void check_start(Reckoning& run, const cl::Spline& spline) {
    const Vec3 gap = cl::start_gap(run.position, spline);
    const double worst = std::max({std::abs(gap.x), std::abs(gap.y), std::abs(gap.z)});
    constexpr double allowed = 0.001 + 1e-9;
    if (worst <= allowed) return;
    if (std::isnan(geom::length(gap))) {
        unchecked(run, codes::unknown_value, run.here(), "where the tool stands before this spline is not known");
        return;
    }
    alarm(run, codes::spline_start, run.here(),
          "the spline starts " + base::fixed(geom::length(gap), 4) +
              " mm beside the end of the last contour element, more than 0.001 mm along an axis",
          "let the coefficients K1, K2, K3 and the end point add up to where the last block ended");
}

/// The stream's splines have two additional axes at most, the control's five axes in all.
bool has_too_many_axes(Telling& run, const cl::Spline& spline) {
    if (spline.axes.size() <= 2) return false;
    unchecked(run, codes::unsupported, run.here(),
              "a spline with more than two axes besides X, Y and Z is not followed: it is run straight");
    for (const cl::SplineAxis& a : spline.axes)
        emit(run, axis_record(std::string_view(a.name.data()), a.to, a.rotary, false));
    emit(run, cl::Linear{spline.to, run.tool_axis, false});
    return true;
}

void spline(Moving& run, const Special& s) {
    flush_path(run);
    const double unit = length_unit(run.modal);
    cl::Spline record;
    const Vec3 to = programmed_target(run);
    Vec3 k[3];
    for (const program::DatumValue& d : s.data) {
        const auto n = static_cast<std::size_t>(d.datum) - static_cast<std::size_t>(Datum::k1);
        const double v = number(run, d.value);
        const auto axis = std::string_view("XYZ").find(d.axis);
        if (axis != std::string_view::npos) {
            coordinate(k[n], static_cast<int>(axis)) = v * unit;
            continue;
        }
        auto at =
            std::find_if(record.axes.begin(), record.axes.end(), [&](const auto& x) { return x.name[0] == d.axis; });
        if (at == record.axes.end()) {
            at = record.axes.insert(record.axes.end(), cl::SplineAxis{});
            at->name[0] = d.axis;
            const Code code = axis_code(static_cast<int>(std::string_view("XYZABC").find(d.axis)));
            at->to = run.block.has(code) ? run.block.get(code) : programmed_coordinate(run, std::string(1, d.axis));
            run.extra_axes[std::string(1, d.axis)] = at->to;
        }
        (n == 0 ? at->k1 : n == 1 ? at->k2 : at->k3) = v;
    }
    record.k1 = geom::apply_direction(run.frame, k[0]);
    record.k2 = geom::apply_direction(run.frame, k[1]);
    record.k3 = geom::apply_direction(run.frame, k[2]);
    record.to = geom::apply(run.frame, to);
    record.axis = run.tool_axis;
    if (run.modal.compensation != Modal::compensation_off)
        alarm(run, codes::compensation, run.here(), "a spline cannot be run with radius compensation",
              "write R0 before it");
    if (run.stopped || run.capture != nullptr) return arrive(run, to);
    require_feed(run);
    begin_motion(run);
    check_start(run, record);
    if (run.stopped) return;
    const PlaneAxes a = plane_axes(run.modal.plane);
    run.last_direction = -1.0 * in_plane(k[0], a);  // at t = 0 the curve runs against its parameter
    arrive(run, to);
    if (!has_too_many_axes(run, record)) emit(run, std::move(record));
}

void act(Moving& run, const Special& s, std::uint32_t index, Modal compensation_before) {
    if (s.kind <= SpecialKind::approach_arc_line) return approach(run, s);
    if (s.kind <= SpecialKind::departure_arc_line) return departure(run, s, compensation_before);
    if (s.kind == SpecialKind::spline) return spline(run, s);
    if (s.kind <= SpecialKind::free_select) return free_contour(run, s, index);
    plane(run, s);
}

}  // namespace

void run_special(Cycling& run, const program::Statement& statement, std::uint32_t index) {
    const Unit& unit = run.unit();
    const Special& s = unit.specials[static_cast<std::size_t>(unit.words[statement.first].payload)];
    run.block.clear();
    run.complained = false;
    const Modal compensation_before = run.modal.compensation;
    const std::uint32_t end = unit.words_end(index);
    for (std::uint32_t i = statement.first + 1; i < end; ++i) {
        gather(run, statement, unit.words[i]);
        if (run.stopped) return;
    }
    if (run.block.twice != 0) repeated_words(run);
    if (run.stopped) return;
    technology(run);
    if (!run.stopped && run.block.retract != 0) retract_tool(run);
    if (!run.stopped) act(run, s, index, compensation_before);
    const bool called = run.block.has(Code::cycle_call), modal = run.block.has(Code::cycle_call_modal);
    const bool moves =
        s.kind <= SpecialKind::spline && s.kind != SpecialKind::free_pole && s.kind != SpecialKind::free_select;
    if (!run.stopped && (called || modal || (moves && run.cycle.modal))) {
        run.cycle.modal = modal || (run.cycle.modal && !called);
        call_cycle(run);
    }
    report_unused(run);
    if (!run.stopped) after_motion(run);
}

}  // namespace obrys::interp
