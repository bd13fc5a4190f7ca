// How the lattice of rays follows from tolerance, stock and memory.

#include <cmath>
#include <limits>
#include <random>

#include "geom/frame.hpp"
#include "sim/milling/cut/milling_testing.hpp"

namespace obrys::sim::milling {
namespace {

using geom::pi;
using geom::Vec3;

TEST(Simulation, MeshStock) {
    // An octahedron: edges and corners lie exactly on rays when the lattice is placed so.
    const MeshStock mesh{{{6, 0, 0}, {-6, 0, 0}, {0, 6, 0}, {0, -6, 0}, {0, 0, 6}, {0, 0, -6}},
                         {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}};
    EXPECT_EQ(problem_of(mesh), "");
    Lattice lattice;
    lattice.origin = {-8, -8, -8};
    lattice.step = {0.25, 0.25, 0.25};
    lattice.count = {65, 65, 65};
    Simulation s(mesh, lattice, 0.01);
    EXPECT_EQ(s.open_rays(), 0U);
    EXPECT_EQ(s.dexels().ray(2, 32, 32).size(), 1U);  // through two corners
    EXPECT_EQ(s.dexels().ray(0, 40, 32).size(), 1U);  // through two edges
    const Simulation beside(mesh, *make_lattice(box_of(mesh), 0.25), 0.01);
    EXPECT_EQ(beside.open_rays(), 0U);
    EXPECT_NEAR(volume(beside) / (4.0 / 3 * 216), 1, 2e-3);
    const Vec3 n = s.normal_at(0, {2, 2, 2});
    EXPECT_NEAR(dot(n, {1, 1, 1}), std::sqrt(3.0), 1e-9);
    MeshStock open = mesh;
    open.triangles.pop_back();
    EXPECT_GT(Simulation(open, lattice, 0.01).open_rays(), 10U);
    open.triangles[0][0] = 17;
    EXPECT_NE(problem_of(open), "");
}

TEST(Simulation, LatticeFollowsFromTolerance) {
    EXPECT_NEAR(step_for(0.01, 3), 0.245, 0.001);
    const Box3 plate{{0, 0, -10}, {100, 100, 0}};
    const auto lattice = make_lattice(plate, step_for(0.01, 3));
    ASSERT_TRUE(lattice);
    EXPECT_NEAR(lattice->node(0, 0, 0).x, -lattice->step.x / 2, 3e-4);  // put on a grid beside all decimals
    EXPECT_NEAR(lattice->node(lattice->count[0] - 1, 0, 0).x, 100 + lattice->step.x / 2, 3e-4);
    const double bytes = bytes_for(*lattice);
    EXPECT_GT(bytes, 5e6);
    EXPECT_LT(bytes, 100e6);
    const double fits = tolerance_that_fits(plate, 3, bytes / 10);
    EXPECT_GT(fits, 0.01);
    EXPECT_LE(bytes_for(*make_lattice(plate, step_for(fits, 3) * (1 + 1e-9))), bytes / 10);
    EXPECT_TRUE(resolve(plate, 0.01, 3, 500e6).lattice);
    const Resolution refused = resolve(plate, 0.01, 3, bytes / 10);
    EXPECT_FALSE(refused.lattice);
    EXPECT_EQ(refused.bytes, bytes);
    EXPECT_TRUE(resolve(plate, refused.fits * 1.001, 3, bytes / 10).lattice);
    EXPECT_TRUE(std::isnan(resolve(plate, 0.01, 3, 10).fits));
    EXPECT_FALSE(resolve(plate, std::nan(""), 3, 500e6).lattice);
    EXPECT_FALSE(resolve({{0, 0, 0}, {1e9, 1, 1}}, 0.01, 3, 500e6).lattice);
    EXPECT_FALSE(make_lattice(plate, 0));
    EXPECT_FALSE(make_lattice(plate, 1e-9));
    EXPECT_FALSE(make_lattice({{0, 0, 0}, {1, 1, 0}}, 0.1));
}

}  // namespace
}  // namespace obrys::sim::milling
