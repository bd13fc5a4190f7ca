#include "dialect/rs274/linuxcnc.hpp"

namespace obrys::dialect::rs274 {

namespace {

using program::LiveParameters;
using program::SystemVariable;

/// Manual "G-code overview", numbered parameters.
constexpr std::array live{
    LiveParameters{5021, 9, SystemVariable::machine_coordinate},
    LiveParameters{5061, 9, SystemVariable::probed_coordinate},
    LiveParameters{5070, 1, SystemVariable::probe_success},
    LiveParameters{5399, 1, SystemVariable::input_value},
    LiveParameters{5400, 14, SystemVariable::tool_table_column},
    LiveParameters{5420, 9, SystemVariable::coordinate},
};

/// Functions of the control's own that leave the path alone: pallets, outputs, overrides, saved modes.
constexpr std::array<std::int16_t, 17> own_functions{48, 49, 50, 51, 52, 53, 60, 61, 62,
                                                     63, 64, 65, 66, 67, 68, 70, 71};

// Canned cycles: LinuxCNC, G-Codes, "Canned cycles"; what the control adds by itself is what its interpreter prints.
using cl::CycleKind;
using cl::CycleRole;
using cl::CycleValue;
using program::CannedWord;
using program::Code;
constexpr double peck_clearance = 0.254;  // mm: 0.010 inch

constexpr std::array dwell_word{CannedWord{Code::p, CycleRole::dwell_bottom, false, 1}};
constexpr std::array peck_words{CannedWord{Code::q, CycleRole::infeed, true, 1}};
constexpr std::array bore_stop_words{CannedWord{Code::p, CycleRole::dwell_bottom, false, 1}};
constexpr std::array back_bore_words{CannedWord{Code::i, CycleRole::shift_u, true, 1},
                                     CannedWord{Code::j, CycleRole::shift_v, true, 1},
                                     CannedWord{Code::k, CycleRole::counterbore_top, true, 1}};
constexpr std::array rise{CycleValue{CycleRole::rise_first, 1}};
constexpr std::array chip_break{CycleValue{CycleRole::rise_first, 1},
                                CycleValue{CycleRole::chip_break_distance, peck_clearance}};
constexpr std::array peck{CycleValue{CycleRole::rise_first, 1},
                          CycleValue{CycleRole::stop_distance_first, peck_clearance}};
constexpr std::array tap_dwell{CannedWord{Code::p, CycleRole::dwell, false, 1}};
constexpr std::array tap_right{CycleValue{CycleRole::rise_first, 1}, CycleValue{CycleRole::spindle_direction, 1},
                               CycleValue{CycleRole::feed_out, 1}, CycleValue{CycleRole::dwell, 0}};
constexpr std::array tap_left{CycleValue{CycleRole::rise_first, 1}, CycleValue{CycleRole::spindle_direction, -1},
                              CycleValue{CycleRole::feed_out, 1}, CycleValue{CycleRole::dwell, 0}};
constexpr std::array feed_out{CycleValue{CycleRole::rise_first, 1}, CycleValue{CycleRole::feed_out, 1}};

constexpr std::array canned{
    program::CannedCycle{730, CycleKind::canned_chip_break, "G73", peck_words, chip_break, true},
    program::CannedCycle{740, CycleKind::canned_tap_floating, "G74", tap_dwell, tap_left, false, true},
    program::CannedCycle{810, CycleKind::canned_drill, "G81", {}, rise},
    program::CannedCycle{820, CycleKind::canned_drill, "G82", dwell_word, rise},
    program::CannedCycle{830, CycleKind::canned_peck, "G83", peck_words, peck, true},
    program::CannedCycle{840, CycleKind::canned_tap_floating, "G84", tap_dwell, tap_right, false, true},
    program::CannedCycle{850, CycleKind::canned_bore_feed, "G85", {}, rise},
    program::CannedCycle{860, CycleKind::canned_bore_stop, "G86", bore_stop_words, rise},
    program::CannedCycle{870, CycleKind::canned_back_bore, "G87", back_bore_words, feed_out},
    program::CannedCycle{880, CycleKind::canned_bore_manual, "G88", dwell_word, rise},
    program::CannedCycle{890, CycleKind::canned_bore_feed, "G89", dwell_word, feed_out},
};

constexpr std::array finish_words{CannedWord{Code::offset_d, CycleRole::allowance_first, true, 1},
                                  CannedWord{Code::e, CycleRole::allowance_last, true, 1},
                                  CannedWord{Code::p, CycleRole::passes, false, 1}};
constexpr std::array rough_words{
    CannedWord{Code::i, CycleRole::infeed, true, 1}, CannedWord{Code::radius, CycleRole::escape, true, 1},
    CannedWord{Code::offset_d, CycleRole::allowance_side, true, 1}, CannedWord{Code::w, CycleRole::offset_u, true, 1},
    CannedWord{Code::u, CycleRole::offset_v, true, 1}};
constexpr std::array thread_words{CannedWord{Code::p, CycleRole::pitch, true, 1},
                                  CannedWord{Code::i, CycleRole::crest_offset, true, 1, true},
                                  CannedWord{Code::j, CycleRole::first_depth, true, 1, true},
                                  CannedWord{Code::k, CycleRole::thread_depth, true, 1, true},
                                  CannedWord{Code::radius, CycleRole::degression, false, 1},
                                  CannedWord{Code::q, CycleRole::infeed_angle, false, 1},
                                  CannedWord{Code::offset_h, CycleRole::spring_passes, false, 1},
                                  CannedWord{Code::e, CycleRole::taper_length, true, 1},
                                  CannedWord{Code::l, CycleRole::taper_ends, false, 1}};
constexpr std::array all_pockets{CycleValue{CycleRole::pockets, 0}};
constexpr std::array no_pockets{CycleValue{CycleRole::pockets, 1}};
constexpr std::array only_pockets{CycleValue{CycleRole::pockets, 2}};

constexpr std::array turning{
    program::CannedCycle{700, CycleKind::lathe_finish_offset, "G70", finish_words, {}},
    program::CannedCycle{710, CycleKind::lathe_rough_along, "G71", rough_words, all_pockets},
    program::CannedCycle{711, CycleKind::lathe_rough_along, "G71.1", rough_words, no_pockets},
    program::CannedCycle{712, CycleKind::lathe_rough_along, "G71.2", rough_words, only_pockets},
    program::CannedCycle{720, CycleKind::lathe_rough_across, "G72", rough_words, all_pockets},
    program::CannedCycle{721, CycleKind::lathe_rough_across, "G72.1", rough_words, no_pockets},
    program::CannedCycle{722, CycleKind::lathe_rough_across, "G72.2", rough_words, only_pockets},
    program::CannedCycle{760, CycleKind::lathe_thread_degressive, "G76", thread_words, {}},
};

}  // namespace

/// Manual "Parameters", numbered parameters: those that the machine keeps in its parameter file. #1 to #5000 are
/// volatile: 0 when LinuxCNC is started, and then what the last program has left there. A call sets #1 to #30.
constexpr std::array kept{
    program::KeptParameters{1, 5000, "nothing left there since LinuxCNC was started"},
    program::KeptParameters{5161, 5169},  // G28
    program::KeptParameters{5181, 5189},  // G30
    program::KeptParameters{5210, 5390},  // G92, the active system, G54 to G59.3
};

/// LinuxCNC, M-codes: orientation, overrides, outputs and inputs; M100 … M199 take P and Q.
constexpr std::array function_letters{
    program::FunctionLetters{19, 19, "RPQ"}, program::FunctionLetters{48, 53, "P"},
    program::FunctionLetters{62, 65, "P"},   program::FunctionLetters{66, 66, "PELQ"},
    program::FunctionLetters{67, 68, "EQ"},
};

/// Comparisons hold within 0.000001 (measured). The last parameter is #5601.
constexpr program::Traits traits{
    .guessed_machine = program::GuessedMachine::by_words,
    .equality = {0, 1e-6, true},
    .banks = {program::ParameterBank{"#", 5602}, {}, {}},
    .named_variables = program::NamedVariables::in_angles,
    .jump_to_block_number = false,
    .end_stops_all = true,
    .may_end_anywhere = true,
    .polar_from_position = true,
    .datum = {.prefix = "G",
              .key = "G",
              .none = "G54",
              .none_key = "G54",
              .more_by_decimals = true,
              .none_is_machine_zero = false},
    .assigns_together = true,
    .variables_by_assignment = true,
    .argument_parameters = 30,
    .parameters_begin_at_one = true,
    .programs_by_number = true,
    .modal_calls_nest = true,
    .repeats_program = "M99",
    .parameters_begin_at_zero = true,
    .kept = kept,
    .live = live,
    .offsets = {.datum_first = 5221,
                .datum_step = 20,
                .datum_count = 9,
                .rotation = 9,
                .active_datum = 5220,
                .shift_first = 5211,
                .shift_active = 5210,
                .home_first = 5161,
                .home_second = 5181},
    .stops_before_motion = true,
    .changes_on_m6 = true,
    .dwell_in_feed_words = false,
    .tool_change_stops_spindle = true,
    .feed_mode_ends_surface_speed = false,
    .own_functions = own_functions,
    .pallet_stop = 60,  // LinuxCNC, M-codes: M60 exchanges pallets and pauses, M30 exchanges them and ends
    .pallet_end = 30,
    .function_letters = function_letters,
    .builders_letters = "PQ",
    .compensation_holds_move = true,
    .modulo_is_positive = true,
    .radius_at_start = true,
    .blends_without_limit = true,
    .loops_remember = true,
    .call_levels = 10,  // interp_internal.hh, INTERP_SUB_ROUTINE_LEVELS; run
    .arc_turns_in_p = true,
    .clearance_at_start = true,
    .arc_tolerance = 0.02828427125,
    .arc_tolerance_inch = 0.002828427125 * 25.4,
    .bad_block_stops = true,
    .missing_program_stops = true,
    .needs_feed = true,
    .compensation_forbids_canned = true,
    .refuses_unready = true,
    .pitch_along = program::PitchAlong::move,
    .cancel_leaves_no_motion = true,
    .hole_ends_at_least_at_retract_plane = true,
    .tap_keeps_dwell = true,
    .tool_number_function = 61,
    .canned = canned,
    .turning = turning,
};
const program::Traits linuxcnc_traits = traits;

const Dialect linuxcnc{
    .control = "LinuxCNC",
    .traits = &linuxcnc_traits,
    .g = linuxcnc_g,
    .g_index = &linuxcnc_g_index,
    .m = linuxcnc_m,
    .operators = linuxcnc_operators,
    .functions = linuxcnc_functions,
    .predefined = linuxcnc_predefined,
    .read_only = linuxcnc_read_only,
    .letters = linuxcnc_letters,
    .longest_line = 252,  // measured: 253 are refused
};

}  // namespace obrys::dialect::rs274
