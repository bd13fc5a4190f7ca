#pragma once
/// Shared by the tests of milling: tools, blanks and moves in short.

#include <gtest/gtest.h>

#include "sim/milling/cut/simulation.hpp"

namespace obrys::sim::milling {

inline ToolShape tool_of(CutterKind kind, double diameter, double corner = 0, double length = 40) {
    Cutter c;
    c.kind = kind;
    c.diameter = diameter;
    c.corner_radius = corner;
    c.cutting_length = length;
    c.point_angle = geom::radians(118);
    const MadeShape made = shape_of(c);
    EXPECT_EQ(made.problem, "");
    return made.shape;
}

/// A blank and one tool at work in it.
struct Work {
    Simulation simulation;
    double before = 0;
    geom::Vec3 at, axis{0, 0, 1};
    std::uint32_t tool = 0;

    Work(const Stock& stock, double step, ToolShape shape, double tolerance = 0.01, int threads = 0)
        : simulation(stock, *make_lattice(box_of(stock), step), tolerance, threads),
          before(volume(simulation)),
          tool(simulation.add_tool(std::move(shape))) {}
    void start(geom::Vec3 p) { at = p; }
    Taken to(geom::Vec3 p) {
        const Taken taken = simulation.add({geom::Straight{at, p}, axis, tool});
        at = p;
        return taken;
    }
    Taken arc(geom::Vec3 p, geom::Vec3 centre, double sweep, geom::Vec3 normal = {0, 0, 1}) {
        const Taken taken = simulation.add({geom::Circular{at, p, centre, normal, sweep}, axis, tool});
        at = p;
        return taken;
    }
    [[nodiscard]] double removed() {
        simulation.flush();
        return before - volume(simulation);
    }
    [[nodiscard]] double summed() {
        simulation.flush();
        double sum = 0;
        for (std::size_t i = 0; i < simulation.engagements().size(); ++i) sum += simulation.engagements()[i].volume;
        return sum;
    }
};

}  // namespace obrys::sim::milling
