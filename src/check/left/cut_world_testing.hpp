#pragma once
/// A block of material for tests, and tools that cut it: what is left of it is asked for.

#include <gtest/gtest.h>

#include <utility>

#include "sim/milling/cut/simulation.hpp"
#include "sim/milling/cutter.hpp"

namespace obrys::check::testing {

struct CutWorld {
    sim::milling::Stock stock;
    sim::milling::Simulation simulation;
    std::uint32_t passes = 0;

    explicit CutWorld(sim::milling::Stock s = sim::milling::Box3{{0, 0, -20}, {60, 40, 0}})
        : stock(std::move(s)),
          simulation(stock, *sim::milling::make_lattice(sim::milling::box_of(stock), 1), 0.01, 1) {}

    std::uint32_t tool(double diameter, sim::milling::CutterKind kind = sim::milling::CutterKind::end_mill,
                       double edges = 60) {
        sim::milling::Cutter c;
        c.kind = kind;
        c.diameter = diameter;
        c.corner_radius = kind == sim::milling::CutterKind::ball ? diameter / 2 : diameter / 8;
        c.point_angle = 2;
        c.cutting_length = edges;
        return simulation.add_tool(sim::milling::shape_of(c).shape);
    }
    void cut(std::uint32_t tool, const geom::PathElement& path, geom::Vec3 axis = {0, 0, 1}) {
        ASSERT_NE(simulation.add({path, axis, tool}), sim::milling::Taken::not_known);
        ++passes;
    }
};

inline geom::Straight straight(geom::Vec3 from, geom::Vec3 to) { return {from, to}; }

}  // namespace obrys::check::testing
