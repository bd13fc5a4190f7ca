#pragma once
/// What of a tool may not meet material, against what is left of the stock, by geometry: its cutting part by rapid, its
/// shank and holder at any feed. Rays see what is wide; a tip, a clipped edge, a wall that is rubbed lie between them.
///
/// What is clear of the stock as it was before anything was cut is clear (sim/certify), and so is what stays in columns
/// that cuts before have emptied (cleared.hpp). Of the rest some places are looked at (touch.hpp); where none of these
/// touches, the deepest place in what no cut before has taken is looked for (check/left/search.hpp), several moves at
/// once where these are clear; so it is for the deepest of those that touch. What the search could not decide, or was
/// not looked at since so many were before, is said, not passed over.

#include <array>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include "check/left/stock_search.hpp"
#include "check/touching/cleared.hpp"
#include "check/touching/tip_stack.hpp"
#include "sim/certify/certify.hpp"

namespace obrys::check {

class StockGuard {
public:
    /// `allowed`: mm; `apart`: of the rays; `tolerance`: of the simulation.
    StockGuard(const sim::milling::Stock& stock, double allowed, double apart, double tolerance, int threads);

    StockGuard(const StockGuard&) = delete;
    StockGuard& operator=(const StockGuard&) = delete;

    /// By the tool's number in the simulation, in that order.
    void add_tool(const sim::milling::ToolShape& tool);
    /// Queues a pass that takes nothing; `number`: of the pass in the simulation.
    void add(std::uint32_t number, const sim::milling::Pass& pass);
    /// Judges what is queued and was carried out in the simulation, until it is told to stop.
    void carry_out(const sim::milling::Simulation& simulation, const std::function<bool()>& stop);
    [[nodiscard]] StockHit hit_by(std::uint32_t number) const;
    /// Of a rapid beside whose tip rays stand: how high material stands over that; nothing where this does not matter.
    [[nodiscard]] std::optional<TipStack> over_tip(std::uint32_t number) const;
    /// Whether it could not be decided, or was not looked at.
    [[nodiscard]] bool is_open(std::uint32_t number) const { return undecided_.contains(number); }

private:
    [[nodiscard]] bool in_emptied(const StockPass& q, const sim::milling::Simulation& simulation);
    [[nodiscard]] bool profile_is_clear(const StockPass& q, const Upright& way, const std::vector<geom::Vec2>& profile,
                                        int halvings);
    void look_over_tips(const sim::milling::Simulation& simulation);
    void sort_out(const sim::milling::Simulation& simulation);
    void keep_deepest(std::vector<double> depths);
    [[nodiscard]] StockHit refined(const StockPass& q, StockHit hit, const sim::milling::Simulation& simulation) const;

    mesh::Distance stock_;
    double apart_ = 0, least_ = 0, allowed_ = 0;
    int threads_ = 0;
    sim::certify::Judge judge_;
    sim::milling::Box3 box_;
    Cleared cleared_;
    StockSearch search_;
    std::deque<std::array<StockPart, 3>> tools_;  ///< of each what cuts, its shank, its holder
    std::vector<StockPass> queued_;
    std::map<std::uint32_t, StockHit> hits_;
    std::map<std::uint32_t, TipStack> over_tips_;
    std::set<std::uint32_t> undecided_;
    std::size_t refined_ = 0, searched_bodies_ = 0, searched_rapids_ = 0, deepest_searched_ = 0, deep_rapids_ = 0,
                touching_rapids_ = 0;
};

}  // namespace obrys::check
