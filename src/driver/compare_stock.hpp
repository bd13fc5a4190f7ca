#pragma once
/// What two programs leave of their stock, held against each other by the simulation. How they came to it does not
/// count: not the order of the cuts, nor the tools.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "compare/compare.hpp"
#include "driver/session.hpp"

namespace obrys::driver {

/// A line of one of the programs, and the move that it made.
struct StockCut {
    std::string file;
    std::uint32_t line = 0;
    std::uint64_t move = 0;  ///< as check::Finding::move counts
};

/// Where one of them has left more than the other.
struct StockPlace {
    double depth = 0;               ///< mm by which the one goes deeper
    geom::Vec3 at;                  ///< there, frame of the stock; turned stock: x a radius, y 0
    bool b_is_deeper = false;       ///< else A
    std::optional<StockCut> by;     ///< what cut deeper
    std::optional<StockCut> other;  ///< what made the surface of the other one there; none: nothing cut there
};

struct StockComparison {
    enum class Verdict : std::uint8_t { equal, differs, not_compared };
    Verdict verdict = Verdict::not_compared;
    std::string why;                 ///< it was not compared
    bool is_missed = false;          ///< although both have stock and tools
    double tolerance = 0;            ///< mm within which it was
    bool by_moves = false;           ///< the same moves with the same tools in the same stock: nothing was simulated
    std::vector<StockPlace> places;  ///< the deepest first; the first ones of many
    std::size_t count = 0;           ///< of all places
};

/// One of the two: opened for the comparison of its moves, and what it was opened with.
struct ComparedSide {
    const Session& session;
    const Request& request;
};
/// Runs both anew, each on its stock, but for where `moves`, compared within `same_place` mm, settle it.
[[nodiscard]] StockComparison compare_stock(const ComparedSide& a, const ComparedSide& b, const compare::Result& moves,
                                            double same_place);

}  // namespace obrys::driver
