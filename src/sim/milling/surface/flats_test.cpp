// Plane faces at, and hardly beside, the nodes of the lattice: floors and walls of a pocket whose coordinates walk over
// a node in steps from rounding errors up to a cell. The surface must be that of the pocket wherever they lie.

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "mesh/distance.hpp"
#include "mesh/primitives.hpp"
#include "mesh/topology.hpp"
#include "sim/milling/cut/milling_testing.hpp"
#include "sim/milling/surface/surface.hpp"

namespace obrys::sim::milling {
namespace {

using geom::Vec3;

constexpr Box3 plate_block{{0, 0, -20}, {60, 40, 0}};
constexpr double mill_radius = 3;

double beyond(double v, double low, double high) { return std::max({low - v, v - high}); }

/// Distance from the surface of the block with a pocket of sharp floor edges, tool radius in its corners. Positive:
/// outside of the material.
double distance_from(Vec3 p, const Box3& pocket) {
    const double u = std::max({pocket.min.x + mill_radius - p.x, p.x - pocket.max.x + mill_radius, 0.0}),
                 v = std::max({pocket.min.y + mill_radius - p.y, p.y - pocket.max.y + mill_radius, 0.0});
    const double wall =
        u > 0 && v > 0 ? std::hypot(u, v) - mill_radius
                       : std::max(beyond(p.x, pocket.min.x, pocket.max.x), beyond(p.y, pocket.min.y, pocket.max.y));
    const double floor = pocket.min.z - p.z;
    const double outside_pocket = wall > 0 && floor > 0 ? std::hypot(wall, floor) : std::max(wall, floor);
    const double box =
        std::max({beyond(p.x, plate_block.min.x, plate_block.max.x), beyond(p.y, plate_block.min.y, plate_block.max.y),
                  beyond(p.z, plate_block.min.z, plate_block.max.z)});
    return std::max(box, -outside_pocket);
}

/// Mills the pocket ring by ring from its middle, then once along its walls.
void mill(Work& w, const Box3& pocket) {
    const Vec3 low = pocket.min + Vec3{mill_radius, mill_radius, 0},
               high = pocket.max - Vec3{mill_radius, mill_radius, 0};
    const double half = std::min(high.x - low.x, high.y - low.y) / 2;
    w.start({(low.x + high.x) / 2, (low.y + high.y) / 2, 2});
    for (double in = half; in > -3.5; in -= 3.5) {
        const double by = std::max(in, 0.0), z = pocket.min.z;
        w.to({low.x + by, low.y + by, z});
        w.to({high.x - by, low.y + by, z});
        w.to({high.x - by, high.y - by, z});
        w.to({low.x + by, high.y - by, z});
        w.to({low.x + by, low.y + by, z});
    }
}

/// The worst distance of the surface's corners and centres, both ways.
double worst_of(const Lattice& lattice, const Box3& pocket) {
    Work w(plate_block, 0.25, tool_of(CutterKind::end_mill, 2 * mill_radius));
    w.simulation = Simulation(plate_block, lattice, 0.01);
    w.tool = w.simulation.add_tool(tool_of(CutterKind::end_mill, 2 * mill_radius));
    mill(w, pocket);
    w.simulation.flush();
    const Surface s = extract_surface(w.simulation);
    EXPECT_EQ(s.unmatched, 0U);
    const mesh::Topology t = mesh::topology(s.mesh);
    EXPECT_EQ(t.open.count + t.crowded.count + t.turned.count, 0U);
    double worst = 0;
    for (const Vec3& p : s.mesh.vertices) worst = std::max(worst, std::abs(distance_from(p, pocket)));
    for (std::size_t i = 0; i < s.mesh.triangles.size(); ++i)
        worst = std::max(worst, std::abs(distance_from(mesh::centre(s.mesh, i), pocket)));
    return worst;
}

constexpr double flats_tolerance = 0.01;

// Sanitizers look for other things than results, and take ten times as long.
#ifdef __SANITIZE_ADDRESS__
constexpr int flats_share = 6;
#else
constexpr int flats_share = 1;
#endif

TEST(Flats, AtAndBesideNodesOfTheLattice) {
    const Lattice lattice = make_lattice(plate_block, step_for(flats_tolerance, 3)).value();
    const Vec3 node = lattice.node(20, 16, 50);
    // Decimals lie on no node (below); what was turned or computed may.
    int number = 0;
    for (const double size : {0.0, 1e-16, 1e-15, 1e-14, 5e-14, 1e-13, 1e-12, 1e-11, 1e-10, 1e-9, 1.0000001e-9, 1e-8,
                              1e-7, 1e-6, 1e-5, 1e-3, 0.05, 0.12})
        for (const double off : {size, -size}) {
            if (number++ % flats_share != 0) continue;
            const Box3 floor{{5.3, 4.7, node.z + off}, {54.1, 35.2, 1}},
                low{{node.x + off, node.y + off, -10.3}, {54.1, 35.2, 1}},
                high{{5.3, 4.7, -9.1}, {lattice.node(220, 0, 0).x + off, lattice.node(0, 140, 0).y + off, 1}};
            EXPECT_LE(worst_of(lattice, floor), flats_tolerance) << "floor " << off;
            EXPECT_LE(worst_of(lattice, low), flats_tolerance) << "lower walls " << off;
            EXPECT_LE(worst_of(lattice, high), flats_tolerance) << "upper walls " << off;
        }
}

constexpr std::array<double, 20> sizes{0,    1e-16, 1e-15, 1e-14, 5e-14, 1e-13, 2e-13, 1e-12, 1e-11, 1e-10,
                                       1e-9, 2e-9,  1e-8,  1e-7,  1e-6,  2e-6,  1e-5,  1e-4,  5e-4,  1e-3};

/// Floor and all four walls at nodes, each hardly beside them by another amount.
TEST(Flats, AllFacesOfAPocketAtNodes) {
    const Lattice lattice = make_lattice(plate_block, step_for(flats_tolerance, 3)).value();
    std::mt19937 random(7);
    const auto off = [&] { return (random() % 2 == 0 ? 1 : -1) * sizes[random() % sizes.size()]; };
    const auto at = [&](int low, int high) {
        return low + static_cast<int>(random() % static_cast<unsigned>(high - low));
    };
    for (int i = 0; i < 25 / flats_share; ++i) {
        const Vec3 low = lattice.node(at(10, 40), at(10, 30), at(20, 60));
        const Vec3 high = lattice.node(at(150, 230), at(100, 150), 0);
        const Box3 pocket{low + Vec3{off(), off(), off()}, {high.x + off(), high.y + off(), 1}};
        EXPECT_LE(worst_of(lattice, pocket), flats_tolerance) << low.x << " " << low.y << " " << low.z;
    }
}

/// The stock's own faces at nodes: of a box, and of the same as a mesh.
TEST(Flats, FacesOfTheStockAtNodes) {
    const Lattice lattice = make_lattice(plate_block, 0.5).value();
    std::mt19937 random(8);
    const auto off = [&] { return (random() % 2 == 0 ? 1 : -1) * sizes[random() % sizes.size()]; };
    for (int i = 0; i < 200 / flats_share; ++i) {
        const Box3 box{lattice.node(10, 10, 10) + Vec3{off(), off(), off()},
                       lattice.node(50, 60, 30) + Vec3{off(), off(), off()}};
        const mesh::Mesh walls = mesh::box(box.min, box.max);
        Stock stock = box;
        if (i % 2 == 1) stock = MeshStock{walls.vertices, {walls.triangles.begin(), walls.triangles.end()}};
        const Surface s = extract_surface(Simulation(stock, lattice, 0.01));
        EXPECT_EQ(s.unmatched, 0U);
        const mesh::Topology t = mesh::topology(s.mesh);
        EXPECT_EQ(t.open.count + t.crowded.count + t.turned.count, 0U);
        const mesh::Distance exact(walls);
        double worst = 0;
        for (const Vec3& p : s.mesh.vertices) worst = std::max(worst, exact.nearest(p).distance);
        for (std::size_t n = 0; n < s.mesh.triangles.size(); ++n)
            worst = std::max(worst, exact.nearest(mesh::centre(s.mesh, n)).distance);
        EXPECT_LE(worst, 1e-5) << i;
    }
}

/// Coordinates as programs have them lie on no node, whatever the tolerance and the tool.
TEST(Flats, DecimalsLieOnNoNode) {
    for (const double size : {9.0, 10.0, 20.0, 25.4, 47.123, 60.0, 100.0, 2000.0})
        for (const double step : {0.0123, 0.05, 0.1, 0.13, 0.2, 0.244948974, 0.25, 0.5, 1.0, 3.0}) {
            const Lattice l = make_lattice({{0, -size / 2, -size}, {size, size / 2, 0}}, step).value();
            for (int i = 0; i < l.count[0]; ++i)
                for (const double at : {l.node(i, 0, 0).x, l.node(0, i, 0).y, l.node(0, 0, i).z})
                    ASSERT_GT(std::abs(at * 1e6 - std::round(at * 1e6)), 0.4) << at;
            EXPECT_LT(l.node(0, 0, 0).x, -l.step.x / 5);
            EXPECT_GT(l.node(l.count[0] - 1, 0, 0).x, size + l.step.x / 5);
        }
}

}  // namespace
}  // namespace obrys::sim::milling
