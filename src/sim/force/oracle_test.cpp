/// Forces that another program computed (../shared/spec/oracle/physics/force.json): closed forms, and sums over 7200
/// places of a revolution.

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "base/oracle_testing.hpp"
#include "sim/force/deflection.hpp"
#include "sim/force/milling.hpp"
#include "sim/force/processes.hpp"

namespace obrys::sim::force {
namespace {

using geom::pi;
using nlohmann::json;

constexpr double closed = 1e-12, numeric = 3e-3, sloping = 1e-2;
constexpr int fine = 7200;

class ForceOracle : public base::testing::OracleTest {
protected:
    ForceOracle() : OracleTest("physics/force.json") {}
    void SetUp() override {
        OracleTest::SetUp();
        if (IsSkipped()) return;
        const json& k = oracle.at("K_used");
        linear.cut = {k[0], k[1], k[2]};
        linear.edge = {k[3], k[4], k[5]};
    }
    cutting::Law linear;
};

void expect_near(double value, double expected, double relative, const std::string& what) {
    EXPECT_NEAR(value, expected, relative * std::abs(expected)) << what;
}

cutting::Law kienzle(const json& c) {
    cutting::Law law;
    law.cut.tangential = c.at("kc11");
    law.exponent = c.at("mc");
    return law;
}

TEST_F(ForceOracle, cylinders) {
    for (const json& c : oracle.at("cylindrical")) {
        const std::string name = c.at("name");
        const double diameter = c.at("D"), depth = c.at("ap"), feed = c.at("fz");
        const int teeth = c.at("N");
        const Arc arc{geom::radians(c.at("phi_st_deg").get<double>()), geom::radians(c.at("phi_ex_deg").get<double>())};
        const ClosedMeans m = closed_means(linear, teeth, diameter, depth, feed, arc);
        const json& told = c.at("mean_closed_Fx_Fy_Fz");
        expect_near(m.x, told[0], closed, name);
        expect_near(m.y, told[1], closed, name);
        expect_near(m.axial, told[2], closed, name);
        expect_near(m.torque, c.at("mean_torque_closed_Nmm"), closed, name);

        const double helix = geom::radians(c.at("helix_deg").get<double>());
        const auto rings = flank(diameter, 0, depth, helix, helix > 0 ? 100 : 1, arc);
        const Forces f = forces(rings, teeth, {feed, 0}, linear, fine);
        const json& sums = c.at("numeric");
        expect_near(f.mean.x, sums.at("mean")[0], numeric, name);
        expect_near(f.mean.y, sums.at("mean")[1], numeric, name);
        expect_near(-f.mean.z, sums.at("mean")[2], numeric, name);
        expect_near(f.mean_resultant, sums.at("mean_resultant"), numeric, name);
        expect_near(geom::length(f.mean), sums.at("resultant_of_means"), numeric, name);
        expect_near(f.peak, sums.at("peak"), numeric, name);
        expect_near(f.rms, sums.at("rms"), numeric, name);
        expect_near(f.mean_torque, sums.at("mean_torque_Nmm"), numeric, name);
        expect_near(forces(rings, teeth, {feed, 0}, linear).mean_resultant, sums.at("mean_resultant"), 1e-2, name);
        expect_near(section(rings, {1, 0}), depth * c.at("ae").get<double>(), 1e-9, name);
    }
}

TEST_F(ForceOracle, slot_by_kienzle) {
    for (const json& c : oracle.at("kienzle_slot")) {
        const auto rings = flank(c.at("D"), 0, c.at("ap"), 0, 1, {0, pi});
        const Forces f = forces(rings, c.at("N"), {c.at("fz"), 0}, kienzle(c), fine);
        expect_near(f.mean_torque, c.at("mean_torque_Nmm"), numeric, c.dump());
    }
}

TEST_F(ForceOracle, turning_and_grooving) {
    for (const json& c : oracle.at("turning")) {
        const bool blade = c.at("kappa_deg").is_null();
        const double vc = c.at("vc");
        const Turning t =
            blade ? grooving(kienzle(c), c.at("ap"), c.at("f"), vc)
                  : turning(kienzle(c), c.at("ap"), c.at("f"), geom::radians(c.at("kappa_deg").get<double>()), vc);
        expect_near(t.chip, c.at("h"), closed, c.dump());
        expect_near(t.width, c.at("b"), closed, c.dump());
        expect_near(t.cutting, c.at("Fc_N"), closed, c.dump());
        expect_near(t.power, 1000 * c.at("P_kW").get<double>(), closed, c.dump());
    }
}

TEST_F(ForceOracle, ball_in_a_slot) {
    for (const json& c : oracle.at("ball_slot")) {
        const double radius = c.at("R"), depth = c.at("ap");
        auto rings = round_edge(0, radius, 0, std::acos(1 - depth / radius), 0, 400);
        for (Ring& r : rings) r.arcs = {{0, pi}};
        const Forces f = forces(rings, c.at("N"), {c.at("fz"), 0}, linear, fine);
        const json& told = c.at("mean_closed");
        expect_near(f.mean.x, told[0], numeric, c.dump());
        expect_near(f.mean.y, told[1], numeric, c.dump());
        expect_near(f.mean.z, told[2], numeric, c.dump());
        const json& sums = c.at("numeric").at("1600");
        expect_near(f.mean_resultant, sums.at("mean_resultant"), numeric, c.dump());
        expect_near(f.peak, sums.at("peak"), numeric, c.dump());
        expect_near(section(rings, {1, 0}), sums.at("area_mm2"), numeric, c.dump());
        EXPECT_NEAR(f.engaged, sums.at("engaged_fraction").get<double>(), 1e-3);
    }
}

/// A ball on a slope beside its last row: engaged is what lies under the surface that is cut and not in that row.
TEST_F(ForceOracle, ball_on_a_slope) {
    for (const json& c : oracle.at("ball_slope")) {
        const double radius = c.at("R"), depth = c.at("ap"), row = c.at("stepover");
        const double slope = geom::radians(c.at("slope_deg").get<double>());
        const geom::Vec3 way{std::cos(slope), 0, std::sin(slope)}, normal{-std::sin(slope), 0, std::cos(slope)};
        auto rings = round_edge(0, radius, 0, pi / 2, 0, 800);
        constexpr int angles = 3600;
        for (Ring& r : rings) {
            for (int i = 0; i < angles; ++i) {
                const double a = (i + 0.5) * 2 * pi / angles;
                const geom::Vec3 out{std::sin(r.lean) * std::sin(a), std::sin(r.lean) * std::cos(a), -std::cos(r.lean)};
                const geom::Vec3 p = radius * out, last = p - geom::Vec3{0, -row, 0};
                const double across =
                    std::sqrt(std::max(0.0, geom::dot(last, last) - geom::dot(last, way) * geom::dot(last, way)));
                if (radius + geom::dot(p, normal) > depth || across < radius) continue;
                const double step = 2 * pi / angles;
                if (!r.arcs.empty() && r.arcs.back().to > a - 0.75 * step)
                    r.arcs.back().to = a + step / 2;
                else
                    r.arcs.push_back({a - step / 2, a + step / 2});
            }
        }
        const Forces f = forces(rings, c.at("N"), {c.at("fz").get<double>() * way.x, -c.at("fz").get<double>() * way.z},
                                linear, 3600);
        const json& told = c.at("result");
        const std::string what = c.at("slope_deg").dump() + " deg, " + c.at("ap").dump();
        expect_near(f.mean_resultant, told.at("mean_resultant"), sloping, what);
        expect_near(f.peak, told.at("peak"), sloping, what);
        expect_near(f.mean.x, told.at("mean")[0], sloping, what);
        expect_near(f.mean.y, told.at("mean")[1], sloping, what);
        expect_near(f.mean.z, told.at("mean")[2], sloping, what);
        EXPECT_NEAR(f.engaged, told.at("engaged_fraction").get<double>(), 5e-3) << what;
        expect_near(section(rings, {way.x, -way.z}), told.at("area_mm2"), sloping, what);
    }
}

TEST_F(ForceOracle, tools_that_give_way) {
    for (const json& c : oracle.at("tool_deflection")) {
        ToolBeam t{c.at("D"), c.at("flute_len"), c.at("shank_len"), c.at("E"), c.at("core_ratio")};
        expect_near(stiffness(t), c.at("k_N_per_mm"), closed, c.dump());
        expect_near(c.at("F_tip").get<double>() / stiffness(t), c.at("deflection_mm"), closed, c.dump());
        t.holder = 10000;
        EXPECT_LT(stiffness(t), c.at("k_N_per_mm").get<double>());
    }
}

TEST(Drilling, as_much_power_as_it_removes) {
    cutting::Law law;
    law.cut.tangential = 1500;
    law.exponent = 0.22;
    const double diameter = 8.5, feed = 0.08, point = geom::radians(118);
    const Drilling d = drilling(law, diameter, 2, feed, point);
    const double chip = feed * std::sin(point / 2), kc = cutting::force(law, chip).tangential / chip;
    EXPECT_NEAR(d.torque, kc * 2 * feed * diameter * diameter / 8, 1e-9);
    EXPECT_NEAR(d.thrust, 0.5 * kc * 2 * feed * diameter / 2 * std::sin(point / 2), 1e-9);
}

}  // namespace
}  // namespace obrys::sim::force
