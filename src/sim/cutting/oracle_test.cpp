/// What another program worked out (../shared/spec/oracle/physics/cutting_data.json): the cutting data of a thesis
/// beside what it prints, effective diameters, removal rates.

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

#include "base/oracle_testing.hpp"
#include "geom/vec.hpp"
#include "sim/cutting/data.hpp"
#include "sim/cutting/form.hpp"

namespace obrys::sim::cutting {
namespace {

using nlohmann::json;

const json& case_of(const json& oracle, const std::string& id) {
    for (const json& c : oracle.at("cases"))
        if (c.at("id") == id) return c;
    static const json none = json::object();
    return none;
}

class CuttingOracle : public base::testing::OracleTest {
protected:
    CuttingOracle() : OracleTest("physics/cutting_data.json") {}
};

constexpr double exact = 1e-9;

TEST_F(CuttingOracle, speeds_by_cutting_speed_and_diameter) {
    const struct {
        const char* id;
        double vc, diameter;
    } cases[] = {{"3.1", 160, 10}, {"3.7", 260, 63}};
    for (const auto& c : cases) {
        const json& told = case_of(oracle, c.id);
        Asked a;
        a[Value::cutting_speed] = c.vc;
        a[Value::diameter] = c.diameter;
        EXPECT_NEAR(solve(a, {})[Value::speed], told.at("n").get<double>(), exact) << c.id;
    }
}

TEST_F(CuttingOracle, effective_diameters) {
    for (const json& c : oracle.at("d_eff")) {
        const double diameter = c.at("D");
        EXPECT_NEAR(
            effective_diameter({diameter, diameter / 2, geom::radians(c.at("tilt_deg").get<double>())}, c.at("ap")),
            c.at("d_eff").get<double>(), exact)
            << c.dump();
    }
    EXPECT_NEAR(effective_diameter({10, 5, 0}, 1), case_of(oracle, "3.3").at("d_ef").get<double>(), exact);
}

TEST_F(CuttingOracle, the_printed_feed_is_none_of_its_speeds) {
    const json& told = case_of(oracle, "3.5");
    const auto feed = [](double speed, double per_tooth) {
        Asked a;
        a[Value::speed] = speed;
        a[Value::teeth] = 4;
        a[Value::feed_per_tooth] = per_tooth;
        return solve(a, {})[Value::feed];
    };
    EXPECT_NEAR(feed(8500, 0.035), told.at("vf_from_3_4").get<double>(), exact);
    EXPECT_NEAR(feed(6000, 0.035), told.at("vf_from_6000").get<double>(), exact);
    EXPECT_NEAR(feed(6000, 0.018), told.at("vf_at_fz_0_018").get<double>(), exact);

    Asked a;
    a[Value::speed] = 8500;
    a[Value::teeth] = 4;
    a[Value::feed_per_tooth] = 0.035;
    a[Value::feed] = told.at("printed").get<double>();
    const Data d = solve(a, {});
    ASSERT_EQ(d.differences.size(), 1U);
    EXPECT_EQ(d.differences[0].value, Value::feed);
    EXPECT_NEAR(d.differences[0].computed, told.at("vf_from_3_4").get<double>(), exact);
}

TEST_F(CuttingOracle, removal_rates) {
    for (const json& c : oracle.at("mrr")) {
        Asked a;
        a[Value::depth] = c.at("ap");
        a[Value::width] = c.at("ae");
        a[Value::feed] = c.at("vf");
        EXPECT_NEAR(solve(a, {})[Value::removal], c.at("Q_cm3_min").get<double>(), exact) << c.dump();
    }
}

}  // namespace
}  // namespace obrys::sim::cutting
