#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "base/seed_testing.hpp"
#include "cycles/groove/oracle_testing.hpp"
#include "make/made.hpp"

namespace obrys::make {
namespace {

using groove::Side;
using groove::Strategy;

Order order_of(const groove::testing::Measures& m, double width, double infeed, double stepover) {
    Order o;
    o.request.shape = groove::testing::shape_of(m);
    o.request.insert.width = width;
    o.request.manner.infeed = infeed;
    o.request.manner.stepover = stepover;
    o.stepover_given = true;
    return o;
}

/// What must hold of every path, held against the simulation.
void expect_sound(const Made& made) {
    const Proof& p = made.proof;
    EXPECT_EQ(p.gouge, 0);
    EXPECT_EQ(p.rapid_in_stock, 0);
    // The strategies reckon with a sharp blade.
    const bool sharp = made.request.insert.corner_radius == 0;
    EXPECT_TRUE(!sharp || std::abs(p.removed_area - made.path.does.area) < 1e-6 + 1e-9 * p.asked_area);
    if (made.strategy != Strategy::single) {
        EXPECT_LE(p.rest, p.rest_bound + rest_accuracy);
        EXPECT_NEAR(p.removed_area, p.asked_area - p.rest_area, 1e-5 + 1e-8 * p.asked_area);
    }
    EXPECT_LE(made.path.does.widest_plunge, made.request.insert.width);
    EXPECT_GE(made.path.does.feed - made.path.does.air, p.removed_area / made.request.insert.width - 1e-3);
    const double top = (made.strategy == Strategy::finishing ? made.contours->finished : made.contours->rough).crest();
    EXPECT_GE(made.path.moves.back().to.y, top);  // out of the groove, above all stock beside it
}

TEST(MakeGroove, WhatIsBindingByTheExactSimulation) {
    for (const groove::testing::Binding& b : groove::testing::bindings) {
        SCOPED_TRACE(std::string(groove::named(b.strategy).word) + " " + b.name);
        const Made made = make_groove(order_of(b.measures, b.width, b.infeed, b.stepover), b.strategy);
        ASSERT_EQ(made.refusal.has_value(), b.refused);
        if (b.refused) continue;
        expect_sound(made);
        EXPECT_LE(made.proof.rest, b.rest + 1e-6);
        EXPECT_EQ(verdict_of(made), "clean");
    }
}

// Chapter 7 of the comparison: the groove of examples/groove with the source's cutting data.
TEST(MakeGroove, TimesOfTheComparison) {
    Order o = order_of(groove::testing::bindings[0].measures, 3, 1, 2.4);
    for (const auto& b : groove::testing::bindings)
        if (std::string_view(b.name) == "kod1") o.request.shape = groove::testing::shape_of(b.measures);
    o.stepover_given = false;
    const auto seconds = [&](Strategy s) { return make_groove(o, s).feed_time; };
    EXPECT_NEAR(seconds(Strategy::side_stepping), 2699, 27);
    EXPECT_NEAR(seconds(Strategy::side_stepping_high), 2744, 27);
    EXPECT_NEAR(seconds(Strategy::stepwise), 2953, 30);
    EXPECT_NEAR(seconds(Strategy::cycle93), 3691, 37);
    EXPECT_NEAR(seconds(Strategy::single), 169, 2);
    EXPECT_NEAR(seconds(Strategy::multiple), 2652, 27);
    EXPECT_NEAR(seconds(Strategy::finishing), 179, 2);
    EXPECT_EQ(make_groove(o, Strategy::cycle93).path.does.plunges, 2468U);
    EXPECT_EQ(make_groove(o, Strategy::single).path.does.plunges, 154U);
}

class Random {
public:
    explicit Random(std::uint32_t seed) : engine_(seed) {}
    double from(double a, double b) { return std::uniform_real_distribution<double>(a, b)(engine_); }
    bool one_in(int n) { return std::uniform_int_distribution<int>(1, n)(engine_) == 1; }
    groove::Corner corner(double most) {
        if (one_in(3)) return {};
        const auto form = one_in(3)   ? groove::Corner::Form::leg
                          : one_in(2) ? groove::Corner::Form::base
                                      : groove::Corner::Form::radius;
        return {from(0.05, most), form};
    }
    Order order() {
        Order o;
        groove::Shape& s = o.request.shape;
        s.p = {from(-50, 50), from(100, 200)};
        s.slope = one_in(3) ? 0 : geom::radians(from(-30, 30));
        s.depth = from(0.3, 40);
        s.width = from(2, 40);
        for (const Side side : {Side::left, Side::right}) {
            s.flank[groove::index(side)] = one_in(4) ? 0 : geom::radians(one_in(8) ? from(0, 70) : from(0, 25));
            s.outer[groove::index(side)] = corner(std::min(2.0, s.depth / 4));
            s.inner[groove::index(side)] = corner(std::min(2.0, s.depth / 4));
        }
        s.leave_bottom = one_in(2) ? 0 : from(0, 0.5);
        s.leave_flank = one_in(2) ? 0 : from(0, 0.5);
        groove::Insert& insert = o.request.insert;
        insert.width = one_in(8) ? s.width : from(0.8, std::min(8.0, s.width));
        insert.corner_radius = one_in(2) ? 0 : from(0, 0.2) * insert.width;
        groove::Manner& m = o.request.manner;
        m.infeed = from(0.3, 4);
        m.stepover = from(0.3, 1) * (insert.width - 2 * insert.corner_radius);
        m.peck = one_in(3) ? from(0.5, 3) : 0;
        m.clearance = from(0.2, 2);
        o.stepover_given = true;
        return o;
    }

private:
    std::mt19937 engine_;
};

TEST(MakeGroove, RandomGroovesAreCutSoundlyOrRefused) {
    const std::uint32_t seed = base::testing_seed();
    const char* more = std::getenv("OBRYS_GROOVES");
    const int count = more != nullptr ? std::stoi(more) : 40;
    std::size_t made_of = 0;
    for (int i = 0; i < count; ++i) {
        Random random(seed + static_cast<std::uint32_t>(i));
        const Order order = random.order();
        for (const groove::Named& n : groove::strategies()) {
            SCOPED_TRACE(std::string(n.word) + ", seed " + std::to_string(seed + static_cast<std::uint32_t>(i)));
            const Made made = make_groove(order, n.strategy);
            if (made.refusal) {
                EXPECT_FALSE(made.refusal->text.empty() || made.refusal->remedy.empty());
                continue;
            }
            ++made_of;
            expect_sound(made);
            const groove::Doings& d = made.path.does;
            EXPECT_LE(d.layer, made.request.manner.infeed + 1e-9);  // nothing asks for more
            if (n.strategy == Strategy::plunge_turning) {
                EXPECT_LE(d.thickest_side, d.layer + made.request.manner.lift + 1e-9);
            }
            EXPECT_LT(d.rib_width, made.request.insert.width);
            if (testing::Test::HasFailure()) return;
        }
    }
    EXPECT_GT(made_of, static_cast<std::size_t>(count));
}

// Surfaces and start sides are turned or mirrored pictures of one path.
TEST(MakeGroove, EverySurfaceIsAPictureOfThePlane) {
    for (const Surface surface : {Surface::outside, Surface::inside, Surface::face, Surface::counter_face})
        for (const bool turned : {false, true}) {
            const Placing p{surface, turned};
            const Vec2 a{3, 7}, b{5, 8}, back = p.in_groove(p.on_machine(a));
            EXPECT_DOUBLE_EQ(back.x, a.x);
            EXPECT_DOUBLE_EQ(back.y, a.y);
            const double turn = geom::cross(p.on_machine(a), p.on_machine(b)) / geom::cross(a, b);
            EXPECT_DOUBLE_EQ(turn, p.mirrors() ? -1 : 1);
            // A surface that rises along u, drawn on the machine, leads back to the same slope.
            const Vec2 along = p.on_machine({1, 0.25}) - p.on_machine({0, 0});
            const bool face = surface == Surface::face || surface == Surface::counter_face;
            const double drawn = std::atan(face ? along.x / along.y : along.y / along.x);
            EXPECT_DOUBLE_EQ(p.slope(drawn), std::atan(0.25));
        }
    // Out of the material: to larger x outside, smaller x in a bore, larger z on the face.
    EXPECT_EQ((Placing{Surface::outside, false}.on_machine({0, 1}).y), 1);
    EXPECT_EQ((Placing{Surface::inside, false}.on_machine({0, 1}).y), -1);
    EXPECT_EQ((Placing{Surface::face, false}.on_machine({0, 1}).x), 1);
    EXPECT_EQ((Placing{Surface::counter_face, false}.on_machine({0, 1}).x), -1);
    // On a face the right-hand side of (u, v) is the smaller x.
    EXPECT_LT((Placing{Surface::face, false}.on_machine({1, 0}).y), 0);
}

}  // namespace
}  // namespace obrys::make
