#pragma once
/// What controls truly do differently when a block is run: one small table that travels with the program.

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace obrys::program {

/// Numbered parameters of one kind, in the order of their numbers: R0 …, Q0 …, QL0 ….
struct ParameterBank {
    std::string_view letters;  ///< empty: there is no such bank
    std::uint32_t count = 0;
    bool local = false;  ///< every program has its own, and begins with none set
};

/// When a parameter counts as equal to another number.
struct Equality {
    double relative = 0;  ///< of the larger of the two
    double absolute = 0;
};

struct Traits {
    /// Holds in every comparison.
    Equality equality{};
    /// Numbers of later banks follow those of the first: QL0 is the number behind the last Q.
    std::array<ParameterBank, 3> banks{ParameterBank{"R", 1000}, {}, {}};
    /// A jump to a block number (GOTOF N100) is allowed.
    bool jump_to_block_number = true;
    /// M2 and M30 end the whole run, also in a called program; else they return from it.
    bool end_stops_all = false;
    /// A unit of length (inch, mm) holds for its program alone and comes back behind a call.
    bool unit_per_program = false;
    /// Contour elements, ahead and behind, that radius compensation holds its path against even where it does not look
    /// ahead; 0: neighbours alone.
    std::uint32_t compensation_window = 0;
    /// Parameters that hold text: these letters and a number ("QS5"); empty: there are none.
    std::string_view text_letters{};
    /// How deep calls of labels may be nested within one program.
    std::uint32_t label_depth = 0;
    /// mm/min of a feed of 1 in a program in inches.
    double inch_feed = 25.4;
    /// Polar coordinates and arcs about the pole are an alarm before the program has set one; else it is the zero
    /// point.
    bool needs_pole = false;
    /// A polar coordinate that a block leaves out, or gives incrementally, is that of the position; else the one
    /// programmed last.
    bool polar_from_position = false;
};

[[nodiscard]] constexpr std::uint32_t parameter_count(const Traits& t) {
    std::uint32_t n = 0;
    for (const ParameterBank& b : t.banks) n += b.count;
    return n;
}
/// "Q7", "QL3", "R12"; a number past the last as one of the first bank.
[[nodiscard]] std::string parameter_name(const Traits& t, std::uint32_t number);
/// Number of the parameter called `upper`; one past the last where there is none.
[[nodiscard]] std::uint32_t find_parameter(const Traits& t, std::string_view upper);

}  // namespace obrys::program
