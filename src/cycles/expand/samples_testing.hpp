#pragma once
/// Shared by the tests of this room: a sound call of every kind that is expanded.

#include "cycles/cycle_testing.hpp"
#include "cycles/expand/expand.hpp"

namespace obrys::cycles::test {

const std::vector<Sample>& samples();

}  // namespace obrys::cycles::test
