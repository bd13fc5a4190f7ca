#include "write/staircase.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "write/post_testing.hpp"
#include "write/writer_testing.hpp"

namespace obrys::write {
namespace {

using geom::Vec2;
using geom::Vec3;

struct Ran {
    std::vector<Vec3> way;  ///< where each move leads
    std::vector<std::string> lost;
    StaircaseSums sums;
};

Ran run(const StaircaseForm& form, const std::vector<cl::Step>& steps) {
    Ran out;
    Staircase stairs(form, {[&](const cl::Record& r) {
                                const auto* line = std::get_if<cl::Linear>(&r.step);
                                if (line != nullptr && geom::is_finite(line->to)) out.way.push_back(line->to);
                            },
                            [&](const cl::Record&, std::string what) { out.lost.push_back(std::move(what)); },
                            [](const cl::Record&, const std::string&) {}});
    for (const cl::Step& step : steps) stairs.take({step, {}, 0});
    stairs.finish();
    out.sums = stairs.sums();
    return out;
}

StaircaseForm asked(double roughness) {
    StaircaseForm form;
    form.roughness = form.deviation = roughness;
    return form;
}

/// How far a point lies from the way, by itself: no function of the product measures it.
double distance_of(const Vec2& p, const std::vector<Vec3>& way) {
    double nearest = 1e300;
    for (std::size_t i = 1; i < way.size(); ++i) {
        const double ax = way[i - 1].x, ay = way[i - 1].y, bx = way[i].x, by = way[i].y;
        // Along one axis: the nearest point is the one clamped into the box of the move.
        const double x = std::min(std::max(p.x, std::min(ax, bx)), std::max(ax, bx));
        const double y = std::min(std::max(p.y, std::min(ay, by)), std::max(ay, by));
        nearest = std::min(nearest, std::hypot(p.x - x, p.y - y));
    }
    return nearest;
}

int axes_that_move(const Vec3& a, const Vec3& b) { return (a.x != b.x) + (a.y != b.y) + (a.z != b.z); }

/// A contour's element by its own parameter, with the normal towards the tool.
struct Contour {
    bool arc = false;
    Vec2 from, to, centre;
    double radius = 0, start = 0, sweep = 0;
    bool inner = false, left = false;

    [[nodiscard]] std::pair<Vec2, Vec2> at(double t) const {
        if (arc) {
            const double a = start + sweep * t;
            const Vec2 out{std::cos(a), std::sin(a)};
            return {centre + radius * out, inner ? -out : out};
        }
        const Vec2 way = to - from;
        const Vec2 n = 1 / geom::length(way) * geom::left_of(way);
        return {from + t * way, left ? n : -n};
    }
};

class Random {
public:
    double operator()(double a, double b) { return std::uniform_real_distribution<double>(a, b)(random_); }
    bool coin() { return (*this)(0, 1) < 0.5; }

private:
    std::mt19937 random_{20};
};

Contour random_contour(Random& random, double tool) {
    Contour c;
    c.arc = random.coin();
    c.left = random.coin();
    c.from = {random(-50, 50), random(-50, 50)};
    c.to = {random(-50, 50), random(-50, 50)};
    c.centre = {random(-50, 50), random(-50, 50)};
    c.start = random(0, geom::full_turn);
    c.sweep = random(0.05, 7) * (random.coin() ? 1 : -1);
    c.inner = c.left == (c.sweep > 0);
    c.radius = c.inner ? tool + random(0.1, 60) : random.coin() ? random(0, 60) : 0;
    return c;
}

/// The element's equidistant as a control would run it under radius compensation.
std::vector<cl::Step> steps_of(const Contour& c, double tool) {
    const auto [p, n] = c.at(0);
    const auto [q, m] = c.at(1);
    const Vec2 a = p + tool * n, b = q + tool * m;
    cl::CompensationBegin begin;
    begin.side = c.left ? cl::CompensationSide::left : cl::CompensationSide::right;
    begin.radius = tool;
    std::vector<cl::Step> steps{cl::Feed{100}, cl::Linear{{a.x, a.y, -1}, {0, 0, 1}, true}, begin};
    if (c.arc)
        steps.emplace_back(cl::Arc{{b.x, b.y, -1}, {c.centre.x, c.centre.y, -1}, {0, 0, 1}, c.sweep});
    else
        steps.emplace_back(cl::Linear{{b.x, b.y, -1}});
    return steps;
}

TEST(Staircase, NeverCutsIntoThePartAndLeavesNoHigherRidgeThanAskedFor) {
    Random random;
    for (int i = 0; i < 300; ++i) {
        const double tool = random(1, 30), ridge = random(0.005, 0.4) * tool;
        const Contour contour = random_contour(random, tool);
        const Ran ran = run(asked(ridge), steps_of(contour, tool));
        ASSERT_TRUE(ran.lost.empty());
        for (std::size_t k = 1; k < ran.way.size(); ++k)
            ASSERT_LE(axes_that_move(ran.way[k - 1], ran.way[k]), 1) << "case " << i;
        EXPECT_LE(ran.sums.ridge, ridge + 1e-9) << "case " << i;
        constexpr int samples = 700;
        for (int k = 0; k <= samples; ++k) {
            const auto [p, towards_tool] = contour.at(k / double(samples));
            ASSERT_GE(distance_of(p, ran.way), tool - 1e-6) << "case " << i << ": cuts into the part";
            for (const double height : {ridge + 1e-6, (ridge + tool) / 2, tool})
                ASSERT_LE(distance_of(p + height * towards_tool, ran.way), tool + 1e-6)
                    << "case " << i << ": " << height << " mm above the contour stands material";
        }
    }
}

TEST(Staircase, WithoutASideItStaysNearThePath) {
    Random random;
    for (int i = 0; i < 200; ++i) {
        StaircaseForm form = asked(random(0.02, 2));
        const Contour path = random_contour(random, 0.5);
        std::vector<cl::Step> steps = steps_of(path, 0);
        std::erase_if(steps, [](const cl::Step& s) { return std::holds_alternative<cl::CompensationBegin>(s); });
        if (path.arc && path.radius < 0.1) continue;
        const Ran ran = run(form, steps);
        ASSERT_TRUE(ran.lost.empty());
        EXPECT_EQ(ran.sums.ridge, 0);
        constexpr int samples = 2000;
        for (const Vec3& at : ran.way) {  // corners and places: no point of the way is farther off
            double nearest = 1e300;
            for (int k = 0; k <= samples; ++k)
                nearest = std::min(nearest, geom::distance(path.at(k / double(samples)).first, {at.x, at.y}));
            ASSERT_LE(nearest, form.deviation + 0.15) << "case " << i;  // the samples' own distance
        }
        for (int k = 0; k <= 100; ++k)
            ASSERT_LE(distance_of(path.at(k / 100.0).first, ran.way), form.deviation + 1e-9) << "case " << i;
        EXPECT_LE(ran.sums.either, form.deviation + 1e-9);
    }
}

/// Distance of a wall of the contour from the way; the wall straight.
double distance_of_wall(const Vec2& from, const Vec2& to, const std::vector<Vec3>& way) {
    double nearest = 1e300;
    constexpr int samples = 4000;
    for (int k = 0; k <= samples; ++k)
        nearest = std::min(nearest, distance_of(from + (k / double(samples)) * (to - from), way));
    return nearest;
}

TEST(Staircase, NarrowSlotsAndWedgesAreNotCutWider) {
    Random random;
    int would_cut = 0;
    for (int i = 0; i < 60; ++i) {
        // Along one wall, round its end to the other, and back along that, which leaves the tool hardly more room than
        // it needs.
        const double tool = random(2, 12), angle = random(0, geom::full_turn), opening = random(0, 0.4),
                     gap = random(0.01, 1);
        const Vec2 u{std::cos(angle), std::sin(angle)}, v{std::cos(angle + opening), std::sin(angle + opening)};
        const Vec2 n = geom::left_of(u), m = -geom::left_of(v);  // towards the tool, which is left of both ways
        const Vec2 begin{random(-20, 20), random(-20, 20)}, end = begin + 60 * u;
        const Vec2 back = end + (2 * tool + gap + 60 * std::sin(opening)) * n, far = back - 60 * v;
        const auto at = [](const Vec2& p) { return Vec3{p.x, p.y, -1}; };
        cl::CompensationBegin compensation;
        compensation.radius = tool;
        std::vector<cl::Step> steps{cl::Feed{100},
                                    cl::Linear{at(begin - 30 * u + tool * n), {0, 0, 1}, true},
                                    compensation,
                                    cl::Linear{at(begin + tool * n)},
                                    cl::Linear{at(end + tool * n)},
                                    cl::Linear{at(end + tool * n + 20 * u)},
                                    cl::Linear{at(back + tool * m + 20 * v)},
                                    cl::Linear{at(back + tool * m)},
                                    cl::Linear{at(far + tool * m)}};
        const Ran ran = run(asked(0.3 * tool), steps);
        // The same without knowing what is a contour: the side alone.
        steps.erase(steps.begin() + 2);
        StaircaseForm blind = asked(0.3 * tool);
        blind.part = StaircaseForm::Part::right, blind.tool_diameter = 2 * tool;
        would_cut += distance_of_wall(begin, end, run(blind, steps).way) < tool - 0.01;
        EXPECT_GE(distance_of_wall(begin, end, ran.way), tool - 0.003) << "case " << i;
        EXPECT_GE(distance_of_wall(back, far, ran.way), tool - 0.003) << "case " << i;
        EXPECT_LE(ran.sums.into, 0.003);
        EXPECT_LE(ran.sums.ridge, 0.3 * tool + 1e-9);
    }
    EXPECT_GT(would_cut, 20);
}

TEST(Staircase, RunsAboveRampsAndUprightArcs) {
    const auto above = [](const Ran& ran, const auto& height) {
        for (std::size_t i = 1; i < ran.way.size(); ++i) {
            const Vec3 &a = ran.way[i - 1], &b = ran.way[i];
            for (const double t : {0.0, 0.25, 0.5, 0.75, 1.0}) {
                const Vec3 p = a + t * (b - a);
                EXPECT_GE(p.z, height(p.x) - 1e-9);
                EXPECT_LE(p.z, height(p.x) + 20);
            }
        }
    };
    const Ran down = run(asked(0.1), {cl::Linear{{0, 0, 0}, {0, 0, 1}, true}, cl::Linear{{20, 0, -5}}});
    EXPECT_NEAR(down.sums.above, 0.1, 1e-9);
    above(down, [](double x) { return -x / 4; });
    const Ran up = run(asked(0.1), {cl::Linear{{0, 0, -5}, {0, 0, 1}, true}, cl::Linear{{20, 0, 0}}});
    above(up, [](double x) { return -5 + x / 4; });
    const Ran dome = run(
        asked(0.1), {cl::Linear{{-10, 0, 0}, {0, 0, 1}, true}, cl::Arc{{10, 0, 0}, {0, 0, 0}, {0, 1, 0}, geom::pi}});
    EXPECT_LE(dome.sums.above, 0.1 + 1e-9);
    above(dome, [](double x) { return std::sqrt(std::max(0.0, 100 - x * x)); });
    const Ran bowl = run(
        asked(0.1), {cl::Linear{{-10, 0, 0}, {0, 0, 1}, true}, cl::Arc{{10, 0, 0}, {0, 0, 0}, {0, -1, 0}, geom::pi}});
    above(bowl, [](double x) { return -std::sqrt(std::max(0.0, 100 - x * x)); });
}

TEST(Staircase, RapidsGoUpFirstAndDownLast) {
    const Ran ran = run(asked(0.1), {cl::Linear{{0, 0, 5}, {0, 0, 1}, true}, cl::Linear{{10, 20, 50}, {0, 0, 1}, true},
                                     cl::Linear{{0, 0, 2}, {0, 0, 1}, true}});
    const std::vector<Vec3> expected{{0, 0, 50}, {10, 0, 50}, {10, 20, 50}, {0, 20, 50}, {0, 0, 50}, {0, 0, 2}};
    ASSERT_GE(ran.way.size(), expected.size());
    EXPECT_TRUE(std::equal(expected.rbegin(), expected.rend(), ran.way.rbegin()));
    EXPECT_EQ(ran.sums.slopes, 0U);
}

TEST(Staircase, TheWayOnTheFreeSideCanBeLimited) {
    StaircaseForm form = asked(0.5);
    cl::CompensationBegin begin;
    begin.radius = 20;
    const std::vector<cl::Step> steps{cl::Linear{{0, 0, 0}, {0, 0, 1}, true}, begin, cl::Linear{{80, 60, 0}}};
    EXPECT_GT(run(form, steps).sums.beside, 1);
    form.away = 0.25;
    EXPECT_LE(run(form, steps).sums.beside, 0.25 + 1e-9);
}

TEST(Staircase, ThePostMaySayOnWhichSideThePartIs) {
    StaircaseForm form = asked(0.5);
    form.part = StaircaseForm::Part::right;
    form.tool_diameter = 10;
    const Ran ran = run(form, {cl::Linear{{0, 0, 0}, {0, 0, 1}, true}, cl::Linear{{10, 10, 0}}});
    EXPECT_GT(ran.sums.touching, 0U);
    EXPECT_EQ(ran.way[1].x, 0);  // up first: left of the way
}

TEST(Staircase, WhatCannotBeDoneIsSaid) {
    const cl::Linear start{{0, 0, 0}, {0, 0, 1}, true};
    const auto lost = [&](const cl::Step& step) { return run(asked(0.1), {start, step}).lost.size(); };
    EXPECT_EQ(lost(cl::Spline{{1, 0, 0}, {}, {}, {}, {0, 0, 1}, {}}), 1U);
    EXPECT_EQ(lost(cl::Thread{{1, 0, -5}, 1}), 1U);
    EXPECT_EQ(lost(cl::Thread{{0, 0, -5}, 1}), 0U);
    EXPECT_EQ(lost(cl::Arc{{0, 5, 0}, {0, 0, 0}, {0, 0.6, 0.8}, 1}), 1U);
    EXPECT_EQ(lost(cl::Linear{{1, 1, 0}, {0, 0, 1}, false, cl::Seek::contact}), 1U);
    EXPECT_EQ(lost(cl::Linear{{1e9, 1e9, 0}}), 1U);
    EXPECT_EQ(run(asked(0.1), {cl::Linear{{1, 1, 0}}}).lost.size(), 0U);  // axis by axis: its start is not known
    EXPECT_EQ(lost(cl::Linear{{1, NAN, 3}}), 1U);
    const auto turned = [](const Vec3& to) { return cl::Linear{to, {0, 0, 1}, false, cl::Seek::nothing, {{{'B'}}}}; };
    EXPECT_EQ(run(asked(0.1), {start, turned({1, 0, 0})}).lost.size(), 1U);
    EXPECT_EQ(run(asked(0.1), {start, turned({0, 0, 0})}).lost.size(), 0U);
}

const char* const stairs_post =
    "[modal]\ncoordinates = [\"X\", \"Y\", \"Z\"]\ngroups = [[\"G0\", \"G1\"]]\n[motion]\nrapid = \"G0 X{x} Y{y} "
    "Z{z}\"\n"
    "linear = \"G1 X{x} Y{y} Z{z}\"\n[staircase]\nroughness = 0.5\n";

TEST(Staircase, IsWrittenByAPostThatAsksForIt) {
    const Written w = write(post_of(std::string(stairs_post) + "deviation = 1.0\n"),
                            {cl::Linear{{0, 0, 5}, {0, 0, 1}, true}, cl::Linear{{4, 4, 5}}});
    EXPECT_EQ(w.text, "G0 X0\nY0\nZ5\nG1 Y1.333\nX1.333\nY2.667\nX2.667\nY4\nX4\n");
    EXPECT_TRUE(w.lost.empty());
}

TEST(Staircase, NoBlockNamesTwoAxesWhateverHasBeenForgotten) {
    const Post post = post_of(std::string(stairs_post) + "[tool]\nchange = \"T{number}\"\n");
    cl::ToolChange tool;
    tool.number = 2;
    cl::Datum other;
    other.number = 55, other.origin = {1, 2, 3};
    const auto at = [](double x, double y, double z, bool rapid) { return cl::Linear{{x, y, z}, {0, 0, 1}, rapid}; };
    const Written w = write(post, {at(1, 2, NAN, true), at(1, 2, 3, true), at(4, 5, 3, false), tool, at(9, 5, 3, true),
                                   at(9, 7, 8, true), other, at(5, 5, 5, true), tool, at(5, 5, 1, false),
                                   cl::Arc{{7, 7, 1}, {5, 7, 1}, {0, 0, 1}, geom::pi / 2}});
    EXPECT_EQ(w.text.find("Z3\n", w.text.find("T2")), w.text.find("T2") + 6)
        << w.text;  // another tool stands elsewhere
    for (std::size_t begin = 0; begin < w.text.size();) {
        const std::string line = w.text.substr(begin, w.text.find('\n', begin) - begin);
        EXPECT_LE(std::count_if(line.begin(), line.end(), [](char c) { return c >= 'X' && c <= 'Z'; }), 1) << w.text;
        begin += line.size() + 1;
    }
}

TEST(Staircase, APostWithStaircasesHasNoWordsForOtherMoves) {
    EXPECT_EQ(faults_of(stairs_post), "");
    EXPECT_NE(faults_of(std::string(stairs_post) + "[compensation]\nleft = \"G41\"\n").find("compensation.left"),
              std::string::npos);
    EXPECT_NE(faults_of("extends = \"fanuc\"\n[staircase]\nroughness = 1\n").find("motion.arc-cw"), std::string::npos);
    EXPECT_NE(faults_of("[staircase]\ndeviation = 1\n").find("roughness"), std::string::npos);
    EXPECT_NE(faults_of("[staircase]\nroughness = 0\n"), "");
    EXPECT_NE(faults_of("[staircase]\nroughness = 1\npart = \"left\"\n").find("tool_diameter"), std::string::npos);
    EXPECT_NE(faults_of("[staircase]\nroughness = 1\nfiner = 2\n").find("finer"), std::string::npos);
}

}  // namespace
}  // namespace obrys::write
