#include "report/path_plot.hpp"

#include <gtest/gtest.h>

namespace obrys::report {
namespace {

struct Sample {
    base::Sources sources;
    PathPlot plot;
};

/// A mill's path: a rapid down to (0, 0) and a line to (10, 5), with one step to either side of it.
Sample sample() {
    Sample s;
    s.sources.add("sub/P.H", "0 BEGIN\n1 L X10 Y5\n");
    PathPlot& p = s.plot;
    p.plane = PlotPlane::xy;
    p.program = "sub/P.H";
    p.control = "c";
    p.machine = "m";
    p.all_moves = 3;
    p.unplaced_moves = 1;
    p.moves = {{{{0, 0, 20}, {0, 0, 1}}, true, {}, {}},
               {{{0, 0, 1}, {10, 5, 1}}, false, {{{4, 2}, {-0.001, 0.002}}}, {{{6, 3}, {0.001, -0.002}}}}};
    Interpolation i;
    i.unit = 0.005;
    i.moves = 1;
    i.rapids = 1;
    i.not_known = 1;
    i.steps = 3000;
    i.length = 11.18034;
    i.largest = 0.0022360679;
    i.sum = 3.001;
    i.worst = {2, {0, 8, 18}, "linear", 11.18034, {}};
    i.worst.figures.end_reason = geom::StaircaseEnd::reached;
    i.worst.figures.steps = 3000;
    i.worst.figures.largest = 0.0022360679;
    i.worst.figures.mean = 0.001;
    i.place = {4, 2};
    i.stairs = {{{3.99, 2}, {4, 2}, {4, 2.01}}};
    i.ideal = {{{3.98, 1.99}, {4.02, 2.01}}};
    p.interpolation = i;
    return s;
}

std::size_t count(const std::string& text, const std::string& part) {
    std::size_t n = 0;
    for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
    return n;
}

TEST(PathPlot, AMillIsSeenFromAboveAndFromTheSide) {
    Sample s = sample();
    s.plot.interpolation.reset();
    const std::string svg = to_svg(s.plot, s.sources);
    EXPECT_TRUE(svg.starts_with("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"1040\"")) << svg.substr(0, 200);
    EXPECT_TRUE(svg.ends_with("</svg>\n"));
    for (const char* part : {">P.H: tool path, 3 moves<", "↑ Y mm", "↑ Z mm", "Without a known place: 1 move."})
        EXPECT_NE(svg.find(part), std::string::npos) << part;
    EXPECT_EQ(count(svg, "<path class=\"feed\" d=\"M"), 3u);  // two views and the legend
    EXPECT_EQ(count(svg, "class=\"band\""), 0u);
    EXPECT_EQ(svg.find("centre\" x1"), std::string::npos);
    for (PlotMove& m : s.plot.moves)
        for (geom::Vec3& p : m.points) p.z = NAN;
    EXPECT_EQ(to_svg(s.plot, s.sources).find("↑ Z mm"), std::string::npos);
}

TEST(PathPlot, ALatheIsSeenAsInItsChecks) {
    Sample s = sample();
    s.plot.plane = PlotPlane::zx;
    s.plot.interpolation.reset();
    const std::string svg = to_svg(s.plot, s.sources);
    EXPECT_NE(svg.find("↑ X mm (radius)"), std::string::npos);
    EXPECT_EQ(svg.find("↑ Y mm"), std::string::npos);
}

TEST(PathPlot, DeviationsAreDrawnLarger) {
    const Sample s = sample();
    const std::string svg = to_svg(s.plot, s.sources);
    for (const char* part : {"basic length unit of 0.005 mm", "The largest deviation, 0.002236 mm, true to scale:",
                             ">move 2 (P.H:2)<", "times as large", "class=\"stairs\""})
        EXPECT_NE(svg.find(part), std::string::npos) << part;
    // The band: start, left, end, right; the left point 10 units of the picture or a bit less off the path.
    const auto at = svg.find("<path class=\"band\" d=\"M");
    ASSERT_NE(at, std::string::npos);
    const std::string band = svg.substr(at, svg.find("\"/>", at) - at);
    EXPECT_EQ(count(band, "L"), 3u);
    EXPECT_TRUE(band.ends_with("Z"));
    double x[4], y[4];
    ASSERT_EQ(std::sscanf(band.c_str() + band.find('M') + 1, "%lf %lfL%lf %lfL%lf %lfL%lf %lf", x, y, x + 1, y + 1,
                          x + 2, y + 2, x + 3, y + 3),
              8);
    const geom::Vec2 along{x[2] - x[0], y[2] - y[0]}, left{x[1] - x[0], y[1] - y[0]}, right{x[3] - x[0], y[3] - y[0]};
    const double off = geom::cross(along, left) / geom::length(along);
    EXPECT_LT(off, -2);  // left of the way, with y downwards
    EXPECT_GT(off, -10);
    EXPECT_NEAR(geom::cross(along, right) / geom::length(along), -off, 0.02);
}

TEST(PathPlot, AnEmptyPathIsStillAPicture) {
    const base::Sources none;
    EXPECT_TRUE(to_svg(PathPlot{}, none).ends_with("</svg>\n"));
    PathPlot p;
    p.plane = PlotPlane::xy;
    p.interpolation = Interpolation{};
    EXPECT_TRUE(to_svg(p, none).ends_with("</svg>\n"));
}

TEST(PathTable, SaysEveryFigureWithItsUnit) {
    const Sample s = sample();
    const Interpolation& i = *s.plot.interpolation;
    EXPECT_EQ(table_head(0.005),
              "deviations of a staircase of single-axis steps, basic length unit 0.005 mm\n"
              "  move   length mm      steps   largest mm      mean mm  kind    line\n");
    EXPECT_EQ(table_row(i.worst, s.sources, 0.005),
              "     2      11.180       3000     0.002236     0.001000  linear  sub/P.H:2\n");
    EXPECT_EQ(table_end(i, s.sources),
              "overall: 1 move, 11.180 mm, 3000 steps: largest deviation 0.002236 mm in move 2 (sub/P.H:2), mean "
              "0.001000 mm\n"
              "1 rapid move left out\n"
              "1 move not computed: position not known, or beyond the grid\n");
    InterpolatedMove unknown = i.worst;
    unknown.figures.end_reason = geom::StaircaseEnd::not_known;
    unknown.length = NAN;
    EXPECT_EQ(table_row(unknown, s.sources, 0.005),
              "     2           ?          ?            ?            ?  linear  sub/P.H:2\n");
    // The digits follow the unit.
    EXPECT_NE(table_row(i.worst, s.sources, 1e-6).find("0.002236068"), std::string::npos);
}

}  // namespace
}  // namespace obrys::report
