#include "check/gouge/thread_band.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace obrys::check {
namespace {

using geom::Vec3;

/// The wall of a bore as triangles, normals not needed: radius about (x, 0), from z = -20 to 0.
mesh::Mesh wall(double radius, double x, int layers) {
    constexpr int round = 180;
    mesh::Mesh m;
    for (int k = 0; k <= layers; ++k)
        for (int i = 0; i < round; ++i) {
            const double angle = 2 * geom::pi * i / round;
            m.vertices.push_back({x + radius * std::cos(angle), radius * std::sin(angle), -20.0 + 20.0 * k / layers});
        }
    const auto at = [](int k, int i) { return static_cast<std::uint32_t>(k * round + i % round); };
    for (int k = 0; k < layers; ++k)
        for (int i = 0; i < round; ++i) {
            m.triangles.push_back({at(k, i), at(k + 1, i), at(k, i + 1)});
            m.triangles.push_back({at(k, i + 1), at(k + 1, i), at(k + 1, i + 1)});
        }
    return m;
}

/// Deviation of the wall at a point, of M10 in a hole of `made` mm, drilled `off` mm beside the thread, against a part
/// that shows `shown` mm of diameter.
double left_of_it(double off, double shown, int layers, Vec3 p, double made = 8.5) {
    ThreadBands bands;
    bands.add({0, 0, 3}, {0, 0, -20}, {0, 0, 1}, {4.188, 5, 4.376});
    bands.add({0, 0, -20}, {0, 0, 3}, {0, 0, 1}, {4.188, 5, 4.376});
    const mesh::Distance part(wall(shown / 2, 0, 4));
    bands.fit(wall(made / 2, off, layers), part, 0.01);
    return bands.judged(p, shown / 2 - std::hypot(p.x, p.y));
}

TEST(ThreadBands, AHoleShownByAnyOfItsDiametersIsRight) {
    for (const double shown : {8.376, 8.5, 9.026, 10.0})
        for (const double angle : {0.0, 1.0, 2.0, 4.0})
            EXPECT_NEAR(left_of_it(0, shown, 50, {4.25 * std::cos(angle), 4.25 * std::sin(angle), -7}), 0, 2e-3)
                << shown;
}

TEST(ThreadBands, AHoleDrilledBesideItsThreadIsNot) {
    for (int layers = 3; layers < 200; layers += 7)
        EXPECT_NEAR(left_of_it(0.03, 10, layers, {-4.22, 0, -7}), 0.03, 4e-3) << layers;
    EXPECT_NEAR(left_of_it(0.03, 8.5, 50, {4.28, 0, -7}), -0.03, 4e-3);
}

/// M4 in a hole of 3.3 mm, drilled 0.12 mm beside it, which the tap cuts on one side; the part shows its core: 3.242
/// mm.
TEST(ThreadBands, WhatTheTapCutsOfAHoleBesideItsThreadDoesNotTellHowThePartShowsIt) {
    mesh::Mesh result = wall(1.65, 0.12, 50);
    result.tags.assign(result.triangles.size(), 1);
    for (std::size_t t = 0; t < result.triangles.size(); ++t) {
        const Vec3 c = mesh::centre(result, t);
        if (std::hypot(c.x, c.y) < 1.621) result.tags[t] = 2;
    }
    for (Vec3& v : result.vertices)
        if (const double r = std::hypot(v.x, v.y); r < 1.621) v.x *= 1.621 / r, v.y *= 1.621 / r;
    ThreadBands bands;
    bands.add({0, 0, 3}, {0, 0, -20}, {0, 0, 1}, {1.621, 2, 1.733});
    const mesh::Distance part(wall(1.621, 0, 4));
    bands.fit(result, part, 0.002, [](std::uint32_t tag) { return tag == 2; });
    EXPECT_NEAR(bands.judged({1.77, 0, -7}, 1.621 - 1.77), -0.12, 1e-3);
}

/// M6 in a hole of 5 mm that the part shows with its core: only what lies in the thread all over excuses the drill.
TEST(ThreadBands, ATriangleIsExcusedThatLiesInTheThreadAllOver) {
    ThreadBands bands;
    bands.add({0, 0, 3}, {0, 0, -20}, {0, 0, 1}, {2.459, 3, 2.607});
    const mesh::Distance part(wall(2.459, 0, 4));
    bands.fit(wall(2.5, 0, 50), part, 0.01);
    const auto at = [](double radius, double angle, double z) {
        return Vec3{radius * std::cos(angle), radius * std::sin(angle), z};
    };
    const std::array<Vec3, 3> on_wall{at(2.46, 0, 0), at(2.46, 0, -19), at(2.46, 0.03, -10)};
    EXPECT_NEAR(bands.deeper(on_wall), 0.041, 1e-3);
    const std::array<Vec3, 3> across{at(2.46, 0, -5), at(2.46, 2, -5), at(2.46, 4, -5)};
    EXPECT_EQ(bands.deeper(across), 0);
    const std::array<Vec3, 3> beyond{at(2.46, 0, 0), at(2.46, 0, -20.02), at(2.46, 0.03, -10)};
    EXPECT_EQ(bands.deeper(beyond), 0);
}

/// M10 in a hole of 8.5 mm that the part shows as it is; another move has made it wider over an arc.
TEST(ThreadBands, AHoleThatIsMadeWiderOverAnArcIsNoWiderHole) {
    for (const double arc : {0.5, 2.0, 3.5, 4.5, 5.9})
        for (const double more : {0.03, 0.2, 0.5}) {
            mesh::Mesh result = wall(4.25, 0, 50);
            result.tags.assign(result.triangles.size(), 1);
            const auto cut = [&](Vec3 p) { return std::atan2(p.y, p.x) + geom::pi < arc; };
            for (std::size_t t = 0; t < result.triangles.size(); ++t)
                if (cut(mesh::centre(result, t))) result.tags[t] = 2;
            for (Vec3& v : result.vertices)
                if (cut(v)) v.x *= (4.25 + more) / 4.25, v.y *= (4.25 + more) / 4.25;
            ThreadBands bands;
            bands.add({0, 0, 3}, {0, 0, -20}, {0, 0, 1}, {4.188, 5, 4.376});
            const mesh::Distance part(wall(4.25, 0, 4));
            bands.fit(result, part, 0.02);
            const double at = -geom::pi + arc / 2, radius = 4.25 + more;
            EXPECT_NEAR(bands.judged({radius * std::cos(at), radius * std::sin(at), -7}, -more), -more, 0.1 * more)
                << arc << " " << more;
        }
}

/// Two strokes of the same drill to either side.
TEST(ThreadBands, StrokesBesideAHoleAreNoWiderHole) {
    for (const double off : {0.025, 0.1, 0.3}) {
        mesh::Mesh result = wall(4.25, 0, 50);
        for (Vec3& v : result.vertices) {
            const double c = std::abs(v.x) / 4.25, out = off * c + std::sqrt(4.25 * 4.25 - off * off * (1 - c * c));
            v.x *= out / 4.25, v.y *= out / 4.25;
        }
        result.tags.assign(result.triangles.size(), 1);
        for (std::size_t t = 0; t < result.triangles.size(); ++t)
            if (mesh::centre(result, t).x > 0) result.tags[t] = 2;
        ThreadBands bands;
        bands.add({0, 0, 3}, {0, 0, -20}, {0, 0, 1}, {4.188, 5, 4.376});
        const mesh::Distance part(wall(4.25, 0, 4));
        bands.fit(result, part, 0.02);
        EXPECT_NEAR(bands.judged({4.25 + off, 0, -7}, -off), -off, 0.1 * off) << off;
    }
}

/// 8.376 is the core of M10, 8.751 the widest that 7H allows.
TEST(ThreadBands, AHoleTooWideForItsThreadIsHeldToThePart) {
    for (const double shown : {8.376, 8.5, 8.7, 10.0})
        for (const double made : {8.376, 8.5, 8.6, 8.7, 8.75, 8.8, 9.0, 9.5, 9.9}) {
            const double off = (shown - made) / 2, left = made < 8.76 ? 0 : off;
            EXPECT_NEAR(left_of_it(0, shown, 50, {made / 2, 0, -7}, made), left, 2e-3) << made << " in " << shown;
        }
}

/// M10x1.5 in 8.5 mm below, M10x1 in 9 mm above, and a bore of 9 mm between them that the part shows with 8.5 mm.
TEST(ThreadBands, ThreadsOfOneAxisThatDoNotMeetOrHaveAnotherPitchExcuseNothingBetweenThem) {
    for (const double upper_core : {4.188, 4.459}) {
        ThreadBands bands;
        bands.add({0, 0, -13}, {0, 0, -20}, {0, 0, 1}, {4.188, 5, 4.376});
        bands.add({0, 0, 3}, {0, 0, -7}, {0, 0, 1}, {upper_core, 5, upper_core + 0.188});
        const mesh::Distance part(wall(5, 0, 40));
        bands.fit(wall(upper_core + 0.05, 0, 40), part, 0.01);
        EXPECT_NEAR(bands.judged({upper_core + 0.05, 0, -5}, 4.95 - upper_core), 0, 2e-3);
        EXPECT_NEAR(bands.judged({upper_core + 0.05, 0, -10}, 4.95 - upper_core), 4.95 - upper_core, 1e-9);
    }
    ThreadBands meeting;
    meeting.add({0, 0, -9}, {0, 0, -20}, {0, 0, 1}, {4.188, 5, 4.376});
    meeting.add({0, 0, 3}, {0, 0, -9}, {0, 0, 1}, {4.459, 5, 4.609});
    const mesh::Distance part(wall(5, 0, 40));
    meeting.fit(wall(4.25, 0, 40), part, 0.01);
    EXPECT_NEAR(meeting.judged({4.25, 0, -15}, 0.75), 0, 2e-3);
    EXPECT_NEAR(meeting.judged({4.25, 0, -5}, 0.75), 0.75, 1e-9);  // within the core of M10x1
}

TEST(ThreadBands, WhatIsNoThreadStays) {
    EXPECT_DOUBLE_EQ(left_of_it(0, 12, 50, {4.25, 0, -7}), 1.75);   // wider than any thread of this size
    EXPECT_DOUBLE_EQ(left_of_it(0, 10, 50, {4.25, 0, -23}), 0.75);  // below it
    EXPECT_DOUBLE_EQ(left_of_it(0, 10, 50, {3.0, 0, -7}), 2.0);     // within the core
}

}  // namespace
}  // namespace obrys::check
