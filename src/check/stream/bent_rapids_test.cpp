/// Rapid moves that do not go straight.

#include <gtest/gtest.h>

#include <algorithm>

#include "base/codes.hpp"
#include "check/stream/check.hpp"
#include "check/stream/milling_testing.hpp"

namespace obrys::check {

namespace {

using testing::face_setup;
using testing::of;

/// From X -30 Y -40 to X 30 Y 80 beside a block: the straight way misses its corner, the way of axes that go as fast as
/// they can one by one does not.
TEST(BentRapids, ADogLegRapidMeetsWhatTheStraightOneMisses) {
    for (const bool dog_leg : {false, true}) {
        check::Setup s = face_setup();
        s.machine.rapid_path = dog_leg ? shop::RapidPath::dog_leg : shop::RapidPath::straight;
        for (const char* name : {"X", "Y", "Z"}) {
            shop::MachineAxis a;
            a.name = name;
            a.rapid = 10'000;
            s.machine.axes.push_back(a);
        }
        const cl::CallStacks stacks;
        Check check(std::move(s), stacks);
        const auto take = [&](cl::Step step) { check.take({std::move(step), {0, 0, 1}, 0}); };
        take(cl::ToolChange{1, 1, ""});
        take(cl::Spindle{3000, cl::SpindleMode::rpm, 1, 0});
        take(cl::Linear{{-40, -60, -5}, {0, 0, 1}, true});
        take(cl::Linear{{0, 100, -5}, {0, 0, 1}, true});
        take(cl::Feed{500, cl::FeedMode::per_minute});
        take(cl::Linear{{0, 30, -5}, {0, 0, 1}, false});
        const Result r = check.finish();
        EXPECT_EQ(of(r, base::codes::rapid_in_stock).empty(), !dog_leg);
    }
}

/// Where the machine file does not say which way a rapid goes, the one that nobody has asked for finds nothing, but the
/// check is not called clean.
TEST(BentRapids, ARapidThatMayBendIsNotCalledClear) {
    for (const double corner : {-60.0, -160.0}) {
        check::Setup s = face_setup();
        s.rapids = {shop::RapidPath::either, "bit LRP of parameter 1401 = 0"};
        const cl::CallStacks stacks;
        Check check(std::move(s), stacks);
        const auto take = [&](cl::Step step) { check.take({std::move(step), {0, 0, 1}, 0}); };
        take(cl::ToolChange{1, 1, ""});
        take(cl::Spindle{3000, cl::SpindleMode::rpm, 1, 0});
        take(cl::Linear{{-40, corner, -5}, {0, 0, 1}, true});
        take(cl::Linear{{corner < -100 ? -40.0 : 0.0, 100, -5}, {0, 0, 1}, true});
        const Result r = check.finish();
        EXPECT_TRUE(of(r, base::codes::rapid_in_stock).empty());
        const bool said = std::any_of(r.unchecked.begin(), r.unchecked.end(), [](const Note& n) {
            return n.text.find("bit LRP of parameter 1401 = 0") != std::string::npos;
        });
        EXPECT_EQ(said, corner > -100) << "along one axis nothing bends";
    }
}

}  // namespace
}  // namespace obrys::check
