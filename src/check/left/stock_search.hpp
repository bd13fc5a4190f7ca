#pragma once
/// The deepest place of moving parts of tools in what is left of the stock, several at once where these are clear
/// (search.hpp). Frame of the stock, millimetres.

#include <functional>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "check/left/search.hpp"
#include "check/left/stock_parts.hpp"
#include "check/left/stock_planes.hpp"
#include "sim/milling/cut/simulation.hpp"

namespace obrys::check {

class StockSearch {
public:
    struct Limits {
        double allowed = 0;    ///< no deeper is clear
        double enough = 0;     ///< deeper is not asked for
        double tolerance = 0;  ///< of the simulation: what is surely no deeper is left undecided
    };
    struct Verdict {
        bool decided = true;
        StockHit hit;
    };
    using Verdicts = std::vector<std::pair<std::uint32_t, Verdict>>;  ///< by numbers of passes; others are clear

    StockSearch(const sim::milling::Stock& stock, Limits limits, int threads)
        : stock_(stock), planes_(planes_of(stock)), limits_(limits), threads_(threads) {}
    /// `passes` in their order, of the same part one after the other; until it is told to stop.
    [[nodiscard]] Verdicts search(const std::vector<StockPass>& passes, const sim::milling::Simulation& simulation,
                                  const std::function<bool()>& stop) const;

private:
    struct Group;
    [[nodiscard]] Verdicts judged(std::span<const StockPass> passes, const sim::milling::Simulation& simulation,
                                  const std::function<bool()>& stop, std::size_t patience) const;
    void look_again(Verdicts& verdicts, const std::vector<StockPass>& passes,
                    const sim::milling::Simulation& simulation, const std::function<bool()>& stop) const;
    [[nodiscard]] bool has_met(const sim::milling::Simulation& simulation, const StockPass& q) const;
    [[nodiscard]] sim::milling::Box3 box_of(const Group& g) const;
    [[nodiscard]] bool clear_together(Group& g, std::size_t first, std::size_t end) const;
    void judge_range(Group& g, std::size_t first, std::size_t end) const;
    [[nodiscard]] std::optional<geom::Straight> at_stock(const geom::Straight& way, const StockPass& q) const;
    [[nodiscard]] bool retraces(const Group& g, const StockPass& q, const LeftCuts& cuts) const;
    [[nodiscard]] bool leaves_own_cut(const Group& g, const StockPass& q, const LeftCuts& cuts,
                                      const LeftSearch& search) const;
    [[nodiscard]] Verdict judge_one(Group& g, const StockPass& q) const;
    [[nodiscard]] sim::milling::Heights heights_in_stock(const LeftBody& body) const;
    [[nodiscard]] bool all_clear(const LeftBody& way, const StockPart& part, const LeftSearch& search) const;
    void judge_piece(Verdict& verdict, const LeftBody& way, const StockPart& part, const LeftSearch& search) const;

    const sim::milling::Stock& stock_;
    StockPlanes planes_;
    Limits limits_;
    int threads_ = 0;
};

}  // namespace obrys::check
