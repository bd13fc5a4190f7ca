#pragma once
/// How near a program can be written: by a control that counts lengths in increments, by words of so many decimals.

#include <optional>

#include "cl/record.hpp"
#include "cl/recording.hpp"
#include "compare/compare.hpp"
#include "write/post.hpp"

namespace obrys::driver {

/// How far a step along each axis of a frame may lead along one of the workpiece: 1, more where a frame turns or
/// scales.
[[nodiscard]] double spread_of(const cl::Frame& frame);
/// A control that counts in increments rounds every coordinate to them. `spread`: the widest of the program's frames.
[[nodiscard]] compare::Tolerance as_control_counts(const write::Post& post, compare::Tolerance tolerance,
                                                   double spread);

/// What a look through the program's stream says about how it can be compared.
struct LookedThrough {
    double spread = 1;  ///< the widest of its frames
    double lever = 0;   ///< mm: how far from the origin of its tilted plane a move ends
    double tilt = 1;    ///< sine of the least tilt of one
    std::optional<cl::Record> without_feed{};
};
[[nodiscard]] LookedThrough look_through(const cl::Recording& stream);

/// What the words of a post cannot say any nearer: a place between the ends of an arc follows from three of them, its
/// start, its end and its centre. Places that are written are given more room in tilted planes alone, of which each of
/// three angles may be half a step of its word beside.
[[nodiscard]] compare::Tolerance as_words_hold(const write::Post& post, const LookedThrough& program,
                                               compare::Tolerance tolerance);

}  // namespace obrys::driver
