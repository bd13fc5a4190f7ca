#include "base/work_time.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

namespace obrys::base {
namespace {

TEST(WorkTime, WaitingIsNoWork) {
    const WorkTime time;
    std::this_thread::sleep_for(std::chrono::milliseconds(60));
    EXPECT_GE(time.by_clock(), 0.06);
    EXPECT_LT(time.by_processor(), 0.06);
    while (time.by_processor() < 0.02) {
    }
    EXPECT_GE(time.by_clock(), 0.08);
}

}  // namespace
}  // namespace obrys::base
