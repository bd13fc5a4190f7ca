/// Where cycles are called besides the place of the tool: CYCL CALL POS, CYCL CALL PAT, cycles 220 and 221.
/// Source: HEIDENHAIN iTNC 530 cycle programming, "WayOfCall cycles", "Point tables", "Point patterns"; of it the order
/// of the ways and the clearance height between points are from memory.

#include <algorithm>
#include <cmath>

#include "base/codes.hpp"
#include "cycles/contour/contour.hpp"
#include "cycles/pattern.hpp"
#include "interp/capture.hpp"
#include "interp/cycles/cycles.hpp"

namespace obrys::interp {

namespace codes = base::codes;
using cl::CycleKind;
using geom::Vec3;
using Role = cl::CycleRole;

namespace {

/// Coordinates along the tool axis in which a cycle works. NaN: it does not say.
struct Heights {
    double surface = NAN, first = NAN, second = NAN;  ///< second: free of clamps
};
Heights heights_of(const cycles::Demand& d) {
    Heights h;
    h.surface = d.get(Role::surface);
    if (const auto absolute = d.find(Role::clearance_height)) {
        h.first = h.second = *absolute;
        return h;
    }
    const double clearance = d.get(Role::clearance);
    h.first = h.surface + clearance;
    h.second = h.surface + std::max(clearance, d.get(Role::second_clearance, clearance));
    return h;
}

/// The tool's way between calls, in the working plane's coordinates.
class Way {
public:
    Way(Moving& run, bool rapid) : run_(run), axes_(plane_axes(run.modal.plane)), rapid_(rapid) {}

    [[nodiscard]] Vec3 at() const { return into_plane(run_.programmed_position, axes_); }
    void to(const Vec3& p) {
        const Vec3 now = at();
        const auto same = [](double a, double b) { return std::abs(a - b) < 1e-9 || (std::isnan(a) && std::isnan(b)); };
        if (run_.stopped || (same(p.x, now.x) && same(p.y, now.y) && same(p.z, now.z))) return;
        if (!rapid_) require_feed(run_);
        step(cl::Linear{p, {0, 0, 1}, rapid_});
    }
    void to_height(double w) {
        Vec3 p = at();
        if (std::isnan(w)) return;
        p.z = w;
        to(p);
    }
    void to_place(const Vec3& p) { to({p.x, p.y, at().z}); }
    /// The shorter way about `centre`, which is at the same distance from both ends.
    void along_circle(geom::Vec2 centre, const Vec3& p) {
        const geom::Vec2 from = geom::Vec2{at().x, at().y} - centre, end = geom::Vec2{p.x, p.y} - centre;
        const double turn = std::atan2(geom::cross(from, end), geom::dot(from, end));
        if (!(std::abs(turn) > 1e-12)) return to_place(p);
        cl::Arc arc;
        arc.to = {p.x, p.y, at().z};
        arc.centre = {centre.x, centre.y, at().z};
        arc.sweep = turn;
        arc.rapid = rapid_;
        step(arc);
    }

private:
    void step(cl::Step s) {
        flush_path(run_);
        begin_motion(run_);
        std::vector<cl::Step> steps{std::move(s)};
        emit_steps(run_, steps);
    }

    Moving& run_;
    PlaneAxes axes_;
    bool rapid_;
};

bool stands_alone(CycleKind k) { return k == CycleKind::program_call || cycles::is_contour_cycle(k); }

/// Cycles whose own coordinates are counted from the place of the call; others just stand there.
bool has_own_place(const cycles::Demand& d) {
    return stands_alone(d.kind) || d.find(Role::centre_u) || d.find(Role::start_u);
}

/// Calls the cycle with the frame shifted; a program that it calls is run to its end.
void call_shifted(Cycling& run, const Vec3& by, const CycleValues& instead, const WayOfCall& calling) {
    const Vec3 at = run.programmed_position;
    const bool shifted = by.x != 0 || by.y != 0 || by.z != 0;
    if (shifted) shift_for_call(run, by);
    if (shifted) run.programmed_position = at - by;
    const std::size_t depth = run.calls.size();
    const program::Statement* statement = run.statement;
    const BlockWords block = run.block;
    const bool complained = run.complained;
    const ActiveCycle cycle = run.cycle;
    call_cycle(run, instead, calling);
    const bool program = run.calls.size() > depth;
    while (!run.stopped && run.calls.size() > depth) run.onward->step();
    if (run.stopped) return;
    if (program) {
        run.statement = statement;
        run.block = block;
        run.complained = complained;
        run.cycle = cycle;
    }
    const Vec3 end = run.programmed_position + by;
    if (shifted) shift_for_call(run, -1 * by);
    if (shifted && !program) run.programmed_position = end;
}

/// Calls the cycle at `place` (u, v, and the shift of its surface), where the tool stands already.
void call_at(Cycling& run, const cycles::Demand& d, Vec3 place, const WayOfCall& calling,
             const CycleValues& instead = {}) {
    if (!has_own_place(d)) place.x = place.y = 0;
    call_shifted(run, out_of_plane(place, plane_axes(run.modal.plane)), instead, calling);
}

bool cycle_is_defined(Cycling& run) {
    if (run.cycle.definition != nullptr) return true;
    alarm(run, codes::missing_label, run.here(), "no cycle is defined that could be called here",
          "define one with CYCL DEF before the call");
    return false;
}

/// The shift of the surface does nothing to a cycle that counts from where the tool stands.
void require_surface(Cycling& run, const cycles::Demand& d, double z) {
    if (z == 0 || d.find(Role::surface) || d.kind == CycleKind::program_call) return;
    unchecked(run, codes::unsupported, run.here(),
              run.cycle.definition->name + " has no surface coordinate: the Z of the pattern's points is left out");
}

}  // namespace

void run_point_cycle(Cycling& run, const ActiveCycle& c) {
    if (!cycle_is_defined(run)) return;
    const cycles::Demand points = demand_of(run, c), cycle = demand_of(run, run.cycle);
    const cycles::Positions p = cycles::pattern_positions(points);
    report(run, c, p.complaints);
    if (run.stopped || !p.ok()) return;
    CycleValues heights;
    for (const Role role : {Role::clearance, Role::surface, Role::second_clearance})
        if (const auto v = points.find(role)) heights.push_back({role, *v});
    const Heights h = heights_of(points);
    begin_cycle(run, c);
    Way way(run, true);
    for (std::size_t i = 0; i < p.at.size() && !run.stopped; ++i) {
        const Vec3 place{p.at[i].x, p.at[i].y, 0};
        way.to_height(i == 0 || p.at_second_clearance ? h.second : h.first);
        if (i > 0 && p.along_circle)
            way.along_circle(p.centre, place);
        else
            way.to_place(place);
        CycleValues instead = heights;
        if (!p.at_second_clearance && i + 1 < p.at.size())
            instead.push_back({Role::second_clearance, points.get(Role::clearance)});
        call_at(run, cycle, place, {cl::CycleCall::pattern, i + 1, p.at.size()}, instead);
        if (over_budget(run, i % 64 == 63)) return;
    }
    if (!run.stopped) end_bracket(run);
}

void call_cycle_at_position(Cycling& run) {
    if (!cycle_is_defined(run)) return;
    const PlaneAxes a = plane_axes(run.modal.plane);
    const cycles::Demand d = demand_of(run, run.cycle);
    Vec3 place = into_plane(programmed_target(run), a);
    if (!run.block.has(axis_code(a.w)) && d.find(Role::surface)) place.z = 0;
    if (stands_alone(d.kind)) return call_at(run, d, place, {});
    Way way(run, run.modal.motion == Modal::rapid);
    const double now = way.at().z;
    if (!d.find(Role::surface)) {  // it counts from where the tool stands
        if (!(now >= place.z)) way.to_height(place.z);
        way.to_place(place);
        way.to_height(place.z);
        return call_cycle(run);
    }
    const Heights h = heights_of(d);
    if (!(now > h.surface + place.z)) way.to_height(h.second + place.z);
    way.to_place(place);
    call_at(run, d, place, {});
}

void call_cycle_at_pattern(Cycling& run) {
    if (!cycle_is_defined(run)) return;
    if (!run.pattern.defined) {
        alarm(run, codes::missing_label, run.here(), "no points are defined for CYCL CALL PAT",
              "define them with PATTERN DEF or name their table with SEL PATTERN before the call");
        return;
    }
    const CallPattern pattern = run.pattern;  // a program that is called may define another
    const PlaneAxes a = plane_axes(run.modal.plane);
    const cycles::Demand d = demand_of(run, run.cycle);
    const Heights h = heights_of(d);
    Way way(run, run.modal.motion == Modal::rapid);
    const double start = way.at().z;
    for (std::size_t i = 0; i < pattern.points.size() && !run.stopped; ++i) {
        Vec3 place = into_plane(pattern.points[i].at, a);
        require_surface(run, d, place.z);
        if (!std::isnan(pattern.points[i].clearance))
            way.to_height(pattern.points[i].clearance);
        else
            way.to_height(std::fmax(start, h.second + (d.find(Role::clearance_height) ? 0 : place.z)));
        if (!stands_alone(d.kind)) way.to_place(place);
        if (!d.find(Role::surface) && d.kind != CycleKind::program_call) place.z = 0;
        call_at(run, d, place, {cl::CycleCall::pattern, i + 1, pattern.points.size()});
        if (over_budget(run, i % 64 == 63)) return;
    }
}

}  // namespace obrys::interp
