/// The costs of a thesis (../shared/spec/oracle/physics/cost.json), and what a price from the cycle alone leaves out.

#include "sim/cost/cost.hpp"
#include "base/oracle_testing.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numeric>

namespace obrys::sim::cost {
namespace {

using nlohmann::json;

shop::CostTable thesis(double pieces) {
    shop::CostTable t;
    t.utilisation = 0.95;
    t.wage = 100;
    t.overhead = 500;
    t.machine = 850;
    t.material = 120;
    t.pieces = pieces;
    return t;
}

class CostOracle : public base::testing::OracleTest {
protected:
    CostOracle() : OracleTest("physics/cost.json") {}
};

TEST_F(CostOracle, of_the_thesis) {
    for (const json& c : oracle.at("cases")) {
        shop::CostTable t = thesis(c.at("dv"));
        t.utilisation = c.at("k_VS");
        t.wage = c.at("M");
        t.overhead = c.at("R_s");
        t.machine = c.at("N_hS");
        t.material = c.at("N_m");
        const Cost cost = cost_of(t, c.at("t_s"));
        const double exact = 1e-9;
        EXPECT_NEAR(cost.items[0].money, c.at("N_mAC").get<double>(), exact);
        EXPECT_NEAR(cost.items[1].money, c.at("N_pSAC").get<double>(), exact);
        EXPECT_NEAR(cost.per_piece, c.at("N").get<double>(), exact);
        EXPECT_NEAR(*cost.per_year, c.at("VN").get<double>(), 1e-6);
    }
}

TEST_F(CostOracle, the_printed_table_to_the_crown) {
    // The second part's first two rows are those of a piece's price rounded to the crown; the last one is neither
    // 1201 x 150 nor 1201.14 x 150 (180171.05), but that within its own last digit: tens of crowns.
    const struct {
        double seconds, pieces;
        bool rounded;
    } rows[] = {{166, 1000, false}, {159, 1000, false}, {163, 1000, false},
                {2700, 150, true},  {1380, 150, true},  {2550, 150, false}};
    const json& printed = oracle.at("table");
    ASSERT_EQ(printed.size(), std::size(rows));
    for (std::size_t i = 0; i < std::size(rows); ++i) {
        shop::CostTable t = thesis(rows[i].pieces);
        if (rows[i].rounded) t.rounding = 1;
        double year = *cost_of(t, rows[i].seconds).per_year;
        if (i == 5) year = std::round(year / 10) * 10;
        EXPECT_EQ(std::round(year), printed[i].get<double>()) << "row " << i;
    }
}

double sum(const Cost& c) {
    return std::accumulate(c.items.begin(), c.items.end(), 0.0, [](double s, const Item& i) { return s + i.money; });
}

TEST(Cost, what_the_cycle_leaves_out) {
    shop::CostTable t = thesis(1000);
    const double alone = cost_of(t, 166).exact;
    t.batch = 50;
    t.set_up_min = 30;
    t.load_s = 20;
    t.fixture = 5000;
    shop::CostTool mill;
    mill.name = "end mill D10";
    mill.price = 800;
    mill.lives = 4;
    mill.regrind = 200;
    mill.life_min = 60;
    mill.cut_s = 150;
    mill.change_min = 2;
    shop::CostTool other;
    other.name = "chamfer mill";
    other.price = 500;
    other.life_min = 90;
    t.tools = {mill, other};
    const Cost c = cost_of(t, 166);
    const double a_minute = 100.0 / 60 * 6 + 850.0 / 60;
    const double tool = 150.0 / 60 / 60 * ((800 + 3 * 200) / 4.0 + 2 * a_minute);
    EXPECT_NEAR(c.exact, alone + 30 * a_minute / 50 + 20.0 / 60 * a_minute + 5 + tool, 1e-9);
    EXPECT_NEAR(sum(c), c.exact, 1e-9);
    EXPECT_NEAR(*c.per_batch, 50 * c.exact, 1e-9);
    EXPECT_EQ(c.tools_left_out, std::vector<std::string>{"chamfer mill"});
    t.scrap = 20;
    EXPECT_NEAR(cost_of(t, 166).exact, c.exact / 0.8, 1e-9);
    EXPECT_NEAR(sum(cost_of(t, 166)), c.exact / 0.8, 1e-9);
}

}  // namespace
}  // namespace obrys::sim::cost
