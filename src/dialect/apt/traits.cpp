#include "dialect/apt/traits.hpp"

#include <array>

#include "dialect/apt/cycles.hpp"

namespace obrys::dialect::apt {

namespace {

using cl::CycleKind;
using cl::CycleRole;
using program::CannedCycle;
using program::CannedWord;
using program::Code;

constexpr CannedWord retract{Code::e, CycleRole::return_level, true, 1};
constexpr CannedWord surface{Code::i1, CycleRole::surface, true, 1};
constexpr CannedWord dwell{Code::p, CycleRole::dwell_bottom, false, 1};
constexpr CannedWord infeed{Code::q, CycleRole::infeed, true, 1};
constexpr CannedWord decrement{Code::j, CycleRole::decrement, true, 1};
constexpr CannedWord least{Code::k, CycleRole::min_infeed, true, 1};

constexpr std::array plain{retract, dwell, surface};
constexpr std::array pecks{
    retract, surface, dwell, infeed, decrement, least, CannedWord{Code::i, CycleRole::stop_distance_first, true, 1}};
constexpr std::array chips{
    retract, surface, dwell, infeed, decrement, least, CannedWord{Code::i, CycleRole::chip_break_distance, true, 1}};
constexpr std::array threads{retract, dwell,
                             surface, CannedWord{Code::i, CycleRole::pitch, true, 1},
                             infeed,  CannedWord{Code::k1, CycleRole::chip_break_turns, false, 1}};

/// In the order of Hole.
constexpr std::array canned{
    CannedCycle{0, CycleKind::canned_drill, "CYCLE/DRILL", plain, {}},
    CannedCycle{1, CycleKind::canned_peck, "CYCLE/DEEP", pecks, {}},
    CannedCycle{2, CycleKind::canned_chip_break, "CYCLE/BRKCHP", chips, {}},
    CannedCycle{3, CycleKind::canned_tap_rigid, "CYCLE/TAP", threads, {}},
    CannedCycle{4, CycleKind::canned_tap_floating, "CYCLE/TAP", plain, {}},
    CannedCycle{5, CycleKind::canned_bore_feed, "CYCLE/REAM", plain, {}},
    CannedCycle{6, CycleKind::canned_bore_stop, "CYCLE/BORE", plain, {}},
};

/// SPINDL/ORIENT,angle.
constexpr std::array function_letters{program::FunctionLetters{19, 19, "R"}};

constexpr program::Traits common(program::GuessedMachine machine) {
    return {
        .guessed_machine = machine,
        .repeated_words = program::Repeated::last_counts,
        .banks = {program::ParameterBank{}, {}, {}},
        .named_variables = program::NamedVariables::none,
        .jump_to_block_number = false,
        .end_stops_all = true,
        .may_end_anywhere = true,
        .datum = {.prefix = "zero ",
                  .article = "",
                  .key = "zero",
                  .none = "the part's zero",
                  .none_key = "part_zero",
                  .none_is_machine_zero = false},
        .stops_before_motion = true,
        .definitions_describe = true,
        .feed_mode_ends_surface_speed = false,
        .function_letters = function_letters,
        .radius_at_start = true,
        .radius_makes_arc = false,
        .clearance_at_start = true,
        .canned = canned,
    };
}

}  // namespace

const program::Traits traits = common(program::GuessedMachine::mill);
const program::Traits turning_traits = common(program::GuessedMachine::lathe);

}  // namespace obrys::dialect::apt
