#pragma once
/// What controls truly do differently when a block is run: one small table that travels with the program.

#include <cstdint>

namespace obrys::program {

struct Traits {
    /// Two real numbers count as equal in every comparison when they differ by at most this, relative to the larger
    /// one.
    double relative_equality = 0;
    /// Number of numbered parameters (R0 … R999); one past the last.
    std::uint32_t parameter_count = 1000;
    char parameter_letter = 'R';
    /// An arc's two radii may differ by this many millimetres unless the machine says otherwise.
    double circle_tolerance = 0.01;
    /// A jump to a block number (GOTOF N100) is allowed.
    bool jump_to_block_number = true;
};

}  // namespace obrys::program
