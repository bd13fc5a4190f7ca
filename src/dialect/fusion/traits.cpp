#include "dialect/fusion/traits.hpp"

#include <array>

#include "dialect/fusion/cycles.hpp"

namespace obrys::dialect::fusion {

namespace {

using cl::CycleKind;
using cl::CycleRole;
using program::CannedCycle;
using program::CannedWord;
using program::Code;

// The words are the reader's own: R the retract plane, Z the bottom, both absolute.
constexpr CannedWord ends_at{Code::e, CycleRole::return_level, true, 1};
constexpr CannedWord dwell{Code::p, CycleRole::dwell_bottom, false, 1};
constexpr CannedWord surface{Code::i1, CycleRole::surface, true, 1};
constexpr CannedWord infeed{Code::q, CycleRole::infeed, true, 1};
constexpr CannedWord decrement{Code::j, CycleRole::decrement, true, 1};
constexpr CannedWord least{Code::k, CycleRole::min_infeed, true, 1};
constexpr CannedWord back{Code::i, CycleRole::chip_break_distance, true, 1};
constexpr CannedWord stop{Code::j1, CycleRole::stop_distance_first, true, 1};

constexpr std::array plain{ends_at, dwell, surface};
constexpr std::array pecks{ends_at, dwell, infeed, decrement, least, stop};
constexpr std::array chips{ends_at, dwell, infeed, decrement,
                           least,   back,  stop,   CannedWord{Code::i1, CycleRole::retract_every, true, 1}};
constexpr std::array threads{ends_at,
                             dwell,
                             surface,
                             infeed,
                             CannedWord{Code::i, CycleRole::chip_break_turns, false, 1},
                             CannedWord{Code::k1, CycleRole::pitch, true, 1}};
constexpr std::array beside{ends_at, dwell, surface, CannedWord{Code::i, CycleRole::shift_u, true, 1},
                            CannedWord{Code::j, CycleRole::shift_v, true, 1}};

/// In the order of Hole.
constexpr std::array canned{
    CannedCycle{0, CycleKind::canned_drill, "drilling", plain, {}},
    CannedCycle{1, CycleKind::canned_peck, "deep-drilling", pecks, {}},
    CannedCycle{2, CycleKind::canned_chip_break, "chip-breaking", chips, {}},
    CannedCycle{3, CycleKind::canned_tap_rigid, "tapping", threads, {}},
    CannedCycle{4, CycleKind::canned_tap_floating, "tapping", plain, {}},
    CannedCycle{5, CycleKind::canned_bore_feed, "boring", plain, {}},
    CannedCycle{6, CycleKind::canned_bore_stop, "stop-boring", plain, {}},
    CannedCycle{7, CycleKind::canned_bore_orient, "fine-boring", beside, {}},
};

constexpr program::Traits common(program::GuessedMachine machine) {
    return {
        .guessed_machine = machine,
        .repeated_words = program::Repeated::last_counts,
        .banks = {program::ParameterBank{}, {}, {}},
        .named_variables = program::NamedVariables::none,
        .jump_to_block_number = false,
        .end_stops_all = true,
        .may_end_anywhere = true,
        .datum = {.prefix = "work offset ",
                  .article = "",
                  .key = "work_offset_",
                  .first = 53,
                  .none = "the part's zero",
                  .none_key = "part_zero",
                  .none_is_machine_zero = false},
        .stops_before_motion = true,
        .definitions_describe = true,
        .feed_mode_ends_surface_speed = false,
        .radius_at_start = true,
        .radius_makes_arc = false,
        .clearance_at_start = true,
        .pitch_along = program::PitchAlong::farthest_axis,
        .canned = canned,
    };
}

}  // namespace

const program::Traits traits = common(program::GuessedMachine::mill);
const program::Traits turning_traits = common(program::GuessedMachine::lathe);

}  // namespace obrys::dialect::fusion
