#pragma once
/// The deepest place of a moving body in what is left of a stock: branch and bound over the body's own places, each
/// bounded by what single cuts have taken (cuts.hpp). What is clear is proved to be so. Millimetres.

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "check/left/body.hpp"

namespace obrys::check {

struct StockPlanes;

struct LeftSearch {
    const sim::milling::Stock& stock;
    const sim::milling::Air& air;
    const std::vector<LeftCut>& cuts;
    double allowed = 0;                   ///< no deeper is clear
    double enough = 0;                    ///< deeper is not asked for
    std::size_t most_cells = 0;           ///< looked at
    std::uint32_t* hint = nullptr;        ///< number of a cut that is tried first, and found last
    const StockPlanes* planes = nullptr;  ///< of the stock; with them depths are decided by inside.hpp, too
    bool met = false;                     ///< rays met something: then what is thin counts, too
    std::size_t most_inside = 800;        ///< cells that inside.hpp looks at
};

struct LeftDepth {
    bool decided = false;  ///< nothing is deeper than allowed, or `depth` is more than that
    double depth = 0;      ///< reached, as a rule within a tenth of the deepest; 0: none deeper than allowed
    geom::Vec3 at;
    double bound = 0;  ///< where it is not decided: nothing is deeper
};
[[nodiscard]] LeftDepth deepest_left(const LeftBody& body, const LeftSearch& search);

/// Whether it is clear for sure, without looking for depths: for many moves at once.
[[nodiscard]] bool surely_clear(const LeftBody& body, const LeftSearch& search);

}  // namespace obrys::check
