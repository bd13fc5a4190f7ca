#pragma once
/// Collisions with a body that nothing may enter, by geometry (sim/certify): a clamp; the finished part, for what of a
/// tool does not cut. What is clipped by hundredths lies between the rays.

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <vector>

#include "geom/interpolation.hpp"
#include "mesh/distance.hpp"
#include "sim/certify/certify.hpp"
#include "sim/milling/cut/simulation.hpp"
#include "sim/milling/cutter.hpp"
#include "sim/milling/stock.hpp"

namespace obrys::check {

class BodyGuard {
public:
    /// `body` has no problem; `allowed`: mm, deeper is a hit.
    BodyGuard(const sim::milling::Stock& body, double allowed, int threads);
    /// A closed mesh. `before`: the material there was at all.
    BodyGuard(std::shared_ptr<const mesh::Distance> body, double allowed, int threads, sim::certify::Before before);

    BodyGuard(const BodyGuard&) = delete;
    BodyGuard& operator=(const BodyGuard&) = delete;

    /// By the tool's number in the simulation, in that order.
    void add_tool(const sim::milling::ToolShape& tool);
    /// Queues a pass under a number.
    void add(std::uint32_t number, const sim::milling::Pass& pass);
    void carry_out();
    /// What a pass that was carried out hit, if anything.
    [[nodiscard]] std::optional<sim::certify::Depth> hit_by(std::uint32_t number) const;
    /// Whether it was not decided if that pass hits the body.
    [[nodiscard]] bool is_open(std::uint32_t number) const { return open_.contains(number); }

private:
    struct Queued {
        std::uint32_t number = 0;
        geom::PathElement path;
        geom::Vec3 axis;
        const sim::certify::Shape* shape = nullptr;
    };
    [[nodiscard]] static sim::certify::Move move_of(const Queued& q) { return {q.path, q.axis, q.shape}; }
    [[nodiscard]] std::vector<std::optional<sim::certify::Depth>> depths() const;

    std::shared_ptr<const mesh::Distance> body_;
    double allowed_ = 0;
    int threads_ = 0;
    sim::certify::Judge judge_;
    /// Of each tool what cuts, its shank, its holder; as long as the guard.
    std::vector<std::unique_ptr<const std::array<sim::certify::Shape, 3>>> tools_;
    std::vector<Queued> queued_;
    std::map<std::uint32_t, sim::certify::Depth> hits_;
    std::set<std::uint32_t> open_;
};

}  // namespace obrys::check
