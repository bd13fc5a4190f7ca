#include "base/shared_log.hpp"

#include <gtest/gtest.h>

#include <random>

#include "base/seed_testing.hpp"

using namespace obrys::base;

/// Whatever is added, changed, cut and copied: each copy is as a vector with the same history.
TEST(SharedLog, CopiesAreApart) {
    const auto seed = testing_seed();
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    for (int round = 0; round < 200; ++round) {
        std::vector<SharedLog<int, 4>> logs(1);
        std::vector<std::vector<int>> plain(1);
        for (int step = 0; step < 60; ++step) {
            const std::size_t n = random() % logs.size();
            const int value = static_cast<int>(random() % 1000);
            switch (random() % 5) {
                case 0:
                    logs.push_back(logs[n]);
                    plain.push_back(plain[n]);
                    break;
                case 1:
                    if (!plain[n].empty()) {
                        const std::size_t at = random() % plain[n].size();
                        logs[n].edit(at) = plain[n][at] = value;
                    }
                    break;
                case 2:
                    if (random() % 4 == 0) {
                        const std::size_t count = random() % (plain[n].size() + 1);
                        logs[n].cut_to(count);
                        plain[n].resize(count);
                    }
                    break;
                default: logs[n].push_back(value); plain[n].push_back(value);
            }
        }
        for (std::size_t n = 0; n < logs.size(); ++n) {
            ASSERT_EQ(logs[n].size(), plain[n].size());
            for (std::size_t i = 0; i < plain[n].size(); ++i) ASSERT_EQ(logs[n][i], plain[n][i]) << n << ' ' << i;
        }
    }
}
