#include "cl/recording.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include "cl/records_testing.hpp"
#include "cl/text.hpp"

namespace obrys::cl {
namespace {

Recording recording_of(const std::vector<Record>& records) {
    Recording out;
    for (const Record& record : records) out.take(record);
    return out;
}

std::vector<Record> played(const Recording& recording) {
    std::vector<Record> out;
    Recording::Playback playback(recording);
    while (playback.step([&](const Record& record) { out.push_back(record); })) {
    }
    return out;
}

RC_GTEST_PROP(Recording, GivesBackWhatItTook, ()) {
    std::vector<Record> taken;
    const auto kinds = *rc::gen::container<std::vector<std::size_t>>(
        rc::gen::oneOf(rc::gen::just(std::size_t{0}), rc::gen::inRange<std::size_t>(0, std::variant_size_v<Step>)));
    for (const std::size_t kind : kinds) {
        taken.push_back(any_record(kind));
        if (kind == 0 && *rc::gen::arbitrary<bool>()) {  // one more in the same way, as most moves are
            taken.push_back(taken.back());
            std::get<Linear>(taken.back().step).to = vec();
        }
    }
    const Recording recording = recording_of(taken);
    RC_ASSERT(recording.size() == taken.size());
    RC_ASSERT(to_text(played(recording)) == to_text(taken));
}

/// Longer than a block of its memory, and gone through twice.
TEST(Recording, IsLong) {
    std::vector<Record> taken;
    for (int i = 0; i < 40'000; ++i) {
        const double x = i * 0.125;
        Step step = Linear{{x, -x, 1}, {0, 0, 1}, i % 7 == 0, {}};
        if (i % 100 == 50) step = Arc{{x, 1, 2}, {x, 0, 2}, {0, 0, 1}, x, false};
        if (i % 1000 == 1) step = Comment{std::to_string(i)};
        taken.push_back({step, {0, static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(i + 1)}, 3});
    }
    const Recording recording = recording_of(taken);
    EXPECT_EQ(to_text(played(recording)), to_text(taken));  // every field, NaN as NaN
    EXPECT_EQ(to_text(played(recording)), to_text(taken));
}

TEST(Recording, WithoutRecordsItHasEnded) { EXPECT_TRUE(played(Recording{}).empty()); }

}  // namespace
}  // namespace obrys::cl
