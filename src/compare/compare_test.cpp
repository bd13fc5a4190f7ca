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

/// Both end; what the control does then besides is told and is nothing that the machine does to the part.
TEST(Compare, EndsOfOneControlThatAreNotTheSame) {
    const auto ending = [](const std::string& stop) { return steps_of({"linear 1 0 0", "linear 2 0 0", stop}); };
    constexpr Tolerance same{.same_control = true};
    for (const char* other : {"stop end pallets", "stop end stays"}) {
        const Result r = compared(ending("stop end"), ending(other), same);
        ASSERT_NE(r.of(Aspect::events), nullptr) << other;
        EXPECT_FALSE(r.of(Aspect::events)->is_done);
        EXPECT_EQ(compared(ending("stop end"), ending(other), {.is_written_from_a = true}).of(Aspect::events), nullptr);
        EXPECT_EQ(compared(ending(other), ending(other), same).of(Aspect::events), nullptr);
    }
    const Result r = compared(ending("stop program"), ending("stop program pallets"), same);
    ASSERT_NE(r.of(Aspect::events), nullptr);
    EXPECT_TRUE(r.of(Aspect::events)->is_done);
}

/// What a program is given is told of two programs of one control; what is written may have it in its moves.
TEST(Compare, ArgumentsOfCallsAreTold) {
    const auto called = [](const std::string& with) {
        return steps_of({"linear 1 0 0", "call \"P\" pass 1 of 1" + with, "linear 2 0 0", "part-end"});
    };
    constexpr Tolerance same{.same_control = true};
    const std::string three = " with \"DEPTH\" 3 \"NAME\" \"A\"";
    EXPECT_EQ(compared(called(three), called(three), same).of(Aspect::parts), nullptr);
    for (const char* other :
         {"", " with \"DEPTH\" 4 \"NAME\" \"A\"", " with \"DEPTH\" 3 \"NAME\" \"B\"", " with \"DEPTH\" 3"}) {
        EXPECT_NE(compared(called(three), called(other), same).of(Aspect::parts), nullptr) << other;
        EXPECT_EQ(compared(called(three), called(other), {.is_written_from_a = true}).of(Aspect::parts), nullptr);
    }
}

TEST(Compare, PartsAndPreparationsAreSeenAndMoveNothing) {
    const std::vector<cl::Step> flat{line(10), line(20)};
    const auto called = [](std::uint64_t passes) {
        return std::vector<cl::Step>{line(10), cl::PartBegin{cl::PartKind::call, "1", 1, passes}, line(20),
                                     cl::PartEnd{}};
    };
    EXPECT_EQ(differences(flat, called(1)), "parts");
    EXPECT_EQ(differences(called(1), flat), "parts");
    EXPECT_EQ(differences(called(1), called(3)), "parts");
    EXPECT_EQ(differences(called(3), called(3)), "");
    EXPECT_EQ(differences(called(1), {line(10), cl::PartBegin{cl::PartKind::call, "1"}, line(20)}), "parts");
    EXPECT_EQ(differences(called(1), {cl::PartBegin{cl::PartKind::call, "1"}, line(10), line(20), cl::PartEnd{}}),
              "parts");
    const std::vector<cl::Step> prepared{line(10), cl::ToolSelection{7, ""}, line(20)};
    EXPECT_EQ(differences(flat, prepared), "preparation");
    EXPECT_EQ(differences(prepared, {line(10), cl::ToolSelection{8, ""}, line(20)}), "preparation");
    EXPECT_EQ(differences(prepared, {line(10), line(20), cl::ToolSelection{7, ""}}), "preparation");
    EXPECT_EQ(differences(prepared, prepared), "");
    EXPECT_FALSE(is_done(Aspect::parts) || is_done(Aspect::preparation));
}

TEST(Compare, HowCyclesAreCalledAndCompensationIsSaidIsSeen) {
    const auto cycle = [](cl::CycleCall call, std::uint64_t pass, std::uint64_t passes) {
        cl::CycleBegin begin;
        begin.place = {10, 0, 0}, begin.call = call, begin.pass = pass, begin.passes = passes;
        return std::vector<cl::Step>{line(10), begin, line(20), cl::CycleEnd{}};
    };
    const auto once = cycle(cl::CycleCall::single, 1, 1);
    EXPECT_EQ(differences(once, cycle(cl::CycleCall::modal, 1, 1)), "cycles");
    EXPECT_EQ(differences(once, cycle(cl::CycleCall::single, 1, 2)), "cycles");
    EXPECT_EQ(differences(cycle(cl::CycleCall::single, 1, 2), cycle(cl::CycleCall::single, 2, 2)), "cycles");
    std::vector<cl::Step> open = once;
    open.pop_back();
    EXPECT_EQ(differences(once, open), "cycles");
    const auto given = [](bool is_given, std::uint32_t nose) {
        cl::CompensationBegin begin;
        begin.radius = 2, begin.given = is_given, begin.nose = nose;
        return std::vector<cl::Step>{line(10), begin, line(20), cl::CompensationEnd{}};
    };
    EXPECT_EQ(differences(given(true, 0), given(false, 0)), "compensation");
    EXPECT_EQ(differences(given(true, 2), given(true, 3)), "compensation");
    EXPECT_EQ(differences({line(10), cl::LeadBegin{}, line(20), cl::LeadEnd{}}, {line(10), cl::LeadBegin{}, line(20)}),
              "compensation");
    cl::Datum by_word{500, {NAN, NAN, NAN}};
    by_word.selected = true;
    EXPECT_EQ(differences({cl::Datum{500, {NAN, NAN, NAN}}, line(10)}, {by_word, line(10)}), "datum");
}

TEST(Compare, OffsetsCountWhereTheirRadiiAreNotKnown) {
    const auto by = [](std::uint32_t offset, double radius) {
        cl::CompensationBegin begin;
        begin.offset = offset, begin.radius = radius;
        return std::vector<cl::Step>{line(10), begin, line(20), cl::CompensationEnd{}};
    };
    EXPECT_EQ(differences(by(11, 0), by(12, 0)), "compensation");
    EXPECT_EQ(differences(by(11, NAN), by(12, NAN)), "compensation");
    EXPECT_EQ(differences(by(11, 0), by(11, 0)), "");
    EXPECT_EQ(differences(by(11, 5), by(12, 5)), "");  // the radius says what it holds
    EXPECT_EQ(differences(by(11, 0), by(0, 0)), "");   // that of the tool, on a control without numbers
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

/// Exact stop beside a contour that may be left by 1 mm: of two controls that is said in their own ways.
TEST(Compare, HowMovesAreJoinedCountsOnOneControl) {
    const auto done = [](const Tolerance& tolerance) {
        const Result r = compared(steps_of({"path exact", "feed 100 mm/min", "linear 1 2 3"}),
                                  steps_of({"path within tolerance 1", "feed 100 mm/min", "linear 1 2 3"}), tolerance);
        const Difference* d = r.of(Aspect::tolerance);
        return d == nullptr ? std::string("none") : std::string(d->is_done ? "done" : "said");
    };
    EXPECT_EQ(done({.same_control = true}), "done");
    EXPECT_EQ(done({}), "said");
}

/// A pitch adds up with every turn: a coarse tolerance of places says nothing of it.
TEST(Compare, PitchesAreHeldToTheirWords) {
    const auto tapped = [](const std::string& pitch) {
        return steps_of({"spindle 500 1/min cw limit 0", "thread 0 0 -10 pitch " + pitch + " tap"});
    };
    EXPECT_TRUE(compared(tapped("1"), tapped("1.00005"), {.length = 0.1}).is_equal(Aspect::motion));
    EXPECT_FALSE(compared(tapped("1"), tapped("1.01"), {.length = 0.1}).is_equal(Aspect::motion));
}

/// No zero is right for several tools whose lengths do not count.
TEST(Compare, SeveralToolsWithoutTheirLengthsAreAnotherProgram) {
    const auto drilled = [](const std::string& tool, const std::string& more) {
        return std::vector<std::string>{tool + more, "feed 100 mm/min", "rapid 0 0 50", "linear 0 0 -1",
                                        "rapid 0 0 50"};
    };
    const auto joined = [](std::vector<std::string> a, const std::vector<std::string>& b) {
        a.insert(a.end(), b.begin(), b.end());
        return steps_of(a);
    };
    const std::string one = "tool 1 edge 1 \"\"", two = "tool 2 edge 1 \"\"", with = " lengthened";
    const Steps a = joined(drilled(one, with), drilled(two, with)), b = joined(drilled(one, ""), drilled(two, ""));
    const Difference* d = nullptr;
    const Result several = compared(a, b), single = compared(steps_of(drilled(one, with)), steps_of(drilled(one, "")));
    ASSERT_NE(d = several.of(Aspect::tool), nullptr);
    EXPECT_TRUE(d->is_done);
    EXPECT_EQ(single.of(Aspect::tool), nullptr) << "its zero may lie by its length deeper";
    EXPECT_NE(single.of(Aspect::datum), nullptr);
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

/// What a post leaves out of a program that it writes: the numbers look the same.
TEST(Compare, AProgramThatIsWrittenHasItsLengthsAndZeros) {
    const auto in = [](std::uint32_t zero, bool lengthened) {
        Steps out{cl::Datum{zero, {NAN, NAN, NAN}}, cl::ToolChange{1, 1, ""}};
        if (lengthened) out.emplace_back(cl::ToolLength{1, 1, {}});
        out.insert(out.end(), {cl::Feed{100}, line(10), line(20)});
        return out;
    };
    const auto first = [](const Steps& a, const Steps& b, const Tolerance& t) {
        std::string out;
        for (const Difference& d : compared(a, b, t).first)
            out += (out.empty() ? "" : " ") + std::string(name_of(d.aspect));
        return out;
    };
    const Tolerance written{.is_written_from_a = true}, same{.same_control = true};
    EXPECT_EQ(first(in(54, true), in(54, false), {}), "datum");
    EXPECT_EQ(first(in(54, true), in(54, false), written), "tool");
    EXPECT_EQ(first(in(54, false), in(54, true), written), "datum");  // the control compensates by itself
    EXPECT_EQ(first(in(54, true), in(54, false), same), "tool");
    EXPECT_EQ(first(in(54, true), in(55, true), {}), "datum");
    EXPECT_EQ(first(in(54, true), in(55, true), written), "datum motion");
    EXPECT_EQ(first(in(1000, true), in(54, true), written), "datum");  // called otherwise there
}

TEST(Compare, PlacesOfTheMachine) {
    const auto to = [](cl::MachinePlace place) {
        return Steps{cl::ToolChange{1, 1, ""}, line(10), place, cl::Linear{{10, 0, NAN}, {0, 0, 1}, true}, line(20)};
    };
    const cl::MachinePlace up{cl::PlaceKind::coordinates, 1, {false, false, true}, {NAN, NAN, 0}};
    cl::MachinePlace tip = up, home = up, aside = up;
    tip.tip = true;
    home.kind = aside.kind = cl::PlaceKind::home, home.to.z = aside.to.z = NAN;
    aside.axes = {true, false, false};
    EXPECT_EQ(differences(to(up), to(up)), "");
    EXPECT_EQ(differences(to(up), to(tip)), "tool events");
    EXPECT_EQ(differences(to(home), to(aside)), "events");
    // Without its length on the way there, with it again behind that: only where the tip does not go there.
    const auto off = [&](cl::MachinePlace place) {
        Steps out = to(place);
        out.insert(out.begin() + 2, cl::ToolChange{1, 0, ""});
        out.insert(out.end() - 1, cl::ToolChange{1, 1, ""});
        return out;
    };
    EXPECT_EQ(differences(to(up), off(up)), "");
    EXPECT_EQ(differences(to(tip), off(tip)), "tool");
}

TEST(Compare, WhatHoldsWhileTheToolStands) {
    const auto waits = [](const cl::Coolant& coolant) {
        return Steps{line(10), coolant, cl::Dwell{1, 0}, cl::Coolant{}, line(20)};
    };
    EXPECT_EQ(differences(waits({true, false}), waits({false, true})), "coolant");
    EXPECT_EQ(differences(waits({true, false}), waits({true, false})), "");
}

TEST(Compare, ADwellInRevolutionsIsOneInSecondsWhereTheSpindleTurns) {
    const cl::Spindle turns{1000, cl::SpindleMode::rpm, 1};
    EXPECT_EQ(
        differences({turns, line(10), cl::Dwell{0, 20}, line(20)}, {turns, line(10), cl::Dwell{1.2, 0}, line(20)}), "");
    EXPECT_EQ(differences({turns, line(10), cl::Dwell{0, 20}, line(20)}, {turns, line(10), cl::Dwell{2, 0}, line(20)}),
              "events");
    EXPECT_EQ(differences({line(10), cl::Dwell{0, 20}, line(20)}, {line(10), cl::Dwell{1.2, 0}, line(20)}), "events");
}

TEST(Compare, AnotherToolAtTheSameNumbersIsAMove) {
    const Steps there{line(10), cl::ToolChange{2, 1, ""}, line(10), line(20)};
    EXPECT_EQ(differences(there, {line(10), cl::ToolChange{2, 1, ""}, line(20)}), "motion");
    const Steps zero{line(10), cl::Datum{55, {NAN, NAN, NAN}}, line(10), line(20)};
    EXPECT_EQ(differences(zero, {line(10), cl::Datum{55, {NAN, NAN, NAN}}, line(20)}), "motion");
}

TEST(Compare, AnAxisThatIsCountedOtherwiseMoves) {
    const auto turned = [](bool counted) {
        cl::Linear first = line(10), second = line(20);
        first.ends = {{{'C'}, 30, true, false}};
        second.ends = {{{'C'}, 30, true, counted}};
        return Steps{first, second};
    };
    EXPECT_EQ(differences(turned(false), turned(false)), "");
    EXPECT_EQ(differences(turned(false), turned(true)), "motion");
}

/// Of a control that counts in thousandths: B holds each place to half of them.
TEST(Compare, WhatIsLostInTheIncrementsOfAControl) {
    const auto said = [](const Steps& a, const Steps& b, double increment) {
        Tolerance t;
        t.length = 0.0005 * (1 + 1e-6);
        t.increment = increment;
        std::string out;
        const Path p = path_of(a), q = path_of(b);
        for (const Difference& d : compare(p, q, t).first) out += std::string(name_of(d.aspect)) + " ";
        return out;
    };
    const Steps fine{cl::Feed{100}, line(10), line(10.0006), line(10.0012), cl::Stop{}, line(20)};
    const Steps counted{cl::Feed{100}, line(10), line(10.001), cl::Stop{}, line(20)};
    EXPECT_EQ(said(fine, counted, 0.001), "");
    EXPECT_NE(said(fine, counted, 0), "");
    EXPECT_NE(said({line(10), line(10.0008), line(10.0016), line(20)}, {line(10), line(20.0011)}, 0.001), "")
        << "places do not drift";
    EXPECT_NE(said({line(10), line(10.002), line(10, 0.002)}, {line(10), line(10, 0.002)}, 0.001), "");
}

/// Beside a smooth joint that is rounded stands the arc of a corner, or none.
TEST(Compare, AnArcOfNoLengthIsNoMove) {
    const auto about = [](double sweep, double radius) {
        cl::Arc arc;
        arc.centre = {10, radius, 0};
        arc.to = {10 + radius * std::sin(sweep), radius - radius * std::cos(sweep), 0};
        arc.sweep = sweep;
        return arc;
    };
    const Steps without{cl::Feed{100}, line(10), line(20)};
    const auto with = [&](const cl::Arc& arc) { return Steps{cl::Feed{100}, line(10), arc, line(20)}; };
    EXPECT_EQ(differences(without, with(about(1.6e-6, 5))), "");
    EXPECT_EQ(differences(with(about(-1.6e-6, 5)), without), "");
    EXPECT_NE(differences(without, with(about(1e-3, 5))), "");
    EXPECT_NE(differences(without, with(about(geom::full_turn, 5))), "") << "it ends where it begins";
    EXPECT_NE(differences(without, with(about(geom::full_turn - 1e-6, 5))), "");
}

TEST(Compare, SpeedsThatTheirWordHolds) {
    const auto at = [](double speed) { return Steps{cl::Spindle{speed, cl::SpindleMode::rpm, 1}, line(10), line(20)}; };
    const auto same = [&](double a, double b, double step) {
        Tolerance t;
        t.speed_step = step;
        const Path p = path_of(at(a)), q = path_of(at(b));
        return compare(p, q, t).first.empty();
    };
    EXPECT_TRUE(same(1000.4, 1000, 0.5));
    EXPECT_FALSE(same(1000.4, 1000, 0));
    EXPECT_FALSE(same(1000.4, 1001, 0.5));
    EXPECT_FALSE(same(4.5, 5, 0.5)) << "a tenth of it";
    EXPECT_FALSE(same(0.4, 0, 0.5));
}

}  // namespace
}  // namespace obrys::compare
