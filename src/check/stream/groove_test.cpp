/// The grooving subprogram of 2015: moves and events as an independent, sampled model computed them (../shared).

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "base/codes.hpp"
#include "base/number.hpp"
#include "check/stream/bench_part.hpp"

namespace obrys::check {
namespace {

using nlohmann::json;

const std::string expected_folder = OBRYS_SOURCE_DIR "/../shared/programs/groove/expected/";
constexpr double depth_tolerance = 0.1;  ///< mm, of the sampled model
constexpr double area_tolerance = 0.01;  ///< of the area
constexpr double half_cell = 0.005;      ///< mm the edge of a cut may be off in the sampled model, times its depth

struct Case {
    json expected;
    Result result;
};

std::vector<std::string> split(const std::string& line) {
    std::vector<std::string> out(1);
    for (const char c : line) {
        if (c == ',')
            out.emplace_back();
        else
            out.back() += c;
    }
    return out;
}

check::Setup groove_setup(const json& expected) {
    const auto at = [&](const char* p) {
        const json& point = expected["points_by_line_intersection"][p];
        return geom::Vec2{point["Z"], point["X"]};
    };
    check::Setup s = bench_part::setup();
    const geom::Vec2 left{0, 106}, right{300, 226};
    const auto closed = [&](std::vector<geom::Vec2> groove) {
        std::vector<geom::Vec2> points{{0, 0}, {300, 0}, right};
        points.insert(points.end(), groove.begin(), groove.end());
        points.push_back(left);
        return bench_part::polygon(points);
    };
    s.stock = closed({});
    s.part = closed({at("P"), at("BR"), at("BL"), at("C1")});
    s.allowance = closed({at("U"), at("T"), at("S"), at("R")});
    s.tools[0].width = expected["params"]["R9"];
    s.keep_moves = 1000;
    return s;
}

/// The moves of the case through the check; the span of a move is its line in its program, one "file" for each.
Case run(const std::string& name) {
    std::ifstream moves(expected_folder + name + "_moves.csv"), figures(expected_folder + name + ".json");
    Case c{json::parse(figures), {}};
    const cl::CallStacks stacks;
    Check check(groove_setup(c.expected), stacks);
    check.take({cl::Spindle{300, cl::SpindleMode::surface, 1, 3000}, {}, 0});
    check.take({cl::Feed{0.2, cl::FeedMode::per_rev}, {}, 0});
    check.take({cl::ToolChange{5, 1, ""}, {}, 0});
    std::string line;
    std::getline(moves, line);
    while (std::getline(moves, line)) {
        const auto field = split(line);
        const auto number = [&](std::size_t i) { return base::parse_double(field[i]).value_or(NAN); };
        const auto at = static_cast<std::uint32_t>(number(2));
        check.take({cl::Linear{{number(5), 0, number(6)}, {0, 0, 1}, field[4] == "G0"}, {0, at, at + 1}, 0});
    }
    c.result = check.finish();
    return c;
}

const Finding* find(const Result& r, std::string_view code, std::uint64_t move) {
    for (const Finding& f : r.findings)
        if (f.code == code && f.move == move) return &f;
    return nullptr;
}

void expect_amounts(const Finding* f, double depth_x, double area, const std::string& what) {
    ASSERT_NE(f, nullptr) << what;
    EXPECT_NEAR(bench_part::amount(*f, "depth_x_mm"), depth_x, depth_tolerance) << what;
    EXPECT_NEAR(bench_part::amount(*f, "area_mm2"), area, std::max(area * area_tolerance, half_cell * depth_x)) << what;
}

void expect_events(const Case& c) {
    std::set<std::uint64_t> moves_with_event, moves_with_finding;
    std::set<std::uint32_t> lines_with_event, lines_with_finding;
    for (const json& e : c.expected["events"]) {
        const std::uint64_t i = e["i"];
        moves_with_event.insert(i);
        lines_with_event.insert(e["line"].get<std::uint32_t>());
        const std::string what = "move " + std::to_string(i);
        const double gouge = e["final_area_mm2"], rough = e["rough_area_mm2"], rapid = e["rapid_area_mm2"];
        if (gouge > 1e-3)
            expect_amounts(find(c.result, base::codes::gouge, i), e["below_final_contour_mm"], gouge, what + " gouge");
        if (rough > gouge + 0.01)
            expect_amounts(find(c.result, base::codes::allowance_cut, i), e["below_rough_contour_mm"], rough,
                           what + " allowance");
        if (rapid > 1e-3)
            expect_amounts(find(c.result, base::codes::rapid_in_stock, i), e["rapid_depth_mm"], rapid, what + " rapid");
    }
    for (const Finding& f : c.result.findings)
        if (f.code != base::codes::rest_material) moves_with_finding.insert(*f.move);
    for (const Finding& f : c.result.findings) lines_with_finding.insert(f.where.begin);
    EXPECT_EQ(moves_with_finding, moves_with_event);
    EXPECT_EQ(lines_with_finding, lines_with_event);  // in these cases rest material also lies beside one of them
}

class Groove : public ::testing::TestWithParam<const char*> {};

TEST_P(Groove, FindsExactlyTheEventsOfTheSampledModel) {
    if (!std::ifstream(expected_folder + GetParam() + ".json")) GTEST_SKIP() << "needs ../shared";
    const Case c = run(GetParam());
    EXPECT_EQ(c.result.stats.moves, c.expected["n_moves"]);
    EXPECT_NEAR(c.result.stats.feed_length_mm, c.expected["length_G1_mm"], 1e-4);
    EXPECT_NEAR(c.result.stats.rapid_length_mm, c.expected["length_G0_mm"], 1e-4);
    EXPECT_TRUE(c.result.unchecked.empty());
    expect_events(c);
    double rest = 0;
    for (const Finding& f : c.result.findings)
        if (f.code == base::codes::rest_material) rest += bench_part::amount(f, "area_mm2");
    EXPECT_NEAR(rest, c.expected["residual_area_mm2"], 0.01);
    const bool clean = c.expected["events"].empty() && c.expected["residual_area_mm2"] == 0.0;
    EXPECT_EQ(c.result.verdict, clean ? Verdict::clean : Verdict::findings);
}

INSTANTIATE_TEST_SUITE_P(Cases, Groove,
                         ::testing::Values("kod1", "zp_R3_150", "both_R3_80", "kod1__fixed2", "zp_R3_150__fixed2",
                                           "both_R3_80__fixed1"));

}  // namespace
}  // namespace obrys::check
