#include "path/compensation/refusal.hpp"

#include <array>
#include <cstddef>
#include <string_view>

#include "base/number.hpp"

namespace obrys::path {

namespace {

/// By Refusal. The interpreter of LinuxCNC 2.9 was asked for each of them (held_move_rs274_test.cpp).
constexpr std::array<std::string_view, 13> texts{
    "",
    "Length of cutter compensation entry move is not greater than the tool radius",
    "Radius of cutter compensation entry arc is not greater than the tool radius",
    "Tool radius not less than arc radius with comp",
    "Straight feed in concave corner cannot be reached by the tool without gouging",
    "Straight traverse in concave corner cannot be reached by the tool without gouging",
    "Arc move in concave corner cannot be reached by the tool without gouging",
    "Arc to straight motion makes a corner the compensated tool can't fit in without gouging",
    "Arc to arc motion makes a corner the compensated tool can't fit in without gouging",
    "Arc to arc motion is invalid because the arcs have the same center",
    "BUG: cutter compensation has generated an invalid arc with mismatched radii",
    "The move just after exiting cutter compensation mode must be straight, not an arc",
    "Cannot turn cutter radius comp on when on",
};

}  // namespace

std::string message(const Fault& fault, double unit) {
    std::string text{texts[static_cast<std::size_t>(fault.refusal)]};
    if (fault.refusal == Refusal::radii_differ)
        text += " r1 " + base::fixed(fault.radius_was / unit, 6) + " r2 " + base::fixed(fault.radius_is / unit, 6);
    return text;
}

}  // namespace obrys::path
