/// Where radius compensation ends without a move.

#include <gtest/gtest.h>

#include "write/post_testing.hpp"
#include "write/writer_testing.hpp"

namespace obrys::write {
namespace {

cl::Programmed element(const geom::Vec3& from, const geom::Vec3& to) {
    cl::Programmed out;
    out.from = from, out.to = to;
    return out;
}

cl::ToolChange tool(std::uint32_t number) {
    cl::ToolChange out;
    out.number = number;
    return out;
}

/// A compensated line that ends without a move, something else, and a way on.
std::vector<cl::Step> left_without_a_move(const std::vector<cl::Step>& between) {
    cl::CompensationBegin begin;
    begin.radius = 2, begin.offset = 1;
    const cl::Programmed first = element({0, 0, 0}, {10, 0, 0}), second = element({10, 0, 0}, {10, 20, 0});
    std::vector<cl::Step> out{tool(1),
                              cl::Linear{{0, 0, 0}, {0, 0, 1}, true},
                              cl::Feed{100},
                              begin,
                              first,
                              cl::Linear{{8, 0, 0}},
                              second,
                              cl::Linear{{8, 20, 0}},
                              cl::CompensationEnd{}};
    out.insert(out.end(), between.begin(), between.end());
    return out;
}

const cl::Step way_on = cl::Linear{{0, 50, 0}, {0, 0, 1}, true};

TEST(WriterCompensation, ItEndsAloneBeforeAnotherTool) {
    const Written w = write(post_of("extends = \"linuxcnc\"\n"), left_without_a_move({tool(2), way_on}));
    EXPECT_NE(w.text.find("\nY20\nG40\nT2 M6\nG0 X0 Y50 Z0\n"), std::string::npos) << w.text;
    EXPECT_TRUE(w.lost.empty()) << w.lost.front();
}

TEST(WriterCompensation, ItEndsWithTheNextMoveWhereNothingStandsBetween) {
    for (const cl::Step& between : {cl::Step(cl::Spindle{500, cl::SpindleMode::rpm, 1}), cl::Step(cl::Dwell{1, 0})}) {
        const Written w = write(post_of("extends = \"linuxcnc\"\n"), left_without_a_move({between, way_on}));
        EXPECT_NE(w.text.find("\nG0 G40 X0 Y50\n"), std::string::npos) << w.text;
        EXPECT_EQ(w.text.find("\nG40\n"), std::string::npos) << w.text;
    }
}

TEST(WriterCompensation, ItEndsAloneBeforeTheEndAZeroAFrameAnArcAndAPlaceOfTheMachine) {
    cl::Frame shifted;
    shifted.parts.push_back({cl::FrameKind::shift, geom::Frame::shift({5, 0, 0})});
    cl::Datum zero;
    zero.number = 55;
    cl::MachinePlace home;
    home.kind = cl::PlaceKind::home, home.axes = {false, false, true};
    const cl::Arc arc{{-8, 20, 0}, {0, 20, 0}, {0, 0, 1}, geom::pi};
    const std::vector<std::vector<cl::Step>> cases{{cl::Stop{cl::StopKind::end}},
                                                   {},
                                                   {zero, way_on},
                                                   {shifted, way_on},
                                                   {home, cl::Linear{{8, 20, NAN}, {0, 0, 1}, true}},
                                                   {arc}};
    for (const std::vector<cl::Step>& between : cases) {
        const Written w = write(post_of("extends = \"fanuc\"\n"), left_without_a_move(between));
        EXPECT_NE(w.text.find("\nG40\n"), std::string::npos) << w.text;
        EXPECT_EQ(w.text.find("G40 X"), std::string::npos) << w.text;
        EXPECT_TRUE(w.lost.empty()) << w.text << w.lost.front();
    }
}

TEST(WriterCompensation, WhereNoWordEndsItAloneAnotherToolIsALossAndTheEndOfTheProgramIsNot) {
    const Post post = post_of("extends = \"sinumerik-840d\"\n");
    const Written changed = write(post, left_without_a_move({tool(2), way_on}));
    ASSERT_EQ(changed.lost.size(), 1U) << changed.text;
    EXPECT_EQ(changed.lost.front(), "the end of radius compensation: the post has no compensation.off-alone");
    const Written ended = write(post, left_without_a_move({cl::Stop{cl::StopKind::end}}));
    EXPECT_TRUE(ended.lost.empty()) << ended.lost.front();
    EXPECT_EQ(ended.text.find("G40\n"), std::string::npos) << ended.text;
    bool said = false;
    for (const std::string& what : ended.expanded)
        said = said || what.find("which the end of the program brings") != std::string::npos;
    EXPECT_TRUE(said);
}

TEST(WriterCompensation, AContourThatIsWrittenByItsPathIsNotWrittenUnderTheCompensationOfTheOneBefore) {
    cl::CompensationBegin given;
    given.radius = 3, given.given = true;
    const cl::Programmed third = element({10, 20, 0}, {40, 20, 0});
    const Written w =
        write(post_of("extends = \"fanuc\"\n"),
              left_without_a_move({given, third, cl::Linear{{40, 23, 0}}, cl::CompensationEnd{}, way_on}));
    EXPECT_NE(w.text.find("\nG40\nX40. Y23.\n"), std::string::npos) << w.text;
}

/// A mirror that the post cannot say, or says: the side counts in the frame of the text.
TEST(WriterCompensation, ItsSideIsThatOfTheFrameOfTheText) {
    cl::Frame mirror{{{cl::FrameKind::mirror, geom::Frame::scaling({-1, 1, 1})}}};
    cl::CompensationBegin begin;
    begin.radius = 0, begin.offset = 1, begin.normal = {0, 0, -1};
    const std::vector<cl::Step> steps{tool(1),
                                      mirror,
                                      cl::Linear{{20, -20, 0}, {0, 0, 1}, true},
                                      cl::Feed{100},
                                      begin,
                                      element({20, -20, 0}, {0, 0, 0}),
                                      cl::Linear{{0, 0, 0}},
                                      cl::CompensationEnd{}};
    const std::string plain = write(post_of("extends = \"iso\"\n"), steps).text;
    EXPECT_NE(plain.find("G42 D1 X0 Y0"), std::string::npos) << plain;
    const std::string said =
        write(post_of("extends = \"iso\"\n[frame]\nmirror = \"G51.1 X0\"\nmirror-off = \"G50.1 X0\"\n"), steps).text;
    EXPECT_NE(said.find("G51.1 X0\n"), std::string::npos) << said;
    EXPECT_NE(said.find("G41 D1 X0 Y0"), std::string::npos) << said;
}

}  // namespace
}  // namespace obrys::write
