#pragma once
/// The seed of a test's random cases.

#include <cstdint>
#include <cstdlib>
#include <random>

namespace obrys::base {

/// In a test run (which sets RC_PARAMS, as for the property tests) the same each time: a result is not to depend on
/// luck. By hand a new one: the test prints it where it fails.
[[nodiscard]] inline std::uint32_t testing_seed() {
    return std::getenv("RC_PARAMS") != nullptr ? 20261121U : std::random_device{}();
}

}  // namespace obrys::base
