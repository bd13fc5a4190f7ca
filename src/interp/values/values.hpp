#pragma once
/// Values: expressions, variables, and what can be asked of the machine as it stands. Nothing here changes what the
/// stream is told. Private to interp.

#include <cmath>
#include <limits>

#include "cl/totals.hpp"
#include "interp/say.hpp"

namespace obrys::interp {

// --- evaluate.cpp
[[nodiscard]] double number(Reckoning&, ExprId);  ///< a numeric value; alarm where it is none
/// What a numbered parameter holds; unknown, or assumed, where nobody has set it.
[[nodiscard]] double parameter_value(Reckoning&, double index, const base::Span& where);
/// A condition; one that depends on an unknown value is reported and counts as `when_unknown`.
[[nodiscard]] bool truth(Reckoning&, ExprId, bool when_unknown = false);
[[nodiscard]] Value evaluate(Reckoning&, ExprId);
/// Name of the axis that an expression in brackets means: an axis identifier, an AXIS variable, or a number (AX[1]).
[[nodiscard]] std::string axis_of(Reckoning&, ExprId);
/// A parameter that is empty (Traits::empty_parameters), alone or with a sign.
[[nodiscard]] bool is_empty(Reckoning&, ExprId);

// --- increments.cpp
/// Words whose values the control takes in least input increments.
inline constexpr std::uint64_t counted_words =
    linear_axes | bit(Code::i) | bit(Code::j) | bit(Code::k) | bit(Code::radius);
/// How many of them a length of 1 in the program has; 0: it is taken as written.
[[nodiscard]] double increments_of_unit(const Reckoning&);
[[nodiscard]] inline double in_increments(double v, double of_unit) {
    return of_unit == 0 ? v : std::round(v * of_unit) / of_unit;
}
/// The value of such a word, or of S; any other one's as it is.
[[nodiscard]] inline double as_taken(const Reckoning& run, Code code, double v) {
    if (code == Code::spindle && run.traits->speed_is_whole) return std::round(v);
    return (counted_words & bit(code)) != 0 ? in_increments(v, increments_of_unit(run)) : v;
}

// --- functions.cpp
[[nodiscard]] Value call_function(Reckoning&, const program::Expr&);

// --- text_format.cpp
/// SPRINT (text_format.cpp).
[[nodiscard]] Value format_text(Reckoning&, const program::Expr&);

// --- system_read.cpp
[[nodiscard]] Value read_system(Reckoning&, const program::Expr&);

// --- coordinates.cpp
/// Coordinate of an axis in the programmed frame as the program would write it (diameter where it programs diameters).
[[nodiscard]] double programmed_coordinate(const Reckoning&, const std::string& axis);
/// The axis of the program that a machine axis called X1, AX1 or MX1 is; nothing where the name is none such.
[[nodiscard]] std::optional<std::string> machine_axis_name(const Saying&, const std::string& name);
/// Greater results of operators are too large for every control.
inline constexpr double largest_result = 1e300;
/// Writing it changes nothing but itself: the control shows nothing there, keeps nothing that acts, and has it.
[[nodiscard]] inline bool is_programs_own(const Reckoning& run, std::uint32_t n) {
    const program::Traits& t = *run.traits;
    const bool shown = !t.live.empty() && n >= t.live.front().first;  // the lowest stands first
    if (shown || n == 0 || n >= run.parameters.count() || (n >= t.absent_first && n <= t.absent_last)) return false;
    for (const program::KeptParameters& k : t.kept)
        if (k.acts && n >= k.first && n <= k.last) return false;
    return true;
}
/// Whether a word with this reference (0 = as the modal state says) is incremental.
[[nodiscard]] inline bool is_incremental(const Reckoning& run, std::uint8_t reference) {
    using program::Reference;
    if (reference == 0) return !run.modal.absolute;
    return reference == 1 + static_cast<std::uint8_t>(Reference::incremental) ||
           reference == 1 + static_cast<std::uint8_t>(Reference::diameter_incremental) ||
           reference == 1 + static_cast<std::uint8_t>(Reference::radius_incremental);
}
/// Millimetres per programmed unit of a linear axis: inches, and diameters of a lathe's X.
[[nodiscard]] inline double length_factor(const Reckoning& run, int axis, bool incremental) {
    const double factor = length_unit(run.modal);
    if (axis != 0 || run.modal.diameter == DiameterMode::off) return factor;
    if (run.modal.diameter == DiameterMode::absolute_only && incremental) return factor;
    return factor * 0.5;
}
/// The same of a word with its own reference (DIC, RAC …; 0: as the modal state says).
[[nodiscard]] double word_factor(const Reckoning&, int axis, std::uint8_t reference);
/// The machine's axis of that name, or null.
[[nodiscard]] const shop::MachineAxis* machine_axis(const Saying&, const std::string& name);
/// The tool stands at `to` (programmed frame) from here on.
void arrive(Reckoning&, const geom::Vec3& to);

// --- given.cpp
/// Takes over what the control's parameters and global variables hold before the run.
void take_given(Reckoning&);
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

// --- backup.cpp
/// Adds what a backup of the control's variables assigns (backup.cpp).
void take_backup(Reckoning&, const Unit&);

// --- arithmetic.cpp
[[nodiscard]] double binary_number(Saying&, const program::Expr&, double a, double b);
[[nodiscard]] Value binary_value(Saying&, const program::Expr&, const Value& a, const Value& b);

// --- variable.cpp
void create_variable(Saying&, program::NameId, double value);
/// Sets a numbered parameter to `v`, the value of `value`; one that the job sets keeps that where `value` is a
/// constant.
void assign_number(Reckoning&, std::uint32_t parameter, ExprId value, double v, const base::Span& where);
/// Converts and stores; alarm where the value does not fit.
/// Sets a parameter that holds text (QS5).
void assign_text(Saying&, ExprId target, const std::string& text);
void store(Saying&, Array& array, std::size_t index, Value v, const base::Span& where);
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
/// A text parameter (QS5) exists from its first use on, for all programs.
[[nodiscard]] const Binding* text_parameter(Saying& run, program::NameId name);
/// A variable that begins to exist by being assigned: `_NAME` for all programs, another name for this one.
void create_variable(Saying& run, program::NameId name, double value);
void write_character(Reckoning& run, const Binding& b, const program::Expr& e, ExprId value);

// --- definitions.cpp
void define(Reckoning&, const program::Define&, Scope& scope, const Unit& unit);
/// A definition stands before the first block that does something (840D sl programming manual, "Definition of user
/// variables (DEF)").
void judge_place_of_definition(Saying&, const Unit&, std::uint32_t index);

// --- budget.cpp
/// Ends the run where it has made too many blocks or, if the clock is looked at, taken too long.
bool over_budget(Reckoning&, bool check_clock);

// --- program_files.cpp
/// A program of this name, with or without path and suffix, is there.
[[nodiscard]] bool find_file(Saying&, const std::string& written);
/// A subprogram that is nowhere (Traits::missing_program_stops).
void refuse_call(Saying&, const std::string& name, const program::Call* call);
/// The program that a text names, path and suffix or not; null after a complaint.
[[nodiscard]] const Unit* find_named_program(Saying&, const std::string& written, const base::Span& where);
[[nodiscard]] std::string program_name(std::string_view written);
[[nodiscard]] const Unit* find_program(Saying& run, const std::string& name, const base::Span& where,
                                       const program::Call* call = nullptr);

// --- control_parameters.cpp
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
void control_sets(Reckoning&, std::initializer_list<program::ControlValue>);
void control_sets_all(Reckoning&);

// --- standard_functions.cpp
/// M functions that the control itself knows; others go to the machine and are listed.
[[nodiscard]] bool is_standard_function(const Saying&, int m);
/// One of Traits::own_functions.
[[nodiscard]] bool is_own_function(const Saying&, int m);

// --- tool_list.cpp
/// A tool without dimensions behind those of the list; the tool in the spindle stays the one it is.
std::vector<shop::Tool>::iterator add_tool(Reckoning&, std::uint32_t number);
/// G41 D: the radius is that of the tool or offset with this number.
void take_offset_radius(Reckoning&, double number);
[[nodiscard]] const shop::Tool* find_tool(const Reckoning& run, const ToolState& t);
void tool_into_spindle(Reckoning& run);
[[nodiscard]] bool is_listed(const Reckoning& run, double number);

// --- system_tool.cpp
/// n of $TC_DPn: the digits at the end of the name.
[[nodiscard]] int tool_parameter_number(const std::string& name);
/// Value of a system variable from `inch_program` on (program/expr.hpp), in mm and degrees; nothing where the shop does
/// not say it.
[[nodiscard]] std::optional<double> tool_or_frame(Reckoning&, const program::Expr&);

// --- feed_factor.cpp
/// mm/min (mm per revolution, 1/min) of a feed of 1.
[[nodiscard]] double feed_factor(const Reckoning&);

// --- frame_component.cpp
/// $P_PFRAME[X,TR]: the last two indices name a component of a frame (frame_component.cpp).
[[nodiscard]] bool is_component(const Saying&, const program::Expr&);
[[nodiscard]] Value read_component(Reckoning&, const program::Expr&, const geom::Frame&);
void write_component(Reckoning&, const program::Expr&, geom::Frame&, ExprId value);

// --- active_transforms.cpp
/// Shift that is in force and can be changed, and a new one in its place (transform.cpp).
[[nodiscard]] geom::Vec3 active_shift(const Reckoning&);
/// The tilted working plane in force.
[[nodiscard]] geom::Frame active_plane(const Reckoning&);
[[nodiscard]] geom::Frame active_transform(const Reckoning& run, TransformKind kind);

// --- datum_place.cpp
/// Where the selected datum lies in the machine; NaN where that is not known (frame_words.cpp).
[[nodiscard]] geom::Vec3 datum_origin(const Reckoning&);
/// Way between the active datum and the one the stream's coordinates are in; nothing where it is not known.
[[nodiscard]] std::optional<geom::Frame> datum_shift(const Reckoning& run);

/// mm (degrees) of a machine coordinate of 1 in a parameter.
[[nodiscard]] inline double stored_unit(const Saying& run, std::size_t axis) {
    return is_rotary(axis) ? 1 : run.env.machine_unit;
}
/// Where the tip stands against the point that the control moves.
[[nodiscard]] inline const Axes& tip_in_use(const Offsets& o) { return o.tip_known ? o.tip : o.tool; }
[[nodiscard]] inline bool keeps_offsets(const Saying& run) { return run.traits->offsets.datum_first != 0; }
/// Which zero a numbered parameter belongs to (0: what is added to all of them), and its axis from 0 (X).
struct ZeroParameter {
    std::uint32_t number = 0, axis = 0;
};
/// Tool, zero or compensation are other ones: whether its tip is where the program says is asked again.
inline void judge_anew(Offsets& o) { o.length_judged = o.length_said = false; }
/// What was not run leaves the tool at a place that is not known.
inline void lose_position(Reckoning& run) { run.position = run.programmed_position = {NAN, NAN, NAN}; }
/// Why the tool in the spindle is not known.
inline constexpr const char* no_tool_said =
    "which tool is in use when the program begins is not known, and no block before selects one";

// --- stored_offsets.cpp
/// What somebody has to give, so that the axes' place of the machine is known in the workpiece too; `at`: there, NaN where
/// not known.
[[nodiscard]] std::string wanted_for_home(const Reckoning&, const geom::Vec3& at, const cl::MachinePlace& place);
/// From the selected zero, turned as it is, to that of the run.
[[nodiscard]] geom::Frame datum_frame(const Reckoning&);
/// Where the zero that the stream's coordinates count from lies in the machine is told by job, file or program.
[[nodiscard]] bool is_datum_given(const Reckoning&, std::size_t axis);
[[nodiscard]] bool is_datum_given(const Reckoning&, std::uint32_t datum, std::size_t axis);
/// … of any linear axis.
[[nodiscard]] bool is_datum_given(const Reckoning&);
/// The parameter is one of the zero offset in force, or of what is added to all of them.
[[nodiscard]] bool holds_active_datum(const Reckoning&, std::uint32_t parameter);
/// Programmed coordinate of an axis (0 … 8) as the program would write it now; NaN where it is not known.
[[nodiscard]] double axis_coordinate(const Reckoning&, std::size_t axis);
/// What machine coordinates of X, Y, Z (0 … 2) lie ahead of the stream's; NaN where nobody has said where the zero lies
/// in the machine, or it is turned against it. The one way from a place of the machine to one on the workpiece.
[[nodiscard]] double machine_ahead(const Reckoning&, std::size_t axis);
/// Programmed coordinate in machine coordinates, mm or degrees; NaN where it is not known there.
[[nodiscard]] double machine_coordinate(const Reckoning&, std::size_t axis);
/// Parameter that holds X of a zero offset; nothing for one that is kept nowhere.
[[nodiscard]] inline std::optional<std::uint32_t> first_of_datum(const Saying& run, std::uint32_t number) {
    const program::OffsetParameters& p = run.traits->offsets;
    const std::uint32_t place = place_of_datum(number) - 1;
    if (place < p.datum_count) return p.datum_first + place * p.datum_step;
    if (place >= 1000 && place - 1000 < p.extended_count) return p.extended_first + (place - 1000) * p.datum_step;
    return std::nullopt;
}
[[nodiscard]] bool holds_all(const Saying& run);
/// What a zero offset has for this axis (or as its rotation) is known; what the job leaves out is 0.
[[nodiscard]] bool is_zero_held(const Reckoning& run, std::uint32_t datum, std::size_t axis);

// --- kept_parameters.cpp
[[nodiscard]] std::optional<ZeroParameter> zero_of(const program::OffsetParameters&, std::uint32_t parameter);
/// One of Traits::kept that nobody has given or set.
[[nodiscard]] bool is_kept_unknown(Reckoning&, std::uint32_t parameter);
/// The control has no parameter of this number; true after a complaint.
[[nodiscard]] bool is_absent(const Saying&, std::uint32_t parameter);
[[nodiscard]] bool refuse_absent(Saying&, std::uint32_t parameter, const base::Span& where);
/// Its value where it is known; else NaN after a complaint that names its key in the job.
[[nodiscard]] double kept_parameter(Reckoning&, std::uint32_t parameter, const base::Span& where);
[[nodiscard]] inline const program::KeptParameters* range_of(const Saying& run, std::uint32_t n) {
    for (const program::KeptParameters& k : run.traits->kept)
        if (n >= k.first && n <= k.last) return &k;
    return nullptr;
}

// --- live_parameters.cpp
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
/// LinuxCNC's own interpreter, which Environment::stand_alone says, begins with nothing in the spindle.
void begin_said(Reckoning&);

// --- numbered_blocks.cpp
/// Statements of the program at hand with this block number, in order.
[[nodiscard]] std::vector<std::uint32_t> numbered_statements(const Saying&, double n);
/// Statements that carry block number `n`; the text is gone through when a program first jumps to a computed one.
[[nodiscard]] std::vector<std::uint32_t> numbered_blocks(const Saying& run, std::int64_t n);

// --- datum_words.cpp
/// Value of a datum of the block; `otherwise` where it was not written.
[[nodiscard]] double datum_of(Reckoning&, const program::Special&, program::Datum, double otherwise = 0);
[[nodiscard]] bool has_datum(const program::Special&, program::Datum);

}  // namespace obrys::interp
