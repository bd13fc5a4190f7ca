/// Cycles: what a definition keeps, what a call makes of it, and how the steps come into the stream.

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "base/codes.hpp"
#include "cycles/expand/expand.hpp"
#include "cycles/names.hpp"
#include "cycles/turn/turning.hpp"
#include "interp/complaints.hpp"
#include "interp/cycles/contour_cycle.hpp"
#include "interp/cycles/cycles.hpp"
#include "interp/moves/small_infeed.hpp"
#include "interp/stream/path_stage.hpp"

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

base::Span place_of_setting(const Saying& run, const ActiveCycle& c, cl::CycleRole role) {
    for (const program::CycleSetting& s : c.definition->settings)
        if (s.role == role) return s.where;
    return run.here();
}

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

namespace {

/// Climb or up-cut is what a milling cycle asks for; the manual at hand does not say which of them a mirror image
/// leaves.
void say_mirrored(Moving& run, const ActiveCycle& c) {
    const auto& settings = c.definition->settings;
    const bool directed = std::any_of(settings.begin(), settings.end(), [](const program::CycleSetting& s) {
        return s.role == cl::CycleRole::direction;
    });
    if (!directed || run.capture != nullptr || !(geom::determinant(run.frame) < 0)) return;
    assume(run, run.here(),
           c.definition->name +
               " in a mirror image: the path is taken to be mirrored with all else, so that the tool runs around the "
               "figure the other way");
}

}  // namespace

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
        const bool meant = !e || doubt_infeeds(run, c.definition->name, demand_of(run, c, instead), *e,
                                               [&](cl::CycleRole r) { return place_of_setting(run, c, r); });
        if (e && meant) {
            report(run, c, *e);
            say_mirrored(run, c);
        }
        if (!meant) {
            e.reset();
            lose_position(run);
        }
        if (e) emit_along(run, e->steps, elements, situation_of(run).at);
        if (run.stopped) return;
        if (run.feed_valid) emit(run, cl::Feed{run.feed, run.modal.feed_mode});
    }
    end_bracket(run);
}

namespace {

std::string parameter_name(const Saying& run, const program::CycleSetting& s) {
    if (s.parameter != program::no_target) return program::parameter_name(*run.unit().traits, s.parameter);
    return std::string(cycles::name(s.role));
}

}  // namespace

void begin_cycle(Cycling& run, const ActiveCycle& c, const CycleValues& instead, const WayOfCall& calling) {
    std::vector<cl::CycleParameter> written;
    for (std::size_t i = 0; i < c.values.size(); ++i)
        written.push_back({parameter_name(run, c.definition->settings[i]), value_at_call(run, c, i)});
    begin_bracket(run, demand_of(run, c, instead), c.definition->name, calling, std::move(written));
}

}  // namespace obrys::interp
