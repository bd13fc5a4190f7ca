#pragma once
/// What of a tool may not meet material, against what is left of the stock, by geometry: its cutting part by rapid, its
/// shank and holder at any feed. Rays see what is wide; a tip, a clipped edge, a wall that is rubbed lie between them.
///
/// What is clear of the stock as it was before anything was cut is clear (sim/certify). Of the rest the deepest place
/// in what no cut before has taken is looked for (left_search.hpp), several moves at once where these are clear. What
/// the search could not decide is said, not passed over.

#include <array>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include "check/left_inside.hpp"
#include "sim/certify/certify.hpp"
#include "sim/milling/simulation.hpp"

namespace obrys::check {

class StockGuard {
public:
    struct Hit {
        double depth = 0;  ///< mm; 0: none
        geom::Vec3 at;
    };
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
    [[nodiscard]] Hit hit_by(std::uint32_t number) const;
    /// Whether it could not be decided, or was not looked at.
    [[nodiscard]] bool is_open(std::uint32_t number) const { return undecided_.contains(number); }
    /// Pass from which on shanks and holders are left to the rays, since so many were searched before.
    [[nodiscard]] std::optional<std::uint32_t> rays_from() const { return rays_from_; }

private:
    struct Part {
        sim::certify::Shape shape;
        std::vector<std::vector<geom::Vec2>> profiles;  ///< convex ones
        double radius = 0, bottom = 0, top = 0;
    };
    struct Queued {
        std::uint32_t number = 0;
        geom::PathElement path;
        geom::Vec3 axis;  ///< unit length
        const Part* part = nullptr;
        bool body = false;  ///< a shank or holder
    };
    struct Verdict {
        bool decided = true;
        Hit hit;
    };
    struct Heights {
        double low = 0, high = 0;
    };
    struct Group;
    [[nodiscard]] bool has_met(const sim::milling::Simulation& simulation, const Queued& q) const;
    [[nodiscard]] bool is_worth_search(const Queued& q);
    [[nodiscard]] Part made(const sim::milling::Shape& shape) const;
    [[nodiscard]] sim::milling::Box3 box_of(std::size_t first, std::size_t end) const;
    [[nodiscard]] bool clear_together(Group& g, std::size_t first, std::size_t end) const;
    void judge_range(Group& g, std::size_t first, std::size_t end) const;
    [[nodiscard]] Verdict judge_one(Group& g, const Queued& q) const;
    [[nodiscard]] Heights heights_in_stock(const LeftBody& body) const;
    [[nodiscard]] bool all_clear(const LeftBody& way, const Part& part, const LeftSearch& search) const;
    void judge_piece(Verdict& verdict, const LeftBody& way, const Part& part, const LeftSearch& search) const;
    [[nodiscard]] Hit refined(const Queued& q, Hit hit, const sim::milling::Simulation& simulation) const;

    const sim::milling::Stock& body_;
    mesh::Distance stock_;
    StockPlanes planes_;
    double allowed_ = 0, apart_ = 0, tolerance_ = 0, least_ = 0;
    int threads_ = 0;
    sim::certify::Judge judge_;
    std::deque<std::array<Part, 3>> tools_;  ///< of each what cuts, its shank, its holder
    std::vector<Queued> queued_;
    std::map<std::uint32_t, Hit> hits_;
    std::set<std::uint32_t> undecided_;
    std::size_t refined_ = 0, searched_ = 0, deep_rapids_ = 0;
    std::optional<std::uint32_t> rays_from_;
};

}  // namespace obrys::check
