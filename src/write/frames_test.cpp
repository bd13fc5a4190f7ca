#include "write/frames.hpp"

#include <gtest/gtest.h>

#include <random>

#include "base/seed_testing.hpp"

namespace obrys::write {
namespace {

using geom::Frame;

double radians_of(const Values& v, Value which) { return geom::radians(v.number(index_of(which))); }

Frame by_euler(const Values& v) {
    return Frame::rotation(2, radians_of(v, Value::euler_1)) * Frame::rotation(0, radians_of(v, Value::euler_2)) *
           Frame::rotation(2, radians_of(v, Value::euler_3));
}
Frame by_fixed_axes(const Values& v) {
    return Frame::rotation(2, radians_of(v, Value::angle_z)) * Frame::rotation(1, radians_of(v, Value::angle_y)) *
           Frame::rotation(0, radians_of(v, Value::angle_x));
}

void expect_same(const Frame& a, const Frame& b) {
    for (std::size_t i = 0; i < 9; ++i) EXPECT_NEAR(a.linear[i], b.linear[i], 1e-9);
}

}  // namespace

/// Both ways of saying a plane say that plane, also where one of their angles is not determined.
TEST(FrameValues, AnglesOfAPlaneSayItsTurn) {
    std::mt19937 random(base::testing_seed());
    std::uniform_int_distribution<int> quarter(-4, 4);
    std::uniform_real_distribution<double> any(-geom::pi, geom::pi);
    for (int n = 0; n < 400; ++n) {
        const auto angle = [&] { return n % 2 == 0 ? quarter(random) * geom::pi / 4 : any(random); };
        const Frame plane =
            Frame::rotation(2, angle()) * Frame::rotation(1, angle()) * Frame::rotation(0, angle()) * Frame{};
        Values v;
        ASSERT_TRUE(frame_values({cl::FrameKind::plane, plane}, v));
        expect_same(by_euler(v), plane);
        expect_same(by_fixed_axes(v), plane);
    }
    // Beside a quarter turn, where the cosine is small and the sine says nothing of it.
    for (const double beside : {1e-3, 1e-4, 3e-5, 1e-5, 1e-6, 1e-8, 1e-10, 0.0})
        for (const double quarter_turn : {-geom::pi / 2, geom::pi / 2}) {
            const Frame plane = Frame::rotation(2, 0.7) * Frame::rotation(1, quarter_turn + beside) *
                                Frame::rotation(0, -1.1) * Frame{};
            Values v;
            ASSERT_TRUE(frame_values({cl::FrameKind::plane, plane}, v));
            expect_same(by_euler(v), plane);
            expect_same(by_fixed_axes(v), plane);
        }
    Values v;
    ASSERT_TRUE(frame_values({cl::FrameKind::plane, Frame{}}, v));
    EXPECT_TRUE(v.has(index_of(Value::euler_1)) && v.has(index_of(Value::angle_x))) << "a level plane is said, too";
}

}  // namespace obrys::write
