#include "check/gouge/proof.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "mesh/primitives.hpp"
#include "sim/milling/cut/simulation.hpp"

namespace obrys::check {
namespace {

namespace milling = sim::milling;
using geom::Vec3;
using Outcome = Proof::Outcome;

constexpr std::size_t cells = 200'000;

class Numbers {
public:
    explicit Numbers(std::uint64_t seed) : random_(seed) {}
    double between(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
    /// Evenly in the logarithm.
    double spread(double low, double high) { return std::exp(between(std::log(low), std::log(high))); }

private:
    std::mt19937_64 random_;
};

/// A block from the origin to (60, 40, 0) and 20 deep, as stock; tools go through it.
struct Bench {
    milling::Simulation simulation;
    explicit Bench(double top = 0)
        : simulation(milling::Box3{{0, 0, -20}, {60, 40, top}},
                     milling::make_lattice({{0, 0, -20}, {60, 40, top}}, 2).value(), 0.01) {}
    std::uint32_t tool(milling::CutterKind kind, double diameter, double angle = 90) {
        milling::Cutter c;
        c.kind = kind;
        c.diameter = diameter;
        c.point_angle = geom::radians(angle);
        c.cutting_length = 40;
        return simulation.add_tool(milling::shape_of(c).shape);
    }
    void move(std::uint32_t tool, Vec3 from, Vec3 to) {
        simulation.add({geom::Straight{from, to}, {0, 0, 1}, tool});
        simulation.flush();
    }
    Proof ask(const mesh::Distance& part, bool gouge, double allowed, const milling::Box3& box) {
        const milling::Air air = simulation.air_in(box);
        return decide({part, air, gouge, allowed, {}}, box, cells);
    }
};

/// Two places of a mill against a wall leave a crest between them, however narrow.
TEST(MillingProof, ACrestBetweenTwoPlungesIsThereOrNotAsItsHeightSays) {
    Numbers n(1);
    const mesh::Distance part(mesh::box({0, 0, -20}, {30, 40, 0}));
    for (int i = 0; i < 20; ++i) {
        const double r = n.between(1, 10), apart = n.between(0.1, 1.2) * r, allowed = n.spread(0.002, 0.05);
        const double y = n.between(10, 30), crest = r - std::sqrt(r * r - apart * apart / 4);
        if (std::abs(crest - allowed) < 0.03 * allowed) continue;
        Bench b;
        const auto tool = b.tool(milling::CutterKind::end_mill, 2 * r);
        for (const double side : {-0.5, 0.5})
            b.move(tool, {30 + r, y + side * apart, 5}, {30 + r, y + side * apart, -6});
        const milling::Box3 box{{29.8, y - apart / 2, -5.5}, {30 + 2 * crest + 0.01, y + apart / 2, -4.5}};
        const Proof p = b.ask(part, false, allowed, box);
        EXPECT_EQ(p.outcome, crest > allowed ? Outcome::present : Outcome::absent) << crest << " " << allowed;
        if (crest > allowed) {
            EXPECT_LE(p.deviation, crest + 1e-9);
            EXPECT_GT(p.deviation, allowed);
        }
        EXPECT_EQ(b.ask(part, true, allowed, box).outcome, Outcome::absent);
    }
}

/// A pointed tool drawn over a finished face.
TEST(MillingProof, AScratchIsThereOrNotAsItsDepthSays) {
    Numbers n(2);
    const mesh::Distance part(mesh::box({0, 0, -20}, {60, 40, 0}));
    for (int i = 0; i < 20; ++i) {
        const double allowed = n.spread(0.002, 0.05), depth = allowed * n.spread(0.3, 20), angle = n.between(30, 140);
        if (std::abs(depth - allowed) < 0.03 * allowed) continue;
        Bench b;
        const auto tool = b.tool(milling::CutterKind::chamfer, 8, angle);
        const double x = n.between(10, 50), turn = n.between(0, 3);
        const Vec3 at{x, 20, -depth}, way{std::cos(turn), std::sin(turn), 0};
        b.move(tool, at - 4.0 * way, at + 4.0 * way);
        const milling::Box3 box{{x - 1, 19, -1}, {x + 1, 21, 0.3}};
        const Proof p = b.ask(part, true, allowed, box);
        EXPECT_EQ(p.outcome, depth > allowed ? Outcome::present : Outcome::absent) << depth << " " << allowed;
        if (depth > allowed) {
            EXPECT_LE(p.deviation, depth + 1e-9);
            EXPECT_GT(p.deviation, allowed);
            EXPECT_EQ(p.cut, 1U);
        }
    }
}

/// Two slots beside each other with next to nothing between them.
TEST(MillingProof, AFinOfAnyThicknessIsFound) {
    Numbers n(3);
    const mesh::Distance part(mesh::box({0, 0, -20}, {60, 40, -5}));
    for (int i = 0; i < 12; ++i) {
        const double thick = i == 0 ? 0 : n.spread(0.0005, 0.2), allowed = n.spread(0.002, 0.05);
        Bench b;
        const auto tool = b.tool(milling::CutterKind::end_mill, 6);
        for (const double side : {-1.0, 1.0})
            b.move(tool, {-5, 20 + side * (3 + thick / 2), -5}, {65, 20 + side * (3 + thick / 2), -5});
        const Proof p = b.ask(part, false, allowed, {{29.5, 19.5, -5.2}, {30.5, 20.5, -4.5}});
        if (thick > 0) {
            EXPECT_EQ(p.outcome, Outcome::present) << thick;
        } else {
            EXPECT_NE(p.outcome, Outcome::present);
        }
    }
}

/// What fits its part is proved to, with room for the effort: walls, floors, their edges, round holes and their cones.
TEST(MillingProof, WhatFitsIsProvedToFit) {
    Numbers n(4);
    for (int i = 0; i < 20; ++i) {
        const double allowed = n.spread(0.005, 0.05), z = n.between(-9, -3), x = n.between(20, 40);
        const mesh::Distance part(mesh::box({0, 0, -20}, {x, 40, z}));
        Bench b;
        const auto tool = b.tool(milling::CutterKind::end_mill, 8);
        for (double y = -4; y < 45; y += 3) b.move(tool, {-5, y, z}, {65, y, z});
        for (double beside = x + 4; beside < 70; beside += 3) b.move(tool, {beside, -5, -21}, {beside, 45, -21});
        const milling::Box3 corner{{x - 0.4, 18, z - 0.4}, {x + 0.4, 18.8, z + 0.4}};
        EXPECT_EQ(b.ask(part, false, allowed, corner).outcome, Outcome::absent) << allowed;
        EXPECT_EQ(b.ask(part, true, allowed, corner).outcome, Outcome::absent) << allowed;
    }
}

}  // namespace
}  // namespace obrys::check
