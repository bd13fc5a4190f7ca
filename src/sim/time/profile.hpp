#pragma once
/// How fast a path is gone along: blocks with a feed and limits each, places between them that are slow, at rest or
/// held speed at both ends. mm, mm/s, mm/s2, mm/s3, s.
///
/// Slow places are where the profile is held down; between two of them it is an S-curve (span.hpp). Places that turn
/// out too slow or too fast for their curve are lowered or added, one at a time, so that a place is looked at a few
/// times whatever the path's length. At a slow place in the middle of a ramp the speed goes on to change where that
/// takes less time. Source: shared spec physics.md (a) 4; not optimal: docs/time.md says by how much.

#include <cstdint>
#include <span>
#include <vector>

#include "base/function_ref.hpp"
#include "sim/time/span.hpp"

namespace obrys::sim::time {

/// A piece of path that is gone along with one feed.
struct Block {
    double length = 0;
    double speed = 0;  ///< the most in it
    Limits limits;
    double end_speed = 0;  ///< the most at its end
};

/// What a profile is made of: the places where it is held down, and the curves between them.
struct Profile {
    struct Place {
        std::uint32_t block = 0;  ///< it lies at the begin of this block; the number of blocks: at the end
        double speed = 0, acceleration = 0;
    };
    std::vector<Place> places;  ///< one more than `spans`
    std::vector<Span> spans;
    [[nodiscard]] double seconds() const;
};

/// `begin`, `end`: speeds at both ends of the path; lowered where there is not way enough.
[[nodiscard]] Profile plan(std::span<const Block> blocks, double begin, double end);

/// Lowers the speeds at the ends of blocks so that the machine can stand at the end of what a control knows that looks
/// `depth` blocks ahead, the one at hand among them (1: each ends in a stop); `lowered` is told which.
void limit_to_known(std::span<Block> blocks, std::size_t depth, base::FunctionRef<void(std::size_t)> lowered);

struct BlockTime {
    double seconds = 0;
    double rising = 0;  ///< of them, those before the top of the curve that the block lies in
    double speed = 0;   ///< at its end
};
/// Of the blocks in the first `spans` of the profile.
void block_times(std::span<const Block> blocks, const Profile& profile, std::size_t spans,
                 std::vector<BlockTime>& times);
[[nodiscard]] std::vector<BlockTime> block_times(std::span<const Block> blocks, const Profile& profile);

}  // namespace obrys::sim::time
