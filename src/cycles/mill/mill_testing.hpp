#pragma once
/// Shared by the tests of this room: a call as one line of text.

#include <string>

#include "cycles/cycle_testing.hpp"
#include "cycles/mill/mill.hpp"

namespace obrys::cycles::test {

/// The script of a call that must succeed; else what was complained of.
inline std::string run(Kind kind, const Values& values, const Situation& s = situation()) {
    return script_or_complaints(expand_mill({kind, values}, s), s);
}

}  // namespace obrys::cycles::test
