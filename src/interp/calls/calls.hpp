#pragma once
/// Words and statements one by one, calls of programs and labels, loops, jumps and ends. Private to interp.

#include "interp/moves/moves.hpp"

namespace obrys::interp {

// --- jump.cpp
void jump(Calling&, const program::Jump&);
/// Goes to `target`; a missing end of a structure (reported by the reader) ends the program part.
inline void go_on_at(Saying& run, std::uint32_t target) {
    Activation& act = run.top();
    act.pc = target == program::no_target ? static_cast<std::uint32_t>(act.unit->statements.size()) : target;
}
void go_back(Calling& run, std::uint32_t target);
[[nodiscard]] std::uint32_t nearest(const std::vector<std::uint32_t>& at, std::uint32_t here, program::JumpDirection d);

// --- passes.cpp
/// Counts a backward branch of the statement being run to `target` (no_target: of another program); ends the run past
/// the budget, and where the loop cannot end.
void count_pass(Calling&, std::uint32_t target);

// --- loop_marks.cpp
/// A break or continue.
void leave_loop(Calling&, const program::Jump&);
/// A while is not run, as its condition does not hold.
void pass_over(Calling&, const program::Branch& while_line);
/// Whether a do ends whose condition says so, or not.
[[nodiscard]] bool ends_do(Calling&, bool done);
void begin_remembered_repeat(Calling&, const program::Branch&, std::uint32_t index);
void end_remembered_repeat(Calling&, const program::Branch&);
/// False after an alarm: the run has come by another structure with this label.
[[nodiscard]] bool owns_label(Calling&, const program::Branch& opener, std::uint32_t index);

// --- label.cpp
void call_label(Telling&, const program::LabelCall&, std::uint32_t index);
void end_label(Telling&);  ///< LBL 0

// --- calls.cpp
void call_program(Calling&, const program::Call&);
/// `repeats`: further runs of it, where no call says how many.
void enter(Calling&, const Unit&, const program::Call* call, const base::Span& where, std::uint64_t repeats = 0);
void leave(Calling&);
/// M99 P: back to the caller, who goes on with another block; in a program that nobody called a jump.
void return_to_block(Calling&, const program::Jump&);
/// Runs of the call beyond the first; nothing where it is not made at all.
[[nodiscard]] std::optional<std::uint64_t> repeats_of(Reckoning& run, const program::Call& call,
                                                      const base::Span& where);

// --- control_cycle.cpp
/// A cycle of the control itself that no program of the user stands in for (control_cycle.cpp).
void control_cycle(Calling&, const program::Call&);

/// An argument as a number; 0 where it is left out, nothing where it is none or not known.
[[nodiscard]] std::optional<double> plain(Reckoning&, const program::Call&, std::size_t argument);
/// A call that is not run, and why.
void say_not_run(Saying&, const program::Call&, const std::string& why);

// --- called_hole.cpp
/// The arguments of a call as numbers; nothing, and it is said, where the call is one that is not run.
[[nodiscard]] std::optional<HoleCall> read_hole_call(Calling&, const program::Call&);
// --- called_hole_demand.cpp
/// What it says by meaning; nothing after an alarm.
[[nodiscard]] std::optional<cycles::Demand> demand_of(Reckoning&, const HoleCall&);
// --- called_hole.cpp
/// The cycle where the tool stands.
void call_hole(Calling&, const HoleCall&, const WayOfCall&);

// --- hole_pattern.cpp
/// HOLES1, HOLES2: the modal cycle at every place of a row or a circle.
void call_hole_pattern(Calling&, const program::Call&);

// --- modal_call.cpp
void set_modal_call(Calling&, const Unit&, const program::Call&);
void run_modal_call(Calling&);

// --- procedures.cpp
void procedure(Calling&, const program::ProcedureCall&);

// --- modal_words.cpp
void modal_word(Calling&, const program::Word&);
/// What a word of the modal state does, without the block it stands in; false where `m` is none.
[[nodiscard]] bool apply_mode(Calling&, Modal m, int number);
/// What the block says that holds from its end on.
void modes_behind_motion(Calling&);

// --- dimension_words.cpp
void set_plane(Moving&, int plane);
/// The block changes the plane: alarm where radius compensation stays on.
void hold_plane(Reckoning&);
void change_plane(Moving& run, int plane);
/// Offsets and stored positions: they take the axis words of the block. False where `m` is none of them.
[[nodiscard]] bool offset_word(Moving& run, Modal m, int number);
/// Units, absolute and incremental, diameters. False where `m` is none of them.
[[nodiscard]] bool dimension_word(Telling& run, Modal m, int number);

// --- saved_modes.cpp
/// M70 and M73, M71, M72 (saved_modes.cpp).
void save_modes(Reckoning&, bool for_call);
void forget_modes(Saying&);
void restore_modes(Calling&);

// --- frame_statement.cpp
void frame_statement(Calling&, const program::Statement&, std::uint32_t index);

// --- surface.cpp
/// Polar and cylindrical interpolation, on and off (surface.cpp).
void set_surface(Calling&, Modal);

// --- program_end.cpp
void after_motion(Calling&);

// --- named_value.cpp
/// Words with a value and a name or an extension of their own: ADIS, CTOL, DISC, DL, POS, FA …, T1=, S[2]=
/// (named_value.cpp).
void named_value(Calling&, const program::Statement&, const program::Word&);
void named_axis(Moving&, const program::Named&, const base::Span& where);  ///< AX[…]=, X2=
/// Reference::… and one that a value says of itself (IC, AC …), else 0.
[[nodiscard]] std::uint8_t reference_of(const program::Expr&);

// --- run_text.cpp
/// EXECSTRING: runs a text as if it stood in the program (run_text.cpp).
void run_text(Calling&, const program::ProcedureCall&);

// --- gather.cpp
/// Gathers one word into the block; shared by blocks and frame statements.
void gather(Calling&, const program::Statement&, const program::Word&);
/// A word whose number is an expression.
void put_expression(Calling&, const program::Statement&, const program::Word&);
void take_effect(Moving& run);

// --- path_words.cpp
/// Behind a block with a motion of its own, the one from before it (modal_words.cpp).
void settle_motion(Moving&);
/// Motion, plane and what acts in this block only. False where `m` is none of them.
[[nodiscard]] bool motion_word(Moving& run, Modal m, const program::Word& w);
void set_compensation(Moving& run, Modal m);
void set_path_mode(Moving& run, Modal m, int number);
/// Motion words whose number matters, and what goes with canned cycles. False where `m` is none of them.
[[nodiscard]] bool numbered_motion_word(Moving& run, Modal m, int number);

// --- unused_words.cpp
/// To be called when the block has acted: words that nothing used are said.
void report_unused(Moving&);
/// Words that the block has twice (Traits::repeated_words).
void repeated_words(Moving&);
/// Two words of one group in a block (Traits::repeated_groups).
void repeated_group(Moving&, const program::Word&);

// --- contour_words.cpp
/// While a contour is looked at: words of the block that have no place there (contour_words.cpp).
void say_foreign_words(Moving&);
/// The same of a statement as a whole; true where it is left out.
[[nodiscard]] bool say_foreign_statement(Saying&, const program::Statement&);

// --- refuse_letters.cpp
void refuse_letters(Moving&);

// --- refusals.cpp
/// Before a modal word acts.
void refuse_modal(Moving&, const program::Word&);
/// Before the words of a block act together (Traits::refuses_unready).
void refuse_block(Moving&);
/// The main program runs past its last block (Unit::unended).
void refuse_end(Saying&);
void say_missing_beginning(Saying&);  ///< of a program that is entered

// --- behind_end.cpp
/// Blocks behind the end of the program that is run, which nothing leads to (behind_end.cpp). `end`: its word.
void say_blocks_behind(Calling&, const std::string& end);
/// The same of what a program, ending the run, has called it, and of calls of labels that do not come back.
void say_callers_rest(Calling&, const std::string& end);

// --- output.cpp
/// Text at the end of a file that the program prints to; `again`: the file begins anew.
void print_to(Reckoning&, const program::ProcedureCall&, const std::string& file, std::string_view text, bool again);
void print_form(Telling&, const program::ProcedureCall&);
void print_values(Reckoning&, const program::ProcedureCall&);

// --- table_access.cpp
void open_table(Reckoning&, const program::ProcedureCall&);
void write_table(Reckoning&, const program::ProcedureCall&);
void read_table(Reckoning&, const program::ProcedureCall&);

// --- call_arguments.cpp
void bind_value(Saying& run, const program::Parameter& p, Value v, const base::Span& where, Scope& locals);
[[nodiscard]] Value zero_value(program::Type t);
/// Evaluates the arguments in the caller and binds them in `callee`.
void bind_arguments(Reckoning& run, const Unit& unit, const program::Call& call, Activation& callee);
/// A program that is run without its call: arguments are what the job gives, their default values, or not known.
void bind_main_arguments(Reckoning& run, const Unit& unit);
/// Default values of parameters are evaluated inside the called program.
void bind_presets(Reckoning& run, const Unit& unit);
/// Local numbered parameters begin unset in every program; the caller's are put aside.
void hide_locals(Reckoning& run, const Unit& unit, Activation& callee);
void show_locals(Reckoning& run, const Activation& callee);
/// Arguments of a call as the numbered parameters 1, 2 … of the called program, whose others are 0.
void pass_arguments(Reckoning& run, const program::Call* call, Activation& callee);
void return_arguments(Reckoning& run, const Activation& callee);

// --- loops.cpp
void begin_for(Reckoning& run, const program::For& f, std::uint32_t index);
void end_for(Calling& run, const program::For& f);
void run_case(Calling& run, const program::Case& c);
void repeat_section(Telling& run, const program::Section& s, std::uint32_t index);
/// The count is taken once, at the start.
void begin_repeat(Calling& run, const program::Branch& b, std::uint32_t index);
void end_repeat(Calling& run, const program::Branch& b);

// --- refuse_signals.cpp
void refuse_signals(Moving&);

}  // namespace obrys::interp
