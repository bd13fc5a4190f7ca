#include "write/writer.hpp"

#include <gtest/gtest.h>

#include "write/post_testing.hpp"
#include "write/writer_testing.hpp"

namespace obrys::write {
namespace {

const char* const small =
    "[modal]\ncoordinates = [\"X\", \"Y\", \"Z\"]\nwords = [\"F\"]\n"
    "groups = [[\"G0\", \"G1\", \"G2\", \"G3\"], [\"M3\", \"M5\"], [\"G94\", \"G95\"]]\nstart = [\"M5\", \"G94\"]\n"
    "[motion]\nrapid = \"G0 X{x} Y{y} Z{z}\"\nlinear = \"G1 X{x} Y{y} Z{z} {feed}\"\n"
    "arc-cw = \"G2 X{x} Y{y} Z{z} I{i} J{j} {feed}\"\narc-ccw = \"G3 X{x} Y{y} Z{z} I{i} J{j} {feed}\"\n"
    "[feed]\nper-minute = \"G94 F{feed}\"\nper-rev = \"G95 F{feed}\"\n";

TEST(Writer, WordsThatAreInForceAreLeftOut) {
    const Written w = write(post_of(small), {cl::Linear{{10, 0, 5}, {0, 0, 1}, true}, cl::Feed{200},
                                             cl::Linear{{10, 0, -2}}, cl::Linear{{20, 0, -2}}, cl::Linear{{20, 0, -2}},
                                             cl::Arc{{30, 10, -2}, {20, 10, -2}, {0, 0, 1}, geom::pi / 2}});
    EXPECT_EQ(w.text, "G0 X10 Y0 Z5\nG1 Z-2 F200\nX20\nG3 X30 Y10 I0 J10\n");
    EXPECT_TRUE(w.lost.empty());
}

TEST(Writer, AFeedOfAnotherKindIsWrittenAlsoWhereItsNumberIsTheSame) {
    const Written w = write(post_of(small), {cl::Feed{2}, cl::Linear{{1, 0, 0}}, cl::Feed{2, cl::FeedMode::per_rev},
                                             cl::Linear{{2, 0, 0}}});
    EXPECT_EQ(w.text, "G1 X1 Y0 Z0 F2\nX2 G95 F2\n");
}

TEST(Writer, SeveralTurnsAreWrittenOneByOneWhereTheControlHasNoWordForThem) {
    const Written w = write(post_of(small), {cl::Linear{{10, 0, 0}, {0, 0, 1}, true},
                                             cl::Arc{{0, 10, -5}, {0, 0, 0}, {0, 0, 1}, 2.25 * geom::full_turn}});
    EXPECT_EQ(w.text, "G0 X10 Y0 Z0\nG3 Z-2.222 I-10 J0\nZ-4.444 I-10 J0\nX0 Y10 Z-5 I-10 J0\n");
}

TEST(Writer, CoordinatesOfAFrameThatThePostHasNoWordsForAreThoseOfTheWorkpiece) {
    cl::Frame turned;
    turned.parts.push_back({cl::FrameKind::rotation, geom::Frame::rotation(2, geom::pi / 2)});
    const Written w = write(post_of(small), {turned, cl::Linear{{0, 10, 0}, {0, 0, 1}, true}});
    EXPECT_EQ(w.text, "G0 X0 Y10 Z0\n");
    EXPECT_EQ(w.expanded.size(), 1U);
    const Written f = write(post_of("extends = \"fanuc\"\n"), {turned, cl::Linear{{0, 10, 0}, {0, 0, 1}, true}});
    EXPECT_NE(f.text.find("G68 X0. Y0. R90.\nG0 X10. Y0. Z0.\n"), std::string::npos) << f.text;
}

TEST(Writer, WhatThePostCannotSayIsLostAndSaid) {
    const Post post = post_of(small);
    EXPECT_EQ(write(post, {cl::Dwell{1, 0}}).lost.size(), 1U);
    EXPECT_EQ(write(post, {cl::Spindle{100, cl::SpindleMode::rpm, 1}, cl::Linear{{1, 0, 0}}}).lost.size(), 1U);
    EXPECT_EQ(write(post, {cl::Linear{{1e7, 0, 0}}}).lost.size(), 1U);
    EXPECT_EQ(write(post, {cl::Feed{NAN}, cl::Linear{{1, 0, 0}}, cl::Linear{{2, 0, 0}}}).lost.size(), 1U);
    EXPECT_EQ(write(post, {cl::Feed{1, cl::FeedMode::inverse_time}, cl::Linear{{1, 0, 0}}}).lost.size(), 1U);
    EXPECT_EQ(write(post, {cl::Linear{{5, 0, 0}}, cl::Arc{{0, 5, 0}, {0, 0, 0}, {0, 0.6, 0.8}, 1}}).lost.size(), 1U);
    EXPECT_EQ(write(post, {cl::Spline{{1, 0, 0}, {}, {}, {}, {0, 0, 1}, {}}}).lost.size(), 1U);
}

TEST(Writer, ACycleIsFoldedOnlyWhereAllThatItSaysHasItsWord) {
    const Post post = post_of(std::string(small) +
                              "[cycles]\nend = \"G80\"\n[[cycle]]\nkind = \"canned-drill\"\n"
                              "call = \"G81 X{x!} Z{bottom} R{retract-plane}\"\n");
    const auto bracket = [](std::vector<cl::CycleValue> values) {
        return std::vector<cl::Step>{
            cl::Linear{{10, 0, 5}, {0, 0, 1}, true},
            cl::CycleBegin{cl::Cycle{cl::CycleKind::canned_drill, {}, std::move(values), "G81", {}}, {10, 0, 5}},
            cl::Linear{{10, 0, -5}}, cl::CycleEnd{}, cl::Linear{{0, 0, 5}, {0, 0, 1}, true}};
    };
    const Written folded = write(post, bracket({{cl::CycleRole::bottom, -5}, {cl::CycleRole::retract_plane, 2}}));
    EXPECT_EQ(folded.text, "G0 X10 Y0 Z5\nG81 X10 Z-5 R2\nG80\nX0 Y0 Z5\n");
    const Written moves = write(post, bracket({{cl::CycleRole::bottom, -5}, {cl::CycleRole::dwell_bottom, 2}}));
    EXPECT_EQ(moves.text, "G0 X10 Y0 Z5\nG1 Z-5\nG0 X0 Z5\n");
    EXPECT_EQ(moves.expanded.size(), 1U);
}

TEST(Writer, AMoveOverTheHoleIsWrittenWhereTheCycleCannotHoldItsNumbers) {
    const Post post = post_of(std::string(small) +
                              "[[cycle]]\nkind = \"canned-drill\"\nmoves_over = true\n"
                              "call = \"G81 X{x!} Y{y!} Z{bottom} R{retract-plane}\"\n");
    const auto drilled = [&](double bottom) {
        Written out;
        Output output{[&](std::string_view text) { out.text += text; },
                      [&](const Note& n) { out.lost.push_back(n.what); }};
        Writer writer(post, "P", output);
        const cl::Cycle cycle{cl::CycleKind::canned_drill,
                              {},
                              {{cl::CycleRole::bottom, bottom}, {cl::CycleRole::retract_plane, 2}},
                              "G81",
                              {}};
        const base::Span block{0, 0, 9};
        for (const cl::Step& step :
             {cl::Step(cl::Linear{{10, 20, 5}, {0, 0, 1}, true}), cl::Step(cl::CycleBegin{cycle, {10, 20, 5}}),
              cl::Step(cl::Linear{{10, 20, -5}}), cl::Step(cl::CycleEnd{})})
            writer.take({step, block, 0});
        writer.finish();
        return out.text;
    };
    EXPECT_EQ(drilled(-5), "G81 X10 Y20 Z-5 R2\n");
    EXPECT_EQ(drilled(-1e7), "G0 X10 Y20 Z5\nG1 Z-5\n");
}

TEST(Writer, WhatNobodyKnowsIsSaidToBeLost) {
    const Post post = post_of(small);
    const cl::Linear known{{1, 2, 3}, {0, 0, 1}, true};
    EXPECT_EQ(write(post, {known, cl::Linear{{1, 2, NAN}, {0, 0, 1}, true}}).lost.size(), 1U);
    EXPECT_TRUE(write(post, {cl::Linear{{1, 2, NAN}, {0, 0, 1}, true}, known}).lost.empty());
    cl::Arc turning{{0, 10, -5}, {0, 0, 0}, {0, 0, 1}, 2.25 * geom::full_turn};
    turning.ends = {{{'A'}, 90, true}};
    EXPECT_EQ(write(post, {known, turning}).lost.size(), 1U);
}

TEST(Writer, CompensationWithoutAPlaceInTheBlockIsSaidToBeLost) {
    const std::string with = std::string(small) + "[compensation]\nleft = \"G41\"\noff = \"G40\"\n";
    const std::vector<cl::Step> steps{cl::Linear{{1, 0, 0}}, cl::CompensationBegin{}, cl::Linear{{2, 0, 0}}};
    const Written w = write(post_of(with), steps);
    ASSERT_EQ(w.lost.size(), 1U);
    EXPECT_EQ(w.lost.front(), "compensation: motion.linear of the post has no place for it");
}

TEST(Writer, ALengthThatWaitsHasABlockOfItsOwnWhereMovesHaveNoPlaceForIt) {
    const std::string with = std::string(small) + "[tool]\nlength-on = \"G43 H{number}\"\n";
    const Written w = write(post_of(with), {cl::ToolLength{1, 7, {}}, cl::Linear{{1, 0, 5}, {0, 0, 1}, true}});
    EXPECT_EQ(w.text, "G43 H7\nG0 X1 Y0 Z5\n");
    EXPECT_TRUE(w.lost.empty());
}

TEST(Writer, NumbersOfBlocksBeginAnewWhereTheWordIsFull) {
    const Post post = post_of(std::string(small) + "[block_numbers]\ntext = \"N{block}\"\nfirst = 99998\nstep = 1\n");
    const Written w = write(post, {cl::Linear{{1, 0, 0}}, cl::Linear{{2, 0, 0}}, cl::Linear{{3, 0, 0}}});
    EXPECT_EQ(w.text, "N99998 G1 X1 Y0 Z0\nN99999 X2\nN99998 X3\n");
}

TEST(Writer, AFeedIsSaidAgainBehindAWordThatTakesItsPlace) {
    std::string text = small;
    text.insert(text.find("\"G3\"]"), "\"G33\", ");
    text.insert(text.find("[feed]"), "thread = \"G33 X{x} Z{z} F{pitch}\"\n");
    const Written w =
        write(post_of(text), {cl::Feed{2}, cl::Linear{{1, 0, 0}}, cl::Thread{{1, 0, -5}, 1.5}, cl::Linear{{2, 0, -5}}});
    EXPECT_EQ(w.text, "G1 X1 Y0 Z0 F2\nG33 Z-5 F1.5\nG1 X2 F2\n");
}

TEST(Writer, ArcsEndAtQuadrantsOrHoldSoManyDegreesWhereThePostSaysSo) {
    const std::vector<cl::Step> arc{cl::Linear{{10, 0, 0}, {0, 0, 1}, true},
                                    cl::Arc{{0, -10, -3}, {0, 0, 0}, {0, 0, 1}, 1.5 * geom::pi}};
    std::string text = small;
    text.insert(text.find("rapid ="), "by_quadrants = true\n");
    EXPECT_EQ(write(post_of(text), arc).text,
              "G0 X10 Y0 Z0\nG3 X0 Y10 Z-1 I-10 J0\nX-10 Y0 Z-2 I0 J-10\nX0 Y-10 Z-3 I10 J0\n");
    text.replace(text.find("by_quadrants = true"), 19, "most_sweep = 180");
    for (std::size_t at = text.find("I{i} J{j}"); at != std::string::npos; at = text.find("I{i} J{j}"))
        text.replace(at, 9, "R{radius}");
    const Written by_radius = write(post_of(text), arc);
    EXPECT_EQ(by_radius.text, "G0 X10 Y0 Z0\nG3 X-7.071 Y7.071 Z-1.5 R10\nX0 Y-10 Z-3 R10\n");
    text.replace(text.find("most_sweep = 180"), 16, "most_sweep = 300");
    EXPECT_EQ(write(post_of(text), arc).text, "G0 X10 Y0 Z0\nG3 X0 Y-10 Z-3 R-10\n") << "more than half a circle";
}

TEST(Writer, ClockwiseArcsFromAQuadrantToTheNextAreCutThere) {
    std::string text = small;
    text.insert(text.find("rapid ="), "by_quadrants = true\n");
    const double d = 10 * std::sqrt(0.5);
    const Written w = write(post_of(text), {cl::Linear{{d, d, 0}, {0, 0, 1}, true},
                                            cl::Arc{{d, -d, 0}, {0, 0, 0}, {0, 0, 1}, -geom::pi / 2}});
    EXPECT_EQ(w.text, "G0 X7.071 Y7.071 Z0\nG2 X10 Y0 I-7.071 J-7.071\nX7.071 Y-7.071 I-10 J0\n");
}

TEST(Writer, WhatAMoveHasAndItsTemplateHasNoPlaceForIsLostAndSaid) {
    std::string text = small;
    text.replace(text.find("linear = \"G1 X{x} Y{y} Z{z} {feed}\""), 35, "linear = \"G1 X{x} Y{y}\"");
    const Written w =
        write(post_of(text),
              {cl::Feed{200}, cl::Linear{{1, 0, -5}, {0, 0, 1}, false, cl::Seek::nothing, {{{'C'}, 90, true}}}});
    ASSERT_EQ(w.lost.size(), 3U);
    EXPECT_EQ(w.lost[0], "a move along Z");
    EXPECT_EQ(w.lost[1], "axis C, which moves together with others here,");
    EXPECT_EQ(w.lost[2], "a feed: motion.linear of the post has no place for it");
}

TEST(Writer, FunctionsOfOtherLettersAreLostWhereThePostNamesItsOwn) {
    const std::string with = std::string(small) + "[function]\nletters = \"M\"\ntext = \"{letter}{number}\"\n";
    const Written w = write(post_of(with), {cl::Auxiliary{'M', 50}, cl::Auxiliary{'H', 5}});
    EXPECT_EQ(w.text, "M50\n");
    EXPECT_EQ(w.lost.size(), 1U);
}

TEST(Writer, AnArcThatIsOnePlaceToTheControlIsNoFullCircle) {
    const Post post = post_of(std::string("[numbers]\nincrement = 0.001\nlength = { increments = true }\n") + small);
    const auto arc = [&](double chord, double sweep, double radius = 10) {
        const double angle = chord / radius;
        return write(post, {cl::Linear{{radius, 0, 0}, {0, 0, 1}, true},
                            cl::Arc{{radius * std::cos(angle), radius * std::sin(angle), 0},
                                    {},
                                    {0, 0, 1},
                                    sweep == 0 ? angle : sweep}})
            .text;
    };
    EXPECT_EQ(arc(0.0004, 0), "G0 X10 Y0 Z0\n") << "nothing moves there";
    EXPECT_EQ(arc(0.0014, 0), "G0 X10 Y0 Z0\nG3 Y0.001 I-10 J0\n");
    EXPECT_EQ(arc(0.0004, 0.0004 / 10 - geom::full_turn), "G0 X10 Y0 Z0\nG2 I-10 J0\n") << "nearly a full turn is one";
    EXPECT_EQ(arc(0, geom::full_turn), "G0 X10 Y0 Z0\nG3 I-10 J0\n");
    EXPECT_EQ(arc(0.0007, 0, 0.0004).find('I'), std::string::npos) << "its centre is its start there";
}

TEST(Writer, EveryDecimalIsOneOfTheControl) {
    const std::string text = "[numbers]\nincrement = 0.001\nlength = { increments = true }\n" + std::string(small);
    const std::vector<cl::Step> line{cl::Linear{{1.23456, 0, 0}, {0, 0, 1}, true}};
    EXPECT_EQ(write(post_of(text), line).text, "G0 X1.235 Y0 Z0\n");
    Post finer = post_of(text);
    count_in(finer, 0.0001);
    EXPECT_EQ(write(finer, line).text, "G0 X1.2346 Y0 Z0\n");
    EXPECT_EQ(write(post_of("extends = \"fanuc\"\n[numbers]\nlength = { decimals = 2 }\n"), line).text.find("1.235"),
              std::string::npos)
        << "decimals stand in the place of increments";
    EXPECT_EQ(faults_of("[numbers]\nincrement = 0.002\n"),
              "2: 'increment' is 1 mm or a decimal part of it (0.001, 0.0001)\n");
}

}  // namespace
}  // namespace obrys::write
