#pragma once
/// Sweeps made ready to be cut, and the work on one tile of rays.

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "sim/milling/cut/stack.hpp"
#include "sim/milling/dexel.hpp"
#include "sim/milling/rays/rows.hpp"
#include "sim/milling/shape.hpp"
#include "sim/milling/track.hpp"

namespace obrys::sim::milling {

/// A sweep with all that does not depend on the ray.
struct Job {
    const Shape* shape = nullptr;
    Orientation frame;
    Track track;
    geom::Vec3 from;        ///< of the tip, frame of the stock
    geom::Vec3 way;         ///< translation, frame of the stock
    Box3 box;               ///< around what is swept, as far as it can lie in the stock
    std::uint32_t cut = 0;  ///< number of the sweep, from 1
    std::uint32_t pass = 0;
    bool cuts = true;
    int main = 2;              ///< the direction of rays that is measured: most nearly along the tool's axis
    std::array<Aims, 3> aims;  ///< of the track, by rays of each direction
    geom::Vec2 heading;        ///< of straight tracks, seen along the axis: unit vector, or zero
};
[[nodiscard]] Job make_job(const Shape& shape, const Orientation& frame, const Track& track, geom::Vec3 from,
                           const Box3& stock);

/// What a job met in one tile. All but `touched` only for rays of the job's main direction; the depth for all.
struct Tally {
    bool touched = false;
    double length = 0;
    double lowest = std::numeric_limits<double>::infinity(), highest = -std::numeric_limits<double>::infinity();
    double rightmost = std::numeric_limits<double>::infinity(), leftmost = -std::numeric_limits<double>::infinity();
    double depth = 0;
    geom::Vec3 deepest;
    Stacks stacks;  ///< of jobs that do not cut
};
void join(Tally& into, const Tally& t);

/// Tiles of one direction that a job may touch: first and one past the last in both directions.
struct TileRange {
    int a0 = 0, a1 = 0, b0 = 0, b1 = 0;
};
[[nodiscard]] TileRange tiles_of(const Job& job, const Dexels& dexels, int axis);
/// False where the job surely misses the tile (long slanting moves).
[[nodiscard]] bool may_touch(const Job& job, const Lattice& lattice, int axis, int ta, int tb);

/// Carries out jobs on one tile in their order; `tallies` has one entry for each of `order`.
void cut_tile(Tile& tile, const Lattice& lattice, int axis, int ta, int tb, std::span<const Job> jobs,
              std::span<const std::uint32_t> order, std::span<Tally> tallies);

/// Carries out jobs in their order on all rays; adds up what each met.
void cut_all(Dexels& dexels, std::span<const Job> jobs, std::span<Tally> tallies, int threads);

}  // namespace obrys::sim::milling
