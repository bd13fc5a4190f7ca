/// Cycles: what a definition keeps, what a call makes of it, and how the steps come into the stream.

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "base/codes.hpp"
#include "cycles/expand/expand.hpp"
#include "cycles/turn/turning.hpp"
#include "interp/complaints.hpp"
#include "interp/contour_cycle.hpp"
#include "interp/cycle_call.hpp"

namespace obrys::interp {

namespace codes = base::codes;
using program::CycleDefinition;
using program::CycleSetting;
using program::CycleUse;

namespace {

/// A cycle's own value is no setting of the program, even where one parameter serves both (Q10 of CYCL DEF 25).
void define_parameter(Reckoning& run, const CycleDefinition& d, const CycleSetting& s, double v) {
    const std::uint32_t n = s.parameter;
    if (run.parameter_overridden[n] != 0 && v != run.parameter_override[n])
        assume(run, s.where,
               program::parameter_name(*run.unit().traits, n) + " is set from outside, and " + d.name +
                   " sets it to a value of its own here: that of the cycle holds from here on");
    run.parameters.set(n, v);
}

/// The definition's assignments: a named parameter is set for everybody, as the control does it.
ActiveCycle take(Reckoning& run, const CycleDefinition& d) {
    ActiveCycle c;
    c.definition = &d;
    c.unit = &run.unit();
    for (const CycleSetting& s : d.settings) {
        const double written = number(run, s.value);
        const double v = value_at_definition(run, s, written);
        c.written.push_back(written);
        c.values.push_back(v);
        if (s.parameter != program::no_target && s.parameter < run.parameters.count()) define_parameter(run, d, s, v);
    }
    for (const ExprId id : d.texts) c.texts.push_back(printed(evaluate(run, id)));
    return c;
}

void add_values(const Reckoning& run, const ActiveCycle& c, cycles::Demand& d) {
    if (c.definition == nullptr) return;
    const double unit = length_unit(run.modal);
    for (std::size_t i = 0; i < c.values.size(); ++i) {
        const CycleSetting& s = c.definition->settings[i];
        const double factor = s.is_feed ? feed_factor(run) : s.scales ? unit : 1;
        const double v = value_at_call(run, c, i) * factor;
        const bool may_be_rapid = s.role == cl::CycleRole::feed_position || s.role == cl::CycleRole::feed_retract;
        d.values.push_back({s.role, may_be_rapid && v >= fastest_feed ? std::numeric_limits<double>::infinity() : v});
    }
}

}  // namespace

/// A contour cycle takes what the cycle of its data says, and then its own values.
cycles::Demand demand_of(const Cycling& run, const ActiveCycle& c, const CycleValues& instead) {
    cycles::Demand d;
    d.kind = c.definition->kind;
    if (d.kind == cl::CycleKind::contour_train)
        add_values(run, run.contour_train_data, d);
    else if (cycles::is_contour_cycle(d.kind))
        add_values(run, run.contour_data, d);
    add_values(run, c, d);
    d.values.insert(d.values.end(), instead.begin(), instead.end());
    return d;
}

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

geom::Vec2 far_from(const cycles::ContourTask& task) {
    const bool train = !task.train.contour.vertices.empty();
    if (!train && (task.area.empty() || task.area.contours.front().vertices.empty())) return {};
    const geom::Vec2 p = train ? task.train.contour.vertices.front().p : task.area.contours.front().vertices.front().p;
    return p + geom::Vec2{1000, 1000};
}

void append(cycles::Expansion& all, cycles::Expansion more) {
    std::move(more.steps.begin(), more.steps.end(), std::back_inserter(all.steps));
    for (cycles::Complaint& k : more.complaints)
        if (std::none_of(all.complaints.begin(), all.complaints.end(),
                         [&](const auto& have) { return have.text == k.text; }))
            all.complaints.push_back(std::move(k));
    if (!more.assumption.empty()) all.assumption = more.assumption;
    all.simulated = all.simulated && more.simulated;
}

geom::Vec3 end_of(const std::vector<cl::Step>& steps, const geom::Vec3& otherwise) {
    for (auto s = steps.rbegin(); s != steps.rend(); ++s) {
        if (const auto* line = std::get_if<cl::Linear>(&*s)) return line->to;
        if (const auto* arc = std::get_if<cl::Arc>(&*s)) return arc->to;
    }
    return otherwise;
}

/// The steps of the cycle; nothing after a complaint.
std::optional<cycles::Expansion> expansion(Cycling& run, const ActiveCycle& c, const CycleValues& instead,
                                           ContourElements& elements) {
    const cycles::Demand demand = demand_of(run, c, instead);
    if (!cycles::is_contour_cycle(demand.kind)) return cycles::expand(demand, situation_of(run));
    const auto layers = contour_layers(run, demand, elements);
    if (!layers) return std::nullopt;
    cycles::Expansion all;
    cycles::Situation s = situation_of(run);
    for (const ContourLayer& layer : *layers) {
        // The cycle goes to its contour by itself: where it comes from does not matter, if only it is somewhere else.
        if (std::isnan(s.at.x) || std::isnan(s.at.y)) {
            const geom::Vec2 far = far_from(layer.task);
            s.at.x = far.x;
            s.at.y = far.y;
        }
        cycles::Demand own = demand;
        own.values.insert(own.values.end(), layer.instead.begin(), layer.instead.end());
        append(all, cycles::expand_contour(own, s, layer.task));
        if (!all.ok()) break;
        if (!all.steps.empty()) s.at = end_of(all.steps, s.at);
    }
    return all;
}

}  // namespace

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

void report(Saying& run, const ActiveCycle& c, const cycles::Expansion& e) {
    if (not_run_for_unknown(run, c, e)) return;
    report(run, c, e.complaints);
    if (!e.assumption.empty()) assume(run, run.here(), c.definition->name + ": " + std::string(e.assumption));
    if (!e.simulated)
        unchecked(run, codes::unsupported, run.here(), c.definition->name + " is not run: its path is not known here");
}

}  // namespace

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
    } else if (auto* arc = std::get_if<cl::Arc>(&step)) {
        auto placed = plane_move(run, plane_arc(*arc), arc->rapid);
        if (!placed) return circle_alarm(run, run.here());
        place(arc->to);
        step = std::move(*placed);
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
    plane_element(run, e, out_of_plane(arc->to, a), false);
}

void emit_steps(Telling& run, std::vector<cl::Step>& steps) {
    for (cl::Step& step : steps)
        if (!run.stopped) emit_step(run, std::move(step));
}

namespace {

void call_program_of(Calling& run, const ActiveCycle& c) {
    if (c.texts.empty()) return;
    program::Call call;
    call.name = run.env.names.id(c.texts.front());
    call.where = run.here();
    call_program(run, call);
}

}  // namespace

void define_cycle(Cycling& run, const CycleDefinition& d) {
    if (d.kind == cl::CycleKind::global_values) return set_globally(run, d);
    ActiveCycle c = take(run, d);
    if (run.stopped) return;
    if (d.use == CycleUse::refused) {
        unchecked(run, codes::unsupported, d.where, d.name + " is not run" + (d.reason.empty() ? "" : ": " + d.reason));
        if (d.call_active) run.cycle = std::move(c);
        return;
    }
    if (d.call_active) {
        run.cycle = std::move(c);
        return;
    }
    if (cycles::is_turning_cycle(d.kind)) return define_turning_cycle(run, c);
    if (d.use == CycleUse::run && !act_at_definition(run, c))
        unchecked(run, codes::unsupported, d.where, d.name + " is not run");
}

void call_cycle(Cycling& run) { call_cycle(run, {}, {run.cycle.modal ? cl::CycleCall::modal : cl::CycleCall::single}); }

void call_cycle(Cycling& run, const CycleValues& instead, const WayOfCall& calling) {
    if (run.cycle.definition == nullptr) {
        alarm(run, codes::missing_label, run.here(), "no cycle is defined that could be called here",
              "define one with CYCL DEF before the call");
        return;
    }
    const ActiveCycle c = run.cycle;
    if (c.definition->kind == cl::CycleKind::program_call) return call_program_of(run, c);
    if (run.look != Look::no) return;  // the others make no elements of a contour
    if (run.modal.compensation != Modal::compensation_off)
        unchecked(
            run, codes::unsupported, run.here(),
            c.definition->name +
                " is called with radius compensation in force: where the control goes then is not known, it is run "
                "at the programmed point",
            "position with R0 before the call");
    if (run.spindle.doubtful) judge_stop(run);
    flush_path(run);
    begin_cycle(run, c, instead, calling);
    const bool known = cycles::is_expanded(c.definition->kind) || cycles::is_contour_cycle(c.definition->kind);
    if (c.definition->use == CycleUse::refused || !known) {
        unchecked(run, codes::unsupported, run.here(), c.definition->name + " is called and not run");
        lose_position(run);
    } else {
        say_unknown_words(run, c);
        ContourElements elements;
        std::optional<cycles::Expansion> e = expansion(run, c, instead, elements);
        if (e) report(run, c, *e);
        if (e) emit_along(run, e->steps, elements, situation_of(run).at);
        if (run.stopped) return;
        if (run.feed_valid) emit(run, cl::Feed{run.feed, run.modal.feed_mode});
    }
    end_bracket(run);
}

}  // namespace obrys::interp
