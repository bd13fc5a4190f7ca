/// From a cycle's expansion to the stream.

#include <algorithm>

#include "base/codes.hpp"
#include "interp/moves/cycle_steps.hpp"
#include "interp/stream/path_stage.hpp"

namespace obrys::interp {

namespace codes = base::codes;

geom::Vec3 into_plane(const geom::Vec3& p, const PlaneAxes& a) {
    return {coordinate(p, a.u), coordinate(p, a.v), coordinate(p, a.w)};
}

geom::Vec3 out_of_plane(const geom::Vec3& p, const PlaneAxes& a) {
    geom::Vec3 v;
    coordinate(v, a.u) = p.x;
    coordinate(v, a.v) = p.y;
    coordinate(v, a.w) = p.z;
    return v;
}

cycles::Situation situation_of(const Reckoning& run) {
    cycles::Situation s;
    s.at = into_plane(run.programmed_position, plane_axes(run.modal.plane));
    s.tool_radius = active_radius(run);
    if (const shop::Tool* t = run.tool.data; t != nullptr) {
        if (mill_radius(*t)) s.tool_corner_radius = t->corner_radius + t->delta_corner_radius + run.tool.delta_corner;
        s.tool_point_angle = t->point_angle.value_or(cycles::unknown);
        s.tool_plunge_angle = t->plunge_angle.value_or(cycles::unknown);
        s.tool_cutting_length = t->cutting_length.value_or(cycles::unknown);
    }
    s.spindle_speed = run.spindle.speed;
    s.spindle_direction = run.spindle.direction;
    if (run.feed_valid && run.modal.feed_mode == cl::FeedMode::per_minute) s.feed = run.feed;
    return s;
}

namespace {

/// An arc of a cycle, which runs in the plane, as an element of it.
path::Element plane_arc(const cl::Arc& arc) {
    path::Element e;
    e.to = {arc.to.x, arc.to.y};
    e.w_to = arc.to.z;
    e.centre = {arc.centre.x, arc.centre.y};
    e.w_from = arc.centre.z;
    e.sweep = arc.normal.z < 0 ? -arc.sweep : arc.sweep;
    return e;
}

}  // namespace

void emit_step(Telling& run, cl::Step step) {
    const PlaneAxes a = plane_axes(run.modal.plane);
    const auto place = [&](const geom::Vec3& p) {
        run.programmed_position = out_of_plane(p, a);
        run.position = geom::apply(run.frame, run.programmed_position);
        return run.position;
    };
    if (auto* linear = std::get_if<cl::Linear>(&step)) {
        linear->to = place(linear->to);
        linear->axis = run.tool_axis;
    } else if (auto* thread = std::get_if<cl::Thread>(&step)) {
        thread->to = place(thread->to);
        thread->axis = run.tool_axis;
    } else if (auto* arc = std::get_if<cl::Arc>(&step)) {
        const PlaneView view(run);
        const path::Element element = plane_arc(*arc);
        const bool rapid = arc->rapid;
        cl::Arc placed;
        if (path::is_arc(element) && !view.arc(element, rapid, placed)) return circle_alarm(run, run.here());
        place(arc->to);
        if (path::is_arc(element))
            step = placed;
        else
            view.line(element, rapid, step.emplace<cl::Linear>());
    }
    emit(run, std::move(step));
}

void path_step(Moving& run, cl::Step step) {
    const PlaneAxes a = plane_axes(run.modal.plane);
    if (run.modal.compensation == Modal::compensation_off) return emit_step(run, std::move(step));
    if (const auto* linear = std::get_if<cl::Linear>(&step))
        return straight_motion(run, out_of_plane(linear->to, a), linear->rapid);
    const auto* arc = std::get_if<cl::Arc>(&step);
    if (arc == nullptr) return emit_step(run, std::move(step));
    path::Element e = plane_arc(*arc);
    const geom::Vec3 from = into_plane(run.programmed_position, a);
    e.from = {from.x, from.y};
    e.w_from = from.z;
    plane_element(run, std::move(e), out_of_plane(arc->to, a), false);
}

void emit_steps(Telling& run, std::vector<cl::Step>& steps) {
    for (cl::Step& step : steps)
        if (!run.stopped) emit_step(run, std::move(step));
}

void emit_hole(Telling& run, std::string_view name, const cycles::Demand& told, cycles::Expansion& e,
               const WayOfCall& calling) {
    // A rigid tap that turns the spindle on leaves it standing: another speed alone does not turn it.
    const bool stops = told.kind == cl::CycleKind::canned_tap_rigid && told.get(cl::CycleRole::starts_spindle, 0) == 1;
    const bool leaves = told.find(cl::CycleRole::spindle_after).has_value();
    if (e.steps.empty()) begin_bracket(run, told, name, calling);  // not simulated
    for (std::size_t i = 0; i < e.steps.size(); ++i) {
        if (run.stopped) return;
        cl::Step& step = e.steps[i];
        if (i == e.leads) begin_bracket(run, told, name, calling);
        if (const auto* s = std::get_if<cl::Spindle>(&step); s != nullptr && (stops || leaves))
            run.spindle.direction = s->direction;
        emit_step(run, std::move(step));
    }
    if (!run.stopped) end_bracket(run);
}

bool report_expansion(Reckoning& run, std::string_view name, const cycles::Expansion& e) {
    const std::string cycle(name);
    for (const cycles::Complaint& k : e.complaints) {
        if (k.fatal) {
            alarm(run, codes::value_range, run.here(), cycle + ": " + k.text, k.remedy);
            return false;
        }
        if (k.doubtful)
            doubt(run, codes::value_range, run.here(), cycle + ": " + k.text, k.remedy);
        else
            assume(run, run.here(), cycle + ": " + k.text, k.remedy);
    }
    if (!e.assumption.empty()) assume(run, run.here(), cycle + ": " + std::string(e.assumption));
    if (e.simulated) return true;
    unchecked(run, codes::unsupported, run.here(), cycle + " is not run: its path is not known here");
    lose_position(run);
    return true;
}

}  // namespace obrys::interp
