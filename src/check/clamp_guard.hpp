#pragma once
/// Collisions with a clamp by geometry (sim/certify): a corner that is clipped by hundredths lies between the rays.

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <vector>

#include "geom/interpolation.hpp"
#include "mesh/distance.hpp"
#include "sim/certify/certify.hpp"
#include "sim/milling/cutter.hpp"
#include "sim/milling/simulation.hpp"
#include "sim/milling/stock.hpp"

namespace obrys::check {

class ClampGuard {
public:
    struct Hit {
        double depth = 0;  ///< mm
        geom::Vec3 at;
    };
    /// `body` has no problem; `allowed`: mm, deeper is a hit.
    ClampGuard(const sim::milling::Stock& body, double allowed, int threads);

    ClampGuard(const ClampGuard&) = delete;
    ClampGuard& operator=(const ClampGuard&) = delete;

    /// By the tool's number in the simulation, in that order.
    void add_tool(const sim::milling::ToolShape& tool);
    /// Queues a pass; passes are numbered from 0.
    void add(const sim::milling::Pass& pass);
    void carry_out();
    /// What a pass that was carried out hit; no depth: nothing.
    [[nodiscard]] Hit hit_by(std::uint32_t pass) const;

private:
    struct Queued {
        std::uint32_t pass = 0;
        geom::PathElement path;
        geom::Vec3 axis;
        const sim::certify::Shape* shape = nullptr;
    };
    mesh::Distance clamp_;
    double allowed_ = 0;
    int threads_ = 0;
    sim::certify::Judge judge_;
    /// Of each tool what cuts, its shank, its holder; as long as the guard.
    std::vector<std::unique_ptr<const std::array<sim::certify::Shape, 3>>> tools_;
    std::vector<Queued> queued_;
    std::uint32_t passes_ = 0;
    std::map<std::uint32_t, Hit> hits_;
};

}  // namespace obrys::check
