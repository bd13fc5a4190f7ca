#pragma once
/// Gouges by geometry (sim/certify): every move of the tool against the part, whatever lies between the rays.

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "check/check.hpp"
#include "check/thread_band.hpp"
#include "sim/certify/certify.hpp"
#include "sim/milling/cutter.hpp"

namespace obrys::check {

/// A place where the part was cut into; `at`, deviation, shares and peak as those of a place of the surface. Without an
/// area the rays did not see it, and the shares of its moves are depths, mm.
struct Gouge {
    mesh::Place place;
    double width = 0;   ///< mm, of the tool in the surface; 0: not known
    bool edge = false;  ///< of an edge
};

class Certificate {
public:
    /// A move that is deeper than allowed.
    struct Found {
        std::uint32_t move = 0;
        sim::certify::Depth depth;
        double beside = 0;  ///< mm of way along the surface there
    };
    Certificate(const MillingSetup& setup, double allowed);

    /// By the tool's number in the simulation, in that order.
    void add_tool(const sim::milling::ToolShape& tool);
    /// What the cutting part of a tool does; `move`: index in Milled::moves.
    void add(std::uint32_t move, const geom::PathElement& path, geom::Vec3 axis, std::uint32_t tool);
    /// Judges what has been added.
    void carry_out();
    /// How deep all that was added goes. What was not measured when it is told to `stop` is left out.
    void measure(const ThreadBands& threads, const std::function<bool()>& stop);
    /// What the rays show of a gouge tells more of one that was measured, or is no move's.
    [[nodiscard]] bool may_be(const mesh::Place& rays) const;
    /// All gouges, measured before. `rays`: what was found on the simulated surface; those that no move has made are
    /// left out, those where no move has cut stay.
    [[nodiscard]] std::vector<Gouge> gouges(const std::vector<MilledMove>& moves,
                                            const std::vector<mesh::Place>& rays) const;

private:
    struct Queued {
        std::uint32_t move = 0, tool = 0;
        geom::PathElement path;
        geom::Vec3 axis;
    };
    [[nodiscard]] sim::certify::Move move_of(const Queued& q) const { return {q.path, q.axis, &shapes_[q.tool]}; }

    int threads_ = 0;
    double allowed_ = 0;
    std::shared_ptr<const mesh::Distance> part_;
    sim::certify::Judge judge_;
    std::vector<sim::certify::Shape> shapes_;
    std::vector<Queued> queued_, suspects_;
    std::vector<Found> found_;
};

}  // namespace obrys::check
