#pragma once
/// Results that other programs computed (../shared/spec/oracle). Where they are not at hand, a test that wants them
/// says so and is skipped.

#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>

namespace obrys::base::testing {

/// `file` below that folder: "physics/beam.json".
[[nodiscard]] inline std::optional<nlohmann::json> oracle(const std::string& file) {
    std::ifstream text(OBRYS_SOURCE_DIR "/../shared/spec/oracle/" + file);
    if (!text) return {};
    return nlohmann::json::parse(text);
}

/// Tests that share one of them.
class OracleTest : public ::testing::Test {
protected:
    explicit OracleTest(std::string file) : file_(std::move(file)) {}
    void SetUp() override {
        auto found = testing::oracle(file_);
        if (!found) GTEST_SKIP() << "needs ../shared/spec/oracle/" << file_;
        oracle = std::move(*found);
    }
    nlohmann::json oracle;

private:
    std::string file_;
};

}  // namespace obrys::base::testing
