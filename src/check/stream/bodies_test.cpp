/// Shanks and holders through the whole check, against the part and against what is left of the stock, between the
/// rays: depths are known by formulas.

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "base/codes.hpp"
#include "base/seed_testing.hpp"
#include "check/result_testing.hpp"
#include "check/stream/check.hpp"
#include "mesh/primitives.hpp"

namespace obrys::check {

using geom::Vec3;
using testing::says;

namespace {

/// Moves of a program whose X and Y are turned about a place.
class Program {
public:
    Program(Setup setup, double turn = 0, Vec3 about = {}) : check_(std::move(setup), stacks_), about_(about) {
        c_ = std::cos(turn), s_ = std::sin(turn);
        take(cl::Feed{500, cl::FeedMode::per_minute});
        take(cl::Spindle{3000, cl::SpindleMode::rpm, 1, 0});
    }
    void tool(std::uint32_t number) { take(cl::ToolChange{number, 1, ""}); }
    void rapid(Vec3 to) { take(cl::Linear{place(to), {0, 0, 1}, true}); }
    void feed(Vec3 to) { take(cl::Linear{place(to), {0, 0, 1}, false}); }
    void arc(Vec3 to, Vec3 centre, double sweep) { take(cl::Arc{place(to), place(centre), {0, 0, 1}, sweep}); }
    [[nodiscard]] std::uint32_t next() const { return at_; }
    [[nodiscard]] Result finish() { return check_.finish(); }
    [[nodiscard]] Vec3 place(Vec3 p) const {
        const Vec3 d = p - about_;
        return about_ + Vec3{c_ * d.x - s_ * d.y, s_ * d.x + c_ * d.y, d.z};
    }

private:
    void take(cl::Step step) {
        check_.take({std::move(step), {0, at_, at_ + 1}, 0});
        ++at_;
    }
    cl::CallStacks stacks_;
    Check check_;
    Vec3 about_;
    double c_ = 1, s_ = 0;
    std::uint32_t at_ = 0;
};

shop::Tool mill(std::uint32_t number, double diameter, double edges, double length = 80) {
    shop::Tool t;
    t.number = number;
    t.kind = shop::ToolKind::end_mill;
    t.radius = diameter / 2;
    t.cutting_length = edges;
    t.length = length;
    return t;
}

Setup setup_of(std::vector<shop::Tool> tools, sim::milling::Stock stock, double tolerance) {
    Setup s;
    s.machine.kind = shop::MachineKind::mill;
    s.tools = std::move(tools);
    s.tools_given = true;
    s.milling.emplace();
    s.milling->stock = std::move(stock);
    s.milling->tolerance = tolerance;
    s.milling->threads = 1;
    s.scope = shop::Scope::collisions;
    return s;
}

struct Deepest {
    double depth = 0;
    std::uint32_t line = 0;
    std::string text;
};
Deepest deepest(const Result& r, std::string_view code) {
    Deepest d;
    for (const Finding& f : r.findings)
        for (const Amount& a : f.amounts)
            if (f.code == code && a.key == "depth_mm" && a.value > d.depth) d = {a.value, f.where.begin, f.text};
    return d;
}

}  // namespace

/// A holder passes an upright edge of the part askew, so near that `deep` of the edge is within.
TEST(Bodies, AHolderThatClipsThePartIsFoundWithItsDepth) {
    const std::uint32_t seed = base::testing_seed();
    std::mt19937 random(seed);
    for (int n = 0; n < 8; ++n) {
        SCOPED_TRACE("seed " + std::to_string(seed) + ", case " + std::to_string(n));
        const bool rapid = n % 2 == 0, misses = n % 4 == 3;
        const double deep = misses ? -0.002 : std::uniform_real_distribution(0.02, 0.2)(random);
        const double turn = std::uniform_real_distribution(0.35, 1.2)(random);
        shop::Tool t = mill(1, 6, 10, 60);
        t.shank = {{6, 6, 10}};
        t.holder = {{30, 30, 40}};
        check::Setup s = setup_of({t}, sim::milling::Box3{{0, 0, -30}, {60, 40, 0}}, 0.01);
        s.milling->part = std::make_shared<const mesh::Distance>(mesh::box({0, 0, -30}, {60, 40, 0}));
        s.scope = shop::Scope::all;
        const Vec3 out{-std::cos(turn), -std::sin(turn), 0}, way{-out.y, out.x, 0};
        const Vec3 middle = (15 - deep) * out + Vec3{0, 0, -25};
        Program p(s);
        p.tool(1);
        p.rapid(middle - 40.0 * way + Vec3{0, 0, 60});
        p.rapid(middle - 40.0 * way);
        const std::uint32_t guilty = p.next();
        if (rapid)
            p.rapid(middle + 40.0 * way);
        else
            p.feed(middle + 40.0 * way);
        p.rapid(middle + 40.0 * way + Vec3{0, 0, 60});
        const Result r = p.finish();
        const Deepest d = deepest(r, base::codes::holder_in_stock);
        EXPECT_NEAR(d.depth, std::max(0.0, deep), std::max(0.002, 0.1 * deep));
        if (misses) continue;
        EXPECT_EQ(d.line, guilty);
        EXPECT_NE(d.text.find("finished part"), std::string::npos) << d.text;
    }
}

/// A slot, then a thin cutter with a thicker shank beside its middle: the shank rubs one wall.
TEST(Bodies, AShankThatRubsAWallThatWasCutIsFound) {
    const std::uint32_t seed = base::testing_seed();
    std::mt19937 random(seed);
    for (int n = 0; n < 8; ++n) {
        SCOPED_TRACE("seed " + std::to_string(seed) + ", case " + std::to_string(n));
        const bool rapid = n % 2 == 0, misses = n % 4 == 3;
        const double deep = misses ? -0.003 : std::uniform_real_distribution(0.015, 0.2)(random);
        const double turn = std::uniform_real_distribution(0.0, 3.0)(random);
        shop::Tool thin = mill(2, 6, 5, 90);
        thin.shank = {{8, 8, 60}};
        check::Setup s = setup_of({mill(1, 10, 40), thin}, sim::milling::CylinderStock{2, {0, 0, -30}, 40, 30}, 0.01);
        Program p(s, turn);
        p.tool(1);
        p.rapid({-60, 0, 40});
        for (const double z : {-9.0, -18.0}) {
            p.rapid({-60, 0, z});
            p.feed({60, 0, z});
            p.rapid({60, 0, 40});
            p.rapid({-60, 0, 40});
        }
        p.tool(2);
        p.rapid({-20, 0, 40});
        p.rapid({-20, 0, -17});
        p.feed({-18, 1 + deep, -17});
        const std::uint32_t guilty = p.next();
        if (rapid)
            p.rapid({15, 1 + deep, -17});
        else
            p.feed({15, 1 + deep, -17});
        p.feed({18, 0, -17});
        p.rapid({18, 0, 40});
        const Result r = p.finish();
        const Deepest d = deepest(r, base::codes::holder_in_stock);
        EXPECT_NEAR(d.depth, std::max(0.0, deep), std::max(0.002, 0.12 * deep)) << d.text;
        EXPECT_FALSE(says(r, "not decided"));
        if (!misses) {
            EXPECT_LE(d.line, guilty);
        }
    }
}

/// Pockets in layers, deeper than the edges are long: the body above them, as thick as they are, touches all walls.
TEST(Bodies, ADeepPocketIsCutWithoutAlarm) {
    const std::uint32_t seed = base::testing_seed();
    std::mt19937 random(seed);
    for (int n = 0; n < 4; ++n) {
        SCOPED_TRACE("seed " + std::to_string(seed) + ", case " + std::to_string(n));
        const double turn = std::uniform_real_distribution(0.0, 3.0)(random);
        const double a = std::uniform_real_distribution(8.0, 14.0)(random), b = 7, r = 2;
        check::Setup s = setup_of({mill(1, 10, 9, 120)}, sim::milling::Box3{{-40, -40, -40}, {40, 40, 0}}, 0.01);
        Program p(s, turn);
        p.tool(1);
        p.rapid({0, 0, 30});
        p.rapid({0, 0, 1});
        for (double z = -4; z >= -32; z -= 4) {
            p.feed({0, 0, z});
            for (const double y : {-5.0, 0.0, 5.0}) {
                p.feed({-a + 1, y, z});
                p.feed({a - 1, y, z});
            }
            p.feed({0, b, z});
            p.feed({-a + r, b, z});
            p.arc({-a, b - r, z}, {-a + r, b - r, z}, geom::pi / 2);
            p.feed({-a, -b + r, z});
            p.arc({-a + r, -b, z}, {-a + r, -b + r, z}, geom::pi / 2);
            p.feed({a - r, -b, z});
            p.arc({a, -b + r, z}, {a - r, -b + r, z}, geom::pi / 2);
            p.feed({a, b - r, z});
            p.arc({a - r, b, z}, {a - r, b - r, z}, geom::pi / 2);
            p.feed({0, b, z});
            p.rapid({0, 0, z});
        }
        p.rapid({0, 0, 30});
        const Result done = p.finish();
        EXPECT_TRUE(done.findings.empty()) << done.findings.front().text;
        EXPECT_FALSE(says(done, "not decided"));
    }
}

/// Time that is up ends the check with what it has, and says where.
TEST(Bodies, TheTimeForACheckEndsIt) {
    check::Setup s = setup_of({mill(1, 10, 40)}, sim::milling::Box3{{0, 0, -30}, {60, 40, 0}}, 0.05);
    s.out_of_time = [] { return true; };
    Program p(s);
    p.tool(1);
    for (int i = 0; i < 40; ++i) p.feed({i % 2 == 0 ? -10.0 : 70.0, 1.0 * i, -2});
    const Result r = p.finish();
    EXPECT_EQ(r.verdict, Verdict::not_fully_checked);
    EXPECT_TRUE(says(r, "the time for the check is up: from move 1"));
}

}  // namespace obrys::check
