#pragma once
/// The state of one run: values only. Private to interp; what works on it is declared in run.hpp.

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <deque>
#include <initializer_list>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "base/work_time.hpp"
#include "geom/frame.hpp"
#include "geom/nurbs.hpp"
#include "interp/call_state.hpp"
#include "interp/interp.hpp"
#include "interp/modes.hpp"
#include "interp/selected_zero.hpp"
#include "interp/value.hpp"
#include "interp/variables.hpp"
#include "program/modal_group.hpp"

namespace obrys::interp {

using program::Code;
using program::ExprId;
using program::Modal;
using program::Unit;

inline constexpr std::uint64_t linear_axes =
    bit(Code::x) | bit(Code::y) | bit(Code::z);  ///< words, as BlockWords::present

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
    mutable std::uint64_t used = 0;          ///< of these, those that something has acted on
    std::uint64_t twice = 0;                 ///< of these, those that the block has more than once
    std::uint32_t groups = 0;                ///< bit per program::ModalGroup that the block has a word of
    bool complained = false;                 ///< something of the block is said not to be understood or run
    std::array<double, 64> value;            ///< by Code; valid where the bit is set
    std::array<std::uint8_t, 64> reference;  ///< 0 = as the modal state says, else 1 + program::Reference
    std::vector<int> m;
    std::vector<int> h;
    std::vector<NamedAxis> axes;  ///< additional axes by name
    std::string tool_name;
    bool tool_named = false;
    int special_number = 0;
    int retract = 0;                     ///< M140: 1 by its distance, 2 to the limit; 0: none
    int surface_word = 0;                ///< 96 or 97 where the block says it
    bool acted = false;                  ///< F, S, T and M have acted already (Code::act)
    std::optional<double> feed_alone;    ///< FB, as written
    std::optional<double> thread_start;  ///< SF, degrees
    bool stops_run = false;              ///< STOP without a function
    bool rapid = false;                  ///< its arc, approach or departure is run in rapid (C … FMAX)
    bool says_straight = false;          ///< G0 or G1 stands in the block
    bool polar_path = false;             ///< its path function takes polar coordinates alone (LP, CP, CTP)
    bool changes_plane = false;          ///< to another one
    bool machine_axis = false;           ///< a linear axis by the name it has in the machine
    std::vector<NamedAxis> positioned;   ///< linear axes that move on their own (POS, POSA); name: of the axis
    bool goes_on = false;                ///< … and the program does not wait for one of them
    std::vector<PendingAssign> pending;
    Modal special = Modal::linear;       ///< dwell, reference point, fixed point, pole; linear: none
    Modal suppress = Modal::linear;      ///< suppress_frames, suppress_all; linear: none
    Modal corner_end = Modal::linear;    ///< corner_crossing, corner_open; linear: none
    std::optional<Modal> motion_behind;  ///< the motion in force from the next block on: this one has its own
    Modal paraxial = Modal::linear;      ///< paraxial, paraxial_longer, paraxial_shorter; linear: none

    [[nodiscard]] bool has(Code c) const { return (present >> static_cast<unsigned>(c)) & 1u; }
    /// The value of a word that acts now: it counts as used (unused_words.cpp).
    [[nodiscard]] double get(Code c) const {
        use(c);
        return value[static_cast<std::size_t>(c)];
    }
    /// The value of a word that is only looked at; something else has to use it.
    [[nodiscard]] double peek(Code c) const { return value[static_cast<std::size_t>(c)]; }
    void use(Code c) const { used |= bit(c); }
    [[nodiscard]] bool has_m(int number) const { return std::find(m.begin(), m.end(), number) != m.end(); }
    [[nodiscard]] std::uint8_t ref(Code c) const { return reference[static_cast<std::size_t>(c)]; }
    void put(Code c, double v, std::uint8_t r = 0) {
        const auto i = static_cast<std::size_t>(c);
        twice |= present & std::uint64_t{1} << i;
        present |= std::uint64_t{1} << i;
        value[i] = v;
        reference[i] = r;
    }
    void clear();
};

/// MCALL: the call that follows every block with motion.
struct ModalCall {
    const Unit* unit = nullptr;
    std::vector<Value> arguments;  ///< as they were when MCALL stood in the program
    std::vector<std::uint8_t> given;
    base::Span where;
    /// With Traits::argument_parameters: the called program's own parameters, which stay from call to call.
    std::vector<std::pair<double, bool>> parameters;
    std::uint64_t repeats = 0;  ///< further runs of each call
};

/// A cycle as its definition left it.
struct ActiveCycle {
    const program::CycleDefinition* definition = nullptr;
    const Unit* unit = nullptr;
    std::vector<double> values;      ///< per setting, as it was at the definition
    std::vector<double> written;     ///< … and what stood there: the number behind FU, FZ
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
    double retract = 0;        ///< R, mm: a position where Traits::canned_positions_stay, else as written
    double bottom = 0;         ///< coordinate of the tool axis, mm: the same
    double initial_level = 0;  ///< of the tool axis when the series began, mm
    bool has_retract = false, has_bottom = false;
    bool bottom_from_retract = false;  ///< it was said in G91
    std::array<double, 12> values{};   ///< by word of the cycle; mm, degrees, s
    std::array<bool, 12> given{};
    std::optional<double> last_dwell;  ///< P of the last cycle that had one, s
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
    std::uint32_t prepared_edge = 1;
    bool waiting = false;
    const shop::Tool* data = nullptr;
    // What nobody has said is not 0: the control holds it from before.
    bool known = false;                       ///< program or job have said which tool is in the spindle
    bool edge_known = false;                  ///< … and which of its edges is in force
    std::optional<std::uint32_t> selected{};  ///< number of the tool that T has prepared last
    double delta_length = 0, delta_radius = 0, delta_corner = 0;  ///< allowances of the call, mm
    double feed = 0;                                              ///< given with the tool (F AUTO), mm/min; 0: none
};

/// What the feed of the stream follows from besides F.
struct FeedShape {
    bool on = false;             ///< something of it was programmed
    bool in_cycle = false;       ///< whose steps have their own feeds
    double programmed = 0;       ///< F of the stream
    double told = 0;             ///< the feed that the stream has now
    geom::Vec3 at;               ///< where the stream stands
    double plunge = 1, arc = 1;  ///< of the element being sent: ModalState::plunge_part, path radius by contour radius
};

/// Polar and cylindrical interpolation: the program moves in a plane that linear and rotary axis make together
/// (surface.cpp).
struct SurfaceMode {
    enum class Kind : std::uint8_t { none, polar, cylinder };
    Kind kind = Kind::none;
    double start = 0;   ///< of C where it was switched on, degrees: the plane's first axis points there
    double angle = 0;   ///< of C where the stream stands, degrees
    double radius = 0;  ///< of the cylinder, mm
    int plane = 18;     ///< before it
    geom::Vec3 at;      ///< where the stream stands in the plane
};

class PathStage;
class Complaints;
struct Captured;
struct ContourElement;
struct FreeContour;

/// The tools that the run knows, and the one in the spindle, which points into their list: also in a copy.
struct ToolRack {
    ToolState tool;
    std::vector<shop::Tool> tools;  ///< of the job, with what the program writes to $TC_DPn

    explicit ToolRack(const std::vector<shop::Tool>& listed) : tools(listed) {}
    ToolRack(const ToolRack& other) : tool(other.tool), tools(other.tools) { point_into_list(other); }
    ToolRack(ToolRack&&) noexcept = default;
    ToolRack& operator=(const ToolRack& other) {
        if (this == &other) return *this;
        tool = other.tool;
        tools = other.tools;
        point_into_list(other);
        return *this;
    }
    ToolRack& operator=(ToolRack&&) noexcept = default;
    ~ToolRack() = default;

private:
    void point_into_list(const ToolRack& other) {
        if (tool.data != nullptr) tool.data = tools.data() + (tool.data - other.tools.data());
    }
};

/// A free contour that is being solved; a copy is solved by itself.
struct SolvedContour {
    std::shared_ptr<FreeContour> at_hand;  ///< null: none

    SolvedContour() = default;
    SolvedContour(const SolvedContour& other);  // free_contour.cpp
    SolvedContour(SolvedContour&&) noexcept = default;
    SolvedContour& operator=(const SolvedContour& other) { return *this = SolvedContour(other); }
    SolvedContour& operator=(SolvedContour&&) noexcept = default;
    ~SolvedContour() = default;
};

/// The zero and the frame that the stream has been told, before its moves.
struct StreamFrame {
    bool begun = false;
    bool current = false;  ///< nothing has changed since
    cl::Datum first, datum;
    std::vector<cl::FramePart> parts;
    base::SharedValue<cl::Cycle> cycle;  ///< the last one
    std::uint32_t open_cycles = 0;       ///< brackets
    cl::ToolLength length;
    std::optional<cl::PathMode> path;
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

/// All that running a block changes and that the next one depends on. A copy is a place to go back to: whoever looks
/// ahead copies it whole (capture.hpp), and a machine that is copied goes on from there (machine.hpp). Programs that it
/// points to do not change.
struct RunState : ToolRack, CallState {
    RunState(const std::vector<shop::Tool>& listed, std::uint32_t parameter_count, const geom::Vec3& start)
        : ToolRack(listed), parameters(parameter_count), position(start), programmed_position(start) {}

    /// A loop whose conditions nothing within it changes: while the run stays in it, it does not end.
    struct WatchedLoop {
        std::size_t depth = 0;  ///< of the call that runs it; 0: none is watched
        std::uint32_t first = 0, last = 0;
        std::uint64_t passes = 0;  ///< without having left it
    };
    WatchedLoop watched;
    std::vector<CarriedCompensation> carried;
    Undefined undefined;
    Parameters parameters;
    std::unordered_map<std::uint64_t, Value> system_written;  ///< system variables the program wrote itself

    ModalState modal;
    program::Modes modes{};  ///< what words of the program mean by, where its reader asks for that
    Offsets offsets;
    BlockWords block;
    SpindleState spindle;
    OtherSpindles spindles;
    bool coolant_on = false, mist = false, flood = false;
    Overrides overrides;
    bool clock_asked = false;  ///< a value was the date or the time, which texts may show and no way may depend on
    std::array<std::array<double, 7>, 2> rounding_said{};  ///< what note_rounding has looked at last, feed and rapid
    std::map<std::string, base::Span> underway;            ///< axes that POSA has sent, and nothing waited for yet
    std::map<std::string, double> axis_feeds;              ///< FA[axis], mm/min or degrees/min
    double feed = 0;                                       ///< mm/min, mm/rev or 1/min by modal.feed_mode
    FeedShape feed_shape;
    SurfaceMode surface;
    bool feed_valid = false;
    double feed_number = 0;     ///< F as the program wrote it last, whatever unit has come since
    bool feed_unknown = false;  ///< the last F depends on a value that is not known
    bool feed_dropped = false;  ///< G94/G95 changed and the stream does not know yet that F is void
    ModalCall modal_call;
    ActiveCycle cycle;                        ///< the last one that is active on call
    std::vector<std::string> contour_labels;  ///< of the contour that contour cycles work on
    CannedState canned;
    ControlCurve curve;
    geom::Vec3 last_spline_end;          ///< P and Q of the last G5, mm
    const Unit* contour_unit = nullptr;  ///< the program whose labels these are
    std::string datum_table;             ///< selected by the program; empty: the one that is active on the control
    std::string open_table;              ///< freely definable table (FN 26)
    ActiveCycle contour_data, contour_train_data;
    std::unordered_map<std::uint32_t, double> global_values;  ///< of GLOBAL DEF, by parameter
    CallPattern pattern;
    std::map<std::string, std::vector<CallPattern::Point>> point_tables;  ///< read so far
    /// What CONTOUR DEF, or DECLARE CONTOUR and formulas, say the contour is; empty: `contour_labels` do.
    std::vector<ContourChoice> contour_choices;

    geom::Vec3 position;  ///< stream frame, mm; NaN where unknown
    geom::Vec3 sent{std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(),
                    std::numeric_limits<double>::quiet_NaN()};  ///< end of the last move handed out, stream frame
    geom::Vec3 programmed_position;                             ///< in the programmed frame
    geom::Frame frame;                                          ///< programmed frame -> stream frame
    bool frame_is_identity = true;
    geom::Vec3 tool_axis{0, 0, 1};        ///< in the stream's frame: normal to a tilted working plane
    std::uint32_t reference_datum = 500;  ///< the datum in which the stream's coordinates are
    bool datum_known = true;              ///< the active datum's place against it is known
    bool datum_complained = false;        ///< that it is not is said since the program selected it
    bool moved = false;
    StreamFrame told;
    bool probed = false;  ///< a probing move was run to its end, where the probe may have stopped before
    std::unordered_map<std::string, double> extra_axes;
    std::vector<double>
        aimed_at;  ///< radians by joint of the machine's chain, for the plane in force; empty: not known
    std::array<double, 3> tilted_axes{std::numeric_limits<double>::quiet_NaN(),
                                      std::numeric_limits<double>::quiet_NaN(),
                                      std::numeric_limits<double>::quiet_NaN()};  ///< of A, B, C in degrees
    geom::Vec2 last_direction;  ///< of the last move in the working plane, for CT
    Look look = Look::no;
    /// Where it is set, elements go there and nothing is emitted (capture.hpp).
    std::vector<Captured>* capture = nullptr;
    /// Set with `capture`: what is complained about goes there (complaints.hpp).
    Complaints* complaints = nullptr;
    /// Where it is set, records come from there instead of the block being run (contour_cycle.hpp).
    const ContourElement* along = nullptr;
    SolvedContour free_contour;
    std::optional<geom::Vec2> free_pole;  ///< FPOL
    /// Values of turning cycles that stay with the control (CycleDefinition::store), mm, by store and role.
    std::map<std::pair<int, cl::CycleRole>, double> cycle_store;

    const program::Statement* statement = nullptr;  ///< being run
    bool stopped = false;                           ///< alarm, budget or program end
    Ending ending = Ending::regular;
    std::uint64_t blocks = 0;
    std::uint64_t steps = 0;   ///< statements gone through, those of rehearsals too
    bool out_of_time = false;  ///< the clock has said so: every step ends the run
    /// Of programs that jump to a computed block number: statements by it.
    mutable std::unordered_map<const Unit*, std::unordered_map<std::int64_t, std::vector<std::uint32_t>>> block_numbers;
    std::set<std::pair<const Unit*, std::uint32_t>> ends_told;  ///< behind which blocks are said that are never run
    std::uint64_t unknown_conditions = 0;                       ///< that were met
    std::string last_message;                                   ///< of MSG
    std::string log_file;                                       ///< that the program has opened; empty: none
    cl::Record record;
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

/// What a run works with: its state, what stands around it, and what it hands out.
struct Run : RunState {
    Run(const Environment& e, cl::CallStacks& s, cl::Sink k, base::Diagnostics& d, std::uint32_t parameter_count);
    /// Goes on from where another one stands, between two of its steps.
    Run(const Run& other, cl::CallStacks& s, cl::Sink k, base::Diagnostics& d);
    ~Run();

    // Around it; settled before the first block.
    const Environment& env;
    const program::Traits* traits = nullptr;  ///< of the main program
    std::uint64_t known_axes = 0;             ///< bit per Code of X … W: the machine has it
    shop::GivenValues given;                  ///< what the job and backups of the control give
    std::unordered_map<program::NameId, double> overrides_by_name;
    std::vector<std::uint8_t> parameter_overridden;
    std::vector<double> parameter_override;
    base::WorkTime time;  ///< since it began

    // Handed out, or kept so that it is handed out once.
    cl::CallStacks& stacks;
    SelectedZero zero;  ///< what records go through
    cl::Sink sink;
    base::Diagnostics& diagnostics;
    std::unique_ptr<PathStage> path;             ///< holds back what is to come out
    std::set<std::string> overrides_met;         ///< names whose constant was replaced
    std::set<std::string> printed_files;         ///< that the program has begun to print to
    std::unordered_set<std::uint64_t> reported;  ///< complaints already made, by place and code
    std::set<std::string> assumed;
    std::unordered_set<const Unit*> entered;
    std::shared_ptr<ReadPieces> read_pieces = std::make_shared<ReadPieces>();  ///< of copies, too: it only grows

    [[nodiscard]] Activation& top() { return calls.back(); }
    [[nodiscard]] const Unit& unit() const { return *calls.back().unit; }
    [[nodiscard]] base::Span here() const { return unit().span(*statement); }
};

}  // namespace obrys::interp
