#include "motion/technology.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace obrys::motion {

TEST(Technology, SpeedUnderConstantCuttingSpeed) {
    cl::Spindle s{100, cl::SpindleMode::surface, 1, 0};  // m/min
    EXPECT_NEAR(spindle_speed(s, 10, INFINITY), 100'000 / (2 * geom::pi * 10), 1e-9);
    EXPECT_EQ(spindle_speed(s, 10, 1000), 1000) << "the machine's highest";
    s.limit = 800;
    EXPECT_EQ(spindle_speed(s, 10, 1000), 800) << "the program's";
    EXPECT_EQ(spindle_speed(s, 0, 1000), 800) << "on the axis";
    s.limit = 0;
    EXPECT_TRUE(std::isnan(spindle_speed(s, 0, INFINITY)));
    EXPECT_EQ(spindle_speed({1500, cl::SpindleMode::rpm, -1, 0}, 0, 1000), 1500) << "as programmed";
}

TEST(Technology, SenseOfASpindleWithoutSpeed) {
    EXPECT_EQ(turning_sense({900, cl::SpindleMode::rpm, -1, 0}), -1);
    EXPECT_EQ(turning_sense({0, cl::SpindleMode::rpm, 1, 0}), 0);
    EXPECT_EQ(turning_sense({900, cl::SpindleMode::rpm, 0, 0}), 0);
}

TEST(Technology, SecondsOfAFeedMove) {
    EXPECT_EQ(feed_seconds({200, cl::FeedMode::per_minute}, 10, NAN), 3);
    EXPECT_EQ(feed_seconds({0.1, cl::FeedMode::per_rev}, 10, 1000), 6);
    EXPECT_TRUE(std::isnan(feed_seconds({0.1, cl::FeedMode::per_rev}, 10, 0))) << "it stands";
    EXPECT_EQ(feed_seconds({2, cl::FeedMode::inverse_time}, 10, NAN), 30) << "whatever its length";
    EXPECT_TRUE(std::isnan(feed_seconds({}, 10, 1000))) << "no feed";
}

TEST(Technology, RapidsGoAtTheSlowestLinearAxis) {
    shop::Machine m;
    shop::MachineAxis x, z, c;
    x.rapid = 20'000;
    z.rapid = 12'000;
    c.rapid = 10;
    c.rotary = true;
    m.axes = {x, z, c};
    EXPECT_EQ(rapid_seconds(m, 200), 1);
    m.axes.clear();
    EXPECT_TRUE(std::isnan(rapid_seconds(m, 200)));
}

}  // namespace obrys::motion
