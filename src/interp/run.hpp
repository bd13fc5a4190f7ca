#pragma once
/// The state of one run. Private to interp: the functions that work on it lie in files by concern.

#include <array>
#include <bit>
#include <chrono>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "geom/frame.hpp"
#include "geom/nurbs.hpp"
#include "interp/interp.hpp"
#include "interp/modes.hpp"
#include "interp/value.hpp"
#include "interp/variables.hpp"

namespace obrys::interp {

using program::Code;
using program::ExprId;
using program::Modal;
using program::Unit;

/// An assignment whose value is known and that waits for the block's other expressions (Traits::assigns_together).
struct PendingAssign {
    const program::Assign* assign = nullptr;
    double index = 0;  ///< of a numbered parameter
    double value = 0;
};

/// The words of one block, gathered before they act together.
struct BlockWords {
    struct NamedAxis {
        std::string name;
        double value = 0;
        std::uint8_t reference = 0;
        base::Span where;
    };
    std::uint64_t present = 0;               ///< bit per Code, of which there are 64 at most
    std::array<double, 64> value;            ///< by Code; valid where the bit is set
    std::array<std::uint8_t, 64> reference;  ///< 0 = as the modal state says, else 1 + program::Reference
    std::vector<int> m;
    std::vector<int> h;
    std::vector<NamedAxis> axes;  ///< additional axes by name
    std::string tool_name;
    bool tool_named = false;
    int special_number = 0;
    int surface_word = 0;  ///< 96 or 97 where the block says it
    bool acted = false;    ///< F, S, T and M have acted already (Code::act)
    std::vector<PendingAssign> pending;
    Modal special = Modal::linear;     ///< dwell, reference point, fixed point, pole; linear: none
    Modal suppress = Modal::linear;    ///< suppress_frames, suppress_all; linear: none
    Modal corner_end = Modal::linear;  ///< corner_crossing, corner_open; linear: none
    Modal paraxial = Modal::linear;    ///< paraxial, paraxial_longer, paraxial_shorter; linear: none

    [[nodiscard]] bool has(Code c) const { return (present >> static_cast<unsigned>(c)) & 1u; }
    [[nodiscard]] double get(Code c) const { return value[static_cast<std::size_t>(c)]; }
    [[nodiscard]] std::uint8_t ref(Code c) const { return reference[static_cast<std::size_t>(c)]; }
    void put(Code c, double v, std::uint8_t r = 0) {
        const auto i = static_cast<std::size_t>(c);
        present |= std::uint64_t{1} << i;
        value[i] = v;
        reference[i] = r;
    }
    void clear();
};

/// A section being repeated (REPEAT label label P=n).
struct ActiveSection {
    std::uint32_t first = 0, last = 0, back = 0;
    std::uint64_t left = 0;
    const program::Statement* finishing = nullptr;  ///< the cycle whose contour it is; null: it is repeated only
    geom::Vec3 start{};                             ///< where that cycle began, programmed frame
};

/// CALL LBL being run.
struct LabelReturn {
    std::uint32_t pc = 0;   ///< where the run goes on
    cl::StackId stack = 0;  ///< of the caller
};

/// One program being run.
struct Activation {
    const Unit* unit = nullptr;
    std::uint32_t pc = 0;
    cl::StackId stack = 0;
    Scope locals;
    struct Counter {
        std::uint32_t statement = 0;
        std::uint64_t left = 0;
    };
    std::vector<Counter> counters;  ///< of repeat_count loops that are being run
    struct Passes {
        std::uint32_t statement = 0;
        std::uint64_t count = 0;
    };
    std::vector<Passes> passes;  ///< of every backward branch taken, by its statement
    std::vector<ActiveSection> sections;
    std::vector<LabelReturn> labels;
    std::vector<std::pair<double, bool>> outer_locals;     ///< the caller's local parameters, and whether they are set
    std::vector<std::pair<double, bool>> outer_arguments;  ///< the same of Traits::argument_parameters
    std::optional<SavedModes> saved_modes;                 ///< M70, M73
    bool restores_modes = false;                           ///< M73: they come back with the return
    std::uint64_t repeats_left = 0;                        ///< of L123 P3: further runs
    std::size_t own_bindings = 0;       ///< bindings that are parameters; the rest goes with each run
    std::uint32_t arguments_given = 0;  ///< bit per parameter, for $P_SUBPAR
    bool from_modal_call = false;
    bool saves = false;
    ModalState saved;
};

/// MCALL: the call that follows every block with motion.
struct ModalCall {
    const Unit* unit = nullptr;
    std::vector<Value> arguments;  ///< as they were when MCALL stood in the program
    std::vector<std::uint8_t> given;
    base::Span where;
};

/// A cycle as its definition left it.
struct ActiveCycle {
    const program::CycleDefinition* definition = nullptr;
    const Unit* unit = nullptr;
    std::vector<double> values;      ///< per setting, as it was at the definition
    std::vector<std::string> texts;  ///< labels, names of programs
    bool modal = false;              ///< M89: behind every block with motion
};

/// Control points between G5.2 and G5.3, or of G6.2.
struct ControlCurve {
    bool open = false, own_knots = false;
    geom::Nurbs curve;  ///< programmed frame
};

/// What the words of a canned cycle's blocks have said, until it is cancelled.
struct CannedState {
    bool active = false;
    int cycle = -1;            ///< index in Traits::canned
    double retract = 0;        ///< R as written, mm
    double bottom = 0;         ///< coordinate of the tool axis as written, mm
    double initial_level = 0;  ///< of the tool axis when the series began, mm
    bool has_retract = false, has_bottom = false;
    std::array<double, 12> values{};  ///< by word of the cycle; mm, degrees, s
    std::array<bool, 12> given{};
};

/// Points at which CYCL CALL PAT calls the cycle, as PATTERN DEF or SEL PATTERN left them; mm.
struct CallPattern {
    struct Point {
        geom::Vec3 at;         ///< the coordinate of the tool axis is that of the surface
        double clearance = 0;  ///< coordinate of the tool axis on the way to it; NaN: none
    };
    bool defined = false;
    std::vector<Point> points;
    base::Span where;
};

/// A statement about the contour of contour cycles that was run, with its values as they were.
struct ContourChoice {
    struct Part {
        std::string name;  ///< of the label or program
        double depth = 0;  ///< mm; NaN: none of its own
    };
    const program::ContourStatement* statement = nullptr;
    const Unit* unit = nullptr;
    std::vector<Part> parts;
};

struct ToolState {
    std::uint32_t number = 0, edge = 0;
    std::string name;
    std::uint32_t prepared = 0;  ///< T programmed, M6 still to come (mills)
    std::string prepared_name;
    bool waiting = false;
    const shop::Tool* data = nullptr;
    double delta_length = 0, delta_radius = 0, delta_corner = 0;  ///< allowances of the call, mm
    double feed = 0;                                              ///< given with the tool (F AUTO), mm/min; 0: none
};

class PathStage;
struct Captured;
struct FreeContour;

struct Run {
    Run(const Environment& e, cl::CallStacks& s, cl::Sink k, base::Diagnostics& d, std::uint32_t parameter_count);
    ~Run();

    const Environment& env;
    const program::Traits* traits = nullptr;  ///< of the main program
    cl::CallStacks& stacks;
    cl::Sink sink;
    base::Diagnostics& diagnostics;

    std::vector<Activation> calls;
    Scope globals;
    Undefined undefined;
    Parameters parameters;
    std::unordered_map<program::NameId, double> overrides_by_name;
    std::vector<std::uint8_t> parameter_overridden;
    std::vector<double> parameter_override;
    std::unordered_map<std::uint64_t, Value> system_written;  ///< system variables the program wrote itself

    ModalState modal;
    Offsets offsets;
    BlockWords block;
    ToolState tool;
    std::vector<shop::Tool> tools;  ///< of the job, with what the program writes to $TC_DPn
    SpindleState spindle;
    bool coolant_on = false, mist = false, flood = false;
    Overrides overrides;
    double feed = 0;  ///< mm/min, mm/rev or 1/min by modal.feed_mode
    bool feed_valid = false;
    bool feed_unknown = false;  ///< the last F depends on a value that is not known
    bool feed_dropped = false;  ///< G94/G95 changed and the stream does not know yet that F is void
    ModalCall modal_call;
    ActiveCycle cycle;                        ///< the last one that is active on call
    std::vector<std::string> contour_labels;  ///< of the contour that contour cycles work on
    CannedState canned;
    ControlCurve curve;
    geom::Vec3 last_spline_end;           ///< P and Q of the last G5, mm
    const Unit* contour_unit = nullptr;   ///< the program whose labels these are
    std::string datum_table;              ///< selected by the program; empty: the one that is active on the control
    std::set<std::string> printed_files;  ///< that the program has begun to print to
    std::string open_table;               ///< freely definable table (FN 26)
    ActiveCycle contour_data, contour_train_data;
    CallPattern pattern;
    std::map<std::string, std::vector<CallPattern::Point>> point_tables;  ///< read so far
    /// What CONTOUR DEF, or DECLARE CONTOUR and formulas, say the contour is; empty: `contour_labels` do.
    std::vector<ContourChoice> contour_choices;

    geom::Vec3 position;             ///< stream frame, mm; NaN where unknown
    geom::Vec3 programmed_position;  ///< in the programmed frame
    geom::Frame frame;               ///< programmed frame -> stream frame
    bool frame_is_identity = true;
    geom::Vec3 tool_axis{0, 0, 1};        ///< in the stream's frame: normal to a tilted working plane
    std::uint32_t reference_datum = 500;  ///< the datum in which the stream's coordinates are
    bool datum_known = true;              ///< the active datum's place against it is known
    bool moved = false;
    bool datum_emitted = false;
    bool probed = false;  ///< a probing move was run to its end, where the probe may have stopped before
    std::unordered_map<std::string, double> extra_axes;
    std::uint64_t known_axes = 0;  ///< bit per Code of X … W: the machine has it
    geom::Vec2 last_direction;     ///< of the last move in the working plane, for CT
    std::unique_ptr<PathStage> path;
    /// Where it is set, elements go there and nothing is emitted or complained about (capture.hpp).
    std::vector<Captured>* capture = nullptr;
    std::shared_ptr<FreeContour> free_contour;  ///< being solved
    std::optional<geom::Vec2> free_pole;        ///< FPOL
    bool turned_contour = false;                ///< the contour of a turning cycle is being collected
    /// Values of turning cycles that stay with the control (CycleDefinition::store), mm, by store and role.
    std::map<std::pair<int, program::CycleRole>, double> cycle_store;
    /// Where it is set, complaints made while `capture` is set go there.
    std::vector<base::Diagnostic>* silenced = nullptr;

    const program::Statement* statement = nullptr;  ///< being run
    bool stopped = false;                           ///< alarm, budget or program end
    Ending ending = Ending::regular;
    std::uint64_t blocks = 0;
    std::uint64_t unknown_conditions = 0;  ///< that were met
    std::chrono::steady_clock::time_point started;
    std::unordered_set<std::uint64_t> reported;  ///< complaints already made, by place and code
    std::set<std::string> assumed;
    std::string last_message;  ///< of MSG
    std::string log_file;      ///< that the program has opened; empty: none
    std::unordered_set<const Unit*> entered;
    cl::Record record;

    [[nodiscard]] Activation& top() { return calls.back(); }
    [[nodiscard]] const Unit& unit() const { return *calls.back().unit; }
    [[nodiscard]] base::Span here() const { return unit().span(*statement); }
};

// --- complaints (interp.cpp)
/// The control would stop here: the run ends.
void alarm(Run&, std::string_view code, const base::Span& where, std::string text, std::string remedy = {});
/// Something obrys does not know or run: reported once per place; the run goes on.
void unchecked(Run&, std::string_view code, const base::Span& where, std::string text, std::string remedy = {});
/// As `unchecked`, once per text wherever it comes up.
void unchecked_once(Run&, std::string_view code, const base::Span& where, std::string text, std::string remedy = {});
/// Something assumed: listed once per text.
void assume(Run&, const base::Span& where, std::string text, std::string remedy = {});

// --- expressions (evaluate.cpp, functions.cpp, system_read.cpp)
[[nodiscard]] double number(Run&, ExprId);  ///< a numeric value; alarm where it is none
/// A condition; one that depends on an unknown value is reported and counts as `when_unknown`.
[[nodiscard]] bool truth(Run&, ExprId, bool when_unknown = false);
[[nodiscard]] Value evaluate(Run&, ExprId);
[[nodiscard]] Value call_function(Run&, const program::Expr&);
[[nodiscard]] Value read_system(Run&, const program::Expr&);
/// Name of the axis that an expression in brackets means: an axis identifier, an AXIS variable, or a number (AX[1]).
[[nodiscard]] std::string axis_of(Run&, ExprId);
/// Coordinate of an axis in the programmed frame as the program would write it (diameter where it programs diameters).
[[nodiscard]] double programmed_coordinate(const Run&, const std::string& axis);

// --- arithmetic (arithmetic.cpp)
[[nodiscard]] double binary_number(Run&, const program::Expr&, double a, double b);
[[nodiscard]] Value binary_value(Run&, const program::Expr&, const Value& a, const Value& b);

// --- variables (assign.cpp, definitions.cpp)
void assign(Run&, const program::Assign&);
void create_variable(Run&, program::NameId, double value);
/// An assignment whose right side, and the number of whose parameter, are known already.
void assign_value(Run&, const program::Assign&, double index, double value);
/// Sets a numbered parameter to `v`, the value of `value`; one that the job sets keeps that where `value` is a
/// constant.
void assign_number(Run&, std::uint32_t parameter, ExprId value, double v, const base::Span& where);
/// Converts and stores; alarm where the value does not fit.
/// Sets a parameter that holds text (QS5).
void assign_text(Run&, ExprId target, const std::string& text);
void store(Run&, Array& array, std::size_t index, Value v, const base::Span& where);
void define(Run&, const program::Define&, Scope& scope, const Unit& unit);
[[nodiscard]] const Binding* find_variable(const Run&, program::NameId);
/// Index of the addressed element; false after an alarm.
[[nodiscard]] bool element_of(Run&, const program::Expr&, const Array&, std::size_t& index);
[[nodiscard]] std::size_t undefined_key(Run&, const program::Expr&);
/// One more index than the STRING has dimensions: a single character of it.
[[nodiscard]] bool is_character_access(const Binding&, const program::Expr&);
[[nodiscard]] Value read_character(Run&, const Binding&, const program::Expr&);

// --- flow (interp.cpp, flow.cpp, calls.cpp)
void step(Run&);  ///< the next statement of the program
/// Ends the run where it has made too many blocks or, if the clock is looked at, taken too long.
bool over_budget(Run&, bool check_clock);
void run_statement(Run&, const program::Statement&, std::uint32_t index);
void jump(Run&, const program::Jump&);
/// Counts a backward branch of the statement being run; ends the run past the budget.
void count_pass(Run&);
void call_label(Run&, const program::LabelCall&, std::uint32_t index);
void end_label(Run&);  ///< LBL 0
void call_program(Run&, const program::Call&);
void enter(Run&, const Unit&, const program::Call* call, const base::Span& where);
void leave(Run&);
void set_modal_call(Run&, const Unit&, const program::Call&);
void run_modal_call(Run&);
void procedure(Run&, const program::ProcedureCall&);

// --- sizes of the tool (control_parameters.cpp)
/// Radius of a mill with the allowance of its table, mm; nothing where the list does not say it.
[[nodiscard]] std::optional<double> mill_radius(const shop::Tool&);
/// Radius of the mill in the spindle with all allowances, mm; NaN where it is not known.
[[nodiscard]] double active_radius(const Run&);
/// Length of the tool in the spindle with all allowances, mm; NaN where no tool data are at hand.
[[nodiscard]] double active_length(const Run&);
/// What the control says of itself, lengths in mm; NaN where it is not known here.
[[nodiscard]] double control_value(const Run&, program::ControlValue);

// --- blocks (block.cpp, modal_words.cpp, tools.cpp, motion.cpp, frame_words.cpp)
void run_block(Run&, const program::Statement&, std::uint32_t index);
void modal_word(Run&, const program::Word&);
/// What a word of the modal state does, without the block it stands in; false where `m` is none.
[[nodiscard]] bool apply_mode(Run&, Modal m, int number);
void set_plane(Run&, int plane);
/// M70 and M73, M71, M72 (saved_modes.cpp).
void save_modes(Run&, bool for_call);
void forget_modes(Run&);
void restore_modes(Run&);
/// The spindle's state as a record (tools.cpp).
void emit_spindle(Run&);
void coolant(Run&, int m);
void frame_statement(Run&, const program::Statement&, std::uint32_t index);
void update_frame(Run&);
void select_tool(Run&);
/// G41 D: the radius is that of the tool or offset with this number.
void take_offset_radius(Run&, double number);
/// $TC_DPn[T, D]=value.
void write_tool_parameter(Run&, double number, double edge, int n, double value);
/// n of $TC_DPn: the digits at the end of the name.
[[nodiscard]] int tool_parameter_number(const std::string& name);
void technology(Run&);
/// mm/min (mm per revolution, 1/min) of a feed of 1.
[[nodiscard]] double feed_factor(const Run&);
void after_motion(Run&);
[[nodiscard]] bool motion(Run&);  ///< true where the block moved
/// Gathers one word into the block; shared by blocks and frame statements.
void gather(Run&, const program::Statement&, const program::Word&);

/// A block with data of its own (special.cpp).
void run_special(Run&, const program::Statement&, std::uint32_t index);

// --- cycles (cycle.cpp, transform.cpp)
void define_cycle(Run&, const program::CycleDefinition&);
/// The cycle defined last, where the tool stands.
void call_cycle(Run&);
/// A cycle that acts at its definition; false where obrys does not run it.
[[nodiscard]] bool act_at_definition(Run&, const ActiveCycle&);
/// Datum shift by a row of the datum table (datums.cpp).
void shift_by_table(Run&, const program::CycleDefinition&, double row);
/// Shift that is in force and can be changed, and a new one in its place (transform.cpp).
[[nodiscard]] geom::Vec3 active_shift(const Run&);
void set_shift(Run&, const geom::Vec3&);
/// Ends shift, mirror, rotation and scaling; a tilted plane stays.
void keep_plane_alone(Run&);
/// A datum of the control's own: settable offset or preset (modal_words.cpp).
void set_datum(Run&, std::uint32_t number);
/// Where the selected datum lies in the machine; NaN where that is not known (frame_words.cpp).
[[nodiscard]] geom::Vec3 datum_origin(const Run&);
/// Cycle 247: a preset by its number, which ends shift, mirror, rotation and scaling (datums.cpp).
void select_preset(Run&, const program::CycleDefinition&, double number);
/// The tilted working plane in force, and a new one in its place.
[[nodiscard]] geom::Frame active_plane(const Run&);
void tilt(Run&, const geom::Frame&);

// --- what is refused though each word is good (refusals.cpp); they end the run
/// Before a modal word acts.
void refuse_modal(Run&, const program::Word&);
/// Before the words of a block act together (Traits::refuses_unready).
void refuse_block(Run&);
/// A subprogram that is nowhere (Traits::missing_program_stops).
void refuse_call(Run&, const std::string& name, const program::Call* call);
/// The main program runs past its last block (Unit::unended).
void refuse_end(Run&);

// --- where cycles are called (pattern.cpp, cycle_places.cpp), contours of several (contour_formula.cpp)
void define_pattern(Run&, const program::Pattern&);
/// CYCL CALL POS: goes to the position of the block and calls the cycle there.
void call_cycle_at_position(Run&);
/// CYCL CALL PAT: calls the cycle at every point of the pattern.
void call_cycle_at_pattern(Run&);
void contour_statement(Run&, const program::ContourStatement&);
/// The program that a text names, path and suffix or not; null after a complaint.
[[nodiscard]] const Unit* find_named_program(Run&, const std::string& written, const base::Span& where);

// --- what the control writes into parameters (control_parameters.cpp)
void control_sets(Run&, std::initializer_list<program::ControlValue>);
void control_sets_all(Run&);

// --- procedures of the control (datums.cpp, output.cpp, table_access.cpp)
void set_own_datum(Run&, const program::ProcedureCall&);
/// Text at the end of a file that the program prints to; `again`: the file begins anew.
void print_to(Run&, const program::ProcedureCall&, const std::string& file, std::string_view text, bool again);
void print_form(Run&, const program::ProcedureCall&);
void print_values(Run&, const program::ProcedureCall&);
void open_table(Run&, const program::ProcedureCall&);
void write_table(Run&, const program::ProcedureCall&);
void read_table(Run&, const program::ProcedureCall&);

// --- offsets kept in parameters (offsets.cpp, set_data.cpp, home.cpp)
/// A, B and C among the nine axes.
[[nodiscard]] inline bool is_rotary(std::size_t axis) { return axis >= 3 && axis < 6; }
/// mm (degrees) of a machine coordinate of 1 in a parameter.
[[nodiscard]] inline double stored_unit(const Run& run, std::size_t axis) {
    return is_rotary(axis) ? 1 : run.env.machine_unit;
}
/// Where the tip stands against the point that the control moves.
[[nodiscard]] inline const Axes& tip_in_use(const Offsets& o) { return o.tip_known ? o.tip : o.tool; }
/// G54 (54) is 1, G59.3 (593) is 9; G54.1 P1 (5401) is 1001.
[[nodiscard]] inline std::uint32_t place_of_datum(std::uint32_t number) {
    return number >= 5401 ? number - 5401 + 1001 : number >= 591 ? number - 584 : number - 53;
}
[[nodiscard]] inline bool keeps_offsets(const Run& run) { return run.traits->offsets.datum_first != 0; }
/// Takes what the parameters hold at the start of the run.
void begin_offsets(Run&);
/// Programmed frame -> stream; also sets Offsets::total.
[[nodiscard]] geom::Frame offset_frame(Run&);
/// The active zero offset anew from its parameters.
void load_datum(Run&);
/// G92 … G92.3, G52; G43 … G49: the words of the block.
void shift_words(Run&, Modal);
void tool_length_words(Run&, Modal);
void set_tool_offset(Run&, const Axes& to);
/// The tool in the spindle was changed: where its tip is.
void take_tip(Run&);
/// G10.
void set_data(Run&, program::DataTable table);
/// G28, G30, G28.1, G30.1.
void go_home(Run&);
void store_home(Run&);
/// Programmed coordinate of an axis (0 … 8) as the program would write it now; NaN where it is not known.
[[nodiscard]] double axis_coordinate(const Run&, std::size_t axis);
/// The same in machine coordinates, mm or degrees.
[[nodiscard]] double machine_coordinate(const Run&, std::size_t axis);
/// Values of the block's axis words as absolute lengths in mm (degrees); nothing where an axis has no word.
[[nodiscard]] std::optional<double> axis_word(const Run&, std::size_t axis);

/// A parameter that is empty (Traits::empty_parameters), alone or with a sign.
[[nodiscard]] bool is_empty(Run&, ExprId);

// --- what the control shows of itself (live_parameters.cpp)
[[nodiscard]] bool is_live(const Run&, std::uint32_t parameter);
/// What probing and inputs leave there can be overwritten.
[[nodiscard]] bool may_be_written(const Run&, std::uint32_t parameter);
/// What the program wrote over live parameters of this kind no longer holds: the control has written them.
void forget_live(Run&, program::SystemVariable what);
[[nodiscard]] double live_parameter(Run&, std::uint32_t parameter, const base::Span& where);
[[nodiscard]] Value live_value(Run&, program::SystemVariable, double index, const base::Span& where);

// --- cycles that motion blocks call (canned.cpp)
/// False where the block's words call no cycle.
[[nodiscard]] bool canned_motion(Run&);
/// G12, G13 (circle_pocket.cpp).
[[nodiscard]] bool circle_pocket(Run&);
/// G70 … G72, G76 of lathes (turning.cpp).
[[nodiscard]] bool turning_cycle(Run&);
/// A turning cycle that acts at its definition (turning_definition.cpp).
void define_turning_cycle(Run&, const ActiveCycle&);
/// The contour of a finishing cycle has been run: back to where the cycle began.
void end_finishing(Run&, const ActiveSection&);
/// Statements of the program at hand with this block number, in order.
[[nodiscard]] std::vector<std::uint32_t> numbered_statements(const Run&, double n);

// --- splines (spline.cpp)
/// G5, G5.1, G5.2 … G5.3, G6.2.
[[nodiscard]] bool spline_motion(Run&);

// --- what is set besides moves (tell.cpp); nothing where nobody wants to know
void tell(Run&, cl::SettingKind, int number = 0, std::initializer_list<double> values = {});
void tell(Run&, cl::SettingKind, int number, const Axes& values);
void tell_tool_entry(Run&, int place, int tool, std::initializer_list<double> values);
/// In inverse time mode: the feed per minute that follows from the length of the programmed move, mm.
void tell_inverse_feed(Run&, double length);
/// What the end of the program sets back.
void tell_end(Run&, int m);
/// What is in force when the run begins.
void begin_telling(Run&);
/// How programmed coordinates become those of the stream.
void tell_frame(Run&);
/// M48 … M53: what the operator may change.
void switch_override(Run&, cl::SettingKind, bool on);
/// F, S, T and M of the block, in the order in which they act.
void tell_technology(Run&);

// --- output (emit.cpp)
void emit(Run&, cl::Step step);
/// Once, before the first move: the datum in which all coordinates of the stream are.
void emit_datum(Run&);
/// Emits what a path stage (compensation, rounding) still holds back.
void flush_path(Run&);

[[nodiscard]] inline Code axis_code(int k) { return static_cast<Code>(static_cast<int>(Code::x) + k); }
[[nodiscard]] inline double& coordinate(geom::Vec3& v, int k) { return k == 0 ? v.x : k == 1 ? v.y : v.z; }
[[nodiscard]] inline double coordinate(const geom::Vec3& v, int k) { return k == 0 ? v.x : k == 1 ? v.y : v.z; }

}  // namespace obrys::interp
