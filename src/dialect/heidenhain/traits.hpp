#pragma once
/// How a HEIDENHAIN iTNC 530 runs a block, as far as it differs from other controls. docs/dialects/heidenhain.md.

#include <array>
#include <iterator>

#include "dialect/heidenhain/functions.hpp"
#include "program/traits.hpp"

namespace obrys::dialect::heidenhain {

/// Number in the stream of preset 0: the numbers below are those of other controls.
inline constexpr std::uint32_t first_preset = 1000;

/// Q108 … Q122, Q150 … Q199: iTNC 530 User's Manual, "Preassigned Q parameters".
inline constexpr auto control_parameters = [] {
    using enum program::ControlValue;
    constexpr program::ControlParameter single[]{
        {108, tool_radius}, {109, tool_axis},   {110, spindle_state}, {111, coolant_state}, {112, pocket_overlap},
        {113, main_unit},   {114, tool_length}, {115, probed},        {116, probed},        {117, probed},
        {118, probed},      {119, probed},      {120, tilted_a},      {121, tilted_b},      {122, tilted_c},
    };
    constexpr std::uint32_t first_result = 150, last_result = 199;  // of touch probe cycles
    std::array<program::ControlParameter, std::size(single) + last_result - first_result + 1> all{};
    std::size_t n = 0;
    for (const program::ControlParameter& p : single) all[n++] = p;
    for (std::uint32_t q = first_result; q <= last_result; ++q) all[n++] = {q, probed};
    return all;
}();

/// Q and QR hold what ran before has left there; QL begin anew with every program. Numbers count through the banks.
inline constexpr std::array kept_parameters{program::KeptParameters{0, 1999, {}, false},
                                            program::KeptParameters{2500, 2999, {}, false}};

/// iTNC 530 User's Manual, "M functions for program run control, spindle and coolant".
inline constexpr std::array spindle_stops{program::SpindleStop{0, false, true, true},
                                          program::SpindleStop{1, false, false},
                                          program::SpindleStop{.function = 6, .does_more = true}};

/// M137 and M111: iTNC 530 User's Manual, overview of the M functions, "effective at block end" (m_functions.cpp).
inline constexpr std::array modes_behind_motion{program::Modal::feed_per_minute, program::Modal::feed_at_tool};

/// Parameters: iTNC 530 pilot (NC software 340 49x-07), Q Q0-Q1999, QL0-QL499 local, QR0-QR499. Equality: the control
/// computes with a limited number of digits; two values that differ by less than 1e-9 count as equal (docs).
inline constexpr program::Traits traits{
    .guessed_machine = program::GuessedMachine::mill,  // TOOL CALL 1 Y is a tool axis, not a lathe
    .equality = {1e-12, 1e-9},
    .banks = {program::ParameterBank{"Q", 2000}, {"QL", 500, true}, {"QR", 500}},
    .named_variables = program::NamedVariables::none,
    .jump_to_block_number = false,
    .end_stops_all = true,
    .text_end_ends_program = true,
    .unit_per_program = true,
    .compensation_window = 99,
    .text_letters = "QS",
    .label_depth = 19,
    .dimensions_per_program = true,
    .arcs_about_pole = true,
    .inch_feed = 2.54,  // 1/10 inch/min: iTNC 530 manual 60642x-03, page 506 (M116)
    .needs_pole = true,
    .polar_from_position = true,
    .datum = {.prefix = "preset ",
              .article = "",
              .key = "preset",
              .first = first_preset,
              .none = "the active preset",
              .none_key = "active_preset",
              .none_is_machine_zero = false},
    .machine_words_are_gauge_point = true,
    .kept = kept_parameters,
    .modes_behind_motion = modes_behind_motion,
    .indexed_tools = true,
    .spindle_stops = spindle_stops,
    .compensation_keeps_side = true,
    .calls_end_compensation = true,
    .feed_at_tool_first = true,
    .corner_keeps_feed = true,  // F holds until another one is reached, and "the previous feed" behind RND F
    .first_tool_says_axis = true,
    .set_by_control = control_parameters,
    .alarm_text = error_message,
};

}  // namespace obrys::dialect::heidenhain
