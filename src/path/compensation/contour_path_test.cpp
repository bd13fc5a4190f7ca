#include "path/compensation/contour_path.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "path/compensation/compensation_testing.hpp"

namespace obrys::path::test {
namespace {

struct Input {
    Element e;
    Setting s;
    CornerRequest request;
};

struct Outcome {
    std::vector<Output> out;
    PathFaults faults;
};

Outcome drive(const std::vector<Input>& input) {
    Outcome r;
    ContourPath p;
    const auto sink = [&r](const Output& o) { r.out.push_back(o); };
    const auto keep = [&r](PathFaults f) {
        if (f.corner) r.faults.corner = f.corner;
        for (const Fault& fault : f.compensation) r.faults.compensation.push_back(fault);
    };
    for (std::size_t i = 0; i < input.size(); ++i) {
        Element e = input[i].e;
        e.tag = 100 + i;
        keep(p.push(Element(e), input[i].s, input[i].request, sink));
    }
    keep(p.flush(sink));
    EXPECT_EQ(p.idle(), input.back().s.side == Side::off);
    return r;
}

const CornerRequest rnd{.kind = CornerKind::rounding, .size = 3, .modal = true};

TEST(contour_path, RoundedAndCompensatedWithEachBlocksOwnSetting) {
    // G41 approach, two sides with modal rounding, G40 away: the second side must still be compensated.
    const Outcome r = drive({{line({0, -9}, {0, 0}), left(2), {}},
                             {line({0, 0}, {10, 0}), left(2), rnd},
                             {line({10, 0}, {10, 10}), left(2), rnd},
                             {line({10, 10}, {0, 10}), {}, {}}});
    EXPECT_TRUE(r.faults.empty());
    ASSERT_EQ(r.out.size(), 6u);
    EXPECT_EQ(r.out[1].element.tag, 101u);
    EXPECT_NEAR(geom::distance(r.out[1].element.to, {7, 2}), 0, 1e-9);
    EXPECT_NEAR(geom::distance(r.out[2].element.centre, {7, 3}), 0, 1e-9);
    EXPECT_EQ(r.out[2].element.tag, 101u) << "the rounding belongs to the block that asks for it";
    EXPECT_EQ(r.out[3].element.tag, 102u);
    EXPECT_EQ(r.out[4].kind, Kind::contour);
    EXPECT_EQ(r.out[5].kind, Kind::retract);
    EXPECT_EQ(r.out[5].element.tag, 103u);
}

TEST(contour_path, RadiusLargerThanTheRoundingNamesItsBlock) {
    const Outcome r = drive({{line({0, 9}, {0, 0}), left(4), {}},
                             {line({0, 0}, {10, 0}), left(4), rnd},
                             {line({10, 0}, {10, 10}), left(4), {}}});
    ASSERT_EQ(r.faults.compensation.size(), 1u);
    EXPECT_EQ(r.faults.compensation[0].reason, Reason::tool_radius_too_large);
    EXPECT_EQ(r.faults.compensation[0].tag, 101u);
    EXPECT_LE(largest_gap({r.out, {}}), 1e-9);
}

TEST(contour_path, CornerFaultNamesItsBlock) {
    CornerRequest wide = rnd;
    wide.size = 30;
    const Outcome r =
        drive({{line({0, 0}, {5, 0}), {}, {}}, {line({5, 0}, {10, 0}), {}, wide}, {line({10, 0}, {10, 10}), {}, {}}});
    ASSERT_TRUE(r.faults.corner);
    EXPECT_EQ(r.faults.corner->tag, 101u);
    EXPECT_EQ(r.out.size(), 3u);
}

TEST(contour_path, LongRunsHoldNothingBack) {
    ContourPath p;
    std::size_t seen = 0;
    const auto sink = [&seen](const Output&) { ++seen; };
    for (int i = 0; i < 1000; ++i) {
        const double u = i;
        EXPECT_TRUE(p.push(line({u, 0}, {u + 1, 0}), {}, i % 3 == 0 ? rnd : CornerRequest{}, sink).empty());
        EXPECT_GE(seen + 1, static_cast<std::size_t>(i + 1));
    }
}

}  // namespace
}  // namespace obrys::path::test
