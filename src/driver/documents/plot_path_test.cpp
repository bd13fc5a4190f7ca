#include "driver/documents/plot_path.hpp"

#include <gtest/gtest.h>

namespace obrys::driver {
namespace {

/// The example of the iTNC 530 user's manual, chapter on spline interpolation: a rapid to the start and two splines.
const std::vector<cl::Record> spl_001{
    {cl::Linear{{28.338, 19.385, -0.5}, {0, 0, 1}, true}, {}, 0},
    {cl::Spline{
         {24.875, 15.924, -0.5}, {3.486, 3.486, 0}, {2.459e-2, 2.155e-2, 0}, {-4.688e-2, -4.563e-2, 0}, {0, 0, 1}, {}},
     {},
     0},
    {cl::Spline{
         {17.952, 9.003, -0.5}, {6.928, 6.910, 0}, {-5.644e-2, -2.644e-2, 0}, {5.159e-2, 3.753e-2, 0}, {0, 0, 1}, {}},
     {},
     0}};

struct Plotted {
    std::vector<report::InterpolatedMove> rows;
    report::PathPlot plot;
};
Plotted run_plot(const std::vector<cl::Record>& records, const PlotOptions& options) {
    Plotted out;
    const auto take = [&out](const report::InterpolatedMove& m) { out.rows.push_back(m); };
    PathPlotter plotter(options, take);
    for (const cl::Record& r : records) plotter(r);
    out.plot = plotter.finish();
    return out;
}

TEST(PlotPath, SplinesOfTheManual) {
    PlotOptions options;
    options.plane = report::PlotPlane::xy;
    options.unit = 0.001;
    const Plotted r = run_plot(spl_001, options);
    ASSERT_EQ(r.rows.size(), 2u);
    EXPECT_STREQ(r.rows[0].kind, "spline");
    EXPECT_EQ(r.rows[0].index, 1u);
    EXPECT_NEAR(r.rows[0].length, 4.897160128390714, 1e-6);
    EXPECT_NEAR(r.rows[1].length, 9.789357022106877, 1e-6);
    // From (28.33871, 19.38592) to (24.875, 15.924): 3464 and 3462 units, half a unit at the ends.
    EXPECT_EQ(r.rows[0].figures.steps_of_axis[0], 28'339u - 24'875u);
    EXPECT_EQ(r.rows[0].figures.steps_of_axis[1], 19'386u - 15'924u);
    const report::Interpolation& all = *r.plot.interpolation;
    EXPECT_EQ(all.moves, 2u);
    EXPECT_EQ(all.rapids, 1u);
    EXPECT_EQ(all.largest, std::max(r.rows[0].figures.largest, r.rows[1].figures.largest));
    EXPECT_LE(all.largest, 0.001 * std::sqrt(0.5) + 1e-8);
    EXPECT_GT(all.largest, 0.0007);  // nearly along the diagonal
    ASSERT_EQ(all.stairs.size(), 1u);
    // The detail is the staircase: every piece is one unit along one axis, and it shows the worst place.
    const auto& stairs = all.stairs[0];
    ASSERT_GE(stairs.size(), 20u);
    for (std::size_t i = 1; i < stairs.size(); ++i) EXPECT_NEAR(geom::distance(stairs[i - 1], stairs[i]), 0.001, 1e-9);
    EXPECT_EQ(std::count(stairs.begin(), stairs.end(), all.place), 1);
    // The picture: a rapid from nowhere is left out; the curve is a chain that begins at the polynomial's start.
    EXPECT_EQ(r.plot.all_moves, 3u);
    EXPECT_EQ(r.plot.unplaced_moves, 1u);
    ASSERT_EQ(r.plot.moves.size(), 2u);
    for (const report::PlotMove& m : r.plot.moves) {
        EXPECT_GE(m.left.size(), 100u);
        EXPECT_GE(m.right.size(), 100u);
        for (const report::Excursion& e : m.left) EXPECT_LE(geom::length(e.off), all.largest);
    }
}

TEST(PlotPath, WithoutAUnitThePathOnly) {
    const Plotted r = run_plot(spl_001, {.plane = report::PlotPlane::xy});
    EXPECT_TRUE(r.rows.empty());
    EXPECT_FALSE(r.plot.interpolation);
    EXPECT_EQ(r.plot.moves.size(), 2u);
    EXPECT_NEAR(r.plot.feed_length, 4.897160128390714 + 9.789357022106877, 1e-6);
}

TEST(PlotPath, WhatIsNotRunIsCounted) {
    PlotOptions options;
    options.unit = 0.001;
    options.most_steps = 10'000;
    options.keep_moves = 1;
    std::vector<cl::Record> records = spl_001;
    records.insert(records.begin(), {cl::Linear{{1, NAN, NAN}, {0, 0, 1}, false}, {}, 0});
    const Plotted r = run_plot(records, options);
    const report::Interpolation& all = *r.plot.interpolation;
    ASSERT_EQ(r.rows.size(), 3u);
    EXPECT_EQ(all.not_known, 1u);
    EXPECT_EQ(all.not_run, 1u);
    EXPECT_EQ(all.moves, 1u);
    EXPECT_EQ(all.steps, r.rows[1].figures.steps);
    EXPECT_EQ(r.plot.moves.size() + r.plot.unplaced_moves, 1u);
    EXPECT_EQ(r.plot.all_moves, 4u);
}

TEST(PlotPath, AnotherZeroOffsetMovesThePicture) {
    const cl::Linear a{{0, 0, 0}, {0, 0, 1}, false}, b{{10, 0, 0}, {0, 0, 1}, false};
    const Plotted r = run_plot(
        {{cl::Datum{54, {0, 0, 0}}, {}, 0}, {a, {}, 0}, {b, {}, 0}, {cl::Datum{55, {5, 7, 0}}, {}, 0}, {b, {}, 0}},
        {.plane = report::PlotPlane::xy});
    ASSERT_EQ(r.plot.moves.size(), 2u);
    EXPECT_EQ(r.plot.moves[1].points.front(), (geom::Vec3{10, 0, 0}));
    EXPECT_EQ(r.plot.moves[1].points.back(), (geom::Vec3{15, 7, 0}));
}

}  // namespace
}  // namespace obrys::driver
