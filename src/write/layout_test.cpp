#include "write/layout.hpp"

#include <gtest/gtest.h>

#include "write/post_testing.hpp"
#include "write/writer.hpp"

namespace obrys::write {
namespace {

const char* const words =
    "[modal]\ncoordinates = [\"X\", \"Y\", \"Z\"]\nwords = [\"F\"]\ngroups = [[\"G0\", \"G1\"], [\"M3\", \"M5\"]]\n"
    "start = [\"M5\"]\n[motion]\nrapid = \"G0 X{x} Y{y} Z{z}\"\nlinear = \"G1 X{x} Y{y} Z{z} {feed}\"\n"
    "[feed]\nper-minute = \"F{feed}\"\n[stop]\nend = \"M30\"\n[text]\ncomment = \"({text})\"\n"
    "[compensation]\nleft = \"G41\"\nright = \"G42\"\noff = \"G40\"\n";
const char* const in_file =
    "[subprogram]\nfirst = 101\nbegin = \"O{number}\"\nend = \"M99\"\ncall = \"M98 P{number}\"\n"
    "repeat = \"M98 P{number} L{passes}\"\n";

struct Made {
    std::string text;
    std::vector<std::pair<std::string, std::string>> files;
    std::vector<Note> notes;
    [[nodiscard]] std::size_t count(Fate fate) const {
        return static_cast<std::size_t>(
            std::count_if(notes.begin(), notes.end(), [&](const Note& n) { return n.fate == fate; }));
    }
};

Made make(const std::string& post_text, const std::vector<cl::Step>& steps, bool files = false) {
    Made out;
    Output output;
    output.text = [&](std::string_view text) { out.text += text; };
    output.note = [&](const Note& n) { out.notes.push_back(n); };
    if (files)
        output.file = [&](const std::string& name, std::string_view text) { out.files.emplace_back(name, text); };
    const Post post = post_of(post_text);
    Writer writer(post, "P", output);
    for (std::uint32_t i = 0; i < steps.size(); ++i) writer.take({steps[i], {0, i, i + 1}, 0});
    writer.finish();
    return out;
}

cl::Linear rapid(double x, double y, double z) { return {{x, y, z}, {0, 0, 1}, true}; }

/// One pass of a part that goes to three places.
void add_pass(std::vector<cl::Step>& steps, std::uint64_t pass, std::uint64_t passes, double last = 3) {
    steps.emplace_back(cl::PartBegin{cl::PartKind::call, "SLOT", pass, passes});
    for (const double x : {1.0, 2.0, last}) steps.emplace_back(rapid(x, 0, 0));
    steps.emplace_back(cl::PartEnd{});
}

TEST(Layout, PassesThatComeToTheSameAreOneSubprogramAndOneCall) {
    std::vector<cl::Step> steps{cl::Feed{100}, rapid(0, 0, 0)};
    for (std::uint64_t pass = 1; pass <= 3; ++pass) add_pass(steps, pass, 3);
    steps.emplace_back(cl::Stop{cl::StopKind::end});
    const Made m = make(std::string(words) + in_file, steps);
    EXPECT_EQ(m.text, "G0 X0 Y0 Z0\nM98 P101 L3\nM30\nO101\nG0 X1\nX2\nX3\nM99\n");
    EXPECT_EQ(m.count(Fate::expanded), 0U);
    const auto call =
        std::find_if(m.notes.begin(), m.notes.end(), [](const Note& n) { return n.what == "call of SLOT"; });
    ASSERT_NE(call, m.notes.end());
    EXPECT_EQ(call->line, 2U);
}

TEST(Layout, APassThatComesToSomethingElseStandsInItsPlaceAndIsSaid) {
    std::vector<cl::Step> steps{rapid(0, 0, 0)};
    add_pass(steps, 1, 2);
    add_pass(steps, 2, 2, 4);
    steps.emplace_back(cl::Stop{cl::StopKind::end});
    const Made m = make(std::string(words) + in_file, steps);
    EXPECT_EQ(m.text, "G0 X0 Y0 Z0\nM98 P101\nG0 X1\nX2\nX4\nM30\nO101\nG0 X1\nX2\nX3\nM99\n");
    EXPECT_EQ(m.count(Fate::expanded), 1U);
}

TEST(Layout, WhatComesAgainIsASubprogramFromThenOn) {
    std::vector<cl::Step> steps{rapid(9, 9, 9)};
    for (const double last : {3.0, 4.0, 4.0, 3.0}) add_pass(steps, 1, 1, last), steps.emplace_back(rapid(9, 9, 9));
    steps.emplace_back(cl::Stop{cl::StopKind::end});
    const Made m = make(std::string(words) + in_file, steps);
    EXPECT_NE(m.text.find("O102\n"), std::string::npos) << m.text;
    EXPECT_EQ(m.count(Fate::expanded), 1U) << m.text;
}

TEST(Layout, APassThatLacksAWordWhichItsPlaceNeedsIsNoCall) {
    // The second pass begins elsewhere in Y, where the subprogram does not go.
    std::vector<cl::Step> steps{rapid(0, 0, 0)};
    add_pass(steps, 1, 1);
    steps.emplace_back(rapid(0, 5, 0));
    add_pass(steps, 1, 1);
    steps.emplace_back(cl::Stop{cl::StopKind::end});
    const Made m = make(std::string(words) + in_file, steps);
    EXPECT_EQ(m.text, "G0 X0 Y0 Z0\nM98 P101\nX0 Y5\nG0 X1 Y0\nX2\nX3\nM30\nO101\nG0 X1\nX2\nX3\nM99\n");
}

TEST(Layout, PartsLieOneInAnother) {
    std::vector<cl::Step> steps{rapid(0, 0, 0)};
    for (int i = 0; i < 2; ++i) {
        steps.emplace_back(cl::PartBegin{cl::PartKind::call, "OUTER"});
        add_pass(steps, 1, 1);
        steps.emplace_back(rapid(0, 0, 7));
        steps.emplace_back(rapid(0, 0, 0));
        steps.emplace_back(cl::PartEnd{});
    }
    steps.emplace_back(cl::Stop{cl::StopKind::end});
    const Made m = make(std::string(words) + in_file, steps);
    EXPECT_EQ(m.text, "G0 X0 Y0 Z0\nM98 P102 L2\nM30\nO101\nG0 X1\nX2\nX3\nM99\nO102\nM98 P101\nX0 Z7\nZ0\nM99\n");
}

TEST(Layout, ASubprogramMayStandBeforeItsCallOrInAFileOfItsOwn) {
    std::vector<cl::Step> steps{rapid(0, 0, 0)};
    add_pass(steps, 1, 1);
    steps.emplace_back(cl::Stop{cl::StopKind::end});
    const std::string here =
        "[subprogram]\nplace = \"here\"\nbegin = \"o{number} sub\"\nend = \"o{number} endsub\"\ncall = \"o{number} "
        "call\"\n";
    EXPECT_EQ(make(words + here, steps).text, "G0 X0 Y0 Z0\no1 sub\nG0 X1\nX2\nX3\no1 endsub\no1 call\nM30\n");
    const std::string own =
        "[subprogram_file]\nlower = true\nname = \"{name}.ngc\"\nend = \"M17\"\ncall = \"{name}\"\n";
    const Made m = make(words + own, steps, true);
    EXPECT_EQ(m.text, "G0 X0 Y0 Z0\nslot\nM30\n");
    ASSERT_EQ(m.files.size(), 1U);
    EXPECT_EQ(m.files[0].first, "slot.ngc");
    EXPECT_EQ(m.files[0].second, "G0 X1\nX2\nX3\nM17\n");
    // Without files, and without a form for one text, its blocks stand in their place.
    EXPECT_EQ(make(words + own, steps).text, "G0 X0 Y0 Z0\nX1\nX2\nX3\nM30\n");
}

TEST(Layout, NothingRunsOnIntoASubprogram) {
    std::vector<cl::Step> steps{rapid(0, 0, 0)};
    add_pass(steps, 1, 1);
    EXPECT_EQ(make(std::string(words) + in_file, steps).text, "G0 X0 Y0 Z0\nM98 P101\nM30\nO101\nG0 X1\nX2\nX3\nM99\n");
}

TEST(Layout, APartInWhichTheProgramEndsStandsInItsPlace) {
    std::vector<cl::Step> steps{rapid(0, 0, 0), cl::PartBegin{cl::PartKind::call, "SLOT"}, rapid(1, 0, 0),
                                cl::Stop{cl::StopKind::end}};
    const Made m = make(std::string(words) + in_file, steps);
    EXPECT_EQ(m.text, "G0 X0 Y0 Z0\nG0 X1\nM30\n");
    EXPECT_EQ(m.count(Fate::expanded), 1U);
}

TEST(Layout, APartWithinCompensationIsNoSubprogram) {
    std::vector<cl::Step> steps{rapid(0, 0, 0), cl::CompensationBegin{}};
    add_pass(steps, 1, 1);
    steps.emplace_back(cl::CompensationEnd{});
    steps.emplace_back(cl::Stop{cl::StopKind::end});
    const Made m = make(std::string(words) + in_file, steps);
    EXPECT_EQ(m.text.find("M98"), std::string::npos) << m.text;
}

TEST(Layout, TextIsInTheCharactersOfTheControl) {
    const std::vector<cl::Step> steps{cl::Comment{"\xC3\xBC\xE2\x82\xAC\xC5\x99"}};  // ü, €, ř
    const auto text_in = [&](const std::string& encoding) {
        return make(std::string(words) + "[file]\nencoding = \"" + encoding + "\"\n", steps).text;
    };
    EXPECT_EQ(text_in("utf-8"), "(\xC3\xBC\xE2\x82\xAC\xC5\x99)\n");
    EXPECT_EQ(text_in("windows-1252"), "(\xFC\x80r)\n");
    EXPECT_EQ(text_in("ascii"), "(ue?r)\n");
    EXPECT_EQ(make(std::string(words) + "[file]\nencoding = \"utf-8\"\n", {cl::Comment{"\xFC"}}).text, "(\xC3\xBC)\n");
    EXPECT_EQ(faults_of("[file]\nencoding = \"ebcdic\"\n").empty(), false);
}

TEST(Layout, AFormThatCannotCallIsRefused) {
    EXPECT_NE(faults_of("[subprogram]\nbegin = \"O1\"\n").find("must be said"), std::string::npos);
    EXPECT_NE(faults_of("[subprogram_file]\ncall = \"A\"\n").find("must be said"), std::string::npos);
}

}  // namespace
}  // namespace obrys::write
