/// Turning cycles whose contour is a subprogram, and threads in several passes (Traits::turning).
/// Source: LinuxCNC, G-Codes, "G70 Lathe finishing cycle", "G71 G72 Lathe roughing cycles", "G76 Threading cycle".

#include "cycles/turn/turning.hpp"

#include <cmath>

#include "base/codes.hpp"
#include "interp/capture.hpp"
#include "interp/cycles/cycles.hpp"
#include "interp/moves/small_infeed.hpp"

namespace obrys::interp {

namespace codes = base::codes;
using cl::CycleRole;
using cycles::TurningElement;

namespace {

const program::CannedCycle* find_cycle(const Moving& run) {
    for (const program::CannedCycle& c : run.traits->turning)
        if (c.number == run.block.special_number) return &c;
    return nullptr;
}

bool takes_roughed_contour(cl::CycleKind k) {
    return k == cl::CycleKind::lathe_finish_offset || k == cl::CycleKind::lathe_rough_along ||
           k == cl::CycleKind::lathe_rough_across;
}

TurningElement element_of(const Captured& c) {
    TurningElement e;
    e.to = c.element.to;
    e.centre = c.element.centre;
    e.turn = !path::is_arc(c.element) ? 0 : c.element.sweep > 0 ? 1 : -1;
    e.rapid = c.rapid;
    e.fillet = c.fillet;
    e.chamfer = c.chamfer;
    return e;
}

/// The elements of the subprogram that Q names; nothing after a complaint.
std::optional<std::vector<TurningElement>> contour(Moving& run, const program::CannedCycle& c, const geom::Vec3& from) {
    const double q = run.block.has(Code::q) ? run.block.get(Code::q) : -1;
    const std::string name = "O" + printed(Value::real(q));
    const Unit* unit = q >= 0 && q == std::floor(q) ? run.env.find_program(name) : nullptr;
    if (unit == nullptr) {
        alarm(run, codes::missing_subprogram, run.here(),
              std::string(c.name) + ": Q must be the number of the subprogram that holds the contour" +
                  (q >= 0 ? ", and there is no " + name : ""));
        return std::nullopt;
    }
    const auto elements = run.onward->turned_contour(*unit, from).said(run, std::string(c.name));
    if (!elements) {
        alarm(run, codes::contour, run.here(), std::string(c.name) + ": the contour " + name + " does not end");
        return std::nullopt;
    }
    std::vector<TurningElement> all;
    for (const Captured& e : *elements) {
        all.push_back(element_of(e));
        if (std::isfinite(all.back().to.x) && std::isfinite(all.back().to.y)) continue;
        unchecked(run, codes::unknown_value, e.where, "the contour depends on a value that is not known");
        return std::nullopt;
    }
    return all;
}

void take_words(const Moving& run, const program::CannedCycle& c, cycles::Demand& d) {
    const double unit = length_unit(run.modal);
    const bool diameters = run.modal.diameter != DiameterMode::off;
    d.values.assign(c.fixed.begin(), c.fixed.end());
    d.values.push_back({CycleRole::length_unit, unit});
    for (const program::CannedWord& w : c.words)
        if (run.block.has(w.code))
            d.values.push_back(
                {w.role, run.block.get(w.code) * (w.length ? unit : 1) * w.factor * (w.across && diameters ? 0.5 : 1)});
}

base::Span place_of_role(const Saying& run, const program::CannedCycle& c, CycleRole role) {
    for (const program::CannedWord& w : c.words)
        if (w.role == role) return place_of_word(run, w.code);
    return run.here();
}

}  // namespace

void emit_turning_steps(Moving& run, std::vector<cl::Step>& steps) {
    for (std::size_t i = 0; i < steps.size() && !run.stopped; ++i) path_step(run, std::move(steps[i]));
}

bool turning_cycle(Moving& run) {
    const program::CannedCycle* c = find_cycle(run);
    if (c == nullptr) {
        unchecked(run, codes::unsupported, run.here(),
                  "G" + printed(Value::real(run.block.special_number / 10.0)) + " is not run");
        return false;
    }
    if (run.modal.plane != 18) {
        alarm(run, codes::value_range, run.here(), std::string(c->name) + " needs the plane of G18");
        return false;
    }
    if (run.modal.compensation == Modal::compensation_off) flush_path(run);
    cycles::TurningDemand demand;
    demand.cycle.kind = c->kind;
    take_words(run, *c, demand.cycle);
    const PlaneAxes a = plane_axes(run.modal.plane);
    const geom::Vec3 start = programmed_target(run), target = into_plane(start, a);
    if (run.block.has(Code::z)) demand.cycle.values.push_back({CycleRole::target_u, target.x});
    if (run.block.has(Code::x)) demand.cycle.values.push_back({CycleRole::target_v, target.y});
    if (takes_roughed_contour(c->kind)) {
        auto elements = contour(run, *c, start);
        if (!elements) return false;
        demand.contour = std::move(*elements);
    }
    demand.situation = situation_of(run);
    cycles::Expansion e = cycles::expand_turning(demand);
    if (!doubt_infeeds(run, c->name, demand.cycle, e, [&](CycleRole r) { return place_of_role(run, *c, r); })) {
        lose_position(run);
        return true;
    }
    if (!report_expansion(run, c->name, e)) return false;
    begin_bracket(run, demand.cycle, c->name);
    emit_turning_steps(run, e.steps);
    if (!run.stopped) end_bracket(run);
    return !run.stopped;
}

}  // namespace obrys::interp
