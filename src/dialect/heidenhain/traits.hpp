#pragma once
/// How a HEIDENHAIN iTNC 530 runs a block, as far as it differs from other controls. docs/dialects/heidenhain.md.

#include <array>

#include "dialect/heidenhain/functions.hpp"
#include "program/traits.hpp"

namespace obrys::dialect::heidenhain {

/// Number in the stream of preset 0: the numbers below are those of other controls.
inline constexpr std::uint32_t first_preset = 1000;

/// Q108 … Q122: iTNC 530 User's Manual, "Preassigned Q parameters".
inline constexpr std::array control_parameters{
    program::ControlParameter{108, program::ControlValue::tool_radius},
    program::ControlParameter{109, program::ControlValue::tool_axis},
    program::ControlParameter{110, program::ControlValue::spindle_state},
    program::ControlParameter{111, program::ControlValue::coolant_state},
    program::ControlParameter{112, program::ControlValue::pocket_overlap},
    program::ControlParameter{113, program::ControlValue::main_unit},
    program::ControlParameter{114, program::ControlValue::tool_length},
    program::ControlParameter{115, program::ControlValue::probed},
    program::ControlParameter{116, program::ControlValue::probed},
    program::ControlParameter{117, program::ControlValue::probed},
    program::ControlParameter{118, program::ControlValue::probed},
    program::ControlParameter{119, program::ControlValue::probed},
    program::ControlParameter{120, program::ControlValue::tilted_axis},
    program::ControlParameter{121, program::ControlValue::tilted_axis},
    program::ControlParameter{122, program::ControlValue::tilted_axis},
};

/// Parameters: iTNC 530 pilot (NC software 340 49x-07), Q Q0-Q1999, QL0-QL499 local, QR0-QR499. Equality: the control
/// computes with a limited number of digits; two values that differ by less than 1e-9 count as equal (docs).
inline constexpr program::Traits traits{
    .equality = {1e-12, 1e-9},
    .banks = {program::ParameterBank{"Q", 2000}, {"QL", 500, true}, {"QR", 500}},
    .jump_to_block_number = false,
    .end_stops_all = true,
    .unit_per_program = true,
    .compensation_window = 99,
    .text_letters = "QS",
    .label_depth = 19,
    .polar_from_position = true,
    .datum = {.prefix = "preset ",
              .article = "",
              .key = "preset",
              .first = first_preset,
              .none = "the active preset",
              .none_key = "active_preset",
              .none_is_machine_zero = false},
    .set_by_control = control_parameters,
    .alarm_text = error_message,
};

}  // namespace obrys::dialect::heidenhain
