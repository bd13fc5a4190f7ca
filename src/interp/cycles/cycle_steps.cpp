/// From a cycle's expansion to the stream.

#include <algorithm>

#include "base/codes.hpp"
#include "cycles/names.hpp"
#include "interp/complaints.hpp"
#include "interp/cycles/cycles.hpp"
#include "interp/stream/path_stage.hpp"

namespace obrys::interp {

namespace codes = base::codes;
using program::CycleSetting;

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

void report(Saying& run, const ActiveCycle& c, const std::vector<cycles::Complaint>& complaints) {
    for (const cycles::Complaint& k : complaints) {
        base::Span where = run.here();
        for (const CycleSetting& s : c.definition->settings)
            if (k.role && s.role == *k.role) where = s.where;
        base::Diagnostic d{k.fatal ? base::Severity::error : base::Severity::warning,
                           k.fatal ? codes::value_range : codes::assumption,
                           where,
                           c.definition->name + ": " + k.text,
                           k.remedy,
                           run.stacks->sites(run.top().stack),
                           {}};
        if (!(where == run.here())) d.related.push_back({run.here(), "called here"});
        raise(run, std::move(d));
    }
}

namespace {

/// The cause is something that is not known; the complaints that name it.
bool not_run_for_unknown(Saying& run, const ActiveCycle& c, const cycles::Expansion& e) {
    if (e.simulated || !e.assumption.empty() || e.complaints.empty()) return false;
    const bool all = std::all_of(e.complaints.begin(), e.complaints.end(), [](const cycles::Complaint& k) {
        return !k.fatal && !k.role && k.text.find("not known") != std::string::npos;
    });
    if (!all) return false;
    for (const cycles::Complaint& k : e.complaints)
        unchecked(run, codes::unknown_value, run.here(), c.definition->name + " is not run: " + k.text,
                  k.remedy.empty() ? "give it in the job; what a tool has, in its [[tool]]" : k.remedy);
    return true;
}

}  // namespace

void report(Saying& run, const ActiveCycle& c, const cycles::Expansion& e) {
    if (not_run_for_unknown(run, c, e)) return;
    report(run, c, e.complaints);
    if (!e.assumption.empty()) assume(run, run.here(), c.definition->name + ": " + std::string(e.assumption));
    if (!e.simulated)
        unchecked(run, codes::unsupported, run.here(), c.definition->name + " is not run: its path is not known here");
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

bool report_expansion(Reckoning& run, std::string_view name, const cycles::Expansion& e) {
    const std::string cycle(name);
    for (const cycles::Complaint& k : e.complaints) {
        if (k.fatal) {
            alarm(run, codes::value_range, run.here(), cycle + ": " + k.text, k.remedy);
            return false;
        }
        assume(run, run.here(), cycle + ": " + k.text, k.remedy);
    }
    if (!e.assumption.empty()) assume(run, run.here(), cycle + ": " + std::string(e.assumption));
    if (e.simulated) return true;
    unchecked(run, codes::unsupported, run.here(), cycle + " is not run: its path is not known here");
    lose_position(run);
    return true;
}

}  // namespace obrys::interp
