#include "compare/streams_testing.hpp"

namespace obrys::compare {
namespace {

TEST(Compare, RecordsThatChangeNothingDoNotCount) {
    EXPECT_EQ(differences({cl::Feed{100}, line(10), line(20)}, {cl::Feed{50}, cl::Feed{100}, line(10), cl::Feed{100},
                                                                line(10), line(20.00005), cl::Feed{9}}),
              "");
}

TEST(Compare, EachAspectIsSeen) {
    const std::vector<cl::Step> base{cl::Feed{100}, line(10), line(20)};
    EXPECT_EQ(differences(base, {cl::Feed{100}, line(10), line(20.001)}), "motion");
    EXPECT_EQ(differences(base, {cl::Feed{100}, line(10)}), "motion");
    EXPECT_EQ(differences(base, {cl::Feed{100}, line(10), line(20), line(30)}), "motion");
    EXPECT_EQ(differences(base, {cl::Feed{100}, line(10), cl::Feed{101}, line(20)}), "feed");
    EXPECT_EQ(differences(base, {cl::Feed{100}, line(10), cl::Spindle{10, cl::SpindleMode::rpm, 1}, line(20)}),
              "spindle");
    EXPECT_EQ(differences(base, {cl::Feed{100}, line(10), cl::Coolant{true, false}, line(20)}), "coolant");
    EXPECT_EQ(differences(base, {cl::Feed{100}, cl::ToolChange{1, 1, ""}, line(10), line(20)}), "tool events");
    EXPECT_EQ(differences(base, {cl::Feed{100}, line(10), cl::Dwell{1, 0}, line(20)}), "events");
    EXPECT_EQ(differences(base, {cl::Feed{100}, line(10), cl::Tolerance{0.1, 0}, line(20)}), "tolerance");
    EXPECT_EQ(differences(base, {cl::Feed{100}, line(10), cl::CycleBegin{}, line(20), cl::CycleEnd{}}), "cycles");
    EXPECT_EQ(differences(base, {cl::Feed{100}, line(10), cl::CompensationBegin{}, line(20), cl::CompensationEnd{}}),
              "compensation");
    EXPECT_EQ(differences(base, {cl::Feed{100}, line(10),
                                 cl::Frame{{{cl::FrameKind::shift, geom::Frame::shift({1, 0, 0})}}}, line(20)}),
              "frame");
}

TEST(Compare, AnEventStandsBetweenTheSameMoves) {
    EXPECT_EQ(differences({line(10), cl::Stop{}, line(20)}, {line(10), line(20), cl::Stop{}}), "events");
}

TEST(Compare, ArcsAreTheSameWayWhateverSideTheirAxisIsSeenFrom) {
    const cl::Arc a{{0, 10, 0}, {0, 0, 0}, {0, 0, 1}, geom::pi / 2};
    const cl::Arc b{{0, 10, 0}, {0, 0, 7}, {0, 0, -1}, -geom::pi / 2};
    const cl::Arc other{{0, 10, 0}, {0, 0, 0}, {0, 0, 1}, geom::pi / 2 - geom::full_turn};
    EXPECT_EQ(differences({line(10), a}, {line(10), b}), "");
    EXPECT_EQ(differences({line(10), a}, {line(10), other}), "motion");
    EXPECT_EQ(differences({line(10), a}, {line(10), line(0, 10)}), "motion");
}

TEST(Compare, LengthsThatCountAtAHeightAreSeenThere) {
    const auto over = [](double x, double z) { return cl::Linear{{x, 0, z}, {0, 0, 1}, true}; };
    const cl::ToolChange tool{1, 1, ""};
    const auto with = [&](const cl::ToolLength& length) {
        return std::vector<cl::Step>{tool, cl::Feed{100}, over(0, 50), length, over(5, 50), over(9, 50), over(9, 10)};
    };
    EXPECT_EQ(differences(with({1, 2, {}}), with({1, 2, {}})), "");
    EXPECT_EQ(differences(with({1, 2, {}}), with({1, 3, {}})), "tool");
    EXPECT_EQ(differences(with({1, 0, geom::Vec3{0, 0, 40}}), with({1, 0, geom::Vec3{0, 0, 41}})), "tool");
    EXPECT_EQ(differences(with({1, 0, geom::Vec3{0, 0, 40}}), with({1, 0, geom::Vec3{0, 0, 40}})), "");
}

TEST(Compare, TheSameNumbersWithAnotherLengthAreAMove) {
    const std::vector<cl::Step> moves{line(10), cl::ToolLength{1, 2, {}}, line(10), line(20)};
    EXPECT_EQ(differences(moves, {line(10), cl::ToolLength{1, 2, {}}, line(20)}), "motion");
}

TEST(Compare, BehindAMoveTooManyNothingIsCalledEqual) {
    const Result r = compared({line(10), line(20, 5), line(30)}, {line(10), line(30)});
    EXPECT_FALSE(r.is_equal(Aspect::motion));
    EXPECT_FALSE(r.is_equal(Aspect::feed));
    EXPECT_TRUE(r.is_equal(Aspect::cycles));
    EXPECT_EQ(r.looked_to, 1U);
    const std::vector<cl::Step> slow{cl::Feed{100}, line(10), line(21, 5), line(30)};
    EXPECT_EQ(differences(slow, {cl::Feed{100}, line(10), line(20, 5), cl::Feed{90}, line(30)}), "motion feed");
}

TEST(Compare, AnUnknownPlaceIsTheSameAsAnUnknownOneOnly) {
    EXPECT_EQ(differences({line(NAN)}, {line(NAN)}), "");
    EXPECT_EQ(differences({line(NAN)}, {line(5)}), "motion");
}

}  // namespace
}  // namespace obrys::compare
