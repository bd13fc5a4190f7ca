#pragma once
/// What controls truly do differently when a block is run: one small table that travels with the program.

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "cl/cycle.hpp"
#include "program/expr.hpp"
#include "program/trait_parts.hpp"
#include "program/word.hpp"

namespace obrys::program {

struct Traits {
    GuessedMachine guessed_machine = GuessedMachine::mill;
    /// An address that a block has twice.
    Repeated repeated_words = Repeated::stops;
    /// Two words of one group (G0 G1).
    Repeated repeated_groups = Repeated::stops;
    /// Holds in every comparison.
    Equality equality{};
    /// Numbers of later banks follow those of the first: QL0 is the number behind the last Q.
    std::array<ParameterBank, 3> banks{ParameterBank{"R", 1000}, {}, {}};
    NamedVariables named_variables = NamedVariables::plain;
    /// A jump to a block number (GOTOF N100) is allowed.
    bool jump_to_block_number = true;
    /// M2 and M30 end the whole run, also in a called program; else they return from it.
    bool end_stops_all = false;
    /// A text that ends without its end (Unit::unended) is run up to there, and said, of called programs, too; else it
    /// is an alarm of the main program.
    bool text_may_end = false;
    /// The last block of the text ends the program as M30 does (END PGM).
    bool text_end_ends_program = false;
    /// With end_stops_all: that is how a program may end; else it is said as a fault of the called program.
    bool may_end_anywhere = false;
    /// A unit of length (inch, mm) holds for its program alone and comes back behind a call.
    bool unit_per_program = false;
    /// Contour elements, ahead and behind, that radius compensation holds its path against even where it does not look
    /// ahead; 0: neighbours alone.
    std::uint32_t compensation_window = 0;
    /// Parameters that hold text: these letters and a number ("QS5"); empty: there are none.
    std::string_view text_letters{};
    /// How deep calls of labels may be nested within one program.
    std::uint32_t label_depth = 0;
    /// Each program begins in absolute coordinates, and leaves its caller's dimensions and motion as they were.
    bool dimensions_per_program = false;
    /// An arc without a radius is about the pole, and its incremental polar angle says how far it sweeps.
    bool arcs_about_pole = false;
    /// mm/min of a feed of 1 in a program in inches.
    double inch_feed = 25.4;
    /// Polar coordinates and arcs about the pole are an alarm before the program has set one; else it is the zero
    /// point.
    bool needs_pole = false;
    /// A polar coordinate that a block leaves out, or gives incrementally, is that of the position; else the one
    /// programmed last.
    bool polar_from_position = false;
    DatumNames datum{};
    Rapids rapids{};
    /// Machine coordinates in a program are those of the spindle's gauge point; else of the tip.
    bool machine_words_are_gauge_point = false;
    /// Assignments of a block take effect together, behind the last expression of the block: `#1=2 X#1` has the old #1.
    bool assigns_together = false;
    /// Named variables come into being when they are assigned: local ones, and global ones where the name begins with
    /// `_`. Reading one that nobody has assigned is an alarm.
    bool variables_by_assignment = false;
    /// Numbered parameters from 1 to this are every program's own: those of a called one begin with the arguments of
    /// the call (argument 0 is parameter 1) and 0 where there is none. 0: arguments go to declared parameters.
    std::uint32_t argument_parameters = 0;
    /// There is no parameter 0 that could be written.
    bool parameters_begin_at_one = false;
    /// Programs are called by number, O100; else by a text that names them.
    bool programs_by_number = false;
    /// Of modal calls one is in force at a time here, and the control nests them; else a new one replaces the last.
    bool modal_calls_nest = false;
    /// The word for a jump to the program's beginning (M99 of the main program) repeats it without end: one pass is
    /// run. Empty: such a jump is an ordinary one.
    std::string_view repeats_program{};
    /// Arc tangent and arc sine that would be negative are a full turn more, by this setting of the control; empty:
    /// they are -180 … 180 and -90 … 90 degrees.
    std::string_view angles_from_zero{};
    /// Parameters hold 0 until they are set, and the control says so itself: reading one is no assumption.
    bool parameters_begin_at_zero = false;
    /// A parameter that nobody has set is empty, and #0 always is: it counts as 0, but EQ and NE tell it from 0, a word
    /// with it alone is left out, and assigning it empties the other (Macro B: "vacant").
    bool empty_parameters = false;
    /// Not known until the job gives them or the program sets them.
    std::span<const KeptParameters> kept{};
    /// Numbers between those of parameters that the control does not have. 0: there are none.
    std::uint32_t absent_first = 0, absent_last = 0;
    std::span<const LiveParameters> live{};  ///< by rising numbers
    OffsetParameters offsets{};
    /// M5 and M9 act before the block's motion; else behind it.
    bool stops_before_motion = false;
    /// What holds from the end of the block that says it, behind its motion.
    std::span<const Modal> modes_behind_motion{};
    /// M6 changes the tool on every machine; else on mills alone, and T does so on lathes.
    bool changes_on_m6 = false;
    /// What T names besides the tool is the number of its offset, by habit the tool's own; else D names an edge.
    bool edge_is_offset_number = false;
    /// F and S beside the word of a dwell are its seconds and its revolutions; else they are feed and speed.
    bool dwell_in_feed_words = true;
    /// A tool change stops the spindle whatever the machine, also where the tool is in the spindle already.
    bool tool_change_stops_spindle = false;
    /// A tool definition says what the tool is and sets nothing on the control; else it writes the tool table.
    bool definitions_describe = false;
    /// "T 5.1" is index 1 of tool 5, another length or radius of it: the list has it as edge 2.
    bool indexed_tools = false;
    /// G94 and G95 end constant cutting speed (G96), of whose group they are.
    bool feed_mode_ends_surface_speed = true;
    /// M functions that the control itself knows and that do nothing to the path.
    std::span<const std::int16_t> own_functions{};
    /// Of those the ones that go to the machine as they stand (gears, clamps, coolant through the tool).
    std::span<const std::int16_t> passed_functions{};
    /// A feed per tooth (FZ) holds under feed per revolution alone, and stays for the tools that follow until the next
    /// F; else it is a feed per revolution of the tool that is in the spindle.
    bool tooth_feed_stays = false;
    /// M functions that exchange pallets: with a stop of the program, and with its end; 0: none.
    std::int16_t pallet_stop = 0, pallet_end = 0;
    /// The M function behind whose end the program may stay where it is, by the control's settings; 0: none.
    std::int16_t end_that_stays = 0;
    std::span<const SpindleStop> spindle_stops{};
    std::span<const FunctionLetters> function_letters{};  ///< of the control's own M functions
    /// Letters that an M function of the machine builder may take; empty: none, M functions stand alone.
    std::string_view builders_letters{};
    /// Radius compensation holds one move back and refuses what it cannot join (path::Method::held_move).
    bool compensation_holds_move = false;
    /// Radius compensation keeps its side and its plane until it is switched off: another one is an alarm.
    bool compensation_keeps_side = false;
    /// The call of a program switches radius compensation off.
    bool calls_end_compensation = false;
    /// Feed holds at the tool's centre until a word asks for it at the cutting edge (M109, M110).
    bool feed_at_tool_first = false;
    /// The remainder of a division is never negative.
    bool modulo_is_positive = false;
    /// At the start X words are radii and the plane is that of X and Y, whatever the machine; else as its file says.
    bool radius_at_start = false;
    /// A modal call is made, too, behind a block without motion that has F or S, or G0 or G1, while G0 or G1 is in
    /// force.
    bool modal_call_without_motion = false;
    /// A chamfer or rounding where the next element goes straight on is none, and no fault.
    bool corner_may_be_tangential = false;
    /// A chamfer or rounding without a feed of its own is run at the feed that is in force where it stands; else at
    /// that of the element behind it.
    bool corner_keeps_feed = false;
    IdleBlocks compensation_idle_blocks{};
    /// Says whether outer corners are arcs about the corner, as they are run here, or go out to the crossing of the
    /// parallels; empty: they are arcs, or as the program says.
    std::string_view outer_corner_setting{};
    /// Radius compensation is made in the plane of G17 … G19 whatever frames turn, unless the program says otherwise
    /// (Modal::compensation_in_frame); else in the plane as frames turn it.
    bool compensates_in_fixed_plane = false;
    /// The plane may not change while radius compensation is on: the control's alarm; empty: it may.
    std::string_view compensation_holds_plane{};
    /// Exponents in texts are written EX ("1.5EX2"), and E alone is none.
    bool exponent_is_ex = false;
    /// DIAMON and DIAMOF say in a program whether X words are diameters.
    bool has_diameter_words = false;
    /// A run begins with diameters, the plane of X and Z and feed per revolution, whatever the machine's file says.
    bool begins_as_lathe = false;
    /// A centre of rotation or scaling of which the block names one axis: that the other is where the tool stands is no
    /// more than likely.
    bool assumes_rest_of_centre = false;
    /// The motion in force before the program has said one is rapid; else at feed.
    bool rapid_at_start = false;
    /// Coordinates while G2 or G3 is in force, without centre and radius, are a straight move at feed: by this setting
    /// of the control; empty: they are an alarm.
    std::string_view line_without_centre{};
    /// G64 without a tolerance lets the path be left as far as its speed needs.
    bool blends_without_limit = false;
    /// An arc by its radius to where it starts is no move; else an alarm.
    bool radius_to_start_stays = false;
    /// R in a block of a straight move makes it an arc in the last sense of rotation; else it belongs to other words.
    bool radius_makes_arc = true;
    /// What the words of hole cycles have said holds for another cycle of the series, too, until it is cancelled.
    bool canned_words_stay = false;
    /// R and Z of a hole cycle are positions from the block on that says them: G90 and G91 of later blocks move them
    /// no more. Else what was written is read anew in every block, as G90 or G91 then has it.
    bool canned_positions_stay = false;
    /// R of a hole cycle is the top of the hole and the coordinate of the tool axis its depth, of either sign; the
    /// retract plane lies by the clearance above R. Else R is the retract plane and the coordinate the bottom.
    bool hole_depth_from_top = false;
    /// Of I, J and K the one across the plane of an arc is the lead of its helix; else no arc has it.
    bool helix_lead_across = false;
    /// Setting the position (G92) in G91 adds to the coordinates; else they become what the block says.
    bool position_adds_in_increments = false;
    /// A break, a continue and the passes left of a repeat are remembered until the end of a loop asks for them, which
    /// may be another loop (interp/calls/loop_marks.cpp).
    bool loops_remember = false;
    /// Programs one in another, the main program counted, beyond which the control stops; 0: the job's budget says it.
    std::uint32_t call_levels = 0;
    /// Called programs one in another that every series of the control takes; 0: they all take the same.
    std::uint32_t common_call_levels = 0;
    /// Axis words beside the word that takes such shifts back (G92.1 X0) name its axes; else they are a way.
    bool position_reset_names_axes = false;
    /// The unit of length (G20, G21) is said before the first move and may not change behind it.
    bool unit_before_motion = false;
    /// Of two positions for a tilted plane the rotary axes go to the one whose first axis (that carries the other one;
    /// the table's before the head's) has the shorter way, then the second one, then whose first one stands nearer to
    /// 0; else to the one with the shorter way of all. Source: FANUC 16i/18i-MB operator's manual, tool axis direction
    /// control, "Angle of rotation axis".
    bool first_rotary_axis_decides = false;
    /// The first tool in the spindle says which axis it lies along (TOOL CALL 1 Z).
    bool first_tool_says_axis = false;
    /// G28 and G30 end the compensation of the tool's length.
    bool home_cancels_length = false;
    /// An arc by its radius has no use for I, J and K beside R, which are passed over; else they are words too many.
    bool radius_before_centre = false;
    /// H and D hold until other ones are programmed, also from one tool to the next: G43 and G41 without a number take
    /// the last, H alone acts while a length is compensated. Else a block without one means the tool in the spindle.
    bool offset_numbers_stay = false;
    /// Says whether G43 and G49 alone move the tool by its length at once, or only together with a word of Z; empty:
    /// they do not move it.
    std::string_view length_word_setting{};
    /// Says that the tool's length acts along Z in every plane of a mill; without that it acts along the axis that
    /// stands on the plane. Empty: it does anyhow.
    std::string_view length_axis_setting{};
    /// P of an arc is the number of its turns, the last one begun counted.
    bool arc_turns_in_p = false;
    /// Canned cycles leave to R (G99) before the program has said which.
    bool clearance_at_start = false;
    /// mm (of a program in inches) by which the radii of an arc's ends may differ, if not more than a thousandth of it;
    /// 0: what the machine says.
    double arc_tolerance = 0, arc_tolerance_inch = 0;
    /// Coordinates and lengths count in least input increments: what is finer is rounded, as the machine file says
    /// how fine they are, else to so many a millimetre (of a program in inches a tenth of them); 0: as written.
    bool counts_increments = false;
    double increments_per_mm = 0;
    bool speed_is_whole = false;  ///< S is a whole number: what a variable holds is rounded
    /// A block that cannot be read ends the run; else it is stepped over.
    bool bad_block_stops = false;
    /// A called program that is not found ends the run; else the call is left out.
    bool missing_program_stops = false;
    /// A path at feed without a feed programmed before is an alarm; else it is for the check to say.
    bool needs_feed = false;
    /// A canned cycle under radius compensation is an alarm.
    bool compensation_forbids_canned = false;
    /// What the control makes of an F that was programmed in another unit (G94, G95) than the one in force; empty: that
    /// is not known.
    std::string_view feed_in_other_unit{};
    /// What is not ready for its block ends the run: a tool that the table does not hold, a thread with the spindle at
    /// rest, a cycle without its dwell, a probe that has no way to go, a path without feed.
    bool refuses_unready = false;
    PitchAlong pitch_along = PitchAlong::axis_of_word;
    /// Q in a thread's block: degrees of the spindle at which it begins.
    bool thread_begins_at_q = false;
    /// G80 leaves no motion in force, so that axis words alone are an error; else rapid.
    bool cancel_leaves_no_motion = false;
    /// G98: a hole ends at the level where its series began or at R, whichever is higher; else at that level also where
    /// it lies below R.
    bool hole_ends_at_least_at_retract_plane = false;
    /// A tapping cycle without its own dwell (P) takes that of the last cycle that had one.
    bool tap_keeps_dwell = false;
    /// M function whose Q says which tool is in the spindle, without a change; 0: there is none.
    std::int16_t tool_number_function = 0;
    std::span<const CannedCycle> canned{};
    std::span<const CalledHole> called_holes{};
    /// Turning cycles, by the number of their block's word (Modal::turning_cycle).
    std::span<const CannedCycle> turning{};
    std::span<const ControlParameter> set_by_control{};
    AlarmNumbers alarms{};
    /// What the control shows when a program stops itself with this number; null: the number and the program's own
    /// text.
    std::string (*alarm_text)(int) = nullptr;
};

[[nodiscard]] constexpr std::uint32_t parameter_count(const Traits& t) {
    std::uint32_t n = 0;
    for (const ParameterBank& b : t.banks) n += b.count;
    return n;
}
/// "Q7", "QL3", "R12"; a number past the last as one of the first bank.
[[nodiscard]] std::string parameter_name(const Traits& t, std::uint32_t number);
/// Number of the parameter called `upper`; one past the last where there is none.
[[nodiscard]] std::uint32_t find_parameter(const Traits& t, std::string_view upper);

/// True where the control keeps something of its own in the parameter: it may change without an assignment.
[[nodiscard]] bool is_of_control(const Traits& t, std::uint32_t number);

/// "G54", "preset 5", "the active preset".
[[nodiscard]] std::string datum_name(const Traits& t, std::uint32_t number);
/// As part of a sentence: "the zero offset G54", "preset 5".
[[nodiscard]] std::string datum_phrase(const Traits& t, std::uint32_t number);
/// Its key in [datum] of the job: "G54", "preset5".
[[nodiscard]] std::string datum_key(const Traits& t, std::uint32_t number);

/// Number of the datum that stands for "none selected".
inline constexpr std::uint32_t no_datum = 500;

}  // namespace obrys::program
