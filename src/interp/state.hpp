#pragma once
/// The state of one run, in floors: each holds what one concern changes and stands on those below, whose values and
/// functions it may use. A function takes the lowest floor that has all it needs, so its parameter says what it may
/// touch. A copy of RunState is a place to go back to. Private to interp.

#include <array>
#include <cstdint>
#include <deque>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

#include "base/work_time.hpp"
#include "interp/block_words.hpp"
#include "interp/call_state.hpp"
#include "interp/cycle_state.hpp"
#include "interp/heard.hpp"
#include "interp/interp.hpp"
#include "interp/machine_state.hpp"
#include "interp/modes.hpp"
#include "interp/selected_zero.hpp"
#include "interp/value.hpp"
#include "interp/variables.hpp"
#include "path/element.hpp"
#include "program/modal_group.hpp"

namespace obrys::interp {

class PathStage;
class Complaints;
struct Captured;
class Onward;

/// What the run keeps through all its states: copying the state around it neither takes it along nor brings it back.
template <class T>
struct Apart : T {
    using T::operator=;
    Apart() = default;
    Apart(const Apart&) : T() {}
    Apart(Apart&&) noexcept : T() {}
    Apart& operator=(const Apart&) noexcept { return *this; }
    Apart& operator=(Apart&&) noexcept { return *this; }
    ~Apart() = default;
    void take(const T& other) { T::operator=(other); }
};

/// What stands around a run; settled before the first block, except for what has been said.
struct Around {
    explicit Around(const Environment& e) : env(e) {}
    Around(const Around&) = default;
    Around& operator=(const Around&) noexcept { return *this; }
    ~Around() = default;

    const Environment& env;
    const program::Traits* traits = nullptr;   ///< of the main program
    std::uint64_t known_axes = 0;              ///< bit per Code of X … W: the machine has it
    cl::CallStacks* stacks = nullptr;          ///< never null
    base::Diagnostics* diagnostics = nullptr;  ///< never null
};

/// Why blocks are looked at without being run (capture.hpp).
enum class Look : std::uint8_t {
    no,                 ///< they are run
    next_element,       ///< what comes behind the block being run, and is run then
    milled_contour,     ///< of a contour cycle
    turned_subprogram,  ///< the contour of a turning cycle: U and W are steps along X and Z, A and C belong to the
                        ///< corner
    turned_blocks,      ///< the same in the program's own blocks
};

/// Where the run is in its programs, and what it says of them (complaints.cpp).
struct Saying : Around, CallState {
    explicit Saying(const Environment& e) : Around(e) {}

    const program::Statement* statement = nullptr;  ///< being run
    bool stopped = false;                           ///< alarm, budget or program end
    Ending ending = Ending::regular;
    bool repeats = false;            ///< the main program would begin anew: one pass of it is run
    std::uint32_t repeats_from = 0;  ///< … at this byte of it
    bool complained = false;         ///< something of the block is said not to be understood or run
    Look look = Look::no;
    /// Set while blocks are only looked at: what is complained about goes there (complaints.hpp).
    Complaints* complaints = nullptr;
    Apart<std::unordered_set<std::uint64_t>> reported;  ///< complaints already made, by place and code
    Apart<std::set<std::string>> assumed;
    /// Of programs that jump to a computed block number: statements by it.
    mutable std::unordered_map<const Unit*, std::unordered_map<std::int64_t, std::vector<std::uint32_t>>> block_numbers;

    [[nodiscard]] Activation& top() { return calls.back(); }
    [[nodiscard]] const Unit& unit() const { return *calls.back().unit; }
    [[nodiscard]] base::Span here() const { return unit().span(*statement); }
};

/// What expressions can ask for: variables, and the machine as the program has set it up.
struct Reckoning : Saying, ToolRack {
    Reckoning(const Environment& e, std::uint32_t parameter_count, const geom::Vec3& start)
        : Saying(e), ToolRack(e.tools), parameters(parameter_count), position(start), programmed_position(start) {}

    Undefined undefined;
    Parameters parameters;
    std::unordered_map<std::uint64_t, Value> system_written;  ///< system variables the program wrote itself
    std::unordered_map<std::uint32_t, double> global_values;  ///< of GLOBAL DEF, by parameter
    std::string last_message;                                 ///< of MSG
    std::string log_file;                                     ///< that the program has opened; empty: none
    std::string open_table;                                   ///< freely definable table (FN 26)
    std::string datum_table;   ///< selected by the program; empty: the one that is active on the control
    bool clock_asked = false;  ///< a value was the date or the time, which texts may show and no way may depend on
    std::uint64_t unknown_conditions = 0;  ///< that were met
    std::uint64_t blocks = 0;
    bool out_of_time = false;  ///< the clock has said so: every step ends the run
    base::WorkTime time;       ///< since it began

    ModalState modal;
    program::Modes modes{};  ///< what words of the program mean by, where its reader asks for that
    /// By ModeSpan::use: what a block found and left as the modes are now, so that its like need not look again.
    std::array<const program::ModeUse*, 4> modes_fit{};
    Offsets offsets;
    SpindleState spindle;
    OtherSpindles spindles;
    bool coolant_on = false, mist = false, flood = false;
    Overrides overrides;
    std::map<std::string, double> axis_feeds;  ///< FA[axis], mm/min or degrees/min
    double feed = 0;                           ///< mm/min, mm/rev or 1/min by modal.feed_mode
    bool feed_valid = false;
    double feed_number = 0;     ///< F as the program wrote it last, whatever unit has come since
    bool feed_unknown = false;  ///< the last F depends on a value that is not known
    bool feed_dropped = false;  ///< G94/G95 changed and the stream does not know yet that F is void

    geom::Vec3 position;             ///< stream frame, mm; NaN where unknown
    geom::Vec3 programmed_position;  ///< in the programmed frame
    /// Axes of which no word has come since another tool was taken, for which the machine may have gone anywhere, or
    /// since a zero that lies nobody knows where.
    std::array<bool, 3> unsaid_since_change{};
    cl::AxisEnds ends;                                        ///< of the axes that the next move takes along
    std::pair<std::uint32_t, std::string> changed_to{0, {}};  ///< number and name of that tool
    std::set<std::uint32_t> tools_called;                     ///< by their numbers, up to here
    geom::Frame frame;                                        ///< programmed frame -> stream frame
    bool frame_is_identity = true;
    geom::Vec3 tool_axis{0, 0, 1};        ///< in the stream's frame: normal to a tilted working plane
    std::uint32_t reference_datum = 500;  ///< the datum in which the stream's coordinates are
    bool datum_known = true;              ///< the active datum's place against it is known
    bool probed = false;  ///< a probing move was run to its end, where the probe may have stopped before
    std::unordered_map<std::string, double> extra_axes;
    std::vector<double>
        aimed_at;  ///< radians by joint of the machine's chain, for the plane in force; empty: not known
    std::array<double, 3> tilted_axes{unknown_number, unknown_number, unknown_number};  ///< of A, B, C in degrees
    std::optional<geom::Vec2> free_pole;                                                ///< FPOL
    /// Where it is set, elements go there and nothing is emitted (capture.hpp).
    std::vector<Captured>* capture = nullptr;

    Apart<shop::GivenValues> given;  ///< what the job and backups of the control give
    Apart<std::unordered_map<program::NameId, double>> overrides_by_name;
    Apart<std::vector<std::uint8_t>> parameter_overridden;
    Apart<std::vector<double>> parameter_override;
    Apart<std::set<std::string>> printed_files;  ///< that the program has begun to print to
    Apart<std::set<std::string>> overrides_met;  ///< names whose constant was replaced
};

/// What the stream is told, and how moves come into it.
struct Telling : Reckoning {
    Telling(const Environment& e, std::uint32_t parameter_count, const geom::Vec3& start, cl::Sink to);
    Telling(const Telling&) = default;
    Telling(Telling&&) noexcept = default;
    Telling& operator=(const Telling&) = default;
    Telling& operator=(Telling&&) noexcept = default;
    ~Telling();

    StreamFrame told;
    geom::Vec3 sent{unknown_number, unknown_number, unknown_number};  ///< end of the last move handed out, stream frame
    bool moved = false;
    bool datum_complained = false;  ///< that the datum's place is not known is said since the program selected it
    FeedShape feed_shape;
    SurfaceMode surface;
    std::vector<CarriedCompensation> carried;
    /// Where it is set, records come from there instead of the block being run (cycles/along_contour.cpp).
    const ContourElement* along = nullptr;
    cl::Record record;

    cl::Sink sink;                           ///< takes the records
    std::optional<Listener> listener;        ///< hears what the control is told
    Apart<std::unique_ptr<PathStage>> path;  ///< holds back what is to come out
};

/// The words of the block at hand and the moves that they make.
struct Moving : Telling {
    using Telling::Telling;

    BlockWords block;
    PlainKinds plain_kinds;
    CannedState canned;
    ControlCurve curve;
    geom::Vec3 last_spline_end;         ///< P and Q of the last G5, mm
    path::EndDirection last_direction;  ///< of the last move in the working plane, for CT
    SolvedContour free_contour;
    std::map<std::string, base::Span> underway;            ///< axes that POSA has sent, and nothing waited for yet
    std::array<std::array<double, 7>, 2> rounding_said{};  ///< what note_rounding has looked at last, feed and rapid
    Onward* onward = nullptr;                              ///< never null
};

/// A loop whose conditions nothing within it changes: while the run stays in it, it does not end.
struct WatchedLoop {
    std::size_t depth = 0;  ///< of the call that runs it; 0: none is watched
    std::uint32_t first = 0, last = 0;
    std::uint64_t passes = 0;  ///< without having left it
};

/// What the run remembers of loops (calls/loop_marks.cpp).
struct LoopMarks {
    using Place = std::pair<const Unit*, std::uint32_t>;
    bool broke = false, passed = false;     ///< by a break, by a continue
    std::map<Place, std::uint64_t> left;    ///< passes of repeat_count statements, the one being run not counted
    std::map<Place, std::uint32_t> labels;  ///< statement that has taken Branch::same_label
};

/// Calls of programs, loops and ends.
struct Calling : Moving {
    using Moving::Moving;

    LoopMarks marks;

    ModalCall modal_call;
    WatchedLoop watched;
    std::set<std::pair<const Unit*, std::uint32_t>> ends_told;  ///< behind which blocks are said that are never run
    Apart<std::unordered_set<const Unit*>> entered;
};

/// What cycles keep from their definition to their calls.
struct Cycling : Calling {
    using Calling::Calling;

    ActiveCycle cycle;                        ///< the last one that is active on call
    std::vector<std::string> contour_labels;  ///< of the contour that contour cycles work on
    const Unit* contour_unit = nullptr;       ///< the program whose labels these are
    ActiveCycle contour_data, contour_train_data;
    /// What CONTOUR DEF, or DECLARE CONTOUR and formulas, say the contour is; empty: `contour_labels` do.
    std::vector<ContourChoice> contour_choices;
    CallPattern pattern;
    std::map<std::string, std::vector<CallPattern::Point>> point_tables;  ///< read so far
    /// Values of turning cycles that stay with the control (CycleDefinition::store), mm, by store and role.
    std::map<std::pair<int, cl::CycleRole>, KeptSetting> cycle_store;
};

/// Pieces of programs as they are read in other states than that of the text (read_again.cpp).
struct ReadPieces {
    struct Key {
        const Unit* unit = nullptr;
        std::uint32_t statement = 0;
        program::Modes relied{};  ///< 0 where the piece does not ask
        [[nodiscard]] bool operator<(const Key& other) const {
            return std::tie(unit, statement, relied) < std::tie(other.unit, other.statement, other.relied);
        }
    };
    std::map<Key, std::deque<program::PieceRead>> pieces;
    std::size_t count = 0;
};

/// All that running a block changes and that the next one depends on. Whoever looks ahead copies it whole
/// (look_ahead.cpp), and a machine that is copied goes on from there (machine.hpp). Programs that it points to do not
/// change.
struct RunState : Cycling {
    using Cycling::Cycling;

    std::uint64_t steps = 0;  ///< statements gone through, those of rehearsals too
    std::shared_ptr<ReadPieces> read_pieces = std::make_shared<ReadPieces>();  ///< of copies, too: it only grows
};

/// A whole run: its state, and where its records go.
struct Run : RunState {
    Run(const Environment& e, cl::CallStacks& s, cl::Sink k, base::Diagnostics& d, std::uint32_t parameter_count);
    /// Goes on from where another one stands, between two of its steps.
    Run(const Run& other, cl::CallStacks& s, cl::Sink k, base::Diagnostics& d);
    ~Run();

    SelectedZero zero;  ///< what records go through
    std::unique_ptr<Onward> ahead;
};

}  // namespace obrys::interp
