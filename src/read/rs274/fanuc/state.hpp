#pragma once
/// What the parts of the FANUC reader share with each other only. What a word means may depend on what stands earlier
/// in the program (units, hole cycles, systems): that is asked through FanucModes alone, which notes it for the run.

#include <array>

#include "base/function_ref.hpp"
#include "dialect/rs274/fanuc.hpp"
#include "read/rs274/fanuc/modes.hpp"
#include "read/rs274/fanuc/plain_block.hpp"
#include "read/rs274/state.hpp"

namespace obrys::read::rs274 {

using dialect::rs274::FanucControl;
using dialect::rs274::FanucG;
using dialect::rs274::FanucMUse;
using dialect::rs274::FanucSpecial;
using dialect::rs274::FanucUse;
using dialect::rs274::WholeNumbers;
using program::DataTable;

/// A letter and its value as written; what it means is known when the whole block is.
struct Address {
    char letter = 0;     ///< upper case
    bool comma = false;  ///< `,C` `,R`
    bool used = false;
    Value value;
    std::uint32_t begin = 0, end = 0;
};

/// A G code that is more than a word, where it stands.
struct Special {
    const FanucG* g = nullptr;
    Address address;
};

/// Words of its own that a function without effect on the path has in the block: G5.1 Q1, M19 R90.
struct OwnWords {
    std::string_view letters;
    std::uint32_t begin = 0, end = 0;  ///< of the function
    bool orients = false;              ///< P or R is the angle of the spindle, degrees
};
inline constexpr std::string_view read_twice =
    "a motion, cycle or function of the block reads one of its letters, too: write two blocks";

struct FanucLoop {
    int number = 0;  ///< m of DO m
    std::uint32_t statement = 0;
    bool has_condition = false;
    base::Span word;
};
struct FanucIf {
    std::uint32_t statement = 0, else_statement = program::no_target;
    base::Span word;
};
/// A jump whose target is looked for when the program has been read.
struct PendingJump {
    std::size_t jump = 0;  ///< in Unit::jumps
    std::uint32_t number = 0;
};
struct NumberedBlock {
    std::uint32_t number = 0, statement = 0;
};
/// A call of a section by the number of its first block (M97).
struct PendingLabel {
    std::size_t entry = 0;  ///< in Unit::label_calls
    std::uint32_t number = 0;
};

/// What C means: an axis, or part of a plane that the control makes of two axes.
enum class Surface : std::uint8_t { none, polar, cylinder };

/// What the block behind a corner has to be: any way at feed; straight along X alone, or along Z alone.
enum class Corner : std::uint8_t { none, at_feed, then_x, then_z };

struct FanucState : State {
    FanucState(std::uint32_t file_number, const FanucControl& c, program::Names& n, base::Diagnostics& d,
               const base::Sources& all)
        : State(file_number, dialect::rs274::fanuc_dialect(c), n, d, all), control(c) {}

    FanucControl control;

    // In force where the text stands.
    FanucModes modes{};
    UnitMode inch{modes};
    ModeField<bool, Mode::per_rev> per_rev{modes};
    ModeField<bool, Mode::incremental> incremental{modes};
    ModeField<bool, Mode::polar> polar{modes};
    ModeField<int, Mode::plane> plane{modes};
    HoleMode hole{modes};
    ModeField<bool, Mode::rigid> rigid{modes};
    ModeField<int, Mode::turning> turning{modes};
    ModeField<bool, Mode::lost> lost{modes};
    ModeField<bool, Mode::lost_motion> lost_motion{modes};
    ModeField<Surface, Mode::surface> surface{modes};
    ModeField<int, Mode::surface_plane> surface_plane{modes};
    RadiusMode cylinder{modes};
    ModeField<bool, Mode::to_clearance> to_clearance{modes};
    ModeField<bool, Mode::cleared_cycle> cleared_cycle{modes};
    ModeField<bool, Mode::new_cycle> new_cycle{modes};
    MotionMode motion{modes};
    ModeField<Corner, Mode::corner_waits> corner_waits{modes};
    ModeField<int, Mode::transformed> transformed{modes};

    // Of the text as a whole.
    bool whole_number_said = false;
    bool pointed_speed_said = false;  ///< of S with a point, too
    bool c_is_axis = false;  ///< of lathes: C is no chamfer
    bool corner_said = false;
    bool draws = false;  ///< of lathes: A is an angle, so that R and C are words of direct drawing input

    PlainBlocks plain{};  ///< of the program at hand

    // The block at hand.
    std::vector<Address> addresses;
    /// `/` between them: how many stand in front of it, and its level + 1.
    std::optional<std::pair<std::size_t, std::uint8_t>> slash;
    std::string called;  ///< `<NAME>` behind M98, G65, G66; empty: none
    std::uint32_t called_begin = 0, called_end = 0;
    std::vector<Special> special;
    std::vector<OwnWords> own_words;
    bool hole_apart = false;              ///< its P, K and R are not those of the hole cycle in force
    std::optional<bool> brackets_match;   ///< ( and ) of its comments
    int depth = 0;                        ///< of IF … THEN within it
    std::optional<Address> corner;        ///< its chamfer or corner R, with or without comma
    bool own_motion = false;              ///< a G code of the motion group stands in it
    bool restore_motion = false;          ///< `motion` holds again behind it
    std::vector<Address> behind;          ///< M functions that act behind the motion
    std::optional<std::uint32_t> number;  ///< N
    ExprId condition = no_expr;           ///< `[ … ]` in front of M99 P (Haas)

    // The program at hand.
    std::vector<FanucLoop> loops;
    std::vector<FanucIf> ifs;
    std::vector<NumberedBlock> block_numbers;  ///< in the order of the text; as its jumps need them at its end
    std::vector<PendingJump> jumps;
    std::vector<PendingLabel> labels;
    std::vector<std::uint32_t> section_labels;  ///< block numbers that become labels: first and last ones of contours
    bool calls_labels = false;                  ///< M97 stands in it: M99 ends a section
};

/// The hole cycle whose words the block's are; 0: none.
[[nodiscard]] inline int hole_of(const FanucState& s) { return s.hole_apart ? 0 : s.hole; }
/// In which the control begins a run.
[[nodiscard]] program::Modes modes_at_start(const FanucControl& control);

// fanuc_again.cpp
/// Reads pieces of the text's units anew.
[[nodiscard]] std::shared_ptr<const program::ReadAgain> reader_of_pieces(const FanucState& s);

// fanuc_block.cpp
void read_fanuc_block(FanucState& s, std::uint32_t begin, std::uint32_t end);
/// The addresses from here to the block's end, put into `addresses`.
/// `/2 N100`, `N100 /2`.
void read_head(FanucState& s);
void note_number(FanucState& s);
void read_addresses(FanucState& s);
/// The first one of a letter that nobody has used; null where there is none.
[[nodiscard]] Address* find_address(FanucState& s, char letter);
/// Puts what `addresses` hold into the tree; the words of the line's statements begin at its begin.
void emit_addresses(FanucState& s);
/// What `make` adds to the tree depends on what it asks of the modes, and changes them, as one piece.
void as_piece(FanucState& s, base::FunctionRef<void()> make);
/// A statement whose entry is `index` of its kind's table, covering the line.
void add_control(FanucState& s, StatementKind kind, std::size_t index);

// fanuc_words.cpp
/// Lengths, angles, feeds and times written without a point.
enum class Quantity : std::uint8_t { length, angle, feed, milliseconds, thousandths, plain };
[[nodiscard]] Quantity quantity_of(const FanucState& s, char letter);
[[nodiscard]] Value scaled(FanucState& s, const Value& v, Quantity q);
/// One address of a block with motion or settings.
void emit_address(FanucState& s, Address& a);
/// Q of a thread's block, in degrees (special.cpp); nothing after a complaint.
std::optional<Value> start_angle(FanucState& s, Address& q);
/// ROUND in an address rounds to the least input increment.
void round_to_increments(FanucState& s, const Address& a);
/// Marks addresses as used.
void use_letters(FanucState& s, std::string_view letters);
/// Axis words that nobody has taken, beside a G code that does not take them: said, and the block does not move.
void refuse_axes(FanucState& s, std::string_view why);
void put_value(FanucState& s, Order order, Code code, const Value& v, const Address& a);

// fanuc_corner.cpp
/// Chamfers, roundings and angles of straight blocks; false where the address is none of them.
[[nodiscard]] bool corner_word(FanucState& s, const Address& a);
/// A chamfer or corner R before this block and in it: which blocks it may stand between, and what else in its block.
void judge_block_behind_corner(FanucState& s);
void judge_corner(FanucState& s);
/// The same before a call and a return.
void judge_call_behind_corner(FanucState& s, const Address& call);
/// A of a lathe's program is the angle of a straight line.
[[nodiscard]] bool uses_line_angles(std::string_view text);
/// C of a lathe's program is an axis by how the text uses it.
[[nodiscard]] bool uses_c_axis(std::string_view text);

// fanuc_g.cpp, fanuc_special.cpp
void read_g_code(FanucState& s, Address& a);
void read_m_code(FanucState& s, Address& a);
/// G number * 10; nothing where it is computed.
[[nodiscard]] std::optional<int> g_tenths(const Address& a);
/// The G codes that are more than a word, in the order of the block.
void run_specials(FanucState& s);
/// `own_words` of the block, as far as its motion or cycle leaves them.
void take_own_words(FanucState& s);

// fanuc_frames.cpp
void frame_special(FanucState& s, const FanucG& g, const Address& a);

// fanuc_tilt.cpp
/// G68.2, G53.1 and their like; false where it is none.
[[nodiscard]] bool tilt_special(FanucState& s, const FanucG& g, const Address& a);
/// The tilted plane ends where one is in force.
void end_tilt(FanucState& s, const Address& a);
/// Words that a block within a tilted plane has, and that are not known there.
void refuse_in_tilt(FanucState& s);

/// Radius or angle for an axis letter while polar coordinates hold.
[[nodiscard]] std::optional<Code> polar_code(const FanucState& s, char letter);
/// F as the program has written it last.
[[nodiscard]] Value feed_in_force(FanucState& s, std::uint32_t begin, std::uint32_t end);

/// A number in least input increments: so many decimals in mm and in inches.
[[nodiscard]] Value in_increments(FanucState& s, const Value& v, int metric, int inch);

// fanuc_repetitive.cpp
/// G70 … G76 of lathes.
void repetitive_cycle(FanucState& s, const FanucG& g, const Address& a);

// fanuc_turning.cpp
void turning_special(FanucState& s, const FanucG& g, const Address& a);
/// A block with coordinates while a turning cycle is in force.
[[nodiscard]] bool turning_block(FanucState& s);

// fanuc_surface.cpp
/// A G code that cannot stand within polar or cylindrical interpolation is said; true then.
[[nodiscard]] bool refused_on_surface(FanucState& s, const FanucG& g, const Address& a);
/// Arcs and sides of the plane Z-C as they are in C-Z, which the tree has.
[[nodiscard]] FanucG as_seen_on_surface(const FanucState& s, FanucG g);
void surface_special(FanucState& s, const FanucG& g, const Address& a);
/// An address within; false where it means what it means elsewhere.
[[nodiscard]] bool surface_word(FanucState& s, const Address& a);

// fanuc_lathe_hole.cpp
/// G81 … G89 of lathes: a block with coordinates while one is in force; false where it has none.
[[nodiscard]] bool lathe_hole(FanucState& s);

// fanuc_call.cpp
/// G65, G66, M97, M98, M99 of the block; false where there is none.
[[nodiscard]] bool read_calls(FanucState& s);

// fanuc_macro.cpp
/// A macro statement (assignment, IF, WHILE, GOTO, DPRNT …); false where the block is none.
[[nodiscard]] bool read_macro_statement(FanucState& s);
/// What stands from here on: a macro statement or words.
void read_rest(FanucState& s);
/// `( … )` that stands here, without its brackets; empty where there is none.
[[nodiscard]] std::string take_comment(FanucState& s);

// fanuc_system.cpp
/// What a system variable says, as an expression; no_expr where it is an ordinary parameter.
[[nodiscard]] ExprId system_parameter(State& s, std::uint32_t number, std::uint32_t begin);
/// `#3000 = …` and its like, which act; false where `number` is not one of them.
[[nodiscard]] bool assign_system(FanucState& s, std::uint32_t number);

// fanuc_flow.cpp
void read_if(FanucState& s);
void read_while(FanucState& s);
void read_do(FanucState& s);
void read_end(FanucState& s);
void read_goto(FanucState& s, ExprId condition);
void read_else(FanucState& s);
void read_endif(FanucState& s);
/// Closes what is open at the program's end and finds the targets of its jumps.
void close_program(FanucState& s);

}  // namespace obrys::read::rs274
