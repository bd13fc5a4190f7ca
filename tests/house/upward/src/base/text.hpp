#pragma once
/// Fixture of the test `layers.finds_upward_include`: the floor below must not include the floor above.
#include "geom/point.hpp"
