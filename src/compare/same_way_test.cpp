/// The same way written otherwise is the same, whatever order its records come in.

#include <limits>

#include "base/seed_testing.hpp"
#include "compare/streams_testing.hpp"

namespace obrys::compare {
namespace {

TEST(SameWay, CutAtOtherPointsAndSaidAgain) {
    const std::uint32_t seed = base::testing_seed();
    AnyStream any(seed);
    for (int i = 0; i < 2000; ++i) {
        const Steps steps = any.any(1 + any.below(40));
        const Steps a = any.cut(steps), b = any.cut(any.cut(steps));
        ASSERT_EQ(differences(steps, a), "") << "seed " << seed << "\n" << text_of(steps) << "\n" << text_of(a);
        ASSERT_EQ(differences(a, b), "") << "seed " << seed << "\n" << text_of(a) << "\n" << text_of(b);
    }
}

/// Behind a change of tools the coordinates that no block has said yet are nobody's: a way to a height is one, whatever
/// the stream has as the height before it, and said twice it is one way.
TEST(SameWay, AHeightThatIsNotSaidYetIsNone) {
    const Steps change{cl::ToolChange{2, 1, ""}};
    cl::MachinePlace in_plane{cl::PlaceKind::frame}, height{cl::PlaceKind::frame};
    in_plane.axes = {true, true, false}, height.axes = {false, false, true};
    const auto at = [](double z) { return cl::Linear{{5, 0, z}, {0, 0, 1}, true, cl::Seek::nothing}; };
    const auto moves = [&](const std::vector<cl::Step>& behind) {
        Steps all{at(50), change[0]};
        all.insert(all.end(), behind.begin(), behind.end());
        return path_of(all).moves.size();
    };
    EXPECT_EQ(moves({in_plane, at(50), at(50)}), 3U);
    EXPECT_EQ(moves({in_plane, at(50), cl::ToolLength{1, 2, {}}, at(50)}), 3U);
    EXPECT_EQ(moves({height, at(50), height, at(50)}), 2U);
    EXPECT_EQ(moves({height, at(50), at(50)}), 3U);
    EXPECT_EQ(differences({at(50), change[0], height, at(50), height, at(50), line(9)},
                          {at(50), change[0], height, at(50), line(9)}),
              "");
}

/// The rotary axes go by their words before the plane to where the control would turn them, or it turns them: the
/// linear ones stand either way, and the machine does the same. Other positions, and a stop in between, are not the
/// same.
TEST(SameWay, AxesThatTurnBeforeTheirPlane) {
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    const geom::Vec3 up{0, 0, 1}, tool{0.6, 0, 0.8};
    cl::FramePart plane{cl::FrameKind::plane, {}};
    plane.frame.linear = {0.8, 0, 0.6, 0, 1, 0, -0.6, 0, 0.8};
    const auto turned = [](geom::Vec3 to, geom::Vec3 axis, double b, bool counted) {
        return cl::Linear{to, axis, true, cl::Seek::nothing, {{{'B'}, b, true, counted}}};
    };
    const auto go = [&](geom::Vec3 to, geom::Vec3 axis) { return cl::Linear{to, axis, true, cl::Seek::nothing, {}}; };
    const auto behind = [&](geom::Vec3 place, std::vector<cl::Step> first, double b) {
        Steps all{go({0, 0, 50}, up)};
        all.insert(all.end(), first.begin(), first.end());
        all.insert(all.end(), {cl::Frame{{plane}}, turned(place, tool, b, true), go({5, 0, 9}, tool)});
        return all;
    };
    for (const geom::Vec3 place : {geom::Vec3{30, 0, 40}, geom::Vec3{unknown, unknown, unknown}}) {
        const Steps by_control = behind(place, {}, 36.8699),
                    before = behind(place, {turned({0, 0, 50}, up, 36.87, false)}, 36.8699);
        EXPECT_EQ(differences(by_control, before), "");
        EXPECT_EQ(path_of(before).moves.size(), path_of(by_control).moves.size());
        EXPECT_NE(differences(by_control, behind(place, {turned({0, 0, 50}, up, -36.87, false)}, 36.8699)), "");
        EXPECT_NE(differences(by_control, behind(place, {turned({1, 0, 50}, up, 36.87, false)}, 36.8699)), "");
        EXPECT_NE(differences(by_control, behind(place, {turned({0, 0, 50}, up, 36.87, false), cl::Stop{}}, 36.8699)),
                  "");
        EXPECT_NE(differences(by_control, behind(place, {}, 36.8)), "");
    }
}

/// The control turns the axes to the plane by itself, and the tool's way on the workpiece is the same in both of their
/// positions: which of them is a difference of its own, whatever else is said otherwise before it.
TEST(SameWay, TurnsOfAxesThatNoMoveTells) {
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    const geom::Vec3 tool{0.6, 0, 0.8};
    const auto in_plane = [&](std::int8_t side, bool table, bool by_control = true, double shift = 0) {
        cl::FramePart plane{cl::FrameKind::plane, {}, {side, table, by_control}}, first{cl::FrameKind::shift, {}};
        plane.frame.linear = {0.8, 0, 0.6, 0, 1, 0, -0.6, 0, 0.8};
        first.frame.origin = {shift, 0, 0};
        Steps all{line(1)};
        if (shift != 0) all.insert(all.end(), {cl::Frame{{first}}, line(2)});
        if (shift == 0) all.push_back(line(2));
        all.insert(all.end(), {cl::Frame{{plane}}, cl::Linear{{unknown, unknown, unknown}, tool, true},
                               cl::Linear{{5, 0, 9}, tool, true}});
        return all;
    };
    const auto found = [&](const Steps& a, const Steps& b, bool written = false) {
        Tolerance t;
        t.is_written_from_a = written;
        const Path p = path_of(a), q = path_of(b);
        const Result r = compare(p, q, t);
        const Difference* frame = r.of(Aspect::frame);
        return std::string(frame == nullptr ? "same"
                           : frame->is_done ? "differs"
                                            : "said otherwise") +
               (r.turns ? ", not known" : "");
    };
    for (const bool written : {false, true}) {
        EXPECT_EQ(found(in_plane(0, false), in_plane(0, false), written), "same");
        EXPECT_EQ(found(in_plane(1, false), in_plane(1, false), written), "same");
        EXPECT_EQ(found(in_plane(1, false), in_plane(-1, false), written), "differs");
        EXPECT_EQ(found(in_plane(1, false, true, 3), in_plane(-1, false), written), "differs");
        EXPECT_EQ(found(in_plane(1, false), in_plane(0, false), written), "said otherwise, not known");
        EXPECT_EQ(found(in_plane(0, true), in_plane(0, false), written), "said otherwise, not known");
        // Moves tell where the axes are.
        EXPECT_EQ(found(in_plane(1, false, false), in_plane(-1, false, false), written), "said otherwise");
    }
    EXPECT_EQ(found(in_plane(0, false), in_plane(-1, false)), "said otherwise, not known");
    EXPECT_EQ(found(in_plane(0, false), in_plane(-1, false), true), "said otherwise");
}

/// Behind the end of a plane to which the control has turned the axes nobody knows the tip's place: a way to a height
/// is none to the place that another program says.
TEST(SameWay, TheEndOfAPlaneThatTheControlTurnedTo) {
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    const geom::Vec3 tool{0.6, 0, 0.8}, up{0, 0, 1};
    cl::FramePart plane{cl::FrameKind::plane, {}, {0, false, true}};
    plane.frame.linear = {0.8, 0, 0.6, 0, 1, 0, -0.6, 0, 0.8};
    cl::MachinePlace height{cl::PlaceKind::frame};
    height.axes = {false, false, true};
    const auto go = [](geom::Vec3 to, geom::Vec3 axis) { return cl::Linear{to, axis, true, cl::Seek::nothing}; };
    const auto behind = [&](const Steps& last) {
        Steps all{line(1), cl::Frame{{plane}}, go({unknown, unknown, unknown}, tool), go({5, 0, 9}, tool), cl::Frame{}};
        all.insert(all.end(), last.begin(), last.end());
        return all;
    };
    const cl::Linear told = go({unknown, unknown, unknown}, up);
    const Steps to_height = behind({told, height, go({unknown, unknown, 100}, up)});
    EXPECT_EQ(path_of(to_height).moves.size(), 3U);
    EXPECT_EQ(differences(to_height, to_height), "");
    EXPECT_NE(differences(to_height, behind({go({5, 0, 100}, up)})), "");
}

/// Readers tell such a height by what they count: with the length of the tool before (HEIDENHAIN) or of the tool that
/// is there now (FANUC). No block moves along it in either, so that the machine stands where it stood.
TEST(SameWay, AHeightThatIsNotSaidYetIsNotCompared) {
    cl::MachinePlace in_plane{cl::PlaceKind::frame}, both{cl::PlaceKind::frame};
    in_plane.axes = {true, true, false}, both.axes = {true, true, true};
    const auto at = [](double x, double z, bool rapid = true) {
        return cl::Linear{{x, 0, z}, {0, 0, 1}, rapid, cl::Seek::nothing};
    };
    const auto with = [&](const cl::MachinePlace& said, double unsaid, double x, double next = 2) {
        return Steps{at(5, 50), cl::ToolChange{2, 1, ""}, said, at(x, unsaid), said, at(9, unsaid), at(9, next)};
    };
    const Steps whole = with(in_plane, 50, 7);
    EXPECT_EQ(differences(whole, with(in_plane, 40, 7)), "");
    EXPECT_EQ(differences(whole, with(in_plane, 40, 8)), "motion");
    EXPECT_EQ(differences(whole, with(in_plane, 40, 7, 3)), "motion");
    EXPECT_EQ(differences(whole, with(both, 40, 7)), "motion events");
    // In a turned frame the coordinates of the workpiece are several of the program's.
    const cl::Frame turned{{{cl::FrameKind::rotation, geom::Frame::rotation(0, 0.5)}}};
    const auto in_frame = [&](double unsaid) {
        return Steps{at(5, 50), turned, cl::ToolChange{2, 1, ""}, in_plane, at(7, unsaid), at(9, 2)};
    };
    EXPECT_EQ(differences(in_frame(50), in_frame(40)), "motion");
}

/// As the records come, in any order, the verdict is that of the whole streams.
TEST(SameWay, WhicheverComesFirst) {
    const std::uint32_t seed = base::testing_seed();
    AnyStream any(seed);
    for (int i = 0; i < 1000; ++i) {
        const Steps steps = any.any(1 + any.below(60));
        Steps other = any.cut(steps);
        if (any.one_in(2)) other.erase(other.begin() + static_cast<std::ptrdiff_t>(any.below(other.size())));
        const std::array<std::vector<cl::Record>, 2> records{records_of(steps), records_of(other)};
        Comparison comparison({});
        std::array<std::size_t, 2> next{};
        while (next[0] <= records[0].size() || next[1] <= records[1].size()) {
            std::size_t n = any.below(2);
            if (next[n] > records[n].size()) n = 1 - n;
            const auto side = n == 0 ? Comparison::Side::a : Comparison::Side::b;
            if (next[n] < records[n].size())
                comparison.take(side, records[n][next[n]]);
            else
                comparison.end(side);
            ++next[n];
            if (any.one_in(3)) comparison.advance();
        }
        const Result streamed = comparison.finish(), whole = compared(steps, other);
        ASSERT_EQ(streamed.first.size(), whole.first.size()) << "seed " << seed << "\n" << text_of(steps);
        ASSERT_EQ(streamed.looked_to, whole.looked_to);
        ASSERT_EQ(streamed.moves_b, whole.moves_b);
        for (std::size_t k = 0; k < whole.first.size(); ++k) {
            ASSERT_EQ(streamed.first[k].what, whole.first[k].what);
            ASSERT_EQ(streamed.first[k].move, whole.first[k].move);
        }
    }
}

TEST(SameWay, ACutIsTheSameOnlyWhereNothingHappensThere) {
    const Steps whole{cl::Feed{100}, line(0, 0), line(20, 0)};
    const auto cut = [&](const cl::Step& between) {
        return Steps{cl::Feed{100}, line(0, 0), line(10, 0), between, line(20, 0)};
    };
    EXPECT_EQ(differences(whole, cut(cl::Comment{"x"})), "");
    EXPECT_EQ(differences(whole, cut(cl::Feed{200})), "feed");
    EXPECT_EQ(differences(whole, cut(cl::Dwell{1, 0})), "events");
    EXPECT_EQ(differences(whole, cut(cl::Coolant{true, false})), "coolant");
    EXPECT_EQ(differences(whole, cut(cl::Datum{55, {NAN, NAN, NAN}})), "motion");
}

TEST(SameWay, ATimeForEachMoveIsNotThatOfBoth) {
    const Steps one{cl::Feed{2, cl::FeedMode::inverse_time}, line(0, 0), line(20, 0)};
    const Steps two{cl::Feed{2, cl::FeedMode::inverse_time}, line(0, 0), line(10, 0), line(20, 0)};
    EXPECT_EQ(differences(one, two), "motion");
    const cl::Arc quarter{{0, 10, 0}, {0, 0, 0}, {0, 0, 1}, geom::pi / 2},
        half{{-10, 0, 0}, {0, 0, 0}, {0, 0, 1}, geom::pi};
    const cl::Arc next{{-10, 0, 0}, {0, 0, 0}, {0, 0, 1}, geom::pi / 2};
    const cl::Feed timed{1, cl::FeedMode::inverse_time};
    EXPECT_EQ(differences({timed, line(10, 0), half}, {timed, line(10, 0), quarter, next}), "motion");
    EXPECT_EQ(differences({cl::Feed{9}, line(10, 0), half}, {cl::Feed{9}, line(10, 0), quarter, next}), "");
}

TEST(SameWay, WhereTheToolStandsStillIsNotPassed) {
    const cl::PathMode stops{cl::PathKind::exact_stop};
    EXPECT_EQ(differences({stops, line(0, 0), line(20, 0)}, {stops, line(0, 0), line(10, 0), line(20, 0)}), "motion");
}

/// Where another length is compensated from there on, or the tip is taken to stand higher, the move begins elsewhere
/// than its numbers say: what lies on the line between them need not lie on its way.
TEST(SameWay, AMoveThatBeginsElsewhereIsNotCut) {
    cl::ToolChange tool{1, 1, ""}, raised = tool;
    raised.raised = 0.5;
    const auto way = [&](const cl::Step& between, bool cut) {
        Steps out{tool, cl::Feed{100}, line(0, 0), between};
        if (cut) out.emplace_back(line(10, 0));
        out.emplace_back(line(20, 0));
        return out;
    };
    EXPECT_EQ(differences(way(cl::Comment{"x"}, false), way(cl::Comment{"x"}, true)), "");
    EXPECT_EQ(differences(way(cl::ToolLength{1, 2, {}}, false), way(cl::ToolLength{1, 2, {}}, true)), "motion");
    EXPECT_EQ(differences(way(raised, false), way(raised, true)), "motion");
}

TEST(SameWay, RapidsAreCutAlongAnAxisOnly) {
    const Steps along{line(0, 0, true), line(20, 0, true)}, across{line(0, 0, true), line(20, 10, true)};
    EXPECT_EQ(differences(along, {line(0, 0, true), line(10, 0, true), line(20, 0, true)}), "");
    EXPECT_EQ(differences(across, {line(0, 0, true), line(10, 5, true), line(20, 10, true)}), "motion");
}

/// Many small bends are none of them more than the tolerance, and all together are.
TEST(SameWay, CutsBesideTheLineDoNotAddUp) {
    Steps bent{cl::Feed{100}, line(0, 0)};
    for (int i = 1; i <= 100; ++i) bent.emplace_back(line(i, 1e-6 * i * (100 - i)));
    EXPECT_EQ(differences({cl::Feed{100}, line(0, 0), line(100, 0)}, bent), "motion");
    Steps there_and_back{cl::Feed{100}, line(0, 0), line(60, 0), line(40, 0), line(100, 0)};
    EXPECT_EQ(differences({cl::Feed{100}, line(0, 0), line(100, 0)}, there_and_back), "motion");
}

TEST(SameWay, ACutThatLeadsElsewhereIsShownWhereTheMoveBegan) {
    const Steps a{cl::Feed{100}, line(0, 0), line(10, 0), line(10, 5), line(30, 5)};
    const Steps b{cl::Feed{100}, line(0, 0), line(20, 0), line(10, 5), line(30, 5)};
    const Result r = compared(a, b);
    ASSERT_EQ(r.first.size(), 1U);
    EXPECT_EQ(r.first[0].move, 1U);
    EXPECT_EQ(r.first[0].what, "linear 10 0 0; in the other linear 20 0 0");
    EXPECT_FALSE(r.looked_to);
}

TEST(SameWay, WhatHasNoCounterpartForLongIsNotWaitedFor) {
    Steps a{line(0, 0)}, b{line(0, 0)};
    a.emplace_back(cl::Dwell{1, 0});
    for (int i = 0; i < 5000; ++i) a.emplace_back(line(i % 2, i)), b.emplace_back(line(i % 2, i));
    b.emplace_back(cl::Dwell{2, 0});
    const Result r = compared(a, b);
    ASSERT_EQ(r.first.size(), 1U);
    EXPECT_EQ(r.first[0].what, "dwell 1 0, which the other does not have");
}

}  // namespace
}  // namespace obrys::compare
