#pragma once
/// What words set and moves go by: zeros, frames, offsets, tools, spindle, feed, compensation. Private to interp.

#include <limits>

#include "interp/setup/tilted_axes.hpp"

namespace obrys::interp {

// --- assign.cpp
void assign(Telling&, const program::Assign&);
/// An assignment whose right side, and the number of whose parameter, are known already.
void assign_value(Reckoning&, const program::Assign&, double index, double value);

// --- compensation_rules.cpp
/// Before something that radius compensation does not survive: an alarm, or with looking ahead it ends
/// (Traits::compensation_keeps_side).
void leave_compensation(Telling&, const std::string& because);
/// Before radius compensation takes this side (compensation_rules.cpp, as the one above).
void refuse_other_side(Reckoning&, Modal side);
/// The word of the statement being run says `m`: where compensation begins is kept, what was carried over ends.
void note_compensation(Telling&, Modal m);
[[nodiscard]] std::string compensation_in_force(const Reckoning&);  ///< "G42 of N150"
/// At a tool change: that compensation goes on.
void say_carried_compensation(Telling&);
/// R+ and R- (G43, G44) of a block along one axis.
void compensate_along_axis(Moving&, Modal);

// --- spindle.cpp
/// The spindle's state as a record (spindle.cpp, as the next ones).
void emit_spindle(Moving&);
/// F and S of the block say how long it dwells.
[[nodiscard]] bool dwells_by_words(const Moving&);
/// A tool change stops the spindle, on machines where it does; `same`: the tool was in the spindle already.
void stop_for_change(Moving&, bool same);
/// S, M3, M4, SPOS of the block; true where the spindle changed.
[[nodiscard]] bool spindle_words(Moving&);
/// M5, M9, M19 and what else stops spindle and coolant, before the block's motion or behind it.
void stop_function(Moving&, int m, bool before_motion);
/// S2=, M2=, SPOS[2]= for a spindle that S and M3 are not for.
void other_spindle(Reckoning&, Code word, double number, double value);
/// SETMS: S, M3, G95 and G96 are for this spindle; nothing: the first one.
void select_master(Moving&, std::optional<double> number);
/// Before a feed move behind a stop that may have stopped the spindle.
void judge_stop(Reckoning&);

// --- technology.cpp
/// FB has acted for its block (technology.cpp).
void end_feed_alone(Moving&);
void technology(Moving&);

// --- tools.cpp
/// The tool that is in use when the program begins, with its own offset.
void begin_with_tool(Telling&, std::uint32_t number);
void select_tool(Moving&);
/// In another plane than that of X and Y, where a setting says along which axis the tool's length acts.
void say_length_axis(Telling&);

// --- coolant.cpp
void coolant(Telling&, int m);

// --- offset_numbers.cpp
/// H of G43: of the block, else the last one; nothing: the tool in the spindle (offset_numbers.cpp, as the next two).
[[nodiscard]] std::optional<double> length_number(Moving&);
/// D of G41 and G42, of the block or the last one.
void take_radius_number(Moving&);
/// H and D of a block that switches no compensation on.
void keep_offset_numbers(Moving&);

// --- tool_parameters.cpp
/// $TC_DPn[T, D]=value.
void write_tool_parameter(Telling&, double number, double edge, int n, double value);

// --- path_rounding.cpp
/// Says by how much the control may leave the programmed path at corners, once each (path_rounding.cpp).
void note_rounding(Moving&);

// --- datums.cpp
/// Datum shift by a row of the datum table (datums.cpp).
void shift_by_table(Telling&, const program::CycleDefinition&, double row);
/// Cycle 247: a preset by its number, which ends shift, mirror, rotation and scaling (datums.cpp).
void select_preset(Telling&, const program::CycleDefinition&, double number);
void set_own_datum(Telling&, const program::ProcedureCall&);

// --- shift.cpp
void set_shift(Telling&, const geom::Vec3&);
/// Ends shift, mirror, rotation and scaling; a tilted plane stays.
void keep_plane_alone(Telling&);
/// Puts a transformation in its place: where it was, else behind those already active; out of it when it does nothing.
void place_transform(Telling& run, TransformKind kind, const geom::Frame& frame);
/// While a cycle is called at a place of its own, the frame's origin lies there: moves it (transform.cpp).
void shift_for_call(Telling&, const geom::Vec3& by);
/// A tilted plane comes into force; the identity ends it.
void tilt(Telling&, const geom::Frame& plane, const TiltChoice& choice, const base::Span& where);

// --- datum_selection.cpp
/// A datum of the control's own: settable offset or preset (modal_words.cpp).
void set_datum(Telling&, std::uint32_t number);

// --- centred.cpp
/// G51, G51.1, G68 and their ends: the words of the block (centred.cpp).
void transform_about_centre(Moving&, Modal);

// --- offsets.cpp
/// G92 … G92.3, G52; G43 … G49: the words of the block.
void shift_words(Moving&, Modal);
/// Tells the stream what compensation of the tool's length is in force; `by`: the values where no number says them.
void tell_length(Telling&, const Axes& by);
void set_tool_offset(Telling&, const Axes& to);
/// Values of the block's axis words as absolute lengths in mm (degrees); nothing where an axis has no word.
[[nodiscard]] std::optional<double> axis_word(const Moving&, std::size_t axis);

// --- length_words.cpp
void tool_length_words(Moving&, Modal);

// --- tool_length.cpp
/// The program has set the height of its zero with the tool in the spindle.
void zero_set_here(Reckoning&);
/// Before a move: whether the tip is where the program says (tool_length.cpp).
void judge_length(Moving&);

// --- tool_against_job.cpp
/// The program has written the length of a tool: it is held to what the job gives.
void compare_with_job(Saying&, const shop::Tool&);

// --- set_data.cpp
/// G10.
void set_data(Moving&, program::DataTable table);

// --- tell_words.cpp
/// In inverse time mode: the feed per minute that follows from the length of the programmed move, mm.
void hear_inverse_feed(Moving&, double length);
/// F, S, T and M of the block, in the order in which they act.
void tell_technology(Moving&);

// --- assign_system.cpp
/// `target` is the assignment's, of kind system.
void assign_system(Telling& run, const program::Expr& target, const program::Assign& a);

}  // namespace obrys::interp
