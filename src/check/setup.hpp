#pragma once
/// What a check is set up with: the machine, tools, stock and part that a program is held to.

#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "geom/contour.hpp"
#include "mesh/distance.hpp"
#include "shop/job.hpp"
#include "shop/machine.hpp"
#include "shop/tool.hpp"
#include "sim/milling/stock.hpp"

namespace obrys::check {

/// What stands beside the stock and may not be touched.
struct Clamp {
    std::string name;
    sim::milling::Stock body;
};

/// The same on a lathe, a body of revolution: chuck, jaws, centre.
struct TurnedClamp {
    std::string name;
    geom::Region body;
};

/// What a milling program is held to. Frame of the stock, mm.
struct MillingSetup {
    sim::milling::Stock stock;
    double tolerance = 0.01;    ///< how near the simulated surface must be to the true one
    double memory_bytes = 2e9;  ///< what the stock may take
    std::vector<Clamp> clamps;
    std::shared_ptr<const mesh::Distance> part;  ///< the finished part, closed
    bool surface = false;                        ///< the surface is asked for without a part, too
    std::optional<std::uint64_t> at;  ///< the move after which Milled::at_move is the surface, as Finding::move counts
    std::uint64_t most_simulated = std::numeric_limits<std::uint64_t>::max();  ///< moves
    std::size_t keep_moves = 0;  ///< how many moves keep their way, for pages
    int threads = 0;             ///< 0: as many as there are processors; the result is the same
};

/// How the control ends rapids of several axes where the machine file does not say it.
struct RapidRule {
    shop::RapidPath path = shop::RapidPath::straight;
    std::string setting;  ///< of the control, with which each axis goes by itself; may be empty
};

/// What the program is held to. Regions lie in the (z, x) plane, x a radius, mm, and are closed to the axis.
struct Setup {
    shop::Machine machine;
    RapidRule rapids;
    std::vector<shop::Tool> tools;
    bool tools_given = false;  ///< a tool list was given, even an empty one
    std::optional<geom::Region> stock;
    std::optional<geom::Region> part;       ///< finished part
    std::optional<geom::Region> allowance;  ///< what this program must leave: the part and the allowance on it
    bool right_face = false;                ///< the part is drawn with its right face, down to the axis or its bore
    std::vector<TurnedClamp> turned_clamps;
    std::optional<MillingSetup> milling;
    shop::Tolerances tolerances;
    shop::Scope scope = shop::Scope::all;
    /// Told from time to time how many moves are simulated; may be empty.
    std::function<void(std::uint64_t moves)> progress;
    /// Whether the check is to come to its end with what it has; asked now and then, from any thread; may be empty.
    std::function<bool()> out_of_time;
    std::size_t keep_moves = 0;            ///< how many moves Result::moves keeps, for pictures
    std::size_t findings_per_code = 1000;  ///< the others are counted only
};

}  // namespace obrys::check
