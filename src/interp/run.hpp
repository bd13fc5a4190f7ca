#pragma once
/// What works on the state of one run, by concern; each section names its files. Private to interp.

#include "cl/totals.hpp"
#include "interp/state.hpp"

namespace obrys::interp {

// --- complaints (complaints.cpp)
/// The control would stop here: the run ends.
void alarm(Saying&, std::string_view code, const base::Span& where, std::string text, std::string remedy = {});
[[nodiscard]] std::string of_alarm(std::string_view number);  ///< " (alarm 34)"; nothing without a number
/// Something obrys does not know or run: reported once per place; the run goes on.
void unchecked(Saying&, std::string_view code, const base::Span& where, std::string text, std::string remedy = {});
/// As `unchecked`, once per text wherever it comes up.
void unchecked_once(Saying&, std::string_view code, const base::Span& where, std::string text, std::string remedy = {});
/// Something assumed: listed once per text.
void assume(Saying&, const base::Span& where, std::string text, std::string remedy = {});

// --- expressions (evaluate.cpp, functions.cpp, system_read.cpp)
[[nodiscard]] double number(Reckoning&, ExprId);  ///< a numeric value; alarm where it is none
/// What a numbered parameter holds; unknown, or assumed, where nobody has set it.
[[nodiscard]] double parameter_value(Reckoning&, double index, const base::Span& where);
/// A condition; one that depends on an unknown value is reported and counts as `when_unknown`.
[[nodiscard]] bool truth(Reckoning&, ExprId, bool when_unknown = false);
[[nodiscard]] Value evaluate(Reckoning&, ExprId);
[[nodiscard]] Value call_function(Reckoning&, const program::Expr&);
/// SPRINT (text_format.cpp).
[[nodiscard]] Value format_text(Reckoning&, const program::Expr&);
[[nodiscard]] Value read_system(Reckoning&, const program::Expr&);
/// Name of the axis that an expression in brackets means: an axis identifier, an AXIS variable, or a number (AX[1]).
[[nodiscard]] std::string axis_of(Reckoning&, ExprId);
/// Coordinate of an axis in the programmed frame as the program would write it (diameter where it programs diameters).
[[nodiscard]] double programmed_coordinate(const Reckoning&, const std::string& axis);

// --- what the job gives (given.cpp)
/// Takes over what the control's parameters and global variables hold before the run.
void take_given(Reckoning&);
/// Adds what a backup of the control's variables assigns (backup.cpp).
void take_backup(Reckoning&, const Unit&);
/// What the job gives for a variable by the control's own spelling ("MY_I[2]", "$A_IN[1]"); nothing where it does not.
[[nodiscard]] std::optional<Value> given_value(const Reckoning&, std::string_view key);
/// A name as a key of the job file: in quotes where TOML wants them.
[[nodiscard]] std::string job_key(const std::string& name);
/// Takes what the job gives for an argument of the main program, or for its elements; false where it gives nothing.
bool give_argument(Reckoning&, Array&, const std::string& name);
/// Reports an element that nobody has set here, or assumes what its definition says.
void note_held(Saying&, const Array&, std::size_t index, const base::Span& where);
/// What remedies say: how the job gives the value of `key`.
[[nodiscard]] std::string given_remedy(const std::string& key);
/// That spelling of a variable or system variable, with its indices as they are now.
[[nodiscard]] std::string variable_key(Reckoning&, const program::Expr&);

// --- arithmetic (arithmetic.cpp)
[[nodiscard]] double binary_number(Saying&, const program::Expr&, double a, double b);
[[nodiscard]] Value binary_value(Saying&, const program::Expr&, const Value& a, const Value& b);

// --- variables (assign.cpp, assign_system.cpp, definitions.cpp)
void assign(Telling&, const program::Assign&);
void create_variable(Saying&, program::NameId, double value);
/// An assignment whose right side, and the number of whose parameter, are known already.
void assign_value(Reckoning&, const program::Assign&, double index, double value);
/// Sets a numbered parameter to `v`, the value of `value`; one that the job sets keeps that where `value` is a
/// constant.
void assign_number(Reckoning&, std::uint32_t parameter, ExprId value, double v, const base::Span& where);
/// Converts and stores; alarm where the value does not fit.
/// Sets a parameter that holds text (QS5).
void assign_text(Saying&, ExprId target, const std::string& text);
void store(Saying&, Array& array, std::size_t index, Value v, const base::Span& where);
void define(Reckoning&, const program::Define&, Scope& scope, const Unit& unit);
/// A definition stands before the first block that does something (840D sl programming manual, "Definition of user
/// variables (DEF)").
void judge_place_of_definition(Saying&, const Unit&, std::uint32_t index);
/// A number, perhaps with a sign.
[[nodiscard]] bool is_constant(const Unit&, ExprId);
[[nodiscard]] const Binding* find_variable(const Saying&, program::NameId);
/// Index of the addressed element; false after an alarm.
[[nodiscard]] bool element_of(Reckoning&, const program::Expr&, const Array&, std::size_t& index);
/// Place of an element in `Undefined`, from its indices; of one index alone.
[[nodiscard]] std::size_t undefined_key(Reckoning&, const program::Expr&);
[[nodiscard]] std::size_t undefined_part(double index);
/// One more index than the STRING has dimensions: a single character of it.
[[nodiscard]] bool is_character_access(const Binding&, const program::Expr&);
[[nodiscard]] Value read_character(Reckoning&, const Binding&, const program::Expr&);

// --- flow (interp.cpp, flow.cpp, passes.cpp, calls.cpp)
/// What machine, job and program say before the first block (begin.cpp).
void begin(Calling&, const Unit& main);
void step(RunState&);  ///< the next statement of the program
/// Ends the run where it has made too many blocks or, if the clock is looked at, taken too long.
bool over_budget(Reckoning&, bool check_clock);
void run_statement(Cycling&, const program::Statement&, std::uint32_t index);
void jump(Calling&, const program::Jump&);
/// Counts a backward branch of the statement being run to `target` (no_target: of another program); ends the run past
/// the budget, and where the loop cannot end.
void count_pass(Calling&, std::uint32_t target);
/// "the loop of N96 had run 8000000 passes": the innermost one with many; empty where there is none.
[[nodiscard]] std::string loop_being_run(const Saying&);
/// "N150", or "line 12" where the block has no number.
[[nodiscard]] std::string block_name(const Saying&, const base::Span&);
void call_label(Telling&, const program::LabelCall&, std::uint32_t index);
void end_label(Telling&);  ///< LBL 0
void call_program(Calling&, const program::Call&);
/// A program of this name, with or without path and suffix, is there.
[[nodiscard]] bool find_file(Saying&, const std::string& written);
/// A cycle of the control itself that no program of the user stands in for (control_cycle.cpp).
void control_cycle(Calling&, const program::Call&);
/// `repeats`: further runs of it, where no call says how many.
void enter(Calling&, const Unit&, const program::Call* call, const base::Span& where, std::uint64_t repeats = 0);
void leave(Calling&);
/// M99 P: back to the caller, who goes on with another block; in a program that nobody called a jump.
void return_to_block(Calling&, const program::Jump&);
void set_modal_call(Calling&, const Unit&, const program::Call&);
void run_modal_call(Calling&);
void procedure(Calling&, const program::ProcedureCall&);

// --- sizes of the tool (control_parameters.cpp)
/// Radius of a mill with the allowance of its table, mm; nothing where the list does not say it.
[[nodiscard]] std::optional<double> mill_radius(const shop::Tool&);
/// Radius by which the path of a tool is offset: of the mill, or of the insert's corner.
[[nodiscard]] std::optional<double> compensation_radius(const shop::Tool&);
/// Radius of the mill in the spindle with all allowances, mm; NaN where it is not known.
[[nodiscard]] double active_radius(const Reckoning&);
/// Length of the tool in the spindle with all allowances, mm; NaN where no tool data are at hand.
[[nodiscard]] double active_length(const Reckoning&);
/// The same; not known where the tool is listed without a length.
[[nodiscard]] double gauge_length(const Reckoning&);
/// What the control says of itself, lengths in mm; NaN where it is not known here.
[[nodiscard]] double control_value(const Reckoning&, program::ControlValue);

// --- blocks (block.cpp, modal_words.cpp, technology.cpp, tools.cpp, motion.cpp, thread.cpp, frame_words.cpp)
void run_block(Cycling&, const program::Statement&, std::uint32_t index);
void modal_word(Calling&, const program::Word&);
/// What a word of the modal state does, without the block it stands in; false where `m` is none.
[[nodiscard]] bool apply_mode(Calling&, Modal m, int number);
void set_plane(Moving&, int plane);
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
/// M70 and M73, M71, M72 (saved_modes.cpp).
void save_modes(Reckoning&, bool for_call);
void forget_modes(Saying&);
void restore_modes(Calling&);
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
/// FB has acted for its block (technology.cpp).
void end_feed_alone(Moving&);
/// The tool that is in use when the program begins, with its own offset.
void begin_with_tool(Telling&, std::uint32_t number);
void coolant(Telling&, int m);
/// M functions that the control itself knows; others go to the machine and are listed.
[[nodiscard]] bool is_standard_function(const Saying&, int m);
/// One of Traits::own_functions.
[[nodiscard]] bool is_own_function(const Saying&, int m);
/// A tool without dimensions behind those of the list; the tool in the spindle stays the one it is.
std::vector<shop::Tool>::iterator add_tool(Reckoning&, std::uint32_t number);
void frame_statement(Calling&, const program::Statement&, std::uint32_t index);
void update_frame(Telling&);
void select_tool(Moving&);
/// H of G43: of the block, else the last one; nothing: the tool in the spindle (offset_numbers.cpp, as the next two).
[[nodiscard]] std::optional<double> length_number(Moving&);
/// D of G41 and G42, of the block or the last one.
void take_radius_number(Moving&);
/// H and D of a block that switches no compensation on.
void keep_offset_numbers(Moving&);
/// Polar and cylindrical interpolation, on and off (surface.cpp).
void set_surface(Calling&, Modal);
/// Hands a move of the plane to the stream as the axes make it.
void send_on_surface(Telling&, const cl::Record&);
/// G41 D: the radius is that of the tool or offset with this number.
void take_offset_radius(Reckoning&, double number);
/// $TC_DPn[T, D]=value.
void write_tool_parameter(Telling&, double number, double edge, int n, double value);
/// n of $TC_DPn: the digits at the end of the name.
[[nodiscard]] int tool_parameter_number(const std::string& name);
void technology(Moving&);
/// mm/min (mm per revolution, 1/min) of a feed of 1.
[[nodiscard]] double feed_factor(const Reckoning&);
/// G34, G35: F says by how much the pitch changes.
[[nodiscard]] inline bool changes_pitch(Modal m) { return m == Modal::thread_rising || m == Modal::thread_falling; }
void after_motion(Calling&);
[[nodiscard]] bool motion(Cycling&);  ///< true where the block moved
/// Words with a value and a name or an extension of their own: ADIS, CTOL, DISC, DL, POS, FA …, T1=, S[2]=
/// (named_value.cpp).
void named_value(Calling&, const program::Statement&, const program::Word&);
void named_axis(Moving&, const program::Named&, const base::Span& where);  ///< AX[…]=, X2=
/// Reference::… and one that a value says of itself (IC, AC …), else 0.
[[nodiscard]] std::uint8_t reference_of(const program::Expr&);
/// The axis of the program that a machine axis called X1, AX1 or MX1 is; nothing where the name is none such.
[[nodiscard]] std::optional<std::string> machine_axis_name(const Saying&, const std::string& name);
/// Linear axes that move on their own, behind the block's path (positioning.cpp).
void position_axes(Moving&, bool path_moved);
/// Behind a block that may have moved while axes of POSA are under way.
void judge_underway(Moving&, bool path_moved);
/// WAITP.
void wait_for_axes(Moving&, const program::ProcedureCall&);
/// The block changes the plane: alarm where radius compensation stays on.
void hold_plane(Reckoning&);
/// Says by how much the control may leave the programmed path at corners, once each (path_rounding.cpp).
void note_rounding(Moving&);
/// EXECSTRING: runs a text as if it stood in the program (run_text.cpp).
void run_text(Calling&, const program::ProcedureCall&);
/// $P_PFRAME[X,TR]: the last two indices name a component of a frame (frame_component.cpp).
[[nodiscard]] bool is_component(const Saying&, const program::Expr&);
[[nodiscard]] Value read_component(Reckoning&, const program::Expr&, const geom::Frame&);
void write_component(Reckoning&, const program::Expr&, geom::Frame&, ExprId value);
/// Gathers one word into the block; shared by blocks and frame statements.
void gather(Calling&, const program::Statement&, const program::Word&);
/// Behind a block with a motion of its own, the one from before it (modal_words.cpp).
void settle_motion(Moving&);
/// Traits::arcs_about_pole (polar.cpp).
void complete_arc(Moving&);

// --- words of a block that nothing acted on, or that stand twice (unused_words.cpp)
/// To be called when the block has acted: words that nothing used are said.
void report_unused(Moving&);
/// Words that the block has twice (Traits::repeated_words).
void repeated_words(Moving&);
/// Two words of one group in a block (Traits::repeated_groups).
void repeated_group(Moving&, const program::Word&);

/// While a contour is looked at: words of the block that have no place there (contour_words.cpp).
void say_foreign_words(Moving&);
/// The same of a statement as a whole; true where it is left out.
[[nodiscard]] bool say_foreign_statement(Saying&, const program::Statement&);

/// A block with data of its own (special.cpp).
void run_special(Cycling&, const program::Statement&, std::uint32_t index);

// --- cycles (cycle.cpp, transform.cpp)
void define_cycle(Cycling&, const program::CycleDefinition&);
/// The cycle defined last, where the tool stands.
void call_cycle(Cycling&);
/// A cycle that acts at its definition; false where obrys does not run it.
[[nodiscard]] bool act_at_definition(Cycling&, const ActiveCycle&);
/// Datum shift by a row of the datum table (datums.cpp).
void shift_by_table(Telling&, const program::CycleDefinition&, double row);
/// Shift that is in force and can be changed, and a new one in its place (transform.cpp).
[[nodiscard]] geom::Vec3 active_shift(const Reckoning&);
void set_shift(Telling&, const geom::Vec3&);
/// Ends shift, mirror, rotation and scaling; a tilted plane stays.
void keep_plane_alone(Telling&);
/// A datum of the control's own: settable offset or preset (modal_words.cpp).
void set_datum(Telling&, std::uint32_t number);
/// Where the selected datum lies in the machine; NaN where that is not known (frame_words.cpp).
[[nodiscard]] geom::Vec3 datum_origin(const Reckoning&);
/// Cycle 247: a preset by its number, which ends shift, mirror, rotation and scaling (datums.cpp).
void select_preset(Telling&, const program::CycleDefinition&, double number);
/// The tilted working plane in force.
[[nodiscard]] geom::Frame active_plane(const Reckoning&);

/// G51, G51.1, G68 and their ends: the words of the block (centred.cpp).
void transform_about_centre(Moving&, Modal);

// --- blocks read anew for the state of the run (read_again.cpp)
/// The statement was read in another state than the run's, and has been run as it is read in this one; else what it
/// sets is in force.
[[nodiscard]] bool runs_read_again(RunState&, std::uint32_t index);

// --- what is refused though each word is good (refusals.cpp, refuse_letters.cpp); they end the run
void refuse_letters(Moving&);
/// Before a modal word acts.
void refuse_modal(Moving&, const program::Word&);
/// Before the words of a block act together (Traits::refuses_unready).
void refuse_block(Moving&);
/// A subprogram that is nowhere (Traits::missing_program_stops).
void refuse_call(Saying&, const std::string& name, const program::Call* call);
/// Blocks behind the end of the program that is run, which nothing leads to (behind_end.cpp). `end`: its word.
void say_blocks_behind(Calling&, const std::string& end);
/// The same of what a program, ending the run, has called it, and of calls of labels that do not come back.
void say_callers_rest(Calling&, const std::string& end);
/// The main program runs past its last block (Unit::unended).
void refuse_end(Saying&);
void say_missing_beginning(Saying&);  ///< of a program that is entered

// --- where cycles are called (pattern.cpp, cycle_places.cpp), contours of several (contour_formula.cpp)
void define_pattern(Cycling&, const program::Pattern&);
/// CYCL CALL POS: goes to the position of the block and calls the cycle there.
void call_cycle_at_position(Cycling&);
/// CYCL CALL PAT: calls the cycle at every point of the pattern.
void call_cycle_at_pattern(Cycling&);
void contour_statement(Cycling&, const program::ContourStatement&);
/// The program that a text names, path and suffix or not; null after a complaint.
[[nodiscard]] const Unit* find_named_program(Saying&, const std::string& written, const base::Span& where);

// --- what the control writes into parameters (control_parameters.cpp)
void control_sets(Reckoning&, std::initializer_list<program::ControlValue>);
void control_sets_all(Reckoning&);

// --- procedures of the control (datums.cpp, output.cpp, table_access.cpp)
void set_own_datum(Telling&, const program::ProcedureCall&);
/// Text at the end of a file that the program prints to; `again`: the file begins anew.
void print_to(Reckoning&, const program::ProcedureCall&, const std::string& file, std::string_view text, bool again);
void print_form(Telling&, const program::ProcedureCall&);
void print_values(Reckoning&, const program::ProcedureCall&);
void open_table(Reckoning&, const program::ProcedureCall&);
void write_table(Reckoning&, const program::ProcedureCall&);
void read_table(Reckoning&, const program::ProcedureCall&);

// --- offsets kept in parameters (offsets.cpp, set_data.cpp, home.cpp)
/// A, B and C among the nine axes.
[[nodiscard]] inline bool is_rotary(std::size_t axis) { return axis >= 3 && axis < 6; }
/// mm (degrees) of a machine coordinate of 1 in a parameter.
[[nodiscard]] inline double stored_unit(const Saying& run, std::size_t axis) {
    return is_rotary(axis) ? 1 : run.env.machine_unit;
}
/// Where the tip stands against the point that the control moves.
[[nodiscard]] inline const Axes& tip_in_use(const Offsets& o) { return o.tip_known ? o.tip : o.tool; }
/// G54 (54) is 1, G59.3 (593) is 9; G54.1 P1 (5401) is 1001.
[[nodiscard]] inline std::uint32_t place_of_datum(std::uint32_t number) {
    return number >= 5401 ? number - 5401 + 1001 : number >= 591 ? number - 584 : number - 53;
}
/// As programs select it: 54 … 59, 591 … 593.
[[nodiscard]] inline std::uint32_t number_of_place(std::uint32_t place) {
    return place <= 6 ? 53 + place : 584 + place;
}
[[nodiscard]] inline bool keeps_offsets(const Saying& run) { return run.traits->offsets.datum_first != 0; }
/// Takes what the parameters hold at the start of the run.
void begin_offsets(Telling&);
/// From the selected zero, turned as it is, to that of the run.
[[nodiscard]] geom::Frame datum_frame(const Reckoning&);
/// Programmed frame -> stream; also sets Offsets::total.
[[nodiscard]] geom::Frame offset_frame(Telling&);
/// Where the zero that the stream's coordinates count from lies in the machine is told by job, file or program.
[[nodiscard]] bool is_datum_given(const Reckoning&, std::size_t axis);
[[nodiscard]] bool is_datum_given(const Reckoning&, std::uint32_t datum, std::size_t axis);
/// … of any linear axis.
[[nodiscard]] bool is_datum_given(const Reckoning&);
/// The active zero offset anew from its parameters.
void load_datum(Telling&);
/// The parameter is one of the zero offset in force, or of what is added to all of them.
[[nodiscard]] bool holds_active_datum(const Reckoning&, std::uint32_t parameter);
/// The zero offset in force was written: it counts from here on.
void datum_changed(Telling&);
/// G92 … G92.3, G52; G43 … G49: the words of the block.
void shift_words(Moving&, Modal);
void tool_length_words(Moving&, Modal);
/// Which zero a numbered parameter belongs to (0: what is added to all of them), and its axis from 0 (X).
struct ZeroParameter {
    std::uint32_t number = 0, axis = 0;
};
[[nodiscard]] std::optional<ZeroParameter> zero_of(const program::OffsetParameters&, std::uint32_t parameter);
/// Tells the stream what compensation of the tool's length is in force; `by`: the values where no number says them.
void tell_length(Telling&, const Axes& by);
void set_tool_offset(Telling&, const Axes& to);
/// The tool in the spindle, its compensation or the zero was changed: where its tip is (tool_length.cpp).
void take_tip(Telling&);
/// Changes tool offset or tip while the machine stands still: the tip's place follows.
void while_standing(Telling&, base::FunctionRef<void()> change);
/// mm of the axes X … W that compensating a tool's length means.
[[nodiscard]] Axes axes_of(const shop::Tool&);
/// Tool, zero or compensation are other ones: whether its tip is where the program says is asked again.
inline void judge_anew(Offsets& o) { o.length_judged = o.length_said = false; }
/// The program has set the height of its zero with the tool in the spindle.
void zero_set_here(Reckoning&);
/// Before a move: whether the tip is where the program says (tool_length.cpp).
void judge_length(Moving&);
/// The program has written the length of a tool: it is held to what the job gives.
void compare_with_job(Saying&, const shop::Tool&);
/// What was not run leaves the tool at a place that is not known.
inline void lose_position(Reckoning& run) { run.position = run.programmed_position = {NAN, NAN, NAN}; }
/// G10.
void set_data(Moving&, program::DataTable table);
/// G28, G30, G28.1, G30.1.
void go_home(Moving&);
void store_home(Moving&);
/// Programmed coordinate of an axis (0 … 8) as the program would write it now; NaN where it is not known.
[[nodiscard]] double axis_coordinate(const Reckoning&, std::size_t axis);
/// The same in machine coordinates, mm or degrees.
[[nodiscard]] double machine_coordinate(const Reckoning&, std::size_t axis);
/// Values of the block's axis words as absolute lengths in mm (degrees); nothing where an axis has no word.
[[nodiscard]] std::optional<double> axis_word(const Moving&, std::size_t axis);

/// A parameter that is empty (Traits::empty_parameters), alone or with a sign.
[[nodiscard]] bool is_empty(Reckoning&, ExprId);

// --- what parameters hold from before the program (kept_parameters.cpp)
/// One of Traits::kept that nobody has given or set.
[[nodiscard]] bool is_kept_unknown(Reckoning&, std::uint32_t parameter);
/// The control has no parameter of this number; true after a complaint.
[[nodiscard]] bool is_absent(const Saying&, std::uint32_t parameter);
[[nodiscard]] bool refuse_absent(Saying&, std::uint32_t parameter, const base::Span& where);
/// Its value where it is known; else NaN after a complaint that names its key in the job.
[[nodiscard]] double kept_parameter(Reckoning&, std::uint32_t parameter, const base::Span& where);
/// Behind an assignment: the zero offset in force may stand there, else it is said where writing does more than keep a
/// value.
void note_written(Telling&, std::uint32_t parameter, const base::Span& where);

// --- what the control shows of itself (live_parameters.cpp)
[[nodiscard]] bool is_live(const Reckoning&, std::uint32_t parameter);
/// What probing and inputs leave there can be overwritten.
[[nodiscard]] bool may_be_written(const Saying&, std::uint32_t parameter);
/// The control alone says what the parameter shows: writing it is an alarm, and a timer runs on from where it is set.
[[nodiscard]] bool is_of_control(Saying&, std::uint32_t parameter, const base::Span& where);
/// What the program wrote over live parameters of this kind no longer holds: the control has written them.
void forget_live(Reckoning&, program::SystemVariable what);
[[nodiscard]] double live_parameter(Reckoning&, std::uint32_t parameter, const base::Span& where);
[[nodiscard]] Value live_value(Reckoning&, program::SystemVariable, double index, const std::string& name,
                               const base::Span& where);
/// Number of the G code that a query shows: `yes` or `no` by what it says, or that which it names itself where both are
/// 0. Nothing where the program has said none of its group: the control was left so by the one before.
[[nodiscard]] std::optional<double> code_in_force(const Reckoning&, program::StateQuery, double yes, double no);
/// The program has said a word of the group.
[[nodiscard]] bool is_said(const Reckoning&, program::ModalGroup);
/// Why the tool in the spindle is not known.
inline constexpr const char* no_tool_said =
    "which tool is in use when the program begins is not known, and no block before selects one";
/// LinuxCNC's own interpreter, which Environment::tell_settings stands for, begins with nothing in the spindle.
void begin_said(Reckoning&);

// --- cycles that motion blocks call (canned.cpp)
/// False where the block's words call no cycle.
[[nodiscard]] bool canned_motion(Cycling&);
/// G12, G13 (circle_pocket.cpp).
[[nodiscard]] bool circle_pocket(Moving&);
/// G70 … G72, G76 of lathes (turning.cpp).
[[nodiscard]] bool turning_cycle(Moving&);
/// A turning cycle that acts at its definition (turning_definition.cpp).
void define_turning_cycle(Cycling&, const ActiveCycle&);
/// The contour of a finishing cycle has been run: back to where the cycle began.
void end_finishing(Moving&, const ActiveSection&);
/// Statements of the program at hand with this block number, in order.
[[nodiscard]] std::vector<std::uint32_t> numbered_statements(const Saying&, double n);

// --- splines (spline.cpp)
/// G5, G5.1, G5.2 … G5.3, G6.2.
[[nodiscard]] bool spline_motion(Moving&);

// --- what is set besides moves (tell.cpp); `tell…`: nothing where nobody wants to know
void tell(Telling&, cl::SettingKind, int number = 0, std::initializer_list<double> values = {});
void tell(Telling&, cl::SettingKind, int number, const Axes& values);
void tell_tool_entry(Telling&, int place, int tool, std::initializer_list<double> values);
/// In inverse time mode: the feed per minute that follows from the length of the programmed move, mm.
void tell_inverse_feed(Moving&, double length);
/// What the end of the program sets back.
void tell_end(Telling&, int m);
/// What is in force when the run begins.
void begin_telling(Telling&);
/// How programmed coordinates become those of the stream.
void tell_frame(Telling&);
/// The path mode in force, with its tolerances.
void tell_path_mode(Telling&);
/// How moves are joined from here on; `smoothing_words`: by G60, G64 … G645 of SINUMERIK, else by G61, G61.1, G64.
void tell_joining(Telling&, bool smoothing_words);
/// That the operator may change the feed of a step of a cycle or not: the cycle itself says so to everybody else.
void tell_feed_override(Telling&, bool on);
/// M48 … M53: what the operator may change.
void switch_override(Telling&, cl::OverrideKind, bool on);
/// F, S, T and M of the block, in the order in which they act.
void tell_technology(Moving&);

// --- the feed in the stream where it is not F itself (feed_shape.cpp): M103, M109, M110
/// From here on records are looked at.
void shape_feed_from_here(Telling&);
/// Before `record` goes out: the feed that it is run with.
void shape_feed(Telling&, const cl::Record& record);
/// Hands a record to whoever takes the stream.
inline void send(Telling& run, const cl::Record& record) {
    run.sent = cl::position_after(run.sent, record.step);
    if (run.surface.kind != SurfaceMode::Kind::none) return send_on_surface(run, record);
    if (run.feed_shape.on) shape_feed(run, record);
    run.sink(record);
}

/// As above, a record that radius compensation has not made.
inline void send_plain(Telling& run, const cl::Record& record) {
    run.feed_shape.plunge = run.modal.plunge_part;
    run.feed_shape.arc = 1;
    send(run, record);
}

// --- output (emit.cpp)
void emit(Telling&, cl::Step step);
inline constexpr double stream_joined = 1e-6;  ///< mm; no farther off a curve begins where the stream stands
/// Brackets of the stream about what is called or repeated.
void begin_part(Telling&, cl::PartKind kind, std::string name, std::uint64_t pass, std::uint64_t passes);
void end_part(Telling&);
/// Runs a section that has been run before once more, `section.left` times in all.
void begin_repetition(Telling&, ActiveSection section);
/// Before a move: the zero that is selected and the frame in which coordinates are programmed, as far as the stream
/// does not have them yet.
void emit_frame(Telling&);
/// That frame, from the selected zero inwards (frame_words.cpp).
[[nodiscard]] std::vector<cl::FramePart> frame_parts(const Telling&);
/// Zero of the run's coordinates in the machine's, and that of the selected datum; NaN where it is not known.
[[nodiscard]] geom::Vec3 stream_origin(const Reckoning&);
[[nodiscard]] geom::Vec3 selected_origin(const Reckoning&);
[[nodiscard]] cl::Axis axis_record(std::string_view name, double to, bool is_rotary, bool counted);
/// Emits what a path stage (compensation, rounding) still holds back.
void flush_path(Telling&);

[[nodiscard]] inline Code axis_code(int k) { return static_cast<Code>(static_cast<int>(Code::x) + k); }
[[nodiscard]] inline double& coordinate(geom::Vec3& v, int k) { return k == 0 ? v.x : k == 1 ? v.y : v.z; }
[[nodiscard]] inline double coordinate(const geom::Vec3& v, int k) { return k == 0 ? v.x : k == 1 ? v.y : v.z; }

}  // namespace obrys::interp
