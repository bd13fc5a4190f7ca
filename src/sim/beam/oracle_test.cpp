/// Beams and blades that another program computed (../shared/spec/oracle/physics/beam.json): closed forms, Bessel's
/// roots, blades of several blanks before, while and after they are finished.

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "base/oracle_testing.hpp"
#include "geom/vec.hpp"
#include "sim/beam/beam.hpp"
#include "sim/beam/blade.hpp"

namespace obrys::sim::beam {
namespace {

using nlohmann::json;
using Kind = shop::BladeForm::Kind;

class BeamOracle : public base::testing::OracleTest {
protected:
    BeamOracle() : OracleTest("physics/beam.json") {}
};

void expect_near(double value, double expected, double relative, const std::string& what) {
    EXPECT_NEAR(value, expected, relative * std::abs(expected)) << what;
}

/// Coefficient c of 2 pi f = c sqrt(E I / m) / L2 with the root's section, length 1.
double coefficient(double frequency) { return 2 * geom::pi * frequency; }

TEST_F(BeamOracle, uniform) {
    Beam b;
    b.length = 1;
    b.section = [](double) { return Section{1, 1}; };
    const auto f = Model(b, 32).frequencies(3);
    for (std::size_t i = 0; i < f.size(); ++i) {
        const double root = oracle.at("roots_betaL_uniform")[i];
        expect_near(coefficient(f[i]), root * root, 1e-5, "mode " + std::to_string(i + 1));
    }
    const json& u = oracle.at("uniform");
    for (const auto& [elements, told] : u.at("fem").items()) {
        Beam blade;
        const double e = u.at("E").get<double>() / 1e6, w = 1000 * u.at("b").get<double>(),
                     h = 1000 * u.at("h").get<double>(), rho = u.at("rho").get<double>() * 1e-12;
        blade.length = 1000 * u.at("L").get<double>();
        blade.section = [=](double) { return Section{e * w * h * h * h / 12, rho * w * h}; };
        const auto hz = Model(blade, std::stoi(elements)).frequencies(3);
        for (std::size_t i = 0; i < hz.size(); ++i) expect_near(hz[i], told[i].get<double>(), 1e-6, elements);
    }
}

TEST_F(BeamOracle, wedge_and_cone_to_a_point) {
    Beam b;
    b.length = 1;
    b.section = [](double x) { return Section{std::pow(1 - x, 3), 1 - x}; };
    const auto wedge = Model(b).frequencies(2);
    for (std::size_t i = 0; i < wedge.size(); ++i)
        expect_near(coefficient(wedge[i]), oracle.at("wedge_exact")[i].get<double>(), 1e-5, "wedge");
    b.section = [](double x) { return Section{std::pow(1 - x, 4), (1 - x) * (1 - x)}; };
    expect_near(coefficient(Model(b).frequencies(1)[0]), oracle.at("cone_exact")[0].get<double>(), 1e-5, "cone");
}

shop::BladeForm linear(double root, double tip) { return {Kind::linear, root, tip, 0, {}}; }

shop::Blade blade_of(const json& b, const shop::BladeForm& blank) {
    shop::Blade blade;
    blade.elasticity = b.at("E").get<double>() / 1e6;
    blade.density = b.at("rho");
    blade.length = 1000 * b.at("L").get<double>();
    const double width = 1000 * b.at("b").get<double>(), finished = 1000 * b.at("h_final").get<double>();
    blade.width = linear(width, width);
    blade.finished = linear(finished, finished);
    blade.blank = blank;
    return blade;
}

TEST_F(BeamOracle, blades) {
    const json& b = oracle.at("blade");
    const double hollow = b.at("arc_R_concave_mm");
    for (const json& c : b.at("cases")) {
        const std::string shape = c.at("shape");
        const json& h = c.at("h_root_mid_tip_mm");
        shop::BladeForm blank = linear(h[0], h[2]);
        if (shape.find("sqrt") != std::string::npos) blank.kind = Kind::strength;
        if (shape.find("concave") != std::string::npos) blank.kind = Kind::arc, blank.radius = -hollow;
        if (shape.find("convex") != std::string::npos) blank.kind = Kind::arc, blank.radius = b.at("arc_R_convex_mm");
        shop::Blade blade = blade_of(b, blank);
        blade.stages = {0};
        const Stage s = study(blade).stages.front();
        for (std::size_t i = 0; i < 3; ++i) expect_near(s.frequencies[i], c.at("f_Hz")[i].get<double>(), 1e-3, shape);
        expect_near(s.tip_stiffness, c.at("tip_stiffness_N_per_mm"), 1e-3, shape);
        expect_near(s.mass_g, c.at("mass_g"), 1e-3, shape);
        expect_near(s.stress_ratio, c.at("max_over_mean_bending_stress"), 1e-3, shape);
        expect_near(s.middle, h[1], 1e-6, shape);
    }
}

TEST_F(BeamOracle, while_it_is_finished) {
    const struct {
        const char* name;
        double root, tip;
    } blanks[] = {{"segment blank 9->15", 9, 15}, {"constant 6", 6, 6}, {"variable 9->3.6", 9, 3.6}};
    for (const auto& blank : blanks) {
        shop::Blade blade = blade_of(oracle.at("blade"), linear(blank.root, blank.tip));
        const BladeResult r = study(blade);
        const json& told = oracle.at("blade_partly_finished").at("cases").at(blank.name);
        ASSERT_EQ(r.stages.size(), told.size());
        for (std::size_t i = 0; i < told.size(); ++i) {
            EXPECT_EQ(r.stages[i].finished, told[i][0].get<double>());
            expect_near(r.stages[i].frequencies[0], told[i][1].get<double>(), 1e-3, blank.name);
            expect_near(r.stages[i].tip_stiffness, told[i][2].get<double>(), 1e-3, blank.name);
        }
    }
}

TEST_F(BeamOracle, tooth_passing) {
    for (const json& c : oracle.at("tooth_passing")) {
        const Excitation e = excitation(c.at("n"), c.at("z"), c.at("f1"), 0.005);
        expect_near(e.tooth_passing, c.at("tooth_passing_Hz"), 1e-12, c.dump());
        EXPECT_EQ(e.harmonic, c.at("nearest_harmonic").get<int>()) << c.dump();
        expect_near(e.ratio, c.at("ratio"), 1e-12, c.dump());
    }
}

/// The tap test of a fan's blades: blanks of constant allowance and unroughed ones sound deeper than those of variable
/// allowance, which are as heavy as the constant ones.
TEST(Blade, the_order_of_the_tap_test) {
    shop::Blade blade;
    blade.elasticity = 70000;
    blade.density = 2700;
    blade.length = 80;
    blade.width = linear(30, 30);
    blade.finished = linear(3, 3);
    blade.stages = {0};
    const auto first = [&](const shop::BladeForm& blank) {
        blade.blank = blank;
        return study(blade).stages.front();
    };
    const Stage unroughed = first(linear(9, 15)), constant = first(linear(6, 6)), variable = first(linear(9, 3.6));
    EXPECT_LT(constant.frequencies[0], unroughed.frequencies[0]);
    EXPECT_LT(unroughed.frequencies[0], variable.frequencies[0]);
    EXPECT_NEAR(variable.mass_g, constant.mass_g, 0.06 * constant.mass_g);
    EXPECT_GT(variable.frequencies[0] / constant.frequencies[0], 1.65);
}

TEST(Blade, a_root_that_gives_way_and_a_speed_that_does_not_ring) {
    shop::Blade blade;
    blade.elasticity = 70000;
    blade.density = 2700;
    blade.length = 80;
    blade.width = linear(30, 30);
    blade.finished = blade.blank = linear(3, 3);
    blade.stages = {0};
    const double clamped = study(blade).stages.front().frequencies[0];
    blade.root_stiffness = 1e9;
    EXPECT_NEAR(study(blade).stages.front().frequencies[0], clamped, 1e-4 * clamped);
    blade.root_stiffness = 1;
    EXPECT_LT(study(blade).stages.front().frequencies[0], 0.2 * clamped);
    blade.root_stiffness.reset();

    blade.speed = 30 * clamped;  // two teeth: the tooth passing frequency is the natural one
    blade.teeth = 2;
    const Stage s = study(blade).stages.front();
    ASSERT_TRUE(s.excitation && s.excitation->rings);
    EXPECT_NEAR(s.excitation->amplification, 100, 0.1);
    ASSERT_TRUE(s.excitation->better_speed);
    blade.speed = *s.excitation->better_speed;
    EXPECT_FALSE(study(blade).stages.front().excitation->rings);
}

}  // namespace
}  // namespace obrys::sim::beam
