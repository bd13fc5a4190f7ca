/// What a control refuses to begin though each word by itself is good: the run ends where it would have to guess.
/// Only the modal state shows these; what a block shows by itself the reader refuses.
/// Source: LinuxCNC 2.9, its stand-alone interpreter asked for each of them (tests/linuxcnc/bad_programs.py).

#include <cmath>

#include "base/codes.hpp"
#include "interp/calls/calls.hpp"

namespace obrys::interp {

namespace codes = base::codes;

namespace {

constexpr std::uint64_t rotary_axes = bit(Code::a) | bit(Code::b) | bit(Code::c);

constexpr std::uint64_t parallel_axes = bit(Code::u) | bit(Code::v) | bit(Code::w);

/// The word of the block for which `is` holds; the block where it has none such.
template <class Is>
base::Span word_that(const Reckoning& run, Is is) {
    const Unit& unit = run.unit();
    const auto index = static_cast<std::uint32_t>(run.statement - unit.statements.data());
    for (std::uint32_t i = run.statement->first; i < unit.words_end(index); ++i)
        if (is(unit.words[i])) return unit.span(*run.statement, unit.words[i]);
    return run.here();
}

base::Span word_of(const Reckoning& run, Code code) {
    return word_that(run, [code](const program::Word& w) { return program::code_of(w) == code; });
}

base::Span word_of(const Reckoning& run, Modal m) {
    return word_that(
        run, [m](const program::Word& w) { return program::code_of(w) == Code::modal && program::modal_of(w) == m; });
}

bool compensates(const Reckoning& run) {
    return run.traits->compensation_holds_move && run.modal.compensation != Modal::compensation_off;
}

void refuse_under_compensation(Saying& run, const base::Span& where, std::string what) {
    alarm(run, codes::compensation, where, std::move(what) + " while radius compensation is on", "write G40 before it");
}

bool changes_plane(const Reckoning& run, Modal m) {
    const int plane = m == Modal::plane_xy ? 17 : m == Modal::plane_zx ? 18 : m == Modal::plane_yz ? 19 : 0;
    return plane != 0 && plane != run.modal.plane;
}

/// G10 L2 and L20 of the zero offset that is in force.
bool writes_active_datum(const Moving& run) {
    const double l = run.block.has(Code::l) ? run.block.peek(Code::l) : 0;
    const double p = run.block.has(Code::p) ? run.block.peek(Code::p) : 0;
    const std::uint32_t active = place_of_datum(run.modal.datum);
    return (l == 2 || l == 20) && (p == 0 || p == active);
}

/// What may not change under radius compensation; empty: `m` may.
std::string change_of(const Moving& run, Modal m) {
    if (changes_plane(run, m)) return "the plane changes";
    switch (m) {
        case Modal::compensation_left:
        case Modal::compensation_right:
        case Modal::compensation_left_by:
        case Modal::compensation_right_by: return "radius compensation is switched on";
        case Modal::datum: return "the coordinate system is selected";
        case Modal::tool_length:
        case Modal::tool_length_by_axes:
        case Modal::tool_length_added:
        case Modal::tool_length_off: return "the tool offset changes";
        case Modal::position_becomes:
        case Modal::local_shift: return "the axes are shifted";
        case Modal::path_exact:
        case Modal::path_stop:
        case Modal::path_blend: return "the path mode changes";
        case Modal::retract_initial:
        case Modal::retract_clearance: return "the retract mode of cycles changes";
        case Modal::home: return "the axes go to a stored position";
        case Modal::probe: return "the axes probe";
        case Modal::set_data:
            return writes_active_datum(run) ? "the coordinate system in force is written" : std::string();
        default: return {};
    }
}

bool on(Modal m) {
    return m == Modal::compensation_left || m == Modal::compensation_right || m == Modal::compensation_left_by ||
           m == Modal::compensation_right_by;
}

// --- the block

/// Axes that the named machine has not; LinuxCNC's stand-alone interpreter has X Y Z A B C.
void refuse_axes(Moving& run) {
    const shop::Machine& machine = run.env.machine;
    const bool named = !machine.axes.empty() && !machine.more_axes;
    const std::uint64_t all = linear_axes | rotary_axes | parallel_axes;
    const std::uint64_t known = named ? run.known_axes : run.env.stand_alone ? linear_axes | rotary_axes : all;
    const std::uint64_t foreign = run.block.present & all & ~known;
    if (foreign == 0) return;
    const int k = std::countr_zero(foreign) - std::countr_zero(bit(Code::x));
    alarm(run, codes::unknown_word, word_of(run, axis_code(k)),
          "the machine " + (named ? machine.name + " " : std::string()) + "has no axis " + "XYZABCUVW"[k],
          "name the right machine in the job, or add the axis to its file");
}

/// Overrides, outputs and waiting stop the control's reading ahead, which compensation needs.
void refuse_functions(Moving& run) {
    for (const int m : run.block.m)
        if ((m >= 48 && m <= 53) || (m >= 62 && m <= 68))
            return refuse_under_compensation(run, word_of(run, Code::m), "M" + std::to_string(m) + " acts");
}

void refuse_tool(Moving& run) {
    const bool by_t = run.block.has(Code::tool) && !run.block.tool_named;
    const double t = by_t ? run.block.peek(Code::tool) : 0;
    if (compensates(run) && run.block.has_m(6))
        return refuse_under_compensation(run, word_of(run, Code::m), "the tool is changed");
    if (!(t > 0) || run.tools.empty()) return;
    for (const shop::Tool& tool : run.tools)
        if (tool.number == t) return;
    alarm(run, codes::tool_missing, word_of(run, Code::tool),
          "T" + printed(Value::real(t)) + " is not in the tool table", "add the tool to the table");
}

void refuse_machine_move(Moving& run) {
    const base::Span where = word_of(run, run.block.suppress);
    if (compensates(run)) return refuse_under_compensation(run, where, "a block moves in machine coordinates");
    if (run.modal.motion != Modal::rapid && run.modal.motion != Modal::linear && run.modal.motion != Modal::canned_off)
        return alarm(run, codes::value_range, where, "only G0 and G1 move in machine coordinates",
                     "write G0 or G1 in the block");
    if (!run.modal.absolute)
        alarm(run, codes::value_range, where, "machine coordinates cannot be incremental: G91 is in force",
              "write G90 before the block");
}

bool spindle_turns(const Moving& run) {
    return run.block.has_m(3) || run.block.has_m(4) || (run.spindle.direction != 0 && !run.block.has_m(5));
}

void refuse_still_spindle(Moving& run, Modal m, std::string_view what) {
    if (spindle_turns(run)) return;
    alarm(run, codes::spindle_stopped, word_of(run, m), std::string(what) + " needs a turning spindle",
          "write M3 or M4 with S before it");
}

/// F of the block or in force; in inverse time mode every block has its own.
bool has_feed(const Moving& run) {
    const bool dwells = run.block.special == Modal::dwell && run.traits->dwell_in_feed_words;
    if (run.block.has(Code::feed) && !dwells) return run.block.peek(Code::feed) != 0;
    return (run.feed_valid || run.feed_unknown) && run.modal.feed_mode != cl::FeedMode::inverse_time;
}

void refuse_missing_feed(Moving& run, std::string_view what, Modal m) {
    if (!run.traits->needs_feed || has_feed(run)) return;
    const bool inverse = run.modal.feed_mode == cl::FeedMode::inverse_time, zero = run.block.has(Code::feed);
    alarm(run, codes::feed_missing, zero ? word_of(run, Code::feed) : word_of(run, m),
          std::string(what) + (zero      ? " cannot be run with F0"
                               : inverse ? " in inverse time mode (G93) needs F in its block"
                                         : " needs a feed: none is in force"),
          zero ? "" : "write F before it or in its block");
}

void refuse_probe(Moving& run) {
    refuse_missing_feed(run, "probing", Modal::probe);
    // Away from the workpiece the probe may have let go already; behind an earlier probing it stands somewhere else.
    if (run.modal.motion_number >= 4 || run.probed) return;
    if (run.stopped || (run.block.present & (rotary_axes | parallel_axes)) != 0) return;
    for (int k = 0; k < 3; ++k) {
        const Code code = axis_code(k);
        if (!run.block.has(code)) continue;
        const bool incremental = is_incremental(run, run.block.ref(code));
        const double v = run.block.peek(code) * length_factor(run, k, incremental);
        const double way = incremental ? v : v - coordinate(run.programmed_position, k);
        if (!(std::abs(way) < 1e-9)) return;  // also where it stands is not known
    }
    alarm(run, codes::value_range, word_of(run, Modal::probe),
          "the probe stands at the end point of this block already");
}

void refuse_dwell(Moving& run, const program::CannedCycle& c) {
    const bool goes_on = run.canned.active && run.canned.cycle == run.modal.motion_number;
    for (std::size_t i = 0; i < c.words.size() && i < run.canned.given.size(); ++i) {
        const program::CannedWord& w = c.words[i];
        if (w.role != cl::CycleRole::dwell_bottom) continue;
        const bool given = run.block.has(w.code) ? !(run.block.peek(w.code) < 0) : goes_on && run.canned.given[i];
        if (!given)
            alarm(run, codes::value_range, run.block.has(w.code) ? word_of(run, w.code) : word_of(run, Modal::canned),
                  std::string(c.name) + " needs P, the dwell at the bottom in seconds, 0 or more");
    }
}

void refuse_canned(Moving& run) {
    const program::CannedCycle& c = run.traits->canned[static_cast<std::size_t>(run.modal.motion_number)];
    const std::string name(c.name);
    for (int k = 3; k < 9; ++k)
        if (run.block.has(axis_code(k)))
            return alarm(run, codes::value_range, word_of(run, axis_code(k)),
                         axis_name(k) + " cannot stand in " + name + ": a cycle moves X, Y and Z",
                         "position it in a block before");
    if (run.block.has(Code::l) && run.block.peek(Code::l) == 0)
        return alarm(run, codes::value_range, word_of(run, Code::l), name + " cannot be repeated zero times");
    refuse_dwell(run, c);
    if (run.stopped) return;
    if (run.modal.feed_mode == cl::FeedMode::inverse_time)
        return alarm(run, codes::feed_missing, word_of(run, Modal::canned),
                     name + " cannot be run in inverse time mode", "write G94 before it");
    refuse_missing_feed(run, name, Modal::canned);
}

/// R beside I, J, K, and the one of them that is normal to the plane.
void refuse_arc(Moving& run, Modal m) {
    const std::string name = m == Modal::arc_cw ? "G2" : "G3";
    const int normal = plane_axes(run.modal.plane).w;
    for (int k = 0; k < 3; ++k) {
        const Code code = k == 0 ? Code::i : k == 1 ? Code::j : Code::k;
        if (!run.block.has(code)) continue;
        const std::string letter(1, "IJK"[k]);
        if (run.block.has(Code::radius))
            return alarm(run, codes::arc_radius, word_of(run, code),
                         name + " has both R and " + letter + ": the radius and the centre", "write one of them");
        if (k == normal)
            return alarm(
                run, codes::arc_radius, word_of(run, code),
                letter + " is normal to the plane of G" + std::to_string(run.modal.plane) + ": no arc there has it");
    }
    refuse_missing_feed(run, name, m);
}

void refuse_motion(Moving& run) {
    const Modal m = run.modal.motion;
    const bool coordinates = (run.block.present & (linear_axes | rotary_axes | parallel_axes)) != 0;
    if (run.block.special == Modal::rigid_tap) return refuse_still_spindle(run, Modal::rigid_tap, "G33.1");
    constexpr std::uint64_t centre = bit(Code::i) | bit(Code::j) | bit(Code::k) | bit(Code::radius);
    const bool arc = m == Modal::arc_cw || m == Modal::arc_ccw;
    if (arc && run.block.special == Modal::linear && (coordinates || (run.block.present & centre) != 0))
        return refuse_arc(run, m);
    if (!coordinates || run.block.special != Modal::linear) return;
    if (m == Modal::thread) return refuse_still_spindle(run, m, "G33");
    if (m == Modal::probe) return refuse_probe(run);
    if (m == Modal::canned) return refuse_canned(run);
    if (m == Modal::linear) refuse_missing_feed(run, "G1", m);
}

}  // namespace

void refuse_modal(Moving& run, const program::Word& w) {
    const Modal m = program::modal_of(w);
    const auto where = [&] { return run.unit().span(*run.statement, w); };
    if (m == Modal::restore_modal && !run.top().saved_modes)
        return alarm(run, codes::value_range, where(), "there is no saved state to bring back",
                     "save it with M70 or M73 before");
    if (!run.traits->compensation_holds_move) return;
    if (on(m) && run.modal.plane == 19)
        return alarm(run, codes::compensation, where(), "radius compensation works in G17 and G18, not in G19");
    if (!compensates(run)) return;
    if (std::string what = change_of(run, m); !what.empty()) refuse_under_compensation(run, where(), std::move(what));
}

void refuse_block(Moving& run) {
    const BlockWords& b = run.block;
    if (run.capture != nullptr) return refuse_letters(run);  // a contour is only read
    refuse_axes(run);
    if (!run.stopped && (b.has(Code::tool) || run.block.has_m(6))) refuse_tool(run);
    if (!run.stopped && !b.m.empty() && compensates(run)) refuse_functions(run);
    if (!run.stopped && !b.m.empty()) refuse_signals(run);
    if (!run.stopped && b.suppress != Modal::linear) refuse_machine_move(run);
    if (!run.stopped) refuse_letters(run);
    if (!run.stopped) refuse_motion(run);
}

void say_missing_beginning(Saying& run) {
    const Unit& unit = run.unit();
    const std::uint32_t at = unit.statements.front().begin;
    unchecked(run, codes::unclosed, {unit.file, at, at}, unit.unbegun, "");
}

void refuse_end(Saying& run) {
    const Unit& unit = run.unit();
    const base::Span where =
        unit.statements.empty() ? base::Span{unit.file, unit.begin, unit.begin} : unit.span(unit.statements.back());
    if (run.traits->text_may_end)
        return unchecked(run, codes::unclosed, where, unit.unended, "add M30; in a subprogram M17 or RET");
    alarm(run, codes::unclosed, where, unit.unended,
          unit.startable ? "add M30, or M99 where it is a subprogram" : "add M2");
}

}  // namespace obrys::interp
