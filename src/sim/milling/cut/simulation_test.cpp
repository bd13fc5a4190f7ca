// What must not change the result, what must not be taken, and what passes that do not cut say.

#include <cmath>
#include <limits>
#include <random>

#include "geom/frame.hpp"
#include "sim/milling/cut/milling_testing.hpp"

namespace obrys::sim::milling {
namespace {

using geom::pi;
using geom::Vec3;

Cutter any_cutter(std::mt19937_64& random) {
    const auto between = [&](double a, double b) { return std::uniform_real_distribution<double>(a, b)(random); };
    Cutter c;
    c.kind = static_cast<CutterKind>(random() % 7);
    c.diameter = between(2, 12);
    c.corner_radius = c.kind == CutterKind::t_slot ? 0.4 : between(0.1, 0.9) * c.diameter / 2;
    c.cutting_length = between(8, 30);
    c.point_angle = between(0.8, 2.6);
    c.tip_diameter = between(0, 0.9) * c.diameter;
    c.width = between(1, 4);
    c.neck_diameter = c.diameter / 2;
    return c;
}

/// A turn of the whole set-up.
struct Turn {
    geom::Frame frame;
    [[nodiscard]] Vec3 point(Vec3 p) const { return geom::apply(frame, p); }
    [[nodiscard]] Vec3 way(Vec3 v) const { return geom::apply_direction(frame, v); }
};

/// Random moves with random tools; `tilt`: how far the axis leans, radians.
void machine(Simulation& s, const Turn& turn, std::uint64_t seed, double tilt, int moves) {
    std::mt19937_64 random(seed);
    const auto between = [&](double a, double b) { return std::uniform_real_distribution<double>(a, b)(random); };
    Vec3 at{15, 10, 2};
    for (int i = 0; i < moves; ++i) {
        const std::uint32_t tool = s.add_tool(shape_of(any_cutter(random)).shape);
        const double lean = between(0, tilt), about = between(0, 2 * pi);
        const Vec3 axis =
            tilt == 0 ? Vec3{0, 0, 1}
                      : Vec3{std::sin(lean) * std::cos(about), std::sin(lean) * std::sin(about), std::cos(lean)};
        for (int k = 0; k < 3; ++k) {
            const bool level = random() % 2 == 0;
            const Vec3 to{between(-2, 32), between(-2, 22), level ? at.z : between(-6, 0)};
            if (level && random() % 2 == 0) {
                const double sweep = between(-6, 6);
                const Vec3 centre{at.x + between(-5, 5), at.y + between(-5, 5), at.z};
                const Vec3 out = at - centre;
                const Vec3 end = centre + Vec3{out.x * std::cos(sweep) - out.y * std::sin(sweep),
                                               out.x * std::sin(sweep) + out.y * std::cos(sweep), 0};
                s.add({geom::Circular{turn.point(at), turn.point(end), turn.point(centre), turn.way({0, 0, 1}), sweep},
                       turn.way(axis), tool});
                at = end;
            } else {
                s.add({geom::Straight{turn.point(at), turn.point(to)}, turn.way(axis), tool});
                at = to;
            }
        }
    }
    s.flush();
}

template <class Visit>
void each_ray(const Dexels& d, Visit&& visit) {
    for (int axis = 0; axis < 3; ++axis)
        for (int b = 0; b < d.rays_b(axis); ++b)
            for (int a = 0; a < d.rays_a(axis); ++a) visit(axis, a, b, d.ray(axis, a, b));
}

const Box3 bed{{0, 0, -10}, {30, 20, 0}};

TEST(Simulation, NumberOfThreadsChangesNothing) {
    for (const double tilt : {0.0, 0.7}) {
        Simulation one(bed, *make_lattice(bed, 0.35), 0.01, 1), four(bed, *make_lattice(bed, 0.35), 0.01, 4);
        machine(one, {}, 7, tilt, 12);
        machine(four, {}, 7, tilt, 12);
        std::size_t cuts = 0;
        each_ray(one.dexels(), [&](int axis, int a, int b, std::span<const Interval> ray) {
            const auto other = four.dexels().ray(axis, a, b);
            ASSERT_TRUE(std::equal(ray.begin(), ray.end(), other.begin(), other.end()));
            for (const Interval& v : ray) cuts += (v.begin_cut != 0) + (v.end_cut != 0);
        });
        EXPECT_GT(cuts, 1000U);
        ASSERT_EQ(one.engagements().size(), four.engagements().size());
        for (std::size_t i = 0; i < one.engagements().size(); ++i) {
            EXPECT_EQ(one.engagements()[i].volume, four.engagements()[i].volume);
            EXPECT_EQ(one.engagements()[i].leftmost, four.engagements()[i].leftmost);
            EXPECT_EQ(one.engagements()[i].lowest, four.engagements()[i].lowest);
        }
    }
}

TEST(Simulation, IntervalsAreInOrderAndNormalsPointOut) {
    Simulation s(bed, *make_lattice(bed, 0.35), 0.01);
    machine(s, {}, 11, 0.5, 12);
    std::size_t wrong = 0, ends = 0;
    each_ray(s.dexels(), [&](int axis, int a, int b, std::span<const Interval> ray) {
        double last = -1e9;
        Vec3 p = s.dexels().lattice().node(0, 0, 0);
        set_component(p, first_across(axis),
                      component(p, first_across(axis)) + a * component(s.dexels().lattice().step, first_across(axis)));
        set_component(
            p, second_across(axis),
            component(p, second_across(axis)) + b * component(s.dexels().lattice().step, second_across(axis)));
        for (const Interval& v : ray) {
            ASSERT_GT(v.begin, last);
            ASSERT_GT(v.end, v.begin);
            last = v.end;
            set_component(p, axis, v.begin);
            const Vec3 in = s.normal_at(v.begin_cut, p);
            set_component(p, axis, v.end);
            const Vec3 out = s.normal_at(v.end_cut, p);
            ASSERT_NEAR(length(in), 1, 1e-9);
            wrong += component(in, axis) > 1e-3 || component(out, axis) < -1e-3;
            ++ends;
        }
    });
    // Where a ray meets an edge that stood still, either face may answer.
    EXPECT_GT(ends, 10'000U);
    EXPECT_LE(wrong, ends / 1000);
}

TEST(Simulation, QuarterTurnAboutXChangesNothing) {
    const Turn turn{geom::Frame::rotation(0, pi / 2)};
    const Box3 turned{{0, 0, 0}, {30, 10, 20}};  // (x, y, z) becomes (x, -z, y)
    for (const std::uint64_t seed : {3U, 4U, 5U}) {
        const Lattice lattice = *make_lattice(bed, 0.35);
        const Vec3 far = lattice.node(lattice.count[0] - 1, lattice.count[1] - 1, lattice.count[2] - 1);
        const Lattice other_lattice{{lattice.origin.x, -far.z, lattice.origin.y},
                                    {lattice.step.x, lattice.step.z, lattice.step.y},
                                    {lattice.count[0], lattice.count[2], lattice.count[1]}};
        Simulation a(bed, lattice, 0.01), b(turned, other_lattice, 0.01);
        machine(a, {}, seed, 0, 10);
        machine(b, turn, seed, 0, 10);
        const int last = a.dexels().lattice().count[2] - 1;
        std::size_t compared = 0;
        each_ray(a.dexels(), [&](int axis, int i, int j, std::span<const Interval> ray) {
            // y of the turned lattice counts against z.
            const auto other = axis == 0   ? b.dexels().ray(0, last - j, i)
                               : axis == 1 ? b.dexels().ray(2, i, last - j)
                                           : b.dexels().ray(1, i, j);
            ASSERT_EQ(ray.size(), other.size()) << "axis " << axis << " seed " << seed;
            for (std::size_t k = 0; k < ray.size(); ++k) {
                const Interval& v = ray[k];
                const Interval& w = axis == 2 ? other[ray.size() - 1 - k] : other[k];
                EXPECT_NEAR(v.begin, axis == 2 ? -w.end : w.begin, 1e-7);
                EXPECT_NEAR(v.end, axis == 2 ? -w.begin : w.end, 1e-7);
                ++compared;
            }
        });
        EXPECT_GT(compared, 1000U);
    }
}

/// Turned by 30 degrees about z, with leaning tools: the lattices do not meet. Where a point of one surface comes to
/// lie next to a ray of the other lattice, that ray must have material right behind it and none right before it.
TEST(Simulation, ThirtyDegreesAboutZWithLeaningToolsChangesNothing) {
    const CylinderStock bar{2, {15, 10, -10}, 14, 10};
    const Turn turn{geom::Frame::shift(bar.centre) * geom::Frame::rotation(2, pi / 6) *
                    geom::Frame::shift(-1.0 * bar.centre)};
    const auto lattice = *make_lattice(box_of(bar), 0.25);
    std::size_t compared = 0, wrong = 0;
    for (const std::uint64_t seed : {21U, 22U}) {
        Simulation a(bar, lattice, 0.01), b(bar, lattice, 0.01);
        machine(a, {}, seed, 0.6, 6);
        machine(b, turn, seed, 0.6, 6);
        EXPECT_NEAR(volume(a) / volume(b), 1, 2e-3);
        const auto holds = [&](int axis, Vec3 p) {
            const int first = first_across(axis), second = second_across(axis);
            const double u = (component(p, first) - component(lattice.origin, first)) / component(lattice.step, first);
            const double v =
                (component(p, second) - component(lattice.origin, second)) / component(lattice.step, second);
            for (const Interval& i :
                 b.dexels().ray(axis, static_cast<int>(std::lround(u)), static_cast<int>(std::lround(v))))
                if (i.begin <= component(p, axis) && component(p, axis) <= i.end) return true;
            return false;
        };
        const auto beside = [&](int axis, Vec3 p) {
            double square = 0;
            for (const int across : {first_across(axis), second_across(axis)}) {
                const double u =
                    (component(p, across) - component(lattice.origin, across)) / component(lattice.step, across);
                square += std::pow((u - std::round(u)) * component(lattice.step, across), 2);
            }
            return std::sqrt(square);
        };
        each_ray(a.dexels(), [&](int axis, int i, int j, std::span<const Interval> ray) {
            for (const Interval& v : ray) {
                if (v.end_cut == 0) continue;
                Vec3 p = lattice.node(0, 0, 0);
                set_component(p, first_across(axis),
                              component(p, first_across(axis)) + i * component(lattice.step, first_across(axis)));
                set_component(p, second_across(axis),
                              component(p, second_across(axis)) + j * component(lattice.step, second_across(axis)));
                set_component(p, axis, v.end);
                const Vec3 n = turn.way(a.normal_at(v.end_cut, p)), q = turn.point(p);
                for (int other = 0; other < 3; ++other) {
                    // Near edges of the surface a point may look past the corner, so some are allowed to differ.
                    if (beside(other, q) > 0.006 || std::abs(component(n, other)) < 0.5) continue;
                    ++compared;
                    wrong += holds(other, q + 0.03 * n) || !holds(other, q - 0.03 * n);
                }
            }
        });
    }
    EXPECT_GT(compared, 200U);
    EXPECT_LE(wrong, compared / 50);
}

TEST(Simulation, WhatCannotBeTakenIsRefusedByValue) {
    Work w(bed, 0.5, tool_of(CutterKind::end_mill, 6));
    const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
    w.start({1, 1, 1});
    EXPECT_EQ(w.to({1, 1, 1}), Taken::no_motion);
    EXPECT_EQ(w.to({nan, 1, 1}), Taken::not_known);
    w.start({1, 1, 1});
    EXPECT_EQ(w.to({1, inf, 1}), Taken::not_known);
    w.start({1, 1, 1});
    EXPECT_EQ(w.arc({2, 2, 1}, {1, 2, 1}, nan), Taken::not_known);
    w.axis = {0, 0, 0};
    w.start({1, 1, 1});
    EXPECT_EQ(w.to({2, 1, 1}), Taken::not_known);
    w.axis = {0, 0, 1};
    w.tool = 9;
    EXPECT_EQ(w.to({3, 1, 1}), Taken::no_tool);
    w.tool = 0;
    EXPECT_EQ(w.arc({3, 1, 0}, {1e9, 1, 1}, 1e9), Taken::too_long);
    EXPECT_EQ(w.simulation.engagements().size(), 7U);
    EXPECT_EQ(w.removed(), 0);
    EXPECT_EQ(w.simulation.add({geom::Cubic{{0, 0, 1}, {0, 0, nan}, {}, {}}, {0, 0, 1}, 0}), Taken::not_known);
}

TEST(Simulation, CuttersThatAreNone) {
    Cutter c;
    c.cutting_length = 10;
    EXPECT_FALSE(shape_of(c).ok());
    c.diameter = std::nan("");
    EXPECT_FALSE(shape_of(c).ok());
    c.diameter = 6;
    EXPECT_TRUE(shape_of(c).ok());
    c.cutting_length = 0;
    EXPECT_FALSE(shape_of(c).ok());
    c.cutting_length = 10;
    c.kind = CutterKind::bull_nose;
    c.corner_radius = 4;
    EXPECT_FALSE(shape_of(c).ok());
    c.corner_radius = 3;
    EXPECT_TRUE(shape_of(c).ok());
    c.kind = CutterKind::form;
    EXPECT_FALSE(shape_of(c).ok());
    c.profile = {{{2, 0}}, {{2, 4}}, {{3, 3}}};
    EXPECT_FALSE(shape_of(c).ok());
    c.kind = CutterKind::countersink;
    c.point_angle = pi;
    EXPECT_FALSE(shape_of(c).ok());
}

TEST(Simulation, PassesThatDoNotCutSayWhatTheyMeet) {
    ToolShape shape = tool_of(CutterKind::end_mill, 6, 0, 8);
    Cutter c;
    c.diameter = 6;
    c.cutting_length = 8;
    c.holder = {{20, 20, 5}, {20, 30, 10}};
    Work w(bed, 0.4, shape_of(c).shape);
    const auto probe = [&](Part part, Vec3 from, Vec3 to) {
        w.simulation.add({geom::Straight{from, to}, {0, 0, 1}, 0, part, false});
        w.simulation.flush();
        return w.simulation.engagements().back();
    };
    EXPECT_FALSE(probe(Part::cutting, {5, 5, 1}, {20, 15, 1}).touched);
    EXPECT_FALSE(probe(Part::shank, {5, 5, -9}, {20, 15, -9}).touched);  // it has none
    const Engagement rapid = probe(Part::cutting, {-20, 10, -2}, {50, 10, -2});
    EXPECT_TRUE(rapid.touched);
    EXPECT_NEAR(rapid.depth, 2, 1e-9);  // the blank's upper face above the tool's lower one
    EXPECT_FALSE(probe(Part::holder, {15, 10, 5}, {15, 10, -7.9}).touched);
    const Engagement holder = probe(Part::holder, {15, 10, 5}, {15, 10, -8.5});
    EXPECT_TRUE(holder.touched);
    EXPECT_NEAR(holder.depth, 0.5, 0.01);
    EXPECT_NEAR(holder.deepest.z, 0, 0.01);
    EXPECT_EQ(w.removed(), 0);
}

TEST(Simulation, AProbeAlongASlotIsAsDeepAsItsWalls) {
    Cutter c;
    c.diameter = 6;
    c.cutting_length = 8;
    c.shank = {{6.04, 6.04, 30}};
    Work w(bed, 0.4, shape_of(c).shape);
    w.simulation.add({geom::Straight{{-20, 10, -6}, {50, 10, -6}}, {0, 0, 1}, 0});
    w.simulation.add({geom::Straight{{-20, 10, -9.5}, {50, 10, -9.5}}, {0, 0, 1}, 0, Part::shank, false});
    w.simulation.flush();
    const Engagement shank = w.simulation.engagements().back();
    EXPECT_TRUE(shank.touched);
    EXPECT_NEAR(shank.depth, 0.02, 1e-6);
    EXPECT_NEAR(std::abs(shank.deepest.y - 10), 3, 1e-6);
}

}  // namespace
}  // namespace obrys::sim::milling
