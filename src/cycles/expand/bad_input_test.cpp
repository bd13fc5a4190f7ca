/// What every cycle must do with values that make no sense: complain, never hang, never make up a path.

#include <gtest/gtest.h>

#include <limits>

#include "cycles/expand/samples_testing.hpp"
#include "cycles/names.hpp"

namespace obrys::cycles::test {
namespace {

constexpr double inf = std::numeric_limits<double>::infinity();

std::string label(const Sample& s, Role role) { return std::to_string(int(s.kind)) + " " + std::string(name(role)); }

bool finite(const Expansion& e, geom::Vec3 from) {
    for (const cl::Step& s : e.steps) {
        if (cl::is_move(s)) from = cl::position_after(from, s);
        if (const auto* f = std::get_if<cl::Feed>(&s)) {
            if (!(f->value > 0 && std::isfinite(f->value))) return false;
        }
        if (cl::is_move(s) && !geom::is_finite(from)) return false;
    }
    return true;
}

TEST(bad_input, SamplesAreSound) {
    for (const Sample& s : samples()) {
        const Situation start = situation();
        const Expansion e = expand({s.kind, s.values}, start);
        EXPECT_TRUE(e.ok()) << int(s.kind) << ' ' << complaints(e);
        EXPECT_FALSE(e.steps.empty()) << int(s.kind);
        EXPECT_EQ(broken_rules(e, start.at), 0u) << int(s.kind);
        EXPECT_TRUE(finite(e, start.at)) << int(s.kind);
    }
}

TEST(bad_input, EveryKindHasASample) {
    int expanded = 0;
    for (int k = 0; k <= int(Kind::probe); ++k) expanded += is_expanded(Kind(k)) ? 1 : 0;
    EXPECT_EQ(std::size_t(expanded), samples().size());
}

TEST(bad_input, AnUnknownValueGivesNoPath) {
    for (const Sample& s : samples())
        for (const cl::CycleValue& v : s.values) {
            const Expansion e = expand({s.kind, with(s.values, {{v.role, unknown}})}, situation());
            EXPECT_FALSE(e.ok()) << label(s, v.role);
            EXPECT_TRUE(e.steps.empty()) << label(s, v.role);
            EXPECT_FALSE(e.complaints.empty()) << label(s, v.role);
        }
}

/// It says its place itself, and goes there from wherever the tool stands.
bool says_its_place(const Sample& s) {
    const Demand d{s.kind, s.values};
    const bool round_slot_elsewhere = s.kind == Kind::round_slot && d.get(Role::position, 0) != 0;
    return d.find(Role::target_u) || d.find(Role::start_u) || (d.find(Role::centre_u) && !round_slot_elsewhere);
}

TEST(bad_input, AnUnknownPlaceGivesNoPath) {
    for (const Sample& s : samples()) {
        if (says_its_place(s)) continue;
        Situation nowhere = situation();
        nowhere.at.x = unknown;
        EXPECT_FALSE(expand({s.kind, s.values}, nowhere).simulated) << int(s.kind);
    }
}

/// Where the moves lead, from the first one on that leads to a known place.
std::vector<geom::Vec3> places(const Expansion& e, geom::Vec3 at) {
    std::vector<geom::Vec3> out;
    for (const cl::Step& step : e.steps) {
        if (!cl::is_move(step)) continue;
        at = cl::position_after(at, step);
        if (geom::is_finite(at)) out.push_back(at);
    }
    return out;
}

TEST(bad_input, WhatSaysItsPlaceGoesThereFromAnywhere) {
    int kinds = 0;
    for (const Sample& s : samples()) {
        if (!says_its_place(s) || Demand{s.kind, s.values}.find(Role::target_u)) continue;
        ++kinds;
        Situation nowhere = situation(), elsewhere = situation();
        nowhere.at.x = nowhere.at.y = unknown;
        elsewhere.at.x = elsewhere.at.y = -4321;
        const Expansion lost = expand({s.kind, s.values}, nowhere);
        EXPECT_TRUE(lost.simulated) << int(s.kind);
        const std::vector<geom::Vec3> a = places(lost, nowhere.at);
        std::vector<geom::Vec3> b = places(expand({s.kind, s.values}, elsewhere), elsewhere.at);
        ASSERT_FALSE(a.empty()) << int(s.kind);
        ASSERT_LE(a.size(), b.size()) << int(s.kind);
        b.erase(b.begin(), b.end() - static_cast<std::ptrdiff_t>(a.size()));
        EXPECT_EQ(a, b) << int(s.kind);
    }
    EXPECT_GE(kinds, 9);
}

TEST(bad_input, AnUnknownToolGivesNoPathWhereItMatters) {
    for (const Kind kind : {Kind::bore_mill, Kind::thread_mill, Kind::thread_mill_outside, Kind::multipass,
                            Kind::face_mill, Kind::ruled_surface})
        for (const Sample& s : samples())
            if (s.kind == kind) {
                Situation any = situation();
                any.tool_radius = unknown;
                const Expansion e = expand({s.kind, s.values}, any);
                EXPECT_FALSE(e.simulated) << int(s.kind);
                EXPECT_TRUE(e.steps.empty()) << int(s.kind);
            }
}

TEST(bad_input, PositiveDepth) {
    for (const Sample& s : samples())
        if (s.kind != Kind::thread_cut && Demand{s.kind, s.values}.find(Role::depth)) {
            const Expansion e = expand({s.kind, with(s.values, {{Role::depth, 5}})}, situation());
            EXPECT_FALSE(e.ok()) << int(s.kind);
            EXPECT_TRUE(e.steps.empty()) << int(s.kind);
            ASSERT_FALSE(e.complaints.empty());
            EXPECT_EQ(e.complaints.at(0).text, "Enter depth as a negative value") << int(s.kind);
        }
}

TEST(bad_input, ZeroDepthIsNotExecuted) {
    for (const Kind kind :
         {Kind::drill, Kind::ream, Kind::tap_rigid, Kind::centre, Kind::peck, Kind::thread_cut, Kind::thread_mill})
        for (const Sample& s : samples())
            if (s.kind == kind) {
                const Expansion e = expand({kind, with(s.values, {{Role::depth, 0}})}, situation());
                EXPECT_TRUE(e.ok()) << int(kind);
                EXPECT_TRUE(e.steps.empty()) << int(kind);
                EXPECT_EQ(e.complaints.size(), 1u) << int(kind);
            }
}

/// Values that no cycle takes for these parameters.
TEST(bad_input, NamesTheParameterAtFault) {
    const std::vector<std::pair<Role, double>> bad = {{Role::infeed, 0},
                                                      {Role::infeed, -1},
                                                      {Role::second_clearance, -1},
                                                      {Role::feed_plunge, -5},
                                                      {Role::feed_mill, 0},
                                                      {Role::feed_mill, inf},
                                                      {Role::feed_position, 0},
                                                      {Role::pitch, 0},
                                                      {Role::diameter, 0},
                                                      {Role::diameter, -3},
                                                      {Role::infeed_per_turn, 0},
                                                      {Role::infeed_per_turn, 1e-7},
                                                      {Role::depth, -1e300},
                                                      {Role::depth, inf},
                                                      {Role::surface, -inf},
                                                      {Role::dwell_bottom, -1},
                                                      {Role::passes, 0},
                                                      {Role::passes, 1e9},
                                                      {Role::overlap, 0},
                                                      {Role::overlap, 1e-9},
                                                      {Role::strategy, 7},
                                                      {Role::thickness, 0},
                                                      {Role::chip_break_depth, -1},
                                                      {Role::chip_break_depth, 1e-12},
                                                      {Role::rpm_factor, -1},
                                                      {Role::threads_per_step, 1.5}};
    for (const auto& [role, value] : bad) {
        int tried = 0;
        for (const Sample& s : samples()) {
            if (!Demand{s.kind, s.values}.find(role)) continue;
            const bool signs = s.kind == Kind::peck || s.kind == Kind::rectangular_pocket_simple ||
                               s.kind == Kind::circular_pocket_simple;
            if (signs && role == Role::infeed && value < 0) continue;  // sign of older programs
            if (s.kind == Kind::canned_tap_rigid && role == Role::infeed && value == 0) continue;  // Q0: in one go
            tried++;
            const Expansion e = expand({s.kind, with(s.values, {{role, value}})}, situation());
            EXPECT_FALSE(e.ok()) << label(s, role) << ' ' << value;
            EXPECT_TRUE(e.steps.empty()) << label(s, role) << ' ' << value;
            bool named = false;
            for (const Complaint& c : e.complaints) named = named || c.role == role;
            EXPECT_TRUE(named) << label(s, role) << ' ' << value << ": " << complaints(e);
        }
        EXPECT_GT(tried, 0) << name(role);
    }
}

TEST(bad_input, NegativeClearance) {
    for (const Sample& s : samples()) {
        const bool old_form = s.kind == Kind::peck || s.kind == Kind::tap_floating_simple ||
                              s.kind == Kind::tap_rigid_simple || s.kind == Kind::rectangular_pocket_simple ||
                              s.kind == Kind::circular_pocket_simple;
        if (old_form || !Demand{s.kind, s.values}.find(Role::clearance)) continue;
        const Expansion e = expand({s.kind, with(s.values, {{Role::clearance, -1}})}, situation());
        EXPECT_FALSE(e.ok()) << int(s.kind);
        EXPECT_TRUE(e.steps.empty()) << int(s.kind);
    }
}

TEST(bad_input, TinyInfeedsEnd) {
    for (const Sample& s : samples())
        if (Demand{s.kind, s.values}.find(Role::infeed)) {
            const Expansion e =
                expand({s.kind, with(s.values, {{Role::infeed, 1e-12}, {Role::min_infeed, 1e-12}})}, situation());
            EXPECT_FALSE(e.ok()) << int(s.kind);
            EXPECT_TRUE(e.steps.empty()) << int(s.kind);
        }
}

TEST(bad_input, MissingParameters) {
    for (const Sample& s : samples()) {
        const Expansion e = expand({s.kind, {}}, situation());
        EXPECT_FALSE(e.ok()) << int(s.kind);
        EXPECT_TRUE(e.steps.empty()) << int(s.kind);
    }
}

TEST(bad_input, KindsThatAreNotExpandedSayso) {
    const Expansion e = expand({Kind::rough_out, {}}, situation());
    EXPECT_FALSE(e.simulated);
    EXPECT_FALSE(e.complaints.empty());
    EXPECT_FALSE(is_expanded(Kind::probe));
}

/// Moving the call and the surface moves the steps, and nothing else.
TEST(bad_input, PathIsCarriedAlong) {
    for (const Sample& s : samples()) {
        // Canned cycles have more heights than the surface, and a test of their own.
        if (!Demand{s.kind, s.values}.find(Role::surface) || Demand{s.kind, s.values}.find(Role::retract_plane))
            continue;
        Situation a = situation(), b = situation(137);
        b.at.x += 3;
        b.at.y -= 8;
        const Expansion one = expand({s.kind, s.values}, a);
        const double surface = Demand{s.kind, s.values}.get(Role::surface) + 37;
        Values moved = with(s.values, {{Role::surface, surface}});
        for (const auto& [role, by] : {std::pair{Role::centre_u, 3.0}, std::pair{Role::centre_v, -8.0}})
            if (const auto centre = Demand{s.kind, s.values}.find(role)) moved.push_back({role, *centre + by});
        const Expansion two = expand({s.kind, moved}, b);
        ASSERT_EQ(one.steps.size(), two.steps.size()) << int(s.kind);
        for (std::size_t i = 0; i < one.steps.size(); ++i) {
            a.at = cl::position_after(a.at, one.steps[i]);
            b.at = cl::position_after(b.at, two.steps[i]);
            EXPECT_NEAR(geom::distance(a.at + geom::Vec3{3, -8, 37}, b.at), 0, 1e-9) << int(s.kind) << " step " << i;
        }
    }
}

/// Any mixture of values: bounded, finite, and the stream's rules hold.
TEST(bad_input, NonsenseIsBounded) {
    const std::uint32_t seed = 20260713;
    Random random(seed);
    const double nasty[] = {0, -1, 1, 1e-12, -1e-12, 1e-2, 5, -20, 360, 1e6, -1e6, 1e300, inf, -inf, unknown, 0.1, 3};
    for (int round = 0; round < 30000; ++round) {
        const Sample& s = samples()[std::size_t(random.upto(int(samples().size()) - 1))];
        Values v = s.values;
        for (int k = random.upto(3); k >= 0; --k)
            v.push_back(
                {v[std::size_t(random.upto(int(v.size()) - 1))].role, nasty[random.upto(int(std::size(nasty)) - 1)]});
        Situation start = situation();
        if (random.upto(3) == 0) start.at.z = nasty[random.upto(int(std::size(nasty)) - 1)];
        if (random.upto(3) == 0) start.tool_radius = nasty[random.upto(int(std::size(nasty)) - 1)];
        if (random.upto(3) == 0) start.spindle_speed = nasty[random.upto(int(std::size(nasty)) - 1)];
        const Expansion e = expand({s.kind, v}, start);
        ASSERT_LE(e.steps.size(), most_steps) << "seed " << seed << " round " << round;
        ASSERT_TRUE(e.ok() || e.steps.empty()) << "seed " << seed << " round " << round;
        ASSERT_TRUE(e.ok() || !e.complaints.empty()) << "seed " << seed << " round " << round;
        const bool by_itself = Demand{s.kind, v}.find(Role::target_u) && !std::isfinite(start.at.z);
        ASSERT_TRUE(by_itself || finite(e, start.at))
            << "seed " << seed << " round " << round << " kind " << int(s.kind);
        if (!std::isfinite(start.at.z)) continue;
        ASSERT_EQ(broken_rules(e, start.at), 0u)
            << "seed " << seed << " round " << round << " kind " << int(s.kind) << ' ' << script(e, start.at);
    }
}

}  // namespace
}  // namespace obrys::cycles::test
