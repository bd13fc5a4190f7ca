// Volumes and shapes against exact formulas.

#include <cmath>
#include <random>

#include "sim/milling/cut/milling_testing.hpp"
#include "sim/milling/surface/surface.hpp"

namespace obrys::sim::milling {
namespace {

using geom::pi;
using geom::Vec3;

const Box3 plate{{0, 0, -20}, {60, 40, 0}};

TEST(Volumes, Stock) {
    Simulation box(plate, *make_lattice(plate, 0.7), 0.01);
    EXPECT_NEAR(volume(box), 60 * 40 * 20.0, 1e-6);
    for (int axis = 0; axis < 3; ++axis) {
        const CylinderStock bar{axis, {1, 2, 3}, 12, 30};
        Simulation s(bar, *make_lattice(box_of(bar), 0.3), 0.01);
        EXPECT_NEAR(volume(s) / (pi * 144 * 30), 1, 1e-3) << axis;
    }
}

TEST(Volumes, Slot) {
    Work w(plate, 0.25, tool_of(CutterKind::end_mill, 10));
    w.start({12.03, 20.07, 5});
    w.to({12.03, 20.07, -4.1});
    w.to({47.11, 20.07, -4.1});
    const double exact = (35.08 * 10 + pi * 25) * 4.1;
    EXPECT_NEAR(w.removed() / exact, 1, 1e-3);
    EXPECT_NEAR(w.summed() / exact, 1, 0.02);
}

TEST(Volumes, SlantingSlotRunsOut) {
    Work w(plate, 0.25, tool_of(CutterKind::end_mill, 8));
    const double angle = geom::radians(27);
    w.start({-60 * std::cos(angle) + 30, -60 * std::sin(angle) + 20, -3.3});
    w.to({60 * std::cos(angle) + 30, 60 * std::sin(angle) + 20, -3.3});
    EXPECT_NEAR(w.removed() / (60 / std::cos(angle) * 8 * 3.3), 1, 1e-3);
}

TEST(Volumes, DrilledPattern) {
    Work w(plate, 0.13, tool_of(CutterKind::drill, 8));
    for (int i = 0; i < 4; ++i) {
        for (int j = 0; j < 3; ++j) {
            w.start({8.3 + 14 * i, 7.1 + 12.7 * j, 3});
            w.to({8.3 + 14 * i, 7.1 + 12.7 * j, -14});
        }
    }
    const double point = 4 / std::tan(geom::radians(59));
    EXPECT_NEAR(w.removed() / (12 * pi * 16 * (14 - point + point / 3)), 1, 1e-3);
}

TEST(Volumes, HelicalBore) {
    Work w(plate, 0.15, tool_of(CutterKind::end_mill, 6), 0.002);
    const Vec3 centre{30.1, 20.2, 0};
    w.start({32.6, 20.2, 0.5});
    w.arc({32.6, 20.2, -8}, centre, 2 * pi * 6);
    w.arc({32.6, 20.2, -8}, centre, 2 * pi);
    EXPECT_NEAR(w.removed() / (pi * 5.5 * 5.5 * 8), 1, 1e-3);
}

TEST(Volumes, RingByCircles) {
    Work w(plate, 0.2, tool_of(CutterKind::end_mill, 6));
    w.start({42.1, 20.2, 1});
    w.to({42.1, 20.2, -5});
    w.arc({42.1, 20.2, -5}, {30.1, 20.2, 0}, -2 * pi);
    EXPECT_NEAR(w.removed() / (pi * (15 * 15 - 9 * 9) * 5), 1, 1e-3);
}

TEST(Volumes, BallTrench) {
    Work w(plate, 0.2, tool_of(CutterKind::ball, 8));
    w.start({-10, 20.03, -3});
    w.to({70, 20.03, -3});
    const double half = std::acos(1 - 3.0 / 4), area = 16 * (half - std::sin(half) * std::cos(half));
    EXPECT_NEAR(w.removed() / (60 * area), 1, 1e-3);
}

TEST(Volumes, BallOnARamp) {
    Work w(plate, 0.2, tool_of(CutterKind::ball, 8));
    // The trench's cross-section normal to the way is the ball's; measured at right angles to x it is stretched.
    const double drop = std::tan(geom::radians(10));
    w.start({-40, 20.03, -3 + 70 * drop});
    w.to({100, 20.03, -3 - 70 * drop});
    double exact = 0;
    constexpr int slices = 60000;
    for (int i = 0; i < slices; ++i) {
        const double x = (i + 0.5) * 60 / slices;
        const double centre = 1 - (x - 30) * drop, r = 4, stretch = 1 / std::cos(geom::radians(10));
        const double depth =
            std::min(2.0, (r * stretch - centre) / (r * stretch));  // in half-axes of the section's ellipse
        if (depth <= 0) continue;
        const double half = std::acos(std::max(-1.0, 1 - depth));
        double area = r * r * stretch * (half - std::sin(half) * std::cos(half));
        if (depth > 1) area = r * r * stretch * pi / 2 + 2 * r * (-centre);  // above its middle the tool is straight
        exact += area * 60 / slices;
    }
    EXPECT_NEAR(w.removed() / exact, 1, 1e-3);
}

TEST(Volumes, BullNoseTrench) {
    Work w(plate, 0.2, tool_of(CutterKind::bull_nose, 10, 2));
    w.start({-10, 20.03, -5});
    w.to({70, 20.03, -5});
    EXPECT_NEAR(w.removed() / (60 * (10 * 5 - 2 * (4 - pi))), 1, 1e-3);
}

TEST(Volumes, TSlotHasAnUndercut) {
    Cutter c;
    c.kind = CutterKind::t_slot;
    c.diameter = 16;
    c.width = 5;
    c.neck_diameter = 7;
    c.cutting_length = 30;
    const MadeShape made = shape_of(c);
    ASSERT_TRUE(made.ok()) << made.problem;
    Work w(plate, 0.25, tool_of(CutterKind::end_mill, 8));
    w.start({-10, 20.03, -12});
    w.to({70, 20.03, -12});
    const double slot = w.removed();
    w.tool = w.simulation.add_tool(made.shape);
    w.start({-10, 20.03, -12});
    w.to({70, 20.03, -12});
    EXPECT_NEAR(w.removed() - slot, 60 * 5 * 8.0, 60 * 5 * 8e-3);
    const Dexels& d = w.simulation.dexels();
    const Lattice& l = d.lattice();
    const auto index = [&](int axis, double at) {
        return static_cast<int>(std::lround((at - component(l.origin, axis)) / component(l.step, axis)));
    };
    // Six millimetres beside the slot: bridge above, undercut, floor.
    const auto ray = d.ray(2, index(0, 30), index(1, 26));
    ASSERT_EQ(ray.size(), 2U);
    EXPECT_NEAR(ray[0].end, -12, 1e-9);
    EXPECT_NEAR(ray[1].begin, -7, 1e-9);
    EXPECT_NEAR(w.simulation.normal_at(ray[0].end_cut, {30, 26, -12}).z, 1, 1e-12);
    EXPECT_NEAR(w.simulation.normal_at(ray[1].begin_cut, {30, 26, -7}).z, -1, 1e-12);
    // Across the slot in the undercut's height.
    const auto across = d.ray(1, index(0, 30), index(2, -9));
    ASSERT_EQ(across.size(), 2U);
    EXPECT_NEAR(across[0].end, 20.03 - 8, 1e-9);
    EXPECT_NEAR(across[1].begin, 20.03 + 8, 1e-9);
    EXPECT_NEAR(w.simulation.normal_at(across[0].end_cut, {30, across[0].end, -9}).y, 1, 1e-9);
}

TEST(Volumes, FormToolByProfile) {
    // A corner rounding cutter: concave quarter arc of 3 mm between a pilot of radius 2 and the shaft of radius 5.
    Cutter c;
    c.kind = CutterKind::form;
    c.profile = {{{2, 0}}, {{2, 4}, -std::tan(pi / 8)}, {{5, 7}}, {{5, 20}}};
    c.deviation = 1e-4;
    const MadeShape made = shape_of(c);
    ASSERT_TRUE(made.ok()) << made.problem;
    EXPECT_TRUE(made.shape.cutting.rising);
    Work w(plate, 0.2, made.shape);
    w.start({-10, 20.03, -9});
    w.to({70, 20.03, -9});
    // Its half section up to 9 mm: 2 x 4, then 2 x 3 and a quarter disc's complement or the disc, then 5 x 2.
    const double arc = 9 - pi * 9 / 4;
    const double concave = 2 * 4 + 2 * 3 + arc + 5 * 2;
    EXPECT_NEAR(w.removed() / (60 * 2 * concave), 1, 1e-3);
}

/// In the lattice that a tolerance asks for, at any place in it. What is off, against what was removed.
struct Off {
    double most = 0, square = 0;
    int count = 0;
    void add(double share) {
        most = std::max(most, std::abs(share));
        square += share * share;
        ++count;
    }
    [[nodiscard]] double rms() const { return std::sqrt(square / count); }
};

TEST(Volumes, WhereverTheLatticeLies) {
    std::mt19937 random(20261121);
    std::uniform_real_distribution<double> any(-1, 1);
    for (const double tolerance : {0.01, 0.05}) {
        Off slot, trench, slanting;
        for (int i = 0; i < 16; ++i) {
            const double dx = any(random), dy = any(random), dz = any(random);
            Work a(plate, step_for(tolerance, 5), tool_of(CutterKind::end_mill, 10));
            a.start({15 + dx, 20 + dy, 2});
            a.to({15 + dx, 20 + dy, -5 + dz});
            a.to({40 + dx, 20 + dy, -5 + dz});
            slot.add(a.removed() / ((250 + pi * 25) * (5 - dz)) - 1);
            Work b(plate, step_for(tolerance, 5), tool_of(CutterKind::ball, 10));
            b.start({-10, 20 + dy, -3 + dz});
            b.to({70, 20 + dy, -3 + dz});
            const double half = std::acos(1 - (3 - dz) / 5);
            trench.add(b.removed() / (60 * 25 * (half - std::sin(half) * std::cos(half))) - 1);
            Work c(plate, step_for(tolerance, 4), tool_of(CutterKind::end_mill, 8));
            const double angle = 0.1 + 0.1 * (1 + dx);
            c.start({30 - 60 * std::cos(angle), 20 + dy - 60 * std::sin(angle), -5 + dz});
            c.to({30 + 60 * std::cos(angle), 20 + dy + 60 * std::sin(angle), -5 + dz});
            slanting.add(c.removed() / (60 / std::cos(angle) * 8 * (5 - dz)) - 1);
        }
        const double h = tolerance == 0.01 ? 1 : 6;  // coarser by the root of 5, errors grow with its square or slower
        for (const Off& off : {slot, trench, slanting}) {
            EXPECT_LE(off.rms(), 4e-4 * h) << tolerance;
            EXPECT_LE(off.most, 1e-3 * h) << tolerance;
        }
    }
}

double enclosed(const Simulation& s) {
    const auto normal = [&](std::uint32_t cut, Vec3 p, int, double) { return s.normal_at(cut, p); };
    const Surface surface = extract_surface(s.dexels(), normal);
    double six_times = 0;
    for (const auto& t : surface.mesh.triangles) {
        const auto& v = surface.mesh.vertices;
        six_times += dot(v[t[0]], cross(v[t[1]], v[t[2]]));
    }
    return six_times / 6;
}

/// In the lattice that a tolerance of 0.01 mm asks for, what the closed surface holds.
TEST(Volumes, OfTheSurfaceInAnOrdinaryLattice) {
    {
        Work w(plate, step_for(0.01, 4), tool_of(CutterKind::drill, 8));
        for (int i = 0; i < 4; ++i) {
            for (int j = 0; j < 3; ++j) {
                w.start({8.3 + 14 * i, 7.1 + 12.7 * j, 3});
                w.to({8.3 + 14 * i, 7.1 + 12.7 * j, -14});
            }
        }
        w.simulation.flush();
        const double point = 4 / std::tan(geom::radians(59));
        EXPECT_NEAR((48000 - enclosed(w.simulation)) / (12 * pi * 16 * (14 - point + point / 3)), 1, 1e-3);
    }
    {
        Work w(plate, step_for(0.01, 4), tool_of(CutterKind::ball, 8));
        w.start({-10, 20.03, -3});
        w.to({70, 20.03, -3});
        w.simulation.flush();
        const double half = std::acos(1 - 3.0 / 4), area = 16 * (half - std::sin(half) * std::cos(half));
        EXPECT_NEAR((48000 - enclosed(w.simulation)) / (60 * area), 1, 1e-3);
    }
    {
        Work w(plate, step_for(0.01, 3), tool_of(CutterKind::end_mill, 6), 0.01);
        w.start({32.6, 20.2, 0.5});
        w.arc({32.6, 20.2, -8}, {30.1, 20.2, 0}, 2 * pi * 6);
        w.arc({32.6, 20.2, -8}, {30.1, 20.2, 0}, 2 * pi);
        w.simulation.flush();
        EXPECT_NEAR((48000 - enclosed(w.simulation)) / (pi * 5.5 * 5.5 * 8), 1, 1e-3);
    }
}

TEST(Volumes, EngagementOfASideCut) {
    Work w(plate, 0.1, tool_of(CutterKind::end_mill, 10));
    w.start({-10, -4.02, -6});
    w.to({70, -4.02, -6});
    w.simulation.flush();
    const Engagement& e = w.simulation.engagements()[0];
    EXPECT_TRUE(e.touched);
    EXPECT_NEAR(e.volume, 60 * 0.98 * 6, 60 * 6 * 0.1);
    EXPECT_NEAR(e.lowest, -6, 1e-9);
    EXPECT_NEAR(e.highest, 0, 1e-9);
    EXPECT_NEAR(e.rightmost, 4.02, 0.1);
    EXPECT_NEAR(e.leftmost, 5, 0.1);
    const Angles a = engaged_angles(e, 5);
    EXPECT_NEAR(a.from, std::asin(4.02 / 5), 0.05);
    EXPECT_GT(a.to, a.from);
}

}  // namespace
}  // namespace obrys::sim::milling
