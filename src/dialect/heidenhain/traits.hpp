#pragma once
/// How a HEIDENHAIN iTNC 530 runs a block, as far as it differs from other controls. docs/dialects/heidenhain.md.

#include "program/traits.hpp"

namespace obrys::dialect::heidenhain {

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
    .inch_feed = 2.54,  // 1/10 inch/min: iTNC 530 manual 60642x-03, page 506 (M116)
    .needs_pole = true,
    .polar_from_position = true,
};

}  // namespace obrys::dialect::heidenhain
