#include "write/holes/lone_taps.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace obrys::write {
namespace {

cl::Linear rapid(double x, double y, double z) { return {{x, y, z}, {0, 0, 1}, true}; }

cl::Thread tap(const geom::Vec3& to, double pitch) {
    cl::Thread out;
    out.to = to, out.pitch = pitch, out.rigid_tap = true;
    return out;
}

/// What comes out, a letter a record: m moves, t taps, s spindle, ( and ) the bracket, - others; its cycle.
std::string through(const std::vector<cl::Step>& steps, cl::CycleBegin* begin = nullptr) {
    std::string out;
    LoneTaps taps([&](const cl::Record& record) {
        const cl::Step& step = record.step;
        if (const auto* cycle = std::get_if<cl::CycleBegin>(&step); cycle != nullptr && begin != nullptr)
            *begin = *cycle;
        out += std::holds_alternative<cl::CycleBegin>(step) ? '('
               : std::holds_alternative<cl::CycleEnd>(step) ? ')'
               : std::holds_alternative<cl::Thread>(step)   ? 't'
               : std::holds_alternative<cl::Linear>(step)   ? 'm'
               : std::holds_alternative<cl::Spindle>(step)  ? 's'
                                                            : '-';
    });
    for (std::uint32_t i = 0; i < steps.size(); ++i) taps.take({steps[i], {0, i, i + 1}, 0});
    taps.settle();
    return out;
}

double value(const cl::CycleBegin& begin, cl::CycleRole role) {
    for (const cl::CycleValue& v : begin.cycle->values)
        if (v.role == role) return v.value;
    return NAN;
}

TEST(LoneTaps, InAndBackIsACycle) {
    cl::CycleBegin begin;
    const cl::Spindle reversed{500, cl::SpindleMode::rpm, -1};
    EXPECT_EQ(through({rapid(10, 20, 5), tap({10, 20, -18}, -1.5), reversed, tap({10, 20, 5}, -1.5), rapid(0, 0, 50)},
                      &begin),
              "m(tst)m");
    EXPECT_EQ(begin.cycle->kind, cl::CycleKind::canned_tap_rigid);
    EXPECT_EQ(begin.place, (geom::Vec3{10, 20, 5}));
    EXPECT_EQ(value(begin, cl::CycleRole::retract_plane), 5);
    EXPECT_EQ(value(begin, cl::CycleRole::bottom), -18);
    EXPECT_EQ(value(begin, cl::CycleRole::pitch), 1.5);
    EXPECT_EQ(value(begin, cl::CycleRole::spindle_direction), -1);
}

TEST(LoneTaps, HeightsAreThoseOfTheFrameInForce) {
    cl::CycleBegin begin;
    const cl::Frame shifted{{{cl::FrameKind::shift, geom::Frame::shift({0, 0, 30})}}};
    EXPECT_EQ(through({shifted, rapid(0, 0, 32), tap({0, 0, 20}, 1), tap({0, 0, 32}, 1)}, &begin), "-m(tt)");
    EXPECT_EQ(value(begin, cl::CycleRole::retract_plane), 2);
    EXPECT_EQ(value(begin, cl::CycleRole::bottom), -10);
}

/// Every record comes out, once and in its order.
TEST(LoneTaps, EverythingElseGoesOnAsItComes) {
    const cl::Step down = tap({0, 0, -10}, 1), back = tap({0, 0, 5}, 1);
    EXPECT_EQ(through({rapid(0, 0, 5), down, tap({0, 0, -5}, 1), back}), "mttt");  // back in steps
    EXPECT_EQ(through({rapid(0, 0, 5), down, tap({0, 0, 5}, 2)}), "mtt");          // by another pitch
    EXPECT_EQ(through({rapid(0, 0, 5), down, cl::Stop{}, back}), "mt-t");
    EXPECT_EQ(through({rapid(0, 0, 5), down}), "mt");
    EXPECT_EQ(through({down, back}), "tt");  // from nobody knows where
    EXPECT_EQ(through({rapid(0, 0, 5), tap({1, 0, -10}, 1), back}), "mtt");
    EXPECT_EQ(through({rapid(0, 0, 5), tap({0, 0, 10}, 1), back}), "mtt");  // upwards
    EXPECT_EQ(through({rapid(0, 0, 5), cl::CycleBegin{}, down, back, cl::CycleEnd{}, down, back}), "m(tt)(tt)");
}

}  // namespace
}  // namespace obrys::write
