#pragma once
/// Rapids into the stock that lie between the rays: a tip, a clipped edge.
///
/// What is clear of the stock as it was before anything was cut is clear, by geometry (sim/certify). Of other rapids
/// places of the tool are looked at: the deepest one in that stock, if it is hardly deeper than rays lie apart, and
/// some of its end on the way. A place that no cut before has taken is in the material, as deep as it lies from all of
/// them. So what is found is there; what lies deeper in cuts made before, and is narrow, is left to the rays.

#include <cstdint>
#include <deque>
#include <map>
#include <vector>

#include "sim/certify/certify.hpp"
#include "sim/milling/simulation.hpp"

namespace obrys::check {

class RapidGuard {
public:
    struct Hit {
        double depth = 0;  ///< mm
        geom::Vec3 at;
    };
    /// `allowed`: mm; `apart`: of the rays; `tolerance`: of the simulation.
    RapidGuard(const sim::milling::Stock& stock, double allowed, double apart, double tolerance, int threads);

    RapidGuard(const RapidGuard&) = delete;
    RapidGuard& operator=(const RapidGuard&) = delete;

    /// By the tool's number in the simulation, in that order.
    void add_tool(const sim::milling::ToolShape& tool);
    /// Queues a rapid of the cutting part; `pass`: its number in the simulation, which takes nothing.
    void add(std::uint32_t pass, const geom::PathElement& path, geom::Vec3 axis, std::uint32_t tool);
    /// Judges what is queued and was carried out in the simulation.
    void carry_out(const sim::milling::Simulation& simulation);
    [[nodiscard]] Hit hit_by(std::uint32_t pass) const;

private:
    struct Tool {
        sim::certify::Shape shape;
        std::vector<geom::Vec2> end;  ///< radius and height of places of its lower side
    };
    struct Queued {
        std::uint32_t pass = 0, tool = 0;
        geom::PathElement path;
        geom::Vec3 axis;
    };
    [[nodiscard]] sim::certify::Move move_of(const Queued& q) const { return {q.path, q.axis, &tools_[q.tool].shape}; }
    /// Of the tool on its way.
    struct Places {
        std::vector<geom::Vec3> all;
        sim::certify::Depth deepest;  ///< in the stock before anything was cut, if it is not deep
    };
    [[nodiscard]] Places places_of(const Queued& q);
    [[nodiscard]] Hit deepest(const Queued& q, const Places& places, const sim::milling::Simulation& simulation) const;

    mesh::Distance stock_;
    double allowed_ = 0, apart_ = 0, tolerance_ = 0;
    int threads_ = 0;
    sim::certify::Judge judge_;
    std::deque<Tool> tools_;
    std::vector<Queued> queued_;
    std::map<std::uint32_t, Hit> hits_;
    std::size_t searches_ = 0, looks_ = 0;  ///< done
};

}  // namespace obrys::check
