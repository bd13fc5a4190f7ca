#include <gtest/gtest.h>

#include "report/path.hpp"
#include "report/sample.hpp"
#include "report/svg_window.hpp"

namespace obrys::report {
namespace {

constexpr Projection plain{1, 0, 0, 4};

TEST(Path, LinesAndClosing) {
    EXPECT_EQ(path_of(geom::Contour{{{{0, 0}, 0}, {{10, 0}, 0}, {{10, 2.5}, 0}}, true}, plain), "M0 0L10 0L10 -2.5Z");
    EXPECT_EQ(path_of(geom::Contour{{{{0, 0}, 0}, {{10, 0}, 0}}, false}, plain), "M0 0L10 0");
    EXPECT_EQ(path_of(geom::Region{}, plain), "");
}

TEST(Path, ArcsKeepTheirSenseToTheEye) {
    // A quarter from (10, 0) counter-clockwise to (0, 10), drawn with y downwards: SVG's negative direction.
    const double quarter = std::tan(geom::pi / 8);
    EXPECT_EQ(path_of(geom::Contour{{{{10, 0}, quarter}, {{0, 10}, 0}}, false}, plain), "M10 0A10 10 0 0 0 0 -10");
    EXPECT_EQ(path_of(geom::Contour{{{{0, 10}, -quarter}, {{10, 0}, 0}}, false}, plain), "M0 -10A10 10 0 0 1 10 0");
    // A half circle is split, so that its centre is never in doubt.
    EXPECT_EQ(path_of(geom::Contour{{{{10, 0}, 1}, {{-10, 0}, 0}}, false}, plain),
              "M10 0A10 10 0 0 0 0 -10A10 10 0 0 0 -10 0");
}

TEST(Path, MovesAreChained) {
    MovePath path(plain);
    check::MoveTrace unknown;
    unknown.from = {NAN, NAN};
    unknown.to = {0, 5};
    path.add(unknown);
    check::MoveTrace a;
    a.from = {0, 5};
    a.to = {3, 5};
    check::MoveTrace b;
    b.from = a.to;
    b.to = {3, 7};
    check::MoveTrace c;
    c.from = {9, 9};
    c.to = {9, 10};
    path.add(a), path.add(b), path.add(c);
    EXPECT_EQ(path.data(), "M0 -5L3 -5L3 -7M9 -9L9 -10");
}

TEST(Path, CurvesAreChains) {
    MovePath path(plain);
    check::MoveTrace a;
    a.from = {0, 5};
    a.to = {3, 5};
    a.via = {{1, 6}, {2, 6.5}};
    path.add(a);
    EXPECT_EQ(path.data(), "M0 -5L1 -6L2 -6.5L3 -5");
}

TEST(Path, NumbersAndMarkup) {
    EXPECT_EQ(number(1.5000, 3), "1.5");
    EXPECT_EQ(number(-0.0001, 3), "0");
    EXPECT_EQ(number(120, 0), "120");
    EXPECT_EQ(escaped("a<b> & \"c\""), "a&lt;b&gt; &amp; &quot;c&quot;");
}

TEST(Marks, FindingsOfOneMoveShareOne) {
    sample::Sample s = sample::make();
    const check::Finding f = s.result.findings[0];
    s.result.findings = {f, f, f, f};
    for (std::uint32_t i = 0; i < 4; ++i) s.result.findings[i].cause = std::to_string(i);  // four things to mend
    s.result.findings[3].move = 9;
    s.result.findings[3].at.reset();
    const auto marks = marks_of(s.result);
    ASSERT_EQ(marks.size(), 2u);
    EXPECT_EQ(marks[0].label, "1-3");
    EXPECT_EQ(marks[1].label, "4");
    EXPECT_EQ(marks[1].at, (geom::Vec2{3, 18.625}));  // the middle of its region
}

TEST(SvgWindow, EqualScaleZRightXUp) {
    const Window w("w", {0, 100, 0, 50}, 60, 70, 500, 500);
    EXPECT_EQ(w.projection().scale, 5);
    EXPECT_EQ(w.projection()({0, 0}), (geom::Vec2{60, 320}));
    EXPECT_EQ(w.projection()({100, 50}), (geom::Vec2{560, 70}));
    EXPECT_EQ(w.bottom(), 320);
}

TEST(Svg, ShowsStockPartPathAndFinding) {
    const sample::Sample s = sample::make();
    const std::string svg = to_svg(s.subject());
    EXPECT_TRUE(svg.starts_with("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"1040\""));
    EXPECT_TRUE(svg.ends_with("</svg>\n"));
    for (const char* part :
         {"<path class=\"before\"", "<path class=\"after\"", "<path class=\"part\"", "<path class=\"feed\" d=\"M",
          "<path class=\"bad\"", ">MAIN.MPF: not fully checked", "finding, numbered as below", ">Z mm →<"})
        EXPECT_NE(svg.find(part), std::string::npos) << part;
    EXPECT_EQ(svg.find("<path class=\"allowance\""), std::string::npos);
    EXPECT_EQ(svg.find("<path class=\"rapid\" d=\"M62"), std::string::npos);
    EXPECT_EQ(svg.find("nan"), std::string::npos);
    EXPECT_NE(svg.find("1  with blank/SUB.SPF:2 [gouge] cuts into the finished part"), std::string::npos);
}

TEST(Svg, ShowsClampsBelowTheStock) {
    sample::Sample s = sample::make();
    EXPECT_EQ(to_svg(s.subject()).find("<path class=\"clamp\""), std::string::npos);
    s.setup.turned_clamps = {{"jaws", {{{{{{-30, 0}, 0}, {{5, 0}, 0}, {{5, 60}, 0}, {{-30, 60}, 0}}, true}}}},
                             {"far away", {{{{{{-900, 0}, 0}, {{-800, 0}, 0}, {{-800, 9}, 0}}, true}}}}};
    const std::string svg = to_svg(s.subject());
    const std::size_t clamp = svg.find("<path class=\"clamp\""), stock = svg.find("<path class=\"before\"");
    ASSERT_NE(clamp, std::string::npos);
    EXPECT_LT(clamp, stock);
    EXPECT_NE(svg.find(">clamp<"), std::string::npos);
    EXPECT_EQ(svg.find(">-200<"), std::string::npos) << "the picture is about the workpiece";
}

TEST(Svg, AnEmptyResultIsStillAPicture) {
    sample::Sample s = sample::make();
    s.result = {};
    s.setup = {};
    const std::string svg = to_svg(s.subject());
    EXPECT_EQ(svg.find("nan"), std::string::npos);
    EXPECT_EQ(svg.find("inf"), std::string::npos);
    EXPECT_TRUE(svg.ends_with("</svg>\n"));
}

}  // namespace
}  // namespace obrys::report
