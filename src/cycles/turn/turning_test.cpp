#include "cycles/turn/turning.hpp"

#include "cycles/cycle_testing.hpp"

namespace obrys::cycles::test {
namespace {

using geom::Vec2;
using Contour = std::vector<TurningElement>;

/// At Z 5 X 20 (radius) unless said otherwise.
TurningDemand demand(Kind kind, Values values, Contour contour = {}, Vec2 at = {5, 20}) {
    TurningDemand d;
    d.cycle = {kind, std::move(values)};
    d.contour = std::move(contour);
    d.situation = situation();
    d.situation.at = {at.x, at.y, 0};
    return d;
}

/// u is Z, v is X.
std::string script_of(const TurningDemand& d) {
    const Expansion e = expand_turning(d);
    return e.ok() ? script(e, d.situation.at) : "complaint: " + complaints(e);
}

TurningElement to(double z, double x, bool rapid = false) { return {.to = {z, x}, .rapid = rapid}; }

/// A shaft with a shoulder: from X 20 to 10, along to Z -20, out to X 16, cone to Z -30 X 20.
const Contour shaft = {to(5, 10, true), to(-20, 10), to(-20, 16), to(-30, 20)};
const Values allowances = {{Role::allowance_u, 0.1}, {Role::allowance_v, 0.5}};

TEST(turning, BoxCycles) {
    const Values end = {{Role::target_u, -30}, {Role::target_v, 15}};
    EXPECT_EQ(script_of(demand(Kind::lathe_box_along, end)), "R v15 L u-30 L v20 R u5");
    EXPECT_EQ(script_of(demand(Kind::lathe_box_along, with(end, {{Role::taper_v, -2}}))),
              "R v13 L u-30 v15 L v20 R u5");
    EXPECT_EQ(script_of(demand(Kind::lathe_box_across, end)), "R u-30 L v15 L u5 R v20");
    EXPECT_EQ(script_of(demand(Kind::lathe_box_across, with(end, {{Role::taper_u, 1}}))),
              "R u-29 L u-30 v15 L u5 R v20");
}

TEST(turning, BoxThread) {
    const Values thread = {{Role::target_u, -30}, {Role::target_v, 18}, {Role::pitch, 2}};
    EXPECT_EQ(script_of(demand(Kind::lathe_box_thread, thread)), "R v18 T2 u-30 R v20 R u5");
    // The runout goes away at 45 degrees, the lead along the axis stays.
    EXPECT_EQ(script_of(demand(Kind::lathe_box_thread, with(thread, {{Role::runout, 1}}))),
              "R v18 T2 u-29 T2.828427 u-30 v19 R v20 R u5");
    EXPECT_EQ(script_of(demand(Kind::lathe_box_thread, with(thread, {{Role::runout, 3}}))),
              "R v18 T2 u-27 T2.403701 u-30 v20 R R u5");
    const Values cone = with(thread, {{Role::taper_v, -3.5}, {Role::pitch, 3.5}});
    EXPECT_EQ(script_of(demand(Kind::lathe_box_thread, cone)), "R v14.5 T3.517456 u-30 v18 R v20 R u5");
}

TEST(turning, ThreadInPasses) {
    const Values thread = {{Role::target_u, -30},   {Role::target_v, 18},     {Role::pitch, 2},
                           {Role::thread_depth, 1}, {Role::first_depth, 0.5}, {Role::finish_allowance, 0.1}};
    // Depths 0.5, 0.5 sqrt 2, 0.5 sqrt 3, what the finishing leaves, the whole.
    EXPECT_EQ(script_of(demand(Kind::lathe_thread_passes, thread)),
              "R R v18.5 T2 u-30 R v20 R u5 R v18.292893 T2 u-30 R v20 R u5 R v18.133975 T2 u-30 R v20 R u5 "
              "R v18.1 T2 u-30 R v20 R u5 R v18 T2 u-30 R v20 R u5");
    const Expansion e = expand_turning(
        demand(Kind::lathe_thread_passes,
               with(thread,
                    {{Role::min_infeed, 0.3}, {Role::finish_passes, 3}, {Role::infeed_angle, 30}, {Role::runout, 2}})));
    ASSERT_TRUE(e.ok()) << complaints(e);
    EXPECT_FALSE(e.assumption.empty());
    int full = 0;
    double deepest = 100;
    for (const cl::Step& s : e.steps)
        if (const auto* t = std::get_if<cl::Thread>(&s)) {
            deepest = std::min(deepest, t->to.y);
            full += std::abs(t->to.y - 18) < 1e-9 ? 1 : 0;
        }
    EXPECT_NEAR(deepest, 18, 1e-9);
    EXPECT_EQ(full, 3);
    // An inside thread grows outwards.
    EXPECT_EQ(script_of(demand(Kind::lathe_thread_passes,
                               {{Role::target_u, -10},
                                {Role::target_v, 11},
                                {Role::pitch, 1},
                                {Role::thread_depth, 1},
                                {Role::first_depth, 1}},
                               {}, {5, 9})),
              "R R v11 T1 u-10 R v9 R u5");
}

TEST(turning, Pecks) {
    EXPECT_EQ(script_of(demand(Kind::lathe_peck_along, {{Role::target_u, -10}, {Role::infeed, 6}, {Role::escape, 1}})),
              "L u-1 R u0 L u-7 R u-6 L u-10 R u5");
    EXPECT_EQ(script_of(demand(Kind::lathe_peck_across, {{Role::target_v, 14},
                                                         {Role::target_u, 0},
                                                         {Role::infeed, 4},
                                                         {Role::escape, 0.5},
                                                         {Role::stepover, 3},
                                                         {Role::relief, 0.25}})),
              "L v16 R v16.5 L v14 R v20 R u2 L v16 R v16.5 L v14 R u2.25 R v20 R u0 L v16 R v16.5 L v14 R u0.25 R v20 "
              "R u5");
    EXPECT_FALSE(expand_turning(demand(Kind::lathe_peck_along, {{Role::infeed, 6}})).ok());
}

TEST(turning, FinishingBringsItsFeeds) {
    Contour c = shaft;
    c[1].feed = cl::Feed{0.15, cl::FeedMode::per_rev};
    EXPECT_EQ(script_of(demand(Kind::lathe_finish, {}, c)), "R v10 F0.15 L u-20 L v16 L u-30 v20 R u5");
}

TEST(turning, StockRemovalAlong) {
    EXPECT_EQ(
        script_of(demand(Kind::lathe_remove_along, with(allowances, {{Role::infeed, 4}, {Role::escape, 1}}), shaft)),
        "R u5.1 v20.5 R v16.5 L u-19.9 R u-18.9 v17.5 R u5.1 R v12.5 L u-19.9 R u-18.9 v13.5 R u5.1 "
        "R v10.5 L u-19.9 L v16.5 L u-29.9 v20.5 R R u5 v20");
    // The same contour towards the tailstock and inside: mirrored.
    Contour bore = {to(-5, 30), to(20, 30), to(20, 24), to(30, 20)};
    EXPECT_EQ(
        script_of(demand(Kind::lathe_remove_along, {{Role::infeed, 4}, {Role::escape, 1}, {Role::allowance_v, -0.5}},
                         bore, {-5, 20})),
        "R v19.5 L v23.5 L u20 R u19 v22.5 R u-5 L v27.5 L u20 R u19 v26.5 R u-5 L v29.5 L u20 L v23.5 L u30 v19.5 "
        "R R u-5 v20");
}

TEST(turning, StockRemovalAcross) {
    const Contour face = {to(-10, 20, true), to(-10, 12), to(0, 12), to(5, 8)};
    EXPECT_EQ(script_of(demand(Kind::lathe_remove_across, {{Role::infeed, 6}, {Role::escape, 1}}, face)),
              "R R u-1 L v12 R u0 v13 R v20 R u-7 L v12 R u-6 v13 R v20 R u-10 L v12 L u0 L u5 v8 R R v20");
}

TEST(turning, StockRemovalWantsOneDirection) {
    Contour pocket = shaft;
    pocket.insert(pocket.begin() + 2, {to(-22, 8), to(-28, 8)});
    pocket[4].to.x = -28;
    const Values values = {{Role::infeed, 1}, {Role::escape, 0.5}};
    EXPECT_FALSE(expand_turning(demand(Kind::lathe_remove_along, values, pocket)).ok());
    const TurningDemand two = demand(Kind::lathe_remove_along, with(values, {{Role::pockets, 1}}), pocket);
    const Expansion e = expand_turning(two);
    ASSERT_TRUE(e.ok()) << complaints(e);
    EXPECT_FALSE(e.assumption.empty());
    double lowest = 100;
    for (const cl::Step& s : e.steps)
        if (const auto* line = std::get_if<cl::Linear>(&s)) lowest = std::min(lowest, line->to.y);
    EXPECT_NEAR(lowest, 8, 1e-9);
    EXPECT_EQ(walk(e, two.situation.at).end, (geom::Vec3{5, 20, 0}));
}

TEST(turning, PatternComesNearer) {
    EXPECT_EQ(script_of(demand(Kind::lathe_repeat_pattern,
                               with(allowances, {{Role::relief_u, 1}, {Role::relief_v, 4}, {Role::passes, 2}}),
                               {to(5, 10, true), to(-20, 10), to(-25, 20)})),
              "R u6.1 v24.5 R v14.5 L u-18.9 L u-23.9 v24.5 R u5.1 v20.5 R v10.5 L u-19.9 L u-24.9 v20.5 R u5 v20");
}

/// No cut of stock removal goes deeper than the contour with its allowances, and at last the whole of it is followed.
TEST(turning, RemovalStaysOutsideTheContour) {
    const std::uint32_t seed = 20261121;
    Random r(seed);
    for (int round = 0; round < 300; ++round) {
        Contour c = {to(2, r.in(5, 15), true)};
        const double last = c[0].to.y;
        std::vector<Vec2> corners{c[0].to};
        Vec2 at = c[0].to;
        double x = last;
        for (int k = 0; k < 5; ++k) {
            at = {at.x - r.in(0.5, 6), x += r.in(0, 3)};
            c.push_back(to(at.x, at.y));
            corners.push_back(at);
        }
        const double ax = r.in(0, 0.5), az = r.in(0, 0.2);
        const TurningDemand d = demand(
            Kind::lathe_remove_along,
            {{Role::infeed, r.in(0.3, 3)}, {Role::escape, 0.5}, {Role::allowance_u, az}, {Role::allowance_v, ax}}, c,
            {2, 30});
        const Expansion e = expand_turning(d);
        ASSERT_TRUE(e.ok()) << "seed " << seed << " round " << round << complaints(e);
        const auto contour_at = [&](double z) {
            for (std::size_t i = 1; i < corners.size(); ++i)
                if (z >= corners[i].x + az) {
                    const double part = (z - az - corners[i - 1].x) / (corners[i].x - corners[i - 1].x);
                    return corners[i - 1].y + std::max(0.0, part) * (corners[i].y - corners[i - 1].y) + ax;
                }
            return corners.back().y + ax;
        };
        Vec2 from{2, 30};
        for (const cl::Step& s : e.steps) {
            const auto& line = std::get<cl::Linear>(s);
            for (const double part : {0.0, 0.25, 0.5, 0.75, 1.0}) {
                const Vec2 p = from + part * (Vec2{line.to.x, line.to.y} - from);
                if (p.x > 2) continue;
                ASSERT_GE(p.y, contour_at(p.x) - 1e-6) << "seed " << seed << " round " << round;
            }
            from = {line.to.x, line.to.y};
        }
    }
}

struct TurningSample {
    Kind kind;
    Values values;
    bool contour;
};

const std::vector<TurningSample>& turning_samples() {
    static const Values end = {{Role::target_u, -30}, {Role::target_v, 15}};
    static const Values thread = with(end, {{Role::pitch, 2}, {Role::taper_v, -1}, {Role::runout, 1}});
    static const std::vector<TurningSample> all = {
        {Kind::lathe_finish_offset,
         {{Role::allowance_first, 0.5}, {Role::allowance_last, 0.1}, {Role::passes, 3}},
         true},
        {Kind::lathe_rough_along,
         {{Role::infeed, 2},
          {Role::escape, 0.3},
          {Role::allowance_side, 0.2},
          {Role::offset_u, 0},
          {Role::offset_v, 0},
          {Role::pockets, 0},
          {Role::length_unit, 1}},
         true},
        {Kind::lathe_rough_across, {{Role::infeed, 2}, {Role::escape, 0.3}, {Role::pockets, 1}}, true},
        {Kind::lathe_thread_degressive,
         {{Role::target_u, -30},
          {Role::pitch, 2},
          {Role::crest_offset, -1},
          {Role::first_depth, 0.3},
          {Role::thread_depth, 1.2},
          {Role::degression, 2},
          {Role::infeed_angle, 29.5},
          {Role::spring_passes, 1},
          {Role::taper_length, 1},
          {Role::taper_ends, 3}},
         false},
        {Kind::lathe_finish, {}, true},
        {Kind::lathe_remove_along,
         with(allowances, {{Role::infeed, 2},
                           {Role::escape, 0.5},
                           {Role::pockets, 0},
                           {Role::relief_u, 0.1},
                           {Role::relief_v, 0.2}}),
         true},
        {Kind::lathe_remove_across, with(allowances, {{Role::infeed, 2}, {Role::escape, 0.5}, {Role::pockets, 1}}),
         true},
        {Kind::lathe_repeat_pattern, with(allowances, {{Role::relief_u, 1}, {Role::relief_v, 2}, {Role::passes, 3}}),
         true},
        {Kind::lathe_peck_along,
         with(end, {{Role::infeed, 3}, {Role::stepover, 2}, {Role::escape, 1}, {Role::relief, 0.1}}), false},
        {Kind::lathe_peck_across,
         with(end, {{Role::infeed, 3}, {Role::stepover, 9}, {Role::escape, 1}, {Role::relief, 0}}), false},
        {Kind::lathe_thread_passes,
         with(thread, {{Role::thread_depth, 1.2},
                       {Role::first_depth, 0.3},
                       {Role::min_infeed, 0.05},
                       {Role::finish_allowance, 0.05},
                       {Role::finish_passes, 2},
                       {Role::runout_leads, 0.5},
                       {Role::infeed_method, 2},
                       {Role::infeed_angle, 30}}),
         false},
        {Kind::lathe_box_along, with(end, {{Role::taper_v, 1}}), false},
        {Kind::lathe_box_thread, thread, false},
        {Kind::lathe_box_across, with(end, {{Role::taper_u, 1}}), false},
    };
    return all;
}

TEST(turning, EveryKindHasASample) {
    std::size_t kinds = 0;
    for (int k = 0; k <= int(Kind::probe); ++k) kinds += is_turning_cycle(Kind(k)) ? 1 : 0;
    EXPECT_EQ(kinds, turning_samples().size());
    EXPECT_FALSE(expand_turning(demand(Kind::drill, {})).simulated);
    for (const TurningSample& s : turning_samples()) {
        const TurningDemand d = demand(s.kind, s.values, s.contour ? shaft : Contour{});
        const Expansion e = expand_turning(d);
        EXPECT_TRUE(e.ok()) << int(s.kind) << complaints(e);
        EXPECT_FALSE(e.steps.empty()) << int(s.kind);
        EXPECT_EQ(broken_rules(e, d.situation.at), 0u) << int(s.kind);
        EXPECT_FALSE(expand_turning(demand(s.kind, s.contour ? s.values : Values{})).ok()) << int(s.kind);
    }
}

TEST(turning, UnknownsGiveNoPath) {
    for (const TurningSample& s : turning_samples()) {
        const Contour contour = s.contour ? shaft : Contour{};
        for (const cl::CycleValue& v : s.values) {
            const Expansion e = expand_turning(demand(s.kind, with(s.values, {{v.role, unknown}}), contour));
            EXPECT_FALSE(e.ok()) << int(s.kind) << ' ' << int(v.role);
            EXPECT_TRUE(e.steps.empty());
        }
        EXPECT_FALSE(expand_turning(demand(s.kind, s.values, contour, {unknown, 20})).ok()) << int(s.kind);
        if (!s.contour) continue;
        Contour hole = contour;
        hole[1].to.y = unknown;
        EXPECT_FALSE(expand_turning(demand(s.kind, s.values, hole)).ok()) << int(s.kind);
    }
}

/// Any mixture of values and contours: bounded, finite, and the stream's rules hold but for the radii of arcs.
TEST(turning, NonsenseIsBounded) {
    const std::uint32_t seed = 20261122;
    Random r(seed);
    const double nasty[] = {0, -1, 1, 1e-12, -1e-12, 1e-2, 5, -20, 360, 1e6, -1e6, 1e300, unknown, 0.1, 3};
    const auto any = [&] { return nasty[r.upto(int(std::size(nasty)) - 1)]; };
    for (int round = 0; round < 8000; ++round) {
        const TurningSample& s = turning_samples()[std::size_t(r.upto(int(turning_samples().size()) - 1))];
        Values v = s.values;
        for (int k = r.upto(2); k >= 0 && !v.empty(); --k)
            v.push_back({v[std::size_t(r.upto(int(v.size()) - 1))].role, any()});
        Contour contour = shaft;
        for (int k = r.upto(3); k > 0; --k) {
            TurningElement& e = contour[std::size_t(r.upto(int(contour.size()) - 1))];
            e.turn = r.upto(2) - 1;
            e.centre = {r.in(-30, 10), r.in(0, 30)};
            if (r.upto(2) == 0) e.to = {r.in(-30, 10), r.in(0, 30)};
            if (r.upto(9) == 0) e.to.x = any();
            if (r.upto(4) == 0) e.fillet = r.in(0, 2);
            if (r.upto(4) == 0) e.chamfer = any();
        }
        const TurningDemand d = demand(s.kind, v, contour, {5, 20});
        const Expansion e = expand_turning(d);
        ASSERT_LE(e.steps.size(), most_steps) << "seed " << seed << " round " << round;
        ASSERT_TRUE(e.ok() || (e.steps.empty() && !e.complaints.empty())) << "seed " << seed << " round " << round;
        for (const cl::Step& step : e.steps) {
            if (!cl::is_move(step)) continue;
            ASSERT_TRUE(geom::is_finite(cl::position_after(d.situation.at, step)))
                << "seed " << seed << " round " << round << " kind " << int(s.kind);
        }
    }
}

}  // namespace
}  // namespace obrys::cycles::test
