// Bodies whose volume is known by formula, made and written by Open CASCADE, read through the module.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "driver/loadable.hpp"
#include "driver/step_file.hpp"
#include "mesh/distance.hpp"
#include "mesh/solids.hpp"
#include "mesh/topology.hpp"
#include "shapes.hpp"

namespace obrys::driver {
namespace {

using step_test::shapes;
using step_test::step_text;

constexpr double tolerance = 0.01;

struct Read {
    std::optional<StepFile> file;
    base::Diagnostics said;

    [[nodiscard]] std::string text() const {
        std::string out;
        for (const base::Diagnostic& d : said.all()) out += std::string(d.code) + ": " + d.text + "\n";
        return out;
    }
};

Read read(const std::string& text, double to = tolerance, const Guard& guard = {}) {
    Read r;
    r.file = read_step(0, text, to, guard, r.said, {});
    return r;
}

class Peer : public testing::Test {
protected:
    void SetUp() override {
        if (!find_module("step")) GTEST_SKIP() << "needs the module libobrys-step.so";
    }
};

/// The most by which a mesh within `deflection` of a surface can miss the volume within it.
double slack(const mesh::Mesh& m) { return 1.01 * step_deflection(tolerance) * mesh::area(m) + 1e-6; }

void expect_extent(const mesh::Mesh& all, const step_test::Shape& wanted) {
    const mesh::Box box = mesh::bounds(all);
    const double d = step_deflection(tolerance) + 1e-6;
    EXPECT_NEAR(box.lo.x, wanted.low[0], d);
    EXPECT_NEAR(box.lo.y, wanted.low[1], d);
    EXPECT_NEAR(box.lo.z, wanted.low[2], d);
    EXPECT_NEAR(box.hi.x, wanted.high[0], d);
    EXPECT_NEAR(box.hi.y, wanted.high[1], d);
    EXPECT_NEAR(box.hi.z, wanted.high[2], d);
}

TEST_F(Peer, VolumeExtentAndClosedSurfaceInEveryUnit) {
    for (const auto& [name, wanted] : shapes()) {
        if (wanted.bodies == 0) continue;
        for (const std::string unit : {"MM", "INCH", "M"}) {
            SCOPED_TRACE(name + " " + unit);
            const Read r = read(step_text(name, unit));
            ASSERT_TRUE(r.file) << r.text();
            EXPECT_EQ(r.file->solids.size(), wanted.bodies);
            EXPECT_TRUE(r.file->closed) << r.text();
            EXPECT_EQ(r.text(), name == "mixed" ? "assumption: 1 face that bound no solid left out\n" : "");
            mesh::Mesh all;
            for (const mesh::Mesh& m : r.file->solids) {
                EXPECT_TRUE(mesh::topology(m).closed());
                mesh::append(all, m);
            }
            EXPECT_NEAR(mesh::volume(all), wanted.volume, slack(all));
            expect_extent(all, wanted);
            std::printf("%-9s %-4s %7zu triangles, volume off by %9.4f of %11.3f mm3\n", name.c_str(), unit.c_str(),
                        all.triangles.size(), mesh::volume(all) - wanted.volume, wanted.volume);
        }
    }
}

/// Distances of the vertices, edges' middles and triangles' centres from the true surface.
template <class Distance>
double farthest(const mesh::Mesh& m, Distance&& distance) {
    double most = 0;
    for (std::size_t t = 0; t < m.triangles.size(); ++t) {
        const auto c = mesh::corners(m, t);
        for (const geom::Vec3& p : {c[0], 0.5 * (c[0] + c[1]), 0.5 * (c[1] + c[2]), mesh::centre(m, t)})
            most = std::max(most, std::abs(distance(p)));
    }
    return most;
}

TEST_F(Peer, FacetsStayWithinAFifthOfTheTolerance) {
    for (const double wanted : {0.1, 0.01, 0.005}) {
        SCOPED_TRACE(wanted);
        const Read ball = read(step_text("ball", "MM"), wanted), ring = read(step_text("ring", "MM"), wanted);
        ASSERT_TRUE(ball.file && ring.file);
        const double of_ball =
            farthest(ball.file->solids[0], [](geom::Vec3 p) { return std::hypot(p.x - 1, p.y - 2, p.z - 3) - 10; });
        const double of_ring =
            farthest(ring.file->solids[0], [](geom::Vec3 p) { return std::hypot(std::hypot(p.x, p.y) - 10, p.z) - 3; });
        std::printf("tolerance %g: ball %.5f mm, ring %.5f mm off\n", wanted, of_ball, of_ring);
        EXPECT_LE(of_ball, step_deflection(wanted));
        EXPECT_LE(of_ring, step_deflection(wanted));
    }
}

TEST_F(Peer, BodiesThatTouchAreNotTakenForOnePart) {
    bool closed = true;
    base::Diagnostics said;
    const Read apart = read(step_text("apart", "MM")), touching = read(step_text("touching", "MM"));
    ASSERT_TRUE(apart.file && touching.file);
    EXPECT_EQ(mesh::united(0, apart.file->solids, closed, said).triangles.size(), 24U);
    EXPECT_TRUE(closed && said.all().empty());
    EXPECT_EQ(mesh::united(0, touching.file->solids, closed, said).triangles.size(), 24U);
    EXPECT_FALSE(closed);
    ASSERT_EQ(said.all().size(), 1U);
    EXPECT_EQ(said.all()[0].code, "mesh-not-closed");
}

TEST_F(Peer, SurfacesAreNoSolid) {
    const Read r = read(step_text("shell", "MM"));
    EXPECT_FALSE(r.file);
    EXPECT_EQ(r.text(), "mesh-file: the STEP file holds no solid; faces that bound none: 1\n");
}

TEST_F(Peer, AFileWithoutItsUnitIsRefused) {
    std::string text = step_text("block", "MM");
    const std::size_t unit = text.find("LENGTH_UNIT()"), from = text.rfind('\n', unit);
    text.erase(from, text.find('\n', unit) - from);
    const Read r = read(text);
    EXPECT_FALSE(r.file);
    EXPECT_EQ(r.text(), "mesh-file: the STEP file does not say its unit of length\n");
}

/// Whatever is done to a file, there is an answer: a mesh, or a complaint.
TEST_F(Peer, DamagedFiles) {
    const std::string whole = step_text("block", "MM");
    unsigned seed = 20261121, refused = 0, crashed = 0, seen = 0, read_anyway = 0;
    const auto random = [&](std::size_t n) {
        return static_cast<std::size_t>((seed = seed * 1664525 + 1013904223) >> 8) % n;
    };
    Guard guard;
    guard.seconds = 5;
    for (int i = 0; i < 100; ++i) {
        std::string text = whole;
        for (std::size_t faults = 1 + random(4); faults > 0; --faults) {
            const std::size_t at = 600 + random(text.size() - 700), kind = random(4);
            if (kind == 0) text.erase(at, 1 + random(40));
            if (kind == 1) text[at] = static_cast<char>('0' + random(10));
            if (kind == 2) text[at] = "#(),;'$*E-."[random(11)];
            if (kind == 3) text.insert(at, text.substr(600 + random(text.size() - 700), 1 + random(60)));
        }
        const Read r = read(text, 0.1, guard);
        if (r.text().find("the STEP file is damaged") != std::string::npos) ++seen;
        if (r.file) {
            ++read_anyway;
        } else {
            ++refused;
            ASSERT_FALSE(r.said.all().empty());
            EXPECT_EQ(r.said.all().back().code, "mesh-file");
            if (r.text().find("crashed") != std::string::npos) ++crashed;
        }
    }
    std::printf("%u refused (%u by grammar, in %u Open CASCADE crashed), %u read\n", refused, seen, crashed,
                read_anyway);
    EXPECT_GT(seen, refused / 2);
}

}  // namespace
}  // namespace obrys::driver
