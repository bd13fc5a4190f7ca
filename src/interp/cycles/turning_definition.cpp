/// Turning cycles that are given with their parameters (program::CycleDefinition): stock removal down to a contour of
/// the program's own blocks and its finishing, grooves, threads. What stays with the control and what it holds itself
/// comes with the definition.

#include "base/codes.hpp"
#include "cycles/names.hpp"
#include "interp/cycles/cycles.hpp"
#include "interp/cycles/turned_contour.hpp"
#include "interp/moves/small_infeed.hpp"
#include "interp/stream/path_stage.hpp"

namespace obrys::interp {

namespace codes = base::codes;
using cl::CycleKind;
using cl::CycleRole;
using program::CycleDefinition;
using program::CycleSetting;

namespace {

bool takes_defined_contour(CycleKind k) {
    return k == CycleKind::lathe_finish || k == CycleKind::lathe_remove_along || k == CycleKind::lathe_remove_across ||
           k == CycleKind::lathe_repeat_pattern;
}

/// mm, degrees; targets absolute.
double in_mm(const Reckoning& run, const CycleSetting& s, double v) {
    const PlaneAxes a = plane_axes(run.modal.plane);
    if (s.role == CycleRole::target_u || s.role == CycleRole::target_v) {
        const int k = s.role == CycleRole::target_u ? a.u : a.v;
        const bool incremental = s.incremental || !run.modal.absolute;
        v *= length_factor(run, k, incremental);
        return incremental ? coordinate(run.programmed_position, k) + v : v;
    }
    if (s.scales && run.modal.inch_geometry) v *= 25.4;
    return s.across && run.modal.diameter != DiameterMode::off ? v / 2 : v;
}

/// What the control keeps, then what the cycle says, then what is taken for the rest.
cycles::Demand demand_of_turning(Cycling& run, const ActiveCycle& c) {
    const CycleDefinition& d = *c.definition;
    cycles::Demand out;
    out.kind = d.kind;
    for (const auto& [key, kept] : run.cycle_store)
        if (key.first == d.store && d.store != 0) out.values.push_back({key.second, kept.value});
    for (std::size_t i = 0; i < c.values.size(); ++i)
        out.values.push_back({d.settings[i].role, in_mm(run, d.settings[i], c.values[i])});
    for (const program::CycleDefault& o : d.otherwise) {
        if (out.find(o.role) || (o.needs != o.role && !out.find(o.needs))) continue;
        out.values.push_back({o.role, o.value});
        assume(run, d.where, d.name + ": " + std::string(o.text));
    }
    return out;
}

void keep(Cycling& run, const ActiveCycle& c) {
    for (std::size_t i = 0; i < c.values.size(); ++i) {
        const CycleSetting& s = c.definition->settings[i];
        run.cycle_store[{c.definition->store, s.role}] = {in_mm(run, s, c.values[i]), s.where};
    }
}

bool names_axis(const Unit& unit, std::uint32_t first, Code axis) {
    for (std::uint32_t i = first; i < unit.statements.size(); ++i) {
        if (i > first && (unit.statements[i].flags & program::line_start) != 0) return false;
        for (std::uint32_t w = unit.statements[i].first; w < unit.words_end(i); ++w)
            if (program::code_of(unit.words[w]) == axis) return true;
    }
    return false;
}

/// Contours of stock removal: with both axes in their first block they may have pockets; with one it is that of the
/// infeed. False after a complaint.
bool choose_type(Reckoning& run, const CycleDefinition& d, const ContourBlocks& blocks, cycles::Demand& demand) {
    if (d.kind == CycleKind::lathe_repeat_pattern) return true;
    if (blocks.names_both_axes) {
        demand.values.push_back({CycleRole::pockets, 1});
        return true;
    }
    const bool along = d.kind == CycleKind::lathe_remove_along;
    if (names_axis(run.unit(), blocks.first, along ? Code::x : Code::z)) return true;
    alarm(
        run, codes::contour, run.unit().span(run.unit().statements[blocks.first]),
        d.name + ": the first block of the contour does not move " + (along ? "X" : "Z") + ", the axis of the infeed");
    return false;
}

/// Grooves, holes and threads know no compensation; cuts of one block (G90, G94) do, and contours when they are
/// finished.
bool cannot_be_compensated(CycleKind k) {
    return k == CycleKind::lathe_peck_along || k == CycleKind::lathe_peck_across ||
           k == CycleKind::lathe_thread_passes || k == CycleKind::lathe_box_thread;
}

/// Controls leave compensation off in these cycles; where the tool stands that comes in with it is not known here [-].
bool refuse_compensated(Reckoning& run, const CycleDefinition& d) {
    if (!cannot_be_compensated(d.kind) || run.modal.compensation == Modal::compensation_off) return false;
    unchecked(run, codes::unsupported, d.where,
              d.name + ": " + compensation_in_force(run) +
                  " is still in force, and this cycle knows no tool nose radius compensation: it is not run",
              "write G40 before it, in a block with a way of its own");
    lose_position(run);
    return true;
}

/// No tool nose radius compensation as long as this lives: the tool stands at the programmed point meanwhile, and the
/// element behind it brings compensation in anew.
class Uncompensated {
public:
    explicit Uncompensated(Telling& run) : run_(run), before_(run.modal.compensation) {
        if (before_ == Modal::compensation_off) return;
        const geom::Vec3 start = run.programmed_position;
        run.path->end_compensation(run);
        run.modal.compensation = Modal::compensation_off;
        arrive(run, start);
    }
    ~Uncompensated() { run_.modal.compensation = before_; }
    Uncompensated(const Uncompensated&) = delete;
    Uncompensated& operator=(const Uncompensated&) = delete;

private:
    Telling& run_;
    Modal before_;
};

/// Of this block, or of an earlier one that the control keeps.
base::Span place_of_setting(const Cycling& run, const CycleDefinition& d, CycleRole role) {
    for (const CycleSetting& s : d.settings)
        if (s.role == role) return s.where;
    const auto kept = run.cycle_store.find({d.store, role});
    return kept != run.cycle_store.end() && d.store != 0 ? kept->second.where : d.where;
}

/// Where the fault lies: a setting, an element of the contour, or the cycle as such.
base::Span place_of(const CycleDefinition& d, const cycles::Complaint& k, const TurnedContour* contour) {
    if (k.element && contour != nullptr && *k.element < contour->places.size()) return contour->places[*k.element];
    for (const CycleSetting& s : d.settings)
        if (k.role && s.role == *k.role) return s.where;
    return d.where;
}

/// False where the run ended with an alarm.
bool report_turning(Reckoning& run, const CycleDefinition& d, const cycles::Expansion& e,
                    const TurnedContour* contour) {
    for (const cycles::Complaint& k : e.complaints) {
        const base::Span where = place_of(d, k, contour);
        if (k.fatal) {
            alarm(run, k.element ? codes::contour : codes::value_range, where, d.name + ": " + k.text,
                  k.remedy.empty() && k.role ? "give it in the block of the cycle" : k.remedy);
            return false;
        }
        if (k.doubtful)
            doubt(run, codes::value_range, where, d.name + ": " + k.text, k.remedy);
        else
            assume(run, where, d.name + ": " + k.text, k.remedy);
    }
    if (!e.assumption.empty()) assume(run, d.where, d.name + ": " + std::string(e.assumption));
    if (e.simulated) return true;
    unchecked(run, codes::unsupported, d.where, d.name + " is not run: its path is not known here");
    lose_position(run);
    return true;
}

bool ends_program(const Unit& unit, std::uint32_t index) {
    const program::Statement& s = unit.statements[index];
    if (s.kind == program::StatementKind::return_) return true;
    for (std::uint32_t w = s.first; w < unit.words_end(index) && s.kind == program::StatementKind::block; ++w) {
        const program::Word& word = unit.words[w];
        if (program::code_of(word) != Code::m || !program::is_literal(word)) continue;
        const double m = unit.literal(word);
        if (m == 2 || m == 30 || m == 99) return true;
    }
    return false;
}

/// The control goes on behind a contour that stands behind the cycle.
void leave_out(Saying& run, const CycleDefinition& d, std::uint32_t self, const ContourBlocks& c) {
    if (c.first < self) return;
    const Unit& unit = run.unit();
    bool blocks = false;
    for (std::uint32_t i = self + 1; i < c.first; ++i) {
        if (ends_program(unit, i)) return;
        blocks = blocks || (unit.statements[i].flags & program::line_start) != 0;
    }
    if (blocks)
        assume(
            run, d.where,
            d.name + ": the run goes on behind the contour; the blocks between the cycle and the contour are left out",
            "write the contour directly behind the cycle");
    run.top().pc = c.last + 1;
}

void finish(Telling& run, const CycleDefinition& d, std::uint32_t self) {
    const auto blocks = find_contour(run, d, self);
    if (!blocks) return;
    if (run.top().sections.size() >= run.env.budgets.call_depth) {
        unchecked(run, codes::budget, run.here(), "contours and repeated sections are nested too deep");
        run.stopped = true;
        run.ending = Ending::budget;
        return;
    }
    flush_path(run);
    begin_bracket(run, {d.kind, {}}, d.name);
    ActiveSection section;
    section.first = blocks->first;
    section.last = blocks->last;
    section.back = run.top().pc;
    section.left = 1;
    section.finishing = run.statement;
    section.start = run.programmed_position;
    run.top().pc = section.first;
    run.top().sections.push_back(section);
}

}  // namespace

void end_finishing(Moving& run, const ActiveSection& section) {
    run.statement = section.finishing;
    run.block.clear();
    run.complained = false;
    run.modal.motion = Modal::rapid;
    straight_motion(run, section.start, true);
    if (!run.stopped) end_bracket(run);
}

void define_turning_cycle(Cycling& run, const ActiveCycle& c) {
    const CycleDefinition& d = *c.definition;
    if (d.sets_only) return keep(run, c);
    const auto self = static_cast<std::uint32_t>(run.statement - run.unit().statements.data());
    if (run.modal.plane != 18)
        return alarm(run, codes::value_range, d.where, d.name + " needs the plane of G18", "program G18 before it");
    if (refuse_compensated(run, d)) return;
    begin_motion(run);
    if (d.kind == CycleKind::lathe_finish) return finish(run, d, self);
    flush_path(run);
    cycles::TurningDemand demand;
    demand.cycle = demand_of_turning(run, c);
    std::optional<ContourBlocks> blocks;
    std::optional<TurnedContour> contour;
    if (takes_defined_contour(d.kind)) {
        blocks = find_contour(run, d, self);
        if (blocks && choose_type(run, d, *blocks, demand.cycle)) contour = turned_contour(run, d, *blocks);
        if (run.stopped || !blocks) return;
        if (!contour) {
            lose_position(run);
            return leave_out(run, d, self, *blocks);
        }
        demand.contour = contour->elements;
        if (contour->compensated || run.modal.compensation != Modal::compensation_off)
            assume(run, d.where,
                   d.name +
                       ": tool nose radius compensation does not act in this cycle, only where the contour is "
                       "finished");
    }
    std::optional<Uncompensated> off;
    if (takes_defined_contour(d.kind)) off.emplace(run);
    demand.situation = situation_of(run);
    cycles::Expansion e = cycles::expand_turning(demand);
    if (!doubt_infeeds(run, d.name, demand.cycle, e, [&](CycleRole r) { return place_of_setting(run, d, r); })) {
        lose_position(run);
        if (blocks) leave_out(run, d, self, *blocks);
        return;
    }
    if (!report_turning(run, d, e, contour ? &*contour : nullptr)) return;
    begin_bracket(run, demand.cycle, d.name);
    emit_turning_steps(run, e.steps);
    if (run.stopped) return;
    end_bracket(run);
    if (blocks) leave_out(run, d, self, *blocks);
}

}  // namespace obrys::interp
