/// Cycles that the words of motion blocks call (G81 X Y Z R …) until they are cancelled.
/// Source: LinuxCNC, G-Codes, "Canned cycles"; Fanuc, "Canned cycle for drilling".

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/codes.hpp"
#include "base/text.hpp"
#include "base/whole.hpp"
#include "cycles/expand/expand.hpp"
#include "interp/cycles/cycles.hpp"
#include "interp/moves/small_infeed.hpp"

namespace obrys::interp {

namespace codes = base::codes;
using cl::CycleRole;

namespace {

constexpr double most_holes = 100'000;

const program::CannedCycle& cycle_of(const Reckoning& run) {
    return run.traits->canned[static_cast<std::size_t>(run.modal.motion_number)];
}

/// Another cycle begins; within a series what was said stays where the control keeps it (Traits::canned_words_stay).
void begin_cycle(Moving& run, const program::CannedCycle& c) {
    CannedState& s = run.canned;
    CannedState next;
    next.active = true;
    next.cycle = run.modal.motion_number;
    next.initial_level = s.initial_level;
    next.last_dwell = s.last_dwell;
    if (s.active && run.traits->canned_words_stay) {
        next.retract = s.retract, next.has_retract = s.has_retract;
        next.bottom = s.bottom, next.has_bottom = s.has_bottom;
        next.bottom_from_retract = s.bottom_from_retract;
        const auto& before = run.traits->canned[static_cast<std::size_t>(s.cycle)].words;
        for (std::size_t i = 0; i < c.words.size() && i < next.values.size(); ++i)
            for (std::size_t k = 0; k < before.size() && k < s.values.size(); ++k)
                if (before[k].code == c.words[i].code && before[k].length == c.words[i].length && s.given[k]) {
                    next.values[i] = s.values[k];
                    next.given[i] = true;
                    next.places[i] = s.places[k];
                }
    }
    s = next;
}

bool taps(cl::CycleKind k) { return k == cl::CycleKind::canned_tap_floating || k == cl::CycleKind::canned_tap_rigid; }

/// G91, and the control makes positions of what it says: R from the level of the series, Z from R.
bool counts_on(const Reckoning& run) { return run.traits->canned_positions_stay && !run.modal.absolute; }

/// R and the coordinate of the tool axis.
void take_heights(Moving& run, const PlaneAxes& a) {
    CannedState& s = run.canned;
    const bool depth = run.block.has(axis_code(a.w));
    if (run.block.has(Code::radius)) {
        s.retract = run.block.get(Code::radius) * length_unit(run.modal) + (counts_on(run) ? s.initial_level : 0);
        s.has_retract = true;
        if (counts_on(run) && !depth && s.has_bottom && s.bottom_from_retract)
            assume(run, run.here(),
                   "R is written anew and the depth is not: what it said before from R is taken to stay where it is",
                   "write the depth beside R");
    }
    if (!depth) return;
    s.bottom = run.block.get(axis_code(a.w)) * length_factor(run, a.w, !run.modal.absolute);
    if (counts_on(run)) s.bottom += s.retract;
    s.has_bottom = true;
    s.bottom_from_retract = !run.modal.absolute;
}

void take_words(Cycling& run, const program::CannedCycle& c, const PlaneAxes& a) {
    CannedState& s = run.canned;
    const double unit = length_unit(run.modal);
    if (!s.active || s.cycle != run.modal.motion_number) {
        if (!s.active) s.initial_level = coordinate(run.programmed_position, a.w);
        begin_cycle(run, c);
    }
    take_heights(run, a);
    for (std::size_t i = 0; i < c.words.size() && i < s.values.size(); ++i) {
        const program::CannedWord& w = c.words[i];
        if (run.block.has(w.code)) {
            s.values[i] = run.block.get(w.code) * (w.length ? unit : 1) * w.factor;
            if (w.sign_ignored) s.values[i] = std::abs(s.values[i]);
            s.given[i] = true;
            s.places[i] = place_of_word(run, w.code);
            if (w.role == CycleRole::dwell_bottom || w.role == CycleRole::dwell) s.last_dwell = s.values[i];
        } else if (run.traits->tap_keeps_dwell && taps(c.kind) && w.role == CycleRole::dwell && s.last_dwell) {
            s.values[i] = *s.last_dwell;
            s.given[i] = true;
        }
    }
}

std::optional<double> repeats(Moving& run) {
    const double n = run.block.has(Code::l) ? run.block.get(Code::l) : 1;
    if (n >= 0 && n <= most_holes && n == std::floor(n)) return n;
    if (std::isnan(n)) {
        unchecked(run, codes::unknown_value, run.here(),
                  "how many holes these are depends on a value that is not known: none is made");
        lose_position(run);
        return std::nullopt;
    }
    const base::Span word = place_of_word(run, Code::l);
    const std::string_view text = base::trim(run.env.sources.text(word));
    const std::string letter = word == run.here() || text.empty() ? "L" : std::string(text.substr(0, 1));
    alarm(run, codes::value_range, word, base::to_upper(letter) + " must be a whole number of repetitions");
    return std::nullopt;
}

/// Between which heights the hole lies.
void add_heights(cycles::Demand& d, const Moving& run, const program::CannedCycle& c, double initial) {
    const CannedState& s = run.canned;
    const bool on = !run.modal.absolute && !run.traits->canned_positions_stay;  // what was written counts as it is read
    const double retract = s.retract + (on ? initial : 0);
    if (!run.traits->hole_depth_from_top) {
        if (s.has_retract) d.values.push_back({CycleRole::retract_plane, retract});
        if (s.has_bottom) d.values.push_back({CycleRole::bottom, on ? retract + s.bottom : s.bottom});
        return;
    }
    if (!s.has_retract) return;
    double clearance = std::numeric_limits<double>::quiet_NaN();
    for (std::size_t i = 0; i < c.words.size() && i < s.values.size(); ++i)
        if (c.words[i].role == CycleRole::clearance && s.given[i]) clearance = s.values[i];
    d.values.push_back({CycleRole::surface, retract});
    d.values.push_back({CycleRole::retract_plane, retract + clearance});
    if (s.has_bottom) d.values.push_back({CycleRole::bottom, retract - std::abs(s.bottom)});
}

bool has_word(const program::CannedCycle& c, const CannedState& s, Code code) {
    for (std::size_t i = 0; i < c.words.size() && i < s.given.size(); ++i)
        if (c.words[i].code == code && s.given[i]) return true;
    return false;
}

CycleRole role_of(const program::CannedCycle& c, const CannedState& s, std::size_t word) {
    const program::CannedWord& w = c.words[word];
    const bool beside = w.beside != nullptr && has_word(c, s, w.beside->word) && !has_word(c, s, w.beside->unless);
    return beside ? w.beside->role : w.role;
}

/// Where it was said, which may be blocks ago.
base::Span place_of_role(const Moving& run, const program::CannedCycle& c, CycleRole role) {
    for (std::size_t i = 0; i < c.words.size() && i < run.canned.given.size(); ++i)
        if (run.canned.given[i] && role_of(c, run.canned, i) == role) return run.canned.places[i];
    return run.here();
}

cycles::Demand demand_at(const Moving& run, const program::CannedCycle& c, const geom::Vec3& target, double initial) {
    const CannedState& s = run.canned;
    cycles::Demand d;
    d.kind = c.kind;
    d.values.assign(c.fixed.begin(), c.fixed.end());
    for (cl::CycleValue& v : d.values)
        if (v.role == CycleRole::rise_first) v.value = 2;  // begin_series does that
    const bool on = !run.modal.absolute && !run.traits->canned_positions_stay;
    const double retract = s.retract + (on ? initial : 0);
    d.values.push_back({CycleRole::target_u, target.x});
    d.values.push_back({CycleRole::target_v, target.y});
    add_heights(d, run, c, initial);
    if (!run.modal.clear_to_retract_plane) {
        const bool raised = run.traits->hole_ends_at_least_at_retract_plane && s.has_retract;
        d.values.push_back({CycleRole::return_level, raised ? std::max(initial, retract) : initial});
    }
    for (std::size_t i = 0; i < c.words.size() && i < s.values.size(); ++i)
        if (s.given[i] && (c.words[i].role != CycleRole::clearance || !run.traits->hole_depth_from_top))
            d.values.push_back({role_of(c, s, i), s.values[i]});
    // A feed per turn is the thread where none is written.
    const bool threaded = std::any_of(d.values.begin(), d.values.end(),
                                      [](const cl::CycleValue& v) { return v.role == CycleRole::pitch; });
    if (c.kind == cl::CycleKind::canned_tap_rigid && !threaded && run.modal.feed_mode == cl::FeedMode::per_rev &&
        run.feed_valid)
        d.values.push_back({CycleRole::pitch, run.feed});
    if (c.adds_in_units) d.values.push_back({CycleRole::length_unit, length_unit(run.modal)});
    if (c.turns_axes && run.modal.plane != 17)
        d.values.push_back({CycleRole::turned_axes, run.modal.plane == 18 ? 1.0 : 2.0});
    return d;
}

/// What the stream says of the cycle: its place says where the hole is.
cycles::Demand told(cycles::Demand d) {
    std::erase_if(d.values, [](const cl::CycleValue& v) {
        return v.role == CycleRole::target_u || v.role == CycleRole::target_v || v.role == CycleRole::rise_first ||
               v.role == CycleRole::kept;
    });
    return d;
}

void exact_path(Telling& run) {
    if (run.modal.path_mode != Modal::path_exact) hear(run, heard::Joining{});
}

/// The move to the retract plane where the series began below it: a block of its own, which comes before the control
/// slows down, and is made also where the tool is there already. From above it goes down.
void rise(Telling& run, double retract) {
    const PlaneAxes a = plane_axes(run.modal.plane);
    geom::Vec3 at = into_plane(run.programmed_position, a);
    at.z = retract;
    emit_step(run, cl::Linear{at, {0, 0, 1}, true});
}

/// What is wrong with the first hole is said before anything moves.
bool begin_series(Moving& run, const program::CannedCycle& c, const cycles::Demand& demand, double began_at) {
    if (demand.get(CycleRole::rise_first, 0) != 0) {
        cycles::Expansion e = cycles::expand(demand, situation_of(run));
        if (!doubt_infeeds(run, c.name, demand, e, [&](CycleRole r) { return place_of_role(run, c, r); })) {
            lose_position(run);
            return false;
        }
        if (std::any_of(e.complaints.begin(), e.complaints.end(), [](const auto& k) { return k.fatal; }))
            return report_expansion(run, c.name, e);
        const double retract = demand.get(CycleRole::retract_plane);
        if (began_at < retract) rise(run, retract);
    }
    exact_path(run);
    return true;
}

void run_holes(Moving& run, const program::CannedCycle& c, const PlaneAxes& a) {
    const auto count = repeats(run);
    if (!count) return;
    if (c.turns_axes && run.modal.plane != 17)
        assume(run, run.here(),
               std::string(c.name) +
                   " outside G17: the control feeds to a place whose coordinates belong to other axes "
                   "(a fault of the control), and so it is run here");
    const geom::Vec3 start = run.programmed_position;
    geom::Vec3 target = programmed_target(run);
    const geom::Vec3 step = target - start;
    const double initial = run.canned.initial_level;
    const bool polar = run.block.has(Code::polar_radius) || run.block.has(Code::polar_angle);
    const auto passes = base::clipped<std::uint64_t>(*count, 1, static_cast<std::uint64_t>(most_holes));
    std::uint64_t pass = 0;
    for (double i = 0; i < *count && !run.stopped; ++i) {
        ++pass;
        if (i > 0 && polar) target = programmed_target(run);  // turns and grows from hole to hole
        const geom::Vec3 at = run.modal.absolute || polar ? target : start + (i + 1) * step;
        const cycles::Demand demand = demand_at(run, c, into_plane(at, a), initial);
        if (i == 0 && !begin_series(run, c, demand, initial)) return;
        cycles::Expansion e = cycles::expand(demand, situation_of(run));
        if (!doubt_infeeds(run, c.name, demand, e, [&](CycleRole r) { return place_of_role(run, c, r); }))
            return lose_position(run);
        if (!report_expansion(run, c.name, e)) return;
        emit_hole(run, c.name, told(demand), e, {cl::CycleCall::modal, pass, passes});
        if (!e.simulated) return;                     // nor is any hole behind it: where the tool stands is not known
        if (c.turns_axes && run.modal.plane != 17) {  // the control takes itself to be where it should be
            const geom::Vec3 there = into_plane(at, a);
            const double level = demand.get(CycleRole::return_level, demand.get(CycleRole::retract_plane));
            arrive(run, out_of_plane({there.x, there.y, level}, a));
        }
        if (over_budget(run, false)) return;
    }
}

/// Heights of a back bore in force, said in G91: its R and Z count from elsewhere than those of other cycles.
bool refuses_heights(Moving& run, const program::CannedCycle& c, const PlaneAxes& a) {
    if (c.kind != cl::CycleKind::canned_back_bore || !counts_on(run)) return false;
    if (!run.block.has(axis_code(a.w)) && !run.block.has(Code::e)) return false;
    unchecked(run, codes::unsupported, run.here(),
              std::string(c.name) + " is not run: R or Z of it in G91, where they count from other places",
              "write R and Z in G90");
    lose_position(run);
    return true;
}

}  // namespace

bool canned_motion(Cycling& run) {
    const PlaneAxes a = plane_axes(run.modal.plane);
    const program::CannedCycle& c = cycle_of(run);
    if (run.modal.compensation != Modal::compensation_off && run.traits->compensation_forbids_canned) {
        alarm(run, codes::compensation, run.here(),
              "Cannot use canned cycles with cutter compensation on: " + std::string(c.name));
        return false;
    }
    flush_path(run);
    if (refuses_heights(run, c, a)) return true;
    take_words(run, c, a);
    run_holes(run, c, a);
    if (run.stopped) return false;
    if (run.modal.path_mode != Modal::path_exact) hear(run, joining_in_force(run));
    return true;
}

}  // namespace obrys::interp
