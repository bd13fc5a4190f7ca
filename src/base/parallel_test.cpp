#include "base/parallel.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <random>

#include "base/seed_testing.hpp"

using namespace obrys::base;

/// Every number is worked on once, whatever the grain and the threads.
TEST(Parallel, NothingIsLeftOutOrDoneTwice) {
    for (const int threads : {0, 1, 4})
        with_threads(threads, [] {
            for (const std::size_t n : {0U, 1U, 7U, 1000U})
                for (const std::size_t grain : {0U, 1U, 16U, 5000U}) {
                    std::vector<std::atomic<int>> pieces(n), each(n), all(n);
                    in_pieces(n, grain, [&](const Piece& some) {
                        for (std::size_t i = some.begin(); i < some.end(); ++i) ++pieces[i];
                    });
                    one_by_one(n, [&](std::size_t i) { ++each[i]; });
                    for_all(n, [&](std::size_t i) { ++all[i]; });
                    for (std::size_t i = 0; i < n; ++i) {
                        ASSERT_EQ(pieces[i], 1);
                        ASSERT_EQ(each[i], 1);
                        ASSERT_EQ(all[i], 1);
                    }
                }
        });
}

TEST(Parallel, SortsLikeTheLibrary) {
    const auto seed = testing_seed();
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    for (const std::size_t n : {0U, 5U, 19'999U, 20'000U, 123'457U}) {
        std::vector<std::uint32_t> all(n);
        for (std::uint32_t& v : all) v = static_cast<std::uint32_t>(random() % 50'000);
        std::vector<std::uint32_t> expected = all;
        std::sort(expected.begin(), expected.end());
        sort_all(all, std::less<>());
        EXPECT_EQ(all, expected);
    }
}
